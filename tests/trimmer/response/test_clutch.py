"""A one-way clutch of parts that are there: on paper, and by SciPy with the law of a clutch itself."""

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from tests.trimmer.response.mechanisms import example
from trimmer import Body, Force, Friction, Mechanism, simulate

DRAG, CAPACITY = 1.0, 40.0


@pytest.mark.parametrize("push", [-6.0, 0.0, 66.0, 90.0])
def test_it_drags_then_locks_slips_or_overruns_on(push: float) -> None:
    """A load of 3 kg overruns a motor of 2 kg at first; then the motor carries what it can."""
    motor, load, lead, duration, bias = 2.0, 3.0, 0.5, 2.0, (CAPACITY - DRAG) / 2
    mechanism = Mechanism(
        {"motor": Body(motor), "load": Body(load)},
        frictions={"clutch": Friction(("motor", "load"), (CAPACITY + DRAG) / 2)},
        forces={"on motor": Force("motor", constant=push - bias), "on load": Force("load", constant=bias)},
        start={"load": (0.0, lead)},
    )
    closing = (push + DRAG) / motor + DRAG / load
    met = lead / closing if closing > lead / duration else duration
    left, carried = duration - met, min(push * load / (motor + load), CAPACITY)
    motion = simulate(mechanism, duration)
    of_motor, of_load = (push + DRAG) * met + (push - carried) * left, carried * left - DRAG * met
    speeds = [of_motor / motor, lead + of_load / load]
    assert [motion.velocity(name, duration) for name in mechanism.bodies] == pytest.approx(speeds, rel=1e-12)
    overrun = lead * met - closing * met**2 / 2
    slip = ((push - carried) / motor - carried / load) * left**2 / 2
    ahead = motion.displacement("load", duration) - motion.displacement("motor", duration)
    lost = motion.energy.frictions["clutch"] - bias * ahead
    assert lost == pytest.approx(DRAG * overrun + CAPACITY * slip, rel=1e-11)


@pytest.mark.parametrize("frequency", [10.0, pytest.param(4.0, marks=pytest.mark.slow)])
def test_the_feeder_moves_as_by_the_law_of_a_clutch(frequency: float) -> None:
    """At 4 Hz the clutch holds, at 10 Hz it slips. What holds creeps, by its force over ``steep``."""
    steep, omega, guide, duration = 1e7, 2 * math.pi * frequency, 12.0, 3.0 / frequency

    def rates(time: float, state: np.ndarray) -> list[float]:
        shuttle, _, speed, feed = state
        turned = 0.01 * np.exp(1j * omega * time)
        rod = 200e3 * (turned.imag - shuttle) + 200.0 * (omega * turned.real - speed)
        carried = min(max(steep * (speed - feed), -DRAG), CAPACITY)
        rubbing = min(max(steep * feed, -guide), guide)
        return [speed, feed, (rod - carried) / 0.5, (carried - rubbing) / 2.0]

    times = np.linspace(0.0, duration, 61)
    made = solve_ivp(rates, (0.0, duration), np.zeros(4), "Radau", times, rtol=1e-8, atol=1e-10).y[:2].T
    motion = simulate(example("strip-feeder").with_value("frequency", frequency), duration)
    moved = np.stack([motion.output(name, times) for name in ("shuttle", "strip")], axis=1)
    assert moved == pytest.approx(made, abs=(CAPACITY + guide) / steep * duration) and moved[-1, 1] > 0.04
