"""Event times against 30 digits, in closed loop and driven, with play, friction and stick."""

import csv
import math
from dataclasses import dataclass
from itertools import groupby
from pathlib import Path

import control
import mpmath
import numpy as np
import pytest

from trimmer import CoulombFriction, FrictionBacklash, TrimmerParameters, ViscousBacklash, simulate
from trimmer.linear import InputChannels
from trimmer.loops import BodyFriction, Drive, EventKind, LoopMotion, OpenLoop, TrimmerLoop

TABLE = Path(__file__).with_name("reference") / "exact_times.csv"
"""The first instants of each motion: sums of exponentials in 30 digits of mpmath, whose zeros are enclosed.

Programs that knew nothing of the engine computed them; they are in the repository's history, in the folder of
the table, up to the commit that removed ``exact_flight.py`` there.
"""
COUNT = 50  # Instants in the table, for each motion
IMPULSE = 1e-6  # Impulse at the displacement of the pin, m s, where nothing drives
PIN = Drive(1.5e-3, 2 * math.pi * 110)
BOTH, ONE = InputChannels.DISPLACEMENT_AND_VELOCITY, InputChannels.DISPLACEMENT_ONLY


def case(
    gap: float, time_constant: float, drive: Drive | None = None, frictions: dict[str, float] | None = None
) -> TrimmerLoop:
    """Return the thesis's trimmer with frictions (N) at displacements; a pin that is driven acts by both."""
    rubbing = tuple(BodyFriction(at, CoulombFriction(force)) for at, force in (frictions or {}).items())
    return TrimmerLoop(
        TrimmerParameters.thesis(),
        ViscousBacklash(gap, time_constant),
        drive,
        channels=BOTH if drive else ONE,
        frictions=rubbing,
    )


CASES = {
    "closed loop, friction-controlled": case(4e-5, 0.0),
    "closed loop, viscous": case(4e-5, 3e-4),
    "closed loop, load that comes to rest": case(4e-5, 1e-6),
    "closed loop, inertia-controlled": case(4e-5, math.inf),
    "driven, friction between cutter and guard": case(2e-4, 0.0, PIN, {"q2-q4": 5.0}),
    "driven, two frictions": case(2e-4, 1e-3, PIN, {"q2-q3": 2.0, "q4": 1.0}),
    "closed loop, friction on the motor": case(4e-5, 0.0, None, {"q1": 0.2}),
}


@dataclass(frozen=True)
class Instant:
    """When something happens, in 30 digits, and what."""

    kind: str
    time: mpmath.mpf


def tabulated(name: str) -> list[Instant]:
    """Read the first instants from the table."""
    with TABLE.open(encoding="utf-8", newline="") as file, mpmath.workdps(30):
        rows = [row for row in csv.DictReader(file) if row["motion"] == name]
        return [Instant(row["kind"], mpmath.mpf(row["time"])) for row in rows]


def simulated(loop: TrimmerLoop, duration: float) -> LoopMotion:
    return simulate(loop, duration, impulse=0.0 if loop.drive else IMPULSE)


NAMES = sorted(CASES)


@pytest.mark.parametrize("name", NAMES)
def test_fifty_instants_agree_with_30_digits(name: str) -> None:
    expected = tabulated(name)
    assert len(expected) == COUNT
    motion = simulated(CASES[name], float(expected[-1].time) * (1 + 1e-9))
    found = [(time, list(events)) for time, events in groupby(motion.events, key=lambda event: event.time)]
    assert len(found) == COUNT
    for (time, events), instant in zip(found, expected, strict=True):
        assert instant.kind in [event.kind.value for event in events]
        with mpmath.workdps(30):
            assert abs(time / instant.time - 1) < 1e-14


def test_times_do_not_drift_over_thousands_of_events() -> None:
    """A friction-controlled load parts from the driven pin at each of its peaks; 4400 of them in 20 s."""
    drive = Drive(1.5e-3, 2 * math.pi * 110)
    motion = simulate(OpenLoop(control.tf([1.0], [1.0, 1.0]), FrictionBacklash(2e-4), drive), 20.0)
    times = np.array([event.time for event in motion.events if event.kind is EventKind.SEPARATION])
    assert len(times) == 4400
    with mpmath.workdps(30):
        peaks = [(k + 0.5) * mpmath.pi / mpmath.mpf(drive.omega) for k in range(len(times))]
        errors = np.array([float(time - peak) for time, peak in zip(times, peaks, strict=True)])
    assert abs(errors / np.spacing(times)).max() < 4


def test_cases_have_every_kind_of_event() -> None:
    assert {instant.kind for name in NAMES for instant in tabulated(name)} == {
        *("impact", "separation", "stick", "switch", "slip")
    }
