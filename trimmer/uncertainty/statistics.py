"""What samples tell of all machines: shares with their intervals, and distributions of a measure."""

from dataclasses import dataclass

import numpy as np

from trimmer.arrays import Reals

CONFIDENCE = 0.95
QUANTILES = (0.05, 0.5, 0.95)
ROUNDING = 1e-12  # Share of the largest value within which all are the same


@dataclass(frozen=True)
class Share:
    """A share of all machines, as far as samples tell.

    Attributes:
        count: Samples that belong to it.
        total: All samples.
        lowest, highest: Ends of its 95 % interval.
    """

    count: int
    total: int
    lowest: float
    highest: float

    @property
    def value(self) -> float:
        """The share of the samples."""
        return self.count / self.total


def share_of(count: int, total: int) -> Share:
    """Return a share with Wilson's interval.

    It holds for independent samples. Those of a Latin hypercube or of Sobol fill the space more evenly, so
    that for them it is too wide rather than too narrow.

    Source: Wilson, J. Am. Stat. Assoc. 22 (1927), 209-212.
    """
    from scipy.stats import binomtest

    if not total:
        return Share(count, total, lowest=0.0, highest=1.0)
    interval = binomtest(count, total).proportion_ci(CONFIDENCE, method="wilson")
    return Share(count, total, float(interval.low), float(interval.high))


@dataclass(frozen=True)
class Quantile:
    """The value below which a share of all machines lies, with the ends of its 95 % interval."""

    share: float
    value: float
    lowest: float
    highest: float


@dataclass(frozen=True)
class Distribution:
    """How a measure is distributed.

    Attributes:
        count: Samples that have it.
        mean: Mean of these.
        deviation: Standard deviation; 0 if they differ by rounding alone.
        quantiles: At the shares of ``QUANTILES``; an end is infinite where the samples are too few to tell.
    """

    count: int
    mean: float
    deviation: float
    quantiles: tuple[Quantile, ...]


def distribution_of(values: Reals) -> Distribution | None:
    """Return the distribution of a measure, from the finite ones of its values; None if there are none.

    The interval of a quantile lies between two of the sorted samples, by the binomial distribution.

    Source: David and Nagaraja, Order Statistics, 3rd ed. (2003), section 7.1.
    """
    finite = np.sort(values[np.isfinite(values)])
    if not finite.size:
        return None
    # Sums and squares of the values themselves may overflow; a power of two leaves their digits alone.
    scale = 2.0 ** min(np.frexp(np.abs(finite).max())[1], 1000)
    mean = scale * float((finite / scale).mean())
    same = finite[-1] - finite[0] <= ROUNDING * np.abs(finite).max()
    deviation = 0.0 if same else scale * float((finite / scale).std(ddof=1))
    quantiles = tuple(_quantile(finite, share) for share in QUANTILES)
    return Distribution(finite.size, mean, deviation, quantiles)


def _quantile(values: Reals, share: float) -> Quantile:
    from scipy.stats import binom

    below, above = binom.ppf([0.5 * (1 - CONFIDENCE), 0.5 * (1 + CONFIDENCE)], values.size, share).astype(int)
    lowest = float(values[below - 1]) if below >= 1 else -np.inf
    highest = float(values[above]) if above < values.size else np.inf
    return Quantile(share, float(np.quantile(values, share)), lowest, highest)
