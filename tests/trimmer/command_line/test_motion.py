"""``trimmer simulate`` and ``trimmer orbits``."""

from __future__ import annotations

import json
import warnings
import wave
from dataclasses import replace
from pathlib import Path

import control
import pytest

from tests.complaints import complaints
from trimmer import InertiaBacklash, harmonic_balance, periodic_orbits
from trimmer.command_line.loops.orbits_text import as_json, as_text
from trimmer.command_line.main import main
from trimmer.parameters import TrimmerParameters

PLAY = ["simulate", "--element", "friction", "--gap", "4e-6", "--channels", "displacement"]
CLOSED = [*PLAY, "--impulse", "1e-6"]
DRIVEN = ["simulate", "--element", "friction", "--gap", "2e-4", "--drive", "110", "--amplitude", "0.0015"]


def test_closed_loop_ends_on_the_limit_cycle(capsys: pytest.CaptureFixture[str]) -> None:
    assert main([*CLOSED, "--json"]) == 0
    content = json.loads(capsys.readouterr().out)
    assert content["outcome"] == "completed"
    # Exact orbit: 8.28949 gap at 733.568 Hz (tests/trimmer/orbits).
    assert content["last_frequency"] == pytest.approx(733.568, rel=1e-4)
    assert content["last_amplitudes"]["pin"] == pytest.approx(8.28949 * 4e-6, rel=1e-3)
    play = content["last_amplitudes"]["pin"] - content["last_amplitudes"]["bridge"]
    assert play == pytest.approx(2e-6, rel=1e-4)
    times = [event["time"] for event in content["events"]]
    assert times == sorted(times)
    assert {event["kind"] for event in content["events"]} == {"impact", "separation"}


def test_text_counts_the_events(capsys: pytest.CaptureFixture[str]) -> None:
    assert main([*DRIVEN, "--friction", "q2-q4=0.5", "--friction", "q3=0.1", "--duration", "0.1"]) == 0
    shown = capsys.readouterr().out
    assert "reached the end" in shown
    assert "x impact" in shown
    assert "friction q2-q4" in shown
    assert "friction q3" in shown
    assert "per second" not in shown


def test_files_read_back_in_the_spectrum(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    table, sound = tmp_path / "motion.csv", tmp_path / "motion.wav"
    assert main([*DRIVEN, "--duration", "1", "--csv", str(table), "--wav", str(sound)]) == 0
    with wave.open(str(sound)) as file:
        assert file.getframerate() >= 8000
        assert file.getnframes() / file.getframerate() == pytest.approx(1.0, abs=0.01)
    printed = capsys.readouterr().out.splitlines()
    assert printed[-2:] == [f"wrote {table}", f"wrote {sound}"]
    assert main(["spectrum", str(table), "--column", "q2-q4", "--drive", "110", "--json"]) == 0
    assert json.loads(capsys.readouterr().out)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["simulate"], "without --element and --drive nothing happens"),
        (["simulate", "--element", "friction", "--gap", "1e-6"], "stays at rest: give --impulse"),
        ([*PLAY, "--impulse", "nan"], "--impulse nan: must be finite"),
        ([*CLOSED, "--duration", "nan"], "--duration nan"),
        ([*CLOSED, "--duration", "-1"], "--duration -1"),
        ([*CLOSED, "--sample-rate", "1e15", "--csv", "a.csv"], "samples; give 2 to"),
        (["simulate", "--drive", "110"], "--amplitude (m) is missing"),
        (["simulate", "--amplitude", "1"], "--drive (Hz) is missing"),
        (
            ["simulate", "--drive", "-1", "--amplitude", "1"],
            "--drive -1: drive must be positive and finite (Hz)",
        ),
        ([*DRIVEN, "--friction", "q2"], "such as q2-q4=0.5"),
        ([*DRIVEN, "--friction", "q2=x"], "--friction q2=x: 'x' is not a number (N)"),
        ([*DRIVEN, "--friction", "q2-q2=1"], "--friction q2-q2=1"),
        ([*DRIVEN, "--friction", "q2-q4=-1"], "--friction q2-q4=-1"),
        (["simulate", "--element", "coulomb", "--force", "1", "--impulse", "1"], "two more poles than zeros"),
        (["orbits", "--element", "friction"], "needs --gap"),
    ],
)
def test_wrong_use_says_what_to_do(
    arguments: list[str], message: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(arguments) == 2
    assert message in capsys.readouterr().err


def test_orbits_stand_beside_their_predictions(capsys: pytest.CaptureFixture[str]) -> None:
    chosen = ["orbits", "--element", "friction", "--gap", "4e-6", "--channels", "displacement"]
    assert main(chosen) == 0
    shown = capsys.readouterr().out
    assert "733.568" in shown
    assert "733.631" in shown
    assert main([*chosen, "--json"]) == 0
    orbits = json.loads(capsys.readouterr().out)["orbits"]
    assert [orbit["stable"] for orbit in orbits] == [True, False]
    assert orbits[0]["amplitude"] == pytest.approx(8.28949 * 4e-6, rel=1e-6)


def test_orbits_name_the_option_that_looks_for_more(capsys: pytest.CaptureFixture[str]) -> None:
    chosen = ["orbits", "--element", "friction", "--gap", "4e-6", "--channels", "displacement"]
    assert main(chosen) == 0
    shown = capsys.readouterr().out
    assert "(--simulate)" in shown
    assert "OrbitSearch" not in shown
    assert main([*chosen, "--simulate"]) == 0
    assert "stable orbits by simulation from 32 initial states" in capsys.readouterr().out


def test_orbits_say_what_was_searched(capsys: pytest.CaptureFixture[str]) -> None:
    chosen = ["orbits", "--element", "coulomb", "--force", "0.5", "--channels", "displacement"]
    assert main(chosen) == 0
    shown = capsys.readouterr().out
    assert "searched: harmonic balance, which predicts no limit cycle; all orbits of the relay" in shown
    assert "32 came to rest" in shown
    assert main([*chosen, "--json"]) == 0
    content = json.loads(capsys.readouterr().out)
    assert content["orbits"] == []
    assert content["search"] in shown


def test_an_orbit_without_prediction_stands_in_the_table() -> None:
    system, element = control.ss(control.tf([20, 8.5], [1, 4.7, 0])), InertiaBacklash(0.64)
    answer = element, harmonic_balance(system, element), periodic_orbits(system, element)
    assert "0.150344" in as_text(*answer)
    (entry,) = json.loads(as_json(*answer))["orbits"]
    assert entry["amplitude"] == pytest.approx(0.150344, rel=1e-5)
    assert (entry["amplitude_error"], entry["frequency_error"]) == (None, None)


def test_orbits_state_where_their_predictions_are_undecided(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    # Without damping G is real, so -1/G lies on the real axis, which N meets at infinite amplitude.
    undamped = replace(TrimmerParameters.thesis(), c1=0.0, c2=0.0, c3=0.0, c4=0.0)
    (tmp_path / "undamped.toml").write_text(undamped.to_toml())
    chosen = ["orbits", "--element", "friction", "--gap", "4e-5"]
    chosen += ["--parameters", str(tmp_path / "undamped.toml")]
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert main(chosen) == 0
        printed = capsys.readouterr()
        assert "undecided: 1394.27979 to 1394.27979 rad/s" in printed.out
        assert complaints(printed.err) == ""
        assert main([*chosen, "--json"]) == 0
    undecided = json.loads(capsys.readouterr().out)["certificate"]["undecided"]
    assert [region["amplitudes"][1] for region in undecided] == [None] * len(undecided)
    assert undecided[0]["omegas"][0] == pytest.approx(1394.27979)
