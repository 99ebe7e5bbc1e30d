/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "mem.h"

#ifdef __GLIBC__
#include <malloc.h>
#endif
#include <string.h>
#include <sys/mman.h>

enum { HUGE_PAGE = 2 << 20 };

/* Large arrays on huge pages, where the system has them: 512 times fewer page faults. NULL: no
 * memory. The bytes are not set. */
static void *alloc_large(size_t bytes) {
    size_t whole = (bytes + HUGE_PAGE - 1) / HUGE_PAGE * HUGE_PAGE;
    void *p = whole >= bytes ? aligned_alloc(HUGE_PAGE, whole) : NULL;
    if (p) (void)madvise(p, whole, MADV_HUGEPAGE);
    return p;
}

void *mem_alloc_unset(size_t n, size_t size, struct err *err) {
    size_t bytes;
    void *p = NULL;
    if (!__builtin_mul_overflow(n, size, &bytes))
        p = bytes >= HUGE_PAGE ? alloc_large(bytes) : malloc(bytes ? bytes : 1);
    if (!p) err_memory(err);
    return p;
}

void *mem_alloc(size_t n, size_t size, struct err *err) {
    size_t bytes;
    bool large = !__builtin_mul_overflow(n, size, &bytes) && bytes >= HUGE_PAGE;
    void *p = large ? alloc_large(bytes) : calloc(n ? n : 1, size);
    if (!p) err_memory(err);
    return p && large ? memset(p, 0, bytes) : p;
}

/* As realloc. */
static void *resize(void *old, size_t old_bytes, size_t bytes) {
    void *fresh;
    if (bytes < HUGE_PAGE) return realloc(old, bytes);
    fresh = alloc_large(bytes);
    if (!fresh) return NULL;
    if (old) memcpy(fresh, old, old_bytes);
    free(old);
    return fresh;
}

bool mem_grow_bytes(void *array, size_t *cap, size_t need, size_t size, struct err *err) {
    size_t n = 2 * *cap, bytes; /* pages that are never used cost nothing */
    void *old, *fresh;
    if (n < need) n = need;
    if (n < 16) n = 16;
    if (__builtin_mul_overflow(n, size, &bytes)) return err_memory(err);
    memcpy(&old, array, sizeof old); /* array is a T **; memcpy keeps the aliasing rules */
    fresh = resize(old, *cap * size, bytes);
    if (!fresh) return err_memory(err);
    memcpy(array, &fresh, sizeof fresh);
    *cap = n;
    return true; /* cppcheck-suppress memleak ; *array owns it */
}

void mem_trim(void) {
#ifdef __GLIBC__
    (void)malloc_trim(0);
#endif
}
