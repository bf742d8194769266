"""Sampled controllers: exact discretisation, public digits, the order at one instant, other integrators."""

import re
from dataclasses import replace
from itertools import pairwise, product

import numpy as np
import pytest
from scipy.linalg import expm

from tests.mechanisms.sampled import SampledControl, instants
from tests.quick import quick
from tests.trimmer.problem_machines import machine_text
from tests.trimmer.response.mechanisms import example
from trimmer import (
    Body,
    FollowSettings,
    Force,
    Friction,
    Link,
    Mechanism,
    SerialRunner,
    follow,
    forced_orbit,
    motion_map,
    respond,
    simulate,
)
from trimmer.contact.flow import MechanismFlow
from trimmer.errors import MechanismError, OrbitNotFoundError
from trimmer.mechanism import Cascade, Controller, Output, Pid, Play, StepReference, TransferController, Wall
from trimmer.response import MotionKind, step_response

INERTIA = np.array([2e-4, 5e-4])
STIFF, DAMPED, DRAG = 80.0, 0.02, 0.001


def two_masses(controller: Controller, at: float = 0.0) -> Mechanism:
    return Mechanism(
        {"motor": Body(inertia=INERTIA[0]), "load": Body(inertia=INERTIA[1])},
        links={
            "shaft": Link(("motor", "load"), STIFF, DAMPED),
            "bearing": Link(("ground", "motor"), damping=DRAG),
        },
        outputs={
            "angle": Output({"load": 1.0}),
            "rate": Output({"motor": 1.0}, kind="velocity"),
            "torque": Output(kind="control", part="axis"),
        },
        controllers={"axis": controller},
        references={"path": StepReference(0.5, at)},
    )


def by_expm(controller: Controller, at: float, end: float) -> tuple[np.ndarray, list[float]]:
    """The state at the end and all that acted, from the exponential of each hold interval."""
    matrix = np.zeros((5, 5))
    matrix[:2, 2:4] = np.eye(2)
    spring, damper = STIFF * np.array([[1, -1], [-1, 1]]), DAMPED * np.array([[1, -1], [-1, 1]])
    matrix[2:4, :2] = -spring / INERTIA[:, None]
    matrix[2:4, 2:4] = -(damper + np.diag([DRAG, 0.0])) / INERTIA[:, None]
    matrix[2, 4] = 1 / INERTIA[0]
    state, acted, control = np.zeros(5), list[float](), SampledControl(controller)
    times = [*instants([control], end), (end, [False])]
    for (time, (samples,)), (following, _) in pairwise(times):
        if samples:
            given = (0.5 if time >= at * (1 - 1e-12) else 0.0, 0.0)
            control.sample(time, state[1], given, state[2])
        control.act(time)
        acted.append(control.acting)
        state[4] = control.acting
        state = expm(matrix * (following - time)) @ state
    return state[:4], acted


AXIS = {"measure": "angle", "acts": ("ground", "motor"), "reference": "path", "sample": 1e-3}
LAWS = {
    "pid": Pid(kp=1.5, ki=10.0, kd=0.04, filter_time=2e-3, **AXIS),
    "limited": Pid(kp=1.5, ki=10.0, limit=0.4, **AXIS),
    "cascade": Cascade(kp=20, kv=0.02, ti=0.05, speed="rate", limit=0.2, **AXIS),
    "difference": Cascade(kp=20, kv=0.02, speed="difference", **AXIS),
    "transfer": TransferController(numerator=(2e-5, 0.03, 1.0), denominator=(2e-6, 3e-3, 1.0), **AXIS),
}


