#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs what is missing, builds the programs and starts the console. Without a file or a device to open, it shows a
# simulated touch.
#   run.sh [arguments of teleta-console]
# Without a display it starts one in memory, takes a picture of the console, prints its path, and ends.
set -euo pipefail
source "$(dirname -- "${BASH_SOURCE[0]}")/build_environment.sh"

"$root/packaging/install_dependencies.sh"
configure run
cmake --build "$root/build/run" --target teleta-console teleta teleta-site

arguments=("$@")
has_source=false
has_screenshot=false
previous=''
for argument in "$@"; do
    case "$argument" in
        --scene | --scene=* | --replay | --replay=* | --sources | --sources=*) has_source=true ;;
        --camera | --camera=* | --arm | --arm=* | --site | --site=* | --study | --study=* | --rehearse) has_source=true ;;
        -h | --help* | -v | --version) has_source=true ;;
        --screenshot | --screenshot=*) has_screenshot=true ;;
        -*) ;;
        *.teleta | *.csv | *.toml)
            # A file to open, unless it belongs to the option before it.
            case "$previous" in
                -*=* | --fresh | --invert) has_source=true ;;
                -*) ;;
                *) has_source=true ;;
            esac
            ;;
    esac
    previous=$argument
done
$has_source || arguments=(--scene "$root/resources/scenes/teleta-touch.toml" "${arguments[@]}")
console="$root/build/run/app/console/teleta-console"

if [[ -n ${DISPLAY:-}${WAYLAND_DISPLAY:-} ]]; then
    exec "$console" "${arguments[@]}"
fi

picture="$root/build/teleta-console.png"
if ! $has_screenshot; then
    arguments+=(--screenshot "$picture" --after 9)
    rm -f "$picture"
fi
ensure_runtime_folder
status=0
xvfb-run -a -s "-screen 0 1600x1000x24" env QT_QPA_PLATFORM=xcb LIBGL_ALWAYS_SOFTWARE=1 \
    "$console" "${arguments[@]}" || status=$?
if ! $has_screenshot && [[ -s $picture ]]; then
    printf 'There is no display, so the console was drawn in memory. The picture is %s\n' "$picture"
fi
exit "$status"
