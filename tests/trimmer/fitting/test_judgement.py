"""Chi-square against noise, with lines and deviations made by hand."""

from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from scipy.stats import f

from trimmer import Signal
from trimmer.fitting.judgement import Judgement, judge
from trimmer.fitting.measured import MeasuredLines
from trimmer.fitting.stray import StrayLine

LINES = np.array([[3.0, 0.5], [1.0, 4.0j], [0.2, 1.0]]) * (1 + 0j)


def measured(
    lines: np.ndarray,
    factors: np.ndarray | None = None,
    *,
    freedom: float = 50.0,
    periods: float = 100.0,
    period_count: int = 1,
    strays: tuple[StrayLine, ...] = (),
    noiseless: bool = False,
) -> MeasuredLines:
    """Return lines, (m, outputs), whose drive of 50 Hz lasts some periods; by default with a noise of 1."""
    count, outputs = lines.shape
    samples = round(20 * periods)
    signals = {f"s{place}": Signal(np.zeros(samples), 1000.0, f"s{place}", "m") for place in range(outputs)}
    unit = np.broadcast_to(np.eye(outputs, dtype=complex), (count, outputs, outputs))
    used = unit if factors is None else factors
    return MeasuredLines(signals, 50.0, True, period_count, lines, used, freedom, strays, noiseless)


def fitted(lines: np.ndarray, chi_square: float) -> Any:
    return SimpleNamespace(lines=lines, chi_square=chi_square)


def test_the_probability_is_that_of_fishers_distribution() -> None:
    # Ten lines of two outputs, of which 50 * 0.972 / 12 share a noise; two numbers and the origin of time.
    lines = np.ones((10, 2), complex)
    found = judge(measured(lines, freedom=50.0, periods=12.0), fitted(lines, 60.0), 2)
    assert found.freedom == 2 * 20 - 3
    known = 50.0 * 10 / (50 * 0.972 / 12)
    assert found.probability == pytest.approx(f.sf(60.0 / 37 * 48 / 50, 37, known), rel=1e-9)
    assert found.reduced == pytest.approx(60.0 / 37)
    assert found.chi_square == 60.0
    assert found.explained


def test_few_lines_and_little_freedom_are_bounded_from_below() -> None:
    one = np.ones((1, 1), complex)
    found = judge(measured(one, freedom=0.5, periods=12.0), fitted(one, 2.0), 5)
    assert found.freedom == 1
    # One line shares with no other; less than one freedom counts as one, and so does less than three.
    assert found.probability == pytest.approx(f.sf(2.0 / 0.5, 1, 1.0), rel=1e-9)
    few = judge(
        measured(np.ones((2, 1), complex), freedom=30.0, periods=5.0), fitted(np.ones((2, 1)), 9.0), 1
    )
    assert few.probability == pytest.approx(f.sf(9.0 / 2 * 28 / 30, 2, 30.0), rel=1e-9)


def test_lines_that_are_missed_are_named_by_output_and_order() -> None:
    apart = np.zeros((3, 2), complex)
    apart[1, 0], apart[2, 1] = 3.0j, -2.0
    factors = np.array([[[0.5, 0.0], [0.0, 0.25]]] * 3, dtype=complex)
    record = measured(LINES, factors, freedom=50.0, period_count=2)
    found = judge(record, fitted(LINES + apart, 100.0), 1)
    assert [(each.output, each.order) for each in found.excesses] == [("s1", (3, 2)), ("s0", (2, 2))]
    assert [each.ratio for each in found.excesses] == pytest.approx([8.0, 6.0])
    assert [each.difference for each in found.excesses] == pytest.approx([2.0, 3.0])
    assert [each.share for each in found.excesses] == pytest.approx([2.0, 3.0])
    told = "more than noise is left at harmonics 3/2 of s1 (8 deviations) and 1 of s0 (6 deviations)"
    assert told in found.sentences
    assert "the measured motion repeats after 2 drive periods" in found.sentences


def test_a_share_is_that_of_the_modulus_of_the_line() -> None:
    lines = np.array([[3.0 - 4.0j], [-2.0], [0.5j]])
    found = judge(measured(lines), fitted(lines + np.array([[10.0], [8.0j], [-6.0]]), 200.0), 1)
    assert [(each.order[0], each.share) for each in found.excesses] == [(1, 2.0), (2, 4.0), (3, 12.0)]


def test_a_line_is_missed_from_what_noise_does_once_in_a_thousand() -> None:
    # With six lines each has a sixth of 1e-3; the ratio's square is twice F with 2 and nu degrees of freedom,
    # in closed form F = nu / 2 (p^(-2 / nu) - 1).
    limit = np.sqrt(2 * 25.0 * ((1e-3 / 6) ** (-2 / 50) - 1))
    for factor, count in ((0.999, 0), (1.001, 1)):
        apart = np.zeros((3, 2), complex)
        apart[0, 1] = factor * limit
        assert len(judge(measured(LINES), fitted(LINES + apart, 20.0), 1).excesses) == count


def test_what_is_left_is_told_in_per_cent_of_the_lines() -> None:
    lines = np.array([[3.0 + 0j], [4.0]])
    found = judge(measured(lines), fitted(lines + np.array([[0.3], [0.4]]), 500.0), 1)
    assert not found.explained
    assert "does not explain" in found.sentences[0]
    assert "reduced chi-square 250 with 2 degrees" in found.sentences[0]
    assert " 10 % rms of the lines is left" in found.sentences[0]
    assert len(found.sentences) == 1
    good = judge(measured(lines), fitted(lines, 2.0), 1)
    assert "explains the measurement within its noise" in good.sentences[0]
    assert good.excesses == ()


def test_lines_between_the_harmonics_are_told_apart() -> None:
    strays = (
        StrayLine("s0", 75.0, 1e-3, 90.0, (3, 2)),
        StrayLine("s1", 75.01, 1e-3, 80.0, (3, 2)),
        StrayLine("s0", 71.3, 1e-3, 70.0, None),
    )
    _, half, other = judge(measured(LINES, strays=strays), fitted(LINES, 1.0), 1).sentences
    assert "lines at 3/2 of the drive, which a motion that repeats after one drive period" in half
    assert "lines at 71.3 Hz, which are no fraction of the drive" in other
    by_itself = replace(measured(LINES, strays=strays), by_itself=True)
    told = judge(by_itself, fitted(LINES, 1.0), 1).sentences
    assert told[1:] == tuple(each.replace("drive", "vibration") for each in (half, other))


def test_six_lines_are_named_and_the_others_counted() -> None:
    lines = np.ones((8, 1), complex)
    (_, where, period) = judge(measured(lines, period_count=2), fitted(lines + 7.0, 400.0), 1).sentences
    assert where.startswith("more than noise is left at harmonics 1/2 of s0") or "1/2 (7 deviations)" in where
    assert where.endswith("3 (7 deviations), and 2 more")
    assert "repeats after 2 drive periods" in period
    strays = tuple(StrayLine("s0", 61.1 + 3.0 * number, 1e-3, 90.0, None) for number in range(8))
    told = judge(measured(LINES, strays=strays), fitted(LINES, 1.0), 1).sentences[-1]
    assert "and 2 more places" in told


def test_noise_may_do_what_happens_once_in_a_thousand() -> None:
    assert Judgement(1.0, 1, 1e-3, (), ()).explained
    assert not Judgement(1.0, 1, 0.9e-3, (), ()).explained
