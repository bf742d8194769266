"""All symmetric orbits of a relay with one switch in half a period."""

import control
import numpy as np
import pytest
import scipy.linalg
import scipy.optimize
import scipy.signal

from tests.quick import quick
from tests.trimmer.orbits.random_loops import roots
from trimmer import CoulombFriction, OrbitSearch, Relay, ViscousFriction, periodic_orbits
from trimmer.orbits import Simulations
from trimmer.orbits.half_period import HalfPeriodEquation, interval_of, zeros

GRID = 300


def equation_of(A: np.ndarray, B: np.ndarray, C: np.ndarray) -> HalfPeriodEquation:
    order = len(A)
    matrix = np.zeros((order + 1, order + 1))
    matrix[:order, :order], matrix[:order, order:] = A, B
    return HalfPeriodEquation(matrix, -C[0])


def by_exponentials(equation: HalfPeriodEquation, half: float) -> float:
    """Evaluate c x(0) as Tsypkin does, with exp(A T) and its integral (Åström 1995)."""
    order = len(equation.row)
    flow = scipy.linalg.expm(equation.matrix * half)
    return -float(equation.row @ np.linalg.solve(np.eye(order) + flow[:order, :order], flow[:order, order]))


@pytest.mark.parametrize("seed", quick(range(8), *range(4)))
def test_no_change_of_sign_on_a_fine_grid_is_missed(seed: int) -> None:
    generator = np.random.default_rng(seed)
    order = 2 + seed % 4
    numerator = np.real(np.poly(roots(generator, int(generator.integers(0, order)), 0.3)))
    denominator = np.real(np.poly(roots(generator, order, 0.2)))
    A, B, C, _ = scipy.signal.tf2ss(np.atleast_1d(numerator), denominator)
    equation = equation_of(A, B, C)
    shortest, longest = interval_of(equation)
    # Where exp(A T) does not overflow the other way of evaluation.
    interval = shortest, min(longest, 12.0)
    found = np.array(zeros(equation, interval).halves)
    grid = np.geomspace(*interval, GRID)
    values = np.array([by_exponentials(equation, half) for half in grid])
    changes = np.flatnonzero(np.sign(values[1:]) != np.sign(values[:-1]))
    expected = [
        scipy.optimize.brentq(lambda half: by_exponentials(equation, half), grid[each], grid[each + 1])
        for each in changes
        if abs(values[each]) + abs(values[each + 1]) > 1e-9
    ]
    for each in expected:
        assert min(abs(found / each - 1), default=np.inf) < 1e-6
    # Zeros that the grid steps over come in pairs; each is one by the other way of evaluation.
    scale = abs(values).max()
    assert all(abs(by_exponentials(equation, each)) < 1e-7 * scale for each in found)


def test_two_zeros_that_nearly_merge_are_both_found() -> None:
    # f(T) of these plants is a sum of tanh; the level is moved until two zeros are 1e-3 apart.
    A, B = np.diag([-1.0, -2.0, -3.0]), np.ones((3, 1))

    def left_side(half: float, middle: float) -> float:
        return float(np.tanh(half / 2) - middle * np.tanh(half) / 2 + np.tanh(1.5 * half) / 3)

    def lowest(middle: float) -> tuple[float, float]:
        found = scipy.optimize.minimize_scalar(
            lambda half: left_side(half, middle),
            bounds=(0.3, 5.0),
            method="bounded",
            options={"xatol": 1e-12},
        )
        return float(found.fun), float(found.x)

    middle = scipy.optimize.brentq(lambda each: lowest(each)[0] + 1e-8, 1.5, 2.0, xtol=1e-14)
    found = zeros(equation_of(A, B, np.array([[1.0, -middle, 1.0]])), (1e-2, 40.0)).halves
    touching = lowest(middle)[1]
    near = [each for each in found if abs(each / touching - 1) < 0.01]
    assert len(near) == 2
    assert near[0] < touching < near[1]


def test_poles_of_the_equation_are_left_undecided() -> None:
    # Without damping the left side has a pole at each odd multiple of half the period of the mode.
    A, B, C, _ = scipy.signal.tf2ss([1.0], np.polymul([1.0, 0.0, 1.0], [1.0, 1.0]))
    solved = zeros(equation_of(A, B, C), (0.1, 20.0))
    assert [round(sum(each) / 2 / np.pi, 3) for each in solved.undecided] == [1.0, 3.0, 5.0]
    assert sum(end - begin for begin, end in solved.undecided) < 1e-2


def test_a_real_pole_of_the_loop_hides_many_orbits() -> None:
    # The only pole pair of 1 + N G that harmonic balance sees hides orbits at lower frequencies.
    search = OrbitSearch(half_periods=(2.0, 12.0))
    orbits = periodic_orbits(control.tf([1], [1, -0.5, 1, -1.5]), Relay(1.0), search=search)
    assert sum(orbit.prediction is not None for orbit in orbits) == 1
    assert len(orbits) > 3
    for orbit in orbits:
        assert orbit.residual < 1e-10
        assert len(orbit.switching_times) == 2


