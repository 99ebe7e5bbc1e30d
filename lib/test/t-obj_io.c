/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Oracle for copies: models are made from random corners whose meaning is known; the copy is read
 * by a reader of its own (strtod, strtol), which finds for each corner the normal that the faces of
 * the copy mean. That must be the known turn of the known normal. */
#include "obj_io.h"

#include "mem.h"
#include "obj_copy.h"
#include "testing.h"

#include <fcntl.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

enum { VERTICES_MAX = 40, NORMALS_MAX = 40, FACES_MAX = 40, CORNERS = 3, TEXT_MAX = 1 << 16 };

/* --- model_read ----------------------------------------------------------------------------- */

/* Writes text to a new file named in path, of 32 bytes. */
static void write_file(char *path, const char *text, size_t length) {
    int fd;
    strcpy(path, "/tmp/supple-test.XXXXXX");
    fd = mkstemp(path);
    assert_true(fd >= 0 && write(fd, text, length) == (ssize_t)length && close(fd) == 0);
}

static bool read_text(struct model *m, const char *text, struct err *err) {
    char path[32];
    bool ok;
    write_file(path, text, strlen(text));
    ok = model_read(m, path, err);
    unlink(path);
    return ok;
}

static void elements(void **unused) {
    const char *text = "# f 9 9 9\r\n"
                       "f 1 2// 3/ # ahead\n"
                       "v 1 2 3\n\tv +4. .5 -6e0 1 0 0\r\n v 7 8 9 2.5\n"
                       "g f 1 2 3 \\\nv 0 0 0\n"
                       "f \\\n -1/5/-9 \\\r\n 1//2 2/3\n"
                       "l 1 2/7 -1 1\np 3 -2\nvp 1 2\nfx\nvn nan\nf 1 2 3 1#4\n"
                       "v 1e-400 -0 -1e-400";
    const double vertex[4][3] = {{1, 2, 3}, {4, 0.5, -6}, {7, 8, 9}, {0, -0.0, -0.0}};
    const uint32_t index[] = {0, 1, 2, 2, 0, 1, 0, 1, 2, 0, 2, 1, 0, 1, 2, 0};
    const size_t start[] = {0, 3, 6, 10, 11, 12, 16};
    struct model m;
    struct err err = {0};
    assert_true(read_text(&m, text, &err));
    assert_int_equal(m.vertex_count, 4);
    assert_memory_equal(m.vertex, vertex, sizeof vertex);
    assert_int_equal(m.element_count, 6);
    assert_memory_equal(m.kind, "fflppf", 6);
    assert_memory_equal(m.start, start, sizeof start);
    assert_memory_equal(m.index, index, sizeof index);
    model_free(&m);
    (void)unused;
}

