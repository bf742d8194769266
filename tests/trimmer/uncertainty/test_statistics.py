from __future__ import annotations

import numpy as np
import pytest

from trimmer.uncertainty.statistics import distribution_of, share_of


def test_wilsons_interval_is_that_of_a_textbook() -> None:
    # Newcombe, Statistics in Medicine 17 (1998), table I, method 3: 81 of 263, 15 of 148, 0 of 20.
    for count, total, lowest, highest in [
        (81, 263, 0.2553, 0.3662),
        (15, 148, 0.0624, 0.1605),
        (0, 20, 0, 0.1611),
    ]:
        share = share_of(count, total)
        assert share.lowest == pytest.approx(lowest, abs=5e-5)
        assert share.highest == pytest.approx(highest, abs=5e-5)


def test_intervals_of_quantiles_hold_as_often_as_they_say() -> None:
    random = np.random.default_rng(3)
    truth = -np.log(1 - np.array([0.05, 0.5, 0.95]))
    held = np.zeros(3)
    for _ in range(400):
        found = distribution_of(random.exponential(size=200))
        held += [
            each.lowest <= value <= each.highest for each, value in zip(found.quantiles, truth, strict=True)
        ]
    assert (held >= 0.93 * 400).all()
    assert (held <= 0.995 * 400).all()


def test_the_interval_of_a_median_lies_between_two_samples_in_order() -> None:
    # Of 20 samples the sixth and the fifteenth: P(6 <= B < 15) = 0.9586 for B binomial with 20 and 1/2.
    median = distribution_of(np.arange(1.0, 21.0)).quantiles[1]
    assert (median.lowest, median.highest) == (6.0, 15.0)


def test_too_few_samples_leave_an_end_open() -> None:
    found = distribution_of(np.arange(10.0))
    assert found.quantiles[0].lowest == -np.inf
    assert found.quantiles[2].highest == np.inf


def test_what_is_no_number_is_left_out() -> None:
    assert distribution_of(np.array([np.nan, np.inf])) is None
    assert distribution_of(np.array([np.nan, 2.0])).count == 1
