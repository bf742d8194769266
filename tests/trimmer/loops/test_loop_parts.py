"""Loops and where their motions start: what is kept, refused and shown, and states of elements at t = 0."""

import math

import control
import numpy as np
import pytest
import tqdm

from trimmer import Relay, TrimmerLoop, TrimmerParameters, ViscousBacklash, ViscousFriction, simulate
from trimmer.elements import CoulombFriction, FrictionBacklash, InertiaBacklash
from trimmer.errors import IllPosedLoopError
from trimmer.loops import BodyFriction, ClosedLoop, Drive, OpenLoop, Outcome, SimulationInterrupted
from trimmer.thesis import Displacement, InputChannels, TrimmerBody

THESIS = TrimmerParameters.thesis()
SYSTEM = control.ss([[0.0, 1.0], [-4.0, -0.5]], [[3.0], [7.0]], [[0.6, 0.0]], 0)
ELEMENT = 2.0 * FrictionBacklash(0.1) + 3.0 * ViscousFriction(0.4)
DRIVE = Drive(0.3, 5.0, 0.2)
GAP = 4e-5
BLADES = BodyFriction("q2-q4", 3.0 * CoulombFriction(0.5) + ViscousFriction(0.2))
MOUNT = BodyFriction(Displacement(TrimmerBody.MOTOR), CoulombFriction(0.7))


def test_which_states_have_a_meaning() -> None:
    for system, meant in ((SYSTEM, True), (control.tf([1.0], [1.0, 2.0, 3.0]), False)):
        assert ClosedLoop(system, ELEMENT).has_states == OpenLoop(system, ELEMENT, DRIVE).has_states == meant
    assert TrimmerLoop(THESIS).has_states
    assert repr(OpenLoop(SYSTEM, ELEMENT, DRIVE)).startswith("OpenLoop(<StateSpace of order 2>, ")


def test_a_trimmer_shows_its_parts_and_names_its_components() -> None:
    loop = TrimmerLoop(THESIS, 2.0 * FrictionBacklash(GAP), DRIVE, frictions=[BLADES, MOUNT])
    assert loop.interconnection().labels == (
        *("backlash", "friction q2-q4", "viscous friction q2-q4", "friction q1"),
    )
    assert repr(loop) == (
        f"TrimmerLoop({loop.element!r}, {DRIVE!r}, output {loop.output.label}, {BLADES!r}, {MOUNT!r})"
    )
    assert repr(TrimmerLoop(THESIS, output="q3")) == "TrimmerLoop(output q3)"
    assert TrimmerLoop(THESIS).channels is InputChannels.DISPLACEMENT_AND_VELOCITY
    assert TrimmerLoop(THESIS, channels="displacement").channels is InputChannels.DISPLACEMENT_ONLY


def test_states_and_an_impulse_add() -> None:
    system = control.ss([[0.0, 1.0], [-4.0, -1.0]], [[0.5], [2.0]], [[1.0, 0.0]], 0)
    given = np.array([0.1, -0.2])
    loop = ClosedLoop(system, FrictionBacklash(9.0))
    motion = simulate(loop, 1.0, initial_state=given, impulse=0.3, element_output=0.25)
    assert motion.state(0.0) == pytest.approx([0.1 + 0.15, -0.2 + 0.6], rel=1e-14)
    assert motion.element_output(0.0) == 0.25
    assert given.tolist() == [0.1, -0.2]
    trimmer = TrimmerLoop(THESIS, FrictionBacklash(GAP))
    start = simulate(trimmer, 1e-3, impulse=1e-6).state(0.0)
    assert start == pytest.approx(1e-6 * trimmer.model.B[:, 0], rel=1e-14)


@pytest.mark.parametrize("element", [FrictionBacklash(GAP), ViscousBacklash(GAP, 0.02), InertiaBacklash(GAP)])
@pytest.mark.parametrize(
    ("pin", "asked", "found"),
    [(0.0, 1e-5, 1e-5), (2e-5, 0.0, 0.0), (-2e-5, 0.0, 0.0), (3e-5, 0.0, 1e-5), (-3e-5, 0.0, -1e-5)],
)
def test_a_load_starts_where_it_is_asked_to_or_in_contact(element, pin, asked, found) -> None:
    loop = ClosedLoop(control.ss(control.tf([1.0], [1.0, 0.3, 1.0])), element)
    row = loop.model.C[0]
    motion = simulate(loop, 1e-9, initial_state=-pin * row / (row @ row), element_output=asked)
    assert motion.element_input(0.0) == pytest.approx(pin, rel=1e-12)
    assert motion.element_output(0.0) == pytest.approx(found, rel=1e-9)


