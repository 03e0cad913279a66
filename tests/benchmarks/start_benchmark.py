#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What it takes to start the programs, beside the least that a program does: start_benchmark.py BUILD_FOLDER [RUNS]

Runs `true`, an empty program of Qt Core, and commands of teleta and teleta-site in turn, RUNS times each (20 unless
given), and prints of each the median and the least processor time, the median time by the clock, the memory at most
(that of the linker and its libraries included) and the number of files that the dynamic linker has loaded.
BUILD_FOLDER: one with TELETA_BENCHMARKS, for example build/release. Before it prints, each command must have ended
well, and `teleta features` must have written a row for each frame.
"""

import os
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile
import time

build = pathlib.Path(sys.argv[1]).resolve()
runs = int(sys.argv[2]) if len(sys.argv) > 2 else 20
teleta = build / "app/cli/teleta"
FRAMES = 50

work = tempfile.TemporaryDirectory()
frames = pathlib.Path(work.name, "frames.csv")
subprocess.run([teleta, "simulate", "tactile-indenter", "--out", work.name + "/run"], check=True, stdout=subprocess.DEVNULL)
frames.write_text("".join(pathlib.Path(work.name, "run/frames.csv").read_text().splitlines(True)[: FRAMES + 1]))
features = pathlib.Path(work.name, "features.csv")
commands = {
    "true": ["/bin/true"],
    "an empty program of Qt Core": [build / "tests/benchmarks/empty_core"],
    "teleta --version": [teleta, "--version"],
    f"teleta features, {FRAMES} frames": [teleta, "features", frames, "--threshold", "0.3", "--out", features],
    "teleta simulate --list": [teleta, "simulate", "--list"],
    "teleta-site --version": [build / "app/site/teleta-site", "--version"],
}


def run(command):
    """Processor time and time by the clock of one process, ms."""
    begin = time.perf_counter()
    null = os.open(os.devnull, os.O_WRONLY)
    # Not a fork, whose copies of this interpreter's pages would count as the command's.
    child = os.posix_spawn(command[0], [str(word) for word in command], os.environ,
                           file_actions=[(os.POSIX_SPAWN_DUP2, null, 1)])
    _, status, usage = os.wait4(child, 0)
    os.close(null)
    assert status == 0, command
    return 1e3 * (usage.ru_utime + usage.ru_stime), 1e3 * (time.perf_counter() - begin)


def memory_MB(command):
    said = subprocess.run(["/usr/bin/time", "-f", "%M", *command], check=True, capture_output=True, text=True).stderr
    return int(said.split()[-1]) / 1024


def loaded_files(command):
    traced = subprocess.run(command, check=True, capture_output=True, text=True, env=os.environ | {"LD_DEBUG": "files"}).stderr
    return len(set(re.findall(r"calling init: (\S+)", traced)))


times = {name: [] for name in commands}
for _ in range(runs):
    for name, command in commands.items():
        times[name].append(run(command))
assert len(features.read_text().splitlines()) == FRAMES + 1

print(f"{'':32}  processor ms: median  least   clock ms   memory MB   files")
for name, command in commands.items():
    processor, clock = zip(*times[name])
    print(f"{name:32} {statistics.median(processor):21.1f} {min(processor):6.1f} {statistics.median(clock):10.1f}"
          f" {memory_MB(command):11.1f} {loaded_files(command):7}")
