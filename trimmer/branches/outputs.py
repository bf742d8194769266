"""Outputs of a periodic motion: peak to peak and harmonics, exact from its flow."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from trimmer.arrays import Complexes, Integers, Places, Reals
from trimmer.contact.flow import Course
from trimmer.mechanism.mechanism import Mechanism

HARMONICS = 15
MOST_REFINEMENTS = 4


@dataclass(frozen=True, eq=False)
class OutputMeasure:
    """What a displacement does over a period.

    Attributes:
        peak_to_peak: m.
        harmonics: Amplitudes a_n, m, of a_n cos(n omega t + phase), n = 1 ... 15, omega that of the drive.
    """

    peak_to_peak: float
    harmonics: Reals


def output_measures(mechanism: Mechanism, course: Course, periods: int) -> dict[str, OutputMeasure]:
    """Return the measures of all outputs by name.

    Args:
        mechanism: The mechanism.
        course: Its motion over a whole number of drive periods, after which it repeats.
        periods: That number.
    """
    orders = periods * np.arange(1, HARMONICS + 1)
    return {
        name: OutputMeasure(_peak_to_peak(course, row), np.abs(coefficients(course, row, orders)))
        for name, row in _rows(mechanism, course).items()
    }


def coefficients(course: Course, row: Reals, orders: Integers) -> Complexes:
    """Return c_n of Re c_n exp(i n omega t), n > 0, and the mean for n = 0.

    Args:
        course: A motion over a period.
        row: What is asked for, as a functional of the extended state.
        orders: n, multiples of the frequency of repetition, shape (n,).
    """
    times, weights, _, states = course.nodes
    turning = np.exp(-2j * np.pi / course.duration * np.multiply.outer(orders, times))
    factors = np.where(orders == 0, 1.0, 2.0) / course.duration
    return np.asarray(factors * (turning @ (weights * (states @ row))), dtype=np.complex128)


def body_rows(course: Course) -> Reals:
    """Return the displacements of the bodies as functionals of the extended state, (bodies, N)."""
    layout = course.modes.layout
    return np.eye(layout.size)[: len(layout.bodies)]


def _rows(mechanism: Mechanism, course: Course) -> dict[str, Reals]:
    layout = course.modes.layout
    named = dict(zip(layout.bodies, body_rows(course), strict=True))
    named |= dict(zip(layout.pins, layout.pin_rows, strict=True))
    return {
        name: np.sum([weight * named[body] for body, weight in output.weights.items()], axis=0)
        for name, output in mechanism.outputs.items()
    }


def _peak_to_peak(course: Course, row: Reals) -> float:
    _, _, rows, states = course.nodes
    rates = _rates(course, row, rows, states)
    turns = np.flatnonzero((rates[1:] * rates[:-1] < 0.0) & (rows[1:] == rows[:-1]))
    values = np.concatenate([states @ row, course.log.state @ row])
    if len(turns):
        values = np.append(values, _at_turns(course, row, turns))
    return float(np.ptp(values))


def _rates(course: Course, row: Reals, rows: Integers, states: Reals) -> Reals:
    by_row = np.array([row @ course.modes[int(mode)].flow for mode in course.log.mode])
    rates: Reals = np.einsum("ij,ij->i", by_row[rows], states)
    return rates


def _at_turns(course: Course, row: Reals, turns: Places) -> Reals:
    """Return the values where the rate vanishes, by the secant method between neighbouring nodes."""
    times, _, rows, states = course.nodes
    before, after, within = times[turns], times[turns + 1], rows[turns]
    first = _rates(course, row, within, states[turns])
    last = _rates(course, row, within, states[turns + 1])
    for _ in range(MOST_REFINEMENTS):
        between = before - first * (after - before) / np.where(last == first, 1.0, last - first)
        values = course.states(between)
        rates = _rates(course, row, within, values)
        lower = rates * first > 0.0
        before, first = np.where(lower, between, before), np.where(lower, rates, first)
        after, last = np.where(lower, after, between), np.where(lower, last, rates)
    return np.asarray(values @ row)
