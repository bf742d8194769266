"""What grows without bound, and what only seems to."""

import math
from dataclasses import replace

import numpy as np
import pytest

from tests.mechanisms.random_mechanisms import random_mechanism
from tests.quick import quick
from tests.trimmer.response.mechanisms import body, example
from trimmer import (
    ClosedLoop,
    Mechanism,
    MotionKind,
    OrbitNotFoundError,
    Relay,
    SerialRunner,
    basin,
    follow,
    forced_orbit,
    motion_map,
    respond,
    simulate,
)
from trimmer.branches import BranchEnd
from trimmer.maps import sweep
from trimmer.mechanism import Body, Force, Friction, Link, Output, Pin, Play
from trimmer.response import step_response
from trimmer.response.results.response_json import response_json
from trimmer.response.statistics.growth import grew


def resonant(rubs: float = 0.0, frequency: float = 1.0, **parts: object) -> Mechanism:
    """An undamped oscillator of 1 Hz, pushed by 3 N in each period."""
    parts |= {"frictions": {"floor": Friction(("ground", "body"), rubs)}} if rubs else {}
    links = {"spring": Link(("ground", "body"), (2 * math.pi) ** 2)}
    return body(frequency=frequency, links=links, forces={"push": Force("body", amplitude=3.0)}, **parts)


def test_what_was_lost_in_rounding_does_not_grow() -> None:
    """Velocities of 35 m/s at first, and later the rounding of what sticks; beside it one that does grow."""
    seen = [(7540.0, np.array([35.0])), (37700.0, np.array([1e-17])), (80786.0, np.array([3e-17]))]
    assert not grew(seen)
    assert not grew(seen, at_last=True)
    assert grew([(time, np.array([0.1 * time])) for time, _ in seen])


@pytest.mark.parametrize("state", [(0.1, 0.02, 0.003), (0.0, 0.001, 0.1), (0.0, 0.0, -1.0)])
def test_a_relay_that_latches_before_an_integrator_diverges(state: tuple[float, ...]) -> None:
    """From near an unstable orbit too: the static gain is negative, so that it drives its input on."""
    plant = ([2.7, -1.04], [1.0, 14.9, 54.7, 0.0])
    response = respond(ClosedLoop(plant, Relay(1.15, hysteresis=0.0094)), state=state)
    assert "in proportion to the time" in response.message


def test_an_undamped_resonance_diverges_and_beside_it_nothing_does() -> None:
    response = respond(resonant())
    content = response_json(response)
    assert (content["kind"], content["success"], content["period_count"]) == ("diverging", True, None)
    assert "grows for ever" in content["message"]
    assert content["outputs"] == {}
    assert respond(resonant(frequency=1.001)).kind is not MotionKind.DIVERGING
    # At a third of its frequency the third harmonic alone would meet it.
    assert respond(resonant(frequency=1 / 3)).kind is not MotionKind.DIVERGING


@pytest.mark.parametrize(("rubs", "grows"), quick([(0.95, True), (0.8, True), (1.05, False)], 1, 2))
def test_dry_friction_holds_a_resonance_from_a_quarter_of_pi_of_the_force_on(rubs, grows) -> None:
    """The work of the push in a period is pi P x, that of friction 4 F x (Den Hartog 1931)."""
    response = respond(resonant(rubs * 3.0 * math.pi / 4))
    assert (response.kind is MotionKind.DIVERGING) is grows
    assert response.success


@pytest.mark.parametrize("frequency", [2.0, None])
def test_a_constant_force_that_nothing_holds_or_damps_diverges(frequency: float | None) -> None:
    pushed = body(frequency=frequency, forces={"push": Force("body", constant=3.0)})
    response = respond(pushed)
    assert (response.kind, response.motion.orbit) == (MotionKind.DIVERGING, None)
    if frequency is None:
        with pytest.raises(OrbitNotFoundError, match="grows for ever"):
            forced_orbit(pushed)


