"""Measure the figures of the project, each beside a peer in the same run; run by ``make benchmark``.

Each row of the table is the median of some runs of a command, the median of its peer's runs, their ratio, and
the target. Commands and peers take turns, so that a busy computer slows both.
"""

import shutil
import statistics
import subprocess
import sys
import time
from argparse import ArgumentParser
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from tempfile import TemporaryDirectory

from benchmarks.calibration import sentence

PROJECT = Path(__file__).resolve().parent.parent


@dataclass(frozen=True)
class Measurement:
    """A command to measure beside a peer."""

    name: str  # What is measured
    command: Sequence[str]  # Command that is measured
    peer_name: str  # What it is compared with
    peer: Sequence[str]  # Command of the peer
    target: float  # Upper limit for the command, s
    runs: int  # How often both run
    # Called before each run of the command, outside the measured time
    prepare: Callable[[], None] = lambda: None


def python(statement: str) -> list[str]:
    """Return the command that runs a statement in a fresh interpreter."""
    return [sys.executable, "-c", statement]


def measurements(folder: Path) -> tuple[Measurement, ...]:
    """Return what is measured, in the order of the table; reports go into the folder, which is removed."""
    trimmer = str(Path(sys.executable).with_name("trimmer"))
    report = [trimmer, "report", "--directory", str(folder)]
    remove = partial(shutil.rmtree, folder, ignore_errors=True)
    control = python("import control")
    return (
        Measurement("report, from nothing", report, "import control", control, 30.0, runs=3, prepare=remove),
        Measurement("report, again", report, "import control", control, 10.0, runs=3),
        Measurement("import trimmer", python("import trimmer"), "import control", control, 0.5, runs=7),
        Measurement(
            "trimmer --help",
            [trimmer, "--help"],
            "python --version",
            [sys.executable, "--version"],
            0.7,
            runs=7,
        ),
        Measurement(
            "make, nothing to install",
            ["make", "--no-print-directory", "help", ".venv/for-use"],
            "python --version",
            [sys.executable, "--version"],
            0.3,
            runs=7,
        ),
    )


def seconds(command: Sequence[str]) -> float:
    """Return how long a command takes, in s.

    Raises:
        subprocess.CalledProcessError: if the command fails; what it printed is shown first.
    """
    start = time.perf_counter()
    ended = subprocess.run(command, cwd=PROJECT, capture_output=True, text=True)
    elapsed = time.perf_counter() - start
    if ended.returncode != 0:
        sys.stderr.write(ended.stdout + ended.stderr)
    ended.check_returncode()
    return elapsed


def measure(measurement: Measurement) -> tuple[float, float]:
    """Return the median times of a command and of its peer, in s."""
    own, peers = [], []
    for _ in range(measurement.runs):
        measurement.prepare()
        own.append(seconds(measurement.command))
        peers.append(seconds(measurement.peer))
    return statistics.median(own), statistics.median(peers)


def main() -> int:
    """Print the table; return 1 if `import trimmer` brings in SymPy, 0 otherwise. Times are never judged."""
    print(sentence())
    row = "{:<27} {:>9} {:>9}  {:<17} {:>9} {:>8}"
    print(row.format("measured", "median", "target", "peer", "median", "ratio"))
    with TemporaryDirectory(prefix="benchmark ") as name:
        for each in measurements(Path(name) / "report"):
            own, peer = measure(each)
            times = f"{own:.3f} s", f"{each.target:g} s", each.peer_name, f"{peer:.3f} s", f"{own / peer:.2f}"
            print(row.format(each.name, *times), flush=True)
    imported = subprocess.run(
        python("import sys, trimmer; raise SystemExit('sympy' in sys.modules)")
    ).returncode
    print("import trimmer imports SymPy:", "yes" if imported else "no")
    return imported


if __name__ == "__main__":
    ArgumentParser(description=__doc__).parse_args()
    sys.exit(main())
