"""Measures of a step: closed forms of the oscillator, a fine grid for machines with events, jumps."""

import math

import numpy as np
import pytest
import scipy.optimize

from trimmer import Mechanism, simulate
from trimmer.motion.step_measures import Step, StepMeasures, step_measures

OMEGA = 2.0


def oscillator(damping_ratio: float, size: float, at: float) -> Mechanism:
    """Return an oscillator that a force moves by a step."""
    return Mechanism.from_toml_text(f"""
[bodies]
body = {{ mass = 1.0 }}
[links]
spring = {{ between = ["ground", "body"], stiffness = {OMEGA**2}, damping = {2 * damping_ratio * OMEGA} }}
[forces]
push = {{ on = "body", profile = [[{at}, {OMEGA**2 * size}]] }}
[outputs]
place = {{ body = 1 }}
""")


def measured(mechanism: Mechanism, output: str, duration: float, step: Step) -> StepMeasures:
    motion = simulate(mechanism, duration)
    return step_measures(motion.course, motion.flow.outputs[output].signal, step)


@pytest.mark.parametrize("damping_ratio", [0.02, 0.2, 0.5, 0.75])
@pytest.mark.parametrize(("size", "at"), [(1.0, 0.0), (-0.003, 0.7)])
def test_the_oscillator_follows_as_on_paper(damping_ratio: float, size: float, at: float) -> None:
    damped = OMEGA * math.sqrt(1 - damping_ratio**2)
    half = math.pi / damped

    def answer(time: float) -> float:
        turned = damped * time
        quotient = damping_ratio / math.sqrt(1 - damping_ratio**2)
        return 1 - math.exp(-damping_ratio * OMEGA * time) * (math.cos(turned) + quotient * math.sin(turned))

    def passing(level: float, low: float, high: float) -> float:
        return float(scipy.optimize.brentq(lambda time: answer(time) - level, low, high, xtol=1e-15))

    swings = max([n for n in range(1, 100) if math.exp(-damping_ratio * OMEGA * n * half) > 0.02], default=0)
    edge = 1 + (0.02 if swings % 2 else -0.02)
    duration = at + (swings + 2) * half
    found = measured(oscillator(damping_ratio, size, at), "place", duration, Step(size, at))
    assert found.rise_time == pytest.approx(passing(0.9, 0, half) - passing(0.1, 0, half), rel=1e-12)
    assert found.overshoot == pytest.approx(100 * math.exp(-damping_ratio * OMEGA * half), rel=1e-11)
    assert found.settling_time == pytest.approx(passing(edge, swings * half, (swings + 1) * half), rel=1e-12)
    assert found.final_error == pytest.approx(size * (1 - answer(duration - at)), rel=1e-9)
    assert (found.largest_control, found.largest_demand) == (None, None)


def test_what_does_not_happen_is_none() -> None:
    heavy = oscillator(0.02, 1.0, 0.0)
    early = measured(heavy, "place", 0.3, Step(1.0))
    assert (early.rise_time, early.overshoot, early.settling_time) == (None, 0.0, None)
    inside = measured(heavy, "place", 0.02, Step(1.0, 0.015)).final_error
    assert inside == pytest.approx(1 - 2 * 0.02**2, rel=1e-4)
    for step in (Step(0.0), Step(1.0, 0.3)):
        with pytest.raises(ValueError, match="must not be 0, and lie within the motion"):
            measured(heavy, "place", 0.3, step)


GAP_AND_FRICTION = """
[bodies]
motor = { mass = 1.0 }
load = { mass = 2.0 }
[links]
spring = { between = ["ground", "motor"], stiffness = 900.0, damping = 6.0 }
[plays]
gear = { between = ["motor", "load"], stiffness = 4e4, damping = 20.0, gap = 0.02 }
[frictions]
guide = { between = ["ground", "load"], force = 3.0, static = 5.0 }
[walls]
end = { between = ["ground", "load"], gap = 0.145, restitution = 0.5 }
[forces]
push = { on = "motor", profile = [[0.05, 108.0]] }
[outputs]
place = { load = 1 }
speed = { velocity = { load = 1 } }
push = { force = "spring" }
"""


@pytest.mark.parametrize(("output", "size"), [("place", 0.12), ("speed", -0.5), ("push", 100.0)])
def test_events_and_jumps_are_met_as_a_fine_grid_meets_them(output: str, size: float) -> None:
    motion = simulate(Mechanism.from_toml_text(GAP_AND_FRICTION), 1.2)
    signal = motion.flow.outputs[output].signal
    found = step_measures(motion.course, signal, Step(size, 0.05), control=signal)
    assert {"impact", "stick begun", "contact broken"} <= {each.kind.value for each in motion.events}
    times, step = np.linspace(0.05, 1.2, 60_001, retstep=True)
    shares = motion.output(output, times) / size
    reached = [times[np.flatnonzero(shares >= level)] for level in (0.1, 0.9)]
    outside = times[np.flatnonzero(abs(shares - 1) > 0.02)]
    close = 2.1 * step
    if all(map(len, reached)):
        assert found.rise_time == pytest.approx(reached[1][0] - reached[0][0], abs=close)
    else:
        assert found.rise_time is None
    if outside[-1] == times[-1]:
        assert found.settling_time is None
    else:
        assert found.settling_time == pytest.approx(outside[-1] - 0.05, abs=close)
    assert found.overshoot == pytest.approx(100 * max(shares.max() - 1, 0.0), rel=1e-3, abs=1e-3)
    assert found.largest_control == pytest.approx(abs(size * shares).max(), rel=1e-3)
