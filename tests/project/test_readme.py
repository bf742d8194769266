"""The README's examples do what it says."""

from __future__ import annotations

import re
import shlex
import subprocess
import sys
from pathlib import Path

import pytest


@pytest.fixture(scope="module")
def readme(project_folder: Path) -> str:
    return (project_folder / "README.md").read_text(encoding="utf-8")


def test_python_examples_print_what_is_shown(readme: str) -> None:
    examples = re.findall(r"```python\n(.*?)```", readme, flags=re.DOTALL)
    shown = re.findall(r"```text\n(.*?)```", readme, flags=re.DOTALL)
    assert len(examples) == 3
    for example, output in zip(examples, shown, strict=True):
        ended = subprocess.run([sys.executable, "-c", example], capture_output=True, text=True, check=True)
        assert ended.stdout == output


def test_command_line_examples_run(readme: str, tmp_path: Path) -> None:
    lines = re.findall(r"^    (trimmer .*)$", readme, flags=re.MULTILINE)
    assert len(lines) == 9
    start = "import sys; from trimmer.command_line.main import main; sys.exit(main(sys.argv[1:]))"
    for line in lines:
        command = [sys.executable, "-c", start, *shlex.split(line)[1:]]
        ended = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True)
        assert ended.returncode == 0, f"{line}: {ended.stderr}"


def test_files_it_points_at_are_there(readme: str, project_folder: Path) -> None:
    targets = re.findall(r"\]\(([^)#:]+)\)", readme)
    assert [target for target in targets if not (project_folder / target).exists()] == []


def test_make_targets_it_names_exist(readme: str, project_folder: Path) -> None:
    makefile = (project_folder / "Makefile").read_text(encoding="utf-8")
    named = set(re.findall(r"\bmake (report|test|benchmark|lint|[a-z-]+(?=`))", readme))
    assert {"report", "test", "benchmark"} <= named
    assert [name for name in named if not re.search(rf"^{name}:", makefile, flags=re.MULTILINE)] == []
