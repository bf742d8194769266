"""Means of correlated series with their uncertainty."""

from dataclasses import dataclass

import numpy as np

from trimmer.arrays import Reals

BATCHES = 16  # Least number of batches
TIMES = 4.0  # Length of a batch in times of correlation, if there are enough data
NORMAL_95 = 1.959963984540054


@dataclass(frozen=True)
class Estimate:
    """A number that was estimated.

    Attributes:
        value: The estimate.
        uncertainty: Its standard error.
    """

    value: float
    uncertainty: float

    @property
    def interval(self) -> tuple[float, float]:
        """The confidence interval of 95 %."""
        return self.value - NORMAL_95 * self.uncertainty, self.value + NORMAL_95 * self.uncertainty


def mean_of(series: Reals) -> Estimate:
    """Return the mean of a series, (count,), with its standard error by means of batches.

    The batches are some times of correlation long; with too few data for that the largest error of some
    lengths of batches is taken.
    """
    count = len(series)
    if count < 2 * BATCHES:
        return Estimate(
            float(series.mean()), float(series.std(ddof=1) / np.sqrt(count)) if count > 1 else 0.0
        )
    wanted = int(np.ceil(TIMES * correlation_time(series)))
    longest = count // BATCHES
    lengths = [wanted] if wanted <= longest else [longest, longest // 2, max(longest // 4, 1)]
    return Estimate(float(series.mean()), max(_error(series, length) for length in lengths))


def correlation_time(series: Reals) -> float:
    """Return the time of correlation of a series in its steps: 1 for one without correlation.

    The sum ends where pairs of correlations are no longer positive (Geyer, Stat. Sci. 7, 1992).
    """
    apart = series - series.mean()
    variance = float(apart @ apart)
    if variance == 0:
        return 1.0
    total = -1.0
    for lag in range(0, len(series) // 4, 2):
        pair = sum(float(apart[: len(apart) - each] @ apart[each:]) for each in (lag, lag + 1)) / variance
        if pair <= 0:
            break
        total += 2 * pair
    return max(total, 1.0)


def _error(series: Reals, length: int) -> float:
    batches = len(series) // length
    means = series[len(series) - batches * length :].reshape(batches, length).mean(axis=1)
    return float(means.std(ddof=1) / np.sqrt(batches))
