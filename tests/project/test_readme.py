"""The README's examples do what it says."""

from __future__ import annotations

import re
import shlex
import shutil
from pathlib import Path

import pytest

from trimmer.command_line.main import main


@pytest.fixture(scope="module")
def readme(project_folder: Path) -> str:
    return (project_folder / "README.md").read_text(encoding="utf-8")


def test_python_examples_print_what_is_shown(readme: str, capsys: pytest.CaptureFixture[str]) -> None:
    examples = re.findall(r"```python\n(.*?)```", readme, flags=re.DOTALL)
    shown = re.findall(r"```text\n(.*?)```", readme, flags=re.DOTALL)
    assert len(examples) == 3
    for example, output in zip(examples, shown, strict=True):
        exec(compile(example, "README.md", "exec"), {"__name__": "__main__"})
        assert capsys.readouterr().out == output


def test_command_line_examples_run(
    readme: str,
    project_folder: Path,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    """Run in this process: what every command imports takes longer than what it does."""
    lines = re.findall(r"^    (trimmer .*)$", readme, flags=re.MULTILINE)
    assert len(lines) == 13
    shutil.copytree(project_folder / "examples", tmp_path / "examples")
    monkeypatch.chdir(tmp_path)
    for line in lines:
        assert main(shlex.split(line)[1:]) == 0, f"{line}: {capsys.readouterr().err}"


def test_files_it_points_at_are_there(readme: str, project_folder: Path) -> None:
    targets = re.findall(r"\]\(([^)#:]+)\)", readme)
    assert [target for target in targets if not (project_folder / target).exists()] == []


def test_make_targets_it_names_exist(readme: str, project_folder: Path) -> None:
    makefile = (project_folder / "Makefile").read_text(encoding="utf-8")
    named = set(re.findall(r"\bmake (report|test|benchmark|lint|[a-z-]+(?=`))", readme))
    assert {"report", "test", "benchmark"} <= named
    assert [name for name in named if not re.search(rf"^{name}:", makefile, flags=re.MULTILINE)] == []
