"""Commands in a process of their own: streams that are closed or full, encodings, surroundings."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from tests.complaints import complaints
from trimmer.command_line.main import main

COMMAND = """
import sys
from trimmer.command_line.main import main
*before, last = "\\n".join(sys.argv[1:]).split("\\n;\\n")
for words in before:
    main(words.splitlines())
    print("ended")
sys.exit(main(last.splitlines()))
"""
"""One command, or several with a semicolon between them."""
C_LOCALE = {"LC_ALL": "C", "PYTHONIOENCODING": "ascii", "PYTHONUTF8": "0", "PYTHONCOERCECLOCALE": "0"}
NOWHERE = {"HOME": "/dev/null/nowhere", "TMPDIR": "/dev/null/nowhere", "XDG_CACHE_HOME": "/dev/null/nowhere"}
SIMULATED = ["simulate", "--drive", "110", "--amplitude", "1e-3", "--duration", "0.01"]


def run(
    folder: Path, *words: str, shell: str = "", alone: bool = False, **settings: str
) -> subprocess.CompletedProcess[str]:
    """Run a command by a shell, which redirects its streams and tells its exit code in a file ``code``.

    What only those are told who wait is left out, as it depends on the machine.
    """
    kept = {name: each for name, each in os.environ.items() if not alone or name in ("PATH", "PYTHONPATH")}
    done = subprocess.run(
        ["sh", "-c", f'{{ "$@"; echo $? >code; }} {shell}', "sh", sys.executable, "-c", COMMAND, *words],
        capture_output=True, cwd=folder, env={**kept, "PYTHONUNBUFFERED": "", **settings}, text=True,
        encoding="utf-8",
    )  # fmt: skip
    done.stderr = complaints(done.stderr)
    return done


def code(folder: Path) -> int:
    return int((folder / "code").read_text())


CLOSED = "trimmer: standard output is closed; send it to a file, or to /dev/null\n"
FULL = "trimmer: standard output: No space left on device; send the output elsewhere\n"


@pytest.mark.parametrize(
    ("words", "shell", "ended", "told"),
    [
        (["parameters"], ">&-", 2, CLOSED),
        (["linear", "--help"], ">&-", 2, CLOSED),
        (["parameters"], ">/dev/full", 2, FULL),
        (["parameters", "--output", "/dev/stdout", "--quiet"], ">/dev/full", 2, "space left on device"),
        (["parameters"], "| true", 0, ""),
        (["linear", "--help"], "| true", 0, ""),
        (["parameters"], "2>&- >/dev/null", 0, ""),
        (["linear", "--parameters", "-"], "<&-", 2, "-: cannot be read: standard input is closed"),
        (["linear", "--nonsense"], "2>&- <&-", 2, ""),
        (["linear", "--nonsense"], "2>&1 | true", 2, ""),
    ],
    ids=str,
)
def test_streams_that_nobody_reads(
    tmp_path: Path, words: list[str], shell: str, ended: int, told: str
) -> None:
    if not Path("/dev/full").exists():
        pytest.skip("needs /dev/full")
    done = run(tmp_path, *words, shell=shell)
    assert (code(tmp_path), done.stdout) == (ended, "")
    assert done.stderr == told or (told and told in done.stderr and done.stderr.count("\n") == 1)


def test_names_and_texts_in_any_letters_where_nothing_but_ascii_is_written_and_home_is_missing(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """One process for all four commands, as most of its time is imports; what is moved goes to its output."""
    (tmp_path / "a.csv").write_text("\n".join(["µ,x", *(f"{k % 5},0" for k in range(99))]), "utf-8")
    done = run(
        tmp_path, "linear", ";", *SIMULATED, "--csv", "/dev/stdout", ";",
        "linear", "--parameters", "ω\udcff.toml", ";", "spectrum", "a.csv", "--column", "µ", "--rate", "100",
        alone=True, COLUMNS="1", **NOWHERE, **C_LOCALE,
    )  # fmt: skip
    plain, moved, unread, spectrum = done.stdout.split("ended\n")
    assert (code(tmp_path), done.stdout.isascii()) == (0, True)
    assert main(["linear"]) == 0
    full = capsys.readouterr().out
    assert " ± " in full
    assert plain == full.replace("±", "+-")
    assert moved.startswith("time [s],q2-q4 [m],") and moved.count("\n") == 201
    *motion, refused = done.stderr.splitlines()
    assert motion[0].startswith("Motion of 0.01 s") and unread == ""
    assert refused.startswith("trimmer: ") and done.stderr.isascii()
    assert spectrum.startswith("u of a.csv")


@pytest.mark.skipif(not Path("/dev/stdout").exists(), reason="needs /dev/stdout")
def test_a_file_on_standard_output_stands_there_alone(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    loud, quiet = (
        run(tmp_path, "parameters", "--output", "/dev/stdout", *more) for more in ([], ["--quiet"])
    )
    assert loud.stdout == quiet.stdout != ""
    assert (loud.stderr, quiet.stderr) == ("wrote /dev/stdout\n", "")
    (tmp_path / "a.toml").symlink_to("/dev/stdout")
    run(tmp_path, "parameters", "--output", "a.toml", shell=">file")
    assert (tmp_path / "file").read_text("utf-8") == quiet.stdout
    run(tmp_path, "parameters", "--output", "mine.toml", shell=">mine.toml")  # what goes there already stays
    assert (tmp_path / "mine.toml").read_text("utf-8") == quiet.stdout
    monkeypatch.chdir(tmp_path)
    Path("a.wav").symlink_to("/dev/stdout")
    assert main([*SIMULATED, "--csv", "/dev/stdout", "--wav", "a.wav"]) == 2
    assert "both write /dev/stdout" in capsys.readouterr().err


@pytest.mark.skipif(not Path("/dev/zero").exists(), reason="needs /dev/zero")
def test_a_file_without_an_end(tmp_path: Path) -> None:
    done = run(tmp_path, "linear", "--parameters", "/dev/zero")
    assert (code(tmp_path), done.stdout, done.stderr.count("\n")) == (2, "", 1)
    assert "/dev/zero: cannot be read: a device that gives 64 MiB or more" in done.stderr


@pytest.mark.slow
def test_a_dash_prints_a_derived_module(tmp_path: Path, project_folder: Path) -> None:
    belt = str(project_folder / "examples" / "block-on-belt.toml")
    done = run(tmp_path, "derive", belt, "--module", "-", "--latex", "a.tex")
    assert done.stdout.startswith('"""Block on a belt in numbers.')
    assert "a.tex: derivation" in done.stderr
