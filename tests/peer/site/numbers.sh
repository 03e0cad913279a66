#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# What a robot at another place costs in time, in one run: DDS over loopback, rest after the commands are cut,
# touch to bracelet over a link of 20 ms with 1 % loss. About 20 minutes. With a real-time priority where it
# is permitted; the links need root.
#   numbers.sh BUILD_FOLDER [SEEDS]      default: 10
set -euo pipefail
build=$(readlink -f "$1")
export TELETA_LOOP_SEEDS=${2:-10}
urgent=()
if chrt -f 20 true 2>/dev/null; then
    urgent=(chrt -f 20)
fi
echo "load average $(cut -d' ' -f1-3 /proc/loadavg), real-time priority: ${urgent[*]:-none}"
"${urgent[@]}" "$build/tests/benchmarks/dds_benchmark" 20
TELETA_FAILURE_ROW="link cut" "${urgent[@]}" "$build/tests/peer/loop/failure_table_test" | grep '^|'
"${urgent[@]}" "$build/tests/peer/loop/closed_loop_test" | grep -v '^\['
