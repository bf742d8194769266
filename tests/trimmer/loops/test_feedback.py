"""A linear system with several elements: held against other engines, closed loops and equations by hand."""

import pickle
import warnings
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import control
import numpy as np
import pytest
import scipy.signal
from scipy.integrate import solve_ivp

import trimmer
from tests.quick import quick
from trimmer import (
    ClosedLoop,
    CoulombFriction,
    DeadZone,
    Drive,
    Feedback,
    FrictionBacklash,
    OrbitSearch,
    Preload,
    Relay,
    Saturation,
    ViscousBacklash,
    ViscousFriction,
    forced_orbit,
    periodic_orbits,
    respond,
    simulate,
)
from trimmer.errors import LoopError, OrbitNotFoundWarning, TrimmerError
from trimmer.loops.description import loop_as_data
from trimmer.mechanism import Body, Force, Friction, Link, Mechanism

A = np.diag([1.0, 0.0, 1.0, 0.0], 1)
A[1, 2], A[3, 3], A[4, 2] = 0.0, -8.0, -20.0
B = np.zeros((5, 4))
B[1, :3], B[3, 1], B[4, 3] = (-5000.0, 4e5, 5000.0), -1.6e5, 20.0
C = np.array([[0, 1, 0, 0, 0], [-1, 0, 1, 0, 0], [0, -0.05, -1.5, 0, 1], [0, 0, 1, 0, 0]], dtype=float)
D = np.zeros((4, 4))
D[2, 3] = 1.5
NAMES = {
    "states": ["qm", "vm", "ql", "vl", "I"],
    "inputs": ["friction", "gap", "sat", "r"],
    "outputs": ["friction", "gap", "sat", "y"],
}
SERVO = control.ss(A, B, C, D, **NAMES)
ELEMENTS = {"friction": CoulombFriction(0.04, static=0.07), "gap": DeadZone(0.01), "sat": Saturation(0.4)}
START = {"qm": 0.3, "ql": 0.3}


def integrator(**signals: object) -> control.StateSpace:
    """x' = u, y = x, as plants of one signal are made."""
    return control.ss(0.0, -1.0, 1.0, 0.0, **signals)


def around(system: control.LTI, element: trimmer.elements.Element, name: str = "e") -> Feedback:
    """Negative feedback of an element and a system, by names."""
    return Feedback(control.ss(-1 * control.ss(system), inputs=[name], outputs=[name]), {name: element})


def test_a_servo_with_friction_gap_and_limit_moves_as_a_second_program_says() -> None:
    """servo.json, feedback_three_elements_transient: expm with Newton on the guards, and DOP853."""
    loop = Feedback(SERVO, ELEMENTS)
    motion = simulate(loop, 1.0, state=START)
    assert len(motion.events) == 38
    # fmt: off
    times = [0.0005952380952380943, 0.003585107122611545, 0.006464383436481976, 0.009096268834624263,
             0.00927332475506568, 0.014008410753808497, 0.01984314999199424, 0.02410133595545932,
             0.02975553212765037, 0.05876397708016187, 0.06416346935450445, 0.06852517975197235]
    last = [-0.01852868498199269, 6.540080445968616e-16, -0.02235949440249789, 0.16378733189571512,
            -0.012974832650274774]
    # fmt: on
    np.testing.assert_allclose(motion.event_times[:12], times, rtol=0, atol=1e-12)
    np.testing.assert_allclose(motion.state(1.0), last, rtol=0, atol=1e-11)
    named = [f"{event.component} {event.mode}" for event in motion.events[:3]]
    assert named == ["sat between the thresholds", "gap above", "sat below"]
    same = simulate(loop, 1.0, state=[0.3, 0.0, 0.3, 0.0, 0.0])
    assert same.events == motion.events == simulate(replace(loop, start=START), 1.0).events


