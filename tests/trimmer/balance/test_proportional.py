"""Relays and Coulomb friction: limit cycles from the polynomials of G, and where the search may end."""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
import pytest

from tests.quick import quick
from trimmer.arrays import Complexes, Reals
from trimmer.balance.element_curve import ElementCurve
from trimmer.balance.inverse_response import InverseResponse
from trimmer.balance.proportional import FALLBACK_REACH, proportional_range, solve_proportional
from trimmer.elements import CoulombFriction, Element, Relay, ViscousFriction
from trimmer.elements.expansion import Expansion
from trimmer.errors import LinearElementError, UnsupportedElementError

FACTOR = 4.0 / math.pi
"""N of a relay of level 1 is 4/(pi A), that of Coulomb friction of 1 N is 4j/(pi A)."""


@dataclass(frozen=True)
class Plant:
    """G = gain * prod(s - zero) / prod(s - pole), with roots that are exact."""

    gain: float
    poles: tuple[complex, ...]
    zeros: tuple[complex, ...] = ()

    def inverse(self, reference: float = 1.0) -> InverseResponse:
        scaled = [np.array(roots, complex) / reference for roots in (self.poles, self.zeros)]
        degree = len(self.poles) - len(self.zeros)
        return InverseResponse(reference**degree / self.gain, *scaled, reference)

    def crossings(self, turn: complex) -> list[tuple[float, float]]:
        """Return omega and -turn * G where that is real and positive, from polynomials in omega."""
        rotated = (
            np.poly1d(self.gain * turn) * _of_omega(self.zeros) * np.poly1d(np.conj(_of_omega(self.poles).c))
        )
        on_axis = [root.imag for root in map(complex, (*self.poles, *self.zeros)) if root.real == 0]
        omegas = [
            root.real
            for root in np.roots(np.trim_zeros(rotated.c.imag, "f"))
            if _is_positive(root) and not np.isclose(root.real, on_axis).any()
        ]
        values = [-complex(turn * self._response(omega)) for omega in omegas]
        return sorted(
            (omega, value.real) for omega, value in zip(omegas, values, strict=True) if value.real > 0
        )

    def _response(self, omega: float) -> complex:
        return complex(self.gain * _of_omega(self.zeros)(omega) / _of_omega(self.poles)(omega))


def _of_omega(roots: tuple[complex, ...]) -> np.poly1d:
    """Return prod(j omega - root) as a polynomial in omega."""
    product = np.poly1d([1.0 + 0.0j])
    for root in roots:
        product = product * np.poly1d([1j, -root])
    return product


def _is_positive(root: complex) -> bool:
    return root.real > 1e-6 and abs(root.imag) < 1e-9 * abs(root)


def random_plant(random: np.random.Generator) -> Plant:
    """Poles and zeros on both sides of the axis, some at zero, pairs and single ones."""

    def roots(count: int, stable: float) -> tuple[complex, ...]:
        found: list[complex] = []
        while len(found) < count:
            size, side = 10 ** random.uniform(-1, 1), -1.0 if random.random() < stable else 1.0
            if count - len(found) > 1 and random.random() < 0.6:
                pair = size * complex(side * random.uniform(0.1, 0.9), random.uniform(0.3, 3.0))
                found += [pair, pair.conjugate()]
            else:
                found.append(complex(side * size))
        return tuple(found)

    poles = (*roots(random.integers(1, 6), 0.8), *[0.0] * random.integers(0, 3))
    zeros = roots(random.integers(0, len(poles)), 0.7)
    return Plant(random.choice([-1.0, 1.0]) * 10 ** random.uniform(-2, 2), poles, zeros)


@pytest.mark.parametrize(("element", "turn"), [(Relay(2.0), 1.0), (CoulombFriction(2.0), 1j)])
@pytest.mark.parametrize("reference", quick([1.0, 30.0], 1))
def test_all_crossings_of_random_plants_are_found(element: Element, turn: complex, reference: float) -> None:
    random = np.random.default_rng(20261122)
    counts = []
    for plant in (random_plant(random) for _ in range(60)):
        searched = solve_proportional(plant.inverse(reference), ElementCurve(element), None)
        expected = plant.crossings(turn)
        counts.append(len(expected))
        assert np.exp(searched.result.x) == pytest.approx([omega for omega, _ in expected], rel=1e-9), plant
        amplitudes = element.amplitude_scale / searched.result.u
        assert amplitudes == pytest.approx([2.0 * FACTOR * gain for _, gain in expected], rel=1e-8), plant
        assert len(searched.result.undecided) == 0
        assert searched.outside_excluded
        assert all(searched.omegas[0] < omega < searched.omegas[1] for omega, _ in expected)
    assert {0, 1, 2} <= set(counts)


