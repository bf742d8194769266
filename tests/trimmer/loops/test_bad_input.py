"""Wrong arguments: the error names the argument, its value and what is wrong; so of drives."""

import math
import pickle
from dataclasses import replace

import control
import pytest

from trimmer import ClosedLoop, Drive, OpenLoop, TrimmerLoop, TrimmerParameters, simulate
from trimmer.elements import CoulombFriction, Element, FrictionBacklash, Relay, ViscousBacklash
from trimmer.errors import IllPosedLoopError, UnsupportedMotionError

THESIS = TrimmerParameters.thesis()
LOOP = TrimmerLoop(THESIS, FrictionBacklash(4e-5))
SYSTEM = control.tf([2.0], [1.0, 0.4, 3.0])
DRIVE = Drive(1e-3, 100.0)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"duration": 0}, "duration must be positive and finite (s), not 0"),
        ({"duration": -1.0}, "duration must be positive and finite (s), not -1.0"),
        ({"duration": math.nan}, "duration must be positive and finite (s), not nan"),
        ({"duration": math.inf}, "duration must be positive and finite (s), not inf"),
        ({"event_limit": 0}, "event_limit must be a whole number of at least 1, not 0"),
        ({"event_limit": 1.5}, "event_limit must be a whole number of at least 1, not 1.5"),
        ({"event_limit": math.nan}, "event_limit must be a whole number of at least 1, not nan"),
        ({"step_limit": math.inf}, "step_limit must be a whole number of at least 1, not inf"),
        ({"impulse": math.inf}, "impulse must be finite, not inf"),
        ({"element_output": math.nan}, "element_output must be finite, not nan"),
        ({"initial_state": [1.0, 2.0]}, "initial_state must have shape (8,), not (2,)"),
        ({"initial_state": [math.nan] * 8}, "initial_state must be finite"),
        ({"initial_state": [1j] * 8}, "initial_state must be a real number"),
    ],
)
def test_arguments_of_simulate(arguments: dict[str, object], message: str) -> None:
    with pytest.raises(ValueError) as error:
        simulate(LOOP, **{"duration": 1.0, **arguments})  # type: ignore[arg-type]
    assert message in str(error.value)


def test_limits_may_be_any_whole_number() -> None:
    motion = simulate(LOOP, 1e-3, impulse=1e-6, event_limit=10**30, step_limit=10**30)
    assert len(motion.events) > 0


def test_a_transfer_function_has_no_states_to_start_from() -> None:
    with pytest.raises(ValueError, match=r"give a control.StateSpace"):
        simulate(ClosedLoop(SYSTEM, Relay(1.0)), 1.0, initial_state=[1.0, 1.0])


@pytest.mark.parametrize(
    ("system", "message"),
    [
        (control.tf([2.0, 1.0, 1.0], [1.0, 1.0]), "more zeros than poles"),
        (control.ss([[-1.0]], [[1.0, 1.0]], [[1.0]], [[0.0, 0.0]]), "one input and one output, not 2 and 1"),
        (control.tf([1.0], [1.0, 0.5], 0.1), "continuous in time, not sampled"),
        (control.frd([1.0, 2.0], [1.0, 2.0]), "not FrequencyResponseData"),
    ],
)
def test_systems_that_have_no_motion(system: control.LTI, message: str) -> None:
    with pytest.raises(UnsupportedMotionError, match=message):
        simulate(ClosedLoop(system, Relay(1.0)), 1.0)


@pytest.mark.parametrize(
    ("system", "name"), [(control.ss(math.nan, 1.0, 1.0, 0), "A"), (control.ss(-1.0, 1.0, math.inf, 0), "C")]
)
def test_values_of_the_system_must_be_finite(system: control.StateSpace, name: str) -> None:
    with pytest.raises(ValueError, match=f"{name} of the system must be finite"):
        simulate(ClosedLoop(system, Relay(1.0)), 1.0)