@pytest.mark.parametrize(("law", "delay"), list(product(LAWS, [0.0, 0.4e-3, 1e-3, 2.3e-3])))
def test_a_linear_machine_by_exact_discretisation(law: str, delay: float) -> None:
    controller, end = replace(LAWS[law], delay=delay), 0.0507
    motion = simulate(two_masses(controller, at=4.2e-3), end)
    state, acted = by_expm(controller, 4.2e-3, end)
    found = np.array([motion.final["motor"], motion.final["load"]]).T.ravel()
    np.testing.assert_allclose(found, state, rtol=0, atol=1e-11 * abs(state).max())
    times = [time for time, _ in instants([SampledControl(controller)], end)]
    torque = motion.signal("torque", np.array(times))
    np.testing.assert_allclose(torque, acted, rtol=0, atol=1e-11 * max(map(abs, acted)))
    assert max(map(abs, acted)) > 0.1
    assert motion.energy.residual < 1e-11
    assert not motion.events
    names = motion.flow.names
    held = [each.partition(" u")[2] for each in names if " u" in each]
    assert len(names) == len(motion.states(0.0)) and held == [str(1 + place) for place in range(len(held))]


def test_behind_a_break_what_samples_set_changes_at_their_instants_to_the_last_digit() -> None:
    """The reference begins between samples; sums of steps from there would miss the instants by rounding."""
    delay = 0.37e-3
    motion = simulate(two_masses(replace(LAWS["pid"], delay=delay), at=4.23e-3), 0.3)
    times = np.arange(5, 290) * 1e-3 + delay
    at, beside = (motion.signal("torque", each) for each in (times, np.nextafter(times, 0.0)))
    np.testing.assert_array_equal(at, motion.signal("torque", times + 1e-5))
    np.testing.assert_array_equal(beside, motion.signal("torque", times - 1e-5))
    assert (at != beside).all()


SERVO = Mechanism.from_toml_text(machine_text("sampled-servo"))


def test_an_integral_that_runs_on_in_stick_is_no_end() -> None:
    motion = simulate(SERVO, 0.3)
    assert motion.energy.residual < 1e-11
    assert motion.rest is None  # The integral goes on until something breaks away.


def test_multipliers_over_a_sample() -> None:
    """Digits of the public case sampled_pid_linear_delay_half, whose guide has a damper too."""
    machine = two_masses(replace(LAWS["pid"], delay=5e-4))
    links = {**machine.links, "guide": Link(("ground", "load"), damping=DRAG)}
    machine = replace(machine, links=links, outputs={**machine.outputs, "angle": Output({"motor": 1.0})})
    flow = MechanismFlow(machine)
    values = np.sort(abs(np.linalg.eigvals(flow.course(flow.rest(), 1).monodromy)))[::-1]
    np.testing.assert_allclose(values[:3], [0.9916677824881331, *[0.9677660177869152] * 2], rtol=1e-12)
    response = respond(machine)
    assert response.kind is MotionKind.REST
    assert response.motions[0].rest is not None
    assert not response.motions[0].rest.family
    assert response.motions[0].rest.positions["load"] == pytest.approx(0.5, rel=1e-9)


def bouncer(**controllers: Controller) -> Mechanism:
    """A ball that hits a wall at 1 m/s at t = 0.01, with samples at that instant."""
    return Mechanism(
        {"ball": Body(2.0), "other": Body(1.0)},
        walls={"floor": Wall(("ground", "ball"), restitution=0.5, gap=0.01)},
        outputs={
            "speed": Output({"ball": 1.0}, kind="velocity"),
            "first": Output(kind="control", part="first"),
            "push": Output(kind="acceleration", weights={"other": 1.0}),
        },
        controllers=controllers,
        start={"ball": (0.0, 1.0)},
    )


def test_the_order_at_one_instant() -> None:
    """An impact comes before the sample; no controller sees what another demands at the same instant."""
    first = Pid(measure="speed", acts=("ground", "other"), kp=2.0, sample=0.01)
    second = Pid(measure="first", acts=("ground", "other"), kp=1.0, sample=0.005, delay=0.0025)
    third = Pid(measure="push", acts=("ground", "other"), kp=1.0, sample=0.01, delay=0.01)
    motion = simulate(bouncer(first=first, second=second, third=third), 0.0161)
    (impact,) = motion.events
    assert impact.time == pytest.approx(0.01, rel=1e-14)
    times = np.array([0.0, 0.0025, 0.0075, 0.01, 0.0125, 0.016])
    # u = -2 v: -2 at first, 1 after the rebound with -0.5 m/s.
    np.testing.assert_allclose(motion.signal("first", times), [-2, -2, -2, 1, 1, 1], rtol=1e-12)
    # The second one saw 0 at 0, -2 at 5 ms and still at 10 ms, 1 at 15 ms.
    acted = motion.signal("push", times) - motion.signal("first", times)
    # The third one saw 0 at 0, and the acceleration -2 + 2 before 10 ms; it has not acted yet.
    np.testing.assert_allclose(acted, [0, 0, 2, 2, 2, 2], atol=1e-12)
    assert motion.energy.residual < 1e-12


