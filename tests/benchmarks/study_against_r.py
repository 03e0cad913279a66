#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""`teleta study analyze` of a trial CSV against R, which only reads the same file and tabulates it.

    study_against_r.py TELETA [ROWS]

Each runs three times in turn; the shortest time of each counts. Prints times, ratio and largest memory.
"""
import os
import random
import subprocess
import sys
import tempfile
import time

R_PROGRAM = """
trials <- read.csv(commandArgs(trailingOnly = TRUE)[1], colClasses = "character")
counts <- table(trials$participant_id, trials$task, trials$condition, trials$stimulus, trials$response)
cat(sum(counts), "\\n")
"""


def write_trials(path, rows):
    draw = random.Random(1)
    letters = "ABCDEF"
    with open(path, "w", encoding="utf-8") as file:
        file.write("participant_id,task,condition,phase,stimulus,response,response_time_s\n")
        for row in range(rows):
            stimulus = letters[row % 6]
            response = stimulus if draw.random() < 0.7 else draw.choice(letters)
            condition = "static" if row % 12 < 6 else "dynamic"
            file.write(f"P{row * 100 // rows:03d},shape,{condition},test,{stimulus},{response},"
                       f"{draw.lognormvariate(1.0, 0.4):.6f}\n")


def run(command):
    """Seconds and largest memory in MB of one run."""
    start = time.monotonic()
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL)
    _, status, usage = os.wait4(process.pid, 0)
    if status != 0:
        raise SystemExit(f"{command[0]} failed")
    return time.monotonic() - start, usage.ru_maxrss / 1000.0


def main():
    if len(sys.argv) < 2:
        raise SystemExit(__doc__)
    rows = int(sys.argv[2]) if len(sys.argv) > 2 else 1_000_000
    with tempfile.TemporaryDirectory() as folder:
        trials = os.path.join(folder, "trials.csv")
        script = os.path.join(folder, "tabulate.R")
        write_trials(trials, rows)
        with open(script, "w", encoding="utf-8") as file:
            file.write(R_PROGRAM)
        ours = [sys.argv[1], "study", "analyze", trials, "--out", os.path.join(folder, "out")]
        theirs = ["Rscript", "--vanilla", script, trials]
        best = {"teleta": (float("inf"), 0.0), "R": (float("inf"), 0.0)}
        for _ in range(3):
            for name, command in (("teleta", ours), ("R", theirs)):
                best[name] = min(best[name], run(command))
    for name, what in (("teleta", "study analyze, everything written"), ("R", "read.csv and table")):
        print(f"{name:7} {best[name][0]:7.2f} s {best[name][1]:7.0f} MB  {what}")
    print(f"{rows} rows: R takes {best['R'][0] / best['teleta'][0]:.1f} times as long")


if __name__ == "__main__":
    main()
