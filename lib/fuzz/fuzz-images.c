/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Headers of images: sizes are in range. Pixels of PNM: values are in range. */
#include "fuzzing.h"
#include "pnm_io.h"

static void read_pixels(const struct image_header *h, const uint8_t *data, size_t size) {
    struct image image = {.width = h->width, .height = h->height};
    struct err err = {0};
    bool ok = pnm_read(&image, h, data, size, &err);
    for (size_t i = 0; ok && i < (size_t)image.width * image.height * (size_t)image.channels; i++)
        INVARIANT(image.value[i] >= 0 && image.value[i] <= image_full(image.sample));
    image_free(&image);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    struct image_header h;
    struct err err = {0};
    bool ok = image_header(&h, data, size, &err);
    INVARIANT(ok ? h.width >= 1 && h.width <= IMAGE_SIDE_MAX && h.height >= 1 &&
                       h.height <= IMAGE_SIDE_MAX
                 : err.kind == ERR_INPUT && err.message[0]);
    if (ok && h.format == IMAGE_PNM && (uint64_t)h.width * h.height < 1 << 20)
        read_pixels(&h, data, size);
    return 0;
}
