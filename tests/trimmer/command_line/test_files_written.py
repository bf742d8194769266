"""Files that commands write: kept if they are the user's, and the same bytes each time."""

import os
import runpy
from pathlib import Path

import pytest

from tests.quick import quick
from trimmer.command_line.main import main

EXAMPLES = Path(__file__).parents[3] / "examples"
TWIN = str(EXAMPLES / "thesis-play.toml")
BEGINNINGS = {"svg": b"<?xml", "PNG": b"\x89PNG", "pdf": b"%PDF-"}
MOTION = ["simulate", TWIN, "--duration", "0.02"]
PICTURES = {
    **{f"a.{ending}": MOTION for ending in BEGINNINGS},
    "starts.svg": ["respond", TWIN, "--starts", "2"],
}


@pytest.fixture(autouse=True)
def folder(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Path:
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.mark.parametrize("name", quick(PICTURES, 0))
def test_a_picture_is_the_same_bytes_each_time(name: str, capsys) -> None:
    contents = []
    for _ in range(2):  # the second one over a picture of its kind
        assert main([*PICTURES[name], "--plot", name]) == 0
        assert capsys.readouterr().out.splitlines()[-1:] != []
        contents.append(Path(name).read_bytes())
    assert contents[0] == contents[1]
    assert contents[0].startswith(BEGINNINGS[name.partition(".")[2]])


def test_two_files_may_both_go_nowhere() -> None:
    Path("a.svg").symlink_to(os.devnull)
    assert main([*MOTION, "--csv", os.devnull, "--plot", "a.svg"]) == 0


@pytest.mark.slow
def test_what_does_not_repeat_is_told_and_drawn_too(capsys) -> None:
    words = ["--set", "frictions.blade.force=0", "--set", "plays.bridge.gap=0.2mm", "--periods", "64"]
    assert main(["respond", TWIN, *words, "--plot", "chaos.png"]) == 0
    told = capsys.readouterr().out
    assert "It is chaotic" in told and "figures are those of the window" in told and "95 %: " in told
    assert Path("chaos.png").stat().st_size > 10_000


@pytest.mark.parametrize("words", [["parameters", "--output"], ["init"]], ids=" ".join)
def test_a_first_file_is_kept_unless_it_is_empty(words: list[str], capsys) -> None:
    Path("a.toml").write_text("")
    assert main([*words, "a.toml"]) == 0
    assert Path("a.toml").read_text("utf-8")
    Path("a.toml").write_text("x")
    assert main([*words, "a.toml"]) == 2
    assert Path("a.toml").read_text() == "x"
    for name, target in (("one", "other"), ("other", "one"), ("gone", "nowhere")):
        Path(name).symlink_to(target)
    capsys.readouterr()
    for name in ("one", "gone"):
        assert main([*words, name]) == 2
        assert f"{name} is a symbolic link to " in capsys.readouterr().err
        assert Path(name).is_symlink() and not Path("nowhere").exists()


RECORD = "time [s],x [m]\n" + "".join(f"{at / 1000},{at % 7 / 1e3}\n" for at in range(2000))
BELT = str(EXAMPLES / "block-on-belt.toml")


@pytest.mark.parametrize(
    "words",
    [
        [*MOTION, "--plot", "a.svg"],
        [*MOTION, "--output", "stroke", "--wav", "a.wav"],
        ["spectrum", "record.csv", "--csv", "a.csv"],
        ["derive", BELT, "--latex", "other.tex", "--module", "a.py"],
        ["derive", BELT, "--module", "other.py", "--latex", "a.tex"],
        ["map", TWIN, "--vary", "frequency=60:61:2", "--periods", "2", "--output", "a.jsonl"],
    ],
    ids=lambda words: f"{words[0]} {words[-1]}",
)
def test_a_file_of_another_kind_is_replaced_only_if_asked(words: list[str]) -> None:
    Path("record.csv").write_text(RECORD)
    target = Path(words[-1])
    target.write_bytes(BEGINNINGS["pdf"])
    assert main(words) == 2
    assert target.read_bytes() == BEGINNINGS["pdf"]
    assert main([*words, "--overwrite"]) == 0
    assert not target.read_bytes().startswith(BEGINNINGS["pdf"])


def test_a_file_named_dash(folder: Path) -> None:
    assert main(["parameters", "--output", "./-"]) == 0
    assert (folder / "-").exists()
    assert main(["linear", "--parameters", "./-"]) == 0


@pytest.mark.parametrize("words", [["spectrum", "-"], ["linear", "--parameters", "-"]], ids=" ".join)
def test_standard_input_may_be_closed(words: list[str], monkeypatch, capsys) -> None:
    monkeypatch.setattr("sys.stdin", None)
    assert main(words) == 2
    assert capsys.readouterr().err.startswith("trimmer: -: cannot be read: standard input is closed; ")


@pytest.mark.parametrize("command", [["linear", "--parameters"], ["respond"], ["sample"], ["design"]])
def test_hundreds_of_problems_fit_on_a_screen(command: list[str], capsys) -> None:
    wrong = "".join(f"strange{number} = {number}\n" for number in range(500))
    bodies = "" if command[0] == "linear" else "[bodies]\na = { mass = 1 }\n"
    Path("many.toml").write_text(wrong + bodies, "utf-8")
    assert main([*command, "many.toml"]) == 2
    lines = capsys.readouterr().err.splitlines()
    assert 10 < len(lines) <= 20
    assert " 5" in lines[0] and "problems" in lines[0]
    assert " more: put these right first" in lines[-1]


def test_more_processes_than_there_are_processors(capsys) -> None:
    assert main(["map", TWIN, "--vary", "frequency=60:120:3", "--jobs", "99999"]) == 2
    assert "--jobs 99999: this computer has" in capsys.readouterr().err


def test_a_title_cannot_leave_the_docstring_nor_names_the_text_of_latex() -> None:
    """Both go into files that are run."""
    text = (
        (EXAMPLES / "block-on-belt.toml")
        .read_text("utf-8")
        .replace("spring =", '"50 % {x} _ \\\\input{y}" =')
    )
    Path("belt.toml").write_text(
        text.replace('"Block on a belt"', '\'"""\\; raise SystemExit("run") #\''), "utf-8"
    )
    assert main(["derive", "belt.toml", "--module", "module.py", "--latex", "a.tex"]) == 0
    module = runpy.run_path("module.py")
    assert "raise SystemExit" in module["__doc__"] and module["mass_matrix"]
    written = Path("a.tex").read_text("utf-8")
    assert r"$k_{1}$ & stiffness of 50 \% \{x\} \_ \textbackslash{}input\{y\} &" in written
    assert r"\input" not in written
