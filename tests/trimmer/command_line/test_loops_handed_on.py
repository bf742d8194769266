"""What the commands on loops hand on to the library, write and print, and which code they end with."""

from __future__ import annotations

from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

from tests.trimmer.command_line.handed_on import Called, as_words
from trimmer.command_line.main import main

EXAMPLES = Path(__file__).parents[3] / "examples"
TWIN = str(EXAMPLES / "thesis-play.toml")
SCATTER = str(EXAMPLES / "scatter.toml")


def test_samples_of_a_loop_have_options_of_their_own(replaced, monkeypatch, capsys) -> None:
    read = replaced("trimmer.uncertainty.loop_samples.read_loop_file", "file")
    sampled = replaced("trimmer.uncertainty.loop_samples.sample_loop", "samples")
    as_words(monkeypatch, "mechanisms.loop_sample_text")
    assert main(["sample", SCATTER, "--gap", "4e-5", "--indices"]) == 0
    assert read.arguments == (Path(SCATTER), 4e-5)
    assert sampled.arguments[0] == "file"
    assert sampled.keywords == {"indices": True, "channels": "both"}
    assert main(["sample", SCATTER, "--gap", "4e-5", "--channels", "displacement", "--json"]) == 0
    assert sampled.keywords == {"indices": False, "channels": "displacement"}
    assert capsys.readouterr().out == "told\ndata\n"
    for wrong in (["--balance", "2"], ["--jobs", "1"], ["--plot", "a.svg"]):
        assert main(["sample", SCATTER, "--gap", "4e-5", *wrong]) == 2


def test_identify_hands_on_what_is_measured(replaced, written, monkeypatch, tmp_path: Path, capsys) -> None:
    identify = replaced(
        "trimmer.balance.identification.identify_time_constant", SimpleNamespace(plot=Called())
    )
    module = "trimmer.command_line.loops.limit_cycles_text"
    monkeypatch.setattr(f"{module}.identified_as_text", lambda _: "told")
    monkeypatch.setattr(f"{module}.identified_as_json", lambda _: "data")
    words = ["identify", "--gap", "4e-5", "--frequency", "740"]
    assert main(words) == 0
    assert capsys.readouterr() == ("told\n", "")
    assert identify.arguments[1:] == (4e-5, 740.0)
    assert identify.keywords == {"frequency_uncertainty": 0.0}
    picture = tmp_path / "a.svg"
    assert main([*words, "--uncertainty", "2", "--json", "--plot", str(picture)]) == 0
    assert capsys.readouterr() == ("data\n", "")
    assert identify.keywords == {"frequency_uncertainty": 2.0}
    assert len(written) == 1
    for wrong in ("740", "-1", "nan"):
        assert main([*words, "--uncertainty", wrong]) == 2
    identify.result = ValueError("no way")
    assert main(words) == 2
    assert "no way" in capsys.readouterr().err
    assert main([*words[:2], "0", *words[3:]]) == 2
    assert main([*words[:4], "0"]) == 2


PLAY = ["--element", "friction", "--gap", "4e-5"]


def test_limit_cycles_are_searched_where_they_are_asked_for(
    replaced, written, monkeypatch, tmp_path: Path, capsys
) -> None:
    balance = replaced("trimmer.balance.solve.harmonic_balance", "balance")
    figure = replaced("trimmer.drawing.locus.balance_figure", "figure")
    as_words(monkeypatch, "loops.limit_cycles_text")
    assert main(["limit-cycles", *PLAY]) == 0
    loop, omegas = balance.arguments
    assert (loop.element.gap, omegas) == (4e-5, None)
    words = ["--omega-range", "10", "1e3", "--json", "--plot", str(tmp_path / "a.svg")]
    assert main(["limit-cycles", *PLAY, *words]) == 0
    assert balance.arguments[1] == (10.0, 1e3)
    assert (figure.arguments, written) == (("balance",), ["figure"])
    assert capsys.readouterr() == ("told\ndata\n", "")
    for wrong in (("10", "10"), ("0", "10"), ("10", "inf"), ("20", "10")):
        assert main(["limit-cycles", *PLAY, "--omega-range", *wrong]) == 2


