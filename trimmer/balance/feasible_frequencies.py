"""At which frequencies a backlash with some load has a limit cycle: the ends of these bands, and the bands.

N(u, gamma) of a backlash fills a region of the complex plane once, for its Jacobian determinant has one sign.
The region is bounded by the loci of friction-controlled (gamma = 0) and inertia-controlled backlash (gamma
infinite) and by the stretch of the negative imaginary axis on which the pin only just touches the load. A
band of frequencies ends where -1/G crosses one of the three.
"""

import math
import warnings
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from functools import lru_cache
from itertools import pairwise

import control
import numpy as np
from scipy.optimize import brentq

from trimmer.balance.limit_cycle import LimitCycle
from trimmer.balance.loop import ComparedSystem
from trimmer.balance.solve import limit_cycles
from trimmer.elements.backlashes.backlash_motion import GAMMA_LIMITS
from trimmer.elements.backlashes.viscous_backlash import ViscousBacklash
from trimmer.errors import UndecidedWarning
from trimmer.linear import ZeroPoleGain, real_axis_crossings, response_at
from trimmer.showing.shown import Shown

_BEYOND = 1e3  # How far beyond the outermost end of a band a frequency is that stands for all beyond

_JUST_TOUCHING = 1.0 - 1e-12  # Share of the largest gap/amplitude at which the pin just touches the load

_LOG_GAMMAS = (math.log(GAMMA_LIMITS[0]), math.log(GAMMA_LIMITS[1]))


@dataclass(frozen=True, repr=False)
class BandEnd(Shown):
    """An end of a band of frequencies, with the M/D that gives a limit cycle there.

    Attributes:
        frequency: Hz; 0 or infinity where the band has no end.
        time_constant: M/D there, s; NaN where the band has no end.
        limit_cycle: That of friction- or inertia-controlled backlash; None where the pin only just touches
            the load, or the band has no end.
    """

    frequency: float
    time_constant: float
    limit_cycle: LimitCycle | None = None

    def _told(self) -> str:
        if math.isnan(self.time_constant):
            return "no end"
        return f"{self.frequency:.6g} Hz, M/D {self.time_constant:.6g} s"


@dataclass(frozen=True, repr=False)
class FeasibleBand(Shown):
    """A band of frequencies at each of which some M/D gives a limit cycle."""

    lower: BandEnd
    upper: BandEnd

    @property
    def frequencies(self) -> tuple[float, float]:
        """Lowest and highest frequency, Hz; 0 and infinity where the band has no end."""
        return self.lower.frequency, self.upper.frequency

    def holds(self, frequency: float) -> bool:
        """Say whether a frequency, Hz, lies in the band or at one of its ends."""
        return self.lower.frequency <= frequency <= self.upper.frequency

    def _told(self) -> str:
        return f"from {self.lower._told()}, to {self.upper._told()}"


def feasible_bands(
    G: control.lti.LTI, gap: float, solvable: Callable[[float], bool]
) -> tuple[FeasibleBand, ...]:
    """Find all bands of frequencies at which some M/D gives a limit cycle, in rising order.

    Those of the last few loops are kept, unless something was undecided there. ``solvable`` says whether
    some M/D gives a limit cycle at a frequency, Hz.
    """
    loop = _BandInputs(ComparedSystem.of(G), float(gap), solvable)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("error", UndecidedWarning)
            return _kept_bands(loop)
    except UndecidedWarning:
        return _bands(loop)  # which warns


@dataclass(frozen=True)
class _BandInputs:
    """A loop with a gap, and the frequencies at which some M/D gives a limit cycle."""

    given: ComparedSystem
    gap: float
    solvable: Callable[[float], bool] = field(compare=False)


def _bands(loop: _BandInputs) -> tuple[FeasibleBand, ...]:
    G, gap, solvable = loop.given.system, loop.gap, loop.solvable
    ends = sorted([*_limits(G, gap), *_touching(G)], key=lambda end: end.frequency)
    low, high = BandEnd(0.0, math.nan), BandEnd(math.inf, math.nan)
    bands: list[FeasibleBand] = []
    for lower, upper in pairwise([low, *ends, high]):
        if not solvable(_between(G, lower.frequency, upper.frequency)):
            continue
        if bands and bands[-1].upper is lower:  # -1/G touches the border, and does not leave the region
            bands[-1] = FeasibleBand(bands[-1].lower, upper)
        else:
            bands.append(FeasibleBand(lower, upper))
    return tuple(bands)


_kept_bands = lru_cache(maxsize=16)(_bands)
"""The same loop is asked for again with each frequency that was measured."""


def _limits(G: control.lti.LTI, gap: float) -> Iterator[BandEnd]:
    for time_constant in (0.0, math.inf):
        for cycle in limit_cycles(G, ViscousBacklash(gap, time_constant)):
            yield BandEnd(cycle.frequency, time_constant, cycle)


def _touching(G: control.lti.LTI) -> Iterator[BandEnd]:
    """Yield where -1/G lies on the stretch of the negative imaginary axis, with the M/D of that place."""
    for crossing in real_axis_crossings(_integrated(G)):
        size = float((1.0 / response_at(G, crossing.omega)).imag)
        smallest, largest = (_touching_size(end) for end in _LOG_GAMMAS)
        if smallest < size < largest:
            log_gamma = brentq(lambda x, size=size: _touching_size(x) - size, *_LOG_GAMMAS, xtol=1e-12)
            yield BandEnd(crossing.omega / (2.0 * math.pi), math.exp(log_gamma) / crossing.omega)


def _touching_size(log_gamma: float) -> float:
    """Return |N| where the pin only just touches the load; there N is negative imaginary."""
    element = ViscousBacklash(1.0, math.exp(log_gamma))
    largest = float(element.domain(1.0))
    return -float(element.describing_function(1.0 / (_JUST_TOUCHING * largest), 1.0).imag)


def _integrated(G: control.lti.LTI) -> control.lti.LTI:
    """Return G/s, which is real on the imaginary axis where G is imaginary."""
    if isinstance(G, control.TransferFunction):
        return control.tf(G.num[0][0], np.append(G.den[0][0], 0.0))
    A = np.block([[G.A, np.zeros((G.nstates, 1))], [G.C, np.zeros((1, 1))]])
    C = np.append(np.zeros((1, G.nstates)), [[1.0]], axis=1)
    return control.ss(A, np.vstack([G.B, G.D]), C, 0.0)


def _between(G: control.lti.LTI, lower: float, upper: float) -> float:
    """Return a frequency, Hz, between two; from 0 to infinity, one among the roots of G."""
    if lower > 0.0 and math.isfinite(upper):
        return math.sqrt(lower) * math.sqrt(upper)
    if lower > 0.0:
        return _BEYOND * lower
    if math.isfinite(upper):
        return upper / _BEYOND
    sizes = np.abs(ZeroPoleGain.of(G).roots)
    sizes = sizes[sizes > 0]
    return float(np.exp(np.log(sizes).mean()) / (2.0 * math.pi)) if sizes.size else 1.0
