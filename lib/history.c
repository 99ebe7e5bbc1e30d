/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "history.h"

#include "mem.h"

#include <stdio.h>
#include <string.h>

char *history_add(const char *history, const char *line, struct err *err) {
    size_t size = (history ? strlen(history) : 0) + strlen(line) + sizeof "# \n";
    char *text = mem_alloc(size, 1, err);
    if (text) snprintf(text, size, "%s# %s\n", history ? history : "", line);
    return text;
}

bool history_next(const char **history, const char **text, const char **end) {
    const char *line = *history;
    if (*line == '\0') return false;
    *end = strchrnul(line, '\n');
    *history = **end ? *end + 1 : *end;
    if (*line == '#') line++;
    if (line < *end && *line == ' ') line++;
    *text = line;
    return true;
}