@pytest.mark.parametrize(
    ("system", "element", "message"),
    [
        (control.tf([2.0], [1.0]), FrictionBacklash(1.0), "backlash: .* strictly proper"),
        (control.tf([2.0, 1.0, 3.0], [1.0, 1.0, 5.0]), FrictionBacklash(1.0), "backlash: .* strictly proper"),
        (control.tf([2.0, 1.0], [1.0, 1.0]), Relay(1.0), "relay: .* strictly proper"),
        (control.tf([1.0], [1.0, 1.0]), CoulombFriction(1.0), "friction: .* two more poles than zeros"),
    ],
)
def test_loops_whose_motion_is_not_determined(system: control.LTI, element: Element, message: str) -> None:
    with pytest.raises(IllPosedLoopError, match=message):
        simulate(ClosedLoop(system, element), 1.0)


@pytest.mark.parametrize("element", [Relay(1.0), CoulombFriction(1.0)])
def test_a_relay_that_is_driven_by_nothing_has_no_output(element: Element) -> None:
    with pytest.raises(IllPosedLoopError, match="its input stays at zero, and its output is not determined"):
        simulate(OpenLoop(SYSTEM, element, Drive(0.0, 1.0)), 1.0)


def test_an_element_frozen_at_a_frequency_has_no_motion() -> None:
    frozen = ViscousBacklash(1.0, 1.0).at(3.0)
    with pytest.raises(UnsupportedMotionError, match="its motion is that of ViscousBacklash"):
        simulate(ClosedLoop(SYSTEM, frozen), 1.0)


@pytest.mark.parametrize("value", [0.0, -1.0, math.nan, math.inf])
def test_no_gap_and_no_friction_are_said_by_leaving_them_out(value: float) -> None:
    with pytest.raises(ValueError, match="gap must be positive and finite"):
        FrictionBacklash(value)
    with pytest.raises(ValueError, match="force must be positive and finite"):
        CoulombFriction(value)


def test_frequency_and_omega_give_the_same_drive() -> None:
    by_omega, by_frequency = Drive(1e-3, 2 * math.pi * 110, 0.5), Drive(1e-3, frequency=110, phase=0.5)
    assert by_omega == by_frequency == Drive(1e-3, omega=2 * math.pi * 110, phase=0.5)
    assert hash(by_omega) == hash(by_frequency)
    assert by_frequency.frequency == pytest.approx(110.0, rel=1e-15)
    assert repr(by_frequency) == repr(by_omega)
    assert pickle.loads(pickle.dumps(by_frequency)) == by_frequency
    assert replace(by_frequency, amplitude=2e-3) == Drive(2e-3, by_omega.omega, 0.5)
    assert Drive(1, 2) == Drive(1.0, 2.0)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({}, "a drive needs omega .* or frequency .*, and one only: neither is given"),
        ({"omega": 691.0, "frequency": 110.0}, "one only: omega=691.0 and frequency=110.0 is given"),
        ({"frequency": 0.0}, r"frequency of the drive must be positive \(Hz\), not 0.0"),
        ({"frequency": -1.0}, r"frequency of the drive must be positive \(Hz\), not -1.0"),
        ({"frequency": math.nan}, "frequency of the drive must be finite, not nan"),
        ({"frequency": 1e308}, "omega of the drive must be finite, not inf"),
        ({"omega": -1.0}, r"omega of the drive must be positive \(rad/s\), not -1.0"),
        ({"omega": 0.0}, r"omega of the drive must be positive \(rad/s\), not 0.0"),
        ({"omega": math.inf}, "omega of the drive must be finite, not inf"),
        ({"omega": 1.0, "amplitude": -1.0}, "amplitude of the drive must not be negative, not -1.0"),
        ({"omega": 1.0, "amplitude": math.nan}, "amplitude of the drive must be finite, not nan"),
        ({"omega": 1.0, "phase": math.nan}, "phase of the drive must be finite, not nan"),
        ({"frequency": "110"}, r"frequency of the drive must be a real number \(Hz\), not '110'"),
        ({"omega": 1j}, r"omega of the drive must be a real number \(rad/s\), not 1j"),
        ({"omega": 1.0, "phase": None}, r"phase of the drive must be a real number \(rad\), not None"),
        ({"omega": 1.0, "amplitude": [1.0]}, r"amplitude of the drive must be a real number .* not \[1\.0\]"),
    ],
)
def test_a_drive_that_has_no_frequency_is_an_error(options: dict[str, object], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        Drive(**{"amplitude": 1e-3, **options})  # type: ignore[arg-type]
