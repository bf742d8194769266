"""What commands tell of mechanisms, of results that are made by hand: each row, and what is left out."""

from __future__ import annotations

from types import SimpleNamespace as Made

import numpy as np

from tests.trimmer.command_line.told import cells
from trimmer.branches.special import SpecialKind
from trimmer.command_line.mechanisms import (
    follow_text,
    map_text,
    respond_text,
    sample_text,
)
from trimmer.command_line.mechanisms import motion_text as of_mechanism
from trimmer.response.estimate import Estimate
from trimmer.uncertainty.statistics import Quantile, Share


def test_energy_of_a_mechanism_is_told_term_by_term() -> None:
    energy = Made(
        kinetic=(1.0, 3.0),
        stored=(0.5, 7.0),
        pins={"pin": 10.0},
        forces={"push": 2.0},
        dampers={"oil": 1.5},
        contacts={"wall": 0.25},
        frictions={"blade": 1.75},
        residual=3e-16,
        undetermined=(),
    )
    lines = of_mechanism._energy_text(energy)
    rows = dict(row for row in cells(lines[2:-1]) if len(row) == 2)
    assert rows == {
        "work of pin": "10",
        "work of push": "2",
        "lost in damper oil": "1.5",
        "lost in contact wall": "0.25",
        "lost in friction blade": "1.75",
        "gained by bodies and springs": "8.5",
    }
    assert "less than 1e-12" in lines[-1]


def test_bodies_stand_in_for_outputs() -> None:
    motion = Made(
        mechanism=Made(outputs={}, bodies=["a", "b"]),
        displacement=lambda name, times: times + ["a", "b"].index(name),
        output=lambda name, times: -times,
    )
    shown = of_mechanism.displacements(motion, np.array([1.0]))
    assert {name: each.tolist() for name, each in shown.items()} == {"a": [1.0], "b": [2.0]}
    motion.mechanism.outputs = {"x": 1}
    assert of_mechanism.displacements(motion, np.array([1.0]))["x"].tolist() == [-1.0]


def settled(lines: list[tuple[int, int, float]] | None, periods: int = 1) -> Made:
    """A motion that repeats, with its lines p/k; without them one that does not."""
    measures = Made(outputs={"x": Made(lines=lines)}, contacts={}, frictions={})
    orbit = Made(measures=measures, periods=periods, nontrivial_multipliers=np.array([0.25, -0.5]))
    return Made(
        orbit=orbit if lines is not None else None,
        window=None if lines is not None else 1,
        rest=None,
        linear=None,
        harmonics={"x": np.array([3.0, 0.0, 1.0])},
        peak_to_peak={"x": 5.0},
        rms={"x": Estimate(2.0, 0.0)},
        rms_acceleration={"body": Estimate(7.0, 0.5)},
        events_per_period=2.5,
        message="It settles.",
        share=0.25,
        mirrored=False,
    )


def test_the_largest_lines_are_told_in_order_of_frequency() -> None:
    lines = [(6, 2, 1.0), (1, 2, 8.0), (3, 2, 7.0), (2, 2, 6.0), (5, 2, 5.0), (4, 2, 4.0), (7, 2, 3.0)]
    told = respond_text._lines(settled([*lines, (8, 2, 1e-9)]), "x")
    assert told == "1/2: 8, 1: 6, 3/2: 7, 2: 4, 5/2: 5, 7/2: 3"
    assert respond_text._lines(settled([(1, 1, 1.0), (2, 1, 1e-9), (3, 1, 2e-9)]), "x") == "1: 1, 3: 2e-09"
    assert respond_text._lines(settled([]), "x") == "none"
    assert respond_text._lines(settled(None), "x") == "1: 3, 3: 1"


def test_parts_are_told_if_there_are_some() -> None:
    contact = Made(impacts=2.0, impact_speed=0.5, largest_force=3.0, share=0.125)
    friction = Made(work=1e-3, power=0.25, stick=0.5)
    lines = list(respond_text._parts(Made(contacts={"wall": contact}, frictions={"blade": friction})))
    assert cells(lines)[1] == ["wall", "2", "0.5", "3", "12.50%"]
    assert cells(lines)[3] == ["blade", "0.001", "0.25", "50.00%"]
    assert list(respond_text._parts(Made(contacts={}, frictions={}))) == []


def made_branch(**changes: object) -> Made:
    mechanism = Made(frequency=60.0, outputs={"x": 1})
    points = [
        Made(value=value, period=period, stable=stable, outputs={"x": Made(peak_to_peak=size)})
        for value, period, stable, size in (
            (1.0, 0.5, True, 4.0),
            (2.0, 0.75, True, 3.0),
            (3.0, 0.25, False, 9.0),
        )
    ]
    for point, (distance, converged) in zip(points, ((0.5, True), (0.25, True), (9.0, False)), strict=True):
        point.balanced = lambda _, d=distance, c=converged: Made(distance=d, converged=c)
    return Made(
        **{
            "map": Made(place="frequency", mechanism=mechanism),
            "unit": "Hz",
            "parted": None,
            "special": [],
            "points": points,
            "periods": 1,
            "searched": "all",
            "message": "over",
            "branches": [],
        }
        | changes
    )


