"""Two textbook loops on which section 2.3.6 is tried, and what happens in them over time.

The thesis's figures 2.13 and 2.14 name no plant. A relay with a third-order plant has one limit cycle, known
in closed form; a backlash with a triple lag has two, of which one is unstable.
"""

from dataclasses import dataclass
from functools import cache
from typing import Final

import control
import numpy as np

from report.numbers.time_stepping import linear_step
from trimmer import FrictionBacklash, Relay, limit_cycles, response_at
from trimmer.arrays import Complexes, Reals
from trimmer.balance.limit_cycle import LimitCycle
from trimmer.elements.element import Element

GAIN: Final = 7.0  # Static gain of the triple lag; from 8 on the loop without play would be unstable
STARTS: Final = (0.9, 1.1, 10.0)
"""Amplitudes from which the loop with backlash is simulated, over that of its first limit cycle."""
WINDOWS: Final = 32
_STEPS: Final = 200
_LOCUS_POINTS: Final = 20_001


@dataclass(frozen=True)
class TextbookLoop:
    """A plant and an element in negative feedback."""

    plant: control.TransferFunction
    element: Element

    def limit_cycles(self) -> tuple[LimitCycle, ...]:
        """Return all that harmonic balance predicts, in order of frequency."""
        return limit_cycles(self.plant, self.element)

    def inverse_element(self, amplitude: float | Reals) -> Complexes:
        """Return -1/N at amplitudes, in the plane of G."""
        return np.asarray(-1 / self.element.describing_function(amplitude))


@dataclass(frozen=True)
class History:
    """Half of peak to peak at the element's input, shape (windows, starts), in each window of time (s)."""

    times: Reals
    amplitudes: Reals


def relay_loop() -> TextbookLoop:
    """Return 1/(s (s + 1)(s + 2)) with a relay of level one: omega = sqrt 2, A = 2/(3 π)."""
    return TextbookLoop(control.tf([1], [1, 3, 2, 0]), Relay(1.0))


def backlash_loop() -> TextbookLoop:
    """Return 7/(s + 1)³ with a friction-controlled backlash of total clearance one."""
    return TextbookLoop(control.tf([GAIN], [1, 3, 3, 1]), FrictionBacklash(1.0))


def graphical_intersections(loop: TextbookLoop, omegas: Reals, amplitudes: Reals) -> Reals:
    """Intersect G and -1/N as they are drawn through samples, as chains of straight lines.

    Samples of G are at omegas, rad/s, those of -1/N at amplitudes; N must not depend on frequency.

    Returns:
        Frequency and amplitude at each intersection, interpolated along the lines, shape (intersections, 2).
    """
    locus, inverse = response_at(loop.plant, omegas), loop.inverse_element(amplitudes)
    along, across = np.diff(locus)[:, None], np.diff(inverse)[None, :]
    apart = inverse[None, :-1] - locus[:-1, None]
    with np.errstate(divide="ignore", invalid="ignore"):
        determinant = (along.conj() * across).imag
        on_locus = (apart.conj() * across).imag / determinant
        on_inverse = (apart.conj() * along).imag / determinant
    hits = np.argwhere((on_locus >= 0) & (on_locus < 1) & (on_inverse >= 0) & (on_inverse < 1))
    return np.array(
        [
            (
                omegas[row] + on_locus[row, column] * (omegas[row + 1] - omegas[row]),
                amplitudes[column] + on_inverse[row, column] * (amplitudes[column + 1] - amplitudes[column]),
            )
            for row, column in hits
        ]
    )


def encirclements_of(plant: control.TransferFunction, point: complex) -> int:
    """Count the clockwise turns of G(j omega), omega from -inf to inf, about any point off the locus.

    The locus is followed in small steps. The plant must be strictly proper, without poles on the axis.
    """
    angles = np.linspace(-np.pi / 2, np.pi / 2, _LOCUS_POINTS)[1:-1]
    response = np.concatenate([[0.0], response_at(plant, np.tan(angles)), [0.0]]) - point
    turned = np.angle(response[1:] / response[:-1])
    return -round(float(np.sum(turned)) / (2 * np.pi))


def growing_poles(loop: TextbookLoop, amplitude: float) -> int:
    """Count the roots of 1 + N G(s) in the right half plane, N frozen at an amplitude."""
    numerator, denominator = loop.plant.num[0][0], loop.plant.den[0][0]
    gain = complex(loop.element.describing_function(amplitude))
    return int(np.count_nonzero(np.roots(np.polyadd(denominator, gain * numerator)).real > 0))


@cache
def backlash_history() -> History:
    """Simulate the loop with backlash from ``STARTS``, each on the predicted oscillation scaled.

    Between two steps the play's output is taken as linear in time; the plant's flow is then exact. Nothing
    of harmonic balance but the start enters, so this is a check on it.
    """
    loop = backlash_loop()
    first = loop.limit_cycles()[0]
    step = 2 * np.pi / first.omega / _STEPS
    space = control.ss(loop.plant)
    starts = np.array(STARTS) * first.amplitude
    drive = -1 / complex(response_at(loop.plant, first.omega))
    state = np.linalg.solve(1j * first.omega * np.eye(3) - space.A, space.B * drive).real * starts
    inputs = _play_in_loop(linear_step(space.A, space.B[:, 0], step), space.C[0], state, starts)
    windows = inputs.reshape(WINDOWS, _STEPS, starts.size)
    times = np.linspace(0.5, WINDOWS - 0.5, WINDOWS) * _STEPS * step
    return History(times, np.ptp(windows, axis=1) / 2)


def _play_in_loop(flow: tuple[Reals, Reals, Reals], output: Reals, state: Reals, starts: Reals) -> Reals:
    """Return the element's input at each step, shape (steps, starts), from the peak of the input on."""
    propagate, constant, rising = flow
    half_gap = 0.5
    play = starts - half_gap
    inputs = np.empty((WINDOWS * _STEPS, starts.size))
    for index in range(len(inputs)):
        state = propagate @ state + np.outer(constant, play)
        inputs[index] = -(output @ state)
        following = np.clip(play, inputs[index] - half_gap, inputs[index] + half_gap)
        state = state + np.outer(rising, following - play)
        play = following
    return inputs
