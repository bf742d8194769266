"""No result depends on where time begins: branches under shifted phases of all drives."""

import math
from typing import Any

import numpy as np
import pytest

from tests.mechanisms.shifted_phases import differences_of_branches, shifted, state_at
from tests.quick import quick
from tests.trimmer.branches.bouncing_ball import ball, damping, fold, resting, thrown
from tests.trimmer.maps.machines import impact_oscillator
from trimmer import ContactLaw, FollowSettings, Mechanism, SpecialKind, follow, follow_special, forced_orbit
from trimmer.branches import LocusRanges, LocusSettings

QUIET, LOCUS = FollowSettings(quiet=True, largest_step=0.05), LocusSettings(quiet=True)
ALONE = FollowSettings(quiet=True, switches=0, largest_step=0.1)


@pytest.mark.parametrize(("stiffness", "phase"), quick([(1e6, 3.0), (1e8, 0.0)], 0))
def test_a_fold_is_passed_wherever_the_ball_meets_the_table(stiffness: float, phase: float) -> None:
    """At the fold the ball meets the table where that is fastest: at t = 0, if the phase is 0."""
    found = follow(
        ball(stiffness, phase), "pins.table.amplitude", 0.6, 0.3, state=thrown(phase), settings=QUIET
    )
    (point,) = found.special
    assert point.kind is SpecialKind.FOLD
    assert point.value == pytest.approx(fold(stiffness), rel=1e-9)
    assert found.success
    assert found.points[0].stable
    assert not found.points[-1].stable
    # States are those at t = 0, wherever the orbits of the branch begin.
    for orbit in found.points[::5]:
        flow = found.map.flow(orbit.value)
        end = flow.course(flow.at(orbit.state), 1).end
        assert np.allclose(end.state, orbit.state, rtol=1e-6, atol=1e-7)


@pytest.mark.parametrize(
    ("law", "phase"),
    quick([(ContactLaw.PULLING, 0.0), (ContactLaw.TRUNCATED, 3.0), (ContactLaw.RELAXING, 0.0)], 1),
)
def test_a_ball_at_rest_on_the_table_lifts_off(law: ContactLaw, phase: float) -> None:
    """The force, g + A |k + i c| / |k - 1 + i c| cos, falls to zero; where it may pull, r does."""
    stiffness = 1e6
    rate = 1j * damping(stiffness)
    pressing = stiffness if law is ContactLaw.PULLING else stiffness + rate
    wanted = abs(stiffness - 1.0 + rate) / abs(pressing)
    begin = resting(stiffness, phase, 0.97)
    found = follow(
        ball(stiffness, phase, 0.97, law),
        "pins.table.amplitude",
        0.97,
        1.000009,
        state=[*begin, *([math.sin(phase) * 0.97 - begin[0]] if law is ContactLaw.RELAXING else [])],
        settings=ALONE,
    )
    assert found.success
    first = found.special[0]
    assert (first.kind, first.parts) == (SpecialKind.GRAZING, ("contact",))
    assert first.note == "contact: contact on the upper side, +1, where it lifts off for a moment"
    # Rounding of a displacement of about 1 m changes the force by some 1e6 N/m times 1e-16 m.
    assert first.value == pytest.approx(wanted, abs=1e-9)
    assert found.points[0].events_per_period == 0
    assert found.points[-1].events_per_period > 0


@pytest.mark.parametrize("law", quick(ContactLaw, 0))
def test_a_phase_over_a_whole_turn_changes_nothing(law: ContactLaw) -> None:
    """All that happens in a period comes to t = 0 in turn."""
    machine = ball(1e6, 0.5, law=law)
    begin = thrown(0.5) + [0.0] * (law is ContactLaw.RELAXING)
    found = follow(machine, "pins.table.phase", 0.5, 0.5 + 2.0 * math.pi, state=begin, settings=QUIET)
    assert (found.success, found.special) == (True, ())
    multipliers = np.array([point.multipliers for point in found.points])
    assert np.allclose(multipliers, multipliers[0], atol=1e-7)
    assert {point.events_per_period for point in found.points} == {found.points[0].events_per_period}
    assert np.allclose(found.points[-1].state, found.points[0].state, atol=1e-7)


@pytest.mark.slow
@pytest.mark.parametrize("phase", [0.0, 3.0])
def test_a_locus_over_the_phase_is_straight(phase: float) -> None:
    machine = ball(1e6, phase)
    branch = follow(machine, "pins.table.amplitude", 0.6, 0.4, state=thrown(phase), settings=QUIET)
    ranges = LocusRanges((0.3, 0.6), (phase - 0.1, phase + 2.0 * math.pi))
    locus = follow_special(
        branch, branch.special[0], "pins.table.phase", ranges.second[1], ranges=ranges, settings=LOCUS
    )
    assert locus.success
    assert locus.second[-1] == pytest.approx(ranges.second[1], rel=1e-12)
    assert locus.first == pytest.approx(np.full(len(locus.first), fold(1e6)), rel=1e-9)
    assert np.ptp(locus.first) < 1e-11
    assert locus.residual.max() < 1e-11
    assert locus.distance.max() < 1e-6


def compared(
    mechanism: Mechanism, place: str, interval: tuple[float, float], share: float, begin: Any
) -> Any:
    """Return the special points of a branch, and what differs under a clock that begins later."""
    first = mechanism.with_value(place, interval[0])
    orbit = forced_orbit(first, guess=begin)
    states = orbit.instant.state, state_at(first, share, orbit.instant.state)
    ours, theirs = (
        follow(each, place, *interval, state=state, settings=ALONE)
        for each, state in zip((first, shifted(first, share)), states, strict=True)
    )
    return {each.kind for each in ours.special}, list(differences_of_branches(ours, theirs))


@pytest.mark.slow
@pytest.mark.parametrize("share", [0.13, pytest.param(0.5, marks=pytest.mark.slow)])
def test_folds_grazings_and_period_doublings_are_the_same_under_a_later_clock(share: float) -> None:
    kinds, different = compared(impact_oscillator(), "frequency", (1.0, 1.5), share, None)
    assert (kinds, different) == ({SpecialKind.FOLD, SpecialKind.GRAZING}, [])
    kinds, different = compared(ball(1e4, 0.0), "pins.table.amplitude", (0.6, 1.13), share, thrown(0.0))
    assert (kinds, different) == ({SpecialKind.PERIOD_DOUBLING}, [])


@pytest.mark.slow
@pytest.mark.parametrize("share", [0.13, 0.5, 0.77])
def test_stick_tori_and_lost_symmetry_are_the_same_under_a_later_clock(share: float) -> None:
    trimmer = Mechanism.from_toml("examples/thesis-play.toml")
    kinds, different = compared(trimmer, "plays.bridge.gap", (4e-5, 1.2e-4), share, None)
    assert kinds == {SpecialKind.STICK, SpecialKind.TORUS, SpecialKind.SYMMETRY_BREAKING}
    assert different == []
