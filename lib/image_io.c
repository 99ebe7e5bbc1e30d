/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "image_io.h"

#include "filemap.h"
#include "mem.h"
#include "oiio_load.h"
#include "out.h"
#include "png_io.h"
#include "pnm_io.h"

#include <inttypes.h>
#include <string.h>
#include <strings.h>
#include <unistd.h>

const char *const image_format_names[] = {"png", "tiff", "exr", "pnm", NULL};

static const char *const titles[] = {"PNG", "TIFF", "OpenEXR", "PNM", "JPEG"};

static const char *const sample_names[] = {"8 bits", "16 bits", "halves", "floats"};

/* As OpenImageIO calls them; NULL: not its business. */
static const char *const oiio_names[] = {NULL, "tiff", "openexr", NULL, "jpeg"};

/* --- Reading -------------------------------------------------------------------------------- */

static bool report_failure(const struct shim_oiio_report *r, int64_t page, struct err *err) {
    switch (r->status) {
    case SHIM_OIIO_MEMORY:
        return err_memory(err);
    case SHIM_OIIO_NO_PAGE:
        return err_set(err, ERR_INPUT, "there is no page %" PRId64, page);
    case SHIM_OIIO_SAMPLES:
        return err_set(err, ERR_INPUT, "expected samples of 8 or 16 bits, halves or floats, got %s",
                       r->message);
    case SHIM_OIIO_VOLUME:
        return err_set(err, ERR_INPUT, "expected a flat image, got a volume or deep pixels");
    default:
        return err_set(err, ERR_INPUT, "bad image: %s", r->message);
    }
}

static bool check_pixels(uint32_t width, uint32_t height, int64_t most, struct err *err) {
    uint64_t pixels = (uint64_t)width * height;
    return pixels <= (uint64_t)most ||
           err_set(err, ERR_INPUT,
                   "%" PRIu32 "x%" PRIu32 " pixels are more than %" PRId64 "; see --max-pixels",
                   width, height, most);
}

/* The decoder's view of the size, which of a later page is the only one. */
static bool check_spec(const struct shim_oiio_spec *s, int64_t most, struct err *err) {
    if (s->width < 1 || s->height < 1 || s->width > IMAGE_SIDE_MAX || s->height > IMAGE_SIDE_MAX)
        return err_set(err, ERR_INPUT, "expected sides of 1..%d pixels, got %" PRIu32 "x%" PRIu32,
                       IMAGE_SIDE_MAX, s->width, s->height);
    if (s->channels < 1 || s->channels > IMAGE_CHANNELS_MAX)
        return err_set(err, ERR_INPUT, "expected 1..%d channels, got %d", IMAGE_CHANNELS_MAX,
                       s->channels);
    if (s->tile_pixels > (uint64_t)most)
        return err_set(err, ERR_INPUT,
                       "tiles of %" PRIu64 " pixels are more than %" PRId64 "; see --max-pixels",
                       s->tile_pixels, most);
    return check_pixels(s->width, s->height, most, err);
}

static bool decode(struct image *image, const void *bytes, size_t length, const char *format,
                   const struct image_request *request, struct err *err) {
    const struct shim_oiio *oiio = oiio_load(err);
    struct shim_oiio_report report;
    struct shim_oiio_spec spec = {0};
    struct shim_oiio_reader *r;
    bool ok;
    if (!oiio) return false;
    r = oiio->open(bytes, length, format, (int)request->page - 1, &spec, &report);
    ok = r || report_failure(&report, request->page, err);
    *image = (struct image){.width = spec.width,
                            .height = spec.height,
                            .channels = spec.channels,
                            .alpha = spec.alpha,
                            .straight = spec.straight,
                            .sample = (enum image_sample)spec.sample,
                            .names = spec.names};
    ok = ok && check_spec(&spec, request->max_pixels, err) && image_allocate(image, err);
    if (ok && !oiio->pixels(r, image->value, &report))
        ok = report_failure(&report, request->page, err);
    oiio->close(r);
    return ok;
}

static bool read_mapped(struct image *image, const struct filemap *f,
                        const struct image_request *request, struct err *err) {
    struct image_header h;
    if (!image_header(&h, f->data, f->length, err)) return false;
    if (request->page > 1 && h.format != IMAGE_TIFF && h.format != IMAGE_OPENEXR)
        return report_failure(&(struct shim_oiio_report){.status = SHIM_OIIO_NO_PAGE},
                              request->page, err);
    if (request->page == 1 && !check_pixels(h.width, h.height, request->max_pixels, err))
        return false;
    if (oiio_names[h.format])
        return decode(image, f->data, f->length, oiio_names[h.format], request, err);
    image->width = h.width;
    image->height = h.height;
    return h.format == IMAGE_PNG ? png_read(image, f->data, f->length, err)
                                 : pnm_read(image, &h, f->data, f->length, err);
}

