/* SPDX-License-Identifier: GPL-3.0-or-later */
/* `done` is how far the text has been dealt with. Every replacement first copies what lies between,
 * so unchanged stretches of any number of lines go out in one piece:
 *
 *      .......done ~~~~~~~~~~~~~ begin ===== end ~~~~~~~~~~
 *                  copied              replaced  left for the next
 */
#include "obj_copy.h"

struct copier {
    struct obj_scan scan;
    struct out *out;
    const struct obj_points *points;
    const struct obj_change *change;
    const char *done;
    size_t vertices, normals; /* lines seen */
};

static void skip(struct copier *k, const char *begin, const char *end) {
    out_bytes(k->out, k->done, (size_t)(begin - k->done));
    k->done = end;
}

static void put_numbers(struct copier *k, const double x[3]) {
    for (int i = 0; i < 3; i++) {
        const char *begin, *end;
        (void)obj_word(&k->scan, &begin, &end);
        skip(k, begin, end);
        out_double(k->out, x[i], k->change->digits);
    }
}

/* The copies that follow normal n, each with the line's own end before it. */
static void put_copies(struct copier *k, size_t n) {
    const struct obj_normals *plan = k->change->plan;
    size_t length = (size_t)(k->scan.next - k->scan.stop);
    if (plan->before[n] == plan->before[n + 1]) return;
    skip(k, k->scan.stop, k->scan.stop);
    for (uint32_t i = plan->before[n]; i < plan->before[n + 1]; i++) {
        const double *x = plan->copy[i].value;
        out_bytes(k->out, length ? k->scan.stop : "\n", length ? length : 1);
        out_text(k->out, "vn");
        for (int c = 0; c < 3; c++) {
            out_char(k->out, ' ');
            out_double(k->out, x[c], k->change->digits);
        }
    }
}

static void copy_normal(struct copier *k) {
    const struct obj_normals *plan = k->change->plan;
    size_t n = k->normals++;
    if (k->change->normals == OBJ_NORMALS_DROP) skip(k, k->scan.line, k->scan.next);
    if (k->change->normals != OBJ_NORMALS_TRANSFORM) return;
    if (plan->owner[n] != OBJ_UNUSED) put_numbers(k, plan->value[n]);
    put_copies(k, n);
}

/* Writes the normal's new number in the style of the old one, if it is another. */
static bool renumber(struct copier *k, const struct obj_corner *corner) {
    const struct obj_normals *plan = k->change->plan;
    size_t vertex, normal;
    int64_t number;
    if (!obj_resolve(&k->scan, corner, "vertex", corner->vertex, k->vertices, &vertex) ||
        !obj_resolve(&k->scan, corner, "normal", corner->normal, k->normals, &normal) ||
        normal >= plan->normal_count)
        return false;
    number = (int64_t)obj_normals_number(plan, normal, vertex) + 1;
    if (corner->normal < 0) number -= (int64_t)obj_normals_defined(plan, k->normals) + 1;
    if (number == corner->normal) return true;
    skip(k, corner->normal_at, corner->end);
    out_int(k->out, number);
    return true;
}

static bool copy_corners(struct copier *k) {
    struct obj_corner corner;
    while (obj_corner(&k->scan, &corner)) {
        if (!corner.normal) continue;
        if (k->change->normals == OBJ_NORMALS_DROP)
            skip(k, corner.cut, corner.end);
        else if (!renumber(k, &corner))
            return false;
    }
    return true;
}

/* Is everything that follows as it was? */
static bool is_rest_unchanged(const struct copier *k, bool corners) {
    return !corners && k->vertices == k->points->vertex_count &&
           (k->change->normals == OBJ_NORMALS_KEEP || k->normals == k->points->normal_count);
}

/* False where the text is not the one that was read before. */
static bool copy_all(struct copier *k) {
    enum obj_normal_mode mode = k->change->normals;
    bool corners = mode == OBJ_NORMALS_DROP ||
                   (mode == OBJ_NORMALS_TRANSFORM && k->change->plan->copy_count > 0);
    enum obj_kind kind;
    while (!is_rest_unchanged(k, corners) && (kind = obj_next(&k->scan)) != OBJ_END) {
        if (kind == OBJ_VERTEX) {
            if (k->vertices == k->points->vertex_count) return false;
            put_numbers(k, k->change->vertex[k->vertices++]);
        } else if (kind == OBJ_NORMAL) {
            if (k->normals == k->points->normal_count) return false;
            copy_normal(k);
        } else if (corners && obj_to_corners(&k->scan, kind) && !copy_corners(k)) {
            return false;
        }
    }
    skip(k, k->scan.end, k->scan.end);
    return k->vertices == k->points->vertex_count;
}

bool obj_copy(struct out *out, const struct filemap *f, const struct obj_points *p,
              const struct obj_change *change, struct err *err) {
    struct copier k = {.out = out, .points = p, .change = change, .done = f->data};
    obj_scan_init(&k.scan, f->name, f->data, f->length);
    if (copy_all(&k)) return true;
    return err_set(err, ERR_INPUT, "%s was changed while it was read", f->name);
}
