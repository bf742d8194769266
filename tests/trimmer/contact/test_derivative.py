"""The derivative of a motion by its start, where it is known in closed form, and by differences."""

import math

import numpy as np
import pytest
from scipy.linalg import expm

from tests.mechanisms.cases import trimmer
from tests.trimmer.contact.exact import derivative
from trimmer import Body, ContactLaw, Force, Friction, Link, Mechanism, Pin, Stop, forced_orbit, simulate

BETWEEN = ("ground", "body")
FLIGHT, CONTACT = 0.5 / 0.7, 0.05


def thrown(**stops: Stop) -> Mechanism:
    """A body of 2 kg that flies 0.5 m at 0.7 m/s."""
    return Mechanism({"body": Body(2.0)}, stops=stops, start={"body": (0.0, 0.7)})


def wall(law: ContactLaw, stiffness: float = 40.0, damping: float = 3.0, gap: float = 0.5) -> Stop:
    return Stop(BETWEEN, stiffness, damping, gap, law)


def met(stiffness: float, damping: float) -> np.ndarray:
    """The force jumps by - c v, and a body that is ahead by d arrives earlier by d / v."""
    pressed = expm(np.array([[0.0, 1.0], [-stiffness / 2, -damping / 2]]) * CONTACT)
    return pressed @ [[1.0, 0.0], [-damping / 2, 1.0]] @ [[1.0, FLIGHT], [0.0, 1.0]]


def test_a_wall_with_a_damper_turns_distances() -> None:
    found = derivative(thrown(wall=wall(ContactLaw.TRUNCATED)), FLIGHT + CONTACT)
    np.testing.assert_allclose(found, met(40.0, 3.0), rtol=1e-11)


def test_two_walls_that_are_met_at_one_instant_turn_distances_once() -> None:
    both = thrown(
        first=wall(ContactLaw.TRUNCATED), second=wall(ContactLaw.TRUNCATED, stiffness=10.0, damping=0.5)
    )
    np.testing.assert_allclose(derivative(both, FLIGHT + CONTACT), met(50.0, 3.5), rtol=1e-11)


def test_contact_gives_a_relaxing_spring_its_length() -> None:
    # The first stop is far and has no state; the spring of the second one is the third state.
    far = wall(ContactLaw.TRUNCATED, gap=90.0)
    mechanism = thrown(far=far, wall=wall(ContactLaw.RELAXING))
    found = derivative(mechanism, FLIGHT + CONTACT)
    np.testing.assert_allclose(found[:2, :2], met(40.0, 3.0), rtol=1e-11)
    np.testing.assert_allclose(found[2], found[0], rtol=1e-11)
    np.testing.assert_allclose(found[:, 2], 0.0, atol=1e-13)
    for stretch in (0.0, 0.01):  # relaxed, or on its way to it
        free = derivative(mechanism, 0.25, np.array([0.0, 0.3, stretch]))
        expected = [[1.0, 0.25, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, math.exp(-10 / 3)]]
        np.testing.assert_allclose(free, expected, rtol=1e-12, atol=1e-15)


def test_a_body_that_comes_to_rest_forgets_its_speed() -> None:
    # It slides for v^2 m / (2 F) and stays there.
    friction = {"floor": Friction(BETWEEN, 0.3)}
    mechanism = Mechanism({"body": Body(2.0)}, frictions=friction, start={"body": (0.1, 0.6)})
    np.testing.assert_allclose(derivative(mechanism, 5.0), [[1.0, 4.0], [0.0, 0.0]], rtol=1e-12, atol=1e-13)


def test_a_body_that_is_pushed_back() -> None:
    # It is slowed down at 2.5 m/s^2 and then accelerated at 1.5 m/s^2 the other way.
    speed, duration = 1.1, 0.9
    mechanism = Mechanism(
        {"body": Body(1.0)},
        frictions={"floor": Friction(BETWEEN, 0.5)},
        forces={"push": Force("body", -2.0)},
        start={"body": (0.0, speed)},
    )
    back = duration - speed / 2.5
    end = simulate(mechanism, duration).states(duration)
    assert end == pytest.approx([speed**2 / 5 - 0.75 * back**2, -1.5 * back], rel=1e-12)
    expected = [[1.0, 2 * speed / 5 + 1.5 * back / 2.5], [0.0, 1.5 / 2.5]]
    np.testing.assert_allclose(derivative(mechanism, duration), expected, rtol=1e-12, atol=1e-14)


@pytest.mark.parametrize("duration", [0.3, 1.25, 3.75, 7.04])
def test_over_many_steps_and_periods_it_is_the_flow(duration: float) -> None:
    mechanism = Mechanism(
        {"body": Body(2.0)},
        frequency=0.8,
        pins={"base": Pin("ground", 1.0)},
        links={"spring": Link(BETWEEN, 8.0, 0.6), "drive": Link(("base", "body"), 1e-3)},
    )
    expected = expm(np.array([[0.0, 1.0], [-4.0005, -0.3]]) * duration)
    np.testing.assert_allclose(derivative(mechanism, duration), expected, rtol=0, atol=1e-12)


def test_a_relaxing_spring_that_contact_sets_again_is_forgotten() -> None:
    relaxing, truncated = (forced_orbit(trimmer(law)).multipliers for law in list(ContactLaw)[:2])
    # The laws give nearly the same motion, as the digits of the definition do too.
    assert abs(relaxing[-1]) < 1e-12
    np.testing.assert_allclose(abs(relaxing[:-1]), abs(truncated), rtol=1e-6)
