"""Whether the mechanism or loop explains the measurement: chi-square, and what is left at which harmonics."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING

import numpy as np

from trimmer.fitting.measured import WINDOW_SHARE
from trimmer.fitting.stray import in_words
from trimmer.messages import listed
from trimmer.spectra.comparison import sought

if TYPE_CHECKING:
    from trimmer.fitting.measured import MeasuredLines
    from trimmer.fitting.misfit import Fitted

UNLIKELY = 1e-3  # Probability below which noise alone does not explain what is left
NAMED = 6  # Lines that a sentence names at most, the largest


@dataclass(frozen=True)
class Excess:
    """A line that the fit misses by more than the noise."""

    output: str  # Name of the output
    order: tuple[int, int]  # p and k of the line at p/k of the drive
    ratio: float  # Modulus of the difference over its standard deviation in noise, 1.4 in the mean square
    difference: float  # Modulus of the difference, in the unit of the signal
    share: float  # That over the measured line


@dataclass(frozen=True)
class Judgement:
    """How well a fit explains a measurement.

    Attributes:
        chi_square: Sum of the squares of the whitened residual.
        freedom: Number of residuals less unknowns and the origin of time.
        probability: That noise alone gives as much or more.
        excesses: Lines that are missed, largest ratio first.
        sentences: What is to be said, without full stops; the first one is the verdict.
    """

    chi_square: float
    freedom: int
    probability: float
    excesses: tuple[Excess, ...]
    sentences: tuple[str, ...]

    @property
    def reduced(self) -> float:
        """Chi-square over its degrees of freedom: about 1 where noise alone is left."""
        return self.chi_square / self.freedom

    @property
    def explained(self) -> bool:
        """Whether noise alone may be what is left."""
        return self.probability >= UNLIKELY


def judge(measured: MeasuredLines, fitted: Fitted, unknowns: int, called: str = "mechanism") -> Judgement:
    """Hold what a fit of some unknowns leaves against the noise."""
    from scipy.stats import f

    freedom = max(2 * measured.lines.size + measured.by_itself - unknowns - 1, 1)
    # Each line has a noise of its own, so that altogether many more are known than of one.
    known = max(measured.freedom * max(len(measured.lines) / _shared(measured), 1.0), 1.0)
    # Weights that are estimated are too large in the mean, which makes chi-square larger.
    inflated = measured.freedom / max(measured.freedom - 2.0, 1.0)
    probability = float(f.sf(fitted.chi_square / (inflated * freedom), freedom, known))
    excesses = _excesses(measured, fitted)
    judged = Judgement(fitted.chi_square, freedom, probability, excesses, ())
    sentences = tuple(_sentences(measured, fitted, judged, called))
    return Judgement(fitted.chi_square, freedom, probability, excesses, sentences)


def _shared(measured: MeasuredLines) -> float:
    """Return how many lines share the noise that is seen between two of them."""
    bins = measured.freedom * WINDOW_SHARE / 2
    return max(bins / max(measured.periods, 1.0), 1.0)


def _excesses(measured: MeasuredLines, fitted: Fitted) -> tuple[Excess, ...]:
    """Return the lines that noise alone would miss as far with a probability of 1e-3 among all of them."""
    from scipy.stats import f

    apart = abs(fitted.lines - measured.lines)
    ratios = apart / measured.deviations
    limit = np.sqrt(2 * f.isf(UNLIKELY / ratios.size, 2, measured.freedom))
    found = [
        Excess(
            measured.outputs[place],
            (int(row) + 1, measured.period_count),
            float(ratios[row, place]),
            float(apart[row, place]),
            float(apart[row, place] / abs(measured.lines[row, place])),
        )
        for row, place in np.argwhere(ratios > limit)
    ]
    return tuple(sorted(found, key=lambda each: -each.ratio))


def _sentences(measured: MeasuredLines, fitted: Fitted, judged: Judgement, called: str) -> Iterator[str]:
    left = float(np.linalg.norm(fitted.lines - measured.lines) / np.linalg.norm(measured.lines))
    told = f"reduced chi-square {judged.reduced:.3g} with {judged.freedom} degrees of freedom"
    if judged.explained:
        yield f"the {called} explains the measurement within its noise: {told}"
    else:
        yield (
            f"the {called} does not explain the measurement: {told}, where noise alone gives about 1; "
            f"{100 * left:.2g} % rms of the lines is left. The intervals know of the noise alone, and not of "
            f"what the {called} lacks"
        )
    if judged.excesses:
        yield f"more than noise is left {_where(judged)}"
    what, _ = sought(measured.by_itself)
    named = dict.fromkeys("{}/{}".format(*each.fraction) for each in measured.strays if each.fraction)
    if measured.period_count > 1:
        yield f"the measured motion repeats after {measured.period_count} drive periods"
    if named:
        yield (
            f"the measurement has lines at {_first(named)} of the {what}, which a motion that repeats after "
            f"{in_words(measured.period_count, what)} does not have"
        )
    others = [each for each in measured.strays if each.fraction is None]
    if others:
        told = _first(dict.fromkeys(f"{each.frequency:.4g} Hz" for each in others))
        yield f"the measurement has lines at {told}, which are no fraction of the {what}; they are left out"


def _first(names: Iterable[str]) -> str:
    """List the first names, and say how many follow."""
    every = list(names)
    more = [] if len(every) <= NAMED else [f"{len(every) - NAMED} more places"]
    return listed([*every[:NAMED], *more])


def _where(judged: Judgement) -> str:
    several = len({each.output for each in judged.excesses}) > 1
    named = [
        f"{Fraction(*each.order)}{f' of {each.output}' if several else ''} ({each.ratio:.3g} deviations)"
        for each in judged.excesses[:NAMED]
    ]
    more = len(judged.excesses) - len(named)
    word = "harmonic" if len(named) == 1 else "harmonics"
    return f"at {word} {listed(named)}{f', and {more} more' if more else ''}"