def test_a_branch_is_told_by_stretches_of_stability() -> None:
    special = Made(kind=SpecialKind.FOLD, value=2.5, note="it turns")
    parted = made_branch(parted=special, periods=2, points=made_branch().points[:1])
    lines = follow_text.as_text(made_branch(special=[special], branches=[parted]), 5).splitlines()
    assert lines[0] == "Periodic motions over frequency (Hz): 3 orbits with the drive's period"
    assert cells(lines[1:4]) == [
        ["from", "to", "orbits", "stable", "x, peak to peak, m"],
        ["1", "2", "2", "yes", "3 to 4"],
        ["3", "3", "1", "no", "9 to 9"],
    ]
    assert cells(lines[6:7]) == [["fold", "2.5", "it turns"]]
    assert lines[7].endswith("5 harmonics: 2 of 3 points, off by 0.25 to 0.5 (rms, relative)")
    assert lines[8:10] == ["Searched: all", "End: over"]
    assert lines[10] == "    From fold at 2.5 over frequency (Hz): 1 orbit with 2 drive periods"
    assert lines[-1] == "    End: over"
    plain = follow_text.as_text(made_branch(points=[]), None)
    assert "Special" not in plain and "balance" not in plain and "Searched" not in plain


def test_what_moves_by_itself_tells_its_period() -> None:
    branch = made_branch()
    branch.map.mechanism.frequency = None
    assert follow_text._many(branch) == "3 orbits with a period of their own"
    branch.periods = 2
    assert follow_text._many(branch).endswith("which has doubled")
    assert follow_text._heads(branch) == ["period, s", "x, peak to peak, m"]
    assert follow_text._stretches(branch)[0] == ("1", "2", "2", "yes", "0.5 to 0.75", "3 to 4")


def test_harmonic_balance_that_converges_nowhere_is_told() -> None:
    branch = made_branch(points=made_branch().points[2:])
    assert follow_text._balance(branch, 3).endswith("converged at no point")


def test_meetings_of_curves_are_told() -> None:
    side = Made(places=("a", "b"), message="it leaves")
    curves = [
        Made(name="fold", periods=1, values=[0, 1], ends=[side], sides=[side]),
        Made(name="grazing", periods=3, values=[0], ends=[], sides=[side]),
    ]
    meeting = Made(curves=(0, 1), values=np.array([1.5, 2.5]), ends=False)
    special = Made(curves=curves, meetings=[meeting, Made(**{**vars(meeting), "ends": True})], searched="all")
    lines = map_text._curves(special)
    assert lines[:3] == ["fold: 2 points", "  it leaves", "grazing, of motions of 3 drive periods: 1 points"]
    assert lines[3] == "fold crosses grazing, near a = 1.5 and b = 2.5"
    assert "meets grazing, where one of them ends" in lines[4]
    assert map_text._rows(np.array([[1.0, np.nan], [np.inf, 2.0]])) == [[1.0, None], [None, 2.0]]


def test_shares_and_quantiles_have_their_intervals() -> None:
    assert sample_text.share_text(Share(1, 8, 0.02, 0.5)) == "12.5% of 8 (2.0% to 50.0%)"
    assert sample_text.quantile_text(Quantile(0.5, 2.0, 1.0, 3.5)) == "2 [1, 3.5]"
    assert sample_text.distribution_data(None) == {
        "count": 0,
        "mean": None,
        "deviation": None,
        "quantiles": [],
    }
    index = Made(place="gap", first=0.5, first_error=0.01, total=0.75, total_error=np.nan)
    assert sample_text.index_data(index)["total_error"] is None
    lines = list(sample_text.index_lines(Made(indices=[index] * 9, message="so")))
    assert len(lines) == 1 + 8 + 1
    assert cells(lines)[1] == ["gap", "0.500 +- 0.010", "0.750 +- nan"]
    assert list(sample_text.index_lines(Made(indices=[], message="so"))) == ["  so"]


def test_harmonic_balance_of_samples_is_told() -> None:
    distances = np.array([0.5, 0.125, 0.25])
    balanced = Made(numbers=(1, 2, 3), harmonics=7, distances=distances, converged=np.array([1, 0, 1], bool))
    (line,) = sample_text._balanced_lines(balanced)
    assert "7 harmonics, of 3 samples: 2 balance" in line
    assert line.endswith("0.25 in the middle, 0.5 at most")
    (line,) = sample_text._balanced_lines(Made(numbers=()))
    assert "no sample repeats" in line


def test_the_yield_is_told_of_all_targets_and_of_each() -> None:
    def trial(*met: str) -> Made:
        return Made(meets=lambda targets: all(each.key in met for each in targets))

    targets = [Made(key="stroke", part="x"), Made(key="period", part="")]
    trials = [trial("stroke", "period"), trial("stroke"), trial("stroke"), trial()]
    samples = Made(targets=targets, trials=trials, met=np.array([1, 0, 0, 0], bool))
    first, *each, last = sample_text._yield_lines(samples)
    assert "25.0% of 4" in first
    assert each[0].startswith("  stroke x: 75.0% of 4") and each[1].startswith("  period: 25.0% of 4")
    assert last == ""
    samples.targets = targets[:1]
    assert len(list(sample_text._yield_lines(samples))) == 2
    samples.targets = []
    assert "no targets" in next(sample_text._yield_lines(samples))
