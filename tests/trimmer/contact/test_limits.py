"""Limits in which the exact motion of a mechanism is known from elsewhere."""

import numpy as np
import pytest

from tests.mechanisms.cases import trimmer
from trimmer import FrictionBacklash
from trimmer.contact.advance import Ending
from trimmer.contact.flow import ExactFlow
from trimmer.mechanism.matrices import linear_matrices
from trimmer.mechanism.mechanism import Mechanism
from trimmer.mechanism.parts import Body, ContactLaw, Friction, Pin, Play

FREQUENCY = 110.0
AMPLITUDE = 1.5e-3


def settled(mechanism, periods):
    """Return a period of what a mechanism does after some periods from rest."""
    flow = ExactFlow(mechanism)
    strobe = flow.strobe(flow.rest(), periods)
    assert strobe.ending is Ending.REACHED_END
    return flow.course(strobe.end, 1)


def first_harmonic(course, row):
    """Return the complex amplitude of a signal, with sin(omega t) as reference."""
    times, weights, _, states = course.nodes
    omega = 2 * np.pi / course.duration
    return 2j / course.duration * (weights * (states @ row)) @ np.exp(-1j * omega * times)


def linear_response():
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
    course = settled(trimmer(law, friction=0.0, gap=0.0), 600)
    found = [first_harmonic(course, row) for row in np.eye(course.log.state.shape[1])[:4]]
    np.testing.assert_allclose(found, linear_response(), rtol=1e-11)


def test_the_matrices_of_the_linear_part_are_those_of_the_flow():
    mechanism = trimmer(friction=0.0, gap=0.0)
    flow = ExactFlow(mechanism)
    instant = flow.rest()
    matrix = flow.modes[flow.modes.number(instant.statuses)].flow
    matrices = linear_matrices(mechanism)
    inverse = np.diag(1 / np.diag(matrices.mass))
    push = np.array([1.0, -1.0, 0, 0])
    np.testing.assert_allclose(
        matrix[4:8, :4], -inverse @ (matrices.stiffness + 30e3 * np.outer(push, push)), rtol=1e-13
    )
    np.testing.assert_allclose(
        matrix[4:8, 4:8],
        -inverse @ (matrices.damping + 0.4 * np.outer(push, push)),
        rtol=1e-13,
        atol=1e-10,
    )


def test_a_small_gap_departs_from_the_linear_trimmer_in_proportion():
    linear = linear_response()[1]
    departures = [
        abs(first_harmonic(settled(trimmer(friction=0.0, gap=gap), 600), np.eye(12)[1]) - linear) / gap
        for gap in (1e-7, 1e-8)
    ]
    assert departures[0] == pytest.approx(departures[1], rel=1e-2)
    assert departures[0] > 0.01


def test_without_damping_all_laws_are_the_dead_zone():
    ends = []
    for law in ContactLaw:
        flow = ExactFlow(trimmer(law, damping=0.0))
        ends.append(flow.strobe(flow.rest(), 3).states[-1][:8])
    np.testing.assert_allclose(ends[1], ends[0], rtol=1e-13)
    np.testing.assert_allclose(ends[2], ends[0], rtol=1e-13)


def test_with_little_damping_a_relaxing_contact_approaches_the_dead_zone_in_proportion():
    def after(damping):
        flow = ExactFlow(trimmer(damping=damping))
        return flow.strobe(flow.rest(), 1).states[-1][:8]

    dead_zone = after(0.0)
    departures = [np.linalg.norm(after(damping) - dead_zone) / damping for damping in (1e-3, 1e-4)]
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
    departures = []
    for scale in (1.0, 0.3, 0.1):
        course = settled(light_bridge(scale), 5)
        found = first_harmonic(course, np.eye(course.log.state.shape[1])[0]) / AMPLITUDE
        departures.append(abs(found - expected) / scale)
    # The describing function is approached in proportion to scale: by 8.5e-4 at scale 1.
    np.testing.assert_allclose(departures, 8.488e-4, rtol=4e-3)
