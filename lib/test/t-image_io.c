/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Oracles: images come back bit for bit from every format that holds them; files that are written
 * here by the formats' specifications are read as the numbers that were put in. */
#include "image_io.h"

#include "testing.h"

#include <fcntl.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

static char folder[40];

static int enter_folder(void **unused) {
    (void)unused;
    strcpy(folder, "/tmp/supple-image-XXXXXX");
    return mkdtemp(folder) && chdir(folder) == 0 ? 0 : -1;
}

static int leave_folder(void **unused) {
    (void)unused;
    (void)unlink("file");
    (void)unlink("again");
    (void)unlink("messages");
    return chdir("/") == 0 && rmdir(folder) == 0 ? 0 : -1;
}

static const struct image_request whole = {
    .path = "file", .page = 1, .max_pixels = IMAGE_PIXELS_DEFAULT};

static bool read_page(struct image *image, int64_t page, struct err *err) {
    struct image_request request = whole;
    request.page = page;
    *err = (struct err){0};
    return image_read(image, &request, err);
}

/* --- There and back ------------------------------------------------------------------------- */

/* Any value that the type holds, with infinities and NaN where there are some. */
static float random_value(enum image_sample sample, uint64_t *state) {
    uint32_t bits = (uint32_t)random_bits(state);
    float x;
    if (sample == IMAGE_U8) return (float)(bits & UINT8_MAX);
    if (sample == IMAGE_U16) return (float)(bits & UINT16_MAX);
    if (sample == IMAGE_HALF) /* 11 bits, subnormals included */
        return ldexpf((float)((int)(bits & 4095) - 2048), (int)(bits >> 16) % 29 - 24);
    memcpy(&x, &bits, sizeof x);
    return x;
}

static size_t count(const struct image *image) {
    return (size_t)image->width * image->height * (size_t)image->channels;
}

static bool can_hold(const struct image *image, enum image_format format) {
    bool whole_numbers = image->sample <= IMAGE_U16, last = image->alpha == image->channels - 1;
    if (format == IMAGE_PNG)
        return whole_numbers && image->channels <= 4 &&
               (image->channels % 2 ? image->alpha < 0 : last);
    if (format == IMAGE_PNM) return whole_numbers && (image->channels == 1 || image->channels == 3);
    return format == IMAGE_TIFF || !whole_numbers;
}

static void make_image(struct image *image, enum image_format format, uint64_t *state) {
    struct err err = {0};
    do {
        int channels = (int)random_in(state, 1, random_in(state, 0, 3) ? 4 : IMAGE_CHANNELS_MAX);
        *image = (struct image){.width = (uint32_t)random_in(state, 1, 40),
                                .height = (uint32_t)random_in(state, 1, 90),
                                .channels = channels,
                                .alpha = channels == 4 || channels == 2 ? channels - 1 : -1,
                                .sample = (enum image_sample)random_in(state, 0, 3)};
        image->straight = image->alpha >= 0 &&
                          (format == IMAGE_PNG || (format == IMAGE_TIFF && random_in(state, 0, 1)));
    } while (!can_hold(image, format));
    assert_true(image_allocate(image, &err));
    for (size_t i = 0; i < count(image); i++) image->value[i] = random_value(image->sample, state);
}

static void check_same(uint64_t seed, const struct image *a, const struct image *b) {

    check_seed(seed, a->width == b->width && a->height == b->height);
    check_seed(seed, a->channels == b->channels && a->sample == b->sample);
    check_seed(seed, a->alpha == b->alpha && a->straight == b->straight);
    check_seed(seed, memcmp(a->value, b->value, count(a) * sizeof *a->value) == 0);
}

static void *slurp(const char *path, size_t *n) {
    struct stat st;
    FILE *file = fopen(path, "rb");
    char *bytes;
    assert_true(file && fstat(fileno(file), &st) == 0);
    bytes = malloc((size_t)st.st_size + 1);
    *n = fread(bytes, 1, (size_t)st.st_size + 1, file);
    fclose(file);
    return bytes;
}

static void spill(const void *bytes, size_t n) {
    FILE *file = fopen("file", "wb");
    assert_true(file && fwrite(bytes, 1, n, file) == n && fclose(file) == 0);
}