@pytest.mark.parametrize(("share", "acting"), [(1e-10, 1.0), (1e-8, -2.0), (-1e-8, 1.0)])
def test_how_near_a_sample_an_impact_is_at_its_instant(share: float, acting: float) -> None:
    """Within 1e-9 of a sample they are together, and the impact comes first."""
    first = Pid(measure="speed", acts=("ground", "other"), kp=2.0, sample=0.01)
    ball = bouncer(first=first).with_value("walls.floor.gap", 0.01 * (1 + share))
    motion = simulate(ball, 0.015)
    np.testing.assert_allclose(motion.signal("first", np.array([0.014])), [acting], rtol=1e-6)


@pytest.mark.slow
def test_hunting_under_samples_is_a_torus_with_lines() -> None:
    """Play in the loop of a slow position control: it hunts, whatever the samples are."""
    loose = replace(
        two_masses(Pid(kp=3.0, ki=10.0, kd=0.05, filter_time=2e-3, limit=2.0, **AXIS)),
        links={"bearing": Link(("ground", "motor"), damping=DRAG)},
        plays={"shaft": Play(("motor", "load"), STIFF, DAMPED, gap=0.02)},
    )
    motion = respond(loose, most_periods=100).motions[0]
    assert motion.kind is MotionKind.TORUS
    assert motion.window is not None
    (frequency, amplitude), (third, _) = motion.window.peaks["angle"][:2]
    assert third == pytest.approx(3 * frequency, rel=1e-3)
    assert amplitude == pytest.approx(motion.peak_to_peak["angle"] / 2, rel=0.2)
    branch = follow(loose, "controllers.axis.kp", 3.0, 2.0, settings=FollowSettings(most_periods=100))
    assert not branch.success
    assert branch.message.startswith("at 3 there is nothing to follow, since only what repeats is followed:")
    assert "it seems to run on a torus: it had not settled after 1600 samples" in branch.message


def test_an_integral_that_runs_in_stick_is_no_rest() -> None:
    """Without one the axis rests in its stiction, one place of many."""
    still = respond(SERVO.with_value("controllers.axis.ki", 0.0)).motions[0]
    assert still.rest is not None
    assert still.rest.family
    assert not still.rest.asymptotic
    assert respond(SERVO, most_periods=30).kind is not MotionKind.REST


def test_a_sampled_axis_is_followed_over_its_gain() -> None:
    """The multipliers on the branch are those of the machine at each gain; two clocks return together."""
    driven = Mechanism(
        {"slide": Body(2.0)},
        frequency=50.0,
        links={"mount": Link(("ground", "slide"), 100.0, 5.0)},
        forces={"cut": Force("slide", amplitude=10.0)},
        outputs={"x": Output({"slide": 1.0}), "v": Output({"slide": 1.0}, kind="velocity")},
        controllers={
            "slow": Pid(measure="x", acts=("ground", "slide"), kp=2e3, sample=4e-3, delay=1e-3),
            "fast": Pid(measure="v", acts=("ground", "slide"), kp=50.0, sample=1e-3),
        },
    )
    branch = follow(driven, "controllers.fast.kp", 50.0, 60.0)
    last = branch.points[-1]
    again = forced_orbit(driven.with_value("controllers.fast.kp", last.value))
    assert last.value == 60.0
    assert again.success
    assert last.stable
    assert last.outputs["x"].peak_to_peak == pytest.approx(again.measures.peak_to_peak["x"], rel=1e-9)
    with pytest.raises(MechanismError, match="return together at single values only"):
        follow(driven, "controllers.fast.sample", 1e-3, 1.1e-3)


