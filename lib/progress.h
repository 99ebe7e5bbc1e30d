/* SPDX-License-Identifier: GPL-3.0-or-later */
/* progress - how far long work has come: the library tells it, a program may show it (cli.h). */
#ifndef PROGRESS_H
#define PROGRESS_H

#include <stddef.h>

struct progress {
    void (*show)(struct progress *progress, double fraction);
};

/* To be called as often as is convenient; NULL: nobody wants to know. */
static inline void progress_tell(struct progress *progress, size_t done, size_t total) {
    if (progress && done % 4096 == 0) progress->show(progress, (double)done / (double)total);
}

/* The same of few and large steps, of which each is told. */
static inline void progress_step(struct progress *progress, size_t done, size_t total) {
    if (progress) progress->show(progress, (double)done / (double)total);
}

#endif
