# SPDX-License-Identifier: GPL-3.0-or-later
# Sourced by the other scripts: makes a Debian 12 in a folder with debootstrap, and runs commands in it. Needs root rights,
# and fail() of the script that sources it.
# shellcheck shell=bash

# The mirror that this machine uses for a suite, since it may reach no other.
mirror_of() {
    local mirror
    mirror=$(apt-cache policy | sed -nE "0,/$1\/main/s/^ *[0-9]+ ([^ ]+) $1\/main .*/\1/p")
    printf '%s' "${mirror:-$2}"
}

# make_tree FOLDER: a minimal Debian 12, with the updates of its suite.
make_tree() {
    local main=http://deb.debian.org/debian updates security
    main=$(mirror_of bookworm "$main")
    updates=$(mirror_of bookworm-updates "$main")
    security=$(mirror_of bookworm-security http://deb.debian.org/debian-security)
    rm -rf --one-file-system -- "$1"
    debootstrap --variant=minbase bookworm "$1" "$main" >"$1.log" 2>&1 || fail "debootstrap failed, see $1.log"
    printf 'deb %s bookworm main\ndeb %s bookworm-updates main\ndeb %s bookworm-security main\n' \
        "$main" "$updates" "$security" >"$1/etc/apt/sources.list"
    # No service that is installed in there may start.
    printf '#!/bin/sh\nexit 101\n' >"$1/usr/sbin/policy-rc.d"
    chmod 755 "$1/usr/sbin/policy-rc.d"
}

mounted=()
# leave_tree: unmounts what enter_tree mounted.
leave_tree() {
    local place
    for place in "${mounted[@]}"; do umount "$place"; done
    mounted=()
}

# enter_tree FOLDER: commands can be run in it with `inside`, and apt-get there reaches the mirrors as it does here.
enter_tree() {
    local file place
    tree=$1
    for file in /etc/resolv.conf /etc/hosts; do cp "$file" "$tree$file"; done
    cp -r /etc/apt/apt.conf.d/. "$tree/etc/apt/apt.conf.d/"
    trap leave_tree EXIT
    for place in proc dev dev/pts; do
        mount --bind "/$place" "$tree/$place"
        mounted=("$tree/$place" "${mounted[@]}")
    done
}

inside() { chroot "$tree" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C DEBIAN_FRONTEND=noninteractive "$@"; }
