#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Looks for inputs that break a parser: coverage-guided fuzzing by libFuzzer under the address and undefined-behaviour sanitizers.
#   fuzz.sh [NAME...] [--seconds S]     default: every target of tests/fuzz, 60 s each
# Not part of test.sh: it installs its own dependencies and builds with clang. What it learns stays in build/fuzz/corpus,
# where the next run continues. Inputs that break something are left in build/fuzz/crashes/NAME, and the exit code is 1. Fix
# the parser and keep them in tests/fuzz/regressions/NAME, which every test run replays.
set -uo pipefail
source "$(dirname -- "${BASH_SOURCE[0]}")/build_environment.sh"

fail() {
    printf 'fuzz: %s\n' "$*" >&2
    exit 2
}

mapfile -t all < <(sed -n 's/^teleta_fuzz_target(\([a-z_]*\) .*/\1/p' "$root/tests/fuzz/CMakeLists.txt")
seconds=60
names=()
while (($#)); do
    case "$1" in
        --seconds)
            [[ ${2:-} =~ ^[1-9][0-9]*$ ]] || fail "--seconds wants a whole number"
            seconds=$2
            shift
            ;;
        *)
            [[ " ${all[*]} " == *" $1 "* ]] || fail "there is no target '$1' (expected ${all[*]})"
            names+=("$1")
            ;;
    esac
    shift
done
((${#names[@]})) || names=("${all[@]}")

"$root/packaging/install_dependencies.sh" --fuzz || exit 1
build="$root/build/fuzz"
configure fuzz && cmake --build "$build" --target "${names[@]/#/fuzz_}" || exit 1

export UBSAN_OPTIONS="print_stacktrace=1"
export ASAN_OPTIONS="detect_stack_use_after_return=1 strict_string_checks=1"
log=$(mktemp)
trap 'rm -f -- "$log"' EXIT
summary=()
broken=0
for name in "${names[@]}"; do
    corpus="$build/corpus/$name"
    crashes="$build/crashes/$name"
    mkdir -p "$corpus" "$crashes"
    awk -F '\t' -v name="$name" '$2 == name { print $3 }' "$build/tests/fuzz/inputs.txt" |
        while read -r input; do cp -- "$input" "$corpus/"; done
    printf '\n== %s, %d s\n' "$name" "$seconds"
    nice "$build/tests/fuzz/fuzz_$name" -max_total_time="$seconds" -timeout=20 -rss_limit_mb=4096 -print_final_stats=1 \
        -artifact_prefix="$crashes/" "$corpus" 2>&1 | tee "$log" | grep -vE '^#|^(INFO|stat::)|NEW_FUNC|NEW_PC'
    status=${PIPESTATUS[0]}
    runs=$(sed -n 's/^stat::number_of_executed_units: *//p' "$log")
    edges=$(grep -oE 'cov: [0-9]+' "$log" | tail -n 1)
    left=$(find "$crashes" -type f | wc -l)
    ((status == 0 && left == 0)) || ((broken += 1))
    summary+=("$(printf '%-20s %10s runs  %6s edges  %5d inputs  %d broke it' "$name" "${runs:-no}" "${edges#cov: }" \
        "$(find "$corpus" -type f | wc -l)" "$left")")
done

printf '\n'
printf '%s\n' "${summary[@]}"
if ((broken)); then
    printf '%d targets broke: see %s\n' "$broken" "$build/crashes"
    exit 1
fi
