/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One pass over the text turns the normal of every corner whose pair (normal, vertex) was not seen
 * yet. Copies are found again by a hash table of their pairs; pairs whose result is the one that
 * the normal's own line has are not stored, so a model that does not move needs no memory for them.
 * Copies are found in the order of their lines: copy c has the number after + 1 + c. */
#include "obj_normals.h"

#include "mem.h"

#include <math.h>
#include <string.h>

struct planner {
    struct obj_scan scan;
    struct obj_normals *plan;
    const struct obj_points *points;
    obj_turn *turn;
    void *context;
    size_t vertices, normals; /* before the current statement */
    bool *stuck;              /* by vertex */
};

/* The slot of a pair: that of its copy, or the empty one where it belongs. */
static uint32_t *find_slot(const struct obj_normals *n, uint32_t normal, uint32_t vertex) {
    uint64_t h = ((uint64_t)normal << 32 | vertex) * 0x9E3779B97F4A7C15U;
    for (size_t i = (h ^ h >> 32) & (n->slot_count - 1);; i = (i + 1) & (n->slot_count - 1)) {
        uint32_t c = n->slot[i];
        if (c == 0 || (n->copy[c - 1].normal == normal && n->copy[c - 1].vertex == vertex))
            return &n->slot[i];
    }
}

static const struct obj_normal_copy *find_copy(const struct obj_normals *n, size_t normal,
                                               size_t vertex) {
    uint32_t c = n->slot_count ? *find_slot(n, (uint32_t)normal, (uint32_t)vertex) : 0;
    return c ? &n->copy[c - 1] : NULL;
}

/* Keeps the table at most half full. */
static bool grow_table(struct obj_normals *n, struct err *err) {
    if (2 * (n->copy_count + 1) <= n->slot_count) return true;
    free(n->slot);
    n->slot_count = n->slot_count ? 2 * n->slot_count : 1024;
    if (!mem_new(n->slot, n->slot_count, err)) return false;
    for (size_t c = 0; c < n->copy_count; c++)
        *find_slot(n, n->copy[c].normal, n->copy[c].vertex) = (uint32_t)c + 1;
    return true;
}

static bool add_copy(struct planner *p, size_t normal, size_t vertex, const double value[3]) {
    struct obj_normals *n = p->plan;
    size_t last = p->normals > 0 ? p->normals - 1 : 0;
    struct obj_normal_copy copy = {
        .normal = (uint32_t)normal, .vertex = (uint32_t)vertex, .after = (uint32_t)last};
    memcpy(copy.value, value, sizeof copy.value);
    if (n->copy_count == INT32_MAX)
        return obj_fail(&p->scan, p->scan.line, "more than %d copies of normals", INT32_MAX);
    if (!grow_table(n, &p->scan.err) ||
        !mem_grow(n->copy, &n->copy_cap, n->copy_count + 1, &p->scan.err))
        return false;
    n->copy[n->copy_count++] = copy;
    *find_slot(n, copy.normal, copy.vertex) = (uint32_t)n->copy_count;
    return true;
}

static void turn(struct planner *p, size_t normal, size_t vertex, double result[3]) {
    if (p->turn(p->context, vertex, p->points->normal[normal], result) || p->stuck[vertex]) return;
    p->stuck[vertex] = true;
    if (p->plan->stuck_count++ == 0) p->plan->stuck_first = vertex;
}

/* Do two results differ by more than the rounding noise of Jacobians? */
static bool differ(const double a[3], const double b[3]) {
    double noise = 0x1p-44 * fmax(fabs(a[0]), fmax(fabs(a[1]), fabs(a[2])));
    for (int c = 0; c < 3; c++)
        if (fabs(a[c] - b[c]) > noise) return true;
    return false;
}

