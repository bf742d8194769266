"""The steady output of an element for an odd periodic input of any shape, by its harmonics."""

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from itertools import pairwise

import numpy as np

from trimmer.arrays import Complexes, Reals
from trimmer.balance.many_harmonics.pieces import corner_pieces, relay_pieces
from trimmer.balance.many_harmonics.trigonometric import OddPolynomial, falls_through_zero, sign_changes
from trimmer.elements.element import Element
from trimmer.errors import UnsupportedMotionError
from trimmer.loops.components.backlash_component import BacklashComponent
from trimmer.loops.components.corner_component import CornerComponent
from trimmer.loops.components.of_elements import RigidComponent, ViscousComponent, components_of
from trimmer.loops.components.relay_component import RelayComponent
from trimmer.loops.components.switched_component import Component
from trimmer.loops.components.threshold_component import ThresholdComponent

NODE_COUNT = 80
NODES, WEIGHTS = np.polynomial.legendre.leggauss(NODE_COUNT)
"""Gauss-Legendre quadrature; each piece of an output is smooth, so it is exact to rounding."""


@dataclass(frozen=True, eq=False)
class Flight:
    """The flight of a load from the upper to the lower side of the gap, where it stays up to half a period.

    It leaves and meets them at phases, rad; its position, m, is a function of those in between.
    """

    leave: float
    meet: float
    position: Callable[[Reals], Reals]


def steady_response(
    element: Element, given: OddPolynomial, omega: float, of_velocity: bool = False
) -> Complexes | None:
    """Return complex amplitudes of the output at the harmonics of the input; None without steady output.

    They have the shape of the input's coefficients. The output of a backlash is the one with two contacts
    in a period. The input of frictions is a velocity or a displacement.
    """
    total = np.zeros(len(given.coefficients), dtype=complex)
    for component, factor in components_of(element, of_velocity):
        response = _of_component(component, given, omega)
        if response is None:
            return None
        total += factor * response
    return total


def flight_of(component: BacklashComponent, given: OddPolynomial, omega: float) -> Flight | None:
    """Return the flight of a load from the upper side to the lower one; None if there is no such flight."""
    gamma, half_gap = omega * component.time_constant, 0.5 * component.gap

    def force(phase: Reals) -> Reals:
        if math.isinf(gamma):
            return given(phase, 2)
        return gamma * given(phase, 2) + given(phase, 1)

    leave = falls_through_zero(force, *_period_around(given))
    if leave is None:
        return None
    start, velocity = float(given(leave)) - half_gap, float(given(leave, 1))

    def position(phase: Reals) -> Reals:
        elapsed = phase - leave
        if gamma == 0.0:
            return np.full(phase.shape, start)
        if math.isinf(gamma):
            return start + velocity * elapsed
        return start - velocity * gamma * np.expm1(-elapsed / gamma)

    # The distance to the lower side is the whole gap at first.
    meet = falls_through_zero(lambda phase: given(phase) + half_gap - position(phase), leave, leave + math.pi)
    return None if meet is None else Flight(leave, meet, position)


def switch_of(component: RelayComponent, given: OddPolynomial) -> float | None:
    """Return the phase at which the output of a relay becomes negative, rad; None if it never does."""
    derivative = int(component.of_rate)
    return falls_through_zero(lambda phase: given(phase, derivative), *_period_around(given))


def _of_component(component: Component, given: OddPolynomial, omega: float) -> Complexes | None:
    match component:
        case ViscousComponent():
            return component.coefficient * 1j * given.numbers * omega * given.coefficients
        case RelayComponent():
            return _relay(component, given)
        case BacklashComponent():
            return _backlash(component, given, omega)
        case RigidComponent():
            return given.coefficients
        case CornerComponent():
            return _harmonics(given, corner_pieces(component, given))
        case ThresholdComponent():
            pieces = relay_pieces(component, given)
            return None if pieces is None else _harmonics(given, pieces)
    raise UnsupportedMotionError(f"{component!r} has no steady response to a periodic input")


def _relay(component: RelayComponent, given: OddPolynomial) -> Complexes | None:
    cuts = sign_changes(given, int(component.of_rate))
    if len(cuts) > 1:
        return _harmonics(given, _alternating(component, given, cuts))
    switch = switch_of(component, given)
    if switch is None:
        return None
    return _harmonics(
        given, [(switch, switch + math.pi, lambda phase: np.full(phase.shape, -component.level))]
    )


def _alternating(
    component: RelayComponent, given: OddPolynomial, cuts: list[float]
) -> list[tuple[float, float, Callable[[Reals], Reals]]]:
    """Return the pieces of half a period of a relay that switches several times in it."""
    pieces: list[tuple[float, float, Callable[[Reals], Reals]]] = []
    for begin, end in pairwise([*cuts, cuts[0] + math.pi]):
        sign = math.copysign(1.0, float(given(0.5 * (begin + end), int(component.of_rate))))
        pieces.append((begin, end, partial(_level, sign * component.level)))
    return pieces


def _level(level: float, phase: Reals) -> Reals:
    return np.full(phase.shape, level)


def _backlash(component: BacklashComponent, given: OddPolynomial, omega: float) -> Complexes | None:
    flight = flight_of(component, given, omega)
    if flight is None:
        return None
    leave, meet = flight.leave, flight.meet
    half_gap = 0.5 * component.gap
    pieces = [(leave, meet, flight.position), (meet, leave + math.pi, lambda phase: given(phase) + half_gap)]
    return _harmonics(given, pieces)


def _period_around(given: OddPolynomial) -> tuple[float, float]:
    """Return a period that begins where the first harmonic rises through zero."""
    begin = -float(np.angle(given.coefficients[0])) - 0.25 * math.pi
    return begin, begin + math.tau


def _harmonics(
    given: OddPolynomial, pieces: list[tuple[float, float, Callable[[Reals], Reals]]]
) -> Complexes:
    """Integrate pieces that make up half a period; the other half has the signs changed."""
    total = np.zeros(len(given.coefficients), dtype=complex)
    for begin, end, output in pieces:
        phases = begin + 0.5 * (end - begin) * (NODES + 1.0)
        kernel = np.exp(-1j * np.multiply.outer(given.numbers, phases))
        total += kernel @ (output(phases) * WEIGHTS) * 0.5 * (end - begin)
    return 2j / math.pi * total
