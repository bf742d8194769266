"""What a shell offers: by the script for bash run in bash, by what the others hold."""

import shutil
import subprocess
from pathlib import Path

import pytest

from trimmer.command_line.completion import SHELLS
from trimmer.command_line.main import installed_commands, main

ASK = """
source "$1"; shift
COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); COMPREPLY=()
_shtab_trimmer
printf '%s\\n' "${COMPREPLY[@]}"
"""
needs_bash = pytest.mark.skipif(shutil.which("bash") is None, reason="needs bash")


def script(capsys: pytest.CaptureFixture[str], shell: str) -> str:
    assert main(["completion", shell]) == 0
    told = capsys.readouterr()
    assert told.err == ""
    return told.out


@pytest.fixture
def offered(tmp_path: Path, capsys: pytest.CaptureFixture[str]):
    """Return what bash offers for the last of some words, in a folder with files of all kinds."""
    path = tmp_path / "completion.sh"
    path.write_text(script(capsys, "bash"))
    there = tmp_path / "there"
    (there / "folder").mkdir(parents=True)
    for name in ("a.toml", "b.csv", "c.svg", "d.wav", "e.txt", "two words.toml"):
        (there / name).write_text("")

    def ask(*words: str) -> set[str]:
        command = ["bash", "--norc", "-c", ASK, "bash", str(path), "trimmer", *words]
        done = subprocess.run(command, capture_output=True, text=True, cwd=there, check=True)
        assert done.stderr == ""
        return set(done.stdout.split("\n")) - {""}

    return ask


@needs_bash
@pytest.mark.parametrize(
    ("words", "expected"),
    [
        (["li"], {"linear", "limit-cycles"}),
        (["linear", "--ch"], {"--channels"}),
        (["linear", "--channels", ""], {"displacement", "both"}),
        (["linear", "--output", "q2-"], {"q2-q1", "q2-q3", "q2-q4"}),
        (["limit-cycles", "--gap", "1", "--element", "f"], {"friction"}),
        (["linear", "--parameters", ""], {"a.toml", "two words.toml", "folder"}),
        (["respond", ""], {"a.toml", "two words.toml", "folder"}),
        (["simulate", "--json", "a"], {"a.toml"}),
        (["spectrum", ""], {"b.csv", "d.wav", "e.txt", "folder"}),
        (["spectrum", "b.csv", "--plot", ""], {"c.svg", "folder"}),
        (["spectrum", "b.csv", "--wav", ""], {"d.wav", "folder"}),
        (["report", "--thesis", "e"], {"e.txt"}),
        (["report", "--directory", ""], {"folder"}),
        (["completion", ""], set(SHELLS)),
    ],
    ids=lambda each: " ".join(each) if isinstance(each, list) else "",
)
def test_bash_offers_what_fits(offered, words: list[str], expected: set[str]) -> None:
    assert offered(*words) == expected


@needs_bash
def test_bash_offers_every_command_and_option(offered, capsys: pytest.CaptureFixture[str]) -> None:
    commands = {command.name for command in installed_commands()}
    assert offered("") == commands
    for name in commands:
        with pytest.raises(SystemExit):
            main([name, "--help"])
        shown = capsys.readouterr().out
        options = offered(name, "--")
        assert {"--help", "--quiet"} <= options
        assert all(option in shown for option in options)


@pytest.mark.parametrize(("shell", "begins"), [("zsh", "#compdef trimmer"), ("tcsh", "# AUTOMATICALLY")])
def test_the_other_scripts_know_commands_options_and_files(
    capsys: pytest.CaptureFixture[str], shell: str, begins: str
) -> None:
    text = script(capsys, shell)
    assert text.startswith(begins)
    for word in ("limit-cycles", "channels", "displacement", "*.toml", "*.csv"):
        assert word in text


@pytest.mark.parametrize("shell", ["zsh", "tcsh"])
def test_the_other_scripts_are_read_by_their_shell(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], shell: str
) -> None:
    if shutil.which(shell) is None:
        pytest.skip(f"needs {shell}")
    path = tmp_path / "script"
    path.write_text(script(capsys, shell))
    check = subprocess.run([shell, "-n", str(path)], capture_output=True, text=True, check=False)
    assert (check.returncode, check.stderr) == (0, "")
