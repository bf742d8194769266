"""Motions whose first events are known to 30 digits: what moves, for both computations."""

from __future__ import annotations

import csv
import math
from dataclasses import dataclass
from pathlib import Path

import mpmath
from mpmath import mpf

from tests.trimmer.loops.reference.exact_events import first_instants
from tests.trimmer.loops.reference.exact_flight import Friction, Moment, Trimmer
from trimmer import CoulombFriction, Drive, TrimmerLoop, TrimmerParameters, ViscousBacklash, simulate
from trimmer.linear import InputChannels
from trimmer.loops import BodyFriction, LoopMotion
from trimmer.thesis import Displacement, TrimmerBody

TABLE = Path(__file__).with_name("exact_times.csv")
COUNT = 50
"""Instants in the table, for each motion."""
IMPULSE = 1e-6
"""Impulse at the displacement of the pin, m s, where nothing drives."""
THESIS = TrimmerParameters.thesis()
PIN = (1.5e-3, 2 * math.pi * 110)
"""Amplitude (m) and omega (rad/s) of the thesis's drive."""
BODIES = tuple(TrimmerBody)

CASES = {
    "closed loop, friction-controlled": Trimmer(THESIS, 4e-5, 0.0, False),
    "closed loop, viscous": Trimmer(THESIS, 4e-5, 3e-4, False),
    "closed loop, load that comes to rest": Trimmer(THESIS, 4e-5, 1e-6, False),
    "closed loop, inertia-controlled": Trimmer(THESIS, 4e-5, math.inf, False),
    "driven, friction between cutter and guard": Trimmer(
        THESIS, 2e-4, 0.0, True, PIN, (Friction(1, 3, 5.0),)
    ),
    "driven, two frictions": Trimmer(
        THESIS, 2e-4, 1e-3, True, PIN, (Friction(1, 2, 2.0), Friction(3, None, 1.0))
    ),
    "closed loop, friction on the motor": Trimmer(THESIS, 4e-5, 0.0, False, None, (Friction(0, None, 0.2),)),
}


@dataclass(frozen=True)
class Instant:
    """When something happens, in 30 digits, and what."""

    kind: str
    time: mpf


def computed(case: Trimmer, count: int) -> list[Instant]:
    """Compute the first instants; a twelfth of a second each."""
    rates = mpmath.zeros(4, 1)
    if case.drive is None:  # The impulse through the spring k2 moves motor and cutter apart.
        with mpmath.workdps(30):
            push = mpf(THESIS.k2) * mpf(IMPULSE)
            rates[0], rates[1] = -push / mpf(THESIS.m1), push / mpf(THESIS.m2)
    start = Moment(mpf(0), mpmath.zeros(4, 1), rates)
    return [Instant(kind, time) for kind, time in first_instants(case, start, count)]


def tabulated(name: str) -> list[Instant]:
    """Read the first instants from the table."""
    with TABLE.open(encoding="utf-8", newline="") as file, mpmath.workdps(30):
        return [
            Instant(row["kind"], mpf(row["time"])) for row in csv.DictReader(file) if row["motion"] == name
        ]


def write_table() -> None:
    """Compute the table anew; half a minute."""
    with TABLE.open("w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["motion", "kind", "time"])
        for name, case in CASES.items():
            for instant in computed(case, COUNT):
                writer.writerow([name, instant.kind, mpmath.nstr(instant.time, 30)])


def simulated(case: Trimmer, duration: float) -> LoopMotion:
    """Simulate a case with the engine."""
    loop = TrimmerLoop(
        THESIS,
        ViscousBacklash(case.gap, case.time_constant),
        Drive(*case.drive) if case.drive else None,
        channels=InputChannels.DISPLACEMENT_AND_VELOCITY
        if case.velocity_too
        else InputChannels.DISPLACEMENT_ONLY,
        frictions=tuple(
            BodyFriction(
                Displacement(BODIES[each.of], None if each.relative_to is None else BODIES[each.relative_to]),
                CoulombFriction(each.force),
            )
            for each in case.frictions
        ),
    )
    return simulate(loop, duration, impulse=0.0 if case.drive else IMPULSE)


if __name__ == "__main__":
    write_table()
