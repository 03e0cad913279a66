#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fits psychometric functions with `teleta study fit`, then with scipy, and compares results and times.

Usage: fits_against_scipy.py TELETA [PARTICIPANTS]

Both fit the same data sets (two intervals, six levels of 40 trials, weibull, lapse rate free in 0 .. 0.06) from several
starts; scipy's Nelder-Mead computes the maximum only, teleta also the profile intervals of threshold and slope and p of
the deviance from 2000 refits. Times of teleta include its start and reading the file.
"""

import json
import random
import subprocess
import sys
import tempfile
import time

import numpy
from scipy.optimize import minimize

LEVELS = numpy.array([0.02, 0.04, 0.06, 0.08, 0.12, 0.16])
TRIALS = 40


def share(log_t, log_b, lapse):
    return 0.5 + (0.5 - lapse) * (1 - 2 ** -((LEVELS / numpy.exp(log_t)) ** numpy.exp(log_b)))


def fit(correct):
    """Threshold and minus the log likelihood."""

    def minus(at):
        lapse = 0.06 / (1 + numpy.exp(-at[2]))
        p = numpy.clip(share(at[0], at[1], lapse), 1e-12, 1 - 1e-12)
        return -(correct * numpy.log(p) + (TRIALS - correct) * numpy.log(1 - p)).sum()

    best = None
    for threshold in (0.04, 0.07, 0.11):
        for slope in (1.5, 4):
            end = minimize(minus, [numpy.log(threshold), numpy.log(slope), -1], method="Nelder-Mead",
                           options={"xatol": 1e-8, "fatol": 1e-10, "maxiter": 4000, "maxfev": 4000})
            if best is None or end.fun < best.fun:
                best = end
    return float(numpy.exp(best.x[0]))


def main():
    teleta = sys.argv[1]
    people = int(sys.argv[2]) if len(sys.argv) > 2 else 20
    draw = random.Random(1)
    counts = [[sum(draw.random() < p for _ in range(TRIALS)) for p in share(numpy.log(0.07), numpy.log(3), 0.02)]
              for _ in range(people)]
    with tempfile.NamedTemporaryFile("w", suffix=".csv") as table:
        table.write("participant_id,task,condition,phase,track,level,correct\n")
        for person, correct in enumerate(counts):
            for level, right in zip(LEVELS, correct):
                for trial in range(TRIALS):
                    table.write(f"P{person:03},detect,rest,test,t1,{level},{int(trial < right)}\n")
        table.flush()
        begin = time.monotonic()
        found = json.loads(subprocess.run([teleta, "study", "fit", table.name, "--guess", "0.5", "--json"], check=True,
                                          capture_output=True, text=True).stdout)
        ours = time.monotonic() - begin
    begin = time.monotonic()
    theirs_t = [fit(numpy.array(correct)) for correct in counts]
    theirs = time.monotonic() - begin
    differences = [abs(line["threshold"] / t - 1) for line, t in zip(found["thresholds"], theirs_t) if line["threshold"]]
    print(f"{people} fits: teleta {ours:.2f} s with intervals and p, scipy {theirs:.2f} s without, "
          f"ratio {theirs / ours:.1f}; thresholds of {len(differences)} within {max(differences):.1e}")


if __name__ == "__main__":
    main()
