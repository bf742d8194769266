"""Lines of an oscillator in displacement, velocity and acceleration, against its formula."""

from __future__ import annotations

import math

import numpy as np
import pytest

from tests.trimmer.design.made import oscillator
from trimmer.fitting.model import Model
from trimmer.fitting.unknowns import Unknown

STIFFNESS = Unknown("links.spring.stiffness", "N/m", 9e3, True)
MASS = Unknown("bodies.block.mass", "kg", 0.5, False)


def model(derivatives: int, period_count: int = 1, count: int = 3) -> Model:
    outputs = ("double", "block")
    return Model(oscillator(), (STIFFNESS, MASS), outputs, (derivatives, 0), period_count, count)


def wave(stiffness: float, mass: float) -> complex:
    """Return the complex amplitude of the displacement, driven by 7 N sin(w t)."""
    omega = 40 * math.pi
    return -7j / (stiffness - mass * omega**2 + 4j * omega)


@pytest.mark.parametrize("derivatives", [0, 1, 2])
def test_lines_are_those_of_the_quantity_that_was_measured(derivatives: int) -> None:
    found = model(derivatives).settled(np.array([math.log(1.1), 0.2]))
    assert found is not None
    expected = wave(9.9e3, 0.6)
    assert found.lines[0, 0] == pytest.approx(-2 * expected * (40j * math.pi) ** derivatives, rel=1e-9)
    assert found.lines[0, 1] == pytest.approx(expected, rel=1e-9)
    assert abs(found.lines[1:]).max() < 1e-9 * abs(found.lines[0]).min() * (40 * math.pi) ** derivatives * 9
    assert found.coordinates.tolist() == [math.log(1.1), 0.2]
    assert found.orbit.mechanism.value(STIFFNESS.place) == pytest.approx(9.9e3)


def test_lines_lie_at_fractions_of_the_drive_if_the_motion_was_measured_so() -> None:
    found = model(1, 3, 4).settled(np.zeros(2))
    assert found is not None
    expected = wave(9e3, 0.5)
    assert found.lines.shape == (4, 2)
    np.testing.assert_allclose(found.lines[2], [-2 * expected * 40j * math.pi, expected], rtol=1e-9)
    assert abs(found.lines[[0, 1, 3], 1]).max() < 1e-9 * abs(expected)


def test_a_motion_goes_on_from_a_neighbour() -> None:
    of = model(0)
    near = of.settled(np.zeros(2))
    assert near is not None
    for settling in (0, 48):
        found = of.continued(np.array([math.log(1.2), -0.1]), near, settling)
        assert found is not None
        assert found.lines[0, 1] == pytest.approx(wave(1.08e4, 0.45), rel=1e-9)


def test_numbers_that_no_mechanism_can_have_have_no_motion() -> None:
    of = model(0)
    near = of.settled(np.zeros(2))
    assert near is not None
    assert of.settled(np.array([0.0, -1.5])) is None
    assert of.continued(np.array([0.0, -1.5]), near) is None
