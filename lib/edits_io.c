/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A statement is a verb, what belongs to the verb (`top`, a weight), words of POINTS, and clauses
 * in any order. Tables say which clauses a verb takes and needs; the parser walks a line once and
 * never goes back. The reader's sticky error is the parser's; places are those of words. */
#include "edits_io.h"

#include "mem.h"
#include "points_io.h"

#include <stdio.h>
#include <string.h>

struct parser {
    struct src src;
    struct script *script;
    bool in_block; /* the script's last block is still open */
};

/* ---- clauses ---- */

enum clause { BY, TO, FROM, ABOUT, REACH, WITHIN, WITH, CLAUSES };
static const char *const clause_names[] = {"by", "to", "from", "about", "reach", "within", "with"};
#define BIT(clause) (1u << (clause))
#define SLAVES      (BIT(REACH) | BIT(WITHIN) | BIT(WITH))

static const struct verb {
    unsigned takes, needs; /* clauses; besides, one of by and to if it takes any */
    int values;            /* numbers after by, to, from */
    const char *by;        /* what the numbers after by are */
} verbs[] = {
    [SCRIPT_MOVE] = {BIT(BY) | BIT(TO) | BIT(FROM) | SLAVES, 0, 2, "a displacement DX DY"},
    [SCRIPT_ROTATE] = {BIT(BY) | BIT(ABOUT) | SLAVES, BIT(ABOUT), 1, "an angle in degrees"},
    [SCRIPT_SCALE] = {BIT(BY) | BIT(ABOUT) | SLAVES, BIT(ABOUT), 1, "a factor > 0"},
    [SCRIPT_RAISE] = {BIT(BY) | BIT(TO) | SLAVES, 0, 1, "a height"},
    [SCRIPT_SUGGEST] = {BIT(BY) | BIT(TO) | BIT(FROM), 0, 2, "a displacement DX DY"},
    [SCRIPT_PIN] = {0, 0, 0, NULL},
    [SCRIPT_UNPIN] = {0, 0, 0, NULL},
    [SCRIPT_WEIGHT] = {0, 0, 0, NULL},
};

/* Is this word a clause? */
static enum clause clause_of(const char *word, size_t length) {
    int c = 0;
    while (c < CLAUSES &&
           (strlen(clause_names[c]) != length || memcmp(clause_names[c], word, length) != 0))
        c++;
    return (enum clause)c;
}

/* "POINTS or a clause of move (by, to, from, reach, within, with)" */
static void describe(char *to, size_t room, const char *what, enum script_verb verb) {
    const char *separator = " or a clause of ";
    int used = snprintf(to, room, "%s", what);
    for (int c = 0; c < CLAUSES; c++) {
        if (!(verbs[verb].takes & BIT(c))) continue;
        if (separator[0] == ' ')
            used += snprintf(to + used, room - (size_t)used, "%s%s (%s", separator,
                             script_verb_names[verb], clause_names[c]);
        else
            used += snprintf(to + used, room - (size_t)used, "%s%s", separator, clause_names[c]);
        separator = ", ";
    }
    if (verbs[verb].takes) snprintf(to + used, room - (size_t)used, ")");
}

/* Words of POINTS up to a clause or the end of the line; one at least. */
static bool parse_points(struct parser *p, enum script_verb verb, struct script_words *words) {
    char expected[160];
    const char *word;
    size_t length;
    describe(expected, sizeof expected, "POINTS", verb);
    words->first = p->script->selector_count;
    while (src_word(&p->src, &word, &length)) {
        if (clause_of(word, length) != CLAUSES) {
            p->src.at = word;
            break;
        }
        if (!points_parse(&p->src, p->script, word, length, words->count ? expected : "POINTS"))
            return false;
        words->count++;
    }
    return words->count > 0 || src_expected(&p->src, "POINTS");
}

/* A number of which only some are good. */
static bool parse_limited(struct parser *p, const char *what, bool zero, double *x) {
    const char *before = p->src.at;
    if (!src_double(&p->src, what, x)) return false;
    if (*x > 0 || (zero && *x == 0)) return true;
    p->src.at = before;
    return src_expected(&p->src, what);
}

static bool parse_by(struct parser *p, struct script_statement *s) {
    const char *what = verbs[s->verb].by;
    if (s->verb == SCRIPT_SCALE) return parse_limited(p, what, false, &s->by[0]);
    for (int i = 0; i < verbs[s->verb].values; i++)
        if (!src_double(&p->src, what, &s->by[i])) return false;
    return true;
}

static bool parse_position(struct parser *p, int values, double *xy) {
    const char *what = values == 1 ? "a height" : "a position X Y";
    for (int i = 0; i < values; i++)
        if (!src_double(&p->src, what, &xy[i])) return false;
    return true;
}

