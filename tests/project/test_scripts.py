"""Every script tells what it does when it is asked for help, and does nothing else."""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

PROJECT = Path(__file__).parents[2]
MARK = 'if __name__ == "__main__":'
IN_TURN = """
import contextlib, io, json, os, pathlib, runpy, sys
told = {}
for module in sys.argv[1:]:
    folder = pathlib.Path(module)
    (folder / "build").mkdir(parents=True)
    sys.argv = [module, "--help"]
    # What an earlier script has imported of this one is not what is asked for here.
    sys.modules.pop(module, None)
    with (
        contextlib.chdir(folder),
        contextlib.redirect_stdout(io.StringIO()) as out,
        contextlib.redirect_stderr(io.StringIO()) as err,
    ):
        try:
            runpy.run_module(module, run_name="__main__", alter_sys=True)
            code = 0
        except SystemExit as ended:
            code = ended.code or 0
    told[module] = [code, err.getvalue(), out.getvalue(), os.listdir(folder)]
print(json.dumps(told))
"""
"""Runs modules one after another in one process: alone, each would spend its time on the same imports."""


def scripts() -> list[str]:
    """Return all but the programs of peers, which ``make peers`` runs, each by a Python that has the peer."""
    found = []
    for folder in ("benchmarks", "scripts", "report"):
        for path in sorted((PROJECT / folder).rglob("*.py")):
            if path.match("peers/with_*.py"):
                continue
            if path.name == "__main__.py" or MARK in path.read_text("utf-8").splitlines():
                found.append(path.relative_to(PROJECT).as_posix())
    return found


def module_of(script: str) -> str:
    return script.removesuffix(".py").removesuffix("/__main__").replace("/", ".")


def started(folder: Path, *words: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-B", *words],
        cwd=folder,
        env={**os.environ, "PYTHONPATH": str(PROJECT)},
        capture_output=True,
        text=True,
        timeout=120,
    )


@pytest.fixture(scope="module")
def told(tmp_path_factory: pytest.TempPathFactory) -> dict[str, list[object]]:
    """Exit code, errors, output and what is in the folder afterwards, by the name of the module."""
    modules = [module_of(script) for script in scripts()]
    done = started(tmp_path_factory.mktemp("scripts"), "-c", IN_TURN, *modules)
    assert (done.returncode, done.stderr) == (0, "")
    found: dict[str, list[object]] = json.loads(done.stdout)
    return found


def test_there_are_scripts_to_look_at() -> None:
    assert {"benchmarks/run.py", "scripts/mutation/__main__.py", "report/twin/make_maps.py"} <= set(scripts())


@pytest.mark.slow
@pytest.mark.parametrize("script", scripts())
def test_help_is_told_and_nothing_is_done(told: dict[str, list[object]], script: str) -> None:
    code, errors, output, left = told[module_of(script)]
    assert (code, errors) == (0, "")
    assert str(output).startswith("usage: ")
    assert left == ["build"]


@pytest.mark.parametrize("script", ["benchmarks/calibration.py", "scripts/mutation/__main__.py"])
def test_so_it_is_in_a_process_of_its_own(tmp_path: Path, script: str) -> None:
    (tmp_path / "build").mkdir()
    done = started(tmp_path, "-m", module_of(script), "--help")
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.startswith("usage: ")
    assert [path.name for path in tmp_path.iterdir()] == ["build"]