static void errors(void **unused) {
    static const struct {
        const char *text;
        size_t line, col;
        const char *message;
    } bad[] = {
        {"", 1, 1, "expected a vertex line 'v x y z', got end of file"},
        {"# v 1 2 3\n", 2, 1, "expected a vertex line 'v x y z', got end of file"},
        {"v 1 2\n", 1, 6, "expected a coordinate, got end of line"},
        {"v 1 2 # 3\n", 1, 7, "expected a coordinate, got end of line"},
        {"\r\n v 1 2 x3\r\n", 2, 8, "expected a coordinate, got 'x3'"},
        {"v 1 2 3,\n", 1, 7, "expected a coordinate, got '3,'"},
        {"v 1 2 1e400\n", 1, 7, "expected a coordinate, got a number too large"},
        {"v 1 2 \\\n3 red", 2, 3, "expected a weight or colour, got 'red'"},
        {"v 1 2\\\n3 4\n", 1, 5, "expected a coordinate, got '2\\'"},
        {"v 0 0 0\nf 1 1\n", 2, 6, "expected 3 or more vertices, got 2"},
        {"v 0 0 0\nl 1\n", 2, 4, "expected 2 or more vertices, got 1"},
        {"v 0 0 0\nf 1 2 1\n", 2, 5, "vertex 2 does not exist: the model has 1"},
        {"f 1 -1 1\nv 0 0 0\n", 1, 5, "vertex -1 does not exist: 0 before this line"},
        {"v 0 0 0\nf 1 1 0\n", 2, 7, "index 0: indices count from 1, or back from -1"},
        {"v 0 0 0\nf 1 1 99999999999999999999\n", 2, 7, "index out of range"},
        {"v 0 0 0\nf 1 1 4294967297\n", 2, 7, "vertex 4294967297 does not exist: the model has 1"},
        {"v 0 0 0\nf 1 /1 1\n", 2, 5, "expected a vertex index, got '/1'"},
        {"v 0 0 0\nf 1 1/1/1/1 1\n", 2, 5,
         "expected indices v, v/vt, v//vn, v/vt/vn, got '1/1/1/1'"},
    };
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        struct model m;
        struct err err = {0};
        assert_false(read_text(&m, bad[i].text, &err));
        assert_string_equal(err.message, bad[i].message);
        assert_int_equal(err.kind, ERR_INPUT);
        assert_int_equal(err.line, bad[i].line);
        assert_int_equal(err.col, bad[i].col);
    }
    (void)unused;
}

/* Any number of continuations must not take quadratic time or deep recursion. */
static void many_continuations(void **unused) {
    size_t n = 300000, length = 0;
    char *text;
    struct model m;
    struct err err = {0};
    assert_true(mem_new(text, 3 * n + 100, &err));
    length += (size_t)sprintf(text, "v 1 2 ");
    for (size_t i = 0; i < n; i++, length += 2) memcpy(text + length, "\\\n", 2);
    length += (size_t)sprintf(text + length, " 3\nf");
    for (size_t i = 0; i < n / 2; i++, length += 2) memcpy(text + length, " 1", 2);
    assert_true(read_text(&m, text, &err));
    assert_int_equal(m.start[1], n / 2);
    model_free(&m);
    free(text);
    (void)unused;
}

/* --- random models -------------------------------------------------------------------------- */

struct corner {
    int vertex, normal; /* normal -1: none */
};

/* A model whose lines come in random order. */
struct random_model {
    int vertices, normals, faces;
    struct corner corner[FACES_MAX][CORNERS];
    char text[TEXT_MAX];
    size_t length;
};

static void append(struct random_model *m, const char *format, ...) {
    va_list args;
    va_start(args, format);
    m->length += (size_t)vsnprintf(m->text + m->length, TEXT_MAX - m->length, format, args);
    va_end(args);
    assert_true(m->length < TEXT_MAX - 1);
}

/* An index from 0 as the text of one that counts from 1 or, if it exists already, back. */
static int64_t styled(uint64_t *s, int index, int defined) {
    return index < defined && random_in(s, 0, 1) ? index - defined : index + 1;
}

static void append_face(struct random_model *m, uint64_t *s, int vertices, int normals, int most) {
    struct corner *corners = m->corner[m->faces++];
    append(m, "%s", random_in(s, 0, 9) ? "f" : "  f\t");
    for (int c = 0; c < CORNERS; c++) {
        struct corner *k = &corners[c];
        int ahead = random_in(s, 0, 3) == 0 || normals == 0 ? most : normals;
        k->vertex = (int)random_in(s, 0, VERTICES_MAX / 2 - 1);
        k->normal = random_in(s, 0, 9) ? (int)random_in(s, 0, ahead - 1) : -1;
        append(m, " %lld", (long long)styled(s, k->vertex, vertices));
        if (k->normal < 0) continue;
        append(m, random_in(s, 0, 1) ? "/7/%lld" : "//%lld",
               (long long)styled(s, k->normal, normals));
        if (random_in(s, 0, 19) == 0) append(m, " \\\n");
    }
}

