"""Wrong use of every kind gives exit code 2 and one sentence that says what to do."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from trimmer.command_line.main import main

PLAY = ["--element", "friction", "--gap", "4e-5"]
IDENTIFY = ["identify", "--gap", "4e-5", "--frequency", "740"]
DRIVEN = ["simulate", "--drive", "110", "--amplitude", "1e-3"]
CODE = "import sys; from trimmer.command_line.main import main; sys.exit(main(sys.argv[1:]))"


def told(capsys: pytest.CaptureFixture[str], *words: str) -> str:
    try:
        code = main(list(words))
    except SystemExit as stopped:
        code = stopped.code
    shown = capsys.readouterr()
    assert (code, shown.out) == (2, "")
    assert shown.err.startswith("trimmer: ")
    assert shown.err.count("\n") == 1
    return shown.err.removeprefix("trimmer: ").strip()


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "empty.toml").write_text(" \n")
    (tmp_path / "empty.csv").write_text("")
    (tmp_path / "binary").write_bytes(bytes(range(256)))
    (tmp_path / "folder").mkdir()
    return tmp_path


READERS = [["linear", "--parameters"], ["respond"], ["simulate"], ["derive"], ["spectrum"]]


@pytest.mark.parametrize("reader", READERS, ids=" ".join)
def test_a_file_that_cannot_be_read(folder: Path, capsys, reader: list[str]) -> None:
    assert "missing: no such file; " in told(capsys, *reader, "missing")
    assert "folder: is a folder; name the file" in told(capsys, *reader, "folder")
    kind = "csv" if reader == ["spectrum"] else "toml"
    assert f"empty.{kind}: is empty; " in told(capsys, *reader, f"empty.{kind}")
    assert f"; did you mean empty.{kind}?" in told(capsys, *reader, f"emty.{kind}")
    assert "binary" in told(capsys, *reader, "binary")


@pytest.mark.skipif(not Path("/dev/zero").exists(), reason="needs /dev/zero")
@pytest.mark.parametrize("reader", READERS[:2] + READERS[-1:], ids=" ".join)
def test_a_file_without_an_end(capsys, monkeypatch, reader: list[str]) -> None:
    monkeypatch.setattr("trimmer.files.MOST_OF_A_DEVICE", 1 << 20)
    assert "/dev/zero: cannot be read: a device that gives 1 MiB or more; name a file" in told(
        capsys, *reader, "/dev/zero"
    )


@pytest.mark.parametrize("value", ["nan", "inf", "-inf", "-1", "0", "-0", "1e400"])
@pytest.mark.parametrize(
    ("words", "option"),
    [
        (["limit-cycles", "--element", "friction"], "--gap"),
        (["limit-cycles", "--element", "relay"], "--force"),
        (["identify", "--gap", "4e-5"], "--frequency"),
        ([*DRIVEN], "--duration"),
        ([*DRIVEN, "--csv", "a.csv"], "--sample-rate"),
        (["simulate", "--amplitude", "1"], "--drive"),
        (["spectrum", "a.csv"], "--rate"),
        (["spectrum", "a.csv"], "--gap"),
    ],
)
def test_a_number_that_cannot_be_meant(capsys, words: list[str], option: str, value: str) -> None:
    message = told(capsys, *words, option, value)
    assert option in message
    assert "positive" in message


@pytest.mark.parametrize(
    ("words", "message"),
    [
        ([*IDENTIFY, "--uncertainty", "nan"], "--uncertainty nan: must be zero or positive"),
        ([*IDENTIFY, "--uncertainty", "741"], "--uncertainty 741: must be zero or positive"),
        ([*IDENTIFY, "--uncertainty", "-1"], "--uncertainty -1: must be zero or positive"),
        (["spectrum", "a.csv", "--limit", "9" * 30], "is not a positive whole number up to 1000000000"),
        (["spectrum", "a.csv", "--limit", "٣"], "is not a positive whole number"),
        (["map", "a.toml", "--seed", "9" * 30], "is more than 1000000000, the largest"),
        (["simulate", "--drive", "1e308", "--amplitude", "1"], "'1e308' is beyond what can be computed with"),
        (["linear", "--json=3"], "ignored explicit argument '3'"),
        (["limit-cycles", *PLAY, "--plot", "folder"], "must end in .svg, .png, .pdf"),
        ([*DRIVEN, "--wav", "folder.wav"], "folder.wav is a folder: name a file in it"),
        ([*DRIVEN, "--csv", "binary"], "binary is there already and is no CSV file"),
        (
            ["parameters", "--output", "binary/mine.toml"],
            "a file stands where its folder would be; name another",
        ),
        (["parameters", "--output", "a" * 300], ": File name too long; name another "),
        (["parameters", "--output", "-"], "'-' is no file; write /dev/stdout"),
    ],
    ids=lambda each: " ".join(each)[:60] if isinstance(each, list) else "",
)
def test_what_cannot_be_done(folder: Path, capsys, words: list[str], message: str) -> None:
    (folder / "folder.wav").mkdir()
    assert message in told(capsys, *words)


@pytest.mark.parametrize(("value", "size"), [("1e308", "large"), ("5e-324", "small")])
def test_a_frequency_without_a_finite_period(
    project_folder: Path, folder: Path, capsys, value: str, size: str
) -> None:
    text = (project_folder / "examples" / "thesis-play.toml").read_text("utf-8")
    Path("machine.toml").write_text(text.replace("frequency = 110.0", f"frequency = {value}"), "utf-8")
    assert f"frequency = {value}" in Path("machine.toml").read_text("utf-8")
    assert f": is too {size}: its " in told(capsys, "simulate", "machine.toml")


def test_too_little_memory(capsys, monkeypatch) -> None:
    def fail(*_: object, **__: object) -> None:
        raise MemoryError("Unable to allocate 3.5 TiB")

    monkeypatch.setattr("trimmer.balance.identification.identify_time_constant", fail)
    assert told(capsys, *IDENTIFY) == (
        "there is not enough memory for that (Unable to allocate 3.5 TiB); ask for less"
    )


def test_control_characters_in_a_name_do_not_reach_the_terminal(capsys) -> None:
    assert r"a\x1b[2J.csv: no such file" in told(capsys, "spectrum", "a\x1b[2J.csv")


@pytest.mark.parametrize(
    "words",
    [
        ["parameters"],
        pytest.param(["linear"], marks=pytest.mark.slow),  # Matplotlib looks for all fonts again
        pytest.param(["limit-cycles", *PLAY], marks=pytest.mark.slow),
    ],
    ids=" ".join,
)
def test_neither_home_nor_a_place_to_write_is_needed(project_folder: Path, words: list[str]) -> None:
    kept = {name: value for name, value in os.environ.items() if name in ("PATH", "PYTHONPATH")}
    nowhere = {"HOME": "/dev/null/nowhere", "XDG_CACHE_HOME": "/dev/null/nowhere", "LC_ALL": "C"}
    done = subprocess.run(
        [sys.executable, "-c", CODE, *words],
        capture_output=True,
        cwd=project_folder,
        env={**kept, **nowhere, "PYTHONUTF8": "0", "PYTHONCOERCECLOCALE": "0"},
        check=False,
    )
    assert (done.returncode, done.stderr) == (0, b"")
    assert done.stdout


@pytest.mark.parametrize("command", [["linear", "--parameters"], ["respond"], ["sample"], ["design"]])
def test_thousands_of_problems_fit_on_a_screen(folder: Path, capsys, command: list[str]) -> None:
    wrong = "".join(f"strange{number} = {number}\n" for number in range(5000))
    bodies = "" if command[0] == "linear" else "[bodies]\na = { mass = 1 }\n"
    Path("many.toml").write_text(wrong + bodies, "utf-8")
    assert main([*command, "many.toml"]) == 2
    lines = capsys.readouterr().err.splitlines()
    assert 10 < len(lines) <= 20
    assert " 50" in lines[0] and "problems" in lines[0]
    assert " more: put these right first" in lines[-1]


def test_thousands_of_words_without_use_are_counted(capsys) -> None:
    message = told(capsys, "linear", *("word" for _ in range(5000)))
    assert "'word' and 4995 words more have no use here" in message
    assert len(message) < 200


SIMULATED = [*DRIVEN, "--duration", "0.05", "--csv", "out.csv"]
STRANGE = {
    "TMPDIR": "/dev/null/nowhere",
    "HOME": "/dev/null/nowhere",
    "LC_ALL": "C",
    "PYTHONIOENCODING": "ascii",
    "PYTHONUTF8": "0",
    "COLUMNS": "1",
}


@pytest.mark.parametrize("words", [["linear"], ["map", "--help"], SIMULATED], ids=" ".join)
@pytest.mark.parametrize("out", ["read", "full", "closed"])
def test_strange_surroundings(tmp_path: Path, words: list[str], out: str) -> None:
    if not Path("/dev/full").exists():
        pytest.skip("needs /dev/full")
    place = {"read": "out", "full": "/dev/full", "closed": "out"}[out]
    kept = {name: value for name, value in os.environ.items() if name in ("PATH", "PYTHONPATH")}
    again = [sys.executable, "-c", CODE, *words]
    shut = f"import os; os.close(1); os.execv({sys.executable!r}, {again!r})"
    program = shut if out == "closed" else CODE
    with (tmp_path / place).open("wb") as stream:
        done = subprocess.run(
            [sys.executable, "-c", program, *words],
            cwd=tmp_path,
            env={**kept, **STRANGE},
            stdout=stream,
            stderr=subprocess.PIPE,
            check=False,
        )
    told = done.stderr.decode("ascii").splitlines()
    if out == "read":
        assert (done.returncode, told) == (0, [])
        assert (tmp_path / place).read_bytes().decode("ascii")
    else:
        assert done.returncode == 2
        assert len(told) == 1 and told[0].startswith("trimmer: standard output")