@pytest.mark.parametrize("x", [0.4, -0.4, 0.0])
@pytest.mark.parametrize("v", [0.9, -0.9])
def test_a_relay_at_zero_starts_by_the_rate_of_its_input(x: float, v: float) -> None:
    loop = ClosedLoop(control.ss([[0.0, 1.0], [-9.0, -0.2]], [[0.0], [2.0]], [[1.0, 0.0]], 0), Relay(0.7))
    motion = simulate(loop, 1e-9, initial_state=[x, v])
    assert motion.element_output(5e-10) == -math.copysign(0.7, x or v)


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_rounding_has_no_sign(side: float) -> None:
    """The input is zero but for its last digit, and the output that would bring it back holds it there."""
    system = control.ss([[0.0, 3.0], [-9.0, -0.2]], [[2.0 * side], [0.0]], [[side, side]], 0)
    for x, held in ((0.3, True), (np.nextafter(0.3, 1.0), True), (0.3 + 1e-12, False), (0.3 - 1e-12, False)):
        motion = simulate(ClosedLoop(system, Relay(3.0)), 1e-15, initial_state=[x, -0.3])
        assert (abs(motion.element_output(0.0)) < 2.9) == held


def test_what_cannot_move_is_refused_with_its_name() -> None:
    acting = control.ss([[0.0, 1.0], [-9.0, -0.2]], [[1.0], [5.0]], [[1.0, 0.0]], 0)
    with pytest.raises(IllPosedLoopError, match="friction: a force acts on its own rate at once"):
        simulate(ClosedLoop(acting, FrictionBacklash(1.0) + CoulombFriction(0.5)), 1.0)


def test_as_many_parts_as_one_likes_move_as_one_that_does_what_they_do() -> None:
    many, one = sum([Relay(1.0)] * 7, FrictionBacklash(1.0)), FrictionBacklash(1.0) + 7.0 * Relay(1.0)
    ours, theirs = (simulate(ClosedLoop(SYSTEM, each), 1.0, impulse=0.3) for each in (many, one))
    times = np.linspace(0.0, 1.0, 11)
    np.testing.assert_allclose(ours.output(times), theirs.output(times), rtol=0, atol=1e-12)


def test_a_long_motion_that_is_interrupted_is_known_until_then(monkeypatch: pytest.MonkeyPatch) -> None:
    """Ctrl-C when progress is told, after a million steps; the bar is taken away."""
    closed: list[object] = []

    def pressed(self: object, more: float) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(tqdm.tqdm, "close", lambda self: closed.append(self))

    loop = ClosedLoop(
        control.ss([[0.0, 1.0], [-4.0, 0.0]], [[0.0], [1.0]], [[1.0, 0.0]], 0), FrictionBacklash(9.0)
    )
    monkeypatch.setattr(tqdm.tqdm, "update", pressed)
    with pytest.raises(SimulationInterrupted, match=r"interrupted after \S+ s of the motion") as raised:
        simulate(loop, 1e9, initial_state=[1.0, 0.0])
    motion = raised.value.motion
    assert len({id(each) for each in closed}) == 1
    assert (motion.outcome, motion.success, motion.message) == (Outcome.INTERRUPTED, False, "interrupted")
    assert motion.duration > 1e5
    assert motion.state(3.0) == pytest.approx([math.cos(6.0), -2.0 * math.sin(6.0)], rel=1e-11)


def test_numbers_of_a_trimmer_are_in_their_units() -> None:
    ends = Displacement(TrimmerBody.CUTTER, TrimmerBody.GUARD)
    frictions = tuple(BodyFriction(ends, law) for law in (CoulombFriction(0.5), ViscousFriction(2.0)))
    loop = TrimmerLoop(THESIS, ViscousBacklash(4e-5, 1e-3), DRIVE, frictions=frictions)
    told = {
        place: unit for place, unit in loop.places.items() if not place.startswith(("parameters", "start"))
    }
    assert told == {
        **{"frequency": "Hz", "drive.amplitude": "m", "drive.phase": "rad"},
        **{"element.gap": "m", "element.time_constant": "s"},
        **{"frictions.q2-q4.force": "N", 'frictions."q2-q4 2".damping': "N s/m"},
    }
