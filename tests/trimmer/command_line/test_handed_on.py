"""What commands hand on to the library, what of it they write and print, and which code they end with.

The library's functions are replaced: they keep what they are called with, and return results made by hand.
"""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from tests.trimmer import results
from trimmer.command_line.main import main
from trimmer.runners.processes import ProcessRunner
from trimmer.runners.runner import SerialRunner

EXAMPLES = Path(__file__).parents[3] / "examples"
TWIN = str(EXAMPLES / "thesis-play.toml")
GAP = "plays.bridge.gap"


class Called:
    """Stands for a function, keeps its arguments, and returns or raises what it was made with."""

    def __init__(self, result: Any = None) -> None:
        self.result = result
        self.arguments: tuple[Any, ...] = ()
        self.keywords: dict[str, Any] = {}

    def __call__(self, *arguments: Any, **keywords: Any) -> Any:
        self.arguments, self.keywords = arguments, keywords
        if isinstance(self.result, BaseException):
            raise self.result
        return self.result


@pytest.fixture
def replaced(monkeypatch: pytest.MonkeyPatch) -> Callable[..., Called]:
    def replace(place: str, result: Any = None) -> Called:
        called = Called(result)
        monkeypatch.setattr(place, called)
        return called

    return replace


@pytest.fixture
def written(monkeypatch: pytest.MonkeyPatch) -> list[Any]:
    """What is given to the writer of pictures, instead of a picture."""
    drawn: list[Any] = []
    monkeypatch.setattr(
        "trimmer.drawing.content.content_of", lambda figure, ending: drawn.append(figure) or b""
    )
    return drawn


def as_words(monkeypatch: pytest.MonkeyPatch, module: str) -> None:
    """Let a command tell its result in two words."""
    monkeypatch.setattr(f"trimmer.command_line.{module}.as_text", lambda *_: "told")
    monkeypatch.setattr(f"trimmer.command_line.{module}.as_json", lambda *_: "data")


def test_respond_hands_on_what_is_asked(replaced, written, monkeypatch, tmp_path: Path, capsys) -> None:
    found = SimpleNamespace(motion=SimpleNamespace(orbit=None, window=None))
    respond = replaced("trimmer.response.respond.respond", found)
    as_words(monkeypatch, "mechanisms.respond_text")
    replaced("trimmer.drawing.mechanisms.response.response_figure", "figure")
    picture = tmp_path / "a.svg"
    words = ["--state", "motor=1mm,2", "--starts", "3", "--periods", "77", "--seed", "5"]
    assert main(["respond", TWIN, *words, "--set", f"{GAP}=40um", "--plot", str(picture)]) == 0
    ((mechanism,), keywords) = respond.arguments, respond.keywords
    assert mechanism.value(GAP) == 40e-6
    assert keywords == {"state": {"motor": (1e-3, 2.0)}, "starts": 3, "most_periods": 77, "seed": 5}
    told = capsys.readouterr()
    assert (told.out, written) == ("told\n", [])
    assert f"{picture} was not written" in told.err
    assert main(["respond", TWIN, "--json"]) == 0
    assert respond.keywords == {"state": None, "starts": 1, "most_periods": 1000, "seed": 0}
    told = capsys.readouterr()
    assert (told.out, told.err) == ("data\n", "")
    for name in ("orbit", "window"):
        found.motion = SimpleNamespace(**{"orbit": None, "window": None, name: 1})
        assert main(["respond", TWIN, "--plot", str(picture)]) == 0
        assert capsys.readouterr() == ("told\n", "")
        picture.unlink()
    assert written == ["figure", "figure"]
    # What is told makes way for a picture on standard output, but only if there is one.
    monkeypatch.setattr("trimmer.command_line.file_options.is_standard_output", lambda path: True)
    for orbit, streams in ((1, ("", "told\n")), (None, ("told\n", None))):
        found.motion = SimpleNamespace(orbit=orbit, window=None)
        assert main(["respond", TWIN, "--plot", str(picture)]) == 0
        told = capsys.readouterr()
        assert told.out == streams[0]
        assert streams[1] is None or told.err == streams[1]


def test_respond_needs_a_use_of_its_seed(replaced, capsys) -> None:
    replaced("trimmer.response.respond.respond")
    assert main(["respond", TWIN, "--starts", "2", "--seed", "-1"]) == 2
    assert "--seed -1" in capsys.readouterr().err
    assert main(["respond", TWIN, "--seed", "0"]) == 2
    assert main(["respond", TWIN, "--starts", "1", "--seed", "1"]) == 2


