"""The programs, written once, and what GNU Octave computes with them in one run."""

import json
import subprocess
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from derivations.linear_trimmer import derive_linear_trimmer
from report.document.thesis import Program
from report.octave.archive import write_files
from report.octave.listings import corrected_programs
from tests.report.made_once import MadeOnce
from tests.report.octave import points
from trimmer import TrimmerParameters
from trimmer.arrays import Complexes


@dataclass(frozen=True)
class OctaveRun:
    """What one run printed.

    ``main`` is the JSON of ``main_numbers``, ``grid`` that of the listings at ``points``; ``warnings`` is the
    standard error.
    """

    main: Mapping[str, Any]
    grid: Mapping[str, Any]
    warnings: str


@pytest.fixture(scope="session")
def programs(made_once: MadeOnce) -> tuple[Program, ...]:
    def make() -> tuple[Program, ...]:
        return corrected_programs(derive_linear_trimmer(), TrimmerParameters.thesis())

    return made_once.of_sources("programs", make)


@pytest.fixture(scope="session")
def octave_run(octave, programs, tmp_path_factory, made_once) -> OctaveRun:
    folder = tmp_path_factory.mktemp("octave")
    return made_once.of_sources(
        f"run_{Path(octave).resolve().name}",
        lambda: run_of(octave, programs, folder),
        __file__,
        str(points.__file__),
    )


def run_of(octave: str, programs: tuple[Program, ...], folder: Path) -> OctaveRun:
    write_files(programs, folder)
    driver = folder / "driver.m"
    driver.write_text(points.DRIVER, encoding="ascii")
    ended = run(octave, driver)
    assert ended.returncode == 0, ended.stderr
    main, grid = (json.loads(line) for line in ended.stdout.splitlines())
    return OctaveRun(main, grid, ended.stderr)


def run(octave: str, driver: Path) -> subprocess.CompletedProcess[str]:
    """Run a script, with its folder on Octave's path."""
    command = [octave, "--quiet", "--norc", "--path", str(driver.parent), str(driver)]
    return subprocess.run(command, capture_output=True, text=True, stdin=subprocess.DEVNULL)


def complexes(pair: Mapping[str, Any]) -> Complexes:
    """Return what Octave gave as real and imaginary parts; its NaN is JSON's null."""
    real, imaginary = (np.array(pair[part], dtype=float) for part in ("real", "imaginary"))
    return real + 1j * imaginary
