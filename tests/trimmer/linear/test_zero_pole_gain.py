import control
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.trimmer.trimmers import stable_systems
from trimmer.linear import UnsupportedSystemError, ZeroPoleGain, pin_model, transfer_function
from trimmer.thesis import TrimmerParameters

THESIS = TrimmerParameters.thesis()


@settings(max_examples=10)
@given(stable_systems(), st.floats(-2, 2))
def test_gain_and_phase_are_those_of_the_response(system: control.TransferFunction, exponent: float) -> None:
    omega = 10**exponent
    factored = ZeroPoleGain.of(system)
    response = complex(system(1j * omega))
    assert np.exp(factored.log_gain(omega)) == pytest.approx(abs(response), rel=1e-7)
    assert np.exp(1j * factored.phase(omega)) == pytest.approx(response / abs(response), abs=1e-7)


@pytest.mark.parametrize("omega", [0.3, 2.9, 3.1, 40.0])
def test_a_pair_on_the_axis_turns_the_phase_by_a_half(omega: float) -> None:
    system = control.tf([1, 0, 9], [1, 3, 3, 1])
    response = (9 - omega**2) / (1 + 1j * omega) ** 3
    assert np.exp(1j * ZeroPoleGain.of(system).phase(omega)) == pytest.approx(response / abs(response))


@settings(max_examples=10)
@given(stable_systems())
def test_the_phase_is_continuous(system: control.TransferFunction) -> None:
    factored = ZeroPoleGain.of(system)
    for place in (*np.abs(factored.roots), *np.abs(factored.roots.imag)):
        before, after = factored.phase(place * np.array([1 - 1e-7, 1 + 1e-7]))
        assert after == pytest.approx(before, abs=0.1)


def test_zeros_of_a_high_relative_degree_with_feedthrough_and_of_none() -> None:
    system = control.tf([1, 3], np.poly([-1, -2, -5, -7, -11, -13]))
    factored = ZeroPoleGain.of(control.ss(system))
    assert factored.relative_degree == 5
    assert factored.zeros == pytest.approx((-3,), rel=1e-9)
    assert factored.gain == pytest.approx(1.0, rel=1e-9)
    through = ZeroPoleGain.of(control.ss([[-1.0]], [[1.0]], [[1.0]], [[2.0]]))  # 2 + 1/(s + 1)
    assert (through.gain, through.zeros) == (2.0, (pytest.approx(-1.5),))
    for constant in (control.ss([], [], [], [[-4.0]]), control.tf([-4.0], [1.0])):
        assert ZeroPoleGain.of(constant) == ZeroPoleGain(-4.0, (), ())


def test_roots_of_an_undamped_system_lie_on_the_axis() -> None:
    undamped = TrimmerParameters(**{**vars(THESIS), "c1": 0, "c2": 0, "c3": 0, "c4": 0})
    for system in (pin_model(undamped), transfer_function(undamped)):
        factored = ZeroPoleGain.of(system)
        assert {root.real for root in factored.poles + factored.zeros} == {0.0}


@pytest.mark.parametrize(
    ("numerator", "denominator", "expected"),
    [
        *(([2], [1, 4], 0.5), ([1, 0], [1, 4], 0.0), ([1], [1, 0], np.inf), ([-1], [1, 2], -0.5)),
        ([3, 0], [1, 4, 0], 0.75),
    ],
)
def test_static_gain(numerator, denominator, expected) -> None:
    assert ZeroPoleGain.of(control.tf(numerator, denominator)).static_gain == pytest.approx(expected)


@pytest.mark.parametrize(
    "system",
    [
        control.tf([0], [1, 1]),
        control.ss([[-1.0]], [[0.0]], [[1.0]], [[0.0]]),
        control.ss([], [], [], [[0.0]]),
    ],
)
def test_a_zero_system_is_refused(system: control.lti.LTI) -> None:
    with pytest.raises(UnsupportedSystemError, match="identically zero"):
        ZeroPoleGain.of(system)
