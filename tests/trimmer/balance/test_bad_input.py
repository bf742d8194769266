"""What harmonic balance says to input that it cannot use."""

import math

import control
import numpy as np
import pytest

from tests.trimmer.balance.loops import FRICTION, THESIS_LOOP, s
from trimmer import Relay, ViscousFriction, limit_cycles
from trimmer.errors import FrequencyRangeError, LinearElementError, UnsupportedElementError
from trimmer.linear import UnsupportedSystemError


@pytest.mark.parametrize(
    ("G", "message"),
    [
        (control.tf([1, 0, 0], [1, 1]), "more zeros than poles"),
        (control.tf([1], [1, 0.5], 0.1), "discrete-time"),
        (control.tf([2], [1]), "constant gain"),
        (control.ss(-np.eye(2), np.eye(2), np.eye(2), np.zeros((2, 2))), "2 inputs and 2 outputs"),
        (control.frd([1, 1j, 1], [1, 2, 3]), "as many responses as frequencies, 4 or more"),
        (control.tf([0], [1, 1]), "identically zero"),
        (control.tf([math.nan], [1, 1]), "numerator of the system holds a number that is infinite or NaN"),
        (control.tf([1], [1, math.inf]), "denominator of the system holds a number that is infinite or NaN"),
        (control.ss([[math.nan]], [[1]], [[1]], [[0]]), "A of the system holds a number"),
        (control.ss([[-1]], [[1]], [[1]], [[math.inf]]), "D of the system holds a number"),
        (3.0, "float is not accepted"),
    ],
)
def test_a_system_that_cannot_be_used(G, message: str) -> None:
    with pytest.raises(UnsupportedSystemError, match=message):
        limit_cycles(G, FRICTION)


@pytest.mark.parametrize(
    ("G", "element", "error", "message"),
    [
        *(
            (THESIS_LOOP, each, LinearElementError, "does not depend on the amplitude")
            for each in (ViscousFriction(1.0), -2.0 * ViscousFriction(1.0), Relay(1.0) - Relay(1.0))
        ),
        (THESIS_LOOP, 3, UnsupportedElementError, "3 is not an element"),
        # 1/(s + 1) with -s added to s + 1 leaves the gain 1.
        (1 / (s + 1), Relay(1.0) - ViscousFriction(1.0), UnsupportedSystemError, "cancels the highest deriv"),
    ],
)
def test_an_element_that_cannot_be_used(G, element, error: type[Exception], message: str) -> None:
    with pytest.raises(error, match=message):
        limit_cycles(G, element)


def test_a_delay_is_accepted_as_pade_approximation() -> None:
    # 2 exp(-s)/(s + 1): the phase is -pi where atan(omega) + omega = pi, at 2.0288 (textbook value).
    delay = control.tf(*control.pade(1.0, 6))
    first = limit_cycles(2 / (s + 1) * delay, Relay(1.0))[0]
    assert first.omega == pytest.approx(2.028758, rel=1e-6)
    assert first.amplitude == pytest.approx(4 * 2 / math.pi / math.hypot(1, 2.028758), rel=1e-6)


@pytest.mark.parametrize(
    "omegas", [(2, 1), (0, 1), (-1, 1), (1, math.inf), (math.nan, 1), (1, math.nan), (1, 1), (1, 2, 3), (1,)]
)
def test_a_range_that_cannot_be_used(omegas) -> None:
    with pytest.raises(FrequencyRangeError, match="0 < lowest < highest"):
        limit_cycles(THESIS_LOOP, FRICTION, omega_range=omegas)
