"""What commands tell of results that are made by hand: each row, each number, and what is left out."""

from __future__ import annotations

import json
from types import SimpleNamespace as Made

import numpy as np
import pytest

from trimmer.branches.special import SpecialKind
from trimmer.command_line import json_values, motion_summary
from trimmer.command_line.loops import certificate_text, limit_cycles_text, linear_text, orbits_text
from trimmer.command_line.loops import motion_text as of_loop
from trimmer.command_line.mechanisms import (
    follow_text,
    map_text,
    respond_text,
    sample_text,
)
from trimmer.command_line.mechanisms import motion_text as of_mechanism
from trimmer.command_line.signals import fit_text, recording_text
from trimmer.command_line.table import table
from trimmer.motion.switched_component import EventKind
from trimmer.response.estimate import Estimate
from trimmer.uncertainty.statistics import Quantile, Share


def cells(lines: list[str] | str) -> list[list[str]]:
    """The cells of the lines of a table, which are two blanks apart."""
    text = lines if isinstance(lines, str) else "\n".join(lines)
    return [[cell.strip() for cell in line.split("  ") if cell.strip()] for line in text.splitlines()]


def test_columns_are_as_wide_as_their_widest_cell() -> None:
    assert table(("a", "bcd"), [("long", "x"), ("", "y")]) == ["  a     bcd", "  long  x", "        y"]
    assert table(("a",), []) == ["  none"]


def test_numbers_that_json_lacks_are_null() -> None:
    assert [json_values.finite(value) for value in (2.0, np.inf, np.nan)] == [2.0, None, None]
    assert json_values.pair(2 - 3j) == (2.0, -3.0)


def test_a_motion_is_summed_up() -> None:
    lines = motion_summary.summary_lines(0.25, "done", [("b", "x"), ("a", "y"), ("b", "x")])
    assert lines[0] == "Motion of 0.25 s: done"
    assert lines[1:3] == ["  a: 1 x y", "  b: 2 x x"]
    assert len(motion_summary.summary_lines(0.25, "done", [])) == 3
    assert "no event" in motion_summary.summary_lines(0.25, "done", [])[1]
    times = motion_summary.last_times(0.5)
    assert (times.size, times[0], times[-1]) == (20_001, pytest.approx(0.45), 0.5)
    np.testing.assert_allclose(np.diff(times), 0.05 / 20_000)
    assert motion_summary.amplitudes({"a": np.array([1.0, -3.0, 0.0])}) == {"a": 2.0}


def moved(times: list[float], modes: list[str], drive: object = None) -> Made:
    events = [
        Made(time=time, kind=EventKind.IMPACT, mode=mode, component="play")
        for time, mode in zip(times, modes, strict=True)
    ]
    loop = Made(modes=Made(system=Made(drive=drive)))
    return Made(duration=1.0, events=events, loop=loop)


def test_what_repeats_at_the_end_is_told() -> None:
    upper = "upper contact"
    assert of_loop._frequency(moved([0.5, 0.92, 0.94, 0.98], [upper] * 4)) == pytest.approx(2 / 0.06)
    assert of_loop._frequency(moved([0.9, 0.95], [upper, upper])) == pytest.approx(20.0)
    assert of_loop._frequency(moved([0.92, 0.93, 0.96], [upper, "lower contact", upper])) == pytest.approx(
        25.0
    )
    assert of_loop._frequency(moved([0.5, 0.95], [upper, upper])) is None
    assert of_loop._frequency(moved([0.95, 0.95], [upper, upper])) is None
    assert of_loop._frequency(moved([0.92, 0.96], [upper, upper], drive=1)) is None
    other = moved([0.92, 0.96], [upper, upper])
    other.events[1].kind = EventKind.STICK
    assert of_loop._frequency(other) is None


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
    assert "3.0e-16" in lines[-1]


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