static bool parse_reach(struct parser *p, struct script_statement *s) {
    int64_t steps;
    s->has_reach = true;
    if (!src_int(&p->src, "a number of steps", 0, INT32_MAX, &steps)) return false;
    s->reach = (uint32_t)steps;
    return true;
}

static bool parse_clause(struct parser *p, enum clause clause, struct script_statement *s) {
    int values = verbs[s->verb].values;
    switch (clause) {
    case BY:
        return parse_by(p, s);
    case TO:
        return parse_position(p, values, s->to);
    case FROM:
        return parse_position(p, values, s->from);
    case ABOUT:
        return parse_position(p, 2, s->about);
    case REACH:
        return parse_reach(p, s);
    case WITHIN:
        s->has_within = true;
        return parse_limited(p, "a distance >= 0", true, &s->within);
    case WITH:
        return parse_points(p, s->verb, &s->with);
    case CLAUSES:
        break;
    }
    return false;
}

/* May this clause follow those seen? The word is at src.at. */
static bool admit(struct parser *p, enum clause clause, unsigned seen,
                  const struct script_statement *s) {
    unsigned moves = BIT(TO) | BIT(FROM);
    char expected[160];
    describe(expected, sizeof expected, "the end of the line", s->verb);
    if (clause == CLAUSES || !(verbs[s->verb].takes & BIT(clause)))
        return src_expected(&p->src, expected);
    if (seen & BIT(clause))
        return src_fail(&p->src, p->src.at, "expected each clause once, got a second '%s'",
                        clause_names[clause]);
    if ((clause == BY && (seen & moves)) || ((moves & BIT(clause)) && (seen & BIT(BY))))
        return src_fail(&p->src, p->src.at, "expected either 'by' or 'to', got both");
    if (clause == TO && s->verb == SCRIPT_RAISE && s->bottom && s->top)
        return src_expected(&p->src, "'by' after 'both'");
    return true;
}

/* Are all clauses there that the verb needs? */
static bool check_complete(struct parser *p, unsigned seen, const struct script_statement *s) {
    unsigned takes = verbs[s->verb].takes;
    if (takes && !(seen & (BIT(BY) | BIT(TO) | BIT(FROM))))
        return src_expected(&p->src, takes & BIT(FROM) ? "'by', 'to' or 'from'"
                                     : !(takes & BIT(TO)) || (s->bottom && s->top)
                                         ? "'by'"
                                         : "'by' or 'to'");
    if ((seen & BIT(FROM)) && !(seen & BIT(TO))) return src_expected(&p->src, "'to' with 'from'");
    if ((verbs[s->verb].needs & BIT(ABOUT)) && !(seen & BIT(ABOUT)))
        return src_expected(&p->src, "'about'");
    return true;
}

static bool parse_clauses(struct parser *p, struct script_statement *s) {
    unsigned seen = 0;
    const char *word;
    size_t length;
    while (src_word(&p->src, &word, &length)) {
        enum clause clause = clause_of(word, length);
        p->src.at = word;
        if (!admit(p, clause, seen, s)) return false;
        p->src.at = word + length;
        if (!parse_clause(p, clause, s)) return false;
        seen |= BIT(clause);
    }
    s->target = seen & BIT(FROM) ? SCRIPT_FROM_TO : seen & BIT(TO) ? SCRIPT_TO : SCRIPT_BY;
    return check_complete(p, seen, s);
}

/* ---- statements ---- */

/* What stands between the verb and POINTS. */
static bool parse_head(struct parser *p, struct script_statement *s) {
    if (s->verb == SCRIPT_WEIGHT) return parse_limited(p, "a weight > 0", false, &s->by[0]);
    if (s->verb != SCRIPT_RAISE) return true;
    if (src_take(&p->src, "both"))
        s->bottom = s->top = true;
    else if (src_take(&p->src, "bottom"))
        s->bottom = true;
    else if (src_take(&p->src, "top"))
        s->top = true;
    else
        return src_expected(&p->src, "'top', 'bottom' or 'both'");
    return true;
}

static bool parse_statement(struct parser *p, enum script_verb verb, const char *word) {
    struct script_statement s = {
        .verb = verb, .line = p->src.line, .col = src_column(&p->src, word)};
    if (p->in_block && verb >= SCRIPT_PIN) {
        p->src.at = word;
        return src_fail(&p->src, word, "expected '%s' before 'begin', got it in a block",
                        script_verb_names[verb]);
    }
    return parse_head(p, &s) && parse_points(p, verb, &s.points) && parse_clauses(p, &s) &&
           script_add_statement(p->script, &s, p->in_block, &p->src.err);
}

