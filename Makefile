# SPDX-License-Identifier: GPL-3.0-or-later
# GNU make. `make help` lists the targets. Variables: BUILD (folder of a variant), PREFIX, DESTDIR,
# CC, CXX, OPT, WERROR=-Werror, SAN (sanitizer flags), FUZZ_SECONDS.
BUILD   ?= build
PREFIX  ?= /usr/local
DESTDIR ?=
ifeq ($(origin CC),default)
CC  := gcc
endif
ifeq ($(origin CXX),default)
CXX := g++
endif
OPT    ?= -O2 -g
WERROR ?=
SAN    ?=
VERSION := $(shell cat VERSION)
FUZZ_SECONDS ?= 30
export BUILD FUZZ_SECONDS

WARN     := -Wall -Wextra -Wshadow -Wconversion -Wvla $(WERROR)
CPPFLAGS += -Ilib -D_GNU_SOURCE -DSUPPLE_VERSION='"$(VERSION)"' $(shell pkg-config --cflags-only-I cairo libpng)
CFLAGS   += -std=c11 $(OPT) -ffp-contract=off $(WARN) -Wmissing-prototypes $(SAN)
CXXFLAGS += -std=c++17 $(OPT) -ffp-contract=off $(WARN) $(SAN)
LIBS     := -Wl,--as-needed -lspqr -lcholmod $(shell pkg-config --libs mpfr gmp zlib cairo libpng) -ldl -lm
# OpenImageIO takes 0.2 s to start: it is in a module, which programs look for beside themselves.
OIIO     := $(BUILD)/lib/supple/supple-oiio.so
FIND_OIIO = -Wl,-rpath,'$$ORIGIN/../lib/supple'
TESTLIBS := $(shell pkg-config --libs cmocka 2>/dev/null || echo -lcmocka)

