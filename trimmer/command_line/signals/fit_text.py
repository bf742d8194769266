"""Fitted numbers as text and as JSON."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from trimmer.command_line.json_values import document, picked
from trimmer.command_line.signals.recording_text import notes_of, recording_json, signal_json, wrapped
from trimmer.command_line.table import table

if TYPE_CHECKING:
    from trimmer.command_line.signals.signal_options import ChosenRecording
    from trimmer.fitting.result import Fit, FittedNumber


@dataclass(frozen=True)
class ShownFit:
    """What is shown of a fit, with the files of mechanism, if any, measurement and output, if written."""

    file: Path | None
    measured: Path
    output: Path | None
    recordings: Mapping[str, ChosenRecording]
    fit: Fit

    @property
    def notes(self) -> list[str]:
        """What was done to the samples, assumed, or is doubtful, each once."""
        found = [note for each in self.recordings.values() for note in notes_of(each, each.signal, [])]
        open_ends = [sentence for number in self.fit.numbers for sentence in number.sentences]
        return list(dict.fromkeys([*found, *self.fit.notes, *open_ends]))


def as_text(shown: ShownFit) -> str:
    """Return what was fitted to what, the numbers with their intervals, and how well they explain it."""
    parts = [_head(shown), _numbers(shown.fit), _verdict(shown.fit), _notes(shown)]
    text = "\n\n".join("\n".join(lines) for part in parts if (lines := list(part)))
    return text if shown.output is None else f"{text}\n\nwrote {shown.output}"


def _head(shown: ShownFit) -> Iterator[str]:
    measured = shown.fit.measured
    for name, signal in measured.signals.items():
        yield (
            f"measured: {name} as {signal.quantity.word}, {signal.heading} of {shown.measured}, "
            f"{signal.values.size} samples at {signal.sample_rate:.9g} Hz"
        )
    how = "found in the measurement" if measured.found else "as given"
    if measured.by_itself:
        off = 1.0 / shown.fit.orbit.period - measured.frequency
        yield (
            f"vibration by itself: {measured.frequency:.8g} Hz ({how}, "
            f"+-{measured.frequency_deviation:.2g} Hz), {measured.periods:.1f} periods; the fitted one is "
            f"{off:+.2g} Hz off"
        )
    else:
        yield f"drive: {measured.frequency:.8g} Hz ({how}), {measured.periods:.1f} periods"
    step = measured.frequency / measured.period_count
    count = len(measured.lines)
    yield f"compared: {count} lines at multiples of {step:.6g} Hz, weighed by the noise between them"


def _numbers(fit: Fit) -> Iterator[str]:
    yield f"Fitted numbers of {fit.before.title}" if fit.before.title else "Fitted numbers"
    rows = [
        (each.place, each.unit, f"{each.before:.6g}", f"{each.value:.6g}", *_ends(each))
        for each in fit.numbers
    ]
    interval = f"interval of {100 * fit.confidence:g} %"
    yield from table(("number", "unit", "before", "fitted", interval, ""), rows)


def _ends(number: FittedNumber) -> tuple[str, str]:
    ends = (number.lower, number.upper)
    lower, upper = ("open" if end is None else f"{end:.6g}" for end in ends)
    told = "" if None in ends else f"{_percent(number)}"
    return f"{lower} to {upper}", told


def _percent(number: FittedNumber) -> str:
    assert number.lower is not None and number.upper is not None
    if not number.value:
        return ""
    low, high = ((end / number.value - 1.0) * 100 for end in (number.lower, number.upper))
    return f"{min(low, high):+.2g} % to {max(low, high):+.2g} %"


def _verdict(fit: Fit) -> Iterator[str]:
    sentences = [*fit.judgement.sentences, fit.agreement, *(each.message for each in fit.weak)]
    for sentence in sentences:
        yield from wrapped(sentence, "", "  ")


def _notes(shown: ShownFit) -> Iterator[str]:
    for note in shown.notes:
        yield from wrapped(f"note: {note}", "", "  ")


def as_json(shown: ShownFit) -> str:
    """Return the fit as JSON: full precision, SI units."""
    fit, measured = shown.fit, shown.fit.measured
    content = {
        **picked(shown, "file", "measured"),
        "written": shown.output,
        "outputs": {name: _output_json(shown, name) for name in measured.outputs},
        "frequency": measured.frequency,
        "frequency_found": measured.found,
        "file_frequency": fit.before.frequency,
        "period_count": measured.period_count,
        **picked(fit, "shift", "confidence"),
        "numbers": [_number_json(each) for each in fit.numbers],
        "chi_square": fit.judgement.chi_square,
        "degrees_of_freedom": fit.judgement.freedom,
        "reduced_chi_square": fit.judgement.reduced,
        **picked(fit.judgement, "probability", "explained"),
        "judgement": fit.judgement.sentences,
        "excesses": [vars(each) for each in fit.judgement.excesses],
        "stray_lines": [vars(each) for each in measured.strays],
        "weak": [vars(each) for each in fit.weak],
        "starts": {
            "number": fit.searched.starts,
            **picked(fit.searched, "agreeing", "elsewhere", "lost"),
            "message": fit.agreement,
        },
        "notes": shown.notes,
    }
    return document(content)


def _output_json(shown: ShownFit, name: str) -> dict[str, Any]:
    measured = shown.fit.measured
    place = measured.outputs.index(name)
    lines = zip(
        measured.lines[:, place], shown.fit.simulated[:, place], measured.deviations[:, place], strict=True
    )
    return {
        "signal": signal_json(measured.signals[name]),
        **recording_json(shown.recordings[name]),
        "lines": [
            {
                "order": [row, measured.period_count],
                "measured": line,
                "fitted": fitted,
                "deviation": deviation,
            }
            for row, (line, fitted, deviation) in enumerate(lines, start=1)
        ],
    }


def _number_json(number: FittedNumber) -> dict[str, Any]:
    return {
        **picked(number, "place", "unit", "before", "value", "lower", "upper"),
        "lowest_tried": number.lowest,
        "highest_tried": number.highest,
    }