def test_a_certificate_tells_what_is_undecided() -> None:
    region = Made(omegas=(1.0, 2.0), amplitudes=(3.0, np.inf))
    certificate = Made(
        omegas=(10.0, 1e3),
        complete=False,
        outside_excluded=True,
        undecided=[region],
        other_doubts=("doubt",),
    )
    first, second, third = certificate_text.certificate_as_text(certificate)
    assert first.startswith("searched from 10 to 1000 rad/s: there may be others; ")
    assert second == "undecided: 1 to 2 rad/s, amplitude 3 to inf"
    assert third == "doubt"
    assert certificate_text._region(region) == {"amplitudes": [3.0, None], "omegas": [1.0, 2.0]}
    certificate.complete, certificate.outside_excluded = True, False
    assert certificate_text.certificate_as_text(certificate)[0].endswith("none is missing there")


def cycle(**changes: object) -> Made:
    usual = {
        "amplitude": 2e-5,
        "omega": 691.0,
        "frequency": 109.975,
        "stable": True,
        "crossing_angle": np.pi / 6,
    }
    return Made(**usual | {"near_tangency": False} | changes)


def test_limit_cycles_that_nearly_vanish_are_told(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(limit_cycles_text, "harmonic_leakage", lambda loop, cycle: (0.125,) * 9)
    monkeypatch.setattr(limit_cycles_text, "certificate_as_text", lambda _: ["certified"])
    balance = Made(limit_cycles=[cycle(), cycle(stable=False)], certificate=None)
    lines = limit_cycles_text.as_text(Made(element="E"), balance).splitlines()
    assert cells(lines)[2][:6] == ["2e-05", "691", "109.975", "yes", "30", "0.125"]
    assert cells(lines)[3][3] == "no"
    assert lines[-1] == "certified"
    balance.limit_cycles[1].near_tangency = True
    assert "5 degrees" in limit_cycles_text.as_text(Made(element="E"), balance).splitlines()[-1]


def identified(**changes: object) -> Made:
    usual = {"frequency": 740.0, "frequency_uncertainty": 0.0, "time_constants": [], "intervals": []}
    return Made(**usual | {"bands": [], "nearest": None} | changes)


def test_what_was_identified_is_told_with_its_band() -> None:
    found = Made(time_constant=1.5e-3, limit_cycle=cycle(frequency=743.0))
    interval = Made(lowest=1e-3, highest=2e-3, frequencies=(738.0, 742.0))
    band = Made(frequencies=(700.0, 800.0), lower=Made(time_constant=0.0), upper=Made(time_constant=np.nan))
    text = limit_cycles_text.identified_as_text
    lines = text(
        identified(time_constants=[found], frequency_uncertainty=2.0, intervals=[interval], bands=[band])
    ).splitlines()
    assert lines[0] == "Time constants M/D"
    assert cells(lines)[1][:2] == ["M/D, s", "amplitude"] and len(cells(lines)[1]) == 6
    assert cells(lines)[2][:2] == ["0.0015", "2e-05"]
    assert lines[3] == "M/D within 740 +- 2 Hz: 0.001 to 0.002 s (738 to 742 Hz)"
    assert lines[4] == "feasible: 700 to 800 Hz, with M/D from 0 s to no end"
    assert len(lines) == 5
    lines = text(identified(nearest=found, frequency_uncertainty=1e-3)).splitlines()
    assert lines[0].startswith("no M/D gives")
    assert lines[1].startswith("no M/D gives a limit cycle within 740 +- 0.001 Hz")
    assert lines[2].startswith("feasible: no frequency")
    assert lines[3] == "The nearest limit cycle, +3 Hz from there"
    assert len(text(identified()).splitlines()) == 2


def test_orbits_stand_beside_their_predictions() -> None:
    prediction, missed = cycle(), cycle(amplitude=3e-5)
    usual = {"amplitude": 2e-5, "frequency": 110.0, "stable": False, "largest_multiplier": 1.25}
    orbit = Made(**usual, prediction=prediction, amplitude_error=0.0125, frequency_error=-0.001)
    assert orbits_text._row(orbit) == (
        *("2e-05", "110", "no", "1.25"),
        *("2e-05", "+1.25%", "109.975", "-0.100%"),
    )
    assert orbits_text._row(Made(**usual, prediction=None))[4:] == ("none", "", "", "")
    assert orbits_text._without_orbit([prediction, missed], [orbit]) == [missed]


def test_roots_and_extrema_of_the_linear_trimmer() -> None:
    factored = Made(poles=np.array([-1 + 2j, -1 - 2j, -3 + 0j]), zeros=np.array([5j, -5j]), static_gain=2.0)
    low, high = Made(omega=2 * np.pi, magnitude=10.0), Made(omega=4 * np.pi, magnitude=0.0)
    summary = Made(factored=factored, peaks=(high,), antiresonances=(low,))
    assert list(linear_text._root_rows(summary)) == [("-1 ± 2j", "0 ± 5j"), ("-3", "")]
    rows = list(linear_text._extremum_rows(summary))
    assert rows == [("dip", "6.28319", "1", "10", "20"), ("peak", "12.5664", "2", "0", "-inf")]
    mode = Made(eigenvalue=-1 + 2j)
    assert linear_text._is_stable(Made(modes=[mode]))
    assert not linear_text._is_stable(Made(modes=[mode, Made(eigenvalue=0j)]))
    assert linear_text._table("T", ("a", "b"), iter(())) == ["T", "  none"]
    assert linear_text._table("T", ("a", "b"), [("long", "x")]) == ["T", "  a     b", "  long  x"]


def test_gains_of_the_linear_trimmer() -> None:
    summary = Made(
        factored=Made(static_gain=0.0), gain_crossings=[], low_pass=None, roll_off=-40.0, encirclements=None
    )
    told = dict(linear_text._gain_rows(summary))
    assert told["|G| = 1 (0 dB) at"] == "no frequency"
    assert told["bandwidth"].startswith("not defined")
    assert told["roll-off"] == "-40 dB per decade"
    assert told["clockwise encirclements of -1"].startswith("not defined")
    summary.low_pass, summary.encirclements = Made(bandwidth=5.0, crossings=[5.0, 7.0]), 0
    told = dict(linear_text._gain_rows(summary))
    assert told["bandwidth (-3 dB from G(0))"] == "5 rad/s"
    assert told["-3 dB from G(0) at"] == "5, 7 rad/s"
    assert told["clockwise encirclements of -1"] == "0"


def test_ends_of_intervals_are_shares_of_the_number() -> None:
    def number(value: float, lower: float | None, upper: float | None) -> Made:
        return Made(value=value, lower=lower, upper=upper, lowest=1.0, highest=9.0)

    assert fit_text._percent(number(4.0, 3.0, 6.0)) == "-25 % to +50 %"
    assert fit_text._percent(number(-4.0, -6.0, -3.0)) == "-25 % to +50 %"
    assert fit_text._percent(number(0.0, -1.0, 1.0)) == ""
    assert fit_text._ends(number(4.0, 3.0, 6.0)) == ("3 to 6", "-25 % to +50 %")
    assert fit_text._ends(number(4.0, None, 6.0)) == ("open to 6", "")


def test_what_was_assumed_is_told_once() -> None:
    signal = Made(notes=("a", "b"), unit="")
    told = recording_text.notes_of(Made(full_scale_is_one=True), signal, ["b", "c"])
    assert told == ["a", "b", recording_text.NO_SCALE, "c"]
    signal.unit = "m"
    assert recording_text.notes_of(Made(full_scale_is_one=True), signal, []) == ["a", "b"]
    signal.unit = ""
    assert recording_text.notes_of(Made(full_scale_is_one=False), signal, []) == ["a", "b"]
    lines = recording_text.wrapped("word " * 60, "1 ", "22 ")
    assert lines[0].startswith("1 word") and lines[1].startswith("22 word")
    assert max(map(len, lines)) <= 110


def test_multipliers_are_pairs_in_json() -> None:
    point = Made(
        value=1.0,
        period=0.5,
        stable=True,
        multipliers=np.array([0.5 - 0.25j]),
        events_per_period=2,
        outputs={"x": Made(peak_to_peak=4.0, harmonics=np.array([2.0, 1.0]))},
        balanced=lambda count: Made(distance=float(count), converged=True),
    )
    content = json.loads(json.dumps(follow_text._point(point, None)))
    assert content["multipliers"] == [[0.5, -0.25]]
    assert content["outputs"] == {"x": {"peak_to_peak": 4.0, "harmonics": [2.0, 1.0]}}
    assert content["balance"] is None
    assert follow_text._point(point, 3)["balance"] == {"distance": 3.0, "converged": True}
