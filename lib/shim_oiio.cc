// SPDX-License-Identifier: GPL-3.0-or-later
#include "shim_oiio.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <memory>
#include <new>
#include <string>
#include <type_traits>
#include <unistd.h>
#include <vector>

struct shim_oiio_reader {
    OIIO::Filesystem::IOMemReader memory;
    std::unique_ptr<OIIO::ImageInput> input;
    OIIO::ImageSpec spec;
    int page;

    shim_oiio_reader(const void *bytes, size_t length, int page_)
        : memory(const_cast<void *>(bytes), length), page(page_) {}
};

namespace {

// TIFF and OpenEXR would carry the time of writing.
constexpr const char *EPOCH = "1970:01:01 00:00:00";

constexpr size_t BLOCK = 1 << 21; // bytes decoded at a time, about

struct Stop {
    enum shim_oiio_status status;
    std::string message;
};

[[noreturn]] void stop(enum shim_oiio_status status, std::string message = "") {
    throw Stop{status, std::move(message)};
}

// Turns stderr to /dev/null while it lives.
class Quiet {
  public:
    Quiet() : saved(fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, 3)) {
        int null = saved < 0 ? -1 : open("/dev/null", O_WRONLY | O_CLOEXEC);
        if (null < 0) return;
        dup2(null, STDERR_FILENO);
        close(null);
    }
    ~Quiet() {
        if (saved < 0) return;
        dup2(saved, STDERR_FILENO);
        close(saved);
    }
    Quiet(const Quiet &) = delete;
    Quiet &operator=(const Quiet &) = delete;

  private:
    int saved;
};

bool failed(shim_oiio_report *report, enum shim_oiio_status status, const std::string &message) {
    size_t end = std::min(message.find('\n'), message.size());
    report->status = status;
    std::snprintf(report->message, sizeof report->message, "%.*s", static_cast<int>(end),
                  message.c_str());
    return false;
}

// The border: runs the work and turns whatever it throws into a report.
template <class Work> bool guarded(shim_oiio_report *report, Work work) {
    *report = shim_oiio_report{};
    try {
        Quiet quiet;
        OIIO::attribute("threads", 1);
        OIIO::attribute("exr_threads", -1);
        OIIO::attribute("tiff:half", 1);
        work();
        return true;
    } catch (const Stop &s) {
        return failed(report, s.status, s.message);
    } catch (const std::bad_alloc &) {
        return failed(report, SHIM_OIIO_MEMORY, "out of memory");
    } catch (const std::exception &e) {
        return failed(report, SHIM_OIIO_FAILED, e.what());
    } catch (...) {
        return failed(report, SHIM_OIIO_FAILED, "unknown exception");
    }
}

// Also forgets what the library itself keeps to complain about.
[[noreturn]] void stop_with(std::string message) {
    if (OIIO::has_error()) {
        std::string more = OIIO::geterror();
        if (message.empty()) message = more;
    }
    stop(SHIM_OIIO_FAILED, message.empty() ? "the pixels end early or are damaged" : message);
}

shim_oiio_sample sample_of(const OIIO::ImageSpec &spec) {
    for (OIIO::TypeDesc t : spec.channelformats)
        if (t != OIIO::TypeDesc::HALF && t != OIIO::TypeDesc::FLOAT)
            stop(SHIM_OIIO_SAMPLES, t.c_str());
    switch (spec.format.basetype) {
    case OIIO::TypeDesc::UINT8:
        return SHIM_OIIO_U8;
    case OIIO::TypeDesc::UINT16:
        return SHIM_OIIO_U16;
    case OIIO::TypeDesc::HALF:
        return SHIM_OIIO_HALF;
    case OIIO::TypeDesc::FLOAT:
        return SHIM_OIIO_FLOAT;
    default:
        stop(SHIM_OIIO_SAMPLES, spec.format.c_str());
    }
}

OIIO::TypeDesc type_of(shim_oiio_sample sample) {
    return sample == SHIM_OIIO_U8     ? OIIO::TypeDesc::UINT8
           : sample == SHIM_OIIO_U16  ? OIIO::TypeDesc::UINT16
           : sample == SHIM_OIIO_HALF ? OIIO::TypeDesc::HALF
                                      : OIIO::TypeDesc::FLOAT;
}

char *joined_names(const OIIO::ImageSpec &spec) {
    std::string all;
    for (const std::string &name : spec.channelnames) all += name.substr(0, name.find('\0')) + '\0';
    char *names = static_cast<char *>(std::malloc(all.size()));
    if (!names) throw std::bad_alloc();
    std::memcpy(names, all.data(), all.size());
    return names;
}

void open_image(shim_oiio_reader &r, const char *format, shim_oiio_spec &spec) {
    OIIO::ImageSpec wish;
    wish.attribute("oiio:UnassociatedAlpha", 1);
    r.input = OIIO::ImageInput::create(format, false, &wish, &r.memory);
    if (!r.input || !r.input->set_ioproxy(&r.memory)) stop_with("");
    if (!r.input->open("image", r.spec, wish)) stop_with(r.input->geterror());
    if (r.page > 0 && !r.input->seek_subimage(r.page, 0)) stop(SHIM_OIIO_NO_PAGE);
    r.spec = r.input->spec();
    if (r.spec.deep || r.spec.depth > 1) stop(SHIM_OIIO_VOLUME);
    spec = shim_oiio_spec{};
    spec.width = static_cast<uint32_t>(r.spec.width);
    spec.height = static_cast<uint32_t>(r.spec.height);
    spec.channels = r.spec.nchannels;
    spec.alpha = r.spec.alpha_channel;
    spec.straight = spec.alpha >= 0 && r.spec.get_int_attribute("oiio:UnassociatedAlpha") != 0;
    spec.sample = sample_of(r.spec);
    spec.tile_pixels = static_cast<uint64_t>(r.spec.tile_width) *
                       static_cast<uint64_t>(std::max(r.spec.tile_height, 1));
    spec.names = joined_names(r.spec);
}