static void make_model(struct random_model *m, uint64_t seed) {
    uint64_t s = seed;
    bool crlf = random_in(&s, 0, 3) == 0;
    int most = (int)random_in(&s, 1, NORMALS_MAX / 2); /* normals in the end */
    int vertices = 0, normals = 0;
    *m = (struct random_model){.vertices = VERTICES_MAX / 2, .normals = most};
    while (vertices < m->vertices || normals < most || m->faces < FACES_MAX / 2) {
        int64_t what = random_in(&s, 0, 9);
        if (what < 4 && vertices < m->vertices)
            append(m, "v %d 0.%d 1e0 0.5", vertices, vertices + 1), vertices++;
        else if (what < 6 && normals < most)
            append(m, " vn 1 %d.0 +0.%d # normal", normals, normals + 1), normals++;
        else if (what < 9 && m->faces < FACES_MAX)
            append_face(m, &s, vertices, normals, most);
        else
            append(m, "usemtl f 1//1 v vn");
        append(m, crlf ? "\r\n" : "\n");
    }
    if (random_in(&s, 0, 1)) m->length -= crlf ? 2 : 1; /* no final end of line */
    m->text[m->length] = '\0';
}

/* The planted turn: some vertices leave normals alone, some share a result, one is stuck. */
static bool planted_turn(void *context, size_t vertex, const double normal[3], double result[3]) {
    const int *kinds = context;
    memcpy(result, normal, 3 * sizeof *result);
    if (vertex == 3) return false;
    if (kinds[0] > 1) result[0] += (double)((int)vertex % kinds[0]);
    return true;
}

/* --- reading the copy ----------------------------------------------------------------------- */

struct copy_reader {
    double normal[NORMALS_MAX * VERTICES_MAX][3];
    int normals, vertices;
    int64_t written[FACES_MAX][CORNERS][2]; /* vertex and normal from 0; -1: none */
    int faces;
};

static const char *skip_blanks(const char *p) {
    while (*p == ' ' || *p == '\t' || (*p == '\\' && p[1] == '\n')) p += *p == '\\' ? 2 : 1;
    return p;
}

static const char *read_face(struct copy_reader *r, const char *p) {
    for (int c = 0; c < CORNERS; c++) {
        char *next;
        int64_t *to = r->written[r->faces][c], n = strtol(skip_blanks(p), &next, 10);
        to[0] = n < 0 ? r->vertices + n : n - 1;
        to[1] = -1;
        if (*next == '/') {
            next++;
            if (*next != '/') (void)strtol(next, &next, 10);
            if (*next == '/') {
                n = strtol(next + 1, &next, 10);
                to[1] = n < 0 ? r->normals + n : n - 1;
            }
        }
        p = next;
    }
    r->faces++;
    return p;
}

static void read_copy(struct copy_reader *r, const char *text) {
    *r = (struct copy_reader){0};
    for (const char *p = text; *p; p = strchr(p, '\n') ? strchr(p, '\n') + 1 : "") {
        p = skip_blanks(p);
        if (p[0] == 'f' && (p[1] == ' ' || p[1] == '\t')) p = read_face(r, p + 1);
        if (p[0] == 'v' && p[1] == ' ') r->vertices++;
        if (p[0] == 'v' && p[1] == 'n' && p[2] == ' ') {
            char *at = (char *)(uintptr_t)(p + 2);
            for (int c = 0; c < 3; c++) r->normal[r->normals][c] = strtod(at, &at);
            r->normals++;
        }
    }
}

