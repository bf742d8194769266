"""What a measured signal is, and what was done to it and assumed, as text and as JSON."""

from __future__ import annotations

import textwrap
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from trimmer.command_line.json_values import picked

if TYPE_CHECKING:
    from trimmer.command_line.signals.signal_options import ChosenRecording
    from trimmer.signals.signal import Signal

_WIDTH = 110
NO_SCALE = (
    "no scale was given (--scale, --unit), so amplitudes are shares of full scale, and it is not known "
    "whether they are of a displacement, a velocity or an acceleration"
)


def wrapped(text: str, first: str, others: str) -> list[str]:
    """Break a text into lines, with what the first and the others begin with."""
    return textwrap.wrap(
        text,
        _WIDTH,
        initial_indent=first,
        subsequent_indent=others,
        break_long_words=False,
        break_on_hyphens=False,
    )


def notes_of(chosen: ChosenRecording, signal: Signal, doubts: Sequence[str]) -> list[str]:
    """List what was done to the samples, what is assumed, and what is doubtful, each once."""
    notes = [*signal.notes]
    if chosen.full_scale_is_one and not signal.unit:
        notes.append(NO_SCALE)
    return list(dict.fromkeys([*notes, *doubts]))


def signal_json(signal: Signal) -> dict[str, Any]:
    """Describe a signal for JSON."""
    return {
        **picked(signal, "name", "unit"),
        "quantity": signal.quantity.name.lower(),
        "samples": signal.values.size,
        **picked(signal, "sample_rate", "start", "interpolated"),
        "trusted": picked(signal.trusted, "lowest", "highest", "lowest_reason", "highest_reason"),
    }


def recording_json(chosen: ChosenRecording) -> dict[str, Any]:
    """Describe stretches, gaps and faults for JSON."""
    from trimmer.signals.fault import Clipping

    return {
        "stretches": [
            {"start": stretch.start, "samples": stretch.values.size} for stretch in chosen.recording.stretches
        ],
        "gaps": [vars(gap) for gap in chosen.recording.gaps],
        "faults": [
            {
                "kind": fault.kind,
                "certainty": fault.certainty if isinstance(fault, Clipping) else None,
                "message": fault.sentence,
            }
            for fault in chosen.faults
        ],
    }
