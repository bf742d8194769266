"""The trimmer with play and friction against `solve_ivp`, in every configuration."""

import math
from dataclasses import replace

import numpy as np
import pytest

from tests.quick import quick
from tests.trimmer.loops.reference.peer_trimmer import Course, Friction, PeerTrimmer
from trimmer import CoulombFriction, Drive, TrimmerLoop, ViscousBacklash, ViscousFriction, simulate
from trimmer.thesis import BodyFriction, Displacement, InputChannels, TrimmerBody, TrimmerParameters

THESIS = TrimmerParameters.thesis()
DRIVE = (1.5e-3, 2 * math.pi * 110)
SPEED = 0.02
"""Velocity that motor and cutter start with, in opposite directions, where nothing drives, m/s."""
PAIRS = [
    Displacement(of, to)
    for of in TrimmerBody
    for to in (None, *TrimmerBody)
    if to is None or to.value > of.value
]


def own_loop(peer: PeerTrimmer) -> TrimmerLoop:
    frictions = []
    for each in peer.frictions:
        of = TrimmerBody(each.row.index(1.0) + 1)
        between = Displacement(of, TrimmerBody(each.row.index(-1.0) + 1) if -1.0 in each.row else None)
        law = CoulombFriction(each.force) if each.force else ViscousFriction(each.damping)
        if each.force and each.damping:
            law = law + ViscousFriction(each.damping)
        frictions.append(BodyFriction(between, law))
    return TrimmerLoop(
        peer.parameters,
        None if peer.gap is None else ViscousBacklash(peer.gap, peer.tau),
        Drive(*peer.drive) if peer.drive else None,
        channels=InputChannels.DISPLACEMENT_AND_VELOCITY
        if peer.velocity_too
        else InputChannels.DISPLACEMENT_ONLY,
        frictions=tuple(frictions),
    )


def compare(peer: PeerTrimmer, duration: float, events: int) -> None:
    """Compare instants and displacements; the peer is right to about 1e-9 of its largest displacement."""
    start = np.zeros(10)
    if peer.drive is None:
        start[4:6] = -SPEED, SPEED
    course = Course(peer, start).follow(duration)
    motion = simulate(own_loop(peer), duration, initial_state=start[:8])
    instants = np.unique(motion.event_times)
    instants = instants[instants > 0]  # What slips at once slips from the start in the peer.
    assert len(instants) == len(course.events) >= events
    assert instants == pytest.approx(course.events, rel=1e-7)
    times = np.linspace(0.0, duration, 40)
    expected = np.array([course.displacements(time) for time in times]).T
    assert motion.state(times)[:4] == pytest.approx(expected, abs=1e-8 * abs(expected).max())


@pytest.mark.parametrize("velocity_too", quick([False, True], 0))
@pytest.mark.parametrize("tau", [0.0, 1e-3, math.inf])
@pytest.mark.parametrize("drive", [None, DRIVE])
def test_play(tau: float, velocity_too: bool, drive: tuple[float, float] | None) -> None:
    peer = PeerTrimmer(THESIS, velocity_too, drive, 2e-4 if drive else 2e-5, tau)
    compare(peer, 0.008 if drive else 0.003, 4)


@pytest.mark.parametrize("between", quick(PAIRS, 1, 2), ids=lambda each: each.label)
def test_friction_between_any_two_bodies(between: Displacement) -> None:
    compare(PeerTrimmer(THESIS, True, DRIVE, None, 0.0, (Friction(between.row, 0.3),)), 0.006, 2)


@pytest.mark.parametrize("velocity_too", quick([False, True], 1))
@pytest.mark.parametrize("tau", quick([0.0, 1e-3], 0))
@pytest.mark.parametrize("drive", [None, DRIVE])
def test_play_and_frictions_at_once(
    tau: float, velocity_too: bool, drive: tuple[float, float] | None
) -> None:
    frictions = (Friction((0.0, 1.0, 0.0, -1.0), 0.5, 0.3), Friction((0.0, 0.0, 1.0, 0.0), 0.1))
    peer = PeerTrimmer(THESIS, velocity_too, drive, 2e-4 if drive else 2e-5, tau, frictions)
    compare(peer, 0.006 if drive else 0.004, 6)


def test_viscous_friction_alone() -> None:
    peer = PeerTrimmer(THESIS, False, DRIVE, None, 0.0, (Friction((1.0, 0.0, 0.0, -1.0), 0.0, 2.0),))
    compare(peer, 0.005, 0)
    assert own_loop(replace(peer, frictions=())).interconnection().order == 8
