"""What the numbers of a window say a motion is, on windows that are written down."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest

from trimmer import MotionKind
from trimmer.contact.advance import Ending
from trimmer.response.estimate import Estimate
from trimmer.response.verdict import Seen, cut_short, unsettled

ORBITING = np.exp(1j * np.sqrt(2) * np.arange(700))
ROUND = np.array([ORBITING.real, 3 * ORBITING.imag]).T


def seen(value: float, uncertainty: float, leaves: bool, states: np.ndarray = ROUND) -> Seen:
    """A motion of one body, with an exponent per drive period."""
    exponents = Estimate(value, uncertainty), Estimate(-0.7, 0.1)
    window = SimpleNamespace(exponents=exponents, states=states, periods=len(states))
    flow = SimpleNamespace(modes=SimpleNamespace(layout=SimpleNamespace(bodies=("one",))))
    return Seen(flow, window, leaves)


def test_distances_shrink_if_the_exponent_is_negative_by_three_errors_and_no_neighbour_leaves() -> None:
    assert seen(-0.31, 0.1, leaves=False).contracts
    assert not seen(-0.31, 0.1, leaves=True).contracts
    assert not seen(-0.29, 0.1, leaves=False).contracts
    assert not seen(-0.75, 0.25, leaves=False).contracts  # Equal to three errors, exactly.
    assert not seen(0.31, 0.1, leaves=False).contracts


KINDS = [
    (0.31, 0.1, True, MotionKind.CHAOTIC),
    (0.31, 0.1, False, MotionKind.UNDECIDED),
    (0.29, 0.1, True, MotionKind.UNDECIDED),
    (0.75, 0.25, True, MotionKind.UNDECIDED),
    (0.001, 0.01, False, MotionKind.TORUS),
    (3 * 2.0**-10, 2.0**-10, False, MotionKind.TORUS),
    (-3 * 2.0**-10, 2.0**-10, False, MotionKind.TORUS),
    (-0.001, 0.01, False, MotionKind.TORUS),
    (-0.001, 0.01, True, MotionKind.UNDECIDED),
    (0.021, 0.01, False, MotionKind.UNDECIDED),
    (-0.021, 0.01, False, MotionKind.UNDECIDED),
    (-0.019, 0.01, False, MotionKind.TORUS),
    (-0.031, 0.01, False, MotionKind.UNDECIDED),
    (-0.011, 0.001, False, MotionKind.UNDECIDED),
    (-0.125, 0.0625, False, MotionKind.UNDECIDED),
]


@pytest.mark.parametrize(("value", "uncertainty", "leaves", "kind"), KINDS)
def test_the_kind_is_what_exponent_and_neighbour_say(
    value: float, uncertainty: float, leaves: bool, kind: MotionKind
) -> None:
    assert seen(value, uncertainty, leaves).kind is kind


def test_a_motion_that_swings_wider_and_wider_is_no_torus() -> None:
    for share, steady in ((1.09, True), (1.13, False), (0.91, True), (0.87, False)):
        states = ROUND.copy()
        states[350:, 1] *= share
        found = seen(0.0, 0.01, False, states)
        assert found.steady is steady
        assert (found.kind is MotionKind.TORUS) is steady
    # A tenth is one of the wider swing.
    ramp = np.concatenate([np.linspace(0.0, 1.0, 50), np.linspace(0.0, 1.105, 50)])[:, None]
    for states in (ramp, ramp[::-1]):
        assert seen(0.0, 0.01, False, states).steady
        assert not seen(0.0, 0.01, False, states**2).steady
    still = np.zeros((100, 2))
    assert seen(0.0, 0.01, False, still).steady


def test_only_displacements_need_to_be_orderly() -> None:
    walk = np.random.default_rng(1).normal(size=700)
    assert seen(0.0, 0.01, False, np.array([ORBITING.real, walk]).T).orderly
    wild = seen(0.0, 0.01, False, np.array([walk, ORBITING.real]).T)
    assert not wild.orderly
    assert wild.kind is MotionKind.UNDECIDED


def test_what_has_not_settled_was_followed_for_the_wait_and_the_window() -> None:
    watched = seen(0.31, 0.1, True)
    for agrees in (None, True, False):
        motion = unsettled(watched, 70, agrees)
        assert motion.kind is MotionKind.CHAOTIC
        assert motion.orbit is None
        assert motion.window is watched.window
        assert motion.drive_periods == 770
        assert motion.neighbour_agrees is agrees
        assert (motion.starts, motion.share, motion.mirrored) == (1, 1.0, False)
        assert "after 70 drive periods, and over 700 more" in motion.message
        assert ("A neighbouring start" in motion.message) is (agrees is not None)
        assert ("does not settle either" in motion.message) is (agrees is True)
        assert "leaves it" in motion.message
    assert "stays near it" in unsettled(seen(0.0, 0.01, False), 70, None).message


def test_what_could_not_be_followed_is_undecided() -> None:
    motion = cut_short(SimpleNamespace(periods=12, ending=Ending.STEP_LIMIT, grows=False), True)
    assert motion.kind is MotionKind.UNDECIDED
    assert (motion.orbit, motion.window) == (None, None)
    assert (motion.drive_periods, motion.neighbour_agrees) == (12, True)
    assert (motion.starts, motion.share, motion.mirrored) == (1, 1.0, False)
    assert motion.message == f"It could be followed for 12 drive periods only: {Ending.STEP_LIMIT.value}."
    grown = cut_short(SimpleNamespace(periods=12, ending=Ending.DIVERGED, grows=False), True)
    assert (grown.kind, grown.orbit) == (MotionKind.DIVERGING, None)