def test_a_range_leaves_out_what_is_beyond_it() -> None:
    # Six poles and two zeros between them: the phase falls below -180 degrees, rises, and falls again.
    plant = Plant(1.0, (-0.1, -0.1, -0.1, -40.0, -40.0, -40.0), (-2.0, -2.0))
    crossings = plant.crossings(1.0)
    middle = [math.sqrt(one[0] * other[0]) for one, other in pairwise(crossings)]
    assert len(crossings) > 1
    for omegas in ((crossings[0][0] / 2, middle[0]), (middle[-1], crossings[-1][0] * 2)):
        searched = solve_proportional(plant.inverse(), ElementCurve(Relay(1.0)), omegas)
        inside = [omega for omega, _ in crossings if omegas[0] < omega < omegas[1]]
        assert np.exp(searched.result.x) == pytest.approx(inside, rel=1e-9)
        assert searched.omegas == omegas
        assert not searched.outside_excluded


@pytest.mark.parametrize("size", [1.0, 1e-9, 1e7])
def test_ends_of_the_range_are_those_of_the_bound(size: float) -> None:
    """With t = omega/size the phase of (1 + jt)**n is n t but for n t**3/(3 - 3 t**2); 1/2 is tried first.

    Where f starts out real and positive, as for 1/(s+1)**3 with a relay, it is enough that this is below pi;
    at high frequency f is imaginary, and 1.5 + 0.17 is not below pi/2, so that t = 1/4 is the first. Where it
    starts out real and negative, as for -1/(s+1)**2, the phase leaves pi at once, and is not there again.
    """
    third = Plant(1.0, (-size, -size, -size)).inverse(size)
    assert proportional_range(third, FACTOR) == (pytest.approx(size / 2), pytest.approx(4 * size), True)
    second = Plant(-1.0, (-size, -size)).inverse(size)
    assert proportional_range(second, FACTOR) == (pytest.approx(size / 2), pytest.approx(2 * size), True)


def test_without_damping_nothing_beyond_the_range_is_proven() -> None:
    """f = -(4 - omega**2) for -1/(s**2 + 4): real and negative for low frequencies; 1/(s**2 + 4) for high."""
    lowest, _, proven = proportional_range(Plant(-1.0, (2j, -2j)).inverse(2.0), FACTOR)
    assert lowest == pytest.approx(2.0 / FALLBACK_REACH)
    assert not proven
    _, highest, proven = proportional_range(Plant(1.0, (2j, -2j)).inverse(2.0), FACTOR)
    assert highest == pytest.approx(2.0 * FALLBACK_REACH)
    assert not proven
    # The outermost of several roots counts.
    lowest, _, _ = proportional_range(Plant(-1.0, (2j, -2j, 7j, -7j), (5j, -5j)).inverse(2.0), FACTOR)
    _, highest, _ = proportional_range(Plant(1.0, (2j, -2j, 7j, -7j), (5j, -5j)).inverse(2.0), FACTOR)
    assert lowest == pytest.approx(2.0 / FALLBACK_REACH)
    assert highest == pytest.approx(7.0 * FALLBACK_REACH)


@pytest.mark.parametrize("turn", [-1.0, 1.0, 1j, -1j, np.exp(0.3j), -np.exp(1e-3j)])
def test_f_is_not_real_and_negative_outside_of_a_proven_range(turn: complex) -> None:
    random = np.random.default_rng(3)
    for plant in (random_plant(random) for _ in range(60)):
        inverse = plant.inverse()
        lowest, highest, proven = proportional_range(inverse, turn)
        if proven:
            beyond = np.concatenate(
                [lowest * np.geomspace(1e-9, 1, 400), highest * np.geomspace(1, 1e9, 400)]
            )
            assert _least_heading(inverse.value(np.log(beyond)) / turn) > 0.0, plant


