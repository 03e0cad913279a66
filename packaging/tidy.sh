#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Runs clang-tidy on the C++ files that differ from a commit, committed or not.
#   tidy.sh [COMMIT]      COMMIT: default main, or the commit before when main is checked out
#   tidy.sh --all
set -euo pipefail
source "$(dirname -- "${BASH_SOURCE[0]}")/build_environment.sh"
cd "$root"

build=build/release
[[ -f $build/compile_commands.json ]] || build=build/headless
if [[ ! -f $build/compile_commands.json ]]; then
    configure release
    build=build/release
fi

if [[ ${1:-} == --all ]]; then
    changed=$(git ls-files 'app/*.cpp' 'widgets/*.cpp' 'backend/*.cpp' 'devices/*.cpp')
else
    base=${1:-$(git merge-base HEAD main)}
    [[ $(git rev-parse "$base") != $(git rev-parse HEAD) || -n ${1:-} ]] || base=HEAD~1
    changed=$({ git diff --name-only --diff-filter=d "$base"; git ls-files --others --exclude-standard; } |
        grep -E '^(app|widgets|backend|devices|tests)/.*\.cpp$' || true)
fi
files=()
for file in $changed; do
    # A file that this build leaves out (the GUI in a headless one) has no compile command.
    if grep -qF "\"$root/$file\"" "$build/compile_commands.json"; then
        files+=("$file")
    fi
done
if ((${#files[@]} == 0)); then
    printf 'tidy: no changed C++ file is part of %s\n' "$build"
    exit 0
fi
printf '%s\0' "${files[@]}" | xargs -0 -n 1 -P "$jobs" clang-tidy --quiet -p "$build" \
    --extra-arg=-Wno-unknown-warning-option --extra-arg=-Wno-ignored-gch --warnings-as-errors='*' 2> >(grep -v 'warnings generated' >&2)
