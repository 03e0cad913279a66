# SPDX-License-Identifier: GPL-3.0-or-later
"""Statistics against values of other programs and of closed forms."""

from __future__ import annotations

import numpy as np
import pytest

import teleta
from teleta import study


def bits(matrix: np.ndarray) -> float:
    """Mutual information of the shares, by its definition."""
    shares = matrix / matrix.sum()
    products = np.outer(shares.sum(axis=1), shares.sum(axis=0))
    some = shares > 0
    return float((shares[some] * np.log2(shares[some] / products[some])).sum())


@pytest.mark.parametrize("k, n", [(0, 10), (7, 20), (20, 20), (123, 400)])
def test_wilson_has_the_roots_of_its_equation(k, n):
    z2 = 1.959963984540054**2
    share = k / n
    for root in study.wilson(k, n):
        rest = (1.0 + z2 / n) * root**2 - (2.0 * share + z2 / n) * root + share**2
        assert abs(rest) < 1e-14


@pytest.mark.parametrize("k, n", [(0, 10), (7, 20), (20, 20), (123, 400)])
def test_clopper_and_pearson_have_their_tails(k, n):
    from math import comb

    def at_least(low: float) -> float:
        return sum(comb(n, i) * low**i * (1.0 - low) ** (n - i) for i in range(k, n + 1))

    low, high = study.clopper_pearson(k, n)
    assert low == 0.0 if k == 0 else at_least(low) == pytest.approx(0.025, rel=1e-9)
    if k == n:
        assert high == 1.0
    else:
        below = sum(comb(n, i) * high**i * (1.0 - high) ** (n - i) for i in range(k + 1))
        assert below == pytest.approx(0.025, rel=1e-9)


@pytest.mark.parametrize("k, n, confidence", [(3, 2, 0.95), (-1, 5, 0.95), (0, 0, 0.95), (1, 5, 1.0)])
def test_impossible_counts_are_refused(k, n, confidence):
    for interval in (study.wilson, study.clopper_pearson):
        with pytest.raises(ValueError, match="k: expected"):
            interval(k, n, confidence)


def test_information_transfer_is_the_mutual_information():
    matrix = np.array([[18, 2, 1, 0], [3, 14, 2, 1], [0, 4, 16, 1]])
    found = study.information_transfer(matrix)
    assert found.it_bits == pytest.approx(bits(matrix), abs=1e-14)
    assert found.it_corrected_bits == pytest.approx(found.it_bits - found.it_bias_bits, abs=1e-14)
    assert study.information_transfer([[5, 0], [0, 5]]).it_bits == 1.0
    with pytest.raises(teleta.RefusedError):
        study.information_transfer(np.zeros((2, 2)))
    with pytest.raises(ValueError, match="matrix"):
        study.information_transfer([[1, 2, 3, 4]])
    with pytest.raises(ValueError, match="whole counts"):
        study.information_transfer([[0.5]])


def test_anova_of_two_levels_is_the_square_of_the_paired_t():
    random = np.random.default_rng(4)
    first, second = random.normal(0.0, 1.0, 8), random.normal(0.6, 1.0, 8)
    table = {
        "participant_id": [f"P{i}" for i in range(8)] * 2,
        "level": ["a"] * 8 + ["b"] * 8,
        "value": np.concatenate([first, second]),
    }
    difference = second - first
    t = difference.mean() / (difference.std(ddof=1) / np.sqrt(8.0))
    found = study.repeated_anova(table)
    assert found["effect"].tolist() == ["level"]
    assert found["f"][0] == pytest.approx(t**2, rel=1e-12)
    assert (found["df1"][0], found["df2"][0], found["n"][0]) == (1.0, 7.0, 8)


def test_anova_of_two_factors_partitions_the_squares():
    random = np.random.default_rng(5)
    cells = random.normal(0.0, 1.0, (6, 2, 3)) + np.array([0.0, 1.0, 2.0])
    people, first, second = np.meshgrid(np.arange(6), ["x", "y"], ["a", "b", "c"], indexing="ij")
    found = study.repeated_anova(
        {
            "participant_id": people.ravel(),
            "condition": first.ravel(),
            "stimulus": second.ravel(),
            "value": cells.ravel(),
        }
    )
    assert found["effect"].tolist() == ["condition", "stimulus", "condition:stimulus"]
    participants = 6.0 * ((cells.mean(axis=(1, 2)) - cells.mean()) ** 2).sum()
    total = ((cells - cells.mean()) ** 2).sum()
    assert found["ss"].sum() + found["ss_error"].sum() + participants == pytest.approx(total, rel=1e-12)
    assert found["f"][1] > found["f"][0]


def test_tables_that_do_not_fit_are_refused():
    table = {"participant_id": ["P1", "P1"], "level": ["a", "a"], "value": [1.0, 2.0]}
    with pytest.raises(ValueError, match="several"):
        study.repeated_anova(table)
    with pytest.raises(KeyError, match="score"):
        study.repeated_anova(table, value="score")
    with pytest.raises(teleta.RefusedError):
        study.repeated_anova({"participant_id": ["P1", "P2"], "level": ["a", "a"], "value": [1.0, 2.0]})
    with pytest.raises(KeyError, match="response"):
        study.analyze({"participant_id": [], "task": [], "condition": [], "stimulus": []})
    with pytest.raises(teleta.BadInputError, match="no completed trials"):
        study.analyze(
            {name: [] for name in ("participant_id", "task", "condition", "stimulus", "response")}
        )


def test_a_table_gives_what_its_file_gives(tmp_path):
    random = np.random.default_rng(6)
    rows = []
    for person in range(5):
        for condition in ("dynamic", "static"):
            for stimulus in "ABC":
                for _ in range(4):
                    response = stimulus if random.random() < 0.7 else random.choice(["A", "B", "C", "NONE"])
                    rows.append((f"P{person}", "shape", condition, "test", stimulus, response))
    names = ("participant_id", "task", "condition", "phase", "stimulus", "response")
    path = tmp_path / "trials.csv"
    path.write_text("\n".join(",".join(row) for row in [names, *rows]) + "\n")
    by_file = study.analyze(path)
    by_table = study.analyze({name: [row[i] for row in rows] for i, name in enumerate(names)})
    for name in ("summary", "group", "confusion", "anova"):
        first, second = getattr(by_file, name), getattr(by_table, name)
        for column in first:
            np.testing.assert_array_equal(first[column], second[column], err_msg=f"{name}.{column}")
    correct = sum(row[4] == row[5] for row in rows if row[0] == "P0" and row[2] == "static")
    at = (by_file.summary["participant_id"] == "P0") & (by_file.summary["condition"] == "static")
    assert by_file.summary["n_correct"][at].tolist() == [correct]


def test_two_studies_of_the_same_name_are_refused(tmp_path):
    path = tmp_path / "trials.csv"
    path.write_text(
        "participant_id,session_id,trial,attempt,task,condition,phase,stimulus,response\n"
        "P1,1,1,1,shape,static,test,A,A\n"
    )
    with pytest.raises(teleta.RefusedError):
        study.analyze([path, path])