def test_orbits_hand_on_their_search_and_say_when_they_were_interrupted(
    replaced, written, monkeypatch, tmp_path: Path, capsys
) -> None:
    from trimmer.orbits.search import OrbitSearchInterrupted, Simulations

    replaced("trimmer.balance.solve.harmonic_balance", "predictions")
    orbits = replaced("trimmer.orbits.periodic_orbits.periodic_orbits", [])
    as_words(monkeypatch, "loops.orbits_text")
    picture = tmp_path / "a.svg"
    assert main(["orbits", *PLAY, "--plot", str(picture)]) == 0
    assert (orbits.arguments[1], orbits.keywords) == ("predictions", {"search": None})
    assert f"{picture} was not written" in capsys.readouterr().err
    interrupt = OrbitSearchInterrupted.__new__(OrbitSearchInterrupted)
    interrupt.orbits = []
    orbits.result = interrupt
    assert main(["orbits", *PLAY, "--simulate", "--json"]) == 130
    assert orbits.keywords["search"].simulations is Simulations.ALWAYS
    told = capsys.readouterr()
    assert told.out == "data\n"
    assert "interrupted" in told.err
    assert not written
    orbits.result = []
    assert main(["orbits", *PLAY, "--simulate"]) == 0
    assert capsys.readouterr() == ("told\n", "")
    orbits.result = ValueError("no way")
    assert main(["orbits", *PLAY]) == 2
    assert "no way" in capsys.readouterr().err


def test_the_picture_of_orbits_may_go_to_standard_output(
    replaced, written, monkeypatch, tmp_path: Path, capsys
) -> None:
    class Found(list[object]):
        plot = Called()

    replaced("trimmer.balance.solve.harmonic_balance", "predictions")
    replaced("trimmer.orbits.periodic_orbits.periodic_orbits", Found([1]))
    as_words(monkeypatch, "loops.orbits_text")
    picture = tmp_path / "a.svg"
    monkeypatch.setattr("trimmer.command_line.file_options.is_standard_output", lambda path: path == picture)
    assert main(["orbits", *PLAY, "--plot", str(picture)]) == 0
    assert capsys.readouterr() == ("", "told\n")
    assert main(["orbits", *PLAY]) == 0
    assert capsys.readouterr() == ("told\n", "")
    assert len(written) == 1


def test_linear_hands_on_what_is_asked(replaced, written, monkeypatch, tmp_path: Path, capsys) -> None:
    summarise = replaced("trimmer.linear.summary.summarise", "summary")
    figure = replaced("trimmer.drawing.frequency_response.summary_figure", "figure")
    as_words(monkeypatch, "loops.linear_text")
    assert main(["linear"]) == 0
    assert (summarise.arguments[1].label, summarise.arguments[2]) == ("q2-q4", "both")
    words = ["--output", "q3", "--channels", "displacement", "--json", "--plot", str(tmp_path / "a.svg")]
    assert main(["linear", *words]) == 0
    assert (summarise.arguments[1].label, summarise.arguments[2]) == ("q3", "displacement")
    assert (figure.arguments, written) == (("summary",), ["figure"])
    assert capsys.readouterr() == ("told\ndata\n", "")


def test_a_motion_is_as_long_as_asked_and_files_are_named(
    replaced, written, monkeypatch, tmp_path: Path, capsys
) -> None:
    motion = SimpleNamespace(
        success=True, duration=0.1, message="stopped", mechanism=SimpleNamespace(frequency=None)
    )
    simulate = replaced("trimmer.response.simulate.simulate", motion)
    as_words(monkeypatch, "mechanisms.motion_text")
    figure = replaced("trimmer.drawing.mechanisms.response.motion_figure", "figure")
    picture = tmp_path / "a.svg"
    words = ["simulate", TWIN, "--duration", "0.25", "--state", "motor=1um,-3", "--plot", str(picture)]
    assert main(words) == 0
    assert simulate.arguments[1:] == (0.25,)
    assert simulate.keywords == {"state": {"motor": (pytest.approx(1e-6), -3.0)}}
    assert capsys.readouterr() == (f"told\nwrote {picture}\n", "")
    assert (figure.arguments, written) == ((motion,), ["figure"])
    motion.success = False
    assert main([*words, "--json"]) == 3
    told = capsys.readouterr()
    assert told.out == "data\n"
    assert "only 0.1 s of 0.25 s: stopped" in told.err
    from trimmer.motion.motion import Outcome

    motion.outcome = Outcome.INTERRUPTED
    assert main(words[:2]) == 130
    assert simulate.arguments[1:] == (0.5,)


