"""What speaks against a drive that was given with a measurement: the record's own lines lie elsewhere.

It is told, not refused: beside a strong line of something else, whoever measured knows better than a search.
"""

from collections.abc import Iterator

import numpy as np

from trimmer.fitting.measured import MeasuredLines, drive_near
from trimmer.signals.signal import SignalError
from trimmer.spectra.comparison import sought

OFF = 0.25  # Periods of the last line that is compared by which a drive may be off by the end of the record
SEEN = 10.0  # Standard deviations from which on a line is surely there


def doubts_of(measured: MeasuredLines) -> Iterator[str]:
    """Yield what speaks against the drive; nothing if it was found in the record itself."""
    if measured.found:
        return
    told = [*_larger(measured), *_own(measured)] or [*_multiples(measured)]
    yield from (
        f"{each}: is --drive {measured.frequency:.8g} right? Without it, it is looked for"
        for each in told[:1]
    )


def _larger(measured: MeasuredLines) -> Iterator[str]:
    name, (what, _) = measured.outputs[0], sought(measured.by_itself)
    strays = [each for each in measured.strays if each.output == name]
    stray = max(strays, key=lambda each: each.amplitude, default=None)
    if stray is not None and stray.amplitude > abs(measured.lines[:, 0]).max():
        yield f"the largest line of the record is at {stray.frequency:.5g} Hz, no multiple of the {what}"


def _own(measured: MeasuredLines) -> Iterator[str]:
    signal = measured.signals[measured.outputs[0]]
    try:
        own = drive_near(signal, measured.frequency, 1)
    except SignalError:
        return
    orders = len(measured.lines) / measured.period_count
    if orders * abs(own - measured.frequency) * signal.duration > OFF:
        yield f"the record's own lines are at multiples of {own:.8g} Hz"


def _multiples(measured: MeasuredLines) -> Iterator[str]:
    seen = np.flatnonzero((abs(measured.lines) > SEEN * measured.deviations).any(axis=1)) + 1
    step = int(np.gcd.reduce(seen)) if seen.size else 1
    if step > measured.period_count:
        own = step * measured.frequency / measured.period_count
        yield f"all lines of the record are at multiples of {own:.8g} Hz"
