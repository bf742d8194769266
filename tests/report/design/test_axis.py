"""What the report says of an axis that hunts, of one that rests, and of a machine that switches."""

import math
import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from report.design.axis import instability_sentence, loop_rows, loop_sentence
from report.design.markdown import to_markdown
from report.design.origin import origin_of
from report.design.pictures import curves_of, pictures
from report.design.report import DesignReport
from report.design.sentences_around import margin_sentences
from report.design.words.phrases import kind_words
from tests.quick import quick
from tests.report.design.conftest import TEXT as DESK
from tests.report.markdown_lines import markdown_lines
from tests.trimmer.design.test_axis import AXIS
from tests.trimmer.servos import SAMPLED, STICTION
from trimmer import Mechanism, SerialRunner, forced_orbit, respond
from trimmer.branches import BranchEnd
from trimmer.design import DesignSettings, Measure, Study
from trimmer.design.analysis.found_motion import of_orbit
from trimmer.design.analysis.linear import linear_states
from trimmer.design.specification.design_file import design_file_of_text
from trimmer.design.varied_places import varied_places
from trimmer.examples import example_text


def told(text: str, is_drawn: bool = False) -> dict[str, str]:
    file = design_file_of_text(text, "mine.toml")
    study = Study(file, DesignSettings(cells=2, starts=1, neighbours=3), SerialRunner())
    design = study.short()
    figures = pictures(design) if is_drawn else {}
    report = DesignReport("Axis", figures, origin_of([file], "2026-01-01"), design, None)
    assert ("step-1" in figures) == ("[references]" in text and is_drawn)
    return {name: re.sub(r"\\(?=[^a-zA-Z])", "", each) for name, each in to_markdown(report).items()}


def test_an_axis_that_hunts_is_told_so() -> None:
    """Digits of servo.json, hunting_one_mass_static_friction."""
    pieces = told(STICTION + "[targets]\nhunting_at_most = 0\nrise_time_at_most = '20 ms'\n", is_drawn=True)
    assert "the hunting of axis is 2.51 mrad, where none is wanted" in pieces["verdict"]
    step = pieces["step"]
    assert "follow a step of 500 mrad at 10 ms in path" in step
    assert "After it angle hunts by ±2.51 mrad, once in 893.4 ms." in step
    assert "Margins are of the loop opened where the controller acts" in pieces["linear"]
    assert "may" in pieces["linear"]


def test_an_axis_is_followed_over_its_numbers_and_what_ends_that_is_told() -> None:
    """Not down to no gain at all; what targets of a step bound is of the way to the motion."""
    file = design_file_of_text(STICTION + "[targets]\nhunting_at_most = 0\n", "mine.toml")
    study = Study(file, DesignSettings(cells=2, starts=1, neighbours=3, most_points=6), SerialRunner())
    first, *others = study.paths(found := study.motions(), study.varied(found))
    assert [len(side.values) for path in (first, *others) for side in (path.down, path.up)] == [6] * 6
    design = study.short()
    assert [asked.measure for asked, *_ in curves_of(design)] == [Measure.STROKE]
    ends = {BranchEnd.TORN: "the motion jumps", BranchEnd.INFINITE_PERIOD: "its period grows without bound"}
    for reason, words in ends.items():
        torn = replace(first, down=None, up=replace(first.up, reason=reason))
        assert f"% {words}." in margin_sentences(replace(design, paths=(torn,)))


def test_what_advances_is_told_with_its_advance() -> None:
    feeder = Mechanism.from_toml_text(example_text("strip-feeder"))
    motion = of_orbit(forced_orbit(feeder))
    millimetres = 1e3 * motion.outputs["strip"].advance
    assert f"up to an advance of strip by {millimetres:.0f}" in kind_words(motion)


def test_an_axis_that_rests_is_told_so() -> None:
    pieces = told(SAMPLED)
    assert "**The file names no targets**, so nothing is judged; angle comes to rest." in pieces["verdict"]
    assert "How that was found: after the last step all comes to rest, and what" in pieces["verdict"]
    assert "none: it rests" in pieces["step"]
    for told_there in ("may rise to 3.82 times, 139 Hz", "50.1° at 10.5 Hz", "0.661 at 129 Hz"):
        assert told_there in pieces["linear"]  # as `trimmer linear` has it
    assert "sampled controllers (axis) are exact, from sample to sample" in pieces["linear"]
    file = design_file_of_text(SAMPLED, "mine.toml")
    places = [each.place for each in varied_places(file.mechanism, None)]
    assert places == ["controllers.axis.kp", "controllers.axis.ki"]


def test_what_samples_alone_drive_is_told_in_samples() -> None:
    held = STICTION.replace('reference = "path"\n', "sample = 0.005\n").split("[references]")[0]
    pieces = told(held + "[start]\nmotor = [0.5, 0.0]\n", is_drawn=True)
    assert "does not repeat and was measured over 96 samples" in pieces["verdict"]
    assert re.search(r"it was followed for [0-9]+ samples\.", pieces["motions"])
    assert not any("drive period" in pieces[name] for name in ("verdict", "motions"))


