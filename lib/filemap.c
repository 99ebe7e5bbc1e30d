/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "filemap.h"

#include "mem.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

enum { CHUNK = 1 << 18 };

/* A new file without a name in the folder for temporaries; -1 and errno if there is none. */
static int open_unlinked(void) {
    const char *folder = getenv("TMPDIR");
    char path[4096];
    int fd;
    if (!folder || !*folder) folder = "/tmp";
    if (snprintf(path, sizeof path, "%s/supple.XXXXXX", folder) >= (int)sizeof path) {
        errno = ENAMETOOLONG;
        return -1;
    }
    fd = mkstemp(path);
    if (fd >= 0) unlink(path);
    return fd;
}

static bool write_all(int fd, const char *bytes, size_t length) {
    while (length > 0) {
        ssize_t done = write(fd, bytes, length);
        if (done < 0 && errno == EINTR) continue;
        if (done < 0) return false;
        bytes += done;
        length -= (size_t)done;
    }
    return true;
}

/* Copies all of `from` to `to`. */
static bool copy(const struct filemap *f, int from, int to, struct err *err) {
    char *chunk;
    ssize_t got = 1;
    bool ok = true;
    if (!mem_new(chunk, CHUNK, err)) return false;
    while (ok && got != 0) {
        got = read(from, chunk, CHUNK);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0)
            ok = err_system(err, "read", f->name);
        else if (!write_all(to, chunk, (size_t)got))
            ok = err_system(err, "write a temporary copy of", f->name);
    }
    free(chunk);
    return ok;
}

/* Maps the regular file fd from byte `start` on. */
static bool map(struct filemap *f, int fd, off_t start, struct err *err) {
    struct stat st;
    void *at;
    if (fstat(fd, &st) < 0) return err_system(err, "read", f->name);
    if (st.st_size <= start) return true;
    at = mmap(NULL, (size_t)st.st_size, PROT_READ, MAP_PRIVATE, fd, 0);
    if (at == MAP_FAILED) return err_system(err, "map", f->name);
    (void)madvise(at, (size_t)st.st_size, MADV_SEQUENTIAL);
    f->map = at;
    f->data = (const char *)at + start;
    f->length = (size_t)(st.st_size - start);
    return true;
}

static bool spool(struct filemap *f, int fd, struct err *err) {
    int temporary = open_unlinked();
    bool ok;
    if (temporary < 0) return err_system(err, "create a temporary copy of", f->name);
    ok = copy(f, fd, temporary, err) && map(f, temporary, 0, err);
    close(temporary);
    return ok;
}

bool filemap_open(struct filemap *f, const char *path, struct err *err) {
    bool standard = !path || strcmp(path, "-") == 0, ok;
    int fd = standard ? STDIN_FILENO : open(path, O_RDONLY | O_CLOEXEC);
    struct stat st;
    *f = (struct filemap){.name = standard ? "<stdin>" : path, .data = ""};
    if (fd < 0) return err_system(err, "open", f->name);
    if (fstat(fd, &st) == 0 && S_ISREG(st.st_mode)) {
        off_t start = lseek(fd, 0, SEEK_CUR);
        ok = map(f, fd, start > 0 ? start : 0, err);
    } else
        ok = spool(f, fd, err); /* a folder fails in read: "Is a directory" */
    if (!standard) close(fd);
    return ok;
}

void filemap_close(struct filemap *f) {
    if (f->map) munmap(f->map, f->length + (size_t)(f->data - (const char *)f->map));
    *f = (struct filemap){.data = ""};
}
