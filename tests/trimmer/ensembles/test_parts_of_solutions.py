"""Parts of the search of many trimmers: enclosures, other poles, responses, and who is searched again."""

from __future__ import annotations

import math
from dataclasses import asdict

import numpy as np
import pytest
from scipy.optimize import fsolve

from tests.trimmer.ensembles.known_responses import THREE
from trimmer.displacement import Displacement
from trimmer.elements.backlashes.friction_backlash import FrictionBacklash
from trimmer.ensembles.crossings import (
    Crossings,
    crossings,
)
from trimmer.ensembles.other_poles import unstable_others
from trimmer.ensembles.polishing import Solutions, polished
from trimmer.ensembles.polynomials import roots
from trimmer.ensembles.responses import Responses, responses_of
from trimmer.linear.frequency_response import response_at
from trimmer.linear.model import InputChannels, pin_model
from trimmer.parameters import TrimmerParameters


def by_hand(gain: float) -> tuple[float, float]:
    """Return u and omega with N(u) = omega² - j omega over the gain."""

    def rest(unknowns: np.ndarray) -> list[float]:
        u, omega = unknowns
        value = complex(FrictionBacklash(1.0).describing_function(1.0 / u)) - complex(omega**2, -omega) / gain
        return [value.real, value.imag]

    u, omega = fsolve(rest, [0.7, 0.4 * gain**0.5], xtol=1e-13)
    return float(u), float(omega)


def test_crossings_of_some_trimmers_enclose_their_solutions() -> None:
    omegas = np.repeat(np.geomspace(0.01, 30.0, 120)[None], 3, axis=0)
    found = crossings(THREE, omegas)
    assert set(found.rows.tolist()) <= {0, 2}
    solved = polished(THREE[found.rows], found)
    assert solved.found.all()
    for row, gain in ((0, 4.0), (2, 9.0)):
        here = found.rows == row
        assert here.any()
        for u, omega, value, sine in zip(
            solved.u[here], solved.omega[here], solved.gain[here], solved.sine[here], strict=True
        ):
            assert value == pytest.approx(
                complex(FrictionBacklash(1.0).describing_function(1.0 / u)), rel=1e-10
            )
            assert value == pytest.approx(complex(omega**2, -omega) / gain, rel=1e-9)
            # Loeb: the determinant of N + 1/G over u and x, of the other sign over amplitude.
            step = 1e-6
            play = FrictionBacklash(1.0)
            by_u = complex(
                play.describing_function(1.0 / (u + step)) - play.describing_function(1.0 / (u - step))
            )
            by_x = complex(-2.0 * omega**2, omega) / gain
            angle = np.angle(by_x / -by_u)
            assert sine == pytest.approx(math.sin(angle), abs=1e-6)
        assert (found.lower[here] < solved.omega[here]).all()
        assert (solved.omega[here] < found.upper[here]).all()
        steps = np.diff(omegas[0])
        assert (found.upper[here] - found.lower[here] < steps.max() / 60.0).all()
    assert not found.doubtful[[0, 2]].any()
    assert (solved.residual < 1e-11).all()
    one = solved[np.arange(solved.u.size) == 0]
    assert [len(each) for each in vars(one).values()] == [1] * 6
    assert one.sine[0] == solved.sine[0]


def test_unstable_others_are_those_of_the_polynomial_with_n_frozen() -> None:
    # (s + 1)(s² + 0.2 s + 4) + N (b s + c): with a large c it swings at another frequency.
    denominator = np.repeat(np.polymul([1.0, 1.0], [1.0, 0.2, 4.0])[None], 2, axis=0)
    numerator = np.array([[0.0, 0.0, 0.1], [0.0, 0.0, 9.0]])
    responses = Responses(numerator, denominator, np.ones(2))
    near = np.repeat(np.roots(denominator[0]).astype(complex)[None], 2, axis=0)
    gains = np.array([0.5 - 0.1j, 0.5 - 0.1j])
    for omega in (2.0, 0.1):
        solutions = Solutions(np.full(2, omega), np.ones(2), gains, np.ones(2), np.zeros(2), np.ones(2, bool))
        unstable, unknown = unstable_others(responses, near, solutions)
        for row in range(2):
            poles = np.roots(denominator[row] + gains[row] * np.concatenate([[0.0], numerator[row]]))
            poles = np.delete(poles, np.abs(poles - 1j * omega).argmin())
            assert unstable[row] == bool(((poles.real > 0) & (poles.imag > 0)).any())
        assert not unknown.any()


@pytest.mark.parametrize("unit", [1e-3, 1.0, 1e3])
def test_what_is_rounding_of_a_pole_is_a_share_of_its_modulus(unit: float) -> None:
    shares = np.array([1e-7, 5e-11, -1e-7])
    poles = unit * np.array([[-1.0, each + 2j, each - 2j] for each in shares])
    denominator = np.array([np.poly(row).real for row in poles])
    responses = Responses(np.zeros((3, 3)), denominator, np.ones(3))
    three = np.ones(3)
    solutions = Solutions(0.1 * unit * three, three, 0.5 + 0j * three, three, three, three > 0)
    unstable, unknown = unstable_others(responses, poles, solutions)
    assert unstable.tolist() == [True, False, False]
    assert not unknown.any()


def test_responses_are_those_of_the_model() -> None:
    parameters = TrimmerParameters.thesis()
    values = np.array([parameters.values(), [1.7 * each for each in parameters.values()]])
    values[1, 0] *= 1.3
    symbols = list(asdict(parameters))
    for channels in InputChannels:
        made = responses_of(values, Displacement.parse("q2-q4"), channels)
        for row in range(2):
            G = pin_model(
                TrimmerParameters(**dict(zip(symbols, values[row].tolist(), strict=True))), "q2-q4", channels
            )
            omega = np.array([300.0, 691.0, 5000.0])
            inverse = made.inverse(np.repeat((omega / made.reference[row])[None], 2, axis=0))[row]
            assert inverse == pytest.approx(-1.0 / response_at(G, omega), rel=1e-8)
            poles = np.abs(np.roots(made.denominator[row]))
            assert float(np.exp(np.log(poles).mean())) == pytest.approx(1.0, rel=1e-6)
        x = np.array([-0.3, 0.4])
        inverse, slope = made.inverse_and_slope(x)
        step = 1e-5
        ahead, behind = (made.inverse_and_slope(x + each)[0] for each in (step, -step))
        assert slope == pytest.approx((ahead - behind) / (2.0 * step), rel=1e-7)
        assert inverse == pytest.approx(np.diagonal(made.inverse(np.repeat(np.exp(x)[None], 2, axis=0))))
    part = made[np.array([1])]
    assert part.reference.tolist() == [made.reference[1]]
    assert part.numerator.tolist() == [made.numerator[1].tolist()]


def test_roots_that_are_exact_stay() -> None:
    values, found = roots(np.array([[1.0, -3.0, 2.0]]), np.array([[1.0, 2.0]], complex))
    assert values.tolist() == [[1.0, 2.0]]
    assert found.all()


@pytest.mark.parametrize(("share", "found"), [(0.5e-6, True), (2e-6, False)])
def test_a_solution_may_lie_beside_its_enclosure_by_a_millionth(share: float, found: bool) -> None:
    u, omega = by_hand(4.0)
    one = THREE[np.zeros(1, int)]
    for lower, upper in ((0.99, 1.0 - share), (1.0 + share, 1.01)):
        ends = (np.array([each]) for each in (lower * omega, upper * omega, u, False))
        assert polished(one, Crossings(np.zeros(1, int), *ends)).found.tolist() == [found]