static void check_same_bytes(uint64_t seed) {
    size_t n, m;
    char *a = slurp("file", &n), *b = slurp("again", &m);
    check_seed(seed, n == m && memcmp(a, b, n) == 0);
    free(a);
    free(b);
}

static void round_trips(void **unused) {
    static const enum image_format formats[] = {IMAGE_PNG, IMAGE_TIFF, IMAGE_OPENEXR, IMAGE_PNM};
    for (int i = 0; i < test_count(400); i++) {
        uint64_t seed = 0x1a6e0000 + (uint64_t)i, state = seed;
        enum image_format format = formats[i % 4];
        struct image image, back, third;
        struct err err = {0};
        make_image(&image, format, &state);
        assert_true(image_write(&image, format, "file", &err));
        check_seed(seed, read_page(&back, 1, &err));
        check_same(seed, &image, &back);
        assert_true(image_write(&back, format, "again", &err)); /* names, too, must come back */
        check_same_bytes(seed);
        assert_true(image_allocate_like(&third, &back, 3, 5, &err));
        check_seed(seed, third.width == 3 && third.height == 5 && third.value != back.value);
        image_free(&image);
        image_free(&back);
        image_free(&third);
    }
    (void)unused;
}

static void names_are_kept(void **unused) {
    char *names = calloc(40, 1);
    struct image image = {.width = 2,
                          .height = 2,
                          .channels = 3,
                          .alpha = -1,
                          .sample = IMAGE_HALF,
                          .names = names},
                 back;
    struct err err = {0};
    memcpy(names, "zz\0left.X\0right.X", 18);
    assert_true(image_allocate(&image, &err));
    for (int i = 0; i < 12; i++) image.value[i] = (float)i;
    assert_true(image_write(&image, IMAGE_OPENEXR, "file", &err) && read_page(&back, 1, &err));
    assert_memory_equal(back.names, names, 18);
    for (int i = 0; i < 12; i++) assert_true(back.value[i] == (float)i);
    image_free(&image);
    image_free(&back);
    (void)unused;
}

static void values_are_rounded(void **unused) {
    const float value[] = {0.49999997F, 0.5F,      254.5F, 254.49998F, 255.5F,  -1,
                           INFINITY,    -INFINITY, NAN,    65534.496F, 65534.5F};
    const uint8_t want8[] = {0, 1, 255, 254, 255, 0, 255, 0, 0, 255, 255};
    const uint16_t want16[] = {0, 1, 255, 254, 256, 0, 65535, 0, 0, 65534, 65535};
    uint8_t got8[11];
    uint16_t got16[11];
    image_round_u8(value, 11, got8);
    image_round_u16(value, 11, got16);
    assert_memory_equal(got8, want8, sizeof want8);
    assert_memory_equal(got16, want16, sizeof want16);
    (void)unused;
}

