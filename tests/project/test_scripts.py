"""Every script tells what it does when it is asked for help, and does nothing else."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

PROJECT = Path(__file__).parents[2]
MARK = 'if __name__ == "__main__":'


def scripts() -> list[str]:
    found = []
    for folder in ("benchmarks", "scripts", "report"):
        for path in sorted((PROJECT / folder).rglob("*.py")):
            if path.name == "__main__.py" or MARK in path.read_text("utf-8").splitlines():
                found.append(path.relative_to(PROJECT).as_posix())
    return found


def test_there_are_scripts_to_look_at() -> None:
    assert {"benchmarks/run.py", "scripts/mutation/__main__.py", "report/twin/make_maps.py"} <= set(scripts())


@pytest.mark.parametrize("script", scripts())
def test_help_is_told_and_nothing_is_done(tmp_path: Path, script: str) -> None:
    (tmp_path / "build").mkdir()
    module = script.removesuffix(".py").removesuffix("/__main__").replace("/", ".")
    started = subprocess.run(
        [sys.executable, "-B", "-m", module, "--help"],
        cwd=tmp_path,
        env={**os.environ, "PYTHONPATH": str(PROJECT)},
        capture_output=True,
        text=True,
        timeout=60,
    )
    assert (started.returncode, started.stderr) == (0, "")
    assert started.stdout.startswith("usage: ")
    assert [path.name for path in tmp_path.iterdir()] == ["build"]
