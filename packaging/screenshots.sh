#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Makes the pictures of the README from the running console: touches and a contour of a simulated arm, a recorded pressure mat, a
# simulated array, a simulated camera and its calibration, a pattern, a rehearsed study, light and dark. The contour takes four minutes,
# since it is explored in real time.
#   screenshots.sh [FOLDER [WIDTHxHEIGHT]]      default: resources/screenshots 1600x1000
#   screenshots.sh --handbook                   those of the handbook's pages instead: resources/handbook/pictures 1200x760
set -euo pipefail
source "$(dirname -- "${BASH_SOURCE[0]}")/build_environment.sh"
if [[ ${1:-} == --handbook ]]; then
    folder=$root/resources/handbook/pictures
    size=1200x760
else
    folder=${1:-$root/resources/screenshots}
    size=${2:-1600x1000}
fi
mkdir -p "$folder"

"$root/packaging/install_dependencies.sh"
configure run
cmake --build "$root/build/run" --target teleta-console teleta
ensure_runtime_folder

data="$root/tests/data/popu"
recording=(--replay "$data/tactilus_sequence_excerpt.csv" --tare "$data/tactilus_empty1.csv" --rows 64 --columns 27
    --threshold 20 --after 5)
ball=(--scene "$root/resources/scenes/tactile-indenter.toml" --after 6)
plotted=(--plot tactile-indenter/features/force_n --plot tactile-indenter/features/cop_x_m --plot tactile-indenter/features/cop_y_m)
touch=(--scene "$root/resources/scenes/teleta-touch.toml" --after 14)
touches=(--scene "$root/resources/scenes/teleta-touch.toml" --after 34)
camera=(--scene "$root/resources/scenes/vtacarm-multicontact.toml" --after 4)
contour=(--scene "$root/resources/scenes/teleta-contour-triangle.toml" --after 250)
servo=(--scene "$root/resources/scenes/servo-bent-bar.toml" --dock runs --after 12)
bar=(--scene "$root/resources/scenes/tactile-indenter.toml" --after 14)

studies=$(mktemp -d)
trap 'rm -rf -- "$studies"' EXIT
# Of a study the page shows the folder, from the home of the user.
"$root/build/run/app/cli/teleta" study rehearse --participants 6 --seed 1 --out "$studies/whole"
session=(--study "$studies/studies/vibration" --rehearse --page study --after 45)
participant=(--study "$studies/participant" --rehearse --page study --dock participant --after 8)
results=(--study "$studies/whole" --page study --dock results --after 8)
"$root/build/run/app/cli/teleta" simulate "$root/resources/scenes/vtacarm-calibration.toml" --out "$studies/camera"
cat >"$studies/pattern.json" <<'END'
{"format": "teleta-pattern", "version": 1, "id": "example.edge", "name": "Edge, then around", "task": "shape", "condition": "dynamic",
 "notes": "A stroke along the edge, around it, two pulses to confirm.", "tags": ["edge", "example"], "duration_s": 4.0,
 "tracks": [[[3.0, 0], [3.2, 0.6, "ease-in-out"], [3.8, 0]], [], [], [[3.0, 0], [3.2, 0.6, "ease-in-out"], [3.8, 0]], [], []],
 "objects": [
  {"type": "stroke", "name": "edge", "start_s": 0.1, "points": [[0, 0, 0.3], [1.1, 4.6, 0.9]], "intensity": 0.9},
  {"type": "ring", "name": "around", "start_s": 1.3, "duration_s": 1.4, "turns": 4, "first_tactor": 1, "counter_clockwise": true, "intensity": 0.8},
  {"type": "pulses", "name": "confirm", "start_s": 2.9, "duration_s": 0.9, "period_s": 0.45, "width_s": 0.12, "tactors": [5], "intensity": 0.7}]}
END

# take NAME ARGUMENTS...
take() {
    local picture="$folder/$1.png"
    shift
    xvfb-run -a -s "-screen 0 ${size}x24" env QT_QPA_PLATFORM=xcb LIBGL_ALWAYS_SOFTWARE=1 \
        "$root/build/run/app/console/teleta-console" "$@" --size "$size" --screenshot "$picture"
    printf '%s\n' "$picture"
}

if [[ ${1:-} == --handbook ]]; then
    take page-start --fresh --after 60 --theme light
    take page-operate "${touches[@]}" --dock touches --theme light
    take page-recording "${recording[@]}" --theme light
    take page-patterns --page patterns --after 6 --theme light
    HOME=$studies take page-study "${session[@]}" --theme light
    take page-calibrate --page calibrate --after 5 --theme light
    take page-plot "${bar[@]}" --page plot "${plotted[@]}" --theme light
    # Measured on this machine.
    "$root/build/run/app/cli/teleta" tradeoff contact-flow stiffness --out "$studies/data/cost"
    take page-cost --page cost --data "$studies/data" --after 5 --theme light
    exit
fi
take operate-touch-dark "${touch[@]}" --theme dark
take operate-contour-light "${contour[@]}" --dock contour --theme light
take operate-camera-dark "${camera[@]}" --theme dark
take operate-servo-light "${servo[@]}" --theme light
take operate-touches-dark "${touches[@]}" --dock touches --theme dark
take patterns-light --page patterns --pattern "$studies/pattern.json" --after 6 --theme light
take calibrate-camera-dark --page calibrate --camera-pairs "$studies/camera/pairs.csv" --after 12 --theme dark
take calibrate-motors-light --page calibrate --after 4 --theme light
HOME=$studies take study-session-light "${session[@]}" --theme light
take study-participant-light "${participant[@]}" --theme light
HOME=$studies take study-results-dark "${results[@]}" --theme dark
take operate-recording-dark "${recording[@]}" --theme dark
take operate-recording-light "${recording[@]}" --theme light
take operate-ball-light "${ball[@]}" --theme light
take operate-bar-dark "${bar[@]}" --theme dark