def _least_heading(f: Complexes) -> float:
    """Return the least angle from the negative real axis, to rounding of far values."""
    headings: Reals = np.abs(np.angle(-f))
    return float(headings.min())


@pytest.mark.parametrize("omega", [1.0, 0.37, 12.0])
def test_a_pole_or_zero_on_the_axis_is_no_solution_and_leaves_nothing_undecided(omega: float) -> None:
    """There f = (omega**2 - w**2)(...) goes through zero or infinity, and its phase jumps by pi."""
    on_axis = (1j * omega, -1j * omega)
    for plant in (
        Plant(1.0, (*on_axis, -1.0)),
        Plant(1.0, (*on_axis, -1.0, -2.0, -3.0)),
        Plant(-3.0, (-1.0, -2.0, -4.0, 0.0), on_axis),
        Plant(3.0, (-1.0, -2.0, -3.0, -0.1), on_axis),
        Plant(1.0, (*on_axis, -1.0, 0.0)),
    ):
        with np.errstate(divide="raise"):  # a root at 0 is at no finite ln omega
            searched = solve_proportional(plant.inverse(), ElementCurve(Relay(1.0)), None)
        expected = [each for each, _ in plant.crossings(1.0)]
        assert np.exp(searched.result.x) == pytest.approx(expected, rel=1e-9), plant
        assert len(searched.result.undecided) == 0


def test_where_f_stays_real_and_negative_all_is_undecided_there() -> None:
    """1/(s**2 + 4): f = 4 - omega**2, real and negative from 2 rad/s on."""
    searched = solve_proportional(Plant(1.0, (2j, -2j)).inverse(), ElementCurve(Relay(1.0)), (0.1, 10.0))
    boxes = searched.result.undecided
    assert searched.result.x.size == 0
    covered = np.sort(np.column_stack([boxes.x_lower, boxes.x_upper]), axis=0)
    assert covered[1:, 0] == pytest.approx(covered[:-1, 1])
    assert math.exp(covered[0, 0]) == pytest.approx(2.0, rel=0.05)
    assert math.exp(covered[-1, 1]) == pytest.approx(10.0)
    # u = -f/c belongs to each frequency, and lies in the box.
    middle = 0.5 * (boxes.x_lower + boxes.x_upper)
    u = (np.exp(2 * middle) - 4.0) / FACTOR
    above = u > 0
    assert ((boxes.u_lower <= u) & (u <= boxes.u_upper))[above].all()


@dataclass(frozen=True)
class Bent:
    """N = u within limits of u, and not proportional to u beyond them."""

    lowest: float = 0.0
    highest: float = math.inf
    depends_on_x: bool = False
    element: str = "bent"

    def value(self, u: Reals, x: Reals) -> Complexes:
        return np.where((u >= self.lowest) & (u <= self.highest), u, u**2).astype(complex)

    def expansion(self, u: Reals, x: Reals) -> Expansion:
        return Expansion(self.value(u, x), np.ones_like(self.value(u, x)), np.zeros_like(self.value(u, x)))


@pytest.mark.parametrize("curve", [Bent(lowest=0.5), Bent(highest=2.0), Bent(depends_on_x=True)])
def test_an_unbounded_n_that_is_not_proportional_is_refused(curve: Bent) -> None:
    inverse = Plant(1.0, (0.0, -1.0, -2.0)).inverse()
    with pytest.raises(UnsupportedElementError, match="unbounded and not proportional"):
        solve_proportional(inverse, curve, None)
    searched = solve_proportional(inverse, Bent(), None)
    # 1/(s(s+1)(s+2)) is -1/6 at sqrt(2) rad/s, by hand, and N = u.
    assert np.exp(searched.result.x) == pytest.approx([math.sqrt(2.0)])
    assert searched.result.u == pytest.approx([6.0])


def test_an_element_that_is_linear_has_no_limit_cycle_of_its_own() -> None:
    with pytest.raises(LinearElementError, match="does not depend on the amplitude"):
        solve_proportional(Plant(1.0, (-1.0,)).inverse(), ElementCurve(ViscousFriction(1.0)), None)
