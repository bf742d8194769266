"""Motions and mechanisms made by hand, so that every number of them is known."""

from typing import Any

import numpy as np

from trimmer import Mechanism, MotionKind
from trimmer.design import FoundMotion, MotionSignals
from trimmer.motion.measures import OutputMeasures
from trimmer.motion.part_measures import ContactMeasures, FrictionMeasures


def output(smallest: float, largest: float, amplitudes: Any = (), period_count: int = 1) -> OutputMeasures:
    """Return what an output does, with the mean square of its lines."""
    waves = np.array(amplitudes, dtype=complex)
    rms = float(np.sqrt(0.5 * np.sum(abs(waves) ** 2)))
    return OutputMeasures(smallest, largest, 0.25 * (smallest + largest), rms, waves, period_count)


def contact(speed: float, force: float = 1.0) -> ContactMeasures:
    return ContactMeasures(2.0, (0.5 * speed, speed), force, 0.25, 0.0)


def friction(power: float, stick: float = 0.0) -> FrictionMeasures:
    return FrictionMeasures(power / 110, power, stick)


def motion(**changes: Any) -> FoundMotion:
    """Return a motion that repeats after a drive period of 1/110 s, with some of it changed."""
    fields: dict[str, Any] = {
        "kind": MotionKind.PERIODIC,
        "period_count": 1,
        "period": 1 / 110,
        "starts": 4,
        "mirrored": False,
        "drive_periods": 17,
        "neighbour_agrees": None,
        "lyapunov": None,
        "multipliers": np.array([0.5 + 0j]),
        "neutral": False,
        "state": np.array([1e-3, 0.2]),
        "measured_periods": 1,
        "outputs": {"stroke": output(-1e-3, 2e-3)},
        "rms_acceleration": {"motor": 90.0, "cutter": 300.0},
        "contacts": {"bridge": contact(0.2)},
        "frictions": {"blade": friction(0.3)},
        "hand_arm": {},
        "events": 6.0,
        "signals": MotionSignals(np.empty(0), {}, {}, {}, {}),
    }
    return FoundMotion(**{**fields, **changes})


OSCILLATOR = """
frequency = 20.0
[bodies]
block = { mass = 0.5 }
[links]
spring = { between = ["ground", "block"], stiffness = 9e3, damping = 4.0 }
[forces]
shaker = { on = "block", amplitude = 7.0 }
[outputs]
block = { block = 1 }
double = { block = -2 }
"""
"""An oscillator whose motion is known in closed form."""


def oscillator() -> Mechanism:
    return Mechanism.from_toml_text(OSCILLATOR)


def oscillator_amplitude(frequency: float = 20.0, stiffness: float = 9e3) -> float:
    """Return F / |k - m w^2 + i c w|, m."""
    omega = 2 * np.pi * frequency
    return float(7.0 / abs(stiffness - 0.5 * omega**2 + 4j * omega))
