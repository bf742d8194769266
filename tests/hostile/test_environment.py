"""What stands in the environment ends no command with a traceback."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

CODE = "import sys; from trimmer.command_line.main import main; sys.exit(main(sys.argv[1:]))"
COMMANDS = [["linear"], ["respond", "--periods", "2"], ["design"]]
OSCILLATOR = str(Path(__file__).parents[2] / "examples" / "den-hartog.toml")


def run(folder: Path, words: list[str], date: str) -> subprocess.CompletedProcess[str]:
    command = words if words == ["linear"] else [words[0], OSCILLATOR, *words[1:]]
    variables = {**os.environ, "SOURCE_DATE_EPOCH": date}
    return subprocess.run(
        [sys.executable, "-c", CODE, *command], cwd=folder, env=variables, capture_output=True, text=True
    )


@pytest.mark.parametrize("date", ["abc", "1e5", "-5", "9" * 14])
@pytest.mark.parametrize("words", COMMANDS, ids=" ".join)
def test_a_wrong_date_is_told_by_every_command(tmp_path: Path, words: list[str], date: str) -> None:
    done = run(tmp_path, words, date)
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr == (
        f"trimmer: SOURCE_DATE_EPOCH={date!r} in the environment is no date: give seconds since 1970, or "
        "unset it\n"
    )


def test_an_empty_date_is_none(tmp_path: Path) -> None:
    assert run(tmp_path, ["linear"], "").returncode == 0
