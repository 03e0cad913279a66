#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Runs a program in a session of its own: with a bus and a runtime folder in which it may start sound servers.
#   with_sound_session.sh PROGRAM [ARGUMENT...]
# 77: a package is missing, so that the test is skipped.
set -euo pipefail

for program in dbus-run-session pipewire wireplumber pw-cli jackd; do
    command -v "$program" >/dev/null || {
        printf 'with_sound_session: there is no %s\n' "$program" >&2
        exit 77
    }
done
folder=$(mktemp -d "${TMPDIR:-/tmp}/teleta-sound.XXXXXX")
trap 'rm -rf -- "$folder"' EXIT
chmod 700 "$folder"
# Nothing of the person's own session, and nothing of their settings.
export XDG_RUNTIME_DIR=$folder HOME=$folder XDG_CONFIG_HOME=$folder/config XDG_STATE_HOME=$folder/state
unset PIPEWIRE_REMOTE PIPEWIRE_QUANTUM PIPEWIRE_NODE JACK_DEFAULT_SERVER DISPLAY WAYLAND_DISPLAY
export JACK_NO_AUDIO_RESERVATION=1
dbus-run-session -- "$@"
