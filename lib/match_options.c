/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "match_options.h"

#include "cage_io.h"
#include "mem.h"
#include "num.h"

#include <string.h>

static const char *const match_names[] = {"arclength", NULL};

static bool parse_anchor(const struct cli *cli, struct match_anchor *anchor, struct err *err) {
    const char *at = cli->value, *end = at + strlen(at);
    for (int k = 0; k < 2; k++) {
        int64_t n;
        if (num_read_int(at, end, &n, &at) != NUM_OK || n < 0 || n >= MATCH_INSERTED ||
            *at != (k == 0 ? ':' : '\0'))
            return cli_bad_value(cli, err, "two vertex numbers I:J");
        anchor->vertex[k] = (size_t)n;
        at++;
    }
    return true;
}

bool match_option(struct match_options *o, const struct cli *cli, int key, struct err *err) {
    int how;
    if (key == MATCH_MATCH) return o->match = cli_choice(cli, match_names, &how, err);
    return mem_grow(o->anchor, &o->anchor_cap, o->anchor_count + 1, err) &&
           parse_anchor(cli, &o->anchor[o->anchor_count++], err);
}

bool match_options_end(const struct match_options *o, const struct cli *cli, struct err *err) {
    return o->anchor_count == 0 || o->match ||
           err_set(err, ERR_USAGE, "--anchor needs --match arclength; try %s --help",
                   cli->program->name);
}

void match_options_free(struct match_options *o) {
    free(o->anchor);
    *o = (struct match_options){0};
}

bool match_options_read(const struct match_options *o, struct cage *source, const char *source_path,
                        struct cage *target, const char *target_path, struct err *err) {
    if (!cage_read(source, source_path, err)) return false;
    if (!o->match)
        return cage_read_like(target, target_path, source, source_path,
                              "; --match arclength inserts some", err);
    if (!cage_read(target, target_path, err)) return false;
    if (target->reversed == source->reversed)
        return match_cages(source, target, o->anchor, o->anchor_count, err);
    err_set(err, ERR_REFUSAL, "the cage is %s, but %s is not",
            target->reversed ? "clockwise" : "counter-clockwise", source_path);
    return err_place(err, target_path, 0, 0);
}
