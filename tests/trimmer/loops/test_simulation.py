"""Event times against 30 digits, in closed loop and driven, with play, friction and stick."""

from __future__ import annotations

import math
from itertools import groupby

import control
import mpmath
import numpy as np
import pytest

from tests.quick import quick
from tests.trimmer.loops.reference.exact_cases import CASES, COUNT, computed, simulated, tabulated
from trimmer import Drive, FrictionBacklash, OpenLoop, simulate
from trimmer.loops import EventKind

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


@pytest.mark.parametrize("name", quick(NAMES, NAMES.index("driven, two frictions")))
def test_table_is_what_its_script_computes(name: str) -> None:
    some = 2
    for instant, written in zip(computed(CASES[name], some), tabulated(name)[:some], strict=True):
        assert instant.kind == written.kind
        with mpmath.workdps(30):
            assert abs(instant.time / written.time - 1) < 1e-25


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