objects  = $(patsubst %,$(BUILD)/%.o,$(basename $(1)))
LIB     := $(BUILD)/libsupple.a
LIB_OBJ := $(call objects,$(filter-out lib/shim_oiio.cc,$(wildcard lib/*.c lib/*.cc)))
TOOLS   := $(patsubst %.c,$(BUILD)/bin/%,$(notdir $(wildcard tools/*.c)))
TEST_OBJ := $(call objects,$(filter-out lib/test/t-%,$(wildcard lib/test/*.c)))
TESTS   := $(patsubst %.c,$(BUILD)/test/%,$(notdir $(wildcard lib/test/t-*.c)))
FUZZERS := $(patsubst %.c,$(BUILD)/fuzz/%,$(notdir $(wildcard lib/fuzz/fuzz-*.c)))
BENCH   := $(patsubst %,$(BUILD)/bench/%,$(basename $(notdir $(wildcard scripts/bench/*.c scripts/bench/*.cc))))
HEADERS := $(filter-out lib/shim_% lib/oiio_load.h,$(wildcard lib/*.h))
SOURCES := $(wildcard lib/*.[ch] lib/*.cc lib/test/*.[ch] lib/fuzz/*.[ch] tools/*.c scripts/bench/*.c scripts/bench/*.cc)

.PHONY: all tests help unit check check-long bless demo bench figures picture asan fuzz fuzzers lint format install uninstall dist clean
all: $(TOOLS) $(LIB) $(OIIO)     ## build the programs into build/bin

tests: $(TESTS)          ## build the unit tests into build/test

help:                    ## list the targets
	@sed -n 's/^\([a-z-]*\):[^#]*## /\1\t/p' $(firstword $(MAKEFILE_LIST)) | expand -t 16

demo: all                ## bend a worm into an omega
	scripts/demo

unit: $(TESTS)           ## run the unit tests
	scripts/unit

check: all $(TESTS)      ## run all tests that take seconds
	scripts/suites

check-long: all $(TESTS) ## run them with ten times the random cases
	SUPPLE_TEST_SCALE=1000 scripts/suites unit properties same-bytes

bless: all               ## record what the programs print now as the golden output; review by git diff
	scripts/golden --bless

bench: all $(BENCH)      ## measure speed and memory against the limits
	scripts/bench/run

figures: all             ## make the figures of the papers: build/figures/index.html
	scripts/figures/run

picture: all             ## make the picture of the README again
	scripts/worm-omega >/dev/null && cp $(BUILD)/demo/worm-omega.png scripts/figures

asan:                    ## test with AddressSanitizer and UBSan (clang), a quarter of the random cases
	$(MAKE) BUILD=build/asan CC=clang CXX=clang++ OPT='-O1 -g' \
	    SAN='-fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer' all tests
	BUILD=build/asan SUPPLE_TEST_SCALE=25 scripts/suites unit golden bad

fuzz:                    ## fuzz every text format, FUZZ_SECONDS in all (clang)
	$(MAKE) BUILD=build/fuzz CC=clang CXX=clang++ OPT='-O1 -g' \
	    SAN='-fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=all' fuzzers
	BUILD=build/fuzz scripts/fuzz

fuzzers: $(FUZZERS)

lint:                    ## check sources, scripts and manuals against the rules of the house
	scripts/lint

format:                  ## lay out the sources with clang-format
	clang-format -i $(SOURCES)

install: all             ## install programs, library, headers and manuals below PREFIX
	install -d $(addprefix $(DESTDIR)$(PREFIX)/,bin lib/pkgconfig lib/supple include/supple share/man/man1 \
	    share/man/man3 share/man/man5 share/man/man7)
	install $(TOOLS) $(DESTDIR)$(PREFIX)/bin
	install -m 644 $(LIB) $(DESTDIR)$(PREFIX)/lib
	install -m 644 $(OIIO) $(DESTDIR)$(PREFIX)/lib/supple
	install -m 644 $(HEADERS) $(DESTDIR)$(PREFIX)/include/supple
	for page in $(wildcard man/*.[1-8]); do \
	    install -m 644 $$page $(DESTDIR)$(PREFIX)/share/man/man$${page##*.} || exit; done
	printf '%s\n' 'prefix=$(PREFIX)' 'Name: supple' 'Description: smooth deformations of plane and 2.5-D space' \
	    'Version: $(VERSION)' 'Cflags: -I$${prefix}/include/supple' \
	    'Libs: -L$${prefix}/lib -lsupple -Wl,-rpath,$${prefix}/lib/supple $(LIBS) -lstdc++' >$(DESTDIR)$(PREFIX)/lib/pkgconfig/supple.pc

uninstall:               ## remove what install put there
	cd $(DESTDIR)$(PREFIX) && rm -f $(addprefix bin/,$(notdir $(TOOLS))) lib/libsupple.a \
	    lib/pkgconfig/supple.pc $(foreach m,$(notdir $(wildcard man/*.[1-8])),share/man/man$(subst .,,$(suffix $m))/$m)
	rm -rf $(addprefix $(DESTDIR)$(PREFIX)/,include/supple lib/supple)

dist:                    ## pack the last commit as build/supple-VERSION.tar.gz
	@mkdir -p build
	git archive --prefix=supple-$(VERSION)/ -o build/supple-$(VERSION).tar.gz HEAD

clean:                   ## remove what was built
	rm -rf build

$(LIB): $(LIB_OBJ)
	@rm -f $@
	$(AR) rcs $@ $^

$(OIIO): $(BUILD)/lib/shim_oiio.o
	@mkdir -p $(@D)
	$(CXX) $(CXXFLAGS) $(LDFLAGS) -shared -o $@ $< $(shell pkg-config --libs OpenImageIO)

$(BUILD)/bin/%: $(BUILD)/tools/%.o $(LIB) $(OIIO)
	@mkdir -p $(@D)
	$(CXX) $(CXXFLAGS) $(LDFLAGS) $(FIND_OIIO) -o $@ $< $(LIB) $(LIBS)

$(BUILD)/test/%: $(BUILD)/lib/test/%.o $(TEST_OBJ) $(LIB) $(OIIO)
	@mkdir -p $(@D)
	$(CXX) $(CXXFLAGS) $(LDFLAGS) $(FIND_OIIO) -o $@ $< $(TEST_OBJ) $(LIB) $(LIBS) $(TESTLIBS)

$(BUILD)/fuzz/%: $(BUILD)/lib/fuzz/%.o $(LIB) $(OIIO)
	@mkdir -p $(@D)
	$(CXX) $(CXXFLAGS) -fsanitize=fuzzer $(LDFLAGS) $(FIND_OIIO) -o $@ $< $(LIB) $(LIBS)

$(BUILD)/bench/%: $(BUILD)/scripts/bench/%.o $(LIB)
	@mkdir -p $(@D)
	$(CXX) $(CXXFLAGS) $(LDFLAGS) -Wl,--as-needed -o $@ $< $(LIB) $(LIBS)

$(BUILD)/%.o: %.c
	@mkdir -p $(@D)
	$(CC) $(CPPFLAGS) $(CFLAGS) -MMD -MP -c -o $@ $<

$(BUILD)/%.o: %.cc
	@mkdir -p $(@D)
	$(CXX) $(CPPFLAGS) $(CXXFLAGS) -MMD -MP -c -o $@ $<

$(BUILD)/lib/shim_oiio.o: CXXFLAGS += -fPIC
$(BUILD)/lib/shim_cgal.o: CXXFLAGS += -frounding-math # for CGAL's interval arithmetic
$(BUILD)/scripts/bench/cgal_locate.o: CXXFLAGS += -frounding-math -DNDEBUG

.SECONDARY:
-include $(shell find $(BUILD) -name '*.d' 2>/dev/null)
