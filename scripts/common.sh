# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=sh
# Sourced by the test scripts: the folders, a scratch folder that disappears, and counting.
# Every test script ends with one line "N passed, N failed" and fails when something failed.

root=$(cd "$(dirname "$0")/.." && pwd -P) || exit 1
case ${BUILD:=build} in /*) ;; *) BUILD=$root/$BUILD ;; esac
bin=$BUILD/bin
scratch=$(mktemp -d "${TMPDIR:-/tmp}/supple.XXXXXX") || exit 1
trap 'rm -rf "$scratch"' EXIT
trap 'exit 1' HUP INT TERM
passed=0
failed=0

pass() { passed=$((passed + 1)); }

# fail NAME [WHY]: WHY may have several lines.
fail() {
    failed=$((failed + 1))
    printf 'FAILED: %s\n' "$1"
    [ $# -lt 2 ] || printf '%s\n' "$2" | sed 's/^/    /'
}

# skip NAME WHY: something that this machine cannot do. CI cannot afford that.
skip() {
    if [ -n "${SUPPLE_STRICT:-}" ]; then fail "$@"; else printf 'skipped: %s: %s\n' "$1" "$2"; fi
}

# check NAME COMMAND...: passes when the command does.
check() {
    name=$1
    shift
    if "$@" >"$scratch/check.log" 2>&1; then pass; else fail "$name" "$(cat "$scratch/check.log")"; fi
}

finish() {
    printf '%d passed, %d failed\n' "$passed" "$failed"
    [ "$failed" -eq 0 ]
    exit
}

# An empty scratch folder as the working directory; ../data is testdata, so that messages name
# files by the same relative names everywhere.
fresh_folder() {
    cd "$scratch" && rm -rf work && mkdir work && cd work || exit 1
}

# Environment of everything that runs the programs.
ln -s "$root/testdata" "$scratch/data"
export ASAN_OPTIONS=allocator_may_return_null=1
# glibc's newlocale does not free 42 bytes, where LOCPATH is set, when OpenImageIO's libraries call it.
echo leak:argz_add_sep >"$scratch/leaks"
export LSAN_OPTIONS="print_suppressions=0:suppressions=$scratch/leaks"
export BUILD DATA=../data TOOLS="$bin" PATH="$bin:$PATH" LC_ALL=C
