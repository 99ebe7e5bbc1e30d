# SPDX-License-Identifier: GPL-3.0-or-later
# GNU make. `make help` lists the targets.
BUILD  ?= build
PREFIX ?= /usr/local
ifeq ($(origin CC),default)
CC  := gcc
endif
ifeq ($(origin CXX),default)
CXX := g++
endif
OPT    ?= -O2 -g
WERROR ?=
VERSION := $(shell cat VERSION)

WARN     := -Wall -Wextra -Wshadow -Wconversion -Wvla $(WERROR)
CPPFLAGS += -Ilib -D_GNU_SOURCE -DSUPPLE_VERSION='"$(VERSION)"' $(SAN)
CFLAGS   += -std=c11 $(OPT) -ffp-contract=off $(WARN) -Wmissing-prototypes $(SAN)
CXXFLAGS += -std=c++17 $(OPT) -ffp-contract=off $(WARN) $(SAN)
LDLIBS   := -lspqr -lcholmod $(shell pkg-config --libs mpfr gmp zlib) -lm
TESTLIBS := $(shell pkg-config --libs cmocka)

LIB_OBJ := $(patsubst %.c,$(BUILD)/%.o,$(wildcard lib/*.c)) $(patsubst %.cc,$(BUILD)/%.o,$(wildcard lib/*.cc))
LIB     := $(BUILD)/libsupple.a
TOOLS   := $(patsubst tools/%.c,$(BUILD)/bin/%,$(wildcard tools/*.c))
TESTS   := $(patsubst lib/test/%.c,$(BUILD)/test/%,$(wildcard lib/test/t-*.c))

.PHONY: all help unit clean
all: $(TOOLS)            ## build the programs into build/bin

help:                    ## list the targets
	@sed -n 's/^\([a-z-]*\):[^#]*## /\1\t/p' $(MAKEFILE_LIST) | expand -t 16

unit: $(TESTS)           ## run the unit tests
	@set -e; for t in $(TESTS); do echo "$$t"; $$t; done

clean:                   ## remove what was built
	rm -rf build

$(LIB): $(LIB_OBJ)
	@rm -f $@
	$(AR) rcs $@ $^

$(BUILD)/bin/%: $(BUILD)/tools/%.o $(LIB)
	@mkdir -p $(@D)
	$(CXX) $(CXXFLAGS) $(LDFLAGS) -o $@ $< $(LIB) $(LDLIBS)

$(BUILD)/test/%: $(BUILD)/lib/test/%.o $(LIB)
	@mkdir -p $(@D)
	$(CXX) $(CXXFLAGS) $(LDFLAGS) -o $@ $< $(LIB) $(LDLIBS) $(TESTLIBS)

$(BUILD)/%.o: %.c
	@mkdir -p $(@D)
	$(CC) $(CPPFLAGS) $(CFLAGS) -MMD -MP -c -o $@ $<

$(BUILD)/%.o: %.cc
	@mkdir -p $(@D)
	$(CXX) $(CPPFLAGS) $(CXXFLAGS) -MMD -MP -c -o $@ $<

.SECONDARY:
-include $(shell find $(BUILD) -name '*.d' 2>/dev/null)
