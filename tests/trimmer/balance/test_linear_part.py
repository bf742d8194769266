"""The linear part of elements: taken off exactly, and put round the system with poles to the last digits."""

import mpmath
import numpy as np
import pytest

from tests.quick import quick
from trimmer.balance.inverse_response import InverseResponse
from trimmer.balance.linear_part import LinearGain, parted, with_feedback
from trimmer.elements import Element, FrictionBacklash, Relay, ViscousFriction
from trimmer.linear import UnsupportedSystemError


def response(
    gain: float, poles: list[complex], zeros: list[complex], reference: float = 1.0
) -> InverseResponse:
    return InverseResponse(gain, np.array(poles, complex), np.array(zeros, complex), reference)


def exact_roots(given: InverseResponse, feedback: LinearGain) -> list[complex]:
    """Return the roots of gain * prod(s - pole) + (c + d s) prod(s - zero), to 40 digits of 120."""
    with mpmath.workdps(120):

        def times(coefficients: list[mpmath.mpc], first: complex, last: complex) -> list[mpmath.mpc]:
            """Multiply by first s + last, highest power first."""
            return [
                mpmath.mpc(first) * one + mpmath.mpc(last) * other
                for one, other in zip([*coefficients, 0], [0, *coefficients], strict=True)
            ]

        poles, zeros = [mpmath.mpc(given.gain)], [mpmath.mpc(1)]
        for pole in given.poles:
            poles = times(poles, 1.0, -complex(pole))
        for zero in given.zeros:
            zeros = times(zeros, 1.0, -complex(zero))
        added = times(zeros, mpmath.mpf(feedback.damping) * mpmath.mpf(given.reference), feedback.constant)
        total = [
            one + other for one, other in zip(poles, [0] * (len(poles) - len(added)) + added, strict=True)
        ]
        return [complex(root) for root in mpmath.polyroots(total, maxsteps=500, extraprec=400)]


def distances(found: np.ndarray, exact: list[complex]) -> np.ndarray:
    """Return the distance of each exact root from the nearest found one, over its size."""
    return np.array([np.abs(found - root).min() / abs(root) for root in exact])


@pytest.mark.parametrize("feedback", [LinearGain(0.3), LinearGain(damping=0.02), LinearGain(-1.5, 0.4)])
@pytest.mark.parametrize("reference", quick([1.0, 7.0], 1))
def test_poles_of_the_loop_are_right_to_the_last_digits(feedback: LinearGain, reference: float) -> None:
    """Twelve poles in a row: NumPy's roots of the polynomial are off by 1e-9, the polished ones are not."""
    poles = [-float(k) for k in range(1, 13)]
    given = response(1e-3, poles, [-2.5, -6.0 + 1j, -6.0 - 1j], reference)
    exact = exact_roots(given, feedback)
    found = with_feedback(given, feedback)
    assert distances(found.poles, exact).max() < 1e-14
    assert len(found.poles) == len(exact)
    assert np.array_equal(found.zeros, given.zeros)
    assert found.reference == reference


def test_poles_on_the_axis_stay_there_and_are_in_order() -> None:
    """1/G = s² (s + 1) + 9 (s + 1): poles at -1 and at ±3j, to rounding on the axis."""
    found = with_feedback(response(1.0, [0.0, 0.0, -1.0], [-1.0]), LinearGain(9.0))
    assert found.poles.real[1:].tolist() == [0.0, 0.0]
    assert sorted(found.poles.imag) == pytest.approx([-3.0, 0.0, 3.0], rel=1e-14)
    assert np.abs(found.poles) == pytest.approx([1.0, 3.0, 3.0], rel=1e-14)


def test_a_double_pole_is_left_where_it_is() -> None:
    """s² + 2 s + 1, where Weierstrass's step divides by the distance of two equal roots."""
    with np.errstate(all="raise"):
        found = with_feedback(response(1.0, [0.0, 0.0], []), LinearGain(1.0, 2.0))
    assert found.poles == pytest.approx([-1.0, -1.0], abs=1e-6)


