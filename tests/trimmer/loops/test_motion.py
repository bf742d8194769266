"""What a motion gives: events in order, the same state however it is asked for, values at many times."""

import math
from dataclasses import replace
from itertools import pairwise

import control
import numpy as np
import pytest
from scipy.linalg import expm

from trimmer import CoulombFriction, FrictionBacklash, InertiaBacklash, Motion, ViscousBacklash, simulate
from trimmer.elements import Element
from trimmer.loops import BodyFriction, ClosedLoop, Drive, EventKind, LoopMotion, TrimmerLoop
from trimmer.thesis import Displacement, InputChannels, TrimmerBody, TrimmerParameters

THESIS = TrimmerParameters.thesis()
GAP = 2e-4
FRICTION = BodyFriction(Displacement(TrimmerBody.CUTTER, TrimmerBody.GUARD), CoulombFriction(5.0))
ELEMENTS = [FrictionBacklash(GAP), ViscousBacklash(GAP, 1e-3), InertiaBacklash(GAP)]


def driven(element: Element = ELEMENTS[0], duration: float = 0.03, **settings: object) -> Motion:
    drive = Drive(1.5e-3, 2 * math.pi * 110)
    return simulate(TrimmerLoop(THESIS, element, drive, frictions=(FRICTION,)), duration, **settings)


@pytest.mark.parametrize("element", ELEMENTS)
@pytest.mark.parametrize("channels", InputChannels)
def test_dense_output_is_continuous_at_events(element: Element, channels: InputChannels) -> None:
    motion = simulate(TrimmerLoop(THESIS, element, channels=channels), 0.02, impulse=2e-6)
    times = motion.event_times[motion.event_times > 0]
    assert len(times) > 20
    before, after = np.nextafter(times, 0.0), times
    for signal in (motion.state, motion.element_input, motion.element_output, motion.output):
        jumps, sizes = abs(signal(after) - signal(before)), abs(signal(times)).max(axis=-1, keepdims=True)
        assert (jumps < 1e-12 * sizes).all()


def test_what_happens_at_an_event_is_seen_in_the_output() -> None:
    motion = driven()
    event = next(each for each in motion.events if each.kind is EventKind.SLIP)
    force = motion.component_outputs([np.nextafter(event.time, 0.0), event.time])[1]
    assert abs(force) == pytest.approx(5.0, rel=1e-9)
    impact = next(each for each in motion.events if each.kind is EventKind.IMPACT)
    play = float(motion.element_input(impact.time) - motion.element_output(impact.time))
    assert abs(play) == pytest.approx(GAP / 2, rel=1e-12)
    assert impact.mode == ("upper contact" if play > 0 else "lower contact")


@pytest.mark.parametrize("element", ELEMENTS)
def test_events_are_ordered_and_alternate(element: Element) -> None:
    motion = driven(element)
    assert all(first.time <= second.time for first, second in pairwise(motion.events))
    kinds = [event.kind for event in motion.events if event.component == "backlash"]
    assert set(kinds[::2]) == {EventKind.IMPACT}
    assert set(kinds[1::2]) == {EventKind.SEPARATION}
    sticks = [event for event in motion.events if event.component == "friction q2-q4"]
    assert {event.kind for event in sticks} >= {EventKind.STICK, EventKind.SLIP}
    assert all(first.mode != second.mode for first, second in pairwise(sticks))


def test_a_reversal_of_sliding_leaves_the_contact_alone() -> None:
    """The force of a stick that does not last would pull the pin away, and push it back at the same time."""
    friction = BodyFriction(Displacement(TrimmerBody.CUTTER, TrimmerBody.GUARD), CoulombFriction(2.0))
    loop = TrimmerLoop(THESIS, ViscousBacklash(GAP, 1e-3), frictions=(friction,))
    for channels in InputChannels:
        motion = simulate(replace(loop, channels=channels), 0.02, impulse=1e-5)
        assert EventKind.SWITCH in {event.kind for event in motion.events}
        kinds = [event.kind for event in motion.events if event.component == "backlash"]
        times = [event.time for event in motion.events if event.component == "backlash"]
        lengths = [
            after - before
            for (before, after), kind in zip(pairwise(times), kinds[:-1], strict=True)
            if kind is EventKind.SEPARATION
        ]
        assert len(lengths) > 10
        assert min(lengths) > 1e-9


