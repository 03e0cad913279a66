#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs the Debian 12 packages that the project needs and that are missing.
#   install_dependencies.sh          those for building and running
#   install_dependencies.sh --test   also those of packaging/test.sh
#   install_dependencies.sh --package   also those of packaging/make_deb.sh and test_deb.sh
#   install_dependencies.sh --flatpak   also those of packaging/make_flatpak.sh and test_flatpak.sh
#   install_dependencies.sh --fuzz   also those of packaging/fuzz.sh
#   install_dependencies.sh --print  installs nothing, prints the packages that compile the programs
set -euo pipefail

# For compiling the programs.
build_packages=(
    # tools
    build-essential cmake ninja-build ccache pkg-config
    # Qt 6
    qt6-base-dev qt6-base-dev-tools qt6-tools-dev qt6-tools-dev-tools qt6-l10n-tools qt6-svg-dev libqt6svg6
    libqt6opengl6-dev libqt6sql6-sqlite libqt6sql6-psql qt6-translations-l10n
    # the live view for Foxglove
    qt6-websockets-dev
    # masking noise
    qt6-multimedia-dev
    # charts and the 3D view
    libqcustomplot-dev libqcustomplot2.1-qt6 libvtk9-dev
    # numerics
    libeigen3-dev libboost-math-dev
    # files, queues, command line
    libsqlite3-dev libtomlplusplus-dev nlohmann-json3-dev libzip-dev libreaderwriterqueue-dev libcli11-dev libexpected-dev
    # HDF5 and MAT files
    libhdf5-dev libmatio-dev
    # MCAP files
    libzstd-dev liblz4-dev zlib1g-dev
    # figures as PDF and PNG without a GUI library
    librsvg2-dev libcairo2-dev
    # the bracelet over USB HID
    libhidapi-dev
    # the camera in the soft tube
    libopencv-dev
    # motor drivers and joints over Modbus
    libmodbus-dev
    # the bracelet on a sound card; libjack is loaded at run time
    libasound2-dev
    # descriptions of robots, and the meshes that they name
    liburdfdom-dev libassimp-dev
    # robots over ROS 2
    cyclonedds-dev cyclonedds-tools
    # certificates and permissions of sites
    libssl-dev
)
# Build and run. GoogleTest and Google Benchmark are here because every preset configures the tests.
packages=(
    "${build_packages[@]}"
    # tests and benchmarks
    libgtest-dev libgmock-dev libbenchmark-dev lld
    # a screen, OpenGL in software and a font where there are none
    xvfb xauth libgl1-mesa-dri fonts-dejavu-core
)
# For the checks only.
test_packages=(clang-format clang-tidy desktop-file-utils appstream shared-mime-info libglib2.0-bin r-base-core)
# The shared store of studies, readers of reports and figures, and the other shell with completion.
test_packages+=(postgresql python3-html5lib poppler-utils locales zsh)
# Independent servers and serial lines, as peers of the devices.
test_packages+=(python3-pymodbus python3-serial-asyncio python3-dbusmock dbus socat qemu-system-x86 busybox-static cpio)
# Sound servers without a card, for the bracelet on a sound card.
test_packages+=(pipewire pipewire-bin wireplumber pipewire-jack pipewire-alsa jackd2)
# The simulator with which kinematics are compared.
test_packages+=(libmujoco-dev)
# The other DDS of a robot on ROS 2.
test_packages+=(libfastrtps-dev fastddsgen libtinyxml2-dev)
# Independent writers of HDF5 and MAT files.
test_packages+=(python3-h5py python3-scipy)
# A cluster of one node.
test_packages+=(slurm-wlm munge)
# The program that makes keys of sites.
test_packages+=(openssl)
# Independent readers and writers of MCAP, which npm installs.
command -v npm >/dev/null || test_packages+=(nodejs npm)
# For building and testing the Python module.
python_packages=(pybind11-dev python3-dev python3-numpy)
test_packages+=("${python_packages[@]}" python3-pytest mypy python3-pandas python3-matplotlib)
# Displays that die.
test_packages+=(weston qt6-wayland libsm-dev)
# For building and testing the Debian packages only.
package_packages=(help2man dpkg-dev file lintian debootstrap "${python_packages[@]}")
# For building and testing the Flatpak only.
flatpak_packages=(flatpak flatpak-builder ostree debootstrap weston xwayland)
# For fuzzing the parsers.
fuzz_packages=(clang libclang-rt-dev)

fail() {
    printf 'install_dependencies: %s\n' "$*" >&2
    exit 1
}

case "${1:-}" in
    "") ;;
    --test) packages+=("${test_packages[@]}") ;;
    --package) packages+=("${package_packages[@]}") ;;
    --flatpak) packages+=("${flatpak_packages[@]}") ;;
    --fuzz) packages+=("${fuzz_packages[@]}") ;;
    --print)
        printf '%s\n' "${build_packages[@]}"
        exit 0
        ;;
    *) fail "unknown argument '$1' (expected nothing, --test, --package, --flatpak, --fuzz or --print)" ;;
esac

if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    fail "this is not a Debian-like system (no dpkg-query or apt-get). Install what these Debian 12 packages hold, then
build with CMake: ${packages[*]}"
fi

installed=$(dpkg-query -W -f '${binary:Package} ${db:Status-Status}\n' "${packages[@]}" 2>/dev/null |
    sed -n 's/^\([^: ]*\)[^ ]* installed$/\1/p' || true)
missing=()
for package in "${packages[@]}"; do
    grep -qxF -- "$package" <<<"$installed" || missing+=("$package")
done
if ((${#missing[@]} == 0)); then
    exit 0
fi

as_root=(env DEBIAN_FRONTEND=noninteractive)
if ((EUID != 0)); then
    command -v sudo >/dev/null || fail "installing needs root rights and there is no sudo. As root, run:
apt-get update && apt-get install --no-install-recommends ${missing[*]}"
    as_root=(sudo "${as_root[@]}")
fi

printf 'Installing %d missing packages: %s\n' "${#missing[@]}" "${missing[*]}"
apt=("${as_root[@]}" apt-get -q -o DPkg::Lock::Timeout=120)
# A repository that the project does not need may be unreachable, so only a failed install counts.
"${apt[@]}" update || printf 'install_dependencies: apt-get update reported a problem, going on\n' >&2
"${apt[@]}" install -y --no-install-recommends "${missing[@]}" ||
    fail "apt-get could not install the packages (see above). It needs root rights, the network and the package sources
of Debian 12 (bookworm, main)."
