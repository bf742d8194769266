"""A fit made by hand: every part of its text and its JSON."""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path
from types import SimpleNamespace as Made

import numpy as np

from tests.trimmer.command_line.told import cells
from trimmer.command_line.signals import fit_text
from trimmer.command_line.signals.recording_text import NO_SCALE, recording_json, signal_json
from trimmer.signals.fault import Certainty, Clipping
from trimmer.signals.recording import Recording
from trimmer.signals.signal import Signal

SIGNAL = Signal(np.sin(np.arange(500.0)), 250.0, "stroke", "m", notes=("as read",))
OTHER = Signal(np.cos(np.arange(400.0)), 250.0, "other", "", start=2.0)


@dataclass(frozen=True)
class Row:
    number: int


def number(lower: float | None, upper: float | None, *sentences: str) -> Made:
    return Made(
        place="plays.bridge.gap",
        unit="m",
        before=5e-5,
        value=4e-5,
        lower=lower,
        upper=upper,
        lowest=1e-5,
        highest=9e-5,
        sentences=sentences,
    )


def shown(title: str = "Twin", found: bool = True, output: Path | None = None) -> fit_text.ShownFit:
    measured = Made(
        signals={"a": SIGNAL, "b": OTHER},
        outputs=["a", "b"],
        frequency=110.0,
        found=found,
        periods=12.25,
        period_count=2,
        lines=np.array([[1 + 2j, 3 + 4j], [5 + 6j, 7 + 8j], [9.0, 10.0]]),
        deviations=np.array([[0.1, 0.2], [0.3, 0.4], [0.5, 0.6]]),
        strays=(Row(3),),
    )
    judgement = Made(
        sentences=("It explains.", "Well."),
        chi_square=7.5,
        freedom=6,
        reduced=1.25,
        probability=0.375,
        explained=True,
        excesses=(Row(1),),
    )
    fit = Made(
        measured=measured,
        before=Made(title=title, frequency=109.0),
        numbers=[number(3e-5, 6e-5), number(None, 6e-5, "open below")],
        confidence=0.95,
        judgement=judgement,
        agreement="Two starts agree.",
        weak=[Made(message="It is weak.", place="x")],
        notes=("a note", "as read"),
        shift=0.005,
        searched=Made(starts=5, agreeing=2, elsewhere=("there",), lost=1),
        simulated=10 * measured.lines,
    )
    recordings = {
        "a": Made(full_scale_is_one=False, signal=SIGNAL, recording=Recording((SIGNAL,)), faults=()),
        "b": Made(full_scale_is_one=True, signal=OTHER, recording=Recording((OTHER,)), faults=()),
    }
    return fit_text.ShownFit(Path("m.toml"), Path("a.csv"), output, recordings, fit)


def test_notes_stand_once_with_those_of_the_record_first() -> None:
    assert shown().notes == ["as read", NO_SCALE, "a note", "open below"]


def test_a_fit_is_told_part_by_part() -> None:
    head, numbers, verdict, notes = fit_text.as_text(shown()).split("\n\n")
    assert head.splitlines() == [
        "measured: a as displacement, stroke [m] of a.csv, 500 samples at 250 Hz",
        f"measured: b as {OTHER.quantity.word}, other of a.csv, 400 samples at 250 Hz",
        "drive: 110 Hz (found in the measurement), 12.2 periods",
        "compared: 3 lines at multiples of 55 Hz, weighed by the noise between them",
    ]
    lines = numbers.splitlines()
    assert lines[0] == "Fitted numbers of Twin"
    assert cells(lines[1:]) == [
        ["number", "unit", "before", "fitted", "interval of 95 %"],
        ["plays.bridge.gap", "m", "5e-05", "4e-05", "3e-05 to 6e-05", "-25 % to +50 %"],
        ["plays.bridge.gap", "m", "5e-05", "4e-05", "open to 6e-05"],
    ]
    assert verdict.splitlines() == ["It explains.", "Well.", "Two starts agree.", "It is weak."]
    assert notes.startswith("note: as read\nnote: no scale")
    assert notes.endswith("note: a note\nnote: open below")
    other = fit_text.as_text(shown(title="", found=False, output=Path("f.toml")))
    assert "110 Hz (as given)" in other
    assert "\n\nFitted numbers\n" in other
    assert other.endswith("\n\nwrote f.toml")


