"""Curves over a map: the same whoever does the work, and where they meet."""

from __future__ import annotations

import os
import signal
import threading
import time
from pathlib import Path

import numpy as np
import pytest

from trimmer.branches.loci.locus import Locus, LocusEnd
from trimmer.branches.special import SpecialKind
from trimmer.maps.meetings import meetings
from trimmer.maps.motion_map import motion_map
from trimmer.maps.special_curve import SpecialCurve
from trimmer.maps.special_curves import special_curves
from trimmer.mechanism.mechanism import Mechanism
from trimmer.runners.processes import ProcessRunner
from trimmer.runners.runner import SerialRunner

EXAMPLES = Path(__file__).parents[3] / "examples"


def curve(
    values: list[tuple[float, float]], states: list[float], reason: LocusEnd = LocusEnd.LEFT
) -> SpecialCurve:
    """A curve of one side with one state."""
    count = len(values)
    return SpecialCurve(
        (
            Locus(
                SpecialKind.FOLD,
                (),
                ("frequency", "plays.bridge.gap"),
                1,
                np.array(values, dtype=float),
                np.array(states, dtype=float)[:, None],
                np.zeros(count),
                np.zeros(count),
                reason,
                "",
            ),
        )
    )


SPANS = np.array([10.0, 1.0])


def test_curves_that_cross_with_one_orbit_meet_and_with_two_orbits_do_not() -> None:
    rising = curve([(0.0, 0.0), (10.0, 1.0)], [1.0, 1.0])
    falling = curve([(0.0, 1.0), (4.0, 0.6), (10.0, 0.0)], [1.0, 1.0, 1.0])
    elsewhere = curve([(0.0, 0.8), (10.0, 0.1)], [-1.0, -1.0])
    (meeting,) = meetings([rising, elsewhere, falling], SPANS)
    assert meeting.curves == (0, 2)
    assert meeting.values == pytest.approx([5.0, 0.5])
    assert not meeting.ends
    assert meeting.distance == 0.0


def test_a_curve_that_was_lost_near_another_one_ends_there() -> None:
    whole = curve([(0.0, 0.5), (10.0, 0.5)], [1.0, 1.0])
    lost = curve([(5.0, 0.9), (5.0, 0.51)], [1.0, 1.0], LocusEnd.LOST)
    left = curve([(2.0, 0.9), (2.0, 0.51)], [1.0, 1.0])
    (meeting,) = meetings([whole, lost, left], SPANS)
    assert meeting.curves == (0, 1)
    assert meeting.ends
    assert meeting.values == pytest.approx([5.0, 0.51])
    assert meeting.distance == pytest.approx(0.01)


@pytest.mark.slow
def test_curves_do_not_depend_on_who_follows_them() -> None:
    mechanism = Mechanism.from_toml(EXAMPLES / "oscillator-stop.toml")
    result = motion_map(mechanism, {"frequency": [0.86, 0.8865], "stops.stop.gap": [9.9, 10.1]}, quiet=True)
    runners = (SerialRunner(), ProcessRunner(2, chunk=1))
    alone, shared = (special_curves(result, lines=2, runner=runner, quiet=True) for runner in runners)
    assert len(alone.curves) == len(shared.curves) == 2
    assert alone.searched == shared.searched
    for one, other in zip(alone.curves, shared.curves, strict=True):
        assert np.array_equal(one.values, other.values)
        assert np.array_equal(one.states, other.states)
    assert "come and go between two neighbouring orbits" in alone.searched


def sleep(_: int) -> None:
    time.sleep(60.0)


@pytest.mark.slow
def test_an_interrupt_does_not_wait_for_what_is_under_way() -> None:
    threading.Timer(1.0, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
    begun = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        list(ProcessRunner(2, chunk=1).results(sleep, range(2)))
    assert time.monotonic() - begun < 30.0
