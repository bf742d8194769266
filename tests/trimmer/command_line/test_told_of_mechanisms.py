"""What commands tell of mechanisms, of results that are made by hand: each row, and what is left out."""

from __future__ import annotations

import json
from types import SimpleNamespace as Made

import numpy as np
import pytest

from tests.trimmer.command_line.told import cells, point_of_branch
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


def test_a_motion_is_told_with_what_it_repeats_in() -> None:
    lines = list(respond_text._motion(settled([(1, 1, 2.0)])))
    assert lines[0] == "  2.5 events per drive period; largest multiplier 0.5"
    assert "p/k of the drive" in lines[1]
    assert cells(lines[2:3]) == [["x", "5", "2", "1: 2"]]
    assert cells(lines[4:5]) == [["body", "7 (95 %: 6.02002 to 7.97998)"]]
    assert len(lines) == 5
    free = list(respond_text._motion(settled([(1, 1, 2.0)], periods=0)))
    assert "per period;" in free[0]
    assert "multiples of its own frequency" in free[1]
    restless = list(respond_text._motion(settled(None)))
    assert "window" in restless[0]
    assert "p/k of the drive" in restless[1]
    nothing = settled(None)
    nothing.window = None
    assert list(respond_text._motion(nothing)) == []


def test_parts_are_told_if_there_are_some() -> None:
    contact = Made(impacts=2.0, impact_speed=0.5, largest_force=3.0, share=0.125)
    friction = Made(work=1e-3, power=0.25, stick=0.5)
    lines = list(respond_text._parts(Made(contacts={"wall": contact}, frictions={"blade": friction})))
    assert cells(lines)[1] == ["wall", "2", "0.5", "3", "12.50%"]
    assert cells(lines)[3] == ["blade", "0.001", "0.25", "50.00%"]
    assert list(respond_text._parts(Made(contacts={}, frictions={}))) == []


def test_motions_of_several_starts_are_numbered() -> None:
    first, second = settled([(1, 1, 2.0)]), settled([(1, 1, 3.0)])
    second.message, second.mirrored = "Another.", True
    response = Made(message="First.", motions=[first, second], starts=4, seed=5, box={"a": (1e-3, 0.25)})
    lines = respond_text.as_text(response).splitlines()
    assert lines[:3] == ["First.", "", "Motion 1, 25% of the starts"]
    at = lines.index("Motion 2, 25% of the starts, the mirror image of one before")
    assert lines[at - 1 : at + 2] == ["", lines[at], "Another."]
    assert lines.count("First.") == 1
    assert lines[-2:] == [
        "",
        "Random starts lie within a 0.001 m and 0.25 m/s on either side of rest (seed 5).",
    ]
    alone = Made(message="First.", motions=[first], starts=1)
    assert "Motion" not in respond_text.as_text(alone)
    assert "Random" not in respond_text.as_text(alone)


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


def test_a_map_tells_coexistence_and_its_first_failures() -> None:
    motions = [Made(kind=Made(word="w"))]
    failures = {(row, column): f"reason {row}{column}" for row in range(2) for column in range(3)}
    result = Made(
        inputs=Made(
            mechanism=Made(title="", places={"a": "m", "b": "N"}),
            cell_values=lambda number: (number * 1.0, number * 10.0),
        ),
        cells=[Made(motions=motions)] * 6,
        shape=(2, 3),
        places=("a", "b"),
        values=((1.0, 2.0, 3.0), (10.0, 20.0)),
        motion_count=np.array([[1, 2, 2], [1, 1, 3]]),
        failures=failures,
        peak_to_peak={"x": np.array([[1.0, np.nan, 4.0]])},
        impacts=np.full((2, 3), np.nan),
        impact_speed=np.array([[0.5, 0.5, 0.5]]),
        rms_acceleration={},
        wear_power={"f": np.array([[1.0, 2.0, 6.0]])},
    )
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(map_text, "described", lambda motion: motion.kind.word)
        lines = map_text.as_text(result, "all").splitlines()
    assert lines[1:3] == ["  a from 1 to 3 m, 3 values", "  b from 10 to 20 N, 2 values"]
    assert ["w", "6", "100.0%"] in cells(lines)
    ranges = [row for row in cells(lines) if row[-1] in ("m", "m/s", "W")]
    assert ranges == [
        ["x, peak to peak", "1", "2.5", "4", "m"],
        ["largest impact speed", "0.5", "0.5", "0.5", "m/s"],
        ["f, wear power", "1", "2", "6", "W"],
    ]
    assert "several motions coexist in 3 cells" in lines
    failed = [line for line in lines if line.startswith("failed")]
    assert len(failed) == 5
    assert failed[4] == "failed at a = 4, b = 40: reason 11"
    assert lines[-2:] == ["and 1 more failed, which --json lists", "searched: all"]


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


def test_multipliers_are_pairs_in_json() -> None:
    content = json.loads(json.dumps(follow_text._point(point_of_branch(), None)))
    assert content["multipliers"] == [[0.5, -0.25]]
    assert content["outputs"] == {"x": {"peak_to_peak": 4.0, "harmonics": [2.0, 1.0]}}
    assert content["balance"] is None
    assert follow_text._point(point_of_branch(), 3)["balance"] == {"distance": 3.0, "converged": True}
