/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Headers of images: sizes are in range. */
#include "fuzzing.h"
#include "image_header_io.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    struct image_header h;
    struct err err = {0};
    if (image_header(&h, data, size, &err))
        INVARIANT(h.width >= 1 && h.width <= IMAGE_SIDE_MAX && h.height >= 1 &&
                  h.height <= IMAGE_SIDE_MAX);
    else
        INVARIANT(err.kind == ERR_INPUT && err.message[0]);
    return 0;
}
