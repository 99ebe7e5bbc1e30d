/* SPDX-License-Identifier: GPL-3.0-or-later */
/* mem - allocation with overflow checks. What it returns is released with free(). */
#ifndef MEM_H
#define MEM_H

#include "err.h"

#include <stdlib.h>

/* n zeroed elements of the given size; never NULL on success, also for n = 0. */
void *mem_alloc(size_t n, size_t size, struct err *err) WARN_UNUSED;

/* The same, not zeroed: for what is overwritten anyway; takes no memory until it is. */
void *mem_alloc_unset(size_t n, size_t size, struct err *err) WARN_UNUSED;

/* Sets p to n zeroed elements of its type; false if there is no memory. */
#define mem_new(p, n, err) (((p) = mem_alloc((n), sizeof *(p), (err))) != NULL)

/* Makes room for `need` elements in the array p of capacity *cap (both may start as NULL and 0),
 * doubling it at least, so that appending costs O(1) on average. New room is not zeroed. */
#define mem_grow(p, cap, need, err)                                                                \
    ((need) <= *(cap) || mem_grow_bytes((void *)&(p), (cap), (need), sizeof *(p), (err)))
bool mem_grow_bytes(void *array, size_t *cap, size_t need, size_t size,
                    struct err *err) WARN_UNUSED;

/* Gives what was freed back to the system, as far as it can: before work that needs much, after
 * work that needed much in small pieces. */
void mem_trim(void);

#endif
