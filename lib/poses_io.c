/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "poses_io.h"

#include "mem.h"
#include "src.h"

#include <string.h>
#include <sys/stat.h>

struct reader {
    struct src src;
    struct poses *poses;
    size_t cap;
    const char *folder, *extension;
};

static const char *base_name(const char *path) {
    const char *slash = strrchr(path, '/');
    return slash ? slash + 1 : path;
}

static char *copy(const char *text, size_t length, struct err *err) {
    char *s = mem_alloc(length + 1, 1, err);
    if (s) memcpy(s, text, length);
    return s;
}

/* FOLDER/NAME, or FOLDER/STEM and the extension. */
static char *output_of(const struct reader *r, const char *name, struct err *err) {
    const char *dot = strrchr(name, '.'), *extension = r->extension ? r->extension : "";
    size_t folder = strlen(r->folder), stem = strlen(name), end = strlen(extension);
    char *s;
    if (r->extension && dot && dot > name) stem = (size_t)(dot - name);
    s = mem_alloc(folder + stem + end + 2, 1, err);
    if (!s) return NULL;
    memcpy(s, r->folder, folder);
    s[folder] = '/';
    memcpy(s + folder + 1, name, stem);
    memcpy(s + folder + 1 + stem, extension, end);
    return s;
}

/* All that is left of the line but blanks around it. */
static bool read_pose(struct reader *r) {
    struct src *src = &r->src;
    const char *word, *end = src->end;
    size_t length;
    struct pose *p;
    if (!src_word(src, &word, &length)) return src_expected(src, "a file name");
    while (end[-1] == ' ' || end[-1] == '\t') end--;
    length = (size_t)(end - word);
    if (memchr(word, '\0', length)) return src_fail(src, word, "expected a file name, got a NUL");
    if (length == 1 && *word == '-')
        return src_fail(src, word, "expected a file name, got '-': stdin cannot be a pose");
    if (!mem_grow(r->poses->pose, &r->cap, r->poses->count + 1, &src->err)) return false;
    p = &r->poses->pose[r->poses->count++];
    *p = (struct pose){.line = src->line, .path = copy(word, length, &src->err)};
    if (!p->path) return false;
    if (*base_name(p->path) == '\0')
        return src_fail(src, word, "expected a file name, got the folder '%s'", p->path);
    p->output = output_of(r, base_name(p->path), &src->err);
    return p->output != NULL;
}

struct sorted {
    const struct pose *pose;
};

static int by_output(const void *a, const void *b) {
    const struct pose *p = ((const struct sorted *)a)->pose, *q = ((const struct sorted *)b)->pose;
    int order = strcmp(p->output, q->output);
    return order ? order : (p->line > q->line) - (p->line < q->line);
}

/* The clash that comes first in the list. */
static bool check_names(struct reader *r, struct err *err) {
    const struct poses *p = r->poses;
    const struct pose *first = NULL, *second = NULL;
    struct sorted *sorted = NULL;
    if (!mem_new(sorted, p->count, err)) return false;
    for (size_t i = 0; i < p->count; i++) sorted[i].pose = &p->pose[i];
    qsort(sorted, p->count, sizeof *sorted, by_output);
    for (size_t i = 1; i < p->count; i++) {
        const struct pose *before = sorted[i - 1].pose, *pose = sorted[i].pose;
        if (strcmp(before->output, pose->output) != 0) continue;
        if (second && second->line < pose->line) continue;
        first = before;
        second = pose;
    }
    free(sorted);
    return !second ||
           err_set_at(err, ERR_USAGE, r->src.name, second->line, 1,
                      "the output '%s' is already that of line %zu", second->output, first->line);
}

static bool spare(const char *output, const char *path, struct err *err) {
    struct stat a, b;
    if (stat(output, &a) < 0 || stat(path, &b) < 0 || a.st_dev != b.st_dev || a.st_ino != b.st_ino)
        return true;
    return err_set(err, ERR_USAGE, "'%s', which is to be read, would be overwritten", path);
}

bool poses_spare(const struct poses *p, const char *path, struct err *err) {
    if (!path || strcmp(path, "-") == 0) return true;
    for (size_t i = 0; i < p->count; i++)
        if (strcmp(base_name(p->pose[i].output), base_name(path)) == 0)
            return spare(p->pose[i].output, path, err);
    return true;
}

bool poses_read(struct poses *p, const char *list, const char *folder, const char *extension,
                struct err *err) {
    struct reader r = {.poses = p, .folder = folder, .extension = extension};
    bool ok;
    *p = (struct poses){0};
    if (!src_open(&r.src, list, err)) return false;
    while (src_line(&r.src) && read_pose(&r)) continue;
    if (!r.src.err.kind && p->count == 0) src_expected(&r.src, "a file name");
    ok = r.src.err.kind == ERR_NONE;
    if (!ok) *err = r.src.err;
    ok = ok && check_names(&r, err);
    for (size_t i = 0; ok && i < p->count; i++) ok = spare(p->pose[i].output, p->pose[i].path, err);
    src_close(&r.src);
    return ok;
}

bool poses_commit(struct poses *p, struct err *err) {
    for (size_t i = 0; i < p->count; i++)
        if (!out_commit(&p->pose[i].pending, err)) return false;
    return true;
}

void poses_free(struct poses *p) {
    for (size_t i = 0; i < p->count; i++) {
        out_revoke(&p->pose[i].pending);
        free(p->pose[i].path);
        free(p->pose[i].output);
    }
    free(p->pose);
    *p = (struct poses){0};
}