@pytest.mark.parametrize(
    ("begins", "sample", "ki"),
    [(0.0, 1e-3, 10.0), (0.49999, 1e-3, 10.0), (0.5 + 1e-9, 1e-3, 10.0), (0.5 + 1e-8, 2e-4, 0.5)],
)
def test_a_stable_axis_rests_at_its_reference_however_near_it_begins(
    begins: float, sample: float, ki: float
) -> None:
    """An integral that is slow beside its samples leaves a matrix that is nearly singular."""
    axis = example("sampled-axis").with_value("controllers.axis.delay", 0.5 * sample)
    axis = axis.with_value("controllers.axis.sample", sample).with_value("controllers.axis.ki", ki)
    axis = replace(axis, start={"motor": (begins, 0.0), "load": (begins and 0.5, 0.0)})
    (motion,) = respond(axis).motions
    assert (motion.kind, motion.rest.family) == (MotionKind.REST, False)
    assert motion.rest.positions == pytest.approx({"motor": 0.5, "load": 0.5}, rel=1e-12)
    assert begins > 0.5 or not any(motion.rest.forces.values())
    delays = {"controllers.axis.delay": [0.5 * sample, 7.5 * sample]}
    cells = motion_map(axis, delays, runner=SerialRunner()).cells
    assert [cell.motions[0].kind for cell in cells] == [MotionKind.REST] * 2
    assert max(cell.motions[0].periods for cell in cells) <= 800  # That all is linear spares the wait.


@pytest.mark.parametrize("delay", quick([7.3e-3, 40.3e-3], 0))
def test_a_delay_of_many_samples(delay: float) -> None:
    """Modes of the longer one are kept as rows; both begin in the middle of a sample."""
    controller, end = replace(LAWS["pid"], kp=0.05, ki=0.0, kd=2e-3, delay=delay), 0.15
    machine = two_masses(controller, at=4.2e-3)
    motion, (state, _) = simulate(machine, end), by_expm(controller, 4.2e-3, end)
    assert (motion.course.modes.tables.rows is None) is (delay < 0.01)
    found = np.array([motion.final["motor"], motion.final["load"]]).T.ravel()
    np.testing.assert_allclose(found, state, rtol=0, atol=1e-11 * abs(state).max())
    flow = MechanismFlow(two_masses(controller))
    course, unit = flow.course(flow.rest(), 3), np.eye(flow.size)
    moved = [flow.course(flow.at(flow.rest().state + each), 3).end.state - course.end.state for each in unit]
    size = abs(course.monodromy).max()
    np.testing.assert_allclose(np.transpose(moved), course.monodromy, rtol=0, atol=1e-11 * size)


def test_samples_that_never_meet_again() -> None:
    """The phases of the two never return together, and so nothing but a rest repeats."""
    machine = Mechanism(
        {"slide": Body(2.0)},
        links={"mount": Link(("ground", "slide"), 100.0, 5.0)},
        outputs={"x": Output({"slide": 1.0}), "v": Output({"slide": 1.0}, kind="velocity")},
        controllers={
            "slow": Pid(measure="x", acts=("ground", "slide"), kp=200.0, reference="path", sample=4e-3),
            "fast": Pid(measure="v", acts=("ground", "slide"), kp=20.0, sample=np.pi * 1e-3),
        },
        references={"path": StepReference(0.1)},
    )
    (motion,) = respond(machine).motions
    assert motion.rest is not None
    assert re.match("It comes to rest within [0-9]+ periods of the slowest samples, and", motion.message)
    alone = replace(machine, controllers={"slow": machine.controllers["slow"]})
    assert re.match("It comes to rest within [0-9]+ samples, and", respond(alone).message)
    assert motion.rest.positions["slide"] == pytest.approx(200.0 * 0.1 / (200.0 + 100.0), rel=1e-9)
    driven = replace(machine, frequency=10.0, forces={"cut": Force("slide", amplitude=5.0)})
    assert respond(driven, most_periods=50).kind is MotionKind.TORUS
    with pytest.raises(OrbitNotFoundError, match="do not return together within 64 periods"):
        forced_orbit(driven)


