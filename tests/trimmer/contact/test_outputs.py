"""Outputs of every kind: against brute force on both sides of events, and by the laws of motion."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from tests.mechanisms.brute_force import BruteForce
from tests.mechanisms.measures import extremes, root_mean_square
from tests.mechanisms.outputs import output_row
from tests.mechanisms.random_mechanisms import random_mechanism
from tests.quick import quick
from tests.trimmer.contact.test_curves import with_curves
from trimmer import Mechanism, Output, respond, simulate
from trimmer.motion.measures import Measures

WITH_FORCE = ("links", "plays", "stops", "frictions")


def asked(mechanism: Mechanism) -> Mechanism:
    """Return a mechanism with outputs of each kind of all that it has."""
    ends = {
        name: (-1.0) ** place * (1 + place) for place, name in enumerate((*mechanism.bodies, *mechanism.pins))
    }
    outputs = {kind: Output(ends, kind) for kind in ("displacement", "velocity", "acceleration")}
    forces = [name for section in WITH_FORCE for name in getattr(mechanism, section)]
    return replace(mechanism, outputs=outputs | {name: Output(kind="force", part=name) for name in forces})


MADE = [(made, seed) for made in (random_mechanism, with_curves) for seed in range(2, 9, 2)]


@pytest.mark.parametrize(("made", "seed"), quick(MADE, 7))
def test_extremes_and_rms_are_those_of_another_integrator(
    made: Callable[[int], Mechanism], seed: int
) -> None:
    mechanism = asked(made(seed))
    duration = 1.1 / mechanism.frequency
    motion, brute = simulate(mechanism, duration), BruteForce().from_rest(mechanism, duration)
    measures = Measures(motion.course, motion.flow, 1, 1).outputs
    determined = {
        name: each for name, each in mechanism.outputs.items() if name not in motion.undetermined_frictions
    }
    for name, output in determined.items():

        def row(mode, output=mechanism.outputs[name], speed=motion.flow.outputs[name].speed):
            rows = brute.system.rows
            # Measures are those of what is left without the travel of a belt.
            return output_row(brute.system, output, mode) - speed * rows.unit(rows.state_size + 1)

        found, size = measures[name], max(map(abs, extremes(brute, row)))
        assert (found.smallest, found.largest) == pytest.approx(
            extremes(brute, row), rel=1e-8, abs=1e-8 * size
        )
        squared = found.rms**2 + found.mean**2
        assert squared == pytest.approx(root_mean_square(brute, row) ** 2, rel=1e-7, abs=1e-12 * size**2)


def test_rates_have_the_lines_of_what_they_are_rates_of(lever: Mechanism) -> None:
    orbit = respond(lever).motion.orbit
    assert orbit is not None
    x, v, a = (orbit.measures.outputs[name].amplitudes for name in ("x", "v", "a"))
    turning = 2j * np.pi / orbit.period * np.arange(1, len(x) + 1)
    np.testing.assert_allclose(v, turning * x, rtol=1e-9, atol=1e-12 * abs(v).max())
    np.testing.assert_allclose(a, turning * v, rtol=1e-9, atol=1e-12 * abs(a).max())
    assert orbit.measures.outputs["v"].mean == pytest.approx(0.0, abs=1e-12 * abs(v).max())
    assert orbit.measures.outputs["pin"].peak_to_peak == pytest.approx(2 * 3e-3 * (2 * np.pi * 20.0) ** 2)


def test_forces_move_the_bodies(lever: Mechanism) -> None:
    motion = simulate(lever, 0.31)
    times = np.linspace(0.0, motion.duration, 997)
    read = {name: motion.signal(name, times) for name in lever.outputs}
    pulled = read["spring"] - read["slot"] + read["seat"] + read["blade"]
    np.testing.assert_allclose(-0.2 * read["a"], pulled, atol=1e-11 * abs(read["slot"]).max())
    assert motion.signals == {
        **dict.fromkeys(("x",), "m"),
        "v": "m/s",
        "a": "m/s²",
        "pin": "m/s²",
        **dict.fromkeys(("spring", "slot", "seat", "blade"), "N"),
    }
    assert motion.course.log.start.size > 20


@pytest.fixture(scope="module")
def lever() -> Mechanism:
    """A block with one part of each kind, whose forces are all asked for."""
    return Mechanism.from_toml_text("""
frequency = 20.0
[bodies]
block = { mass = 0.2 }
[pins]
crank = { on = "ground", amplitude = 3e-3 }
[links]
spring = { between = ["ground", "block"], stiffness = 2e3, damping = 1.5 }
[plays]
slot = { between = ["block", "crank"], stiffness = 15e3, damping = 2.0, gap = 1e-3 }
[stops]
seat = { between = ["ground", "block"], stiffness = 9e3, damping = 3.0, gap = 1.5e-3, law = "pulling" }
[frictions]
blade = { between = ["ground", "block"], force = 0.8, static = 1.1, viscous = 0.4 }
[outputs]
x = { block = 1 }
v = { velocity = { block = 1 } }
a = { acceleration = { block = 1 } }
pin = { acceleration = { crank = 1 } }
spring = { force = "spring" }
slot = { force = "slot" }
seat = { force = "seat" }
blade = { force = "blade" }
""")