@pytest.mark.parametrize("rest", [0.0, 1e-16])
@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_a_loop_that_loses_its_highest_derivative_is_refused(rest: float, sign: float) -> None:
    given = response(0.4 * sign, [-1.0], [])
    with pytest.raises(UnsupportedSystemError, match="cancels the highest derivative"):
        with_feedback(given, LinearGain(damping=-0.4 * sign * (1.0 - rest)))
    assert with_feedback(given, LinearGain(damping=-0.3 * sign)).poles == pytest.approx([-4.0])


def test_a_highest_derivative_that_is_more_than_rounding_is_kept() -> None:
    """Of 2**-13 (s + 1000) all but 2**-53 s is taken away; powers of two, so that nothing is rounded."""
    given = response(2.0**-13, [-1000.0], [])
    found = with_feedback(given, LinearGain(damping=-(2.0**-13) * (1.0 - 2.0**-40)))
    assert (found.gain, found.poles.tolist()) == (2.0**-53, [-1000.0 * 2.0**40])


def test_poles_are_on_the_axis_only_where_rounding_alone_keeps_them_off() -> None:
    # s (s + 1)(s + 2) + 6 = (s + 3)(s² + 2).
    found = with_feedback(response(1.0, [0.0, -1.0, -2.0], []), LinearGain(6.0))
    assert found.poles.real.tolist()[:2] == [0.0, 0.0]
    assert found.poles == pytest.approx([1j * 2**0.5, -1j * 2**0.5, -3.0]) or found.poles == pytest.approx(
        [-1j * 2**0.5, 1j * 2**0.5, -3.0]
    )
    assert found.is_real
    # s (s + 1e9) + 1: the slow one is no rounding of the fast one.
    slow, fast = with_feedback(response(1.0, [0.0, -1e9], []), LinearGain(1.0)).poles
    assert (slow, fast) == (pytest.approx(-1e-9, rel=1e-12), pytest.approx(-1e9, rel=1e-12))


AMPLITUDES = np.array([1.2, 3.0, 40.0])
PLAY, VISCOUS = FrictionBacklash(1.0), ViscousFriction(0.7)


@pytest.mark.parametrize(
    "element",
    [
        PLAY,
        PLAY + VISCOUS,
        2.0 * (PLAY + 3.0 * VISCOUS) + Relay(0.5),
        (PLAY - VISCOUS).at(5.0),
        2.0 * (VISCOUS.at(4.0) + PLAY) - VISCOUS,
        VISCOUS.at(4.0) + PLAY + 3.0 * VISCOUS.at(9.0),
    ],
    ids=repr,
)
def test_linear_part_and_rest_make_the_element(element: Element) -> None:
    linear, rest = parted(element)
    assert rest is not None
    for omega in (0.3, 5.0):
        whole = element.describing_function(AMPLITUDES, np.full(3, omega))
        parts = linear.value(np.full(3, omega)) + rest.describing_function(AMPLITUDES, np.full(3, omega))
        assert parts == pytest.approx(whole, rel=1e-13)
    far = rest.describing_function(np.array([1e9, 2e9]), np.full(2, 5.0))
    assert abs(far[0] - far[1]) < 1e-8  # bounded: nothing grows with the amplitude


@pytest.mark.parametrize(
    ("element", "damping"), [(VISCOUS, 0.7), (VISCOUS + 2.0 * VISCOUS, 2.1), (-1.0 * VISCOUS, -0.7)]
)
def test_of_a_linear_element_nothing_is_left(element: Element, damping: float) -> None:
    linear, rest = parted(element)
    assert rest is None
    assert linear.damping == pytest.approx(damping)
    assert linear.constant == 0.0


def test_what_is_left_of_one_term_is_that_term() -> None:
    assert parted(PLAY + VISCOUS)[1] == PLAY
    assert parted(VISCOUS + PLAY + Relay(0.5))[1] == PLAY + Relay(0.5)
