"""Every section of a file that may be left out is left out of every example: a right report comes of it."""

import re
from dataclasses import replace
from pathlib import Path

import pytest

from report.cache.stage_store import StageStore
from report.design.building import looked_at, report_on
from report.design.markdown import to_markdown
from report.design.origin import origin_of
from report.design.progress import ProgressLines
from report.design.report import DesignReport
from report.design.sentences_around import first_changes
from trimmer import MechanismError, SerialRunner
from trimmer.deadline import Deadline
from trimmer.design import Design, DesignFile, DesignSettings, Stage
from trimmer.design.specification.design_file import design_file_of_text
from trimmer.examples import example_text, examples

TINY = DesignSettings(
    starts=1,
    cells=2,
    cell_periods=20,
    neighbours=3,
    trials=1,
    most_points=4,
    range_points=3,
    most_periods=40,
    grid=1,
)
KEYS = ("title", "frequency", "held", "author")
SECTION = r"(?ms)^\[{}\]\n.*?(?=^\[|\Z)"
KEY = r"(?m)^{} *=.*\n"


def without(text: str, name: str) -> str:
    """Return a file without a section or a key at its top."""
    return re.sub((KEY if name in KEYS else SECTION).format(name), "", text)


def cases() -> list[tuple[str, str]]:
    """Return each thing that examples have and may be without, with the first three that have it."""
    having: dict[str, list[str]] = {}
    for name in examples():
        text = example_text(name)
        sections = [each for each in re.findall(r"(?m)^\[(\w+)\]", text) if each != "bodies"]
        keys = [each for each in KEYS if re.search(KEY.format(each), text)]
        for each in (*keys, *sections):
            having.setdefault(each, []).append(name)
    return [(name, each) for each, names in having.items() for name in names[:3]]


def reported(file: DesignFile, folder: Path) -> tuple[DesignReport, str]:
    """Return the report on a file, and its text."""
    store = StageStore(folder)
    design = looked_at(file, TINY, SerialRunner(), store, lambda *_: None)
    report = report_on(design, store, "2026-03-01")
    return report, "\n".join(to_markdown(report).values())


def told(design: Design) -> dict[str, str]:
    """Return the text of a report without pictures, which take longer than all else."""
    return dict(to_markdown(DesignReport("Mine", {}, origin_of([design.file], "2026-03-01"), design, None)))


@pytest.mark.slow
@pytest.mark.parametrize(("name", "left_out"), cases())
def test_a_report_needs_no_section_that_may_be_left_out(name: str, left_out: str, tmp_path: Path) -> None:
    try:
        file = design_file_of_text(without(example_text(name), left_out), f"{name}.toml")
    except MechanismError as error:  # what is left names it: then that is said before any work
        assert f"{name}.toml: line" in str(error) or "problems:" in str(error)
        return
    _, text = reported(file, tmp_path)
    assert re.search(r"\bNone\b(?! of the)", text) is None
    assert "nan" not in text.split()


def test_a_search_that_was_ended_early_says_so_in_its_verdict(tmp_path: Path) -> None:
    text = example_text("oscillator-stop") + '[targets]\nstroke_at_least = "1 km"\n'
    file, store = design_file_of_text(text, "open.toml"), StageStore(tmp_path)
    design = looked_at(file, TINY, SerialRunner(), store, lambda *_: None)
    for each, early in ((design, False), (replace(design, cut=((Stage.REMEDIES, ()),)), True)):
        verdict = told(each)["verdict"].replace("\\", "")
        assert verdict.count("was found, in the time that was allowed, that meets all") == 2 * early
        assert ("computed, fewer than planned, as the time was over" in verdict) is early


def test_what_there_was_no_time_for_is_said_where_it_would_stand(tmp_path: Path) -> None:
    text = example_text("thesis-play").replace("gap = 40e-6", 'gap = "30 um..50 um"')
    file = design_file_of_text(text.replace('"2.8 mm"', '"5 mm"'), "open.toml")
    lines = ProgressLines(tmp_path / "open.log")
    store = StageStore(tmp_path)
    design = looked_at(file, TINY, SerialRunner(), store, lines, Deadline(0.0, 1.0))
    pieces = to_markdown(report_on(design, store, "2026-03-01"))
    assert "`--budget` allows more" in pieces["verdict"]
    for name in ("ranges", "motions", "maps", "branches", "sensitivity"):
        assert "There was no time left for" in pieces[name], name
    assert "missed" in pieces["verdict"]
    log = (tmp_path / "open.log").read_text()
    assert "kept" not in log and "what would meet the targets: left out\n" in log
    assert log.count(": left out\n") == len(design.cut) - 1  # the first motion is followed all the same


@pytest.mark.slow
def test_a_file_without_outputs_gets_its_report(tmp_path: Path) -> None:
    text = without(example_text("den-hartog"), "outputs")
    report, text = reported(design_file_of_text(text, "den-hartog.toml"), tmp_path)
    assert {"diagram", "motion", "map-1"} <= set(report.figures)
    assert not {"transfer", "spectrum-1", "branch-1"} & set(report.figures)
    assert "The file names no outputs, so there is no transfer function." in text
    assert "The file names no outputs, whose lines would stand here." in text
    assert "Peak to peak of" not in text
    assert r"block\, acceleration" in text


@pytest.mark.slow
def test_a_servo_that_hunts_has_no_drive_periods(tmp_path: Path) -> None:
    _, text = reported(
        design_file_of_text(without(example_text("two-mass-servo"), "targets"), "two-mass-servo.toml"),
        tmp_path,
    )
    text = re.sub(r"\s+", " ", text.replace("\\", ""))  # the space before a unit is no plain one
    assert "nothing is judged; angle hunts by ±2.61 mrad, once in 105.7 ms" in text
    assert "comes to a motion of its own that repeats after 105.68 ms" in text
    assert "one play, one friction and one controller" in text
    assert "drive period" not in text


def test_what_is_bounded_from_above_shall_fall(tmp_path: Path) -> None:
    text, store = example_text("oscillator-stop"), StageStore(tmp_path)
    for key, way in (("stroke_at_least", "raise"), ("peak_to_peak_at_most", "lower")):
        file = design_file_of_text(f"{text}[targets]\n{key} = 1.0\n", "bound.toml")
        design = looked_at(file, TINY, SerialRunner(), store, lambda *_: None)
        assert first_changes(design).startswith(f"- To {way} the **peak to peak of ")


def test_a_brake_that_squeals_gets_a_map_and_the_damper_that_keeps_it_quiet(tmp_path: Path) -> None:
    """At its speed the friction falls by 1.32 N s/m: a damper of more keeps it quiet."""
    text, store = (
        example_text("brake-squeal").replace("stiffness = 1.0", "stiffness = 1.0, damping = 0.6"),
        StageStore(tmp_path),
    )
    file = design_file_of_text(f'{text}[targets]\npeak_to_peak_at_most = "1 mm"\n', "brake.toml")
    design = looked_at(file, replace(TINY, trials=6), SerialRunner(), store, lambda *_: None)
    assert design.remedies is not None
    (change,) = next(each.changes for each in design.remedies.found if len(each.changes) == 1)
    assert change.place == "links.caliper.damping" and 1.32 < change.after < 1.8
    assert any("pins.disc.velocity" in each.result.places for each in design.maps)