bool image_read(struct image *image, const struct image_request *request, struct err *err) {
    struct filemap f;
    bool ok = filemap_open(&f, request->path, err);
    *image = (struct image){0};
    if (ok && !read_mapped(image, &f, request, err)) ok = err_place(err, f.name, 0, 0);
    if (!ok) image_free(image);
    filemap_close(&f);
    return ok;
}

/* --- Writing -------------------------------------------------------------------------------- */

static bool format_of_name(const char *path, enum image_format *format, struct err *err) {
    static const struct {
        const char *extension;
        enum image_format format;
    } known[] = {{"png", IMAGE_PNG},     {"tif", IMAGE_TIFF}, {"tiff", IMAGE_TIFF},
                 {"exr", IMAGE_OPENEXR}, {"pgm", IMAGE_PNM},  {"ppm", IMAGE_PNM},
                 {"pnm", IMAGE_PNM}};
    const char *slash = strrchr(path, '/'), *dot = strrchr(slash ? slash : path, '.');
    for (size_t i = 0; dot && i < sizeof known / sizeof *known; i++)
        if (strcasecmp(dot + 1, known[i].extension) == 0) {
            *format = known[i].format;
            return true;
        }
    return err_set(err, ERR_USAGE,
                   "%s: expected a name in .png, .tif, .tiff, .exr, .pgm, .ppm or .pnm, or --to",
                   path);
}

bool image_output_format(int choice, const char *path, enum image_format *format, struct err *err) {
    bool to_stdout = !path || strcmp(path, "-") == 0;
    if (to_stdout && isatty(STDOUT_FILENO))
        return err_set(err, ERR_USAGE, "stdout is a terminal; write the picture to a file with -o");
    *format = choice < 0 ? IMAGE_PNG : (enum image_format)choice;
    return choice >= 0 || to_stdout || format_of_name(path, format, err);
}

bool image_fits(const struct image *image, enum image_format format, struct err *err) {
    bool whole = image->sample == IMAGE_U8 || image->sample == IMAGE_U16;
    const char *holds = NULL;
    if (format == IMAGE_OPENEXR ? whole : format != IMAGE_TIFF && !whole)
        holds = whole ? "halves or floats" : "samples of 8 or 16 bits";
    if (holds)
        return err_set(err, ERR_INPUT, "%s holds %s, the image has %s", titles[format], holds,
                       sample_names[image->sample]);
    if (format == IMAGE_PNG && image->channels > 4) holds = "1 to 4 channels";
    if (format == IMAGE_PNM && image->channels != 1 && image->channels != 3)
        holds = "1 or 3 channels";
    if (holds)
        return err_set(err, ERR_INPUT, "%s holds %s, the image has %d", titles[format], holds,
                       image->channels);
    return format != IMAGE_PNG ||
           image->alpha == (image->channels % 2 ? -1 : image->channels - 1) ||
           err_set(err, ERR_INPUT, "the last of 2 or 4 channels of PNG, and no other, is alpha");
}

static void to_out(void *context, const char *bytes, size_t length) {
    out_bytes(context, bytes, length);
}

static bool encode(struct out *out, const struct image *image, enum image_format format,
                   void *samples, struct err *err) {
    struct shim_oiio_spec spec = {.width = image->width,
                                  .height = image->height,
                                  .channels = image->channels,
                                  .alpha = image->alpha,
                                  .straight = image->straight,
                                  .sample = (enum shim_oiio_sample)image->sample,
                                  .names = image->names};
    const struct shim_oiio *oiio = oiio_load(err);
    struct shim_oiio_report report;
    if (!oiio) return false;
    return oiio->write(oiio_names[format], &spec, samples, to_out, out, &report) ||
           err_set(err, ERR_INPUT, "cannot write %s: %s", titles[format], report.message);
}

/* The samples of a file: the values themselves, or a copy of them. */
static void *round_samples(const struct image *image, size_t n, struct err *err) {
    void *samples = image->value;
    if (image->sample == IMAGE_U8 || image->sample == IMAGE_U16)
        samples = mem_alloc_unset(n, image_sample_size(image->sample), err);
    if (samples && image->sample == IMAGE_U8) image_round_u8(image->value, n, samples);
    if (samples && image->sample == IMAGE_U16) image_round_u16(image->value, n, samples);
    return samples;
}

bool image_write(const struct image *image, enum image_format format, const char *path,
                 struct err *err) {
    size_t n = (size_t)image->width * image->height * (size_t)image->channels;
    void *samples = NULL;
    struct out out;
    bool ok;
    if (!image_fits(image, format, err) || !out_open(&out, path, err)) return false;
    samples = round_samples(image, n, err);
    ok = samples != NULL;
    if (ok && format == IMAGE_PNM)
        pnm_write(&out, image, samples);
    else if (ok)
        ok = format == IMAGE_PNG ? png_write(&out, image, samples, err)
                                 : encode(&out, image, format, samples, err);
    if (ok)
        ok = out_close(&out, err);
    else
        out_discard(&out);
    if (samples != image->value) free(samples);
    return ok;
}