def test_signals_are_sampled_as_asked(replaced, monkeypatch, tmp_path: Path, capsys) -> None:
    mechanism = SimpleNamespace(outputs={"a": 1, "b": 2}, frequency=None)
    motion = SimpleNamespace(
        success=True,
        duration=0.01,
        mechanism=mechanism,
        output=lambda name, times: times + {"a": 1.0, "b": 20.0}[name],
    )
    replaced("trimmer.response.simulate.simulate", motion)
    as_words(monkeypatch, "mechanisms.motion_text")
    csv, wav = tmp_path / "a.csv", tmp_path / "a.wav"
    write_wav = replaced("trimmer.signals.wav.write_wav")
    words = ["--duration", "0.01", "--sample-rate", "500", "--csv", str(csv), "--wav", str(wav)]
    assert main(["simulate", TWIN, *words]) == 0
    assert capsys.readouterr() == (f"told\nwrote {csv}\nwrote {wav}\n", "")
    rows = np.loadtxt(csv, delimiter=",", skiprows=1)
    times = np.arange(5) / 500
    np.testing.assert_allclose(rows.T, [times, times + 1.0, times + 20.0])
    path, values, rate = write_wav.arguments
    assert (path, rate, write_wav.keywords) == (wav, 500.0, {"overwrite": False})
    np.testing.assert_allclose(values, times + 1.0)
    assert main(["simulate", TWIN, *words, "--overwrite"]) == 0
    assert write_wav.keywords == {"overwrite": True}
    capsys.readouterr()
    motion.mechanism.frequency = 400.0  # which 500 samples per second cannot show
    assert main(["simulate", TWIN, *words]) == 0
    assert capsys.readouterr().err.startswith("trimmer: note: ")
    for wrong in (["--duration", "0.003"], ["--duration", "2e5"]):
        assert main(["simulate", TWIN, *wrong, "--sample-rate", "500", "--csv", str(csv)]) == 2
    assert main(["simulate", TWIN, "--sample-rate", "500"]) == 2
    assert main(["simulate", TWIN, "--duration", "0.004", "--sample-rate", "500", "--csv", str(csv)]) == 0


def test_impulse_and_drive_of_a_loop(replaced, monkeypatch, capsys) -> None:
    motion = SimpleNamespace(success=True, duration=0.5)
    simulate = replaced("trimmer.motion.simulation.simulate_loop", motion)
    as_words(monkeypatch, "loops.motion_text")
    assert main(["simulate", *PLAY, "--impulse", "-2e-6", "--friction", "q2-q4=0.5"]) == 0
    loop, duration = simulate.arguments
    assert (loop.drive, loop.element.gap, duration) == (None, 4e-5, 0.5)
    assert [(each.between.label, each.law.force) for each in loop.frictions] == [("q2-q4", 0.5)]
    assert simulate.keywords == {"impulse": -2e-6}
    words = ["simulate", "--drive", "110", "--amplitude", "1.5e-3", "--channels", "displacement"]
    assert main([*words, "--output", "q3"]) == 0
    loop, _ = simulate.arguments
    assert (loop.drive.frequency, loop.drive.amplitude, loop.element) == (pytest.approx(110.0), 1.5e-3, None)
    assert (str(loop.channels.value), simulate.keywords) == ("displacement", {"impulse": 0.0})
    assert main([*words[:4], "0"]) == 0  # an amplitude of nothing is one
    for wrong in (
        [*PLAY],
        [*PLAY, "--impulse", "inf"],
        ["--drive", "110"],
        ["--amplitude", "1"],
        ["--drive", "0", "--amplitude", "1"],
        ["--drive", "110", "--amplitude", "-1"],
        ["--drive", "110", "--amplitude", "inf"],
        ["--gap", "4e-5", "--drive", "110", "--amplitude", "1"],
        [*PLAY, "--impulse", "1", "--friction", "q2-q4"],
        [*PLAY, "--impulse", "1", "--friction", "q2-q4=a"],
        [*PLAY, "--impulse", "1", "--friction", "q2-q4=-1"],
    ):
        assert main(["simulate", *wrong]) == 2, wrong
    simulate.result = ValueError("no way")
    capsys.readouterr()
    assert main(["simulate", *PLAY, "--impulse", "1"]) == 2
    assert "no way" in capsys.readouterr().err
