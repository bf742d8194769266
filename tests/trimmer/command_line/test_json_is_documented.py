"""Every key of the JSON that a command prints stands in docs/json.md, and no other."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from tests.json_document import documented, keys
from trimmer.command_line.main import main

NAMED_BY_DATA = {"parameters", "limit_cycles[].harmonic_leakage", "last_amplitudes"}
"""Objects whose keys are data: symbols, numbers of harmonics, names of signals."""
LOOP = ["--element", "friction", "--gap", "4e-5", "--channels", "displacement"]
COMMANDS = {
    "linear": [],
    "limit-cycles": LOOP,
    "identify": ["--gap", "4e-5", "--frequency", "740", "--channels", "displacement", "--uncertainty", "1"],
    "orbits": LOOP,
    "simulate": [*LOOP, "--drive", "100", "--amplitude", "0.0015", "--duration", "0.02"],
}
EMPTY_LISTS = {"certificate.undecided", "not_found", "families"}
"""Lists that these calls leave empty, and the keys of their entries."""
OF_EMPTY_LISTS = {
    "certificate.undecided[].amplitudes",
    "certificate.undecided[].omegas",
    "not_found[].amplitude",
    "not_found[].frequency",
    "families[].amplitude",
    "families[].met",
    "families[].amplitudes",
}
OF_FAULTS = {"faults[].kind", "faults[].certainty", "faults[].message"}
OF_GAPS = {"gaps[].begin", "gaps[].end", "gaps[].line", "gaps[].missing"}
"""Keys of measured signals, which this one need not have; tests of measured files have them."""


@pytest.mark.parametrize("command", COMMANDS)
def test_keys_are_those_of_the_document(command: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main([command, *COMMANDS[command], "--json"]) == 0
    printed = set(keys(json.loads(capsys.readouterr().out), NAMED_BY_DATA)) - EMPTY_LISTS
    assert printed == documented(f"trimmer {command}") - OF_EMPTY_LISTS


def test_keys_of_a_spectrum_are_those_of_the_document(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = str(tmp_path / "motion.csv")
    motion = ["--drive", "100", "--amplitude", "0.0015", "--duration", "0.3", "--csv", file]
    assert main(["simulate", *LOOP, *motion]) == 0
    capsys.readouterr()
    words = ["--column", "2", "--gap", "4e-5", "--drive", "100", "--average", "4", "--json"]
    assert main(["spectrum", file, *words]) == 0
    printed = set(keys(json.loads(capsys.readouterr().out))) - {"gaps", "faults"}
    assert printed - OF_FAULTS == documented("trimmer spectrum") - OF_FAULTS - OF_GAPS
