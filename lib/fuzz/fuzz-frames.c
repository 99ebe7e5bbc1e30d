/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Lists of frames: two names each. */
#include "frames_io.h"
#include "fuzzing.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    struct fuzz_file f = fuzz_open(data, size);
    struct frames frames;
    struct err err = {0};
    if (frames_read(&frames, f.path, -1, &err)) {
        INVARIANT(frames.count > 0);
        for (size_t i = 0; i < frames.count; i++)
            INVARIANT(frames.frame[i].input[0] && frames.frame[i].picture[0]);
        frames_free(&frames);
    } else
        INVARIANT(err.kind == ERR_INPUT && err.message[0]);
    close(f.fd);
    return 0;
}
