/* SPDX-License-Identifier: GPL-3.0-or-later */
/* decles-edit - carries out an editing script on a grid. */
#include "cli.h"
#include "edits_io.h"
#include "grid_io.h"
#include "mem.h"
#include "num.h"
#include "out.h"
#include "plan_io.h"
#include "script_run.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    KEY_CONTINUITY = 256,
    KEY_REPAIR,
    KEY_GAIN,
    KEY_NO_FOLD,
    KEY_LIMIT,
    KEY_VERBOSE,
    KEY_PROGRESS,
    KEY_DIGITS
};

static const struct cli_option options[] = {
    {'e', "edit", "STATEMENT", "this instead of EDITS; repeat it for more lines"},
    {'n', "dry-run", NULL, "print what is edited instead of the grid"},
    {KEY_CONTINUITY, "continuity", "0|1", "keep phi and sigma continuous, or C1 (1)"},
    {KEY_REPAIR, "repair", NULL, "make a grid C1 that is not, before the edits"},
    {KEY_GAIN, "max-gain", "G", "let points move G times as far as anchors (100)"},
    {KEY_NO_FOLD, "no-fold", "[=MARGIN]", "refuse an edit unless it keeps det > MARGIN (0)"},
    {KEY_LIMIT, "limit", NULL, "with --no-fold: carry out as much of it as keeps that"},
    {KEY_VERBOSE, "verbose", NULL, "report each edit on stderr"},
    {KEY_PROGRESS, "progress", NULL, "show progress on stderr also if that is no terminal"},
    {KEY_DIGITS, "digits", "N", "write N significant digits, not all"},
    {'o', "output", "FILE", "write there (stdout)"},
    {0, NULL, NULL, NULL},
};

static const struct cli_program program = {
    .name = "decles-edit",
    .synopsis = "[OPTION]... EDITS [GRID] | -e STATEMENT... [OPTION]... [GRID]",
    .options = options,
    .epilogue = "examples:\n"
                "  mkgrid --rect 0,0,8,4 --cells 8x4 | decles-edit -e 'move @4,2 by 1 0.5 reach 6' "
                ">a.grid\n"
                "  mkgrid --rect 0,0,8,4 --cells 8x4 | decles-edit -n -e 'rotate v:22 about 4 2 by "
                "30 within "
                "2'\n",
};

struct settings {
    struct script_options script;
    bool dry, repair, verbose, progress;
    int digits;
    const char *output, *edits, *grid; /* edits: NULL with -e */
    char *statements;                  /* of -e, one a line */
    size_t length, room;
};

static bool add_statement(struct settings *set, const char *text, struct err *err) {
    size_t n = strlen(text) + 1;
    if (!mem_grow(set->statements, &set->room, set->length + n, err)) return false;
    memcpy(set->statements + set->length, text, n);
    set->length += n;
    set->statements[set->length - 1] = '\n';
    return true;
}

static bool set_option(struct settings *set, const struct cli *cli, int key, struct err *err) {
    int64_t n = 0;
    switch (key) {
    case 'e':
        return add_statement(set, cli->value, err);
    case 'n':
        set->dry = true;
        return true;
    case 'o':
        set->output = cli->value;
        return true;
    case KEY_REPAIR:
        set->repair = true;
        return true;
    case KEY_VERBOSE:
        set->verbose = true;
        return true;
    case KEY_PROGRESS:
        set->progress = true;
        return true;
    case KEY_GAIN:
        return cli_double(cli, 0, 1e300, &set->script.decles.max_gain, err);
    case KEY_NO_FOLD:
        set->script.no_fold = true;
        set->script.margin = 0;
        return !cli->value || cli_double(cli, 0, 1e300, &set->script.margin, err);
    case KEY_LIMIT:
        set->script.limit = true;
        return true;
    case KEY_DIGITS:
        if (!cli_int(cli, 1, 17, &n, err)) return false;
        set->digits = (int)n;
        return true;
    default: /* KEY_CONTINUITY */
        if (!cli_int(cli, 0, 1, &n, err)) return false;
        set->script.decles.continuity = (int)n;
        return true;
    }
}

static bool parse(struct cli *cli, struct settings *set, struct err *err) {
    int key;
    while ((key = cli_next(cli, err)) >= 0)
        if (!set_option(set, cli, key, err)) return false;
    if (key == CLI_STOP) return false;
    if (set->script.limit && !set->script.no_fold)
        return err_set(err, ERR_USAGE, "--limit needs --no-fold; try decles-edit --help");
    if (set->statements) {
        set->grid = cli_operand(cli, 0);
        return cli_check_operands(cli, 0, 1, err);
    }
    set->edits = cli_operand(cli, 0);
    set->grid = cli_operand(cli, 1);
    return cli_check_operands(cli, 1, 2, err);
}

/* ---- what -n and --verbose tell ---- */

