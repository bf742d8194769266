"""Random mechanisms: what they settle to, held against their own rules and other units."""

import json
from dataclasses import replace

import pytest

from tests.mechanisms.random_mechanisms import all_with, random_mechanism
from tests.quick import quick
from trimmer import Mechanism, MotionKind, UnsupportedMotionError, respond, simulate
from trimmer.response.results.response_json import response_json

PERIODS = 200


@pytest.mark.parametrize("seed", quick((11, 27, *range(1, 300, 3)), 0, 1))
def test_what_a_random_mechanism_settles_to(seed: int) -> None:
    """Held against its own rules: return, energy, and where its motion goes."""
    mechanism = random_mechanism(seed)
    try:
        response = respond(mechanism, most_periods=PERIODS)
    except UnsupportedMotionError:
        return
    json.dumps(response_json(response), allow_nan=False)
    motion = response.motion
    assert simulate(mechanism, 5.3 / mechanism.frequency).energy.residual < 1e-10
    if response.kind is MotionKind.PERIODIC:
        orbit = motion.orbit
        assert orbit.residual < 1e-10
        assert orbit.stable or orbit.neutral
        later = orbit.flow.strobe(orbit.flow.rest(), motion.drive_periods + 100 * orbit.periods).states[-1]
        closest = abs((orbit.strobed - later) / orbit.sizes).max(axis=1).min()
        assert closest < max(1e-9, 2 * abs(orbit.nontrivial_multipliers).max() ** 100 * orbit.growth)
    elif response.kind is MotionKind.CHAOTIC:
        assert motion.lyapunov.value - 3 * motion.lyapunov.uncertainty > 0


def scaled(mechanism: Mechanism, length: float, force: float) -> Mechanism:
    """Return a mechanism with all lengths and forces multiplied, and with them stiffness and so on."""
    stiffness = force / length
    contact = {"stiffness": stiffness, "damping": stiffness, "gap": length}
    return replace(
        mechanism,
        bodies=all_with(mechanism.bodies, mass=stiffness),
        pins=all_with(mechanism.pins, amplitude=length, offset=length, velocity=length),
        links=all_with(mechanism.links, stiffness=stiffness, damping=stiffness),
        plays=all_with(mechanism.plays, **contact),
        stops=all_with(mechanism.stops, **contact),
        frictions=all_with(mechanism.frictions, force=force, static=force, viscous=stiffness),
        forces=all_with(mechanism.forces, constant=force, amplitude=force, unbalance=force),
        start={name: (q * length, v * length) for name, (q, v) in mechanism.start.items()},
    )


@pytest.mark.slow
@pytest.mark.parametrize("seed", quick([7, 25, 98], 0))
def test_responses_scale_with_lengths_and_forces(seed: int) -> None:
    mechanism = random_mechanism(seed)
    first = respond(mechanism, most_periods=PERIODS).motion.orbit
    second = respond(scaled(mechanism, 8.0, 0.25), most_periods=PERIODS).motion.orbit
    assert second.period_count == first.period_count
    assert second.multipliers == pytest.approx(first.multipliers, rel=1e-6, abs=1e-9)
    for name, acceleration in first.measures.rms_acceleration.items():
        assert second.measures.rms_acceleration[name] == pytest.approx(8.0 * acceleration, rel=1e-9)
    for name, friction in first.measures.frictions.items():
        assert second.measures.frictions[name].work == pytest.approx(2.0 * friction.work, rel=1e-8, abs=1e-15)
