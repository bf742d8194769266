"""How results show themselves: short reprs, HTML for notebooks, data frames with units."""

import re
from collections.abc import Callable
from dataclasses import is_dataclass, replace
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pandas
import pytest
from IPython.core.formatters import HTMLFormatter

import trimmer
from tests.json_document import documented
from tests.public_names import public_names
from tests.trimmer import results
from trimmer.showing.shown import Shown, Tabular

RESULTS: dict[str, Callable[[], object]] = {
    "HarmonicBalance": results.balance,
    "Certificate": lambda: results.balance().certificate,
    "LimitCycle": lambda: results.balance().limit_cycles[0],
    "Identification": results.identification,
    "IdentifiedTimeConstant": lambda: results.identification().time_constants[0],
    "FeasibleBand": lambda: results.identification().bands[0],
    "BandEnd": lambda: results.identification().bands[0].lower,
    "PeriodicOrbits": results.orbits,
    "PeriodicOrbit": lambda: results.orbits()[0],
    "ImpactEvent": lambda: results.orbits()[0].impacts[0],
    "ClosedLoop": results.loop,
    "TrimmerLoop": lambda: results.driven().loop,
    "Motion": results.driven,
    "LoopMotion": results.driven,
    "Event": lambda: results.driven().events[0],
    "EnergyBalance": lambda: trimmer.energy_balance(results.driven()),
    "MechanismMotion": results.stopped,
    "MechanismEnergy": lambda: results.stopped().energy,
    "MechanismOrbit": results.forced,
    "Response": results.response,
    "SettledMotion": lambda: results.response().motion,
    "Mechanism": lambda: results.forced().mechanism,
    "LinearMatrices": lambda: trimmer.mechanism.linear_matrices(results.forced().mechanism),
    "FollowedBranch": results.branch,
    "FollowedOrbit": lambda: results.branch().points[0],
    "OutputMeasure": lambda: results.branch().points[0].outputs["x"],
    "SpecialPoint": lambda: results.branch().special[0],
    "MotionMap": results.motion_map,
    "Sweep": results.swept,
    "StepResponse": results.stepped,
    "Basin": results.basin,
    "Samples": results.samples,
    "Coexistence": lambda: trimmer.coexisting_motions(results.motion_map(), quiet=True),
    "SpecialCurves": results.curves,
    "SpecialCurve": lambda: results.curves().curves[0],
    "Locus": results.locus,
    "LinearSummary": results.summary,
    "ZeroPoleGain": lambda: results.summary().factored,
    "MeasuredResponse": lambda: trimmer.linear.MeasuredResponse(np.arange(1.0, 6.0), np.ones(5)),
    "Mode": lambda: results.summary().modes[0],
    "TimeResponse": results.time_response,
    "SteadyState": lambda: trimmer.linear.steady_state(results.system(), 700.0),
    "Signal": results.signal,
    "SpectrumAnalysis": results.analysis,
    "Spectrum": lambda: results.analysis().spectrum,
    "HarmonicFit": lambda: results.analysis().harmonics,
    "Peak": lambda: results.analysis().peaks[0].peak,
    "AveragedSpectrum": results.averaged,
    "MotionComparison": results.comparison,
    "Fit": results.fit,
    "SimulatedLines": lambda: trimmer.spectra.SimulatedLines(np.array([1e-3, 2e-6]), 110.0),
    "Recording": lambda: trimmer.signals.Recording((results.signal(),)),
    "Conversion": lambda: trimmer.convert(results.signal(), "velocity"),
    "BalancedHarmonics": lambda: trimmer.multi_harmonic_balance(
        results.loop(), results.balance().limit_cycles[-1], [1, 3]
    )[-1],
    "FeedbackBalance": results.several,
    "BalancedMotion": lambda: results.several().motions[0],
    "SampledLimitCycles": lambda: trimmer.ensembles.sampled_limit_cycles({"k2": [3e4, 3.1e4]}, gap=4e-5),
}
TABLES = [name for name in RESULTS if issubclass(public_names().get(name, object), Tabular)]
LONGEST = 240

JSON = {
    "HarmonicBalance": ("trimmer limit-cycles", "limit_cycles[]."),
    "PeriodicOrbits": ("trimmer orbits", "orbits[]."),
    "Motion": ("trimmer simulate", "events[]."),
    "MechanismMotion": ("trimmer simulate, of a mechanism", "events[]."),
    "LinearSummary": ("trimmer linear", "modes[]."),
    "FollowedBranch": ("trimmer follow", "points[]."),
    "MotionMap": ("trimmer map", ""),
    "Sweep": ("trimmer sweep", "points[]."),
    "StepResponse": ("trimmer step", ""),
    "SpectrumAnalysis": ("trimmer spectrum", "peaks[]."),
    "MotionComparison": ("trimmer overlay", "lines[]."),
    "Fit": ("trimmer fit", "numbers[]."),
}
"""Section of the document of the JSON, and what stands before the keys."""
NOT_IN_JSON = {"largest_multiplier", "branch", "period_count", "distance_bins"}
"""Columns whose keys stand elsewhere there, or that are of several keys."""


