#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Statistics of your own trials: accuracies with intervals, information transfer, analysis of variance."""

import numpy as np
import pictures

import teleta

# Eight people identify four patterns, presented in two ways; with movement they err less often.
random = np.random.default_rng(7)
names = ["circle", "line", "point", "square"]
trials: dict[str, list[str]] = {
    name: [] for name in ("participant_id", "task", "condition", "stimulus", "response")
}
for person in range(8):
    for condition, share in (("static", 0.6), ("dynamic", 0.85)):
        for stimulus in names * 10:
            right = random.random() < share
            response = stimulus if right else str(random.choice(names))
            for column, value in zip(trials.values(), (f"P{person}", "shape", condition, stimulus, response)):
                column.append(value)

results = teleta.study.analyze(trials)
group = results.group
for i, condition in enumerate(group["condition"]):
    print(f"{condition}: {100 * group['accuracy_mean'][i]:.0f} % correct "
          f"(95 %: {100 * group['t_lo'][i]:.0f} to {100 * group['t_hi'][i]:.0f}), "
          f"{group['it_corrected_bits'][i]:.2f} bit")
print("Wilson, 30 of 40:", "{:.3f} to {:.3f}".format(*teleta.study.wilson(30, 40)))

with pictures.figure("study", 720, 340) as figure:
    for axes, condition in zip(figure.subplots(1, 2), ("static", "dynamic")):
        table = results.confusion
        own = (table["participant_id"] == "GROUP") & (table["condition"] == condition)
        own &= table["response"] != "NONE"
        axes.imshow(table["count"][own].reshape(4, 4), cmap="Blues")
        axes.set_title(condition)
        axes.set_xticks(range(4), names)
        axes.set_yticks(range(4), names)

effect = results.anova["effect"] == "condition"
print(f"condition: p < 0.001 is {bool((results.anova['p'][effect] < 0.001)[0])}")
