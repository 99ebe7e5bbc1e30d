/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Lists of poses: names without blanks around them, outputs in the folder, all different. */
#include "fuzzing.h"
#include "poses_io.h"

#include <string.h>

static bool is_blank(char c) {
    return c == ' ' || c == '\t';
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    struct fuzz_file f = fuzz_open(data, size);
    struct poses p;
    struct err err = {0};
    if (poses_read(&p, f.path, "/no/folder", NULL, &err)) {
        INVARIANT(p.count > 0);
        for (size_t i = 0; i < p.count; i++) {
            const char *path = p.pose[i].path, *name = strrchr(path, '/');
            size_t length = strlen(path);
            INVARIANT(length > 0 && !is_blank(path[0]) && !is_blank(path[length - 1]));
            INVARIANT(!strpbrk(path, "\n#") && strncmp(p.pose[i].output, "/no/folder/", 11) == 0);
            INVARIANT(strcmp(p.pose[i].output + 11, name ? name + 1 : path) == 0);
            for (size_t k = 0; k < i; k++)
                INVARIANT(strcmp(p.pose[i].output, p.pose[k].output) != 0);
        }
    } else {
        INVARIANT((err.kind == ERR_INPUT || err.kind == ERR_USAGE) && err.message[0]);
    }
    poses_free(&p);
    close(f.fd);
    return 0;
}
