"""The thesis's loop over friction and gap: what is not so would be noticed."""

from dataclasses import replace

import pytest

from report.numbers.independent.loop_with_friction import largest_friction
from report.numbers.twin.kept_branch import KeptSpecial
from report.twin.observation import UnsupportedObservationError
from report.twin.sections.loop import balance, over_force, over_gap

STICK = KeptSpecial("stick", 0.1, "")


def with_loop(evidence, **changes):
    loop = replace(evidence.twin.loop, **changes)
    return replace(evidence, twin=replace(evidence.twin, loop=loop))


def test_the_second_way_is_most_at_the_fold_and_falls_on_both_sides(evidence):
    parameters, largest = evidence.numbers.parameters, evidence.twin.loop.largest
    for low, high in ((720.0, 725.0), (680.0, 690.0)):
        assert largest_friction(parameters, low, high).force_per_gap < largest.force_per_gap


def test_the_second_way_goes_to_the_exact_orbit_without_friction(evidence):
    exact = evidence.orbits.friction.stable
    found = largest_friction(evidence.numbers.parameters, exact.frequency - 1e-5, exact.frequency)
    assert found.amplitude == pytest.approx(exact.amplitude, rel=1e-5)
    assert abs(found.force_per_gap) < 1e-3 * evidence.twin.loop.largest.force_per_gap


@pytest.mark.parametrize(
    ("record", "changes"),
    [
        (over_force, lambda loop: {"left_above": loop.left_below}),
        (over_force, lambda loop: {"largest": replace(loop.largest, force_per_gap=8097.5)}),
        (over_force, lambda loop: {"over_force": replace(loop.over_force, stable=~loop.over_force.stable)}),
        (over_force, lambda loop: {"miss": 1e-6}),
        (over_gap, lambda loop: {"over_gap": loop.over_gap[::-1]}),
        (balance, lambda loop: {"events": frozenset({(("impact", 2), ("stick", 2))})}),
        (
            balance,
            lambda loop: {"over_force": replace(loop.over_force, special=(*loop.over_force.special, STICK))},
        ),
    ],
)
def test_a_sentence_that_does_not_hold_stops_the_report(record, changes, evidence):
    known = with_loop(evidence, **changes(evidence.twin.loop))
    with pytest.raises(UnsupportedObservationError):
        record.finished(known)
