"""What the commands on mechanisms hand on to the library, write and print, and which code they end with."""

from __future__ import annotations

import json
from pathlib import Path
from types import SimpleNamespace

import pytest

from tests.complaints import complaints
from tests.trimmer import results
from tests.trimmer.command_line.handed_on import Called, as_words
from trimmer.command_line.main import main
from trimmer.runners.processes import ProcessRunner
from trimmer.runners.runner import SerialRunner

EXAMPLES = Path(__file__).parents[3] / "examples"
TWIN = str(EXAMPLES / "thesis-play.toml")
GAP = "plays.bridge.gap"


def test_respond_hands_on_what_is_asked(replaced, written, monkeypatch, tmp_path: Path, capsys) -> None:
    found = SimpleNamespace(motion=SimpleNamespace(orbit=None, window=None, rest=None, linear=None))
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
        found.motion = SimpleNamespace(
            **{"orbit": None, "window": None, "rest": None, "linear": None, name: 1}
        )
        assert main(["respond", TWIN, "--plot", str(picture)]) == 0
        assert capsys.readouterr() == ("told\n", "")
        picture.unlink()
    assert written == ["figure", "figure"]
    # What is told makes way for a picture on standard output, but only if there is one.
    monkeypatch.setattr("trimmer.command_line.file_options.is_standard_output", lambda path: True)
    for orbit, streams in ((1, ("", "told\n")), (None, ("told\n", None))):
        found.motion = SimpleNamespace(orbit=orbit, window=None, rest=None, linear=None)
        assert main(["respond", TWIN, "--plot", str(picture)]) == 0
        told = capsys.readouterr()
        assert told.out == streams[0]
        assert streams[1] is None or complaints(told.err) == streams[1]


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
    told = capsys.readouterr()
    assert (told.out, written) == ("told\n", [])
    assert told.err == f"trimmer: {picture} was not written, because there is no motion on the branch\n"
    branch.points, branch.success = [1], False
    assert main([*words, "--json"]) == 3
    assert capsys.readouterr() == ("data\n", "trimmer: ended\n")
    assert figure.arguments == (branch,)
    assert written == ["figure"]
    settings = follow.keywords["settings"]
    assert (settings.most_points, settings.switches, settings.most_periods) == (2000, 1, 2000)
    told = []
    monkeypatch.setattr(
        "trimmer.command_line.mechanisms.follow_text.as_text", lambda *given: told.append(given) or ""
    )
    assert main([*words, "--harmonics", "5"]) == 3
    assert told == [(branch, 5)]
    capsys.readouterr()
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
    special.result = KeyboardInterrupt()
    capsys.readouterr()
    file = tmp_path / "cells.map"
    for more, kept in (([], "is lost; name a file"), (["--output", str(file)], f"is in {file}; the same")):
        assert main([*MAP, "--special", "1", *more]) == 130
        told = capsys.readouterr()
        assert (told.out, told.err.split("; the map ")[1][: len(kept)]) == ("", kept)
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
    assert capsys.readouterr().err == "trimmer: interrupted before the result was complete\n"
    for wrong in (["--seed", "-1"], ["--indices", "--plan", "sobol"], ["--channels", "both"], ["--resume"]):
        assert main(["sample", SCATTER, *wrong]) == 2


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