struct display {
    const struct cli *cli;
    const struct settings *set;
    FILE *plan; /* the output of -n */
    const struct script_block *noted, *shown;
    struct progress *progress;
};

static void note_report(const struct display *d, const struct script_event *e, const char *text) {
    const struct decles_report *r = e->report;
    cli_note(d->cli,
             "%s:%zu: %s: %s |A| %zu |S| %zu |D| %zu |E| %zu rank %zu redundant %zu added %zu "
             "residual %.3g displacement %.6g gain %.6g%s",
             e->script->name, e->block->line, text, script_channel_names[e->channel], r->anchors,
             r->slaves, r->derived, r->conditions, r->rank, r->redundant, r->added, r->residual,
             r->displacement, r->gain, r->by_qr ? " by QR" : "");
}

/* That a block was limited is always told: it is not what was asked for. */
static void note_exit(const struct display *d, const struct script_event *e, const char *text) {
    char share[NUM_TEXT_MAX + 1], lost[NUM_TEXT_MAX + 1];
    share[num_print(share, e->exit->share, 0)] = '\0';
    lost[num_print(lost, e->exit->lost, 0)] = '\0';
    cli_note(d->cli, "%s:%zu: %s: limited to %s of it; at %s %s", e->script->name, e->block->line,
             text, share, lost, e->exit->text);
}

static bool note_edit(struct display *d, const struct script_event *e, struct err *err) {
    const struct script_statement *s = &e->script->statement[e->block->first];
    char *text = e->block->grouped ? strdup("block") : edits_text(e->script, s, err);
    if (!text) return err_memory(err);
    if (e->exit && d->noted != e->block) note_exit(d, e, text);
    if (d->set->verbose) note_report(d, e, text);
    d->noted = e->block;
    free(text);
    return true;
}

static bool see(void *context, const struct script_event *e, struct err *err) {
    struct display *d = context;
    size_t done = (size_t)(e->block - e->script->block);
    if (d->progress) d->progress->show(d->progress, (double)done / (double)e->script->block_count);
    if (e->edit && (d->set->verbose || e->exit) && !note_edit(d, e, err)) return false;
    if (!d->set->dry) return true;
    if (d->shown != e->block && !plan_put_statements(d->plan, e, err)) return false;
    d->shown = e->block;
    return plan_put_points(d->plan, e, err);
}

/* ---- the work ---- */

static bool repair(struct spline *s, struct err *err) {
    return decles_repair(&s->grid, &s->phi[0][0], 2, 2, err) &&
           (!s->sigma || (decles_repair(&s->grid, &s->sigma[0][0], 2, 1, err) &&
                          decles_repair(&s->grid, &s->sigma[0][1], 2, 1, err)));
}

static bool write_result(const struct cli *cli, const struct settings *set,
                         const struct grid_file *file, const char *plan, struct err *err) {
    char *history = cli_history(cli, err);
    struct out out = {0};
    bool ok = history && out_open(&out, set->output, err);
    if (ok && set->dry) out_text(&out, plan);
    if (ok && !set->dry) grid_write(&out, file, history, set->digits);
    ok = ok && out_close(&out, err);
    free(history);
    return ok;
}

static bool edit(const struct cli *cli, const struct settings *set, const struct script *script,
                 struct grid_file *file, struct err *err) {
    char *plan = NULL;
    size_t size;
    struct display display = {.cli = cli, .set = set, .plan = open_memstream(&plan, &size)};
    struct script_observer observer = {see, &display};
    struct cli_progress progress;
    bool ok = display.plan || err_memory(err);
    display.progress = cli_progress_begin(&progress, cli, set->progress);
    ok = ok && (!set->repair || repair(&file->spline, err)) &&
         script_run(script, &file->spline, &set->script, &observer, err);
    cli_progress_end(&progress);
    if (display.plan && fclose(display.plan) != 0 && ok) ok = err_memory(err);
    ok = ok && write_result(cli, set, file, plan, err);
    free(plan);
    return ok;
}

static void run(const struct cli *cli, const struct settings *set, struct err *err) {
    struct script script = {0};
    struct grid_file file = {0};
    bool read = set->edits ? edits_read(&script, set->edits, err)
                           : edits_parse(&script, "-e", set->statements, set->length, err);
    if (!read) return;
    if (grid_read(&file, set->grid, err)) {
        (void)edit(cli, set, &script, &file, err);
        grid_file_free(&file);
    }
    script_free(&script);
}

int main(int argc, char **argv) {
    struct err err = {0};
    struct cli cli;
    struct settings set = {.script.decles = {.continuity = 1, .max_gain = 100}};
    cli_init(&cli, &program, argc, argv);
    if (parse(&cli, &set, &err)) run(&cli, &set, &err);
    free(set.statements);
    return cli_finish(&cli, &err);
}
