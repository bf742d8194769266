"""``trimmer fit``: what it tells, writes and refuses."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from tests.json_document import documented, keys
from tests.trimmer.fitting.made import record, trimmer
from trimmer import Mechanism, Signal, write_signal
from trimmer.command_line.main import main

FREE = ["--free", "plays.bridge.gap", "--free", "frictions.blade.force", "--starts", "1"]


@pytest.fixture(scope="module")
def folder(tmp_path_factory) -> Path:
    folder: Path = tmp_path_factory.mktemp("fit")
    signal = record(trimmer(), 2e-6)
    write_signal(folder / "measured.csv", signal)
    (folder / "mine.toml").write_text(trimmer().to_toml())
    hum = 1e-4 * np.cos(2 * np.pi * 50 * signal.times)
    clipped = np.clip(signal.values + hum, -1.2e-3, 1.2e-3)
    write_signal(folder / "clipped.csv", Signal(clipped, signal.sample_rate, "stroke", "m"))
    write_signal(folder / "two.csv", *(Signal(signal.values, signal.sample_rate, name, "m") for name in "ab"))
    return folder


def refused(capsys, *words: object) -> str:
    assert main(["fit", *map(str, words)]) == 2
    printed = capsys.readouterr()
    assert printed.out == "" and printed.err.count("\n") == 1
    return str(printed.err)


def test_a_fit_is_told_drawn_and_written(capsys, folder: Path) -> None:
    words = [folder / "mine.toml", folder / "measured.csv", "--set", "plays.bridge.gap=50um", *FREE]
    written, picture = folder / "fitted.toml", folder / "fit.svg"
    assert main(["fit", *map(str, words), "--output", str(written), "--plot", str(picture)]) == 0
    told = capsys.readouterr().out
    assert "interval of 95 %" in told and "explains the measurement within its noise" in told
    assert "one start alone was tried" in told and f"wrote {written}" in told
    fitted = Mechanism.from_toml(written)
    assert fitted.value("plays.bridge.gap") == pytest.approx(40e-6, rel=0.02)
    assert picture.read_text().startswith("<?xml")


def test_keys_are_those_of_the_document(capsys, folder: Path) -> None:
    words = [
        "fit",
        str(folder / "mine.toml"),
        str(folder / "clipped.csv"),
        *FREE[:2],
        "--starts",
        "1",
        "--json",
    ]
    assert main(words) == 0
    printed = json.loads(capsys.readouterr().out)
    assert any("clipped" in note for note in printed["notes"]) and not printed["explained"]
    assert "more than noise is left at harmonics" in " ".join(printed["judgement"])
    known = {each.replace("NAME", "stroke") for each in documented("trimmer fit")}
    empty = {"outputs.stroke.gaps", "weak"}
    unseen = {each for each in known if each.startswith(("outputs.stroke.gaps[]", "weak[]"))}
    assert set(keys(printed)) - empty == known - unseen


def test_what_cannot_be_used_is_refused_in_a_sentence(capsys, folder: Path) -> None:
    mine, measured = folder / "mine.toml", folder / "measured.csv"
    assert "no column is named 'speed'" in refused(capsys, mine, measured, "--column", "speed")
    assert "there are 3 columns" in refused(capsys, mine, folder / "two.csv")
    assert "did you mean stroke?" in refused(capsys, mine, measured, "--column", "strok=2")
    assert "7.71 periods" in refused(capsys, mine, measured, "--until", "0.07")
    assert "explain only" in refused(capsys, mine, measured, "--set", "frequency=131")
    assert "did you mean plays.bridge.gap" in refused(capsys, mine, measured, "--free", "plays.bridge.gaps")
    assert "is the file of the measurement" in refused(capsys, mine, measured, "--output", measured)
    assert "clipped" in refused(capsys, mine, folder / "clipped.csv", "--clipped", "refuse")
    told = refused(capsys, mine, measured, "--unit", "mm")
    assert "the heading says that stroke is in m, not in mm" in told
