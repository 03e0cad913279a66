#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Makes the manual pages from what the programs say with --help: teleta(1), one page for each of its commands,
# teleta-console(1) and teleta-site(8). teleta-site(1) is the page of the command `teleta site`.
#   make_man_pages.sh VERSION TELETA FOLDER [TELETA_CONSOLE] [TELETA_SITE]
set -euo pipefail
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
version=$1 teleta=$2 folder=$3
programs=("${@:4}")
mkdir -p "$folder"
rm -f "$folder"/*.[18] "$folder"/*.[18].gz
# The same bytes out of the same programs.
export LC_ALL=C TZ=UTC SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-$(git -C "$here" log -1 --format=%ct 2>/dev/null || date +%s)}

help_of() { "$@" --help 2>/dev/null; }
commands_in() { sed -n '/^Subcommands:/,/^$/s/^  \([a-z][a-z-]*\) .*/\1/p' <<<"$1"; }

# page NAME.SECTION SUMMARY INCLUDED PROGRAM [COMMAND...]
page() {
    local name=${1%.*} section=${1##*.} summary=$2 included=$3
    shift 3
    # help2man has a shell run its argument, which may hold a path with a space.
    local program
    program=$(printf '%q ' "$@")
    help2man --no-info --section="$section" --name="$summary" --source="TeleTA Console $version" --version-string="$version" \
        --include="$here/$included" --output="$folder/$name.$section" "${program% }"
    # help2man calls the page by the program.
    sed -i -e "s/^\\.TH [^ ]* \"$section\"/.TH ${name^^} \"$section\"/" -e "s/^[^ ]*\\( [a-z ]*\\)\\? \\\\- /$name \\\\- /" "$folder/$name.$section"
    gzip -9n "$folder/$name.$section"
}

# pages NAME INCLUDED PROGRAM [COMMAND...]: of a command and, in turn, of those below it.
pages() {
    local name=$1 included=$2 text summary command
    shift 2
    text=$(help_of "$@")
    summary=$(grep -vE '^(Usage:|$)' <<<"$text" | head -n 1)
    page "$name.1" "${summary%.}" "$included" "$@"
    for command in $(commands_in "$text"); do
        pages "$name-$command" command.h2m "$@" "$command"
    done
}

pages teleta teleta.h2m "$teleta"
for program in "${programs[@]}"; do
    case $program in
        */teleta-console) page teleta-console.1 "see and feel what a remote robot arm touches" teleta-console.h2m "$program" ;;
        */teleta-site) page teleta-site.8 "the robot's end of a link to its consoles" teleta-site.h2m "$program" ;;
    esac
done
