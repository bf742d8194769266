"""What stands in the environment ends no command with a traceback."""

import subprocess
import sys
from pathlib import Path

import pytest

from tests.hostile.commands import called

CODE = "import sys; from trimmer.command_line.main import main; sys.exit(main(sys.argv[1:]))"
OSCILLATOR = str(Path(__file__).parents[2] / "examples" / "den-hartog.toml")
COMMANDS = [["linear"], ["respond", OSCILLATOR, "--periods", "2"], ["design", OSCILLATOR]]


@pytest.mark.parametrize("date", ["abc", "1e5", "-5", "9" * 14])
@pytest.mark.parametrize("words", COMMANDS, ids=["linear", "respond", "design"])
def test_a_wrong_date_is_told_by_every_command(monkeypatch, capsys, words: list[str], date: str) -> None:
    monkeypatch.setenv("SOURCE_DATE_EPOCH", date)
    code, out, told = called(capsys, *words)
    assert (code, out) == (2, "")
    assert told == (
        f"trimmer: SOURCE_DATE_EPOCH={date!r} in the environment is no date: give seconds since 1970, or "
        "unset it\n"
    )


def test_an_empty_date_is_none(monkeypatch, capsys) -> None:
    monkeypatch.setenv("SOURCE_DATE_EPOCH", "")
    assert called(capsys, "linear")[0] == 0


@pytest.mark.parametrize("words", [("design",), ("compare", OSCILLATOR)], ids=["design", "compare"])
def test_a_cluster_that_is_not_there_is_told_before_any_work(tmp_path: Path, capsys, words) -> None:
    folder = tmp_path / "out"
    code, out, told = called(capsys, *words, OSCILLATOR, "--scheduler", "no://a", "--directory", str(folder))
    assert (code, out, told.count("\n")) == (2, "", 1)
    assert "no Dask scheduler answers" in told or "needs the package distributed" in told
    assert not folder.exists()


def test_a_package_that_hides_ours_is_named(tmp_path: Path) -> None:
    (tmp_path / "report").mkdir()
    (tmp_path / "report" / "__init__.py").touch()
    code = f"import sys; sys.path.insert(0, {str(tmp_path)!r})\n{CODE}"
    done = subprocess.run(
        [sys.executable, "-c", code, "design", OSCILLATOR], cwd=tmp_path, capture_output=True, text=True
    )
    assert done.returncode == 2
    assert f"{tmp_path / 'report' / '__init__.py'} hides the package: give it another name" in done.stderr
    assert "Traceback" not in done.stderr