static void misfits(void **unused) {
    static const struct {
        enum image_format format;
        enum image_sample sample;
        int channels, alpha;
        const char *message;
    } cases[] = {
        {IMAGE_PNG, IMAGE_HALF, 3, -1, "PNG holds samples of 8 or 16 bits, the image has halves"},
        {IMAGE_PNM, IMAGE_FLOAT, 1, -1, "PNM holds samples of 8 or 16 bits, the image has floats"},
        {IMAGE_OPENEXR, IMAGE_U8, 1, -1, "OpenEXR holds halves or floats, the image has 8 bits"},
        {IMAGE_OPENEXR, IMAGE_U16, 1, -1, "OpenEXR holds halves or floats, the image has 16 bits"},
        {IMAGE_PNG, IMAGE_U8, 5, -1, "PNG holds 1 to 4 channels, the image has 5"},
        {IMAGE_PNG, IMAGE_U8, 2, -1, "the last of 2 or 4 channels of PNG, and no other, is alpha"},
        {IMAGE_PNG, IMAGE_U8, 3, 2, "the last of 2 or 4 channels of PNG, and no other, is alpha"},
        {IMAGE_PNM, IMAGE_U8, 4, 3, "PNM holds 1 or 3 channels, the image has 4"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct image image = {.width = 1,
                              .height = 1,
                              .channels = cases[i].channels,
                              .alpha = cases[i].alpha,
                              .sample = cases[i].sample};
        struct err err = {0};
        assert_false(image_write(&image, cases[i].format, "file", &err));
        assert_string_equal(err.message, cases[i].message);
        assert_int_equal(err.kind, ERR_INPUT);
    }
    (void)unused;
}

/* --- Files written here --------------------------------------------------------------------- */

struct file {
    unsigned char byte[1 << 16];
    size_t length;
};

static void put(struct file *f, const void *bytes, size_t n) {
    assert_true(f->length + n <= sizeof f->byte);
    memcpy(f->byte + f->length, bytes, n);
    f->length += n;
}

static void put_number(struct file *f, uint64_t value, int n, bool big) {
    unsigned char byte[8];
    for (int i = 0; i < n; i++) byte[i] = (unsigned char)(value >> 8 * (big ? n - 1 - i : i));
    put(f, byte, (size_t)n);
}

/* Sample number i of all test files, of so many bytes. */
static uint64_t sample(size_t i, int bytes) {
    return (i * 2654435761U >> 7) & UINT64_MAX >> (64 - 8 * bytes);
}

static void chunk(struct file *f, const char *type, const void *data, size_t n) {
    size_t start = f->length + 4;
    put_number(f, n, 4, true);
    put(f, type, 4);
    put(f, data, n);
    put_number(f, crc32(0, f->byte + start, (unsigned)(n + 4)), 4, true);
}

static void write_png(struct file *f, int width, int height, int channels, int bytes) {
    static const int colour[] = {0, 0, 4, 2, 6};
    struct file ihdr = {.length = 0}, raw = {.length = 0}, packed = {.length = 0};
    uLongf n = sizeof packed.byte;
    put_number(&ihdr, (uint64_t)width, 4, true);
    put_number(&ihdr, (uint64_t)height, 4, true);
    put_number(&ihdr, (uint64_t)(8 * bytes), 1, true);
    put_number(&ihdr, (uint64_t)colour[channels], 1, true);
    put_number(&ihdr, 0, 3, true);
    for (size_t row = 0, i = 0; row < (size_t)height; row++) {
        put_number(&raw, 0, 1, true); /* no filter */
        for (int k = 0; k < width * channels; k++, i++)
            put_number(&raw, sample(i, bytes), bytes, true);
    }
    assert_int_equal(compress(packed.byte, &n, raw.byte, raw.length), Z_OK);
    put(f, "\x89PNG\r\n\x1a\n", 8);
    chunk(f, "IHDR", ihdr.byte, ihdr.length);
    chunk(f, "iCCP", "profile\0\0rubbish", 16); /* what is not pixels is not looked at */
    chunk(f, "IDAT", packed.byte, n / 2);
    chunk(f, "IDAT", packed.byte + n / 2, n - n / 2);
    chunk(f, "zTXt", "rubbish", 7);
    chunk(f, "IEND", "", 0);
}

static void entry(struct file *f, int tag, int type, uint64_t value, bool big) {
    int n = type == 3 ? 2 : 4;
    put_number(f, (uint64_t)tag, 2, big);
    put_number(f, (uint64_t)type, 2, big);
    put_number(f, 1, 4, big);
    put_number(f, value, n, big);
    put_number(f, 0, 4 - n, big);
}

/* A grey page: a directory and its one strip; `next` is where the next directory's offset goes. */
static size_t put_page(struct file *f, int width, int height, int bytes, int kind, bool big) {
    size_t pixels, next;
    put_number(f, 10, 2, big);
    entry(f, 256, 3, (uint64_t)width, big);
    entry(f, 257, 3, (uint64_t)height, big);
    entry(f, 258, 3, (uint64_t)(8 * bytes), big);
    entry(f, 259, 3, 1, big);
    entry(f, 262, 3, 1, big);
    entry(f, 273, 4, f->length + 12 * 5 + 4, big);
    entry(f, 277, 3, 1, big);
    entry(f, 278, 3, (uint64_t)height, big);
    entry(f, 279, 4, (uint64_t)(width * height * bytes), big);
    entry(f, 339, 3, (uint64_t)kind, big);
    next = f->length;
    put_number(f, 0, 4, big);
    pixels = (size_t)(width * height);
    for (size_t i = 0; i < pixels; i++) put_number(f, sample(i, bytes), bytes, big);
    return next;
}

static void write_tiff(struct file *f, int pages, int bytes, int kind, bool big) {
    size_t next = 4;
    put(f, big ? "MM" : "II", 2);
    put_number(f, 42, 2, big);
    put_number(f, 0, 4, big);
    for (int page = 1; page <= pages; page++) {
        size_t end = f->length;
        f->length = next;
        put_number(f, end, 4, big);
        f->length = end;
        next = put_page(f, 3 + page, 2, bytes, kind, big);
    }
}

static void check_samples(const struct image *image, int width, int height, int channels,
                          int bytes) {
    assert_int_equal(image->width, width);
    assert_int_equal(image->height, height);
    assert_int_equal(image->channels, channels);
    assert_int_equal(image->sample, bytes == 1 ? IMAGE_U8 : IMAGE_U16);
    for (size_t i = 0; i < count(image); i++)
        assert_true(image->value[i] == (float)sample(i, bytes));
}

static void pngs(void **unused) {
    for (int channels = 1; channels <= 4; channels++)
        for (int bytes = 1; bytes <= 2; bytes++) {
            struct file f = {.length = 0};
            struct image image;
            struct err err;
            write_png(&f, 7, 5, channels, bytes);
            spill(f.byte, f.length);
            assert_true(read_page(&image, 1, &err));
            check_samples(&image, 7, 5, channels, bytes);
            assert_int_equal(image.alpha, channels % 2 ? -1 : channels - 1);
            image_free(&image);
        }
    (void)unused;
}

static void pages(void **unused) {
    for (int i = 0; i < 8; i++) {
        int bytes = i % 2 + 1, count_of = i / 4 * 2 + 1;
        struct file f = {.length = 0};
        struct image image;
        struct err err;
        write_tiff(&f, count_of, bytes, 1, i / 2 % 2);
        spill(f.byte, f.length);
        for (int page = 1; page <= count_of; page++) {
            assert_true(read_page(&image, page, &err));
            check_samples(&image, 3 + page, 2, 1, bytes);
            image_free(&image);
        }
        assert_false(read_page(&image, count_of + 1, &err));
        assert_string_equal(err.message,
                            count_of == 1 ? "there is no page 2" : "there is no page 4");
        assert_string_equal(err.file, "file");
    }
    (void)unused;
}

static void other_samples(void **unused) {
    static const struct {
        int bytes, kind; /* 1 unsigned, 2 signed, 3 float */
        const char *name;
    } cases[] = {{4, 1, "uint"}, {1, 2, "int8"}, {2, 2, "int16"}, {4, 2, "int"}, {8, 3, "double"}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct file f = {.length = 0};
        struct image image;
        struct err err;
        char want[100];
        write_tiff(&f, 1, cases[i].bytes, cases[i].kind, false);
        spill(f.byte, f.length);
        assert_false(read_page(&image, 1, &err));
        snprintf(want, sizeof want, "expected samples of 8 or 16 bits, halves or floats, got %s",
                 cases[i].name);
        assert_string_equal(err.message, want);
    }
    (void)unused;
}

/* Bytes as a string literal, without its NUL. */
#define BYTES(literal) literal, sizeof(literal) - 1

static const struct {
    const char *bytes;
    size_t length;
    const char *wrong; /* NULL: the values are right */
    int channels, n, value[8];
} pnms[] = {
    {BYTES("P1 3 2\n1 0 1#x\n0 0 1"), NULL, 1, 6, {0, 255, 0, 255, 255, 0}},
    {BYTES("P1\n3 2\n101001"), NULL, 1, 6, {0, 255, 0, 255, 255, 0}},
    {BYTES("P2 3 1 255\n7 # 8\n 9\r\n255 and more"), NULL, 1, 3, {7, 9, 255}},
    {BYTES("P2 2 1 100\n50 100"), NULL, 1, 2, {128, 255}},
    {BYTES("P2 2 1 1000\n500 001"), NULL, 1, 2, {32768, 66}},
    {BYTES("P3 1 2 65535\n1 2 3 4 5 65535"), NULL, 3, 6, {1, 2, 3, 4, 5, 65535}},
    {BYTES("P4 9 1 \xaa\x80"), NULL, 1, 9, {0, 255, 0, 255, 0, 255, 0, 255}},
    {BYTES("P4 8 1\n\x0f"), NULL, 1, 8, {255, 255, 255, 255, 0, 0, 0, 0}},
    {BYTES("P4 1 2\n\x80\x7f"), NULL, 1, 2, {0, 255}},
    {BYTES("P5 2 2 255\n\n #\0"), NULL, 1, 4, {'\n', ' ', '#', 0}},
    {BYTES("P5 1 2 256\n\1\0\0\1"), NULL, 1, 2, {65535, 256}},
    {BYTES("P6 1 1 65535\n\1\2\3\4\5\6"), NULL, 3, 3, {258, 772, 1286}},
    {BYTES("P1 3 2\n1 0 1 0 0"), "the pixels end early or are damaged", 0, 0, {0}},
    {BYTES("P1 3 1\n1 0 2"), "a value is larger than the largest", 0, 0, {0}},
    {BYTES("P2 2 1 255\n1 -2"), "the pixels end early or are damaged", 0, 0, {0}},
    {BYTES("P2 2 1 255\n1 256"), "a value is larger than the largest", 0, 0, {0}},
    {BYTES("P2 1 1 65535\n99999999999999999999"), "a value is larger than the largest", 0, 0, {0}},
    {BYTES("P4 9 1 \xaa"), "the pixels end early or are damaged", 0, 0, {0}},
    {BYTES("P5 2 1 100 \1\x65"), "a value is larger than the largest", 0, 0, {0}},
    {BYTES("P6 1 1 65535\n\1\2\3\4\5"), "the pixels end early or are damaged", 0, 0, {0}},
};

static void pnm_values(void **unused) {
    for (size_t i = 0; i < sizeof pnms / sizeof *pnms; i++) {
        char want[100];
        struct image image;
        struct err err;
        bool ok;
        spill(pnms[i].bytes, pnms[i].length);
        ok = read_page(&image, 1, &err);
        check_seed(i, ok == !pnms[i].wrong);
        if (!ok) {
            snprintf(want, sizeof want, "bad PNM image: %s", pnms[i].wrong);
            assert_string_equal(err.message, want);
            continue;
        }
        check_seed(i, image.channels == pnms[i].channels && image.alpha == -1);
        check_seed(i, count(&image) == (size_t)pnms[i].n);
        for (int k = 0; k < pnms[i].n && k < 8; k++)
            check_seed(i, image.value[k] == (float)pnms[i].value[k]);
        image_free(&image);
    }
    (void)unused;
}

/* --- What must not pass --------------------------------------------------------------------- */

static void limits(void **unused) {
    struct image_request request = whole;
    struct file f = {.length = 0};
    struct image image;
    struct err err = {0};
    write_png(&f, 7, 5, 1, 1);
    spill(f.byte, f.length);
    request.max_pixels = 35;
    assert_true(image_read(&image, &request, &err));
    image_free(&image);
    request.max_pixels = 34;
    assert_false(image_read(&image, &request, &err));
    assert_string_equal(err.message, "7x5 pixels are more than 34; see --max-pixels");
    f.length = 0; /* of a later page, the decoder tells it */
    write_tiff(&f, 9, 1, 1, false);
    spill(f.byte, f.length);
    request.page = 9;
    request.max_pixels = 23;
    assert_false(image_read(&image, &request, &err));
    assert_string_equal(err.message, "12x2 pixels are more than 23; see --max-pixels");
    (void)unused;
}

/* An image of 16,000 x 16,000 pixels that are not there is an error before they are made room for
 * in memory. */
static void promises(void **unused) {
    struct image_request request = whole;
    struct image image;
    struct err err = {0};
    request.max_pixels = (int64_t)1 << 30;
    for (int i = 0; i < 2; i++) {
        struct file f = {.length = 0};
        if (i == 0)
            put(&f, "P6 16000 16000 65535\nabc", 24);
        else {
            write_png(&f, 7, 5, 4, 2);
            f.byte[18] = f.byte[22] = 0x40; /* + 2^14 a side */
            f.length = 29;
            put_number(&f, crc32(0, f.byte + 12, 17), 4, true);
            chunk(&f, "IDAT", "x\x9c\3\0\0\0\0\1", 8);
            chunk(&f, "IEND", "", 0);
        }
        spill(f.byte, f.length);
        assert_false(image_read(&image, &request, &err));
        assert_int_equal(err.kind, ERR_INPUT);
    }
    (void)unused;
}

/* Damages a file that is good, by cuts and by changed bytes: an image or an error, never a word on
 * stderr. */
static void damage(void **unused) {
    static const enum image_format formats[] = {IMAGE_PNG, IMAGE_TIFF, IMAGE_OPENEXR, IMAGE_PNM};
    int saved = dup(STDERR_FILENO), words = open("messages", O_RDWR | O_CREAT | O_TRUNC, 0600);
    struct stat st;
    assert_true(dup2(words, STDERR_FILENO) >= 0);
    for (int i = 0; i < test_count(2000); i++) {
        uint64_t state = 0xda3a6e0000 + (uint64_t)i;
        struct image image;
        struct err err = {0};
        unsigned char *bytes;
        size_t n;
        make_image(&image, formats[i % 4], &state);
        assert_true(image_write(&image, formats[i % 4], "file", &err));
        image_free(&image);
        bytes = slurp("file", &n);
        if (i % 8 < 4) n = (size_t)random_in(&state, 0, (int64_t)n - 1);
        for (int k = 0; i % 8 >= 4 && k < 3; k++)
            bytes[random_in(&state, 0, random_in(&state, 0, 1) && n > 99 ? 99 : (int64_t)n - 1)] =
                (unsigned char)random_bits(&state);
        spill(bytes, n);
        free(bytes);
        if (read_page(&image, random_in(&state, 0, 9) ? 1 : 2, &err))
            image_free(&image);
        else
            assert_true(err.kind == ERR_INPUT && err.message[0]);
    }
    assert_true(fstat(STDERR_FILENO, &st) == 0 && dup2(saved, STDERR_FILENO) >= 0);
    assert_int_equal(st.st_size, 0);
    close(saved);
    close(words);
    (void)unused;
}

/* Cut anywhere, a file that has all its pixels is refused. */
static void cuts(void **unused) {
    static const enum image_format formats[] = {IMAGE_PNG, IMAGE_TIFF, IMAGE_OPENEXR, IMAGE_PNM};
    for (int i = 0; i < 4; i++) {
        uint64_t state = 7;
        struct image image;
        struct err err = {0};
        unsigned char *bytes;
        size_t n;
        make_image(&image, formats[i], &state);
        assert_true(image_write(&image, formats[i], "file", &err));
        image_free(&image);
        bytes = slurp("file", &n);
        for (size_t cut = n; cut-- > 0;) {
            if (cut > 400 && cut + 400 < n && cut % 97) continue;
            spill(bytes, cut);
            check_seed(cut, !read_page(&image, 1, &err));
        }
        free(bytes);
    }
    (void)unused;
}

static void formats_of_names(void **unused) {
    static const struct {
        const char *path;
        int choice, format; /* -1: refused */
    } cases[] = {{"a.png", -1, IMAGE_PNG},
                 {"a.TIF", -1, IMAGE_TIFF},
                 {"d.exr/a.tiff", -1, IMAGE_TIFF},
                 {"a.exr", -1, IMAGE_OPENEXR},
                 {"a.pgm", -1, IMAGE_PNM},
                 {"a.ppm", -1, IMAGE_PNM},
                 {"a.pnm", -1, IMAGE_PNM},
                 {"a.jpg", -1, -1},
                 {"png", -1, -1},
                 {"d.png/a", -1, -1},
                 {"a.jpg", IMAGE_PNG, IMAGE_PNG},
                 {"a.png", IMAGE_PNM, IMAGE_PNM}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        enum image_format format;
        struct err err = {0};
        bool ok = image_output_format(cases[i].choice, cases[i].path, &format, &err);
        assert_int_equal(ok ? (int)format : -1, cases[i].format);
        assert_true(ok || err.kind == ERR_USAGE);
    }
    (void)unused;
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(round_trips),
        cmocka_unit_test(names_are_kept),
        cmocka_unit_test(misfits),
        cmocka_unit_test(values_are_rounded),
        cmocka_unit_test(pnm_values),
        cmocka_unit_test(pngs),
        cmocka_unit_test(pages),
        cmocka_unit_test(other_samples),
        cmocka_unit_test(limits),
        cmocka_unit_test(promises),
        cmocka_unit_test(damage),
        cmocka_unit_test(cuts),
        cmocka_unit_test(formats_of_names),
    };
    return cmocka_run_group_tests(tests, enter_folder, leave_folder);
}
