"""Laws that every motion obeys: scaling, symmetry, shift of the start, the linear limit."""

import math
from functools import cache

import numpy as np
import pytest
import scipy.linalg
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.trimmer.trimmers import trimmers
from trimmer import CoulombFriction, Motion, TrimmerParameters, ViscousBacklash, simulate
from trimmer.loops import BodyFriction, Drive, Outcome, TrimmerLoop
from trimmer.thesis import Displacement, InputChannels, TrimmerBody

THESIS = TrimmerParameters.thesis()
GAP, AMPLITUDE, OMEGA, FORCE, IMPULSE = 2e-4, 1.5e-3, 2 * math.pi * 110, 2.0, 1e-6
BLADES, SHELL = (
    Displacement(TrimmerBody.CUTTER, TrimmerBody.GUARD),
    Displacement(TrimmerBody.HOUSING, TrimmerBody.GUARD),
)
TAUS = st.sampled_from([0.0, 1e-6, 1e-3, math.inf])
CHANNELS = st.sampled_from(InputChannels)


def moved(  # All that the laws vary.
    *,
    scale: float = 1.0,
    driven: bool = True,
    tau: float = 0.0,
    channels: InputChannels = InputChannels.DISPLACEMENT_ONLY,
    phase: float = 0.0,
    duration: float = 0.02,
    parameters: TrimmerParameters = THESIS,
    **start: object,
) -> Motion:
    """Move a trimmer with play and friction, all lengths and forces times a scale."""
    loop = TrimmerLoop(
        parameters,
        ViscousBacklash(abs(scale) * GAP, tau),
        Drive(abs(scale) * AMPLITUDE, OMEGA, phase) if driven else None,
        channels=channels,
        frictions=(BodyFriction(BLADES, CoulombFriction(abs(scale) * FORCE)),),
    )
    return simulate(loop, duration, impulse=0.0 if driven else 10 * scale * IMPULSE, **start)


@settings(max_examples=7)
@given(st.floats(-6, 6), st.booleans(), TAUS, CHANNELS)
def test_displacements_scale_with_gap_drive_and_force(exponent, driven, tau, channels) -> None:
    scale = 10**exponent
    one = moved(driven=driven, tau=tau, channels=channels)
    other = moved(scale=scale, driven=driven, tau=tau, channels=channels)
    assert len(one.events) > 5
    assert other.event_times == pytest.approx(one.event_times, rel=1e-10)
    times = np.linspace(0.0, one.duration, 50)
    expected = scale * one.state(times)
    for found, wanted in zip(other.state(times), expected, strict=True):
        assert found == pytest.approx(wanted, abs=1e-9 * abs(wanted).max())


@settings(max_examples=7)
@given(TAUS, CHANNELS)
def test_the_mirrored_start_gives_the_mirrored_motion_to_the_last_bit(tau, channels) -> None:
    one, other = (
        moved(scale=scale, driven=False, tau=tau, channels=channels, element_output=3e-5 * scale)
        for scale in (1.0, -1.0)
    )
    assert len(one.events) > 5
    assert np.array_equal(one.event_times, other.event_times)
    times = np.linspace(0.0, one.duration, 50)
    assert np.array_equal(one.state(times), -other.state(times))
    mirrored = {"upper contact": "lower contact", "plus": "minus"}
    mirrored |= {there: here for here, there in mirrored.items()}
    for here, there in zip(one.events, other.events, strict=True):
        assert (here.kind, here.component) == (there.kind, there.component)
        assert mirrored.get(here.mode, here.mode) == there.mode


@settings(max_examples=12)
@given(st.integers(0, 20), st.floats(0.05, 0.95), CHANNELS)
def test_a_motion_can_start_in_the_middle(number: int, share: float, channels: InputChannels) -> None:
    """In the gap, since a contact is an edge, and while the blades slide, since stick is another."""
    whole = undisturbed(channels)
    times = whole.event_times
    starts = times[:-1] + share * np.diff(times)
    play = whole.element_input(starts) - whole.element_output(starts)
    slides = abs(whole.component_outputs(starts)[1]) > 0.999 * FORCE
    inside = starts[(abs(play) < 0.499 * GAP) & slides]
    start = float(inside[number % len(inside)])
    rest = moved(
        channels=channels,
        phase=OMEGA * start,
        duration=0.04 - start,
        initial_state=whole.state(start),
        element_output=float(whole.element_output(start)),
    )
    after = times[times > start]
    assert rest.event_times == pytest.approx(after - start, abs=1e-11)
    instants = np.linspace(0.0, 0.999 * rest.duration, 20)
    expected = whole.state(start + instants)[:4]
    assert rest.state(instants)[:4] == pytest.approx(expected, abs=1e-10 * abs(expected).max())


@cache
def undisturbed(channels: InputChannels) -> Motion:
    return moved(channels=channels, duration=0.04)


@settings(max_examples=10)
@given(trimmers(), st.booleans(), CHANNELS)
def test_without_play_and_friction_it_is_the_matrix_exponential(parameters, driven, channels) -> None:
    drive = Drive(AMPLITUDE, OMEGA, 0.7) if driven else None
    loop = TrimmerLoop(parameters, None, drive, channels=channels)
    model = loop.model
    motion = simulate(loop, 0.01, impulse=IMPULSE)
    n = model.nstates
    flow = np.zeros((n + 2, n + 2))
    flow[:n, :n] = model.A if driven else model.A - model.B @ model.C
    flow[:n, n] = model.B[:, 0] * AMPLITUDE * driven
    flow[n, n + 1], flow[n + 1, n] = OMEGA, -OMEGA
    start = np.concatenate([model.B[:, 0] * IMPULSE, [math.sin(0.7), math.cos(0.7)]])
    times = np.linspace(0.0, 0.01, 7)
    expected = np.array([scipy.linalg.expm(flow * time) @ start for time in times])[:, :n].T
    if motion.outcome is Outcome.COMPLETED:  # Some closed loops are unstable, beyond all numbers.
        sizes = abs(expected).max(axis=1, keepdims=True)
        assert motion.state(times) / sizes == pytest.approx(expected / sizes, abs=1e-9)
    else:
        assert driven is False
    assert motion.events == ()