def test_follow_hands_on_what_is_asked(replaced, written, monkeypatch, tmp_path: Path, capsys) -> None:
    branch = SimpleNamespace(points=[], success=True, message="ended")
    follow = replaced("trimmer.branches.follow.follow", branch)
    as_words(monkeypatch, "mechanisms.follow_text")
    figure = replaced("trimmer.drawing.mechanisms.branch.branch_figure", "figure")
    picture = tmp_path / "a.svg"
    words = ["follow", TWIN, "--vary", GAP, "--from", "40 um", "--to", "2e-4", "--plot", str(picture)]
    more = ["--periods", "3", "--points", "2", "--wait", "9", "--switches", "4", "--set", "frequency=60"]
    assert main([*words, *more]) == 0
    mechanism, *rest = follow.arguments
    assert mechanism.frequency == 60
    assert rest == [GAP, "40 um", 2e-4]
    settings = follow.keywords["settings"]
    assert follow.keywords["periods"] == 3
    assert (settings.most_points, settings.switches, settings.most_periods) == (2, 4, 9)
    assert (capsys.readouterr(), written) == (("told\n", ""), [])
    branch.points, branch.success = [1], False
    assert main([*words, "--json"]) == 3
    assert capsys.readouterr() == ("data\n", "trimmer: ended\n")
    assert figure.arguments == (branch,)
    assert written == ["figure"]
    settings = follow.keywords["settings"]
    assert (settings.most_points, settings.switches, settings.most_periods) == (2000, 1, 2000)
    follow.result = ValueError("no way")
    assert main(words) == 2
    assert "no way" in capsys.readouterr().err
    assert main([*words, "--points", "1"]) == 2


def made_map() -> SimpleNamespace:
    inputs = SimpleNamespace(mechanism=SimpleNamespace(title="title"))
    return SimpleNamespace(searched="all", inputs=inputs, plot=Called())


MAP = ["map", TWIN, "--vary", f"{GAP}=0:2e-4:3", "--vary", "frequency=60:120:2"]


def test_map_hands_on_what_is_asked(replaced, written, monkeypatch, tmp_path: Path, capsys) -> None:
    result, file = made_map(), tmp_path / "cells.map"
    motion_map = replaced("trimmer.maps.motion_map.motion_map", result)
    as_words(monkeypatch, "mechanisms.map_text")
    assert main([*MAP, "--jobs", "1"]) == 0
    assert capsys.readouterr() == ("told\n", "")
    _, values = motion_map.arguments
    assert values == {GAP: [0.0, 1e-4, 2e-4], "frequency": [60.0, 120.0]}
    expected = {"most_periods": 300, "starts": 1, "seed": 0, "runner": SerialRunner(), "file": None}
    expected |= {"resume": False, "overwrite": False, "quiet": False}
    assert motion_map.keywords == expected
    words = [
        "--periods",
        "2",
        "--starts",
        "4",
        "--seed",
        "7",
        "--output",
        str(file),
        "--overwrite",
        "--quiet",
    ]
    assert main([*MAP, *words, "--jobs", "2"]) == 0
    assert capsys.readouterr() == (f"told\nwrote {file}\n", "")
    expected = {"most_periods": 2, "starts": 4, "seed": 7, "runner": ProcessRunner(2), "file": file}
    assert motion_map.keywords == expected | {"resume": False, "overwrite": True, "quiet": True}
    picture = tmp_path / "map.svg"
    picture.write_bytes(b"other")
    assert main([*MAP, "--plot", str(picture), "--overwrite", "--json"]) == 0
    assert capsys.readouterr().out == "data\n"
    assert (motion_map.keywords["overwrite"], motion_map.keywords["runner"]) == (False, None)
    assert (written[0].get_suptitle(), result.plot.keywords) == ("title", {"curves": ()})


def test_map_looks_for_more_if_asked(replaced, written, monkeypatch, tmp_path: Path, capsys) -> None:
    replaced("trimmer.maps.motion_map.motion_map", made_map())
    more = made_map()
    found = SimpleNamespace(result=more, searched="beside")
    coexisting = replaced("trimmer.maps.coexistence.coexisting_motions", found)
    curves = SimpleNamespace(drawn=(("fold", [[0, 0], [1, 1]]),))
    special = replaced("trimmer.maps.special_curves.special_curves", curves)
    told = []
    module = "trimmer.command_line.mechanisms.map_text"
    monkeypatch.setattr(f"{module}.as_text", lambda *given: told.append(given) or "told")
    picture = tmp_path / "map.svg"
    words = ["--coexisting", "--special", "3", "--plot", str(picture)]
    assert main([*MAP, *words]) == 0
    assert told == [(more, "beside", curves)]
    assert capsys.readouterr().out == f"told\nwrote {picture}\n"
    assert coexisting.keywords == {"runner": None, "quiet": False}
    assert special.arguments == (more,)
    assert special.keywords == {"lines": 3, "runner": ProcessRunner(chunk=1), "quiet": False}
    assert more.plot.keywords == {"curves": curves.drawn}
    assert main([*MAP, "--special", "1", "--jobs", "2"]) == 0
    assert special.keywords["runner"] == ProcessRunner(2, 1)
    assert told[-1][1] == "all"
    for wrong in (["--periods", "1"], ["--starts", "0"], ["--starts", "2", "--seed", "-1"]):
        assert main([*MAP, *wrong]) == 2
    assert main([*MAP[:4], "--special", "1"]) == 2