def test_the_servo_hunts_as_a_second_program_says() -> None:
    """servo.json, feedback_three_elements_limit_cycle."""
    loop = Feedback(SERVO, ELEMENTS, start=START)
    motion = respond(loop).motion
    assert motion.orbit.period == pytest.approx(0.9110718763659875, rel=1e-10)
    for name, size in (("qm", 0.015050344013625372), ("ql", 0.0257432255326024), ("vm", 0.6854041246461074)):
        assert 0.5 * motion.peak_to_peak[name] == pytest.approx(size, rel=1e-10)
        assert motion.mean[name] == pytest.approx(0.0, abs=1e-10)
    assert (motion.events_per_period, motion.period_count) == (24, 1)
    orbit = forced_orbit(loop)
    assert orbit.period == pytest.approx(motion.orbit.period, rel=1e-12)
    # A friction takes what it takes: the mean of its force times velocity.
    times = np.linspace(0.0, orbit.period, 400_001)
    power = np.mean(orbit.motion.signal("friction", times) * orbit.motion.signal("friction output", times))
    assert motion.measures.frictions["friction"].power == pytest.approx(power, rel=1e-4)
    assert orbit.stroke_of("ql") == pytest.approx(motion.peak_to_peak["ql"], rel=1e-12)
    with pytest.raises(LoopError, match=r"no signal is called 'qll'; did you mean ql"):
        orbit.stroke_of("qll")


@pytest.mark.slow
def test_from_many_starts_it_hunts_alike_or_rests() -> None:
    (orbit,) = periodic_orbits(Feedback(SERVO, ELEMENTS), search=OrbitSearch(starts=8))
    assert (orbit.period, orbit.stable) == (pytest.approx(0.9110718763659875, rel=1e-10), True)
    assert respond(Feedback(SERVO, ELEMENTS), state={"I": 0.02}).motion.kind.word == "rest"


@pytest.mark.parametrize("frequencies", [(1.1, 1.1), (0.8, 1.2), (1.0, np.sqrt(2.0))])
def test_drives_of_any_frequency_reach_states_inputs_of_elements_and_outputs(frequencies) -> None:
    """Held against equations by hand; both elements are continuous, so that any integrator follows them."""
    first, second = frequencies
    plant = control.ss(
        [[0.0, 1.0], [-4.0, -0.6]],
        [[0.0, 0.0, 0.0, 0.2], [-3.0, 1.0, 2.0, 0.0]],
        [[1.0, 0.0], [0.0, 1.0], [1.0, -2.0]],
        [[0.0, 0.0, 0.3, 0.0], [0.0, 0.0, 0.0, 0.4], [0.7, 0.0, 0.0, 0.5]],
        states=["x", "v"],
        inputs=["slack", "limit", "p", "q"],
        outputs=["slack", "limit", "z"],
    )
    drives = {"p": Drive(0.8, frequency=first, phase=0.3), "q": Drive(1.1, frequency=second)}
    elements = {"slack": 2.0 * DeadZone(0.15), "limit": Saturation(0.4, slope=0.5)}
    loop = Feedback(plant, elements, drives)

    def given(t: float) -> tuple[float, float]:
        return 0.8 * np.sin(2 * np.pi * first * t + 0.3), 1.1 * np.sin(2 * np.pi * second * t)

    def outputs(t: float, y: Any) -> tuple[float, float]:
        p, q = given(t)
        slack, limit = y[0] + 0.3 * p, y[1] + 0.4 * q
        return 2.0 * (slack - np.clip(slack, -0.15, 0.15)), 0.5 * np.clip(limit, -0.4, 0.4)

    def rates(t: float, y: Any) -> list[float]:
        (p, q), (slack, limit) = given(t), outputs(t, y)
        return [y[1] + 0.2 * q, -4.0 * y[0] - 0.6 * y[1] - 3.0 * slack + limit + 2.0 * p]

    times = np.linspace(0.0, 6.0, 61)
    told = solve_ivp(rates, (0.0, 6.0), [0.1, 0.0], "DOP853", times, rtol=1e-12, atol=1e-13).y
    motion = simulate(loop, 6.0, state={"x": 0.1})
    np.testing.assert_allclose(motion.state(times), told, rtol=0, atol=1e-8)
    fed = np.array([outputs(t, y)[0] for t, y in zip(times, told.T, strict=True)])
    np.testing.assert_allclose(motion.signal("slack output", times), fed, rtol=0, atol=3e-8)
    direct = told[0] - 2.0 * told[1] + 0.7 * fed + 0.5 * np.array([given(t)[1] for t in times])
    np.testing.assert_allclose(motion.signal("z", times), direct, rtol=0, atol=1e-7)
    if first == 1.0:
        with pytest.raises(TrimmerError, match=r"no period in common.*simulate"):
            respond(loop)
        return
    orbit = forced_orbit(loop)
    period = {1.1: 1 / 1.1, 0.8: 1 / 0.4}[first]
    assert (orbit.period, loop.frequency) == (pytest.approx(period), pytest.approx(1 / period))
    long = simulate(loop, 400 * period).state(np.array([399.2, 399.7]) * period)
    np.testing.assert_allclose(
        orbit.motion.state(np.array([0.2, 0.7]) * period), long, rtol=0, atol=1e-6 * abs(long).max()
    )


