"""Where the gain and the phase of a system are stationary: all places at once, without a frequency grid.

With F = G'/G, a sum of simple fractions over zeros and poles, d ln|G|/d omega = -Im F(j omega) and
d(phase)/d omega = Re F(j omega). For real coefficients these vanish where F(s) - F(-s) and F(s) + F(-s) do.
The zeros of such a sum are the eigenvalues of an arrowhead pencil. They are only used to part the frequency
axis: what is returned is the sign change of the derivative itself between two of them.
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from itertools import pairwise

import control
import numpy as np
from numpy import exp
from scipy.linalg import eigvals
from scipy.optimize import brentq

from trimmer.arrays import Complexes, Reals
from trimmer.linear.zero_pole_gain import ZeroPoleGain
from trimmer.showing.shown import ShownFields

_ROUNDING = 1e-13
"""Ratio of a sum to the sum of its terms' magnitudes below which its sign is taken for rounding."""

_NEGLIGIBLE = 1e-9
"""Share of the smallest root below which a place is taken for the origin: slopes keep their signs there."""

_SAME = 16 * np.finfo(float).eps
"""Relative distance within which a root that was polished is that of a known one."""


def polished_root(function: Callable[[float], float], lower: float, upper: float) -> float:
    """Find the sign change of a function between two frequencies, rad/s, to the last digits, at any scale."""
    tolerance = 4 * np.finfo(float).eps
    return float(brentq(function, lower, upper, xtol=np.finfo(float).tiny, rtol=tolerance, maxiter=1000))


def stationary_gains(system: ZeroPoleGain) -> Iterator[tuple[float, bool]]:
    """Yield each frequency (rad/s, > 0, rising) where |G| has a local extremum, and whether it is a maximum.

    A pole on the imaginary axis counts as a maximum, a zero there as a minimum.
    """
    places = np.concatenate([system.roots, -system.roots])
    residues = np.concatenate([system.exponents, system.exponents])
    on_axis = [float(root.imag) for root in system.roots if root.real == 0]
    for omega, falls in _sign_changes(
        system.log_gain_slope_terms, system, _zeros_of_fractions(places, residues)
    ):
        nearest = min(on_axis, key=lambda root: abs(root - omega), default=omega)
        yield (nearest if abs(nearest - omega) <= _SAME * omega else omega), falls


def stationary_phases(system: ZeroPoleGain) -> Iterator[float]:
    """Yield each frequency (rad/s, > 0, rising) where the phase has a local extremum."""
    places = np.concatenate([system.roots, -system.roots])
    residues = np.concatenate([system.exponents, -system.exponents])
    for omega, _ in _sign_changes(system.phase_slope_terms, system, _zeros_of_fractions(places, residues)):
        yield omega


def _zeros_of_fractions(places: Complexes, residues: Reals) -> Complexes:
    """Zeros of the sum of residue/(s - place) (Klein, A note on zeros of barycentric forms; as in AAA)."""
    magnitudes = np.abs(places[places != 0])
    if magnitudes.size == 0:
        return np.empty(0, dtype=complex)
    scale = np.exp(np.log(magnitudes).mean())
    arrowhead = np.zeros((places.size + 1, places.size + 1), dtype=complex)
    arrowhead[0, 1:] = residues
    arrowhead[1:, 0] = 1.0
    arrowhead[1:, 1:] = np.diag(places / scale)
    weight = np.eye(places.size + 1)
    weight[0, 0] = 0.0
    with np.errstate(divide="ignore", invalid="ignore"):
        zeros = eigvals(arrowhead, weight) * scale
    return np.asarray(zeros[np.isfinite(zeros)])


def _sign_changes(
    terms: Callable[[float], Reals], system: ZeroPoleGain, candidates: Complexes
) -> Iterator[tuple[float, bool]]:
    """Yield (omega, falls) for each sign change of a sum of terms; each lies beside one of the candidates."""
    sizes = np.abs(system.roots)
    beside = np.concatenate([candidates.imag, system.roots.imag, sizes])
    beside = np.unique(beside[beside > _NEGLIGIBLE * sizes[sizes > 0].min(initial=np.inf)])
    if beside.size == 0:
        return
    between = np.sqrt(beside[:-1]) * np.sqrt(beside[1:])
    told: list[tuple[float, bool]] = []
    for omega in (beside[0] / 2, *between, beside[-1] * 2):
        values = terms(omega)
        if abs(values.sum()) > _ROUNDING * np.abs(values).sum():
            told.append((omega, bool(values.sum() < 0)))
    for (lower, fell), (upper, falls) in pairwise(told):
        if falls is not fell:
            yield polished_root(lambda x: float(terms(x).sum()), lower, upper), falls


@dataclass(frozen=True)
class Extremum(ShownFields):
    """A local extremum of |G(j omega)|.

    Attributes:
        omega: Angular frequency, rad/s.
        magnitude: |G| there, in the unit of output over input; infinite at a pole on the imaginary axis, 0 at
            a zero on it.
    """

    omega: float
    magnitude: float


def resonance_peaks(system: control.lti.LTI) -> tuple[Extremum, ...]:
    """Find all local maxima of |G(j omega)| for omega > 0, in order of frequency.

    Raises:
        UnsupportedSystemError: see ``trimmer.linear.frequency_response.require_siso``.
    """
    return tuple(_extrema(system, maxima=True))


def antiresonances(system: control.lti.LTI) -> tuple[Extremum, ...]:
    """Find all local minima of |G(j omega)| for omega > 0, in order of frequency.

    Raises:
        UnsupportedSystemError: see ``trimmer.linear.frequency_response.require_siso``.
    """
    return tuple(_extrema(system, maxima=False))


def _extrema(system: control.lti.LTI, maxima: bool) -> Iterator[Extremum]:
    factored = ZeroPoleGain.of(system)
    for omega, is_maximum in stationary_gains(factored):
        if is_maximum is maxima:
            yield Extremum(omega, float(exp(factored.log_gain(omega))))
