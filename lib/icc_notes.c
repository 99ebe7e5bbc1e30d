/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "icc_notes.h"

static void note_ray(const struct cli *cli, const struct icc_ray *r, const char *name) {
    cli_note(cli,
             "%s: %zu points inside, %u on the cage; %zu triangles, all counter-clockwise in the "
             "disk%s",
             name, r->mesh.mesh.vertex_count - r->mesh.rim_count, r->mesh.rim_count,
             r->mesh.mesh.triangle_count, r->uniform ? " with uniform weights" : "");
}

static void note_grid(const struct cli *cli, const struct icc_grid *g, const char *name) {
    double top[2];
    icc_domain_vertex(&g->domain, g->function.maximum, top);
    cli_note(cli, "%s: cells of %.9g, %u vertices inside, %u with values, maximum at (%.9g, %.9g)",
             name, g->domain.h, g->domain.inside_count, g->function.valued, top[0], top[1]);
}

static void note_failures(const struct cli *cli, const struct icc_grid *g, const char *name) {
    char text[ICC_FAILURE_TEXT_MAX];
    for (int t = 0; t < ICC_TESTS; t++) {
        if (g->failures[t].count == 0) continue;
        icc_failure_describe((enum icc_test)t, &g->failures[t], text);
        cli_note(cli, "%s: resolution: with cells of %.9g, %s", name, g->domain.h, text);
    }
}

void icc_notes_bound(const struct cli *cli, const struct icc_map *m, const char *const name[2],
                     bool verbose) {
    for (int k = 0; k < (m->target ? 2 : 1); k++) {
        if (m->rule.method == ICC_GRID) {
            if (verbose) note_grid(cli, &m->grid[k], name[k]);
            note_failures(cli, &m->grid[k], name[k]);
        } else if (verbose)
            note_ray(cli, &m->ray[k], name[k]);
    }
}

void icc_notes_mapped(const struct cli *cli, const struct icc_map *m, const char *const name[2]) {
    for (int k = 0; k < 2; k++) {
        const struct icc_tally *t = &m->tally[k];
        if (t->points > 0)
            cli_note(cli,
                     "%s: of %zu points, lines merged: %zu, lost: %zu, leaving the cage: %zu, "
                     "along expansion edges: %zu",
                     name[k], t->points, t->merged, t->lost, t->leaving, t->expanded);
    }
}
