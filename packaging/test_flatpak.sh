#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds the Flatpak, installs it for a person with an empty home, and uses it as that person would. Needs root rights, as
# make_flatpak.sh does.
set -euo pipefail
source "$(dirname -- "${BASH_SOURCE[0]}")/build_environment.sh"

fail() {
    printf 'test_flatpak: %s\n' "$*" >&2
    exit 1
}
"$root/packaging/make_flatpak.sh"
source "$root/packaging/flatpak/names.sh"

# An empty home, without this machine's installations and settings. Not in /tmp: a Flatpak has its own /tmp.
home="$work/home"
rm -rf -- "$home"
mkdir -p "$home"
export HOME="$home"
unset FLATPAK_USER_DIR XDG_DATA_HOME XDG_CONFIG_HOME XDG_CACHE_HOME XDG_STATE_HOME LC_ALL LANGUAGE
export LANG=C.UTF-8
XDG_RUNTIME_DIR=$(mktemp -d)
export XDG_RUNTIME_DIR
processes=()
finish() {
    ((${#processes[@]} == 0)) || kill "${processes[@]}" 2>/dev/null || true
    rm -rf -- "$XDG_RUNTIME_DIR"
}
trap finish EXIT
installation="$home/.local/share/flatpak"

flatpak install --user --noninteractive -y "$runtime_bundle"
flatpak install --user --noninteractive -y "$bundle"

printf '\n== installed\n'
flatpak list --user --columns=application,branch,installation,size
for file in share/applications/$application.desktop share/icons/hicolor/scalable/apps/$application.svg \
    share/metainfo/$application.appdata.xml share/mime/packages/$application.xml bin/$application; do
    [[ -s $installation/exports/$file ]] || fail "exports/$file is missing"
done
desktop="$installation/exports/share/applications/$application.desktop"
grep -q "^Exec=.*flatpak run .*--command=teleta-console .*$application" "$desktop" || fail "the desktop file does not start the Flatpak"
grep -qx "Icon=$application" "$desktop" || fail "the desktop file names an icon that is not exported"
files="$installation/app/$application/current/active/files"
[[ $(gzip -dc "$files/share/app-info/xmls/$application.xml.gz") == *"<id>$application"* ]] || fail "software centres do not see the program"
[[ ! -e $files/lib/udev ]] || fail "udev rules are where no udev reads them"

# inside COMMAND ARGUMENTS...: runs a command in the sandbox of the programs.
inside() { flatpak run --command="$1" "$application" "${@:2}"; }
teleta() { inside teleta "$@"; }

printf '\n== the command line\n'
cd "$home"
teleta --version
teleta simulate --list
teleta simulate tactile-indenter --duration 1 --out run >/dev/null
[[ -s run/summary.json ]] || fail "simulate left no summary"
teleta replay run/recording.teleta --out features.csv
(($(wc -l <features.csv) > 10)) || fail "a recording could not be replayed"
teleta simulate servo-bent-bar --duration 6 --out servo --figures svg,pdf >/dev/null
compgen -G 'servo/*.pdf' >/dev/null || fail "no figure was drawn"
teleta study rehearse --participants 2 --seed 1 --out study >/dev/null
teleta study analyze study --out results >/dev/null
[[ -s results/anova.csv ]] || fail "analyze left no ANOVA"
teleta devices
# says WORD COMMAND...: checks that the command prints the word.
says() {
    local printed
    printed=$("${@:2}") && grep -q -- "$1" <<<"$printed"
}
in_locale() { env LC_ALL="$1" flatpak run --command=teleta "$application" "${@:2}"; }
says '^Calcule contacts' in_locale fr_FR.UTF-8 --help || fail "the command line does not speak French"
says '接触' in_locale ja_JP.UTF-8 --help || fail "the command line does not speak Japanese"
says '接触' in_locale zh_CN.UTF-8 --help || fail "the command line does not speak Chinese"
says uaccess inside cat /app/share/teleta-console/udev/70-teleta-bracelet.rules || fail "there are no udev rules to copy from"
# Nothing listens on port 1: a refused connection shows that the driver is there.
refused=$(teleta study rehearse --participants 2 --seed 1 --out refused --store 'postgresql://nobody@127.0.0.1:1/none?study=x' 2>&1 || true)
[[ $refused == *"connection to server"* ]] || fail "a PostgreSQL server cannot be asked for a study: $refused"
# The second run reads fontconfig's cache.
for ((i = 0; i < 2; ++i)); do
    says '^/run/host/fonts/' inside fc-list || fail "the fonts of this machine are not seen"
done
# Users must not get compilers or package managers.
for tool in gcc cc cmake apt-get dpkg perl; do
    if inside sh -c "command -v $tool" >/dev/null; then fail "the runtime holds $tool"; fi
done

printf '\n== the console\n'
pictures="$work/pictures"
rm -rf -- "$pictures"
mkdir -p "$pictures"
# take NAME ARGUMENTS...: takes a picture of the console under a command that gives it a screen.
take() {
    local picture="$home/$1.png"
    shift
    LIBGL_ALWAYS_SOFTWARE=1 "${screen[@]}" flatpak run "$application" "$@" --screenshot "$picture" 2> >(tee "$home/errors.txt" >&2) ||
        fail "the console ended with an error"
    [[ -s $picture ]] || fail "the console left no picture $picture"
    cp "$picture" "$pictures"
}
has_view3d() { ! grep -q view3d "$home/errors.txt"; }

screen=(xvfb-run -a -s "-screen 0 1600x1000x24")
take touch --scene teleta-touch --after 9 --record recording.teleta
has_view3d || fail "the 3D view cannot draw under X11"
[[ -s recording.teleta ]] || fail "the console recorded nothing"
take replay --replay recording.teleta --after 4
take french --scene tactile-indenter --language fr --after 4
take japanese --scene tactile-indenter --language ja --after 4

# A Wayland desktop, with an X server and without.
weston --backend=headless-backend.so --use-pixman --xwayland --socket=teleta --width=1600 --height=1000 --idle-time=0 \
    >"$home/weston.log" 2>&1 &
processes=($!)
for ((i = 0; i < 50; ++i)); do
    [[ ! -S $XDG_RUNTIME_DIR/teleta ]] || break
    sleep 0.1
done
display=$(sed -n 's/.*xserver listening on display //p' "$home/weston.log")
[[ -n $display ]] || fail "weston does not start, see $home/weston.log"
screen=(env WAYLAND_DISPLAY=teleta XDG_SESSION_TYPE=wayland DISPLAY="$display")
take wayland --scene teleta-touch --after 9
has_view3d || fail "the 3D view cannot draw on a Wayland desktop with an X server"
screen=(env -u DISPLAY WAYLAND_DISPLAY=teleta XDG_SESSION_TYPE=wayland)
take wayland-only --scene teleta-touch --after 4
printf '\n== uninstalled\n'
flatpak uninstall --user --noninteractive -y "$application"
flatpak uninstall --user --noninteractive -y "$platform"
[[ ! -e $installation/exports/bin/$application && ! -e $desktop && ! -e $installation/app/$application ]] ||
    fail "uninstalling leaves the program behind"
[[ -z $(flatpak list --user --columns=application) ]] || fail "uninstalling leaves something behind"
printf 'test_flatpak: passed; pictures in %s\n' "$pictures"