def test_every_number_of_a_fit_is_in_the_json() -> None:
    data = json.loads(fit_text.as_json(shown()))
    outputs = data.pop("outputs")
    assert list(outputs) == ["a", "b"]
    assert outputs["b"]["lines"] == [
        {"order": [1, 2], "measured": [3.0, 4.0], "fitted": [30.0, 40.0], "deviation": 0.2},
        {"order": [2, 2], "measured": [7.0, 8.0], "fitted": [70.0, 80.0], "deviation": 0.4},
        {"order": [3, 2], "measured": [10.0, 0.0], "fitted": [100.0, 0.0], "deviation": 0.6},
    ]
    assert outputs["a"]["lines"][1]["measured"] == [5.0, 6.0]
    assert [outputs[name]["signal"]["samples"] for name in "ab"] == [500, 400]
    assert outputs["b"]["stretches"] == [{"start": 2.0, "samples": 400}]
    usual = {"place": "plays.bridge.gap", "unit": "m", "before": 5e-5, "value": 4e-5}
    usual |= {"lowest_tried": 1e-5, "highest_tried": 9e-5, "upper": 6e-5}
    assert data.pop("notes") == shown().notes
    assert data == {
        "file": "m.toml",
        "measured": "a.csv",
        "written": None,
        "frequency": 110.0,
        "frequency_found": True,
        "file_frequency": 109.0,
        "period_count": 2,
        "shift": 0.005,
        "confidence": 0.95,
        "numbers": [usual | {"lower": 3e-5}, usual | {"lower": None}],
        "chi_square": 7.5,
        "degrees_of_freedom": 6,
        "reduced_chi_square": 1.25,
        "probability": 0.375,
        "explained": True,
        "judgement": ["It explains.", "Well."],
        "excesses": [{"number": 1}],
        "stray_lines": [{"number": 3}],
        "weak": [{"message": "It is weak.", "place": "x"}],
        "starts": {
            "number": 5,
            "agreeing": 2,
            "elsewhere": ["there"],
            "lost": 1,
            "message": "Two starts agree.",
        },
    }
    assert json.loads(fit_text.as_json(shown(output=Path("f.toml"))))["written"] == "f.toml"


def test_a_recording_is_in_the_json_with_its_faults() -> None:
    clipping = Clipping(Certainty.LIKELY, 3, 0, 2, 100, 0.5, 2.0)
    other = Made(kind="gap", sentence="it has a gap")
    gap = Made(begin=1.0, end=1.5, line=7, missing=3)
    chosen = Made(recording=Made(stretches=(SIGNAL, OTHER), gaps=(gap,)), faults=(clipping, other))
    assert recording_json(chosen) == {
        "stretches": [{"start": 0.0, "samples": 500}, {"start": 2.0, "samples": 400}],
        "gaps": [{"begin": 1.0, "end": 1.5, "line": 7, "missing": 3}],
        "faults": [
            {"kind": "clipping", "certainty": "likely", "message": clipping.sentence},
            {"kind": "gap", "certainty": None, "message": "it has a gap"},
        ],
    }


def test_the_band_of_a_signal_is_in_the_json() -> None:
    band = Made(lowest=2.0, highest=90.0, lowest_reason="low", highest_reason="high")
    signal = Made(
        name="x",
        unit="m",
        quantity=Made(name="DISPLACEMENT"),
        values=np.zeros(5),
        sample_rate=100.0,
        start=0.5,
        interpolated=3,
        trusted=band,
    )
    expected = {
        "name": "x",
        "unit": "m",
        "quantity": "displacement",
        "samples": 5,
        "sample_rate": 100.0,
        "start": 0.5,
        "interpolated": 3,
        "trusted": {"lowest": 2.0, "highest": 90.0, "lowest_reason": "low", "highest_reason": "high"},
    }
    assert signal_json(signal) == expected
    band.highest = np.inf
    assert signal_json(signal)["trusted"]["highest"] is None
