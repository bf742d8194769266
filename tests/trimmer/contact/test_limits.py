"""Limits in which the exact motion of a mechanism is known from elsewhere."""

from dataclasses import replace

import numpy as np
import pytest

from tests.mechanisms.cases import trimmer
from trimmer import ContactLaw, FrictionBacklash, Mechanism, forced_orbit, simulate
from trimmer.mechanism import Body, Friction, Output, Pin, Play

FREQUENCY = 110.0
AMPLITUDE = 1.5e-3


def first_harmonics(mechanism: Mechanism, settling: int | None = None) -> np.ndarray:
    """Return the complex amplitude of each body in the motion that repeats; sin(omega t) has 1."""
    outputs = {name: Output({name: 1.0}) for name in mechanism.bodies}
    orbit = forced_orbit(replace(mechanism, outputs=outputs), settling)
    assert orbit.success
    return np.array([1j * orbit.measures.outputs[name].amplitudes[0] for name in outputs])


def linear_response() -> np.ndarray:
    """Return the complex amplitudes of the bodies of the linear trimmer, from its matrices."""
    omega = 2 * np.pi * FREQUENCY
    mass = np.diag([0.035, 0.003, 0.005, 0.030])
    stiffness = np.array(
        [
            [230e3, -30e3, 0, 0],
            [-30e3, 31e3, -1e3, 0],
            [0, -1e3, 251e3, -100e3],
            [0, 0, -100e3, 100e3],
        ]
    )
    damping = np.array([[3.9, -0.4, 0, 0], [-0.4, 0.4, 0, 0], [0, 0, 5.0, -4.0], [0, 0, -4.0, 4.0]])
    dynamic = stiffness + 1j * omega * damping - omega**2 * mass
    return np.linalg.solve(dynamic, (30e3 + 0.4j * omega) * AMPLITUDE * np.array([-1.0, 1.0, 0, 0]))


@pytest.mark.parametrize("law", [ContactLaw.RELAXING, ContactLaw.PULLING])
def test_without_gap_it_is_the_linear_trimmer_with_both_channels_of_the_pin(law):
    found = first_harmonics(trimmer(law, friction=0.0, gap=0.0))
    np.testing.assert_allclose(found, linear_response(), rtol=1e-11)


def after(periods: int, **changes) -> np.ndarray:
    """Return displacements and velocities after some periods from rest."""
    duration = periods / FREQUENCY
    return simulate(trimmer(**changes), duration).states(duration)[:8]


def test_without_damping_all_laws_are_the_dead_zone():
    ends = [after(3, law=law, damping=0.0) for law in ContactLaw]
    np.testing.assert_allclose(ends[1], ends[0], rtol=1e-12)
    np.testing.assert_allclose(ends[2], ends[0], rtol=1e-12)


def test_with_little_damping_a_relaxing_contact_approaches_the_dead_zone_in_proportion():
    dead_zone = after(1, damping=0.0)
    departures = [np.linalg.norm(after(1, damping=damping) - dead_zone) / damping for damping in (1e-3, 1e-4)]
    assert departures[0] == pytest.approx(departures[1], rel=1e-2)


def light_bridge(scale):
    """Return a bridge that friction holds, in a slot that is stiffer the smaller ``scale`` is."""
    mass, stiffness = 1e-5 * scale, 1e6 / scale
    return Mechanism(
        bodies={"bridge": Body(mass)},
        frequency=FREQUENCY,
        pins={"pin": Pin("ground", AMPLITUDE)},
        plays={"slot": Play(("bridge", "pin"), stiffness, np.sqrt(stiffness * mass), 2e-4)},
        frictions={"holder": Friction(("ground", "bridge"), 1.0)},
    )


def test_a_light_bridge_in_a_stiff_slot_is_the_friction_controlled_play_of_the_thesis():
    expected = complex(FrictionBacklash(2e-4).describing_function(AMPLITUDE))
    departures = [
        abs(first_harmonics(light_bridge(scale), 5)[0] / AMPLITUDE - expected) / scale
        for scale in (1.0, 0.3, 0.1)
    ]
    # The describing function is approached in proportion to scale: by 8.5e-4 at scale 1.
    np.testing.assert_allclose(departures, 8.488e-4, rtol=4e-3)