TEXTBOOK = {
    "relay": (control.tf([1], [1, 2, 1, 0]), Relay(1.0)),
    "hysteresis": (control.tf([1], [1, 2, 1, 0]), Relay(1.0, hysteresis=0.1)),
    "relay with dead zone": (control.tf([1], [1, 2, 1, 0]), Relay(1.0, 0.1, dead_zone=0.2)),
    "dead zone": (control.tf([4], [1, 2, 1, 0]), DeadZone(0.1)),
    "preload": (control.tf([1.5], [1, 2, 1, 0]), Preload(0.3, 1.0)),
    "a sum": (control.tf([4], [1, 2, 1, 0]), Saturation(0.3) + 0.5 * DeadZone(0.5)),
    "conditionally stable": (control.tf([2, 4, 2], [0.0025, 0.1, 1, 0, 0, 0]), Saturation(1.0)),
    "backlash servo": (control.tf([3.01], [1, 3, 2, 0]), FrictionBacklash(1.0)),
    "load with inertia": (control.tf([8], [1, 3, 2, 0]), ViscousBacklash(0.2, 0.5)),
}


@pytest.mark.parametrize("name", quick(TEXTBOOK, *range(len(TEXTBOOK) - 1)))
def test_loops_of_textbooks_move_as_closed_loops_do(name: str) -> None:
    system, element = TEXTBOOK[name]
    loop = around(system, element)
    closed = ClosedLoop(control.ss(-loop.plant), element)
    state = np.linspace(0.3, 1.0, loop.plant.nstates)
    ours, theirs = simulate(loop, 15.0, state=state), simulate(closed, 15.0, initial_state=state)
    times = np.linspace(0.0, 15.0, 301)
    np.testing.assert_array_equal(ours.signal("e", times), theirs.element_input(times))
    np.testing.assert_array_equal(ours.element_output(times), theirs.element_output(times))
    assert [event.time for event in ours.events] == [event.time for event in theirs.events]
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", OrbitNotFoundWarning)
        found, expected = (periodic_orbits(each, search=OrbitSearch(starts=6)) for each in (loop, closed))
    assert [each.period for each in found] == [each.period for each in expected]
    assert all(each.loop is loop for each in found)
    for each in found:
        assert each.stroke_of("e") == pytest.approx(2 * each.amplitude, rel=1e-12)


@pytest.mark.parametrize(("gain", "cycles", "predicted"), [(3.0, 0, 0), (3.01, 1, 0), (3.35, 1, 2)])
def test_a_backlash_servo_hunts_at_gains_at_which_nothing_is_predicted(gain, cycles, predicted) -> None:
    loop = around(control.tf([gain], [1, 3, 2, 0]), FrictionBacklash(1.0))
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", OrbitNotFoundWarning)
        found = periodic_orbits(loop, search=OrbitSearch(starts=6))
    assert [each.stable for each in found] == [True] * cycles
    assert len(trimmer.harmonic_balance(loop).limit_cycles) == predicted


