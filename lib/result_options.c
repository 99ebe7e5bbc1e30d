/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "result_options.h"

#include <stdlib.h>

bool result_option(struct result_options *o, const struct cli *cli, int key, struct err *err) {
    if (key == RESULT_DIGITS) return cli_int(cli, 1, 17, &o->digits, err);
    o->output = cli->value;
    return true;
}

bool result_write(const struct result_options *o, const struct cli *cli,
                  const struct grid_file *file, struct err *err) {
    char *command = cli_history(cli, err);
    struct out out;
    bool ok = command && out_open(&out, o->output, err);
    if (ok) {
        grid_write(&out, file, command, (int)o->digits);
        ok = out_close(&out, err);
    }
    free(command);
    return ok;
}
