"""What a branch tells of its orbits: outputs, harmonics, balance, words and tables."""

import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from tests.trimmer import results
from tests.trimmer.maps.machines import impact_oscillator, linear_oscillator
from trimmer import FollowSettings, Force, Mechanism, SpecialKind, follow

EXAMPLES = Path(__file__).parents[3] / "examples"
FEW = FollowSettings(most_points=2, quiet=True)
RESPONSE = 100.0 / (40.0 - 7.5**2 + 0.1j * math.sqrt(40.0) * 7.5)


@pytest.mark.parametrize("periods", [1, 3])
def test_a_linear_motion_has_one_harmonic(periods: int) -> None:
    pushed = replace(linear_oscillator(), forces={"push": Force("mass", constant=80.0, amplitude=100.0)})
    orbit = follow(
        pushed, "links.spring.damping", "0.632455532 N s/m", 0.7, periods=periods, settings=FEW
    ).points[0]
    measure = orbit.outputs["x"]
    assert measure.peak_to_peak == pytest.approx(2.0 * abs(RESPONSE), rel=1e-9)
    assert measure.harmonics[0] == pytest.approx(abs(RESPONSE), rel=1e-9)
    assert abs(measure.harmonics[1:]).max() < 1e-10 * abs(RESPONSE)
    assert (len(measure.harmonics), measure.advance) == (15, 0.0)
    # The force pushes with sin; at t = 0 its displacement is 2 m beside the wave.
    assert orbit.state == pytest.approx([2.0 + RESPONSE.imag, 7.5 * RESPONSE.real], rel=1e-9)
    balanced = orbit.balanced(2)
    assert balanced.converged
    assert balanced.distance < 1e-7


def test_balance_is_nearer_the_more_harmonics_there_are_and_lacks_those_beyond() -> None:
    orbit = results.branch().points[0]
    powers = orbit.outputs["x"].harmonics ** 2
    distances = []
    for count in (1, 4, 12):
        balanced = orbit.balanced(count)
        assert balanced.converged
        beyond = math.sqrt(powers[count:].sum() / powers.sum())
        assert balanced.distance >= beyond * (1.0 - 1e-3)
        distances.append(balanced.distance)
    assert distances[2] < 0.1 * distances[1] < 0.05 * distances[0]


def test_outputs_of_a_motion_without_a_drive_have_its_own_harmonics() -> None:
    """Block on a belt of 0.2 m/s: it slips from x = 1 with 0.5 N of friction, and rides back."""
    belt = Mechanism.from_toml(EXAMPLES / "block-on-belt.toml")
    orbit = follow(belt, "pins.belt.velocity", 0.2, 0.3, settings=FEW).points[0]
    slip = 2.0 * (math.pi - math.atan(0.5 / 0.2))
    period = slip + 1.0 / 0.2
    times = period * (np.arange(400_000) + 0.5) / 400_000
    block = np.where(
        times < slip, 0.5 + 0.5 * np.cos(times) + 0.2 * np.sin(times), 1.0 - 0.2 * (period - times)
    )
    wanted = 2.0 * abs(np.fft.fft(block)[1:16]) / len(times)
    measure = orbit.outputs["block"]
    assert measure.harmonics == pytest.approx(wanted, rel=1e-6, abs=1e-9)
    assert measure.peak_to_peak == pytest.approx(np.ptp(block), rel=1e-7)
    assert orbit.period == pytest.approx(period, rel=1e-11)
    assert (orbit.largest_multiplier, abs(orbit.multipliers).max()) == pytest.approx((0.0, 1.0), abs=1e-9)


def test_a_branch_tells_its_orbits() -> None:
    branch = results.branch()
    orbit = branch.points[3]
    frame = branch.to_dataframe()
    assert frame.iloc[3].to_dict() == pytest.approx(
        {
            "branch": 0,
            "value": orbit.value,
            "stable": orbit.stable,
            "period": 1.0 / orbit.value,
            "period_count": 1,
            "largest_multiplier": max(abs(orbit.multipliers)),
            "events_per_period": orbit.events_per_period,
            "outputs.x.peak_to_peak": orbit.outputs["x"].peak_to_peak,
        }
    )
    units = frame.attrs["units"]
    assert (units["value"], units["period"], units["outputs.x.peak_to_peak"]) == ("Hz", "s", "m")
    assert branch.unit == "Hz"
    assert f"frequency = {orbit.value:.9g}, stable, 1 drive period" in repr(orbit)
    unstable = next(each for each in branch.points if not each.stable)
    assert "not stable" in repr(unstable)
    assert "m peak to peak, 15 harmonics" in repr(orbit.outputs["x"])
    assert f"over frequency, {len(branch.points)} orbits, {len(branch.special)} special point" in repr(branch)
    assert f"neighbours of {len(branch.points)} orbits" in branch.searched
    assert "fold at " in repr(branch.special[0])


def test_a_branch_tells_those_that_part_from_it() -> None:
    branch = results.branch()
    inner = replace(branch, branches=())
    outer = replace(branch, branches=(replace(branch, branches=(inner,)), inner))
    assert "more branch" not in repr(branch)
    assert "one more branch;" in repr(replace(branch, branches=(inner,)))
    assert "3 more branches" in repr(outer)
    assert list(outer.all())[1:] == [outer.branches[0], inner, inner]
    assert sorted(set(outer.to_dataframe()["branch"])) == [0, 1, 2, 3]
    assert len(outer.to_dataframe()) == 4 * len(branch.points)


def test_outputs_at_a_special_point_lie_between_those_of_its_neighbours() -> None:
    branch = results.branch()
    (fold,) = branch.special
    assert fold.kind is SpecialKind.FOLD
    after = next(number for number, each in enumerate(branch.points) if not each.stable)
    strokes = [branch.points[at].outputs["x"].peak_to_peak for at in (after - 1, after)]
    assert min(strokes) < branch.outputs_at(fold)["x"].peak_to_peak < max(strokes)


def test_events_are_counted_for_each_drive_period() -> None:
    """A period of six drive periods, of which some have contact."""
    mechanism = impact_oscillator().with_value("frequency", 0.9)
    orbit = follow(mechanism, "frequency", 0.9, 0.901, settings=FEW).points[0]
    assert orbit.periods == 6
    assert orbit.events_per_period == pytest.approx(len(orbit.passage.course.events) / 6, rel=1e-15)
    assert orbit.period == pytest.approx(6 / 0.9, rel=1e-14)
