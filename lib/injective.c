/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "injective.h"

#include "embed.h"
#include "fans.h"
#include "jacobian.h"

static bool prove_positive(const struct spline *s, enum jacobian_kind kind, const char *what,
                           struct err *err) {
    struct jacobian_report r;
    enum jacobian_verdict verdict;
    uint32_t t;
    if (!jacobian_report_init(&r, s, kind, &jacobian_default_rule, false, err)) return false;
    verdict = r.least.verdict;
    t = r.triangle;
    jacobian_report_free(&r);
    if (verdict == JACOBIAN_CERTIFIED) return true;
    return err_set(err, ERR_REFUSAL, "%s one-to-one: %s: %s, see triangle %u",
                   verdict == JACOBIAN_FOLDS ? "not" : "not proved to be", what,
                   jacobian_verdict_names[verdict], t);
}

static bool prove_fans(const struct spline *s, struct err *err) {
    enum fan_kind kind;
    uint32_t turns, v = fans_worst(s, &kind, &turns);
    if (kind == FAN_SOUND) return true;
    if (kind == FAN_COVERS)
        return err_set(
            err, ERR_REFUSAL,
            "not one-to-one: the images of the triangles around vertex %u overlap, %u turns", v,
            turns);
    return err_set(
        err, ERR_REFUSAL,
        "not proved to be one-to-one: the images of the triangles around vertex %u close "
        "to a full turn",
        v);
}

bool injective_prove(const struct spline *s, struct err *err) {
    char overlap[SIDES_TEXT_MAX];
    if (!embed_check_grid(&s->grid, overlap, err)) return false;
    if (overlap[0])
        return err_set(err, ERR_REFUSAL, "not one-to-one: triangles overlap: %s", overlap);
    return prove_positive(s, JACOBIAN_PLANE, "det grad phi > 0", err) && prove_fans(s, err) &&
           (!s->sigma || prove_positive(s, JACOBIAN_THICKNESS, "sigma1 > sigma0", err));
}
