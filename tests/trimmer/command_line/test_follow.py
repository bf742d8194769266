"""``trimmer follow``."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest

from tests.json_document import documented, keys
from trimmer.command_line.main import main

EXAMPLES = Path(__file__).parents[3] / "examples"
TWIN = ["follow", str(EXAMPLES / "thesis-play.toml"), "--set", "frictions.blade.force=1"]
BREAKING = [*TWIN, "--vary", "frequency", "--from", "120", "--to", "120.8 Hz"]


def test_json_has_the_keys_of_the_document(capsys: pytest.CaptureFixture[str]) -> None:
    varied = ["--vary", "frequency", "--from", "120.4", "--to", "120.56", "--points", "90", "--json"]
    assert main([*TWIN, *varied]) == 3
    content = json.loads(capsys.readouterr().out)
    assert content["reason"] == "most-points"
    (special,) = content["special"]
    assert special["kind"] == "symmetry-breaking"
    assert special["value"] == pytest.approx(120.5173085846, rel=1e-10)
    (asymmetric,) = content.pop("branches")
    assert asymmetric["parted"] == special
    assert asymmetric.keys() == {*content, "branches"}
    assert set(content["points"][0]["outputs"]["stroke"]) == {"peak_to_peak", "harmonics", "advance"}
    of_balance = {"points[].balance.distance", "points[].balance.converged"}
    named = set(keys(content, {"points[].outputs"})) - {"points[].balance"}
    assert named == documented("trimmer follow") - of_balance - {"branches", "points[].balance"}


def test_json_tells_harmonic_balance(capsys: pytest.CaptureFixture[str]) -> None:
    options = ["--harmonics", "3", "--points", "2", "--switches", "0", "--json"]
    assert main([*BREAKING, *options]) == 3
    for point in json.loads(capsys.readouterr().out)["points"]:
        assert point["balance"]["converged"] is True
        assert 0.0 < point["balance"]["distance"] < 1.0


def test_text_tells_stretches_special_points_and_the_end(capsys: pytest.CaptureFixture[str]) -> None:
    assert main([*BREAKING, "--switches", "0"]) == 0
    shown = capsys.readouterr().out
    (count,) = re.findall(
        r"Periodic motions over frequency \(Hz\): (\d+) orbits with the drive's period", shown
    )
    stretches = re.findall(r"^  \S+ +\S+ +(\d+) +(?:yes|no) ", shown, re.MULTILINE)
    assert len(stretches) == 2
    assert sum(map(int, stretches)) == int(count)
    assert "symmetry-breaking  120.517308585" in shown
    assert "End: it leaves the interval at the other end, at 120.8" in shown


def test_plot(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "branch.svg"
    assert main([*BREAKING, "--points", "5", "--switches", "0", "--plot", str(file)]) == 3
    assert file.read_bytes().startswith(b"<?xml")
    first = file.read_bytes()
    assert main([*BREAKING, "--points", "5", "--switches", "0", "--plot", str(file)]) == 3
    assert file.read_bytes() == first
    capsys.readouterr()


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (["--vary", "plays.bridge.gab", "--from", "0", "--to", "1"], "gab"),
        (["--vary", "plays.bridge.gap", "--from", "3 kg", "--to", "1"], "kg"),
        (["--vary", "plays.bridge.gap", "--from", "-1e-6", "--to", "1e-4"], "plays.bridge.gap"),
        (["--vary", "frequency", "--from", "110", "--to", "110"], "interval"),
        (["--vary", "plays.bridge.gap=1", "--from", "1", "--to", "2"], "'plays.bridge.gap=1' is no place"),
        (
            ["--vary", "frequency", "--from", "110", "--to", "120", "--points", "1"],
            "--points 1: give a whole",
        ),
    ],
)
def test_wrong_use(options: list[str], message: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main([*TWIN, *options]) == 2
    error = capsys.readouterr().err
    assert message in error
    assert error.count("\n") == 1


def test_what_does_not_settle_ends_with_a_sentence(capsys: pytest.CaptureFixture[str]) -> None:
    smooth = ["--set", "frictions.blade.force=0"]
    file = str(EXAMPLES / "thesis-play.toml")
    code = main(["follow", file, *smooth, "--vary", "frequency", "--from", "110", "--to", "120"])
    assert code == 3
    assert "has not settled within" in capsys.readouterr().err


BELT = ["follow", str(EXAMPLES / "block-on-belt.toml"), "--vary", "pins.belt.velocity"]


def test_what_moves_by_itself_tells_its_period(capsys: pytest.CaptureFixture[str]) -> None:
    assert main([*BELT, "--from", "200 mm/s", "--to", "0.25"]) == 0
    shown = capsys.readouterr().out
    assert "orbits with a period of their own" in shown
    assert "period, s" in shown
    assert main([*BELT, "--from", "200 mm/s", "--to", "0.25", "--json"]) == 0
    content = json.loads(capsys.readouterr().out)
    assert content["period_count"] == 1
    first = content["points"][0]
    assert first["period"] == pytest.approx(8.902605407815, rel=1e-12)
    assert sorted(abs(complex(*each)) for each in first["multipliers"]) == pytest.approx(
        [0.0, 1.0], abs=1e-12
    )
    assert first["stable"] is True
    assert first["outputs"]["block"]["peak_to_peak"] == pytest.approx(2 * 0.538516480713, rel=1e-11)


def test_what_moves_by_itself_is_drawn(tmp_path: Path) -> None:
    file = tmp_path / "belt.svg"
    assert main([*BELT, "--from", "0.2", "--to", "0.25", "--plot", str(file)]) == 0
    assert b"<svg" in file.read_bytes()


@pytest.mark.parametrize("option", ["--periods", "--harmonics", "--wait"])
def test_options_of_a_drive_are_refused_without_one(option: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main([*BELT, "--from", "0.2", "--to", "0.25", option, "2"]) == 2
    assert f"{option} has no effect without a frequency in the file" in capsys.readouterr().err


def test_a_frequency_that_is_not_there_is_not_varied(capsys: pytest.CaptureFixture[str]) -> None:
    arguments = ["follow", str(EXAMPLES / "block-on-belt.toml"), "--vary", "frequency"]
    assert main([*arguments, "--from", "1", "--to", "2"]) == 2
    assert "frequency: the mechanism has none; it moves by itself" in capsys.readouterr().err
