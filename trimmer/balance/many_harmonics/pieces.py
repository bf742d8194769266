"""The pieces of half a period on which a saturation, dead zone or relay with thresholds is smooth."""

import math
from collections.abc import Callable
from itertools import pairwise

import numpy as np

from trimmer.arrays import Reals
from trimmer.balance.many_harmonics.trigonometric import POINTS, OddPolynomial, passes
from trimmer.loops.components.corner_component import ABOVE, BELOW, BETWEEN, CornerComponent
from trimmer.loops.components.switched_component import Component
from trimmer.loops.components.threshold_component import NEGATIVE, POSITIVE, SILENT, ThresholdComponent

Piece = tuple[float, float, Callable[[Reals], Reals]]


def corner_pieces(component: CornerComponent, given: OddPolynomial) -> list[Piece]:
    """Return phases from and to, rad, and the output between them, in its unit, from phase 0 to π."""

    def output(phase: Reals) -> Reals:
        place = given(phase)
        inside = np.clip(place, -component.threshold, component.threshold)
        return component.inner_slope * inside + component.outer_slope * (place - inside)

    limits = (component.threshold, -component.threshold)
    cuts = sorted({0.0, math.pi, *(cut for limit in limits for cut in passes(given, limit))})
    return [(begin, end, output) for begin, end in pairwise(cuts)]


def relay_pieces(component: ThresholdComponent, given: OddPolynomial) -> list[Piece] | None:
    """Return the pieces of half a period from where the output becomes positive; None if it never does."""
    switches = switching_phases(component, given)
    if switches is None:
        return None
    rise, fall = switches
    end = rise + math.pi
    positive = (rise, min(fall, end), lambda phase: np.full(phase.shape, component.level))
    return [positive, (fall, end, np.zeros_like)] if fall < end else [positive]


def switching_phases(component: ThresholdComponent, given: OddPolynomial) -> tuple[float, float] | None:
    """Return where the output becomes positive, and where it first does not stay so, rad; None if never."""
    phases = np.linspace(0.0, 2.0 * math.pi, POINTS)
    lowest = float(phases[np.argmin(given(phases))])
    # From there on the input first rises through a limit that is above it.
    rises = passes(given, component.on, lowest, 2.0 * math.pi)
    if not rises:
        return None
    rise = rises[0]
    falls = passes(given, component.off, rise, 2.0 * math.pi)
    fall = next((place for place in falls if given(place, 1) < 0), None)
    return None if fall is None else (rise, fall)


def mode_on(component: Component, given: OddPolynomial, phase: float) -> int:
    """Return the mode of a saturation, dead zone or relay with thresholds at a phase, rad."""
    place = float(given(phase))
    if isinstance(component, CornerComponent):
        beyond = ABOVE if place > 0 else BELOW
        return beyond if abs(place) > component.threshold else BETWEEN
    assert isinstance(component, ThresholdComponent)
    switches = switching_phases(component, given)
    if switches is None:
        return SILENT
    rise, fall = switches
    since, length = (phase - rise) % (2.0 * math.pi), fall - rise
    return POSITIVE if since < length else NEGATIVE if 0 <= since - math.pi < length else SILENT