def test_what_map_is_told_to_vary_is_even() -> None:
    from trimmer.command_line.mechanisms.map_options import _count, _spaced

    assert _spaced(1.0, -2.0, 4) == [1.0, 0.0, -1.0, -2.0]
    assert [_count("", text) for text in ("2", "100000")] == [2, 100_000]
    for text in ("1", "100001", "1000000000000", ""):
        with pytest.raises(ValueError, match="number of values"):
            _count("", text)


SCATTER = str(EXAMPLES / "scatter.toml")


def test_sample_hands_on_what_is_asked(replaced, written, monkeypatch, tmp_path: Path, capsys) -> None:
    study = SimpleNamespace(samples="samples")
    studied = replaced("trimmer.uncertainty.study.study_samples", study)
    as_words(monkeypatch, "mechanisms.sample_text")
    figure = replaced("trimmer.drawing.mechanisms.scatter.sample_figure", "figure")
    assert main(["sample", SCATTER]) == 0
    assert capsys.readouterr() == ("told\n", "")
    assert written == []
    _, settings = studied.arguments
    assert (settings.count, settings.plan.word, settings.seed, settings.most_periods) == (
        512,
        "latin-hypercube",
        0,
        300,
    )
    keeping = studied.keywords.pop("keeping")
    assert (keeping.path, keeping.resume, keeping.overwrite) == (None, False, False)
    assert studied.keywords == {"indices": False, "balanced": 0, "runner": None, "quiet": False}
    file, picture = tmp_path / "a.samples", tmp_path / "a.svg"
    words = ["--count", "8", "--plan", "sobol", "--seed", "3", "--periods", "9", "--balance", "2"]
    words += ["--output", str(file), "--overwrite", "--jobs", "1", "--plot", str(picture), "--json"]
    assert main(["sample", SCATTER, *words]) == 0
    assert capsys.readouterr() == ("data\n", "")
    assert (figure.arguments, written) == (("samples",), ["figure"])
    _, settings = studied.arguments
    assert (settings.count, settings.plan.word, settings.seed, settings.most_periods) == (8, "sobol", 3, 9)
    keeping = studied.keywords.pop("keeping")
    assert (keeping.path, keeping.resume, keeping.overwrite) == (file, False, True)
    assert studied.keywords["balanced"] == 2
    studied.result = KeyboardInterrupt()
    assert main(["sample", SCATTER, "--output", str(file), "--resume"]) == 130
    assert str(file) in capsys.readouterr().err
    assert main(["sample", SCATTER]) == 130
    assert "interrupted" in capsys.readouterr().err
    for wrong in (["--seed", "-1"], ["--indices", "--plan", "sobol"], ["--channels", "both"], ["--resume"]):
        assert main(["sample", SCATTER, *wrong]) == 2


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
    orbits.result = ValueError("no way")
    assert main(["orbits", *PLAY]) == 2
    assert "no way" in capsys.readouterr().err


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


def test_a_first_file_is_written_and_kept(tmp_path: Path, capsys) -> None:
    file = tmp_path / "a.toml"
    assert main(["init", str(file)]) == 0
    assert capsys.readouterr().out.startswith(f"wrote {file};")
    text = file.read_text("utf-8")
    assert main(["init", str(file), "--example", "gear-pair"]) == 2
    assert file.read_text("utf-8") == text
    file.write_text("")
    assert main(["init", str(file), "--example", "gear-pair"]) == 0
    assert file.read_text("utf-8") not in ("", text)


def test_results_as_they_are_told_can_be_read(capsys) -> None:
    assert main(["linear", "--json"]) == 0
    content = json.loads(capsys.readouterr().out)
    summary = results.summary()
    assert content["stable"] is True
    assert content["modes"][0]["frequency"] == pytest.approx(summary.modes[0].frequency)
