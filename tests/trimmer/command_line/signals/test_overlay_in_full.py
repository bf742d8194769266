"""A comparison of a measured with a simulated motion, made by hand: every part of its text and its JSON."""

from __future__ import annotations

import json
from pathlib import Path
from types import SimpleNamespace as Made

import numpy as np
import pytest

from tests.trimmer.command_line.test_told_of_signals import comparison as made_comparison
from tests.trimmer.command_line.told import cells
from trimmer.command_line.signals import overlay_text
from trimmer.signals.recording import Recording
from trimmer.signals.signal import Signal

SIGNAL = Signal(np.sin(np.arange(500.0)), 250.0, "stroke", "m", notes=("as read",))


def comparison(**changes: object) -> Made:
    usual = {
        "signal": SIGNAL,
        "simulated_frequency": 40.0,
        "measured": np.array([3j, -0.5]),
        "simulated": np.array([-1.0, 4j]),
        "frequencies": np.array([25.0, 50.0]),
        "decibels": np.array([1.5, -2.5]),
        "phase_differences": np.array([0.25, -0.5]),
    }
    return made_comparison(**usual | changes)


def compared(**changes: object) -> overlay_text.Compared:
    fault = Made(sentence="it is wrong", kind="fault")
    chosen = Made(full_scale_is_one=False, signal=SIGNAL, recording=Recording((SIGNAL,)), faults=(fault,))
    files = Path("a.csv"), Path("m.toml")
    return overlay_text.Compared(*files, "x", "It settles.", chosen, comparison(**changes))


def test_every_number_is_in_the_json() -> None:
    data = json.loads(overlay_text.as_json(compared()))
    assert (data["file"], data["against"], data["output"]) == ("a.csv", "m.toml", "x")
    assert (data["settled"], data["signal"]["samples"], len(data["stretches"])) == ("It settles.", 500, 1)
    assert (data["frequency"], data["frequency_found"], data["simulated_frequency"]) == (50.0, True, 40.0)
    assert (data["period_count"], data["shift"], data["rest"]) == (2, 0.005, 0.0625)
    assert (data["residual"], data["inverted_residual"], data["uncertainty"]) == (0.25, 0.125, 0.125)
    assert data["faults"] == [{"kind": "fault", "certainty": None, "message": "it is wrong"}]
    assert [note[:11] for note in data["notes"]] == ["as read", "it is wrong", "the measure"]
    usual = {"order": [1, 2], "frequency": 25.0, "decibels": 1.5, "phase_difference": 0.25}
    assert data["lines"][0] == usual | {"measured": 3.0, "simulated": 1.0}
    assert (data["lines"][1]["order"], data["lines"][1]["simulated"], len(data["lines"])) == ([2, 2], 4.0, 2)


def test_what_was_compared_stands_first() -> None:
    first, alignment, lines = overlay_text.as_text(compared()).split("\n\n")
    head = first.splitlines()
    assert head[0] == "measured: stroke [m] of a.csv, 500 samples at 250 Hz, 2 s"
    assert head[1:3] == ["simulated: x of m.toml, as displacement", "  It settles."]
    assert head[3] == "drive: 50 Hz measured (found in the measurement), 40 Hz simulated"
    assert head[4:6] == ["note: as read", "note: it is wrong"]
    assert alignment.startswith("Waveforms, aligned in time\n  the simulation is shifted by 0.005 s, 90 deg")
    assert lines.startswith("Lines, measured amplitudes to 0.12 m")
    assert "50 Hz measured (as given)" in overlay_text.as_text(compared(found=False))


@pytest.mark.parametrize("places", [(0, 1, 2), (2, 1, 0)])
def test_lines_are_left_out_beside_the_largest_of_either_motion(places: tuple[int, ...]) -> None:
    """Each amplitude is given by a complex number whose real part says nothing about it."""
    order = list(places)

    def told(measured: list[complex], simulated: list[complex]) -> list[str]:
        numbers = {"measured": np.array(measured)[order], "simulated": np.array(simulated)[order]}
        others = {"frequencies": np.ones(3), "decibels": np.zeros(3), "phase_differences": np.zeros(3)}
        made = comparison(**numbers, **others, period_count=1)
        return sorted(row[0] for row in cells(list(overlay_text._lines(made))[2:]))

    def at(*lines: int) -> list[str]:
        return sorted(str(order.index(line) + 1) for line in lines)

    assert told([-50.0, 1e-3j, 1e-4], [0.0, 0.0, -1e-2j]) == at(0, 2)
    assert told([-1e-2, 1e-3j, 1e-4], [0.0, 0.0, -50j]) == at(0, 2)
    assert told([1e-3, 1e-5j, 1e-8], [0.0, -1e-6j, 1e-8j]) == at(0, 1)
    # The whole of a line that is simulated alone, though its amplitude is no real number.
    assert told([1e-3, 0.0, 0.0], [1e-3, -1e-2, 1e-2j]) == at(0, 1, 2)