def rubbing(seed: int) -> tuple[Mechanism, Feedback]:
    """Three bodies in a row with four frictions, static above kinetic, as a mechanism and as a plant."""
    random = np.random.default_rng(seed)
    masses, stiff, damped = (random.uniform(*ends, 3) for ends in ((0.3, 1.5), (50, 400), (0.05, 1)))
    force = random.uniform(0.2, 1.2, 4)
    static = force * random.uniform(1.0, 2.0, 4)
    frequency, push = random.uniform(0.5, 3.0), random.uniform(2.0, 8.0)
    links = [("ground", "a"), ("a", "b"), ("b", "c")]
    rubs = [("ground", "a"), ("a", "b"), ("ground", "c"), ("ground", "b") if seed % 2 else ("b", "c")]
    machine = Mechanism(
        {name: Body(mass) for name, mass in zip("abc", masses, strict=True)},
        links={f"l{i}": Link(ends, stiffness=stiff[i], damping=damped[i]) for i, ends in enumerate(links)},
        frictions={f"f{i}": Friction(ends, force=force[i], static=static[i]) for i, ends in enumerate(rubs)},
        forces={"push": Force("b", amplitude=push)},
        frequency=frequency,
    )
    of_links, of_rubs = (
        np.array([[float(x == end) - float(x == start) for x in "abc"] for start, end in ends])
        for ends in (links, rubs)
    )
    inverse = np.diag(1 / masses)
    spring, damper = (-inverse @ of_links.T @ np.diag(each) @ of_links for each in (stiff, damped))
    plant = control.ss(
        np.block([[np.zeros((3, 3)), np.eye(3)], [spring, damper]]),
        np.vstack([np.zeros((3, 5)), np.column_stack([-inverse @ of_rubs.T, inverse[:, 1]])]),
        np.hstack([np.zeros((4, 3)), of_rubs]),
        np.zeros((4, 5)),
        states=["a", "b", "c", "va", "vb", "vc"],
        inputs=["f0", "f1", "f2", "f3", "push"],
        outputs=["f0", "f1", "f2", "f3"],
    )
    elements = {f"f{i}": CoulombFriction(force[i], static=static[i]) for i in range(4)}
    return machine, Feedback(plant, elements, {"push": Drive(push, frequency=frequency)})


@pytest.mark.parametrize("seed", [0, 1, 2, pytest.param(range(3, 9), marks=pytest.mark.slow)])
def test_frictions_stick_and_slip_together_as_those_of_machines_do(seed: int | range) -> None:
    """The engine of machines decides them in a way of its own; two of them depend on each other."""
    for each in seed if isinstance(seed, range) else [seed]:
        machine, loop = rubbing(each)
        theirs, ours = simulate(machine, 8.0), simulate(loop, 8.0)
        times = np.linspace(0.0, 8.0, 401)
        for name in "abc":
            np.testing.assert_allclose(ours.signal(name, times), theirs.signal(name, times), 0, 1e-11)
        # What reverses at one instant is one event of loops, and two of machines.
        instants = [np.unique(np.round(motion.event_times, 9)) for motion in (ours, theirs)]
        np.testing.assert_allclose(*instants, rtol=0, atol=2e-9)


def test_stick_lasts_beside_a_friction_that_turns_back_within_its_kinetic_force() -> None:
    """As in ``contact.test_frictions_at_once``: 1.2 on what is held, and 2 on what slides on it."""
    names = {"states": ["block", "slider", "load"], "inputs": ["table", "back"], "outputs": ["table", "back"]}
    flow = [[0.0, 0.0, -1.2], [0.0, 0.0, -2.0], [0.0, 0.0, 0.0]]
    plant = control.ss(
        flow, [[-1.0, 1.0], [0.0, -1.0], [0.0, 0.0]], [[1.0, 0, 0], [-1.0, 1.0, 0]], 0, **names
    )
    elements = {"table": CoulombFriction(1.4, static=2.2), "back": CoulombFriction(0.8, static=1.1)}
    motion = simulate(Feedback(plant, elements), 1.0, state=np.array([0.0, 1.0, 1.0]))
    assert [event.component for event in motion.events] == ["back"]
    assert motion.signal("slider", np.array([1.0])) == pytest.approx(-1.2 * (1.0 - 1.0 / 2.8), rel=1e-12)
    assert motion.signal("block", np.array([1.0])) == 0.0