@pytest.mark.filterwarnings("ignore::trimmer.UndecidedWarning", "ignore::trimmer.errors.OrbitNotFoundWarning")
def test_an_orbit_of_states_one_behind_the_other_is_that_of_partial_fractions() -> None:
    """Harmonic balance leads to none here. Sums over the poles are Tsypkin's for real ones."""
    A = np.array([[-2.6, 0, 0, 0], [-0.5, -1.3, 0, 0], [1.4, 1.8, -2.2, -2.4], [0.9, 0.9, 0, -2]])
    system = A, [[1.2], [0.4], [-0.9], [-1.5]], [[5.3, -0.3, -2.1, 0.4]], [[0.0]]
    (orbit,) = periodic_orbits(control.ss(*system), Relay(1.0, 1.0), search=OrbitSearch(Simulations.NEVER))
    residues, poles, _ = scipy.signal.residue(*map(np.ravel, scipy.signal.ss2tf(*system)))
    assert abs(residues / poles @ np.tanh(poles * orbit.period / 4)) == pytest.approx(1.0, rel=1e-9)


def test_the_interval_can_be_chosen() -> None:
    system = control.ss(*scipy.signal.tf2ss([0.781, 1], [1, 1.467, 8.244, 9, 3.618, 1.247]))
    chosen = OrbitSearch(Simulations.NEVER, half_periods=(3.45, 3.6))
    orbits = periodic_orbits(system, Relay(2.09), [], chosen)
    assert [orbit.amplitude for orbit in orbits] == [pytest.approx(0.69311, rel=1e-5)]
    assert orbits.search.relay.half_periods == (3.45, 3.6)
    assert "from 3.45 to 3.6 s" in orbits.search.sentence


def test_viscous_friction_beside_coulomb_friction_belongs_to_the_linear_system() -> None:
    # Negative Coulomb friction drives a damped oscillator, x'' + 0.3 x' + x = sign(x').
    system, element = control.tf([1], [1, 0, 1]), -CoulombFriction(1.0) + 0.3 * ViscousFriction(1.0)
    (orbit,) = periodic_orbits(system, element, [], OrbitSearch())
    (alone,) = periodic_orbits(control.tf([1], [1, 0.3, 1]), -CoulombFriction(1.0), [], OrbitSearch())
    assert orbit.amplitude == pytest.approx(alone.amplitude, rel=1e-10)
    # From turning point to turning point x swings about -1 or 1, as a damped oscillator of frequency w.
    w = np.sqrt(1 - 0.15**2)
    kept = np.exp(-0.15 * np.pi / w)
    assert orbit.period == pytest.approx(2 * np.pi / w, rel=1e-10)
    assert orbit.amplitude == pytest.approx((1 + kept) / (1 - kept), rel=1e-10)


def loop_with_unequal_switches(seed: int, positive: float, negative: float) -> control.StateSpace:
    """Build a system whose loop with a relay switches after these durations: the row C is free to choose."""
    generator = np.random.default_rng(seed)
    # Close to the switches too, so that the relay neither slides nor switches back.
    edge = np.geomspace(1e-5, 0.02, 10)
    shares = np.concatenate([edge, np.linspace(0.03, 0.97, 25), 1.0 - edge])
    while True:
        A, B, _, _ = scipy.signal.tf2ss([1.0], np.real(np.poly(roots(generator, 4, 0.0))))
        rest = -np.linalg.solve(A, B[:, 0])
        first, second = (scipy.linalg.expm(A * duration) for duration in (positive, negative))
        # x - rest decays while the output is positive, x + rest while it is negative.
        begin = np.linalg.solve(
            np.eye(4) - second @ first, second @ (rest - first @ rest) + second @ rest - rest
        )
        middle = first @ (begin - rest) + rest
        rows = scipy.linalg.null_space(np.array([begin, middle]))
        course = [
            sign * (scipy.linalg.expm(A * duration * share) @ (start - sign * rest) + sign * rest)
            for start, duration, sign in ((begin, positive, 1.0), (middle, negative, -1.0))
            for share in shares
        ]
        for angle in generator.uniform(0.0, 2.0 * np.pi, 50):
            row = rows @ [np.cos(angle), np.sin(angle)]
            if min(row @ x for x in course) > 0 and row @ B[:, 0] <= 0:
                return control.ss(A, B, -row[None], 0)


@pytest.mark.parametrize(
    ("seed", "positive", "negative"), quick([(0, 2.3, 1.1), (1, 2.3, 1.1), (2, 1.4, 1.2), (0, 4.0, 0.6)], 1)
)
@pytest.mark.parametrize("alone", [False, True])
def test_unequal_switches_that_a_loop_was_built_for_are_found(seed, positive, negative, alone) -> None:
    """In any states: the output may be one of them."""
    system = loop_with_unequal_switches(seed, positive, negative)
    if alone:
        states = np.vstack([system.C, scipy.linalg.null_space(system.C).T])
        system = control.similarity_transform(system, states)
    orbits = periodic_orbits(system, Relay(1.0), [], OrbitSearch(Simulations.NEVER))
    nearest = min(orbits, key=lambda orbit: abs(orbit.period - positive - negative))
    assert nearest.period == pytest.approx(positive + negative, rel=1e-8)
    apart = float(np.diff(nearest.switching_times)[0])
    # The motion may begin on either side of the longer duration, or on the mirror image.
    assert min(abs(apart - positive), abs(apart - negative)) < 1e-7