def test_the_play_never_exceeds_the_gap() -> None:
    motion = driven(ViscousBacklash(GAP, 1e-3), 0.1)
    times = np.linspace(0.0, 0.1, 20_000)
    play = motion.element_input(times) - motion.element_output(times)
    assert abs(play).max() == pytest.approx(GAP / 2, rel=1e-9)


def test_samples_are_the_dense_output() -> None:
    motion = driven()
    uniform = np.linspace(0.0, motion.duration, 2001)
    samples = motion.state(uniform)
    assert samples.shape == (8, 2001)
    shuffled = np.random.default_rng(1).permutation(2001)
    assert np.array_equal(motion.state(uniform[shuffled]), samples[:, shuffled])
    assert np.array_equal(
        motion.state(uniform[:2000].reshape(20, 100)), samples[:, :2000].reshape(8, 20, 100)
    )
    assert np.array_equal(motion.state(uniform[::-7]), samples[:, ::-7])
    for place in (0, 1, 777, 2000):
        assert np.array_equal(motion.state(uniform[place]), samples[:, place])
    uniform.flags.writeable = False
    assert np.array_equal(motion.state(uniform), samples)
    assert motion.state([]).shape == (8, 0)


def test_a_longer_motion_begins_as_a_shorter_one() -> None:
    """The log grows and modes are tabulated on the way, which must not show."""
    loop = TrimmerLoop(THESIS, FrictionBacklash(4e-5))
    long, short = (simulate(loop, duration, impulse=1e-6) for duration in (1.0, 0.2))
    assert len(long.events) > 2500
    count = len(short.events)
    assert np.array_equal(long.event_times[:count], short.event_times)
    times = np.linspace(0.0, 0.2, 50)
    assert np.array_equal(long.state(times), short.state(times))


@pytest.mark.parametrize("times", [-1e-9, 0.031, math.nan, [0.01, math.inf]])
def test_times_outside_the_motion_are_refused(times: object) -> None:
    with pytest.raises(ValueError, match=r"times must lie between 0 and the end of the motion, 0.03 s"):
        driven().state(times)


A = np.array([[0.0, 1.0, 0.0], [-400.0, -1.0, 50.0], [0.0, 0.0, -3.0]])
PLANT = control.ss(A, [[0.0], [0.0], [1.0]], [[1.0, 0.0, 0.0]], [[0.0]])
START = np.array([0.2, -1.0, 0.5])
NEVER = FrictionBacklash(100.0)
"""A play so wide that it is never taken up: the element's output stays 0, and the system is left alone."""


@pytest.fixture(scope="module")
def free() -> LoopMotion:
    motion = simulate(ClosedLoop(PLANT, NEVER), 4.0, initial_state=START)
    assert not [time for time in motion.event_times if time > 0.0]
    return motion


def exact(times: np.ndarray) -> np.ndarray:
    return np.array([expm(A * time) @ START for time in times]).T


@pytest.mark.parametrize("count", [1, 33, 64, 1000])
@pytest.mark.parametrize("end", [4.0, 1e-3])
def test_any_number_of_times(free: LoopMotion, count: int, end: float) -> None:
    times = np.random.default_rng(5).uniform(0.0, end, count)
    some = slice(None, None, max(1, count // 5))
    assert free.state(times)[:, some] == pytest.approx(exact(times[some]), abs=1e-12)
    assert free.output(times)[some] == pytest.approx(exact(times[some])[0], abs=1e-12)
    assert (np.diff(free.state(np.sort(times))[2]) < 0.0).all()  # a decay, which no sample may interrupt


def test_times_that_are_far_apart_or_all_the_same(free: LoopMotion) -> None:
    for times in ([3.999], [0.1, 3.9], [1.7] * 5):
        assert free.state(times) == pytest.approx(exact(np.array(times)), abs=1e-12)
