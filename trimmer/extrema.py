"""Resonance peaks and dips of a frequency response."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

from numpy import exp

from trimmer.stationary import stationary_gains
from trimmer.zero_pole_gain import ZeroPoleGain

if TYPE_CHECKING:
    import control


@dataclass(frozen=True)
class Extremum:
    """A local extremum of |G(j omega)|.

    Attributes:
        omega: Angular frequency, rad/s.
        magnitude: |G| there; infinite at a pole on the imaginary axis, 0 at a zero on it.
    """

    omega: float
    magnitude: float


def resonance_peaks(system: control.lti.LTI) -> tuple[Extremum, ...]:
    """Find all local maxima of |G(j omega)| for omega > 0, in order of frequency.

    Raises:
        UnsupportedSystemError: see ``trimmer.frequency_domain.require_siso``.
    """
    return tuple(_extrema(system, maxima=True))


def dips(system: control.lti.LTI) -> tuple[Extremum, ...]:
    """Find all local minima of |G(j omega)| for omega > 0, in order of frequency.

    Raises:
        UnsupportedSystemError: see ``trimmer.frequency_domain.require_siso``.
    """
    return tuple(_extrema(system, maxima=False))


def _extrema(system: control.lti.LTI, maxima: bool) -> Iterator[Extremum]:
    factored = ZeroPoleGain.of(system)
    for omega, is_maximum in stationary_gains(factored):
        if is_maximum is maxima:
            yield Extremum(omega, float(exp(factored.log_gain(omega))))
