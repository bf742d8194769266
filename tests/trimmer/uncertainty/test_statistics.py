"""Shares and quantiles with their intervals."""

import numpy as np
import pytest
from scipy import stats

from trimmer.uncertainty import Share, distribution_of, share_of


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
        held += [each.lowest <= v <= each.highest for each, v in zip(found.quantiles, truth, strict=True)]
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


def test_quantiles_lie_between_samples_in_order_and_the_rest_is_that_of_the_textbook() -> None:
    values = np.random.default_rng(2).permutation(np.arange(1.0, 201.0))
    found = distribution_of(np.array([*values, np.nan, np.inf]))
    assert (found.count, found.mean) == (200, pytest.approx(100.5, rel=1e-13))
    assert found.deviation == pytest.approx(np.sqrt((200**2 - 1) / 12 * 200 / 199))
    for each, share in zip(found.quantiles, (0.05, 0.5, 0.95), strict=True):
        low, high = (int(stats.binom.ppf(part, 200, share)) for part in (0.025, 0.975))
        assert (each.share, each.lowest, each.highest) == (share, low, high + 1)
        assert each.value == pytest.approx(1 + 199 * share)


@pytest.mark.parametrize("scale", [1e-300, 1e306])
def test_sizes_do_not_matter(scale: float) -> None:
    found, usual = (distribution_of(factor * np.arange(1.0, 101.0)) for factor in (scale, 1.0))
    assert found.mean == pytest.approx(scale * usual.mean, rel=1e-12)
    assert found.deviation == pytest.approx(scale * usual.deviation, rel=1e-12)


def test_a_share_of_nothing_may_be_anything_and_one_sample_scatters_by_nothing() -> None:
    assert share_of(0, 0) == Share(0, 0, 0.0, 1.0)
    assert share_of(3, 12).value == 0.25
    one = distribution_of(np.array([np.nan, 3.0, np.inf]))
    assert (one.count, one.mean, one.deviation) == (1, 3.0, 0.0)
    median = one.quantiles[1]
    assert (median.value, median.lowest, median.highest) == (3.0, -np.inf, np.inf)
    assert distribution_of(np.array([3.0, 5.0])).deviation == pytest.approx(np.sqrt(2))
    assert distribution_of(np.array([np.nan, np.inf])) is None
