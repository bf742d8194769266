"""Whether a limit cycle is stable: Loeb's criterion, and the other poles of the loop.

Let F(A, omega) = 1 + N(A, omega) G(j omega) = X + j Y. A slow change of amplitude makes omega complex: with
s = sigma + j omega, F(A + dA, omega + d omega - j sigma) = 0 gives sigma = Im(F_A / F_omega) dA. The
amplitude returns if sigma < 0 for dA > 0, that is if X_A Y_omega - X_omega Y_A > 0 (Loeb's
criterion; Gelb and Vander Velde, Multiple-Input Describing Functions, 1968, treat it).

This sees one pole pair, and only slow changes. The other poles are those of 1 + N G(s) with N frozen; N being
complex for positive frequencies, those with a positive imaginary part count. The test says nothing about
changes within one period, about an element's memory, or where the harmonics are not small; near tangency it
is undecided.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from trimmer.balance.closed_loop import closed_loop_poles

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from trimmer.balance.inverse_response import InverseResponse


def sine_of_crossing(by_amplitude: complex, by_omega: complex) -> float:
    """Sine of the angle from F_A to F_omega; positive if Loeb's criterion holds.

    Both may be multiplied by a common complex factor, and each by a positive one. NaN if one of them is 0.
    """
    cross = by_amplitude.real * by_omega.imag - by_amplitude.imag * by_omega.real
    size = abs(by_amplitude) * abs(by_omega)
    return cross / size if size else math.nan


def other_unstable_poles(
    response: InverseResponse, gains: NDArray[np.complex128], omegas: NDArray[np.float64]
) -> NDArray[np.intp]:
    """Count the poles of 1 + N G(s), N frozen, with Re s > 0 and Im s > 0, without the one at j omega.

    Args:
        response: 1/G.
        gains: N at each limit cycle.
        omegas: Their angular frequencies, rad/s.
    """
    poles = closed_loop_poles(response, gains)
    own = np.abs(poles - 1j * omegas[:, None] / response.reference).argmin(axis=1)
    poles[np.arange(gains.size), own] = 0.0
    rounding = 1e-9 * np.abs(poles)
    return np.asarray(((poles.real > rounding) & (poles.imag > rounding)).sum(axis=1))
