/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "scene.h"

#include "mem.h"

bool scene_add_face(struct scene *s, const struct scene_face *face, struct err *err) {
    if (!mem_grow(s->face, &s->face_cap, s->face_count + 1, err)) return false;
    s->face[s->face_count++] = *face;
    return true;
}

bool scene_add_line(struct scene *s, const struct scene_line *line, struct err *err) {
    if (!mem_grow(s->line, &s->line_cap, s->line_count + 1, err)) return false;
    s->line[s->line_count++] = *line;
    return true;
}

void scene_free(struct scene *s) {
    free(s->face);
    free(s->line);
    *s = (struct scene){0};
}