def test_what_is_demanded_before_the_limit() -> None:
    """The first sample behind the step: kp e + ki T e + kd e (1 - T/(filter_time + T))/filter_time."""
    found = step_response(SERVO, "path", duration=0.3).measures
    assert found.largest_demand == pytest.approx(0.4 * (3.0 + 10.0 * 5e-4 + 0.06 / 1.5e-3), rel=1e-12)
    assert found.largest_control == 1.0


def test_no_sample_is_far_shorter_than_the_slowest_period() -> None:
    """Of a mass of 1 kg on 25 N/m, 2 pi/5 s, or of its drive where that is slower."""

    def axis(sample: float, frequency: float | None) -> Mechanism:
        return Mechanism(
            {"slide": Body(1.0)},
            links={"spring": Link(("ground", "slide"), 25.0)},
            outputs={"place": Output({"slide": 1.0})},
            controllers={"axis": Pid(measure="place", acts=("ground", "slide"), kp=1.0, sample=sample)},
            frequency=frequency,
        )

    free = replace(axis(1e-15, None), links={})
    with pytest.raises(MechanismError, match=r"sample = 1e-15: .* of a second, since no part"):
        respond(free)
    for frequency, slowest in ((None, 0.4e-9 * np.pi), (0.1, 1e-8)):
        assert simulate(axis(1.01 * slowest, frequency), duration=20 * slowest).success
        for ask in (respond, lambda machine: simulate(machine, duration=1.0)):
            with pytest.raises(
                MechanismError, match=r"controllers\.axis\.sample = \S+: it is shorter than 1e-"
            ):
                ask(axis(0.99 * slowest, frequency))


def test_what_sticks_at_first_is_no_slow_motion_beside_which_samples_are_too_short() -> None:
    """A place and a velocity that stick are zero eigenvalues together, which rounding parts by its root."""
    sampled = Cascade(
        measure="y", acts=("ground", "a"), reference="path", kp=37.4, kv=5.9, sample=0.007, delay=0.002
    )
    stuck = Mechanism(
        {"a": Body(0.400083), "b": Body(1.557674), "c": Body(1.88983)},
        links={
            "first": Link(("ground", "a"), 1790.7, 3.45),
            "second": Link(("ground", "b"), 6829.3, 12.7),
            "third": Link(("ground", "c"), 4075.6, 51.3),
        },
        frictions={"rub": Friction(("c", "a"), 353.0)},
        outputs={"y": Output({"a": 1.0})},
        controllers={"k": sampled},
        references={"path": StepReference(0.5)},
    )
    glued = replace(
        stuck,
        bodies={"a": Body(0.400083 + 1.88983), "b": Body(1.557674)},
        links={
            "first": Link(("ground", "a"), 1790.7 + 4075.6, 3.45 + 51.3),
            "second": Link(("ground", "b"), 6829.3, 12.7),
        },
        frictions={},
    )
    times = np.linspace(0.0, 0.5, 51)
    one, other = (simulate(each, 0.5).signal("y", times) for each in (stuck, glued))
    np.testing.assert_allclose(one, other, rtol=0, atol=1e-13)


def test_a_motion_of_too_many_samples_ends_where_it_was_limited() -> None:
    """Those of the whole duration are too many to be listed."""
    axis = example("sampled-axis")
    cut, whole = simulate(axis, 1e9, event_limit=100), simulate(axis, 1.0)
    assert (cut.success, cut.message) == (False, "it has more events than allowed")
    assert 0.01 < cut.duration < 0.2
    times = np.linspace(0.0, 0.999 * cut.duration, 50)
    assert cut.states(times) == pytest.approx(whole.states(times), rel=1e-12)
