#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs what is missing, builds everything with warnings as errors and runs all checks:
#   format      clang-format of every C++ file
#   ci          the whole project: all tests, those with OpenGL on a screen in memory
#   headless    backend and command line without any GUI library: everything builds and links, and the programs work
#   tsan        threads: parts of backend and devices under the thread sanitizer
#   asan        parts of the backend, the hard cases of the others and inputs that once broke a parser, under the address
#               and undefined-behaviour sanitizers
# Runs only when named:
#   alone       the programs and tests of the preset dev: each source compiles by itself, without the other sources of a
#               unity build, and with assertions
#   soak        takes many minutes: every effect of every scene with a camera left out once; the console for an hour
#               with arm, array, camera, bracelet and recording (TELETA_SOAK_S: other seconds)
# Arguments name the checks to run. Every check runs, even when another one fails; the summary comes last.
set -uo pipefail
source "$(dirname -- "${BASH_SOURCE[0]}")/build_environment.sh"

all_checks=(format ci headless tsan asan)
more_checks=(alone soak)
for name in "$@"; do
    if [[ " ${all_checks[*]} ${more_checks[*]} " != *" $name "* ]]; then
        printf "test: unknown check '%s' (expected %s)\n" "$name" "${all_checks[*]} ${more_checks[*]}" >&2
        exit 2
    fi
done
checks=("$@")
((${#checks[@]})) || checks=("${all_checks[@]}")

"$root/packaging/install_dependencies.sh" --test || exit 1
"$root/tests/peer/mcap/install.sh" || exit 1
ensure_runtime_folder

passed=0
failed=0
summary=()

# record CHECK PASSED FAILED [REMARK]
record() {
    ((passed += $2, failed += $3))
    summary+=("$(printf '%-9s %4d passed, %d failed%s  (%d s)' "$1" "$2" "$3" "${4:+: $4}" "$SECONDS")")
}

# run_tests FOLDER [CTEST ARGUMENTS...]: adds the numbers of one CTest run to tests_passed and tests_failed.
run_tests() {
    local log line
    log=$(mktemp)
    ctest --test-dir "$@" -j "$jobs" --no-tests=error --output-on-failure 2>&1 | tee "$log"
    local status=${PIPESTATUS[0]}
    line=$(grep -oE '[0-9]+ tests failed out of [0-9]+' "$log")
    rm -f "$log"
    if [[ $line =~ ^([0-9]+)\ tests\ failed\ out\ of\ ([0-9]+)$ ]]; then
        ((tests_failed += BASH_REMATCH[1], tests_passed += BASH_REMATCH[2] - BASH_REMATCH[1]))
        ((status == 0 || BASH_REMATCH[1] > 0)) || ((tests_failed += 1))
    else
        ((tests_failed += 1))
    fi
}

# check_build PRESET FOLDERS...: builds and tests everything, or only what is in these folders of tests/, and $more_tests. The
# tests are those of $labels.
labels=(-LE '^soak$')
more_tests=()
check_build() {
    local preset=$1 folder
    shift
    local targets=(all) folders=(.) ctest_arguments=("${labels[@]}")
    # Peers, and statistics and faults over many runs, take minutes, and a sanitizer finds its errors in a few runs.
    local slow='(_accuracy|file_faults|allocation_failure|cli_certify|study_kill|written_files)_test$'
    [[ $preset == ci ]] || ctest_arguments=(-LE '^(soak|peer)$' -E "$slow")
    if (($#)); then
        folders=("${@/#/tests/}")
        targets=("${folders[@]/%//all}" "${more_tests[@]}")
    fi
    [[ $preset != headless ]] || targets=(all)
    tests_passed=0
    tests_failed=0
    if ! configure "$preset" || ! cmake --build "$root/build/$preset" --target "${targets[@]}"; then
        record "$preset" 0 1 "it does not build"
        return
    fi
    for folder in "${folders[@]}"; do
        run_tests "$root/build/$preset/$folder" "${ctest_arguments[@]}"
    done
    if ((${#more_tests[@]})); then
        local names
        names=$(IFS='|' && printf '%s' "${more_tests[*]}")
        run_tests "$root/build/$preset" -R "^($names)\$"
    fi
    record "$preset" "$tests_passed" "$tests_failed"
}

# What is compiled for headless is the same, byte for byte, as for ci, which tests it. What may differ is how it is linked and what is
# loaded: the libraries of the programs, each command as its help shows it, and the Python module.
headless_parts=(architecture)
headless_tests=(core_test cli_test cli_examples_test cli_output_test python_imports_test python_examples_test)

# Folders of tests/ that run under a sanitizer. A part joins its list once all of its tests have run clean there.
tsan_parts=(backend/core backend/playback devices/replay)
asan_parts=(backend/core backend/contact backend/stiffness backend/arm backend/contour)
# Of the other parts the hard cases: where a whole part would take many minutes to build. Left out: damaged pattern files
# (pattern_files_stability_test), which take minutes to run and which the fuzzer makes too.
asan_tests=(camera_contacts_stability_test equilibration_test fuzz_regression_test motors_stability_test pattern_stability_test
            servo_stability_test simulated_arm_stability_test simulated_servo_stability_test simulation_stability_test
            study_statistics_stability_test vision_stability_test)

export TSAN_OPTIONS="halt_on_error=1 second_deadlock_stack=1"
export ASAN_OPTIONS="detect_stack_use_after_return=1 strict_string_checks=1"
export UBSAN_OPTIONS="print_stacktrace=1"

for name in "${checks[@]}"; do
    printf '\n== %s\n' "$name"
    SECONDS=0
    case "$name" in
        format)
            if "$root/packaging/format.sh" --check; then
                record format 1 0
            else
                record format 0 1 "run packaging/format.sh"
            fi
            ;;
        alone)
            # Only whether it compiles matters here, so without debug information and optimization.
            if configure dev -B build/alone -DTELETA_WERROR=ON -DCMAKE_CXX_FLAGS_DEBUG= &&
                cmake --build "$root/build/alone" -- -k 0; then
                record alone 1 0
            else
                record alone 0 1 "a source does not compile by itself"
            fi
            ;;
        headless)
            more_tests=("${headless_tests[@]}")
            check_build headless "${headless_parts[@]}"
            more_tests=()
            ;;
        tsan)
            check_build tsan "${tsan_parts[@]}"
            ;;
        asan)
            more_tests=("${asan_tests[@]}")
            check_build asan "${asan_parts[@]}"
            more_tests=()
            ;;
        soak)
            labels=(-L '^soak$')
            check_build ci backend/scene_run app/console
            labels=(-LE '^soak$')
            ;;
        *) check_build "$name" ;;
    esac
done

printf '\n'
printf '%s\n' "${summary[@]}"
printf '%d passed, %d failed\n' "$passed" "$failed"
((failed == 0 && passed > 0))