def test_a_relay_that_a_drive_finds_on_either_side_at_one_state_takes_two_periods() -> None:
    """x' = -1 and +1 between the edges at 0.1 takes 0.4 s; the drive acts beside it."""
    names = {"states": ["x", "w"], "inputs": ["y", "d"], "outputs": ["y"]}
    plant = control.ss(np.diag([0.0, -5.0]), np.diag([-1.0, 1.0]), [[1.0, 0.0]], 0, **names)
    loop = Feedback(plant, {"y": Relay(1.0, hysteresis=0.1)}, {"d": Drive(0.3, frequency=5.0)})
    motion = respond(loop).motion
    assert motion.period_count == 2
    assert motion.peak_to_peak["y"] == pytest.approx(0.2, rel=1e-12)


def test_friction_takes_a_velocity_and_viscous_friction_is_a_gain_there() -> None:
    """v' = -sign(v) - v/2 from 1: it comes to rest after 2 ln(3/2), and stays."""
    loop = Feedback(integrator(inputs="v", outputs="v"), {"v": CoulombFriction(1.0) + ViscousFriction(0.5)})
    motion = simulate(loop, 2.0, state=[1.0])
    (event,) = motion.events
    assert (event.component, event.mode, event.time) == ("v friction", "held", pytest.approx(2 * np.log(1.5)))
    assert motion.state(2.0) == 0.0


def test_numbers_have_places_and_loops_are_told_apart_by_their_names() -> None:
    loop = Feedback(SERVO, ELEMENTS, {"r": Drive(0.1, frequency=2.0)}, start=START)
    for place, value in {
        "elements.friction.static": 0.08,
        "elements.gap.threshold": 0.02,
        "drives.r.amplitude": 0.3,
        "drives.r.frequency": 3.0,
        "frequency": 4.0,
        "start.I": 0.1,
    }.items():
        assert loop.with_value(place, value).value(place) == pytest.approx(value, rel=1e-15)
    with pytest.raises(LoopError, match=r"elements\.friction\.static = 0\.01: static must not be less"):
        loop.with_value("elements.friction.static", 0.01)
    summed = Feedback(SERVO, {**ELEMENTS, "sat": ELEMENTS["sat"] + Relay(0.1)})
    assert summed.with_value("elements.sat.1.level", 0.2).value("elements.sat.1.level") == 0.2
    copy = pickle.loads(pickle.dumps(loop))
    assert loop_as_data(copy) == loop_as_data(loop)
    assert simulate(copy, 0.3).events == simulate(loop, 0.3).events
    names = {**NAMES, "inputs": ["gap", "friction", "sat", "r"]}
    other = Feedback(control.ss(A, B[:, [1, 0, 2, 3]], C, D[:, [1, 0, 2, 3]], **names), ELEMENTS)
    assert loop_as_data(other) != loop_as_data(Feedback(SERVO, ELEMENTS))
    one = Feedback(SERVO, ELEMENTS)
    assert simulate(other, 0.3, state=START).events == simulate(one, 0.3, state=START).events


def test_an_orbit_is_followed_over_a_number_of_an_element() -> None:
    loop = Feedback(SERVO, ELEMENTS, start=START)
    settings = trimmer.FollowSettings(quiet=True, largest_step=0.5)
    branch = trimmer.follow(loop, "elements.sat.threshold", 0.4, 0.41, settings=settings)
    last = respond(loop.with_value("elements.sat.threshold", 0.41)).motion
    assert branch.points[-1].period == pytest.approx(last.orbit.period, rel=1e-8)


@pytest.mark.parametrize(
    "form", [scipy.signal.TransferFunction, scipy.signal.ZerosPolesGain, scipy.signal.StateSpace]
)
def test_systems_of_scipy_are_taken(form: Callable[..., Any]) -> None:
    given = scipy.signal.TransferFunction([1.0], [1.0, 2.0, 1.0, 0.0])
    converted = {"TransferFunction": given, "ZerosPolesGain": given.to_zpk(), "StateSpace": given.to_ss()}
    system = converted[form.__name__]
    period = periodic_orbits(around(control.tf([1], [1, 2, 1, 0]), Relay(1.0)))[0].period
    assert periodic_orbits(ClosedLoop(system, Relay(1.0)))[0].period == pytest.approx(period, rel=1e-12)
    flipped = -1 * given.to_ss() if form is scipy.signal.StateSpace else system
    assert Feedback(flipped, {"relay": -Relay(1.0) if flipped is system else Relay(1.0)}).plant.nstates == 3