@pytest.fixture(params=RESULTS.values(), ids=RESULTS)
def result(request: pytest.FixtureRequest) -> object:
    return request.param()


def test_all_results_that_show_themselves_are_tried() -> None:
    public = public_names()
    shown = {name for name, each in public.items() if isinstance(each, type) and issubclass(each, Shown)}
    assert shown <= set(RESULTS)


def test_a_repr_is_one_short_line_without_arrays(result: object) -> None:
    text = repr(result)
    assert "\n" not in text
    assert "array(" not in text
    assert len(text) <= LONGEST
    assert type(result).__name__ in text
    assert is_dataclass(result)


def test_html_is_well_formed_without_scripts_or_colours(result: object) -> None:
    text = HTMLFormatter()(result) or ""
    assert text or isinstance(result, trimmer.ClosedLoop | trimmer.TrimmerLoop)
    root = ElementTree.fromstring(f"<div>{text}</div>")
    tags = {each.tag for each in root.iter()}
    assert tags <= {"div", "p", "strong", "table", "caption", "thead", "tbody", "tr", "th", "td"}
    assert not re.search("colou?r|style|script|onclick|nan", text)
    assert len(root.findall(".//tbody/tr")) <= 20
    heads = len(root.findall(".//thead/tr/th"))
    assert all(len(row) == heads for row in root.findall(".//tbody/tr")) or heads == 0


@pytest.mark.parametrize("name", TABLES)
def test_a_data_frame_has_a_row_for_each_and_the_units(name: str) -> None:
    result = RESULTS[name]()
    assert isinstance(result, Tabular)
    frame = result.to_dataframe()
    assert isinstance(frame, pandas.DataFrame)
    assert len(frame) > 0
    assert list(frame.attrs["units"]) == list(frame.columns)
    assert all(isinstance(unit, str) for unit in frame.attrs["units"].values())
    assert frame.columns.is_unique


@pytest.mark.parametrize("name", JSON)
def test_columns_have_the_names_of_the_json(name: str) -> None:
    heading, before = JSON[name]
    found = RESULTS[name]()
    if isinstance(found, trimmer.Motion | trimmer.MechanismMotion):
        found = found.events  # The motion itself is a table of signals.
    assert isinstance(found, Tabular)
    keys = {key.removeprefix(before) for key in documented(heading) if key.startswith(before)}
    places = set(getattr(found, "places", ()))
    own = {column for column in found.to_dataframe().columns if "." not in column or column in places}
    assert own - places - NOT_IN_JSON <= keys | {key.split(".")[0] for key in keys}


@pytest.mark.parametrize(
    ("motion", "columns"),
    [
        (results.driven, {"output": "m", "element_input": "m", "element_output": "m"}),
        (results.relay, {"output": "", "element_input": "", "element_output": ""}),
        (results.stopped, {"x": "m"}),
    ],
)
def test_a_motion_is_a_table_of_signals(motion: Callable[[], object], columns: dict[str, str]) -> None:
    found: Any = motion()
    frame = found.to_dataframe(50)
    assert frame.attrs["units"] == {"time": "s", **columns}
    times = frame["time"].to_numpy()
    assert (np.diff(times) > 0).all()
    assert {event.time for event in found.events} | set(np.linspace(0.0, found.duration, 50)) == set(times)
    for name in columns:
        of_mechanism = isinstance(found, trimmer.MechanismMotion)
        expected = found.output(name, times) if of_mechanism else getattr(found, name)(times)
        np.testing.assert_array_equal(frame[name], expected)
    assert found.events.to_dataframe()["time"].tolist() == [event.time for event in found.events]


def test_a_map_lists_its_cells_row_by_row() -> None:
    result = results.motion_map()
    frame = result.to_dataframe()
    assert frame["frequency"].tolist() == [1.1, 1.2, 1.3] * 2
    assert frame["stops.wall.gap"].tolist() == [8.0] * 3 + [10.0] * 3
    np.testing.assert_array_equal(frame["outputs.x.peak_to_peak"], result.stroke.ravel())
    assert set(frame["kind"]) <= {"periodic", "chaotic", "torus", "undecided"}
    assert frame.attrs["units"]["stops.wall.gap"] == "m"


def test_a_basin_numbers_its_motions_as_its_legend_does() -> None:
    found = results.basin()
    assert found.to_dataframe()["motion"].tolist() == (found.number.ravel() + 1).tolist()


def test_what_comes_from_the_user_is_escaped_shortened_and_kept_apart() -> None:
    signal = trimmer.Signal([1.0, 2.0], 10.0, "<script>&", "m")
    text = HTMLFormatter()(signal)
    assert "<script>" not in text and "&lt;script&gt;&amp;" in text
    assert signal.to_dataframe().columns.tolist() == ["time", "<script>&"]
    assert trimmer.Signal([1.0], 10.0, "time").to_dataframe().columns.tolist() == ["time", "value"]
    assert len(repr(replace(results.forced().mechanism, title="many words " * 90))) <= LONGEST
    for points in (1, 2.5, "many"):
        with pytest.raises((ValueError, TypeError), match="points"):
            results.driven().to_dataframe(points)  # type: ignore[arg-type]
