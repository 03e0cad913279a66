#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Makes the manual pages from what the programs say with --help: teleta(1), one page for each of its commands, and
# teleta-console(1).
#   make_man_pages.sh VERSION TELETA FOLDER [TELETA_CONSOLE]
set -euo pipefail
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
version=$1 teleta=$2 folder=$3 console=${4:-}
mkdir -p "$folder"
rm -f "$folder"/*.1 "$folder"/*.1.gz
# The same bytes out of the same programs.
export LC_ALL=C TZ=UTC SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-$(git -C "$here" log -1 --format=%ct 2>/dev/null || date +%s)}

help_of() { "$@" --help 2>/dev/null; }
commands_in() { sed -n '/^Subcommands:/,/^$/s/^  \([a-z][a-z-]*\) .*/\1/p' <<<"$1"; }

# page NAME SUMMARY INCLUDED PROGRAM [COMMAND...]
page() {
    local name=$1 summary=$2 included=$3
    shift 3
    # help2man has a shell run its argument, which may hold a path with a space.
    local program
    program=$(printf '%q ' "$@")
    help2man --no-info --section=1 --name="$summary" --source="TeleTA Console $version" --version-string="$version" \
        --include="$here/$included" --output="$folder/$name.1" "${program% }"
    # help2man calls the page by the program.
    sed -i -e "s/^\\.TH [^ ]* \"1\"/.TH ${name^^} \"1\"/" -e "s/^[^ ]*\\( [a-z ]*\\)\\? \\\\- /$name \\\\- /" "$folder/$name.1"
    gzip -9n "$folder/$name.1"
}

# pages NAME INCLUDED PROGRAM [COMMAND...]: of a command and, in turn, of those below it.
pages() {
    local name=$1 included=$2 text summary command
    shift 2
    text=$(help_of "$@")
    summary=$(grep -vE '^(Usage:|$)' <<<"$text" | head -n 1)
    page "$name" "${summary%.}" "$included" "$@"
    for command in $(commands_in "$text"); do
        pages "$name-$command" command.h2m "$@" "$command"
    done
}

pages teleta teleta.h2m "$teleta"
if [[ -n $console ]]; then
    page teleta-console "see and feel what a remote robot arm touches" teleta-console.h2m "$console"
fi
