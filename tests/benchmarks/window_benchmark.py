#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What it takes until the console's window is shown, beside an empty window of Qt: window_benchmark.py BUILD_FOLDER [RUNS]

Starts both in turn, RUNS times (10 unless given), on a screen in memory with OpenGL in software, and prints of each the
median and the least processor time and time by the clock from the begin of the process to its first picture, and the
memory at most of the whole run. BUILD_FOLDER: one with TELETA_BENCHMARKS, for example build/release. Needs Xvfb and GNU time.
"""

import json
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile

build = pathlib.Path(sys.argv[1]).resolve()
runs = int(sys.argv[2]) if len(sys.argv) > 2 else 10
console = build / "app/console/teleta-console"
commands = {
    "an empty window": [build / "tests/benchmarks/empty_window"],
    "the console": [console, "--fresh", "--measure", "0.5"],
    "the console, Patterns": [console, "--fresh", "--page", "patterns", "--measure", "0.5"],
    "the console, a scene": [console, "--fresh", "--scene", "teleta-touch", "--measure", "0.5"],
}

read_end, write_end = os.pipe()
with tempfile.TemporaryDirectory() as home:
    # It chooses a free number itself and says which.
    screen = subprocess.Popen(["Xvfb", "-displayfd", str(write_end), "-screen", "0", "1600x1000x24", "-nolisten", "tcp"],
                              pass_fds=[write_end], stderr=subprocess.DEVNULL)
    os.close(write_end)
    try:
        number = os.fdopen(read_end).readline().strip()
        environment = os.environ | {"DISPLAY": ":" + number, "QT_QPA_PLATFORM": "xcb", "LIBGL_ALWAYS_SOFTWARE": "1",
                                    "HOME": home, "XDG_RUNTIME_DIR": home}
        measured = {name: [] for name in commands}
        for _ in range(runs):
            for name, command in commands.items():
                done = subprocess.run(["/usr/bin/time", "-f", "%M", *command], env=environment, check=True,
                                      capture_output=True, text=True)
                said = json.loads(done.stdout)
                measured[name].append((1e3 * said["first_window_processor_s"], 1e3 * said["first_window_s"],
                                       int(done.stderr.split()[-1]) / 1024))
    finally:
        screen.terminate()
        screen.wait()

print(f"{'':24} processor ms: median  least  clock ms: median  least   memory MB")
for name, rows in measured.items():
    processor, clock, memory = zip(*rows)
    print(f"{name:24} {statistics.median(processor):20.0f} {min(processor):6.0f} {statistics.median(clock):17.0f}"
          f" {min(clock):6.0f} {statistics.median(memory):11.0f}")
