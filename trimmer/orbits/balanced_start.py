"""Starts of the search for an orbit from harmonic balance with several harmonics."""

import math
from collections.abc import Callable, Iterator, Sequence
from itertools import groupby

import numpy as np

from trimmer.arrays import Complexes, Reals
from trimmer.balance.many_harmonics.feedback import BalancedMotion
from trimmer.balance.many_harmonics.pieces import mode_on
from trimmer.balance.many_harmonics.steady_response import Flight, flight_of, steady_response
from trimmer.balance.many_harmonics.trigonometric import OddPolynomial
from trimmer.elements.element import Element
from trimmer.errors import OrbitNotFoundError
from trimmer.loops import ClosedLoop, Feedback
from trimmer.loops.components.backlash_component import FREE, LOWER, UPPER, BacklashComponent
from trimmer.loops.components.corner_component import CornerComponent
from trimmer.loops.components.of_elements import components_of
from trimmer.loops.components.relay_component import MINUS, PLUS, RelayComponent
from trimmer.loops.components.switched_component import Component
from trimmer.loops.components.threshold_component import ThresholdComponent
from trimmer.orbits.guess import Start
from trimmer.orbits.multi_harmonic_balance import BalancedHarmonics, solutions

ORDERS = range(1, 17, 2)  # Harmonics that are balanced, one after the other
HARMONICS = 32  # Number of odd harmonics of the element's output that move the linear system
DIFFERENCE = 1e-5  # Of phases, rad, for the velocity of a load
Place = Callable[[float], tuple[int, Reals]]  # Mode of a component at a phase, rad, and its own states
PHASES = 128  # Phases of half a period at which it is seen which components switch in between
TRIED = 2  # Of the times without a switch the longest, in whose middles a search begins
NO_STATES = np.array([])  # Those of a component without memory, or with one that its mode is


def balanced_starts(loop: ClosedLoop, amplitude: float, omega: float) -> Iterator[tuple[Start, float]]:
    """Yield modes and extended states on the motion of many balanced harmonics, and its omega, rad/s.

    They serve where contact is so brief that the first harmonic alone misses it. Each is in the middle of a
    time without a switch; the longest comes first. There is none if no more harmonics than the first can be
    balanced.

    Args:
        loop: The closed loop.
        amplitude: Amplitude of the element's input, in its unit, as the first harmonic alone gives it.
        omega: Angular frequency, rad/s.
    """
    balanced = _highest(loop, amplitude, omega)
    if balanced is not None:
        yield from _starts(loop, [loop.element], [balanced.harmonics], balanced.omega)


def starts_of_motion(loop: Feedback, motion: BalancedMotion) -> Iterator[tuple[Start, float]]:
    """Yield the same on a motion of several elements whose harmonics balance."""
    yield from _starts(loop, list(loop.elements.values()), list(motion.inputs.values()), motion.omega)


def _starts(
    loop: ClosedLoop | Feedback, elements: Sequence[Element], inputs: Sequence[Complexes], omega: float
) -> Iterator[tuple[Start, float]]:
    """Yield starts where the harmonics of the input of each element are known."""
    of_velocity = isinstance(loop, Feedback)
    given = [OddPolynomial(np.pad(each, (0, HARMONICS - len(each)))) for each in inputs]
    pairs = list(zip(elements, given, strict=True))
    outputs = [steady_response(each, its, omega, of_velocity) for each, its in pairs]
    pushes = [each for each in outputs if each is not None]
    if len(pushes) < len(outputs):
        return
    fed = [(part, its) for each, its in pairs for part, _ in components_of(each, of_velocity)]
    parts, layout = loop.modes.system.interconnection.components, loop.modes.system.layout
    fed = [(part, its) for part, (_, its) in zip(parts, fed, strict=True)]
    places = [_place_of(part, its, omega) for part, its in fed]
    harmonics = _plant_harmonics(loop, pushes, omega)
    sizes = np.ones(layout.size)
    sizes[: layout.order] = abs(harmonics).sum(axis=0)
    # Of a load position, velocity, and if it slows down the share of it that remains.
    for first, (part, its) in zip(layout.first_states, fed, strict=True):
        own = np.array([its.largest(), omega * its.largest(), 1.0])
        sizes[first : first + part.state_count] = own[: part.state_count]
    for phase in _quiet_phases(places):
        state = np.zeros(layout.size)
        state[: layout.order] = (np.exp(1j * phase * given[0].numbers) @ harmonics).imag
        there = [place(phase) for place in places]
        for first, (_, own) in zip(layout.first_states, there, strict=True):
            state[first : first + len(own)] = own
        yield Start(loop.modes.number(tuple(mode for mode, _ in there)), state, sizes), omega


def _plant_harmonics(loop: ClosedLoop | Feedback, outputs: Sequence[Complexes], omega: float) -> Complexes:
    """Return the complex amplitudes of the states of the linear system, (harmonics, n)."""
    A, columns = loop.model.A, np.array([column for column, _ in loop.element_sides])
    odd = 2 * np.arange(HARMONICS)[:, None, None] + 1
    pushed = np.array(outputs).T @ columns
    return np.asarray(np.linalg.solve(1j * omega * odd * np.eye(len(A)) - A, pushed[:, :, None])[:, :, 0])


def _quiet_phases(places: Sequence[Place]) -> list[float]:
    """Return the middles of the longest times without a switch, rad, the longest first."""
    phases = math.pi * np.arange(2 * PHASES) / PHASES
    modes = [tuple(place(phase)[0] for place in places) for phase in phases.tolist()]
    runs = [list(run) for _, run in groupby(range(len(phases)), key=lambda k: modes[k])]
    # A run that began before phase 0 is whole half a period later.
    whole = [run for run in runs if 0 < run[0] <= PHASES] or runs
    longest = sorted(whole, key=len, reverse=True)[:TRIED]
    return [float(phases[run[0]] + phases[run[-1]]) / 2.0 for run in longest]


def _highest(loop: ClosedLoop, amplitude: float, omega: float) -> BalancedHarmonics | None:
    """Balance as many harmonics as there is a solution for; None if only the first."""
    best = None
    try:
        for balanced in solutions(loop.system, loop.element, (amplitude, omega), ORDERS):
            best = balanced
    except OrbitNotFoundError:
        pass
    return best if best is not None and best.order > 1 else None


def _place_of(component: Component, given: OddPolynomial, omega: float) -> Place:
    match component:
        case BacklashComponent():
            flight = flight_of(component, given, omega)
            assert flight is not None, "its output was found before"

            def carried(phase: float) -> tuple[int, Reals]:
                mode, states = _of_load(flight, omega, phase, component.time_constant)
                return mode, states[: component.state_count]

            return carried
        case RelayComponent():
            rate = int(component.of_rate)
            return lambda phase: (PLUS if float(given(phase, rate)) > 0 else MINUS, NO_STATES)
        case CornerComponent() | ThresholdComponent():
            return lambda phase: (mode_on(component, given, phase), NO_STATES)
    return lambda phase: (0, NO_STATES)


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