// Decodes rows [begin, end); `samples` have the type T.
template <class T> void decode(shim_oiio_reader &r, int begin, int end, T *samples) {
    const OIIO::ImageSpec &s = r.spec;
    OIIO::TypeDesc type = OIIO::BaseTypeFromC<T>::value;
    bool ok = s.tile_width > 0
                  ? r.input->read_tiles(r.page, 0, s.x, s.x + s.width, s.y + begin, s.y + end, s.z,
                                        s.z + 1, 0, s.nchannels, type, samples)
                  : r.input->read_scanlines(r.page, 0, s.y + begin, s.y + end, s.z, 0, s.nchannels,
                                            type, samples);
    if (!ok || r.input->has_error()) stop_with(r.input->geterror());
}

// Whole rows of tiles, or of what OpenEXR compresses together.
int block_rows(const OIIO::ImageSpec &s) {
    int unit = s.tile_width > 0 ? s.tile_height : 64;
    size_t row = std::max<size_t>(s.scanline_bytes(true), 1);
    return std::max(static_cast<int>(std::min<size_t>(BLOCK / row, 1 << 20)) / unit, 1) * unit;
}

template <class T> void decode_all(shim_oiio_reader &r, float *value) {
    size_t row = static_cast<size_t>(r.spec.width) * static_cast<size_t>(r.spec.nchannels);
    int step = block_rows(r.spec);
    std::vector<T> samples;
    for (int begin = 0, end; begin < r.spec.height; begin = end) {
        end = std::min(r.spec.height, begin + step);
        if constexpr (std::is_same_v<T, float>) {
            decode(r, begin, end, value + row * static_cast<size_t>(begin));
        } else {
            samples.resize(row * static_cast<size_t>(end - begin));
            decode(r, begin, end, samples.data());
            value = std::copy(samples.begin(), samples.end(), value);
        }
    }
}

// Without names: those that OpenImageIO gives Y, RGB and RGBA; else "A" and numbers, of two digits,
// since OpenEXR sorts.
void name_channels(OIIO::ImageSpec &s, const shim_oiio_spec &spec) {
    bool usual =
        spec.channels != 2 && spec.channels <= 4 && spec.alpha == (spec.channels == 4 ? 3 : -1);
    const char *name = spec.names;
    for (int c = 0; c < spec.channels && (name || !usual); c++) {
        std::string number{'C', static_cast<char>('0' + c / 10), static_cast<char>('0' + c % 10)};
        if (spec.channels == 2 && spec.alpha == 1) number = "Y";
        s.channelnames[static_cast<size_t>(c)] = name ? name : c == spec.alpha ? "A" : number;
        if (name) name += std::strlen(name) + 1;
    }
}

void encode(OIIO::Filesystem::IOVecOutput &memory, const char *format, const shim_oiio_spec &spec,
            const void *samples) {
    OIIO::ImageSpec s(static_cast<int>(spec.width), static_cast<int>(spec.height), spec.channels,
                      type_of(spec.sample));
    OIIO::TypeDesc type = spec.sample == SHIM_OIIO_HALF ? OIIO::TypeDesc::FLOAT : s.format;
    std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(format);
    if (!output || !output->set_ioproxy(&memory)) stop_with("");
    name_channels(s, spec);
    s.alpha_channel = spec.alpha;
    s.z_channel = -1;
    if (spec.alpha >= 0 && spec.straight) s.attribute("oiio:UnassociatedAlpha", 1);
    s.attribute("DateTime", EPOCH);
    if (std::strcmp(format, "tiff") == 0) s.attribute("compression", "none");
    if (!output->open("image", s) || !output->write_image(type, samples) || !output->close())
        stop_with(output->geterror());
}

void close_reader(shim_oiio_reader *reader) {
    shim_oiio_report ignored;
    guarded(&ignored, [&] { delete reader; });
}

shim_oiio_reader *open_reader(const void *bytes, size_t length, const char *format, int page,
                              shim_oiio_spec *spec, shim_oiio_report *report) {
    std::unique_ptr<shim_oiio_reader> reader;
    bool ok = guarded(report, [&] {
        reader = std::make_unique<shim_oiio_reader>(bytes, length, page);
        open_image(*reader, format, *spec);
    });
    if (ok) return reader.release();
    close_reader(reader.release());
    return nullptr;
}

bool read_pixels(shim_oiio_reader *r, float *value, shim_oiio_report *report) {
    return guarded(report, [&] {
        switch (sample_of(r->spec)) {
        case SHIM_OIIO_U8:
            return decode_all<uint8_t>(*r, value);
        case SHIM_OIIO_U16:
            return decode_all<uint16_t>(*r, value);
        default:
            return decode_all<float>(*r, value);
        }
    });
}

bool write_image(const char *format, const shim_oiio_spec *spec, const void *samples,
                 void (*sink)(void *context, const char *bytes, size_t length), void *context,
                 shim_oiio_report *report) {
    return guarded(report, [&] {
        OIIO::Filesystem::IOVecOutput memory;
        encode(memory, format, *spec, samples);
        sink(context, reinterpret_cast<const char *>(memory.buffer().data()),
             memory.buffer().size());
        OIIO::geterror();
    });
}

} // namespace

const struct shim_oiio shim_oiio = {open_reader, read_pixels, close_reader, write_image};