/* The copy of a model as text; NULL never. The caller frees it. */
static char *copy_model(const struct random_model *m, enum obj_normal_mode mode, int kinds,
                        struct obj_normals *plan) {
    struct filemap f = {.name = "model", .data = m->text, .length = m->length};
    struct obj_change change = {.normals = mode, .plan = plan};
    struct obj_points points;
    struct out out;
    struct err err = {0};
    char path[32], *text = NULL;
    FILE *file;
    size_t n;
    write_file(path, "", 0); /* only for its name: renaming over a file is slow */
    unlink(path);
    assert_true(obj_points_read(&points, &f, &err));
    for (size_t v = 0; v < points.vertex_count; v++) points.vertex[v][2] += 0.125;
    change.vertex = points.vertex;
    if (mode == OBJ_NORMALS_TRANSFORM)
        assert_true(obj_normals_plan(plan, &f, &points, planted_turn, &kinds, &err));
    assert_true(out_open(&out, path, &err));
    assert_true(obj_copy(&out, &f, &points, &change, &err));
    assert_true(out_close(&out, &err));
    obj_points_free(&points);
    file = fopen(path, "r");
    assert_non_null(file);
    assert_true(mem_new(text, TEXT_MAX * 4, &err));
    n = fread(text, 1, TEXT_MAX * 4 - 1, file);
    text[n] = '\0';
    fclose(file);
    unlink(path);
    return text;
}

/* --- properties ----------------------------------------------------------------------------- */

static void corners_mean_the_turned_normals(void **unused) {
    static struct random_model m;
    static struct copy_reader r;
    for (int i = 0; i < test_count(1500); i++) {
        uint64_t seed = (uint64_t)i;
        int kinds = i % 5, pairs = 0;
        struct obj_normals plan;
        bool seen[NORMALS_MAX][VERTICES_MAX] = {{false}};
        int owner[NORMALS_MAX];
        make_model(&m, seed);
        char *text = copy_model(&m, OBJ_NORMALS_TRANSFORM, kinds, &plan);
        read_copy(&r, text);
        for (int n = 0; n < NORMALS_MAX; n++) owner[n] = -1;
        check_seed(seed, r.faces == m.faces && r.vertices == m.vertices);
        for (int f = 0; f < m.faces; f++)
            for (int c = 0; c < CORNERS; c++) {
                struct corner k = m.corner[f][c];
                const int64_t *got = r.written[f][c];
                double plain[3] = {1, k.normal, 0}, want[3], first[3];
                check_seed(seed, got[0] == k.vertex);
                check_seed(seed, (got[1] < 0) == (k.normal < 0));
                if (k.normal < 0) continue;
                char digits[32];
                snprintf(digits, sizeof digits, "0.%d", k.normal + 1);
                plain[2] = strtod(digits, NULL);
                (void)planted_turn(&kinds, (size_t)k.vertex, plain, want);
                check_seed(seed, got[1] < r.normals);
                check_seed(seed, memcmp(r.normal[got[1]], want, sizeof want) == 0);
                if (owner[k.normal] < 0) owner[k.normal] = k.vertex;
                (void)planted_turn(&kinds, (size_t)owner[k.normal], plain, first);
                if (seen[k.normal][k.vertex] || first[0] == want[0]) continue;
                seen[k.normal][k.vertex] = true;
                pairs++;
            }
        check_seed(seed, r.normals == m.normals + pairs);
        check_seed(seed, (int)plan.copy_count == pairs);
        check_seed(seed, plan.stuck_count <= 1 && (plan.stuck_count == 0 || plan.stuck_first == 3));
        obj_normals_free(&plan);
        free(text);
    }
    (void)unused;
}

/* Without copies, face lines and all others but v and used vn pass byte for byte. */
static void unchanged_lines_pass(void **unused) {
    static struct random_model m;
    for (int i = 0; i < test_count(500); i++) {
        uint64_t seed = (uint64_t)i;
        enum obj_normal_mode mode = i % 2 ? OBJ_NORMALS_KEEP : OBJ_NORMALS_TRANSFORM;
        struct obj_normals plan = {0};
        make_model(&m, seed);
        char *text = copy_model(&m, mode, 0, &plan);
        const char *a = m.text, *b = text;
        while (*a && *b) {
            const char *a_end = strchr(a, '\n'), *b_end = strchr(b, '\n');
            size_t na = a_end ? (size_t)(a_end - a) + 1 : strlen(a);
            size_t nb = b_end ? (size_t)(b_end - b) + 1 : strlen(b);
            if (strncmp(a, "v ", 2) == 0)
                check_seed(seed, strncmp(b, "v ", 2) == 0 && strstr(b, " 1.125 0.5"));
            else if (mode == OBJ_NORMALS_KEEP || strncmp(a, " vn ", 4) != 0)
                check_seed(seed, na == nb && memcmp(a, b, na) == 0);
            else
                check_seed(seed, strncmp(b, " vn 1 ", 6) == 0 && strstr(b, " # normal"));
            a += na;
            b += nb;
        }
        check_seed(seed, *a == *b);
        obj_normals_free(&plan);
        free(text);
    }
    (void)unused;
}

