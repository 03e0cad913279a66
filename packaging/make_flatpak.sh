#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds the Flatpak of both programs and their runtime from Debian 12 packages, and prints the paths. Needs root rights for debootstrap,
# and 7 GB. A second run reuses the runtime; remove build/flatpak to build it from newer packages.
set -euo pipefail
source "$(dirname -- "${BASH_SOURCE[0]}")/build_environment.sh"

fail() {
    printf 'make_flatpak: %s\n' "$*" >&2
    exit 1
}
((EUID == 0)) || fail "debootstrap needs root rights"
source "$root/packaging/flatpak/names.sh"
source "$root/packaging/flatpak/runtime.sh"
# An installation only for building, apart from those of the machine and its users.
export FLATPAK_USER_DIR="$work/installation"
mkdir -p "$work"
"$root/packaging/install_dependencies.sh" --flatpak

# packaging_value NAME: the value that packaging/CMakeLists.txt sets.
packaging_value() {
    local value
    value=$(tr '\n' ' ' <"$root/packaging/CMakeLists.txt" | sed -n "s/.*set($1 *\"\([^\"]*\)\").*/\1/p")
    [[ -n $value ]] || fail "packaging/CMakeLists.txt does not set $1 to one text"
    printf '%s' "$value"
}
# Plugins and texts are those of the Debian package; shell completion does not work inside a Flatpak.
plugins=$(packaging_value CPACK_DEBIAN_CONSOLE_PACKAGE_DEPENDS)
texts=$(packaging_value CPACK_DEBIAN_CONSOLE_PACKAGE_RECOMMENDS)
texts=${texts/, bash-completion/}

# needed_packages PROGRAM...: the packages of the libraries that programs and modules built in the Sdk link.
needed_packages() {
    local needed
    tree="$work/Sdk"
    rm -rf -- "$tree/tmp/programs"
    mkdir -p "$tree/tmp/programs/debian"
    printf 'Source: teleta\nPackage: teleta\nArchitecture: any\n' >"$tree/tmp/programs/debian/control"
    cp "$@" "$tree/tmp/programs"
    needed=$(inside sh -c 'cd /tmp/programs && dpkg-shlibdeps -O teleta teleta-console *.so' 2>"$work/shlibdeps.log") ||
        fail "dpkg-shlibdeps refuses the programs, see $work/shlibdeps.log"
    printf '%s' "${needed#shlibs:Depends=}"
}

# flatpak-builder composes the exported metadata with appstream-util.
mapfile -t packages < <("$root/packaging/install_dependencies.sh" --print)
make_runtime Sdk "$(printf '%s, ' "${packages[@]}")appstream-util"
# flatpak-builder needs a Platform before the programs are built, but their libraries decide what it holds.
flatpak --user info "$platform" >/dev/null 2>&1 || make_runtime Platform fontconfig

printf 'Building %s\n' "$application"
flatpak-builder --user --force-clean --ccache --disable-rofiles-fuse --jobs="$jobs" --state-dir="$work/state" --repo="$repository" \
    "$work/application" "$manifest" >"$work/application.log" 2>&1 || {
    tail -n 40 "$work/application.log" >&2
    fail "flatpak-builder failed, see $work/application.log"
}
libraries=$(needed_packages "$work"/application/files/bin/* "$work"/application/files/lib/teleta-console/*.so)
# fc-list, from fontconfig, lists the fonts of the machine that the console sees.
make_runtime Platform "$libraries, $plugins, $texts, fontconfig"
ostree prune --repo="$repository" --refs-only --depth=0 >/dev/null

if [[ ! $runtime_bundle -nt $work/Platform.stamp ]]; then
    flatpak build-bundle --runtime "$repository" "$runtime_bundle" "$platform" "$runtime_version"
fi
flatpak build-bundle "$repository" "$bundle" "$application" "$branch"
printf 'The runtime is %s\nThe program is %s\nTo install them: flatpak install --user FILE, the runtime first.\n' "$runtime_bundle" "$bundle"
