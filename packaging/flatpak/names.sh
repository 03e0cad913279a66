# SPDX-License-Identifier: GPL-3.0-or-later
# For make_flatpak.sh and test_flatpak.sh, which source it after build_environment.sh: what the parts of the Flatpak are called, as the
# manifest has it, and where they lie. Needs fail() of those scripts.
# shellcheck shell=bash
manifest="$root/packaging/flatpak/org.teleta.Console.yml"
manifest_value() {
    local value
    value=$(sed -n "s/^$1: //p" "$manifest" | tr -d "'")
    [[ -n $value ]] || fail "$manifest names no $1"
    printf '%s' "$value"
}
application=$(manifest_value id)
branch=$(manifest_value branch)
platform=$(manifest_value runtime)
sdk=$(manifest_value sdk)
runtime_version=$(manifest_value runtime-version)
work="$root/build/flatpak"
repository="$work/repository"
bundle="$work/teleta-console.flatpak"
runtime_bundle="$work/teleta-platform.flatpak"