def test_of_chaos_it_is_told_by_what_it_grows() -> None:
    lively = re.sub('".{,9}60 um"', '"0.8 mm"', DESK.split("[targets]")[0]).replace(
        "force = 0.8", "force = 0.0"
    )
    grown = re.search("grow by the factor ([0-9.]+) per drive period, so that", told(lively)["motions"])
    exponent = respond(design_file_of_text(lively, "mine.toml").mechanism).motion.lyapunov
    assert grown and exponent is not None
    assert float(grown[1]) == pytest.approx(math.exp(exponent.value), rel=0.1)


def test_lines_of_what_samples_alone_drive_are_told_by_them() -> None:
    """A relay in effect: the control is at its limit, and turns at samples 3, 6, 9 ..., every 1.5 s."""
    text = """
[bodies]
mass = { mass = 1.0 }
[links]
damper = { between = ["ground", "mass"], damping = 1.0 }
[outputs]
x = { mass = 1 }
[controllers.axis]
kind = "pid"
measure = "x"
acts = ["ground", "mass"]
kp = 100.0
limit = 1.0
sample = 0.5
[start]
mass = [0.3, 0.0]
"""
    pieces = told(text)
    assert "of the sampling: the motion repeats after six samples" in pieces["spectrum"]
    # The first harmonic of a square wave of 1 N at 1/3 Hz, through 1/(s (s + 1)).
    s = 2j * math.pi / 3.0
    assert f"{1e3 * abs(4 / math.pi / (s * (s + 1))):.3g} mm" in pieces["spectrum"]
    assert not any("drive period" in each for each in pieces.values())


@pytest.mark.parametrize("targets", quick(["", "[targets]\novershoot_at_most = 40\n"], 1))
def test_a_number_that_nobody_knows_is_told_by_steps_alone(targets: str) -> None:
    """Overshoots in closed form, as in tests/trimmer/design/test_axis.py."""
    ranges = told(AXIS.replace('"2 kg"', '"2 kg..3 kg"') + targets)["ranges"]
    assert "30.5 %" in ranges and "38.8 %" in ranges


LAW = SAMPLED[SAMPLED.index("[controllers.axis]") : SAMPLED.index("[references]")]
OTHER = LAW.replace("axis", "other")


@pytest.mark.parametrize(
    ("beside", "rows", "words"),
    [
        ("", ["axis"], "are exact, from sample to sample, and opened at what is demanded at a sample."),
        (re.sub("sample.*|delay.*", "", OTHER), ["other", "axis"], "while axis holds what was given last."),
        (
            OTHER.replace("0.001", "0.002"),
            [],
            "Sampled controllers (axis and other) have no margins here, since their samples differ.",
        ),
    ],
)
def test_margins_are_of_samples_that_agree(beside: str, rows: list[str], words: str) -> None:
    mechanism = Mechanism.from_toml_text(SAMPLED + beside)
    (state,) = linear_states(mechanism)
    assert [row[0] for row in loop_rows(state, mechanism)[1:]] == rows
    told = loop_sentence(mechanism)
    assert told.endswith(words) and told.startswith("Margins are" if rows else words)


def test_what_is_unstable_is_not_said_to_stay_so() -> None:
    mechanism = Mechanism.from_toml_text(SAMPLED.replace("kp = 1.5", "kp = 50"))
    (state,) = linear_states(mechanism)
    (row,) = loop_rows(state, mechanism)[1:]
    assert row[1].startswith("limit at 0.") and row[4].startswith("grows by e in")
    assert "it grows by e in" in instability_sentence(mechanism)
    assert instability_sentence(Mechanism.from_toml_text(SAMPLED)) == ""


CONTACTOR = Path(__file__).parents[3] / "examples" / "contactor.toml"


def test_a_contactor_that_stays_closed_holds_what_its_coil_pulls() -> None:
    kept_on = CONTACTOR.read_text("utf-8").replace(', ["60 ms", 25.0], ["62 ms", 0.0]]', "]")
    file = design_file_of_text(kept_on[: kept_on.index("[targets]")], "contactor.toml")
    design = Study(file, DesignSettings(cells=2), SerialRunner()).short()
    stiffness = np.array([[600 + 1500 + 1e6, -1500], [-1500, 1500 + 5e5]])
    armature, bridge = np.linalg.solve(stiffness, [25 - 6 - 4 + 1e6 * 3e-3, 4 + 5e5 * 2e-3])
    forces = {
        "return spring": 600 * armature,
        "contact spring": 1500 * (bridge - armature),
        "backstop": 0.0,
        "shoulder": 0.0,
        "core": 1e6 * (armature - 3e-3),
        "contact": 5e5 * (bridge - 2e-3),
    }
    rows = [part for name, force in forces.items() for part in (name, f"{force:.3g} N".replace("-", "−"))]
    report = DesignReport("Contactor", {}, origin_of([file], "2026-01-01"), design, None)
    found = markdown_lines(to_markdown(report))
    assert " | ".join(["", "Part", "Force at rest", *rows]) + "\n" in found
    assert design.motion is not None and design.motion.switched is not None
    closings = [
        f"{name} closes after {1e3 * at.closing_time:.3g} ms and bounces for {1e3 * at.bounce_time:.3g} ms"
        for name, at in sorted(design.motion.switched.closings.items())
    ]
    assert f"The machine switches. From rest, {' and '.join(closings)}; after 15.6 ms nothing" in found