static const struct script_block *last_block(const struct parser *p) {
    return &p->script->block[p->script->block_count - 1];
}

static bool parse_begin(struct parser *p, const char *word) {
    if (p->in_block)
        return src_fail(&p->src, word,
                        "expected 'end' of the block that begins on line %zu, got 'begin'",
                        last_block(p)->line);
    p->in_block = true;
    return src_end_line(&p->src) &&
           script_add_block(p->script, p->src.line, src_column(&p->src, word), &p->src.err);
}

static bool parse_end(struct parser *p, const char *word) {
    if (!p->in_block) return src_fail(&p->src, word, "expected a statement, got 'end'");
    if (last_block(p)->count == 0)
        return src_fail(&p->src, word, "expected a statement in the block, got 'end'");
    p->in_block = false;
    return src_end_line(&p->src);
}

static bool parse_line(struct parser *p) {
    const char *word = p->src.at;
    if (src_take(&p->src, "begin")) return parse_begin(p, word);
    if (src_take(&p->src, "end")) return parse_end(p, word);
    for (int v = 0; script_verb_names[v]; v++)
        if (src_take(&p->src, script_verb_names[v]))
            return parse_statement(p, (enum script_verb)v, word);
    return src_expected(&p->src, "move, rotate, scale, raise, suggest, pin, unpin, weight, begin "
                                 "or end");
}

static bool parse_body(struct parser *p) {
    while (src_line(&p->src))
        if (!parse_line(p)) return false;
    if (p->src.err.kind) return false;
    if (p->in_block)
        return src_fail(&p->src, NULL,
                        "expected 'end' of the block that begins on line %zu, got end of file",
                        last_block(p)->line);
    return true;
}

static bool parse_first_record(struct parser *p) {
    src_line(&p->src);
    return src_expect(&p->src, "edits") && src_expect(&p->src, "1") && src_end_line(&p->src);
}

/* Parses what the opened source holds into a new script, and closes it. */
static bool parse_all_of(struct parser *p, struct script *script, bool first_record,
                         struct err *err) {
    bool ok;
    p->script = script;
    ok = script_init(script, p->src.name, &p->src.err) &&
         (!first_record || parse_first_record(p)) && parse_body(p);
    if (!ok) {
        *err = p->src.err;
        script_free(script);
    }
    src_close(&p->src);
    return ok;
}

bool edits_read(struct script *script, const char *path, struct err *err) {
    struct parser p = {0};
    return src_open(&p.src, path, err) && parse_all_of(&p, script, true, err);
}

bool edits_parse(struct script *script, const char *name, const char *text, size_t length,
                 struct err *err) {
    struct parser p = {0};
    src_open_text(&p.src, name, text, length);
    return parse_all_of(&p, script, false, err);
}

/* ---- writing ---- */

static void put_words(FILE *to, const struct script *script, struct script_words words) {
    for (size_t i = 0; i < words.count; i++) points_put(to, &script->selector[words.first + i]);
}

static void put_values(FILE *to, const char *clause, int n, const double *x) {
    fprintf(to, " %s", clause);
    for (int i = 0; i < n; i++) points_put_number(to, " ", x[i]);
}

static void put_statement(FILE *to, const struct script *script, const struct script_statement *s) {
    const struct verb *v = &verbs[s->verb];
    fputs(script_verb_names[s->verb], to);
    if (s->verb == SCRIPT_RAISE)
        fprintf(to, " %s", s->bottom && s->top ? "both" : s->top ? "top" : "bottom");
    if (s->verb == SCRIPT_WEIGHT) points_put_number(to, " ", s->by[0]);
    put_words(to, script, s->points);
    if (!v->takes) return;
    if (v->needs & BIT(ABOUT)) put_values(to, "about", 2, s->about);
    if (s->target == SCRIPT_BY) put_values(to, "by", v->values, s->by);
    if (s->target == SCRIPT_FROM_TO) put_values(to, "from", v->values, s->from);
    if (s->target != SCRIPT_BY) put_values(to, "to", v->values, s->to);
    if (s->has_reach) fprintf(to, " reach %u", s->reach);
    if (s->has_within) points_put_number(to, " within ", s->within);
    if (s->with.count > 0) fputs(" with", to);
    put_words(to, script, s->with);
}

char *edits_text(const struct script *script, const struct script_statement *s, struct err *err) {
    char *text = NULL;
    size_t size;
    FILE *to = open_memstream(&text, &size);
    if (to) {
        put_statement(to, script, s);
        if (fclose(to) == 0) return text;
    }
    free(text);
    err_memory(err);
    return NULL;
}
