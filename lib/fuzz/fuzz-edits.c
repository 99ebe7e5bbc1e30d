/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Scripts: the text of each statement is read again as a statement with the same text. */
#include "edits_io.h"
#include "fuzzing.h"

#include <string.h>

/* Statements that name a file, inside:FILE, are left alone: the file need not exist any more. */
static void check_statement(const struct script *script, const struct script_statement *statement) {
    struct script again = {0};
    struct err err = {0};
    char *once = edits_text(script, statement, &err), *twice;
    INVARIANT(once);
    if (!strstr(once, "inside:") && statement->verb != SCRIPT_SUGGEST) {
        INVARIANT(edits_parse(&again, "again", once, strlen(once), &err));
        INVARIANT(again.statement_count == 1);
        twice = edits_text(&again, again.statement, &err);
        INVARIANT(twice && strcmp(once, twice) == 0);
        free(twice);
        script_free(&again);
    }
    free(once);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    struct fuzz_file f = fuzz_open(data, size);
    struct script script = {0};
    struct err err = {0};
    if (edits_read(&script, f.path, &err)) {
        for (size_t i = 0; i < script.statement_count; i++)
            check_statement(&script, &script.statement[i]);
        script_free(&script);
    } else {
        INVARIANT(err.kind != ERR_NONE && err.message[0]);
    }
    close(f.fd);
    return 0;
}
