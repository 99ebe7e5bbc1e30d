/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Selectors, statements and blocks stand in three arrays in the order of the text; statements and
 * blocks refer to runs of the array before them, so that a script of any length is a few
 * allocations. Polygons are list elements because selectors point to them. */
#include "script.h"

#include "mem.h"

#include <string.h>

const char *const script_verb_names[] = {"move", "rotate", "scale",  "raise", "suggest",
                                         "pin",  "unpin",  "weight", NULL};

bool script_init(struct script *script, const char *name, struct err *err) {
    *script = (struct script){.name = strdup(name)};
    return script->name || err_memory(err);
}

void script_free(struct script *script) {
    while (script->polygons) {
        struct script_polygon *next = script->polygons->next;
        polygon_free(&script->polygons->polygon);
        free(script->polygons);
        script->polygons = next;
    }
    free(script->name);
    free(script->selector);
    free(script->statement);
    free(script->block);
    *script = (struct script){0};
}

bool script_add_selector(struct script *script, const struct selector *selector, struct err *err) {
    if (!mem_grow(script->selector, &script->selector_cap, script->selector_count + 1, err))
        return false;
    script->selector[script->selector_count++] = *selector;
    return true;
}

static bool add_block(struct script *script, const struct script_block *block, struct err *err) {
    if (!mem_grow(script->block, &script->block_cap, script->block_count + 1, err)) return false;
    script->block[script->block_count++] = *block;
    return true;
}

bool script_add_block(struct script *script, size_t line, uint32_t col, struct err *err) {
    return add_block(
        script,
        &(struct script_block){
            .first = script->statement_count, .grouped = true, .line = line, .col = col},
        err);
}

bool script_add_statement(struct script *script, const struct script_statement *statement,
                          bool to_last_block, struct err *err) {
    struct script_block alone = {
        .first = script->statement_count, .line = statement->line, .col = statement->col};
    if (!mem_grow(script->statement, &script->statement_cap, script->statement_count + 1, err) ||
        (!to_last_block && !add_block(script, &alone, err)))
        return false;
    script->statement[script->statement_count++] = *statement;
    script->block[script->block_count - 1].count++;
    return true;
}

const struct script_polygon *script_find_polygon(const struct script *script, const char *file) {
    const struct script_polygon *p = script->polygons;
    while (p && strcmp(p->file, file) != 0) p = p->next;
    return p;
}

const struct script_polygon *script_add_polygon(struct script *script, const char *file,
                                                struct polygon *polygon, struct err *err) {
    size_t size = strlen(file) + 1;
    struct script_polygon *p = mem_alloc(sizeof *p + size, 1, err);
    if (!p) {
        polygon_free(polygon);
        return NULL;
    }
    memcpy(p->file, file, size);
    p->polygon = *polygon;
    *polygon = (struct polygon){0};
    p->next = script->polygons;
    script->polygons = p;
    return p;
}
