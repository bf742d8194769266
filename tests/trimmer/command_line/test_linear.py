from __future__ import annotations

import json
from pathlib import Path

import pytest

from trimmer.command_line.main import main
from trimmer.displacement import Body, Displacement
from trimmer.linear.model import InputChannels
from trimmer.linear.summary import summarise
from trimmer.parameters import TrimmerParameters

THESIS = TrimmerParameters.thesis()
UNDAMPED = THESIS.to_toml()
for symbol, value in (("c1", 3.5), ("c2", 0.4), ("c3", 1.0), ("c4", 4.0)):
    UNDAMPED = UNDAMPED.replace(f"{symbol} = {value}", f"{symbol} = 0")


def as_json(capsys: pytest.CaptureFixture[str], *arguments: str) -> dict:
    assert main(["linear", "--json", *arguments]) == 0
    return json.loads(capsys.readouterr().out)


def test_json_holds_the_summary_in_full_precision(capsys) -> None:
    printed = as_json(capsys, "--output", "q1", "--channels", "displacement")
    summary = summarise(THESIS, Displacement(Body.MOTOR), InputChannels.DISPLACEMENT_ONLY)
    assert printed["parameters"] == vars(THESIS)
    assert (printed["output"], printed["channels"], printed["stable"]) == ("q1", "displacement", True)
    assert [complex(*mode["eigenvalue"]) for mode in printed["modes"]] == [
        m.eigenvalue for m in summary.modes
    ]
    assert tuple(complex(*pole) for pole in printed["poles"]) == summary.factored.poles
    assert tuple(complex(*zero) for zero in printed["zeros"]) == summary.factored.zeros
    assert printed["static_gain"] == summary.factored.static_gain
    assert tuple(printed["gain_crossings"]) == summary.gain_crossings
    assert [peak["omega"] for peak in printed["peaks"]] == [peak.omega for peak in summary.peaks]
    assert printed["bandwidth"] == summary.low_pass.bandwidth
    assert printed["roll_off"] == summary.roll_off
    assert printed["encirclements"] == summary.encirclements


def test_by_default_it_is_cutter_against_guard_with_both_channels(capsys) -> None:
    printed = as_json(capsys)
    assert (printed["output"], printed["channels"]) == ("q2-q4", "both")
    assert printed["gain_crossings"][-1] == pytest.approx(4634.910642473724, rel=1e-12)


def test_json_has_null_for_what_is_infinite(tmp_path: Path, capsys) -> None:
    path = tmp_path / "undamped.toml"
    path.write_text(UNDAMPED)
    printed = as_json(capsys, "--parameters", str(path))
    assert printed["stable"] is False
    assert [peak["magnitude"] for peak in printed["peaks"]].count(None) == 4


def test_text_names_the_numbers_of_the_thesis(capsys) -> None:
    assert main(["linear", "--channels", "displacement"]) == 0
    printed = capsys.readouterr().out
    assert printed.startswith("Linear trimmer: output q2-q4, pin acts by displacement only, stable\n")
    for shown in (
        *("-541.645 ± 7159.7j", "-80.5896 ± 3453.17j", "-41.8148 ± 2229.51j", "-24.9984 ± 1397.06j"),
        *("4632.88", "0.956938", "2361.56", "-40 dB per decade", "encirclements of -1  0"),
    ):
        assert shown in printed
    assert max(map(len, printed.splitlines())) <= 100


def test_text_shows_an_undamped_trimmer(tmp_path: Path, capsys) -> None:
    path = tmp_path / "undamped.toml"
    path.write_text(UNDAMPED)
    assert main(["linear", "--parameters", str(path), "--output", "q2"]) == 0
    printed = capsys.readouterr().out
    assert "not asymptotically stable" in printed
    assert "Crossings of the real axis\n  none" in printed


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--output", "q2+q4"], "'q2+q4' is not a displacement"),
        (["--output", "q2-q2"], "q2-q2 is zero"),
        (["--parameters", "no such file.toml"], "no such file.toml: no such file"),
    ],
)
def test_what_the_user_got_wrong_is_one_line_and_exit_code_2(capsys, arguments, message) -> None:
    assert main(["linear", *arguments]) == 2
    printed = capsys.readouterr()
    assert printed.out == ""
    assert printed.err.startswith(f"trimmer: {message}")
    assert printed.err.count("\n") == 1


def test_problems_of_a_parameter_file_are_listed(tmp_path: Path, capsys) -> None:
    path = tmp_path / "mine.toml"
    path.write_text(THESIS.to_toml().replace("m1 = 0.035", "m1 = nan").replace("k5", "k6"))
    assert main(["linear", "--parameters", str(path)]) == 2
    printed = capsys.readouterr().err
    assert f"{path}: 3 problems" in printed
    assert "k6 = 1000.0: unknown key" in printed


def test_a_pin_that_touches_nothing_is_reported(tmp_path: Path, capsys) -> None:
    path = tmp_path / "open.toml"
    path.write_text(THESIS.to_toml().replace("k2 = 30000.0", "k2 = 0").replace("c2 = 0.4", "c2 = 0"))
    assert main(["linear", "--parameters", str(path)]) == 2
    assert "does not reach its output" in capsys.readouterr().err
