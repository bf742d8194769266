"""Every key of the JSON that a command prints stands in docs/json.md, and no other."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

from trimmer.command_line.main import main

DOCUMENT = Path(__file__).parents[3] / "docs" / "json.md"
NAMED_BY_DATA = {"parameters", "limit_cycles[].harmonic_leakage", "last_amplitudes"}
"""Objects whose keys are data: symbols, numbers of harmonics, names of signals."""
LOOP = ["--element", "friction", "--gap", "4e-5", "--channels", "displacement"]
COMMANDS = {
    "linear": [],
    "limit-cycles": LOOP,
    "identify": ["--gap", "4e-5", "--frequency", "740", "--channels", "displacement"],
    "orbits": LOOP,
    "simulate": [*LOOP, "--drive", "100", "--amplitude", "0.0015", "--duration", "0.02"],
}
OF_EMPTY_LISTS = {
    "certificate.undecided[].amplitudes",
    "certificate.undecided[].omegas",
    "not_found[].amplitude",
    "not_found[].frequency",
}
"""Keys of what these calls do not have."""


def documented(heading: str) -> set[str]:
    """Return the keys in the first columns of the table below a heading."""
    (section,) = re.findall(
        rf"^## {re.escape(heading)}\n(.*?)(?=^## |\Z)", DOCUMENT.read_text("utf-8"), re.M | re.S
    )
    firsts = (line.split(" | ")[0] for line in section.splitlines() if line.startswith("| `"))
    return {key for first in firsts for key in re.findall(r"`([^`]+)`", first)}


def keys(value: object, path: str = "") -> Iterator[str]:
    """Yield the paths of all that is no object or list of objects."""
    if isinstance(value, dict) and path not in NAMED_BY_DATA:
        for key, inner in value.items():
            yield from keys(inner, f"{path}.{key}" if path else key)
    elif isinstance(value, list) and any(isinstance(entry, dict) for entry in value):
        for entry in value:
            yield from keys(entry, f"{path}[]")
    elif value != [] or f"{path}[]" not in {key.rpartition(".")[0] for key in OF_EMPTY_LISTS}:
        yield path


@pytest.mark.parametrize("command", COMMANDS)
def test_keys_are_those_of_the_document(command: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main([command, *COMMANDS[command], "--json"]) == 0
    printed = set(keys(json.loads(capsys.readouterr().out)))
    assert printed == documented(f"trimmer {command}") - OF_EMPTY_LISTS


def test_keys_of_a_spectrum_are_those_of_the_document(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = str(tmp_path / "motion.csv")
    motion = ["--drive", "100", "--amplitude", "0.0015", "--duration", "0.3", "--csv", file]
    assert main(["simulate", *LOOP, *motion]) == 0
    capsys.readouterr()
    assert main(["spectrum", file, "--column", "2", "--gap", "4e-5", "--drive", "100", "--json"]) == 0
    assert set(keys(json.loads(capsys.readouterr().out))) == documented("trimmer spectrum")