static void dropped_normals_leave_the_rest(void **unused) {
    static struct random_model m;
    static struct copy_reader r;
    for (int i = 0; i < test_count(300); i++) {
        uint64_t seed = (uint64_t)i;
        make_model(&m, seed);
        char *text = copy_model(&m, OBJ_NORMALS_DROP, 0, NULL);
        read_copy(&r, text);
        check_seed(seed, r.normals == 0 && r.faces == m.faces && r.vertices == m.vertices);
        check_seed(seed, !strstr(text, "//7") && !strstr(text, "# normal"));
        for (int f = 0; f < m.faces; f++)
            for (int c = 0; c < CORNERS; c++) {
                check_seed(seed, r.written[f][c][0] == m.corner[f][c].vertex);
                check_seed(seed, r.written[f][c][1] == -1);
            }
        free(text);
    }
    (void)unused;
}

static void pipes_are_spooled(void **unused) {
    enum { N = 200000 };
    const char line[] = "# padding padding padding padding\n";
    int ends[2], status = 0, saved = dup(STDIN_FILENO);
    struct model m;
    struct err err = {0};
    assert_int_equal(pipe(ends), 0);
    pid_t child = fork();
    if (child == 0) {
        FILE *to = fdopen(ends[1], "w");
        close(ends[0]);
        for (int i = 0; i < N; i++) fputs(line, to);
        fputs("v 1 2 3\n", to);
        _exit(fclose(to) == 0 ? 0 : 1);
    }
    close(ends[1]);
    dup2(ends[0], STDIN_FILENO);
    close(ends[0]);
    assert_true(model_read(&m, "-", &err));
    assert_int_equal(m.vertex_count, 1);
    model_free(&m);
    assert_int_equal(waitpid(child, &status, 0), child);
    assert_int_equal(status, 0);
    dup2(saved, STDIN_FILENO);
    close(saved);
    (void)unused;
}

/* stdin from the middle of a regular file: what was read before is not read again. */
static void files_are_read_from_where_they_stand(void **unused) {
    char path[32];
    int saved = dup(STDIN_FILENO), fd;
    struct model m;
    struct err err = {0};
    write_file(path, "v x\nv 1 2 3\n", 12);
    fd = open(path, O_RDONLY);
    assert_int_equal(lseek(fd, 4, SEEK_SET), 4);
    dup2(fd, STDIN_FILENO);
    close(fd);
    unlink(path);
    assert_true(model_read(&m, NULL, &err));
    assert_int_equal(m.vertex_count, 1);
    model_free(&m);
    assert_false(model_read(&m, "/tmp", &err));
    assert_string_equal(err.message, "cannot read /tmp: Is a directory");
    assert_false(model_read(&m, "/nowhere/at all", &err));
    dup2(saved, STDIN_FILENO);
    close(saved);
    (void)unused;
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(elements),
        cmocka_unit_test(errors),
        cmocka_unit_test(many_continuations),
        cmocka_unit_test(corners_mean_the_turned_normals),
        cmocka_unit_test(unchanged_lines_pass),
        cmocka_unit_test(dropped_normals_leave_the_rest),
        cmocka_unit_test(pipes_are_spooled),
        cmocka_unit_test(files_are_read_from_where_they_stand),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