def test_a_constant_force_beyond_friction_diverges_and_below_it_rests() -> None:
    """In maps and sweeps too, though a neighbour stays as near as on a torus."""

    def pushed(force: float, **wave: float) -> Mechanism:
        forces, frictions = (
            {"push": Force("body", constant=force, **wave)},
            {"floor": Friction(("ground", "body"), 1.0)},
        )
        return body(frequency=2.0, forces=forces, frictions=frictions, start={"body": (0.3, 0.7)})

    shaken, place = pushed(1.2, amplitude=0.5), "forces.push.constant"
    mapped = motion_map(shaken, {place: [0.2, 1.2]}, most_periods=300)
    assert mapped.kind.tolist() == [[MotionKind.REST, MotionKind.DIVERGING]]
    swept = sweep(shaken, place, 1.2, 1.4, steps=1, periods=220)
    assert {each.motion.kind for each in swept.points} == {MotionKind.DIVERGING}
    response = respond(pushed(1.2))
    assert response.kind is MotionKind.DIVERGING
    assert "in proportion to the time" in response.message
    rest = respond(pushed(0.6))
    assert rest.kind is MotionKind.REST
    # It slides on until its energy is lost to the difference of both forces.
    assert rest.motion.rest.positions["body"] == pytest.approx(0.3 + 0.7**2 / (2 * (1.0 - 0.6)), rel=1e-12)


def test_a_free_body_that_a_wave_pushes_goes_on_and_does_not_diverge() -> None:
    free = body(2.0, frequency=5.0, forces={"push": Force("body", amplitude=3.0)})
    content = response_json(respond(free))
    omega = 2 * math.pi * 5.0
    assert content["kind"] == "periodic"
    # From rest the velocity is F (1 - cos w t) / (m w).
    assert content["outputs"]["body"]["advance"] == pytest.approx(3.0 / (2.0 * omega) / 5.0, rel=1e-12)
    assert content["outputs"]["body"]["peak_to_peak"] == pytest.approx(2 * 3.0 / (2.0 * omega**2), rel=1e-9)


def test_what_moves_on_evenly_without_a_drive_repeats_after_any_time() -> None:
    def dragged(damping: float) -> Mechanism:
        oil = {"oil": Link(("ground", "body"), 0.0, damping)}
        return body(links=oil, forces={"push": Force("body", constant=3.0)})

    response = respond(dragged(4.0))
    content = response_json(response)
    assert (content["kind"], content["success"]) == ("periodic", True)
    assert content["outputs"]["body"]["advance"] / content["period"] == pytest.approx(0.75, rel=1e-12)
    assert response.motion.orbit.stable
    assert "any time is a period" in content["message"]
    branch = follow(dragged(4.0), "forces.push.constant", 3.0, 4.0)
    assert (branch.reason, branch.points) == (BranchEnd.NO_START, ())
    assert "there is nothing to follow: it moves on evenly" in branch.message
    pulled = body(
        pins={"winch": Pin("ground", velocity=0.2)},
        links={"rope": Link(("winch", "body"), 40.0, 2.0)},
        frictions={"floor": Friction(("ground", "body"), 0.5)},
        outputs={"body": Output({"body": 1.0}), "rope": Output({"body": 1.0, "winch": -1.0})},
    )
    content = response_json(respond(pulled))
    assert content["outputs"]["body"]["advance"] / content["period"] == pytest.approx(0.2, rel=1e-12)
    assert content["outputs"]["rope"]["mean"] == pytest.approx(-0.5 / 40.0, rel=1e-9)


def test_a_resonance_that_meets_a_stop_is_bounded() -> None:
    held = resonant(plays={"slot": Play(("ground", "body"), 2e3, 20.0, 0.5)})
    response = respond(held)
    assert response.kind in (MotionKind.PERIODIC, MotionKind.CHAOTIC)


@pytest.mark.parametrize("frequency", quick([2.0, None], 1))
def test_what_drifts_through_a_wide_gap_does_not_diverge(frequency: float | None) -> None:
    """It grows in proportion to the time, and meets the other side after half a million seconds."""
    slot = Play(("ground", "body"), stiffness=1e3, damping=5.0, gap=1e3)
    drifts = Mechanism(
        {"body": Body(1.0), "beside": Body(1.0)},
        links={"spring": Link(("ground", "beside"), stiffness=30.0, damping=1.0)},
        plays={"slot": slot},
        forces={"push": Force("beside", amplitude=1.0)} if frequency else {},
        frequency=frequency,
        start={"body": (0.0, 1e-3)},
    )
    assert respond(drifts).kind is MotionKind.UNDECIDED


def test_a_map_names_what_diverges() -> None:
    found = motion_map(resonant(0.5), {"frictions.floor.force": [0.5, 2.8]}, most_periods=200)
    assert found.kind.tolist() == [[MotionKind.DIVERGING, MotionKind.PERIODIC]]
    assert not found.failures


