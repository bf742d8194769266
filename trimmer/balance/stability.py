"""Solutions turned into limit cycles, and whether they are stable: Loeb's criterion, and the other poles.

Let F(A, omega) = 1 + N(A, omega) G(j omega) = X + j Y. A slow change of amplitude makes omega complex: with
s = sigma + j omega, F(A + dA, omega + d omega - j sigma) = 0 gives sigma = Im(F_A / F_omega) dA. The
amplitude returns if sigma < 0 for dA > 0, that is if X_A Y_omega - X_omega Y_A > 0 (Loeb's
criterion; Gelb and Vander Velde, Multiple-Input Describing Functions, 1968, treat it).

This sees one pole pair, and only slow changes. The other poles that oscillate are those of 1 + N G(s) with N
frozen; N being complex for positive frequencies, those with a positive imaginary part count. Whether the mean
runs away follows from the real poles of 1 + N_mean G(s), with the element's gain for the mean of its input
(``Element.mean_gain``). The test says nothing about changes within one period, about an element's memory, or
where the harmonics are not small; near tangency it is undecided.
"""

import math

import numpy as np

from trimmer.arrays import Complexes, Places, Reals
from trimmer.balance.inverse_response import InverseResponse
from trimmer.balance.limit_cycle import LimitCycle
from trimmer.balance.loop import LoopEquation
from trimmer.ties import levels


def closed_loop_poles(response: InverseResponse, gains: Complexes) -> Complexes:
    """Find all poles of 1 + N G(s) over ``response.reference`` at each of some N: (n, number of poles).

    G is a chain of sections: 1/(s - pole) without, then (s - zero)/(s - pole) with a zero. The
    eigenvalues of the chain in a loop are the poles; unlike a polynomial's coefficients its entries are
    of the size of the roots.
    """
    poles, without = response.poles, response.relative_degree
    first = max(without - 1, 0)
    output = np.ones(poles.size, dtype=complex)
    output[:first] = 0.0
    output[without:] = poles[without:] - response.zeros
    # A section with a zero takes all that the ones before it add to the output, one without only the last.
    place = np.arange(poles.size)
    chain = (place[:, None] > place) * output
    chain[place[1:without], place[:first]] = 1.0
    chain[place, place] = poles
    feedback = gains / response.gain
    if without == 0:
        # Where the difference vanishes a pole is at infinity; far away will do.
        difference = 1.0 + feedback
        feedback = feedback / np.where(difference == 0, np.finfo(float).eps, difference)
    loops: Complexes = np.repeat(chain[None], gains.size, axis=0)
    reached = slice(1) if without else slice(None)
    loops[:, reached] -= feedback[:, None, None] * output
    return np.asarray(np.linalg.eigvals(loops), dtype=complex)


_ROUNDING = 1e-9  # Part of a pole below which its real or imaginary part is taken for rounding

_NEARLY_REAL = 1e-7  # The same for the imaginary part of a real pole, which may be a double one


def sine_of_crossing(by_amplitude: complex, by_omega: complex) -> float:
    """Sine of the angle from F_A to F_omega, positive if Loeb's criterion holds; NaN if one of them is 0."""
    cross = by_amplitude.real * by_omega.imag - by_amplitude.imag * by_omega.real
    size = abs(by_amplitude) * abs(by_omega)
    return cross / size if size else math.nan


def other_unstable_poles(loop: LoopEquation, gains: Complexes, amplitudes: Reals, omegas: Reals) -> Places:
    """Count the unstable poles of the loop at each limit cycle, (n,), without its own pair.

    They are those of 1 + N G(s), N frozen, with Re s > 0 and Im s > 0, and the real ones of the mean.
    """
    poles = closed_loop_poles(loop.response, gains)
    own = np.abs(poles - 1j * omegas[:, None] / loop.response.reference).argmin(axis=1)
    poles[np.arange(gains.size), own] = 0.0
    rounding = _ROUNDING * np.abs(poles)
    swinging = ((poles.real > rounding) & (poles.imag > rounding)).sum(axis=1)
    return np.asarray(swinging + _drifting_poles(loop.response, loop.curve.element.mean_gain(amplitudes)))


def _drifting_poles(response: InverseResponse, mean_gains: Reals) -> Places | int:
    """Count the positive real roots of 1/G(s) + N_mean; none where N_mean is not known (NaN)."""
    on_axis = np.abs(response.roots.imag) <= _NEARLY_REAL * np.abs(response.roots)
    known = ~np.isnan(mean_gains)
    gains = np.where(known, mean_gains, 0.0)
    if not (on_axis & (response.roots.real > 0)).any() and (response.gain.real * gains >= 0).all():
        return 0
    poles = closed_loop_poles(response, gains.astype(complex))
    drifting = (poles.real > 0) & (np.abs(poles.imag) <= _NEARLY_REAL * np.abs(poles))
    return np.asarray(np.where(known, drifting.sum(axis=1), 0))


def limit_cycles_at(loop: LoopEquation, u: Reals, x: Reals) -> tuple[LimitCycle, ...]:
    """Return the limit cycles of solutions (u, x), shapes (n,), in order of frequency, then of amplitude."""
    if u.size == 0:
        return ()
    order = np.lexsort((-u, levels(np.exp(x))))
    u, x = u[order], x[order]
    inverse, slope = loop.response.value_and_slope(x)
    gain, by_u, gain_by_x = loop.curve.expansion(u, x)
    amplitudes, omegas = loop.curve.amplitude(u), np.exp(x)
    unstable = other_unstable_poles(loop, gain, amplitudes, omegas)
    # 1 + N G of the loop as it was given.
    residuals = np.abs((gain + inverse) / (inverse - loop.linear.value(omegas)))
    slopes = by_u, np.asarray(slope + gain_by_x)
    return cycles_of(amplitudes, omegas, residuals, slopes, unstable)


def cycles_of(
    amplitudes: Reals, omegas: Reals, residuals: Reals, slopes: tuple[Complexes, Complexes], others: Places
) -> tuple[LimitCycle, ...]:
    """Return limit cycles of known dF/du and dF/dx, with the other unstable poles of each; all (n,)."""
    numbers = (each.tolist() for each in (amplitudes, omegas, residuals, *slopes, others))
    cycles = []
    for amplitude, omega, residual, by_u, by_x, unstable in zip(*numbers, strict=True):
        sine = sine_of_crossing(-by_u, by_x)  # u falls with amplitude, hence the sign
        cycles.append(
            LimitCycle(
                amplitude=amplitude,
                omega=omega,
                stable=sine > 0 and unstable == 0,
                residual=residual,
                crossing_angle=math.asin(min(1.0, abs(sine))),
                index=1 if sine > 0 else -1,
                other_unstable_poles=unstable,
            )
        )
    return tuple(cycles)
