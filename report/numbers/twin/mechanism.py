"""The physical twin: the trimmer of Listing A.1, whose bridge has play around the pin and pushes back."""

from typing import Final

from report.numbers.thesis import DRIVE_AMPLITUDE
from trimmer import Mechanism, TrimmerParameters
from trimmer.mechanism.parts import GROUND, Body, Friction, Link, Output, Pin, Play

FREQUENCY: Final = 110.0  # Drive of the twin where nothing else is said, Hz
GAP, FORCE = "plays.bridge.gap", "frictions.blade.force"
STIFFNESS, DAMPING = "plays.bridge.stiffness", "plays.bridge.damping"
SPEED, AMPLITUDE = "frequency", "pins.pin.amplitude"  # Places of the numbers that are varied
STROKE, BRIDGE, BLADE, MOTOR, CUTTER = "stroke", "bridge", "blade", "motor", "cutter"
"""Names of its output, its play, its friction and two of its bodies."""
SMALL_GAP, SMALL_FORCE = 40e-6, 0.5  # Play, m, and friction, N, of ``examples/thesis-play.toml``


def twin(gap: float = SMALL_GAP, force: float = SMALL_FORCE, frequency: float = FREQUENCY) -> Mechanism:
    """Return the mechanism of ``examples/thesis-play.toml`` with a gap, m, friction, N, and drive, Hz.

    Raises:
        MechanismError: if one of them is no such number.
    """
    p = TrimmerParameters.thesis()
    return Mechanism(
        title="Trimmer of the thesis, with play",
        frequency=frequency,
        bodies={MOTOR: Body(p.m1), CUTTER: Body(p.m2), "housing": Body(p.m3), "guard": Body(p.m4)},
        pins={"pin": Pin(MOTOR, DRIVE_AMPLITUDE)},
        links={
            "motor mount": Link((GROUND, MOTOR), p.k1, p.c1),
            "housing mount": Link((GROUND, "housing"), p.k3, p.c3),
            "guard spring": Link(("housing", "guard"), p.k4, p.c4),
            "coil spring": Link(("housing", CUTTER), p.k5),
        },
        plays={BRIDGE: Play((CUTTER, "pin"), p.k2, p.c2, gap)},
        frictions={BLADE: Friction(("guard", CUTTER), force)},
        outputs={STROKE: Output({CUTTER: 1.0, "guard": -1.0})},
    )
