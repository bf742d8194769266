"""Loops that the tests share, and what to hold the solver against: phases on a grid, and a simulation."""

from __future__ import annotations

from dataclasses import dataclass

import control
import numpy as np
from scipy.linalg import expm

from trimmer import FrictionBacklash, TrimmerParameters, pin_model, response_at
from trimmer.elements import Element
from trimmer.linear import InputChannels

GAP = 4e-5
FRICTION = FrictionBacklash(GAP)
THESIS_LOOP = pin_model(TrimmerParameters.thesis(), channels=InputChannels.DISPLACEMENT_ONLY)
LOOP_WITH_BOTH_CHANNELS = pin_model(TrimmerParameters.thesis())

s = control.tf("s")
THIRD_ORDER = 1 / (s * (s + 1) * (s + 2))


def solutions_on_grid(
    G: control.lti.LTI,
    element: Element,
    omegas: tuple[float, float],
    amplitudes: tuple[float, float] | None = None,
) -> tuple[int, int]:
    """Count the cells of a fine grid round which the phase of 1 + N G turns, and the sum of their turns.

    The grid is even in ln omega, and in ln A between the given amplitudes or else in the distance of
    scale/A from both its limits. Loeb's criterion holds where the turn is positive.
    """
    omega = np.geomspace(*omegas, 1000)
    if amplitudes is None:
        place = 0.5 * (1.0 + np.cos(np.linspace(0.0, np.pi, 202)[1:-1]))
        amplitude = element.amplitude_scale / (place[:, None] * element.domain(omega))
    else:
        amplitude = np.broadcast_to(np.geomspace(*amplitudes, 200)[:, None], (200, omega.size))
    gain = element.describing_function(amplitude, np.broadcast_to(omega, amplitude.shape))
    phase = np.angle(1.0 + gain * response_at(G, omega))
    corners = (phase[:-1, :-1], phase[1:, :-1], phase[1:, 1:], phase[:-1, 1:])
    steps = (end - start for start, end in zip(corners, (*corners[1:], corners[0]), strict=True))
    turns = np.rint(sum((step + np.pi) % (2 * np.pi) - np.pi for step in steps) / (2 * np.pi))
    return int(np.abs(turns).sum()), int(turns.sum())


def resolved_by_grid(G: control.lti.LTI) -> bool:
    """Whether no pole or zero is so lightly damped that a grid would step over its resonance."""
    roots = np.concatenate([G.poles(), G.zeros()])
    return bool(np.all(np.abs(roots.real) >= 0.03 * np.abs(roots)))


@dataclass(frozen=True)
class Oscillation:
    """The end of a simulation: half of peak to peak, and angular frequency (rad/s, 0 if at rest)."""

    amplitude: float
    omega: float


def simulate_play(
    G: control.StateSpace, gap: float, amplitude: float, omega: float, duration: float, step: float
) -> Oscillation:
    """Simulate G in a loop with play, from a sinusoid on; play clamps to the pin plus or minus half the gap.

    Small fixed steps with the mean of the play's output at both ends; nothing of harmonic balance is in it.
    """
    A, B, C = G.A, G.B[:, 0], G.C[0]
    order = len(A)
    block = np.zeros((order + 1, order + 1))
    block[:order, :order], block[:order, order] = A * step, B * step
    exponential = expm(block)
    advance, push = exponential[:order, :order], exponential[:order, order]
    response = np.linalg.solve(1j * omega * np.eye(order) - A, B)
    state = (response * amplitude / (C @ response)).real
    bridge = 0.0
    pins = np.empty(int(duration / step))
    for place in range(pins.size):
        pins[place] = C @ state
        pin_next = C @ (advance @ state - push * bridge)
        bridge_next = min(max(bridge, pin_next - gap / 2), pin_next + gap / 2)
        state = advance @ state - push * (0.5 * (bridge + bridge_next))
        bridge = bridge_next
    tail = pins[-pins.size // 4 :]
    rising = np.flatnonzero((tail[:-1] < 0) & (tail[1:] >= 0))
    turns = 2 * np.pi * (rising.size - 1) / ((rising[-1] - rising[0]) * step) if rising.size > 1 else 0.0
    return Oscillation(float(np.ptp(tail)) / 2, float(turns))
