#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a sweep costs besides its runs.

    sweep_benchmark.py TELETA [RUNS]

Runs of about 20 ms (two balls on a tactile array for 6 s), RUNS of them:
  overhead   processor time of the whole program over that of the runs alone, one worker
  workers    time by the clock with one worker over that with two
  loop       the same runs as a shell loop around `teleta simulate` (a tenth of them), processor time of one run
Runs of about 0.1 ms (the ladder of contours):
  memory     largest resident memory of 10 000 and of 100 000 runs
  merging    time by the clock to merge 100 000 runs and draw their charts, `--merge`
A million labelled frames, two workers, npz with everything that is known of their contacts:
  frames     time by the clock, frames and bytes of the shipped sweeps labelled-frames and labelled-servo-frames
"""

import csv
import glob
import os
import subprocess
import sys
import tempfile
import time

import numpy


def spent(arguments):
    """Time by the clock and of the processor in s, and largest resident memory in kB."""
    start = time.monotonic()
    process = subprocess.Popen(arguments, stdout=subprocess.DEVNULL)
    _, status, usage = os.wait4(process.pid, 0)
    if status:
        sys.exit(f"{' '.join(arguments)} failed: {status}")
    return time.monotonic() - start, usage.ru_utime + usage.ru_stime, usage.ru_maxrss


def main():
    program = sys.argv[1]
    runs = int(sys.argv[2]) if len(sys.argv) > 2 else 400
    with tempfile.TemporaryDirectory() as folder:
        path = lambda name: os.path.join(folder, name)
        with open(path("runs.toml"), "w") as file:
            file.write(f'[sweep]\nscene = "tactile-two-contacts"\nseeds = "1:{runs}"\n[sweep.vary]\nduration_s = [6.0]\n')
        one_s, processor_s, _ = spent([program, "sweep", path("runs.toml"), "--out", path("one"), "--workers", "1"])
        with open(path("one/runs.csv")) as file:
            own_s = sum(float(row["processor_s"]) for row in csv.DictReader(file))
        print(f"a run: {1000 * own_s / runs:.2f} ms; overhead: {100 * (processor_s / own_s - 1):.2f} % ({runs} runs)")
        two_s, _, _ = spent([program, "sweep", path("runs.toml"), "--out", path("two"), "--workers", "2"])
        print(f"one worker {one_s:.2f} s, two {two_s:.2f} s: ratio {one_s / two_s:.2f}")
        loop = max(runs // 10, 1)
        loop_s = sum(spent([program, "simulate", "tactile-two-contacts", "--duration", "6", "--seed", str(seed), "--json"])[1]
                     for seed in range(1, loop + 1))
        print(f"a loop of `teleta simulate`: {1000 * loop_s / loop:.1f} ms a run, {loop_s / loop / (processor_s / runs):.2f} "
              "times as much")
        for number in (10_000, 100_000):
            with open(path(f"{number}.toml"), "w") as file:
                file.write(f'[sweep]\nladder = "contour"\nseeds = "1:{number}"\n[sweep.vary]\nrung = ["approximating-8"]\n')
            arguments = [program, "sweep", path(f"{number}.toml"), "--out", path(str(number))]
            _, _, memory_kB = spent(arguments)
            print(f"{number} runs: {memory_kB / 1024:.1f} MB")
        merge_s, merge_processor_s, _ = spent(arguments + ["--merge"])
        print(f"merging 100 000 runs: {merge_s:.2f} s ({merge_processor_s:.2f} s of processor)")
        for sweep in ("labelled-frames", "labelled-servo-frames"):
            frames_s, frames_processor_s, memory_kB = spent(
                [program, "sweep", sweep, "--out", path(sweep), "--frames", "npz", "--workers", "2"])
            frames = size = 0
            for name in glob.glob(path(sweep + "/frames/*.npz")):
                with numpy.load(name) as file:
                    frames += len(file["run_time_s"])
                size += os.path.getsize(name)
            print(f"{sweep}: {frames} frames in {frames_s:.1f} s ({frames_processor_s:.1f} s of processor), "
                  f"{size / 1e6:.0f} MB on disk, {memory_kB / 1024:.0f} MB of memory")


if __name__ == "__main__":
    main()
