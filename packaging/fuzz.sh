#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Looks for inputs that break a parser: coverage-guided fuzzing by libFuzzer under the address and undefined-behaviour sanitizers.
#   fuzz.sh [NAME...] [--seconds S]            default: every target of tests/fuzz, 60 s each
#   fuzz.sh [NAME...] --regular MINUTES        for a timer: each target gets its share of that time
# Each target first reads inputs with as many levels as there is room for (tests/fuzz/deep_inputs.py). Not part of test.sh: it
# installs its own dependencies and builds with clang. What it learns stays in build/fuzz/corpus, where the next run continues; with
# --regular it stays in $XDG_CACHE_HOME/teleta-fuzz (or --corpus FOLDER), which outlives the build, and is thinned at the end.
# Inputs that break something are left in build/fuzz/crashes/NAME, and the exit code is 1. Fix the parser and keep them in
# tests/fuzz/regressions/NAME, which every test run replays.
set -uo pipefail
source "$(dirname -- "${BASH_SOURCE[0]}")/build_environment.sh"

fail() {
    printf 'fuzz: %s\n' "$*" >&2
    exit 2
}

mapfile -t all < <(sed -n 's/^teleta_fuzz_target(\([a-z_]*\) .*/\1/p' "$root/tests/fuzz/CMakeLists.txt")
seconds=60
regular=
corpora=
names=()
while (($#)); do
    case "$1" in
        --seconds)
            [[ ${2:-} =~ ^[1-9][0-9]*$ ]] || fail "--seconds wants a whole number"
            seconds=$2
            shift
            ;;
        --regular)
            [[ ${2:-} =~ ^[1-9][0-9]*$ ]] || fail "--regular wants a whole number of minutes"
            regular=$2
            shift
            ;;
        --corpus)
            [[ -n ${2:-} ]] || fail "--corpus wants a folder"
            corpora=$2
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
if [[ -n $regular ]]; then
    seconds=$((regular * 60 / ${#names[@]}))
    ((seconds >= 5)) || fail "$regular minutes are too short for ${#names[@]} targets"
fi

"$root/packaging/install_dependencies.sh" --fuzz || exit 1
build="$root/build/fuzz"
if [[ -z $corpora ]]; then
    corpora="$build/corpus"
    [[ -z $regular ]] || corpora="${XDG_CACHE_HOME:-$HOME/.cache}/teleta-fuzz"
fi
configure fuzz && cmake --build "$build" --target "${names[@]/#/fuzz_}" || exit 1

export UBSAN_OPTIONS="print_stacktrace=1"
export ASAN_OPTIONS="detect_stack_use_after_return=1 strict_string_checks=1"
log=$(mktemp)
trap 'rm -f -- "$log" "$log.merge"' EXIT
summary=()
broken=0
for name in "${names[@]}"; do
    corpus="$corpora/$name"
    crashes="$build/crashes/$name"
    mkdir -p "$corpus" "$crashes"
    mapfile -t inputs < <(awk -F '\t' -v name="$name" '$2 == name { print $3 }' "$build/tests/fuzz/inputs.txt")
    ((${#inputs[@]} == 0)) || cp -- "${inputs[@]}" "$corpus/"
    printf '\n== %s, %d s\n' "$name" "$seconds"
    # First as many levels as there is room for, which mutations seldom reach.
    rm -rf -- "$build/deep/$name"
    "$root/tests/fuzz/deep_inputs.py" --out "$build/deep/$name" "${inputs[@]}"
    nice "$build/tests/fuzz/fuzz_$name" -runs=0 -timeout=20 -rss_limit_mb=4096 -max_len=200000 -artifact_prefix="$crashes/" \
        "$build/deep/$name" >"$log" 2>&1 || grep -E '^(SUMMARY|==|    #[0-9] )' "$log"
    nice "$build/tests/fuzz/fuzz_$name" -max_total_time="$seconds" -timeout=20 -rss_limit_mb=4096 -print_final_stats=1 \
        -max_len=200000 -len_control=0 \
        -artifact_prefix="$crashes/" "$corpus" 2>&1 | tee "$log" | grep -vE '^#|^(INFO|stat::)|NEW_FUNC|NEW_PC'
    status=${PIPESTATUS[0]}
    if [[ -n $regular ]]; then
        thinned=$(mktemp -d "$corpora/$name.XXXXXX")
        if "$build/tests/fuzz/fuzz_$name" -merge=1 -timeout=20 -rss_limit_mb=4096 "$thinned" "$corpus" >"$log.merge" 2>&1; then
            rm -rf -- "$corpus"
            mv -- "$thinned" "$corpus"
        else
            rm -rf -- "$thinned"
        fi
    fi
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