def test_what_friction_holds_rests_whatever_drives_it() -> None:
    """A moving pin behind a spring is a force to what friction holds; nothing may drift by rounding."""
    motion = respond(random_mechanism(86), most_periods=200).motion
    assert (motion.kind, motion.peak_to_peak) == (MotionKind.REST, {"asked for": 0.0})

    def held(**drive: object) -> Mechanism:
        floor = {"floor": Friction(("ground", "body"), 1.0)}
        return body(0.7, frequency=3.0, frictions=floor, start={"body": (0.01, 0.0)}, **drive)

    spring = {"spring": Link(("pin", "body"), 1234.5, 0.6)}
    pin = Pin("ground", amplitude=2e-4, phase=0.3, offset=0.01)
    pulled = respond(held(links=spring, pins={"pin": pin})).motion
    pushed = respond(held(forces={"push": Force("body", amplitude=0.25)})).motion
    assert pulled.kind is pushed.kind is MotionKind.REST
    assert pulled.rest.positions == pushed.rest.positions == {"body": 0.01}


EXPLOSIVE = """
[bodies]
mass = { mass = 1.0 }
[outputs]
x = { mass = 1 }
[references]
path = { step = 1.0 }
[controllers.lever]
kind = "pid"
measure = "x"
acts = ["ground", "mass"]
reference = "path"
"""


@pytest.mark.parametrize(
    ("seconds", "frequency", "told"),
    [
        (0.4, 1.0, "it could be followed for 0 drive periods only: "),
        (1.3, 1.0, "it diverges: after 1 drive period "),
        (4.6, 1.0, "it diverges: after 4 drive periods "),
        (0.4, None, "it diverges: within 0.384774 s "),
        (4.6, None, "it diverges: within 4.45284 s "),
    ],
)
def test_what_explodes_is_told_to_by_all_that_ask(seconds: float, frequency: float | None, told: str) -> None:
    """A lever pushes away with k times the distance: it grows like exp(sqrt(k) t), to 1e154 and beyond."""
    machine = Mechanism.from_toml_text(f"{EXPLOSIVE}kp = {-((math.log(1e154) / seconds) ** 2)!r}")
    machine, told = replace(machine, frequency=frequency), f"{told}it grew beyond all bounds"
    place = "frequency" if frequency else "bodies.mass.mass"
    failed = "it grew beyond all bounds" if "only" in told else ""
    kind = MotionKind.UNDECIDED if failed else MotionKind.DIVERGING
    moved = simulate(machine, 10.0)
    assert (moved.success, moved.message) == (False, "it grew beyond all bounds")
    assert 0.9 * seconds < moved.duration < 1.1 * seconds
    found = respond(machine, starts=2)
    assert found.message.lower().startswith(told)
    assert [(each.kind, each.orbit, each.window) for each in found.motions[:1]] == [(kind, None, None)]
    with pytest.raises(OrbitNotFoundError, match="it grew beyond all bounds"):
        forced_orbit(machine)
    branch = follow(machine, place, 1.0, 1.1)
    assert (branch.points, branch.reason) == ((), BranchEnd.NO_START)
    assert told in branch.message
    stepped = step_response(machine, "path")
    assert stepped.settles_to.message.lower().startswith(told)
    assert (stepped.ending, stepped.hunting) == ("", None)
    (cell,) = motion_map(machine, {place: [1.0]}, runner=SerialRunner(), quiet=True).cells
    assert [(each.kind, each.measures, each.failure) for each in cell.motions] == [(kind, None, failed)]
    basins = basin(machine, {"mass.displacement": [0.0, 2.0]}, runner=SerialRunner(), quiet=True)
    assert basins.names == ("1: failed" if failed else "1: diverging (all such)",)
    if frequency:
        swept = sweep(machine, place, 1.0, 1.1, steps=2, periods=8, quiet=True)
        assert [point.motion.kind for point in swept.points] == [MotionKind.DIVERGING]
        assert swept.jumps == ()


def test_what_sticks_for_many_drive_periods_does_not_diverge() -> None:
    """A belt carries a pad along until its spring tears it off, some 12 s later."""
    fast = replace(example("brake-squeal"), frequency=2000.0, forces={"hum": Force("pad", amplitude=0.1)})
    told = respond(fast)
    assert told.kind is MotionKind.UNDECIDED
    assert "Its slowest mode takes 12566 drive periods, so that this was brief" in told.message
    (cell,) = motion_map(fast, {"frequency": [700.0]}, quiet=True).kind.ravel()
    assert cell is MotionKind.UNDECIDED
