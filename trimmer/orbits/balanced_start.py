"""Starts of the search for an orbit from harmonic balance with several harmonics."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from trimmer.arrays import Complexes, Reals
from trimmer.balance.many_harmonics.pieces import mode_on, switching_phases
from trimmer.balance.many_harmonics.steady_response import Flight, flight_of, steady_response, switch_of
from trimmer.balance.many_harmonics.trigonometric import OddPolynomial
from trimmer.errors import OrbitNotFoundError
from trimmer.loops.components.backlash_component import FREE, LOWER, UPPER, BacklashComponent
from trimmer.loops.components.corner_component import CornerComponent
from trimmer.loops.components.relay_component import MINUS, PLUS, RelayComponent
from trimmer.loops.components.switched_component import Component
from trimmer.loops.components.threshold_component import ThresholdComponent
from trimmer.loops.loops import ClosedLoop
from trimmer.orbits.guess import Start
from trimmer.orbits.multi_harmonic_balance import BalancedHarmonics, solutions

ORDERS = range(1, 17, 2)
"""Harmonics that are balanced, one after the other."""
HARMONICS = 32
"""Number of odd harmonics of the element's output that move the linear system."""
DIFFERENCE = 1e-5
"""Of phases, rad, for the velocity of a load."""
NO_STATES = np.array([])
"""Those of a component without memory, or with one that its mode is."""


def balanced_starts(loop: ClosedLoop, amplitude: float, omega: float) -> Iterator[tuple[Start, float]]:
    """Yield modes and extended states on the motion of many balanced harmonics, and its omega, rad/s.

    They serve where contact is so brief that the first harmonic alone misses it. Each is in the middle of a
    flight, a contact, or a half period of a relay, where no event is near; the longest comes first. There is
    none if no more harmonics than the first can be balanced.

    Args:
        loop: The closed loop.
        amplitude: Amplitude of the element's input, in its unit, as the first harmonic alone gives it.
        omega: Angular frequency, rad/s.
    """
    balanced = _highest(loop, amplitude, omega)
    if balanced is None:
        return
    coefficients = np.zeros(HARMONICS, dtype=complex)
    coefficients[: len(balanced.harmonics)] = balanced.harmonics
    given = OddPolynomial(coefficients)
    output = steady_response(loop.element, given, balanced.omega)
    if output is not None:
        for phase in _quiet_phases(loop, given, balanced.omega):
            yield _start(loop, given, output, balanced.omega, phase), balanced.omega


def _start(loop: ClosedLoop, given: OddPolynomial, output: Complexes, omega: float, phase: float) -> Start:
    model, layout = loop.model, loop.modes.system.layout
    state, sizes = np.zeros(layout.size), np.ones(layout.size)
    pencils = 1j * omega * given.numbers[:, None, None] * np.eye(model.nstates) - model.A
    responses = np.linalg.solve(pencils, model.B[None])[:, :, 0] * output[:, None]
    state[: model.nstates] = (np.exp(1j * phase * given.numbers) @ responses).imag
    sizes[: model.nstates] = abs(responses).sum(axis=0)
    state[-1] = 1.0
    chosen, largest = [], given.largest()
    # Of a load position, velocity, and if it slows down the share of it that remains.
    for first, component in zip(
        layout.first_states, loop.modes.system.interconnection.components, strict=True
    ):
        own = slice(first, first + component.state_count)
        mode, state[own] = _on(component, given, omega, phase)
        sizes[own] = np.array([largest, omega * largest, 1.0])[: component.state_count]
        chosen.append(mode)
    return Start(loop.modes.number(tuple(chosen)), state, sizes)


def _highest(loop: ClosedLoop, amplitude: float, omega: float) -> BalancedHarmonics | None:
    """Balance as many harmonics as there is a solution for; None if only the first."""
    best = None
    try:
        for balanced in solutions(loop.system, loop.element, (amplitude, omega), ORDERS):
            best = balanced
    except OrbitNotFoundError:
        pass
    return best if best is not None and best.order > 1 else None


def _quiet_phases(loop: ClosedLoop, given: OddPolynomial, omega: float) -> list[float]:
    """Return the middles of flight and contact of the first backlash, or of an output of a relay."""
    components = loop.modes.system.interconnection.components
    for backlash in (each for each in components if isinstance(each, BacklashComponent)):
        flight = flight_of(backlash, given, omega)
        if flight is None:
            return []
        end = flight.leave + math.pi
        middles = [0.5 * (flight.leave + flight.meet), 0.5 * (flight.meet + end)]
        return middles if flight.meet - flight.leave > end - flight.meet else middles[::-1]
    for relay in (each for each in components if isinstance(each, RelayComponent)):
        switch = switch_of(relay, given)
        return [] if switch is None else [switch + 0.5 * math.pi]
    for switched in (each for each in components if isinstance(each, ThresholdComponent)):
        switches = switching_phases(switched, given)
        return [] if switches is None else [0.5 * sum(switches)]
    return []


def _on(component: Component, given: OddPolynomial, omega: float, phase: float) -> tuple[int, Reals]:
    """Return the mode of a component at a phase, rad, and its own states."""
    match component:
        case BacklashComponent():
            flight = flight_of(component, given, omega)
            assert flight is not None, "its output was found before"
            mode, states = _of_load(flight, omega, phase, component.time_constant)
            return mode, states[: component.state_count]
        case RelayComponent():
            positive = float(given(phase, int(component.of_rate))) > 0
            return (PLUS if positive else MINUS), NO_STATES
        case CornerComponent() | ThresholdComponent():
            return mode_on(component, given, phase), NO_STATES
    return 0, NO_STATES


def _of_load(flight: Flight, omega: float, phase: float, time_constant: float) -> tuple[int, Reals]:
    """Return the mode of a load, its position, its velocity and the share of the velocity that remains."""
    turns, since = divmod(phase - flight.leave, math.pi)
    mirrored = turns % 2 == 1
    if flight.leave + since >= flight.meet:
        return (UPPER if mirrored else LOWER), np.array([0.0, 0.0, 1.0])
    around = flight.position(flight.leave + since + DIFFERENCE * np.array([-1.0, 0.0, 1.0]))
    sign = -1.0 if mirrored else 1.0
    velocity = omega * (around[2] - around[0]) / (2.0 * DIFFERENCE)
    share = math.exp(-since / (omega * time_constant)) if time_constant > 0 else 0.0
    return FREE, np.array([sign * around[1], sign * velocity, share])
