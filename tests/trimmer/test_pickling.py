"""What is pickled, as for a pool of processes, behaves afterwards as before."""

import copy
import pickle
from collections.abc import Callable

import numpy as np
import pytest

from tests.public_names import public_names
from trimmer import (
    Signal,
    ViscousBacklash,
    ViscousFriction,
    analyse_signal,
    forced_orbit,
    harmonic_balance,
    identify_time_constant,
    limit_cycles,
    multi_harmonic_balance,
    periodic_orbits,
    simulate,
    summarise,
)
from trimmer.elements import CoulombFriction, Element, FrictionBacklash, InertiaBacklash, Relay
from trimmer.loops import BodyFriction, ClosedLoop, Drive, OpenLoop, TrimmerLoop, energy_balance
from trimmer.thesis import Displacement, TrimmerBody, TrimmerParameters, pin_model, transfer_function

THESIS = TrimmerParameters.thesis()
PLAY = FrictionBacklash(4e-5)
DRIVE = Drive(1.5e-3, frequency=110.0, phase=0.2)
FRICTION = BodyFriction(Displacement(TrimmerBody.CUTTER, TrimmerBody.GUARD), CoulombFriction(0.5))
TIMES = np.linspace(0.0, 0.02, 333)

LOOPS = {
    "closed": ClosedLoop(pin_model(THESIS), PLAY),
    "closed, as a fraction": ClosedLoop(transfer_function(THESIS), PLAY),
    "open": OpenLoop(pin_model(THESIS), ViscousBacklash(4e-5, 1e-3), DRIVE),
    "trimmer": TrimmerLoop(THESIS, PLAY, DRIVE, frictions=(FRICTION,)),
    "trimmer without play": TrimmerLoop(THESIS, drive=DRIVE),
}
ELEMENTS = [
    PLAY,
    InertiaBacklash(4e-5),
    ViscousBacklash(4e-5, 1e-3),
    CoulombFriction(0.5),
    Relay(1.0),
    ViscousFriction(2.0),
    -2.0 * PLAY,
    PLAY + CoulombFriction(0.5),
    ViscousBacklash(4e-5, 1e-3).at(4600.0),
]
COPIES = {"pickle": lambda value: pickle.loads(pickle.dumps(value)), "deepcopy": copy.deepcopy}


@pytest.fixture(params=COPIES.values(), ids=COPIES)
def copied(request: pytest.FixtureRequest) -> Callable:
    return request.param


@pytest.mark.parametrize("element", ELEMENTS, ids=repr)
def test_elements_are_equal_afterwards(element: Element, copied: Callable) -> None:
    again = copied(element)
    assert again == element
    amplitudes = np.geomspace(1e-5, 1e-2, 20)
    expected = element.describing_function(amplitudes, 4600.0)
    np.testing.assert_array_equal(again.describing_function(amplitudes, 4600.0), expected)


@pytest.mark.parametrize("loop", LOOPS.values(), ids=LOOPS)
@pytest.mark.parametrize("used", [False, True])
def test_loops_move_as_before(loop, used: bool, copied: Callable) -> None:
    fresh = copied(loop)
    if used:
        fresh.modes.tables  # noqa: B018
        fresh = copied(fresh)
    impulse = 0.0 if loop.modes.system.interconnection.drives else 1e-6
    before, after = (simulate(each, 0.02, impulse=impulse) for each in (loop, fresh))
    assert after.events == before.events
    np.testing.assert_array_equal(after.output(TIMES), before.output(TIMES))
    assert fresh.has_states == loop.has_states
    assert list(fresh.model.state_labels) == list(loop.model.state_labels)
    if loop.has_states:
        assert fresh.model.name == loop.model.name


@pytest.mark.parametrize("loop", LOOPS.values(), ids=LOOPS)
def test_motions_can_be_read_as_before(loop, copied: Callable) -> None:
    motion = simulate(loop, 0.02, impulse=0.0 if loop.modes.system.interconnection.drives else 1e-6)
    again = copied(motion)
    for name in ("output", "element_input", "element_output", "state", "component_outputs"):
        np.testing.assert_array_equal(getattr(again, name)(TIMES), getattr(motion, name)(TIMES))
    assert again.events == motion.events
    assert (again.outcome, again.success, again.message) == (motion.outcome, True, motion.message)
    if isinstance(loop, TrimmerLoop):
        assert energy_balance(again) == energy_balance(motion)


def test_orbits_are_as_before(copied: Callable) -> None:
    for orbit in (
        periodic_orbits(pin_model(THESIS), PLAY)[0],
        forced_orbit(TrimmerLoop(THESIS, FrictionBacklash(2e-4), DRIVE)),
    ):
        again = copied(orbit)
        np.testing.assert_array_equal(again.harmonics, orbit.harmonics)
        np.testing.assert_array_equal(again.multipliers, orbit.multipliers)
        assert again.stable == orbit.stable
        assert again.impacts == orbit.impacts
        assert again.stroke_of() == orbit.stroke_of()
        assert again.prediction == orbit.prediction
        assert len(pickle.dumps(orbit)) < 20_000  # Tables of its modes would take 600 000


def test_results_are_as_before(copied: Callable) -> None:
    system = pin_model(THESIS)
    balance, summary = harmonic_balance(system, PLAY), summarise(THESIS)
    assert copied(balance) == balance
    assert copied(summary) == summary
    told = identify_time_constant(system, PLAY.gap, 740.0, frequency_uncertainty=0.5)
    assert copied(told) == told
    (solution,) = multi_harmonic_balance(system, PLAY, limit_cycles(system, PLAY)[-1], [1])
    np.testing.assert_array_equal(copied(solution).harmonics, solution.harmonics)


def test_signals_stay_read_only(copied: Callable) -> None:
    signal = Signal(np.sin(np.arange(200.0)), 1000.0, "q2", "m")
    again = copied(signal)
    np.testing.assert_array_equal(again.values, signal.values)
    assert not again.values.flags.writeable
    first, second = analyse_signal(signal, 150.0), copied(analyse_signal(signal, 150.0))
    assert second.peaks == first.peaks
    assert not second.signal.values.flags.writeable


@pytest.mark.parametrize("name", sorted(public_names()))
def test_every_public_class_and_function_is_found_again(name: str) -> None:
    value = public_names()[name]
    assert pickle.loads(pickle.dumps(value)) == value
