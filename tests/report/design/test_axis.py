"""What the report says of an axis that hunts, and of one that rests."""

from __future__ import annotations

import re

from report.design.markdown import to_markdown
from report.design.origin import origin_of
from report.design.pictures import pictures
from report.design.report import DesignReport
from tests.trimmer.servos import SAMPLED, STICTION
from trimmer import SerialRunner
from trimmer.design.design_file import design_file_of_text
from trimmer.design.settings import DesignSettings
from trimmer.design.study import Study
from trimmer.design.varied_places import varied_places


def told(text: str) -> dict[str, str]:
    file = design_file_of_text(text, "mine.toml")
    study = Study(file, DesignSettings(cells=2), SerialRunner())
    design = study.short()
    report = DesignReport("Axis", pictures(design), origin_of([file], "2026-01-01"), design, None)
    assert "step-1" in report.figures
    return {name: re.sub(r"\\(?=[^a-zA-Z])", "", each) for name, each in to_markdown(report).items()}


def test_an_axis_that_hunts_is_told_so() -> None:
    """Digits of servo.json, hunting_one_mass_static_friction."""
    pieces = told(STICTION + "[targets]\nhunting_at_most = 0\nrise_time_at_most = '20 ms'\n")
    assert "the hunting of axis is 2.51 mrad, where none is wanted" in pieces["verdict"]
    step = pieces["step"]
    assert "follow a step of 500 mrad at 10 ms in path" in step
    assert "After it angle hunts by ±2.51 mrad, once in 893.4 ms." in step
    assert "Margins are of the loop opened where the controller acts" in pieces["linear"]
    assert "may" in pieces["linear"]


def test_an_axis_that_rests_is_told_so() -> None:
    pieces = told(SAMPLED)
    assert "**The file names no targets**, so nothing is judged; angle comes to rest." in pieces["verdict"]
    assert "none: it rests" in pieces["step"]
    assert "Margins of sampled controllers (axis) are not computed." in pieces["linear"]
    file = design_file_of_text(SAMPLED, "mine.toml")
    places = [each.place for each in varied_places(file.mechanism, None)]
    assert places == ["controllers.axis.kp", "controllers.axis.ki"]
