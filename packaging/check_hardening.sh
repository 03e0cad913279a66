#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Checks that programs and modules were built with Debian's hardening flags, by what the linker and the compiler left in them.
#   check_hardening.sh PROGRAM...     exit code 1 when something is missing
# Needs readelf and objdump (binutils).
set -uo pipefail
export LC_ALL=C

missing=0
# wants PROGRAM WHAT PATTERN TEXT
wants() {
    grep -qE -- "$3" <<<"$4" && return
    printf '%s: %s is missing\n' "$1" "$2"
    missing=1
}

for program in "$@"; do
    if ! header=$(readelf -hW "$program" 2>&1); then
        printf '%s\n' "$header"
        missing=1
        continue
    fi
    segments=$(readelf -lW "$program")
    dynamic=$(readelf -dW "$program")
    symbols=$(readelf --dyn-syms -W "$program")
    kind='Position-Independent'
    [[ $program != *.so ]] || kind='Shared object'
    wants "$program" 'PIE' "Type: +DYN .*$kind" "$header"
    wants "$program" 'RELRO' 'GNU_RELRO' "$segments"
    wants "$program" 'BIND_NOW' '\(FLAGS\).*BIND_NOW|\(BIND_NOW\)|\(FLAGS_1\).*NOW' "$dynamic"
    wants "$program" 'a stack that is not executable' 'GNU_STACK .* RW +0x' "$segments"
    wants "$program" 'the stack protector' '__stack_chk_fail' "$symbols"
    wants "$program" 'FORTIFY_SOURCE' '__[a-z]+_chk(@| |$)' "$(grep -v __stack_chk_fail <<<"$symbols")"
    if grep -q 'X86-64' <<<"$header"; then
        # Static libraries of others may lack the mark, and then the linker leaves it out of the whole; so count.
        landings=$(objdump -d -j .text --no-show-raw-insn "$program" | grep -c 'endbr64')
        ((landings >= 16)) || {
            printf '%s: CET is missing (%d landings of indirect branches)\n' "$program" "$landings"
            missing=1
        }
    fi
done
exit "$missing"