static bool add_pair(struct planner *p, size_t normal, size_t vertex) {
    struct obj_normals *n = p->plan;
    double value[3];
    if (n->owner[normal] == vertex || find_copy(n, normal, vertex)) return true;
    if (n->owner[normal] == OBJ_UNUSED) {
        n->owner[normal] = (uint32_t)vertex;
        turn(p, normal, vertex, n->value[normal]);
        return true;
    }
    turn(p, normal, vertex, value);
    return !differ(n->value[normal], value) || add_copy(p, normal, vertex, value);
}

static bool add_corner(struct planner *p, const struct obj_corner *corner) {
    struct obj_scan *s = &p->scan;
    size_t normal, vertex;
    if (!obj_resolve(s, corner, "vertex", corner->vertex, p->vertices, &vertex) ||
        !obj_resolve(s, corner, "normal", corner->normal, p->normals, &normal))
        return false;
    if (vertex >= p->points->vertex_count)
        return obj_fail(s, corner->begin, "vertex %zu does not exist: the model has %zu",
                        vertex + 1, p->points->vertex_count);
    if (normal >= p->points->normal_count)
        return obj_fail(s, corner->normal_at, "normal %zu does not exist: the model has %zu",
                        normal + 1, p->points->normal_count);
    return add_pair(p, normal, vertex);
}

static bool plan_all(struct planner *p) {
    struct obj_corner corner;
    enum obj_kind kind;
    while ((kind = obj_next(&p->scan)) != OBJ_END) {
        p->vertices += kind == OBJ_VERTEX;
        p->normals += kind == OBJ_NORMAL;
        if (!obj_to_corners(&p->scan, kind)) continue;
        while (obj_corner(&p->scan, &corner))
            if (corner.normal && !add_corner(p, &corner)) return false;
    }
    return p->scan.err.kind == ERR_NONE;
}

static bool count_before(struct obj_normals *n, struct err *err) {
    uint32_t c = 0;
    if (!mem_new(n->before, n->normal_count + 1, err)) return false;
    for (size_t i = 0; i <= n->normal_count; i++) {
        while (c < n->copy_count && n->copy[c].after < i) c++;
        n->before[i] = c;
    }
    return true;
}

bool obj_normals_plan(struct obj_normals *n, const struct filemap *f, const struct obj_points *p,
                      obj_turn *turn_, void *context, struct err *err) {
    struct planner planner = {.plan = n, .points = p, .turn = turn_, .context = context};
    bool ok;
    *n = (struct obj_normals){.normal_count = p->normal_count};
    obj_scan_init(&planner.scan, f->name, f->data, f->length);
    ok = mem_new(n->owner, p->normal_count, err) && mem_new(n->value, p->normal_count, err) &&
         mem_new(planner.stuck, p->vertex_count, err);
    for (size_t i = 0; ok && i < p->normal_count; i++) n->owner[i] = OBJ_UNUSED;
    if (ok && !plan_all(&planner)) {
        *err = planner.scan.err;
        ok = false;
    }
    ok = ok && count_before(n, err);
    free(planner.stuck);
    if (!ok) obj_normals_free(n);
    return ok;
}

void obj_normals_free(struct obj_normals *n) {
    free(n->owner);
    free(n->value);
    free(n->copy);
    free(n->before);
    free(n->slot);
    *n = (struct obj_normals){0};
}

size_t obj_normals_number(const struct obj_normals *n, size_t normal, size_t vertex) {
    const struct obj_normal_copy *copy =
        n->owner[normal] == vertex ? NULL : find_copy(n, normal, vertex);
    return copy ? copy->after + 1 + (size_t)(copy - n->copy) : normal + n->before[normal];
}

size_t obj_normals_defined(const struct obj_normals *n, size_t count) {
    return count + n->before[count];
}

bool obj_normals_check(const struct filemap *f, struct err *err) {
    struct obj_scan s;
    struct obj_corner corner;
    enum obj_kind kind;
    obj_scan_init(&s, f->name, f->data, f->length);
    while ((kind = obj_next(&s)) != OBJ_END)
        if (obj_to_corners(&s, kind))
            while (obj_corner(&s, &corner)) continue;
    if (s.err.kind == ERR_NONE) return true;
    *err = s.err;
    return false;
}
