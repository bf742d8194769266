"""Samples on a real cluster whose scheduler is killed on the way."""

import json
import os
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from importlib.util import find_spec
from pathlib import Path

import pytest

from trimmer.command_line.main import main

pytestmark = pytest.mark.skipif(find_spec("distributed") is None, reason="needs the package distributed")
PATIENCE = 60.0


@contextmanager
def cluster(folder: Path) -> Iterator[tuple[str, int]]:
    """Begin a scheduler and a worker, each a process of its own; yield its address and its process."""
    told = folder / "scheduler.json"
    here = ["--host", "127.0.0.1", "--scheduler-file", str(told)]
    commands = [
        ["scheduler", *here, "--port", "0", "--no-dashboard", "--no-show"],
        ["worker", *here, "--nthreads", "1", "--no-dashboard", "--death-timeout", "5"],
    ]
    with (folder / "log").open("w") as log:
        programs = [
            subprocess.Popen([sys.executable, "-m", "dask", *words], stdout=log, stderr=log, cwd=folder)
            for words in commands
        ]
    try:
        end = time.monotonic() + PATIENCE
        while not told.exists() or not told.stat().st_size:
            assert time.monotonic() < end, (folder / "log").read_text()
            time.sleep(0.1)
        yield json.loads(told.read_text())["address"], programs[0].pid
    finally:
        for program in programs:
            program.terminate()
        for program in programs:
            program.wait(PATIENCE)


def kill_once_begun(output: Path, process: int) -> None:
    """Kill a process as soon as a file holds more than eight samples."""
    end = time.monotonic() + PATIENCE
    while not output.exists() or output.read_bytes().count(b"\n") < 1 + 9:
        assert time.monotonic() < end
        time.sleep(0.001)
    os.kill(process, signal.SIGKILL)


@pytest.mark.slow
def test_samples_go_on_after_the_scheduler_was_killed(project_folder, tmp_path, capsys) -> None:
    file, output = str(project_folder / "examples" / "scatter.toml"), tmp_path / "samples.jsonl"
    words = ["sample", file, "--count", "400", "--periods", "60", "--json", "--output", str(output)]
    with cluster(tmp_path) as (address, scheduler):
        watching = threading.Thread(target=kill_once_begun, args=(output, scheduler))
        watching.start()
        assert main([*words, "--scheduler", address]) == 2
        watching.join()
    assert "has left: begin it again, and go on" in capsys.readouterr().err
    whole = output.read_bytes()
    assert 1 + 8 < whole.count(b"\n") < 1 + 400
    assert whole.endswith(b"\n")
    assert main([*words, "--resume"]) == 0
    assert output.read_bytes().startswith(whole)
    assert len(output.read_text().splitlines()) == 1 + 400
