"""Writing of signals as a CSV file that reads back equal."""

import csv
import io
from pathlib import Path

import numpy as np

from trimmer.arguments import file_path, require_instance, require_instances, truth_value
from trimmer.files import write_atomically
from trimmer.signals.columns import TIME_NAMES
from trimmer.signals.signal import Signal, SignalError

TIME_HEADING = "time [s]"


def write_signal(path: Path | str, signal: Signal, *others: Signal, overwrite: bool = False) -> None:
    """Write signals as CSV: time stamps, then a column per signal, with headings; whole or not at all.

    Numbers have as many digits as it takes to read back the same value, so ``read_signal`` gives equal values
    and start. The sample rate is read from the time stamps: it is equal if it has at most 15 digits and the
    signal starts at 0, else as near as the rounding of the stamps allows.

    Args:
        path: The file.
        signal: The signal.
        others: Further signals, at the same times; each has its own name.
        overwrite: Replace a file of any kind; see ``write_atomically``.

    Raises:
        SignalError: if the signals are not at the same times, share a name or have that of the time, or
            their times are too large to distinguish neighbouring samples.
        FileWriteError: if the file cannot be written.
    """
    target, overwrite = file_path("path", path), truth_value("overwrite", overwrite)
    signals = (signal, *others)
    require_instance("signal", signal, Signal, "a trimmer.Signal")
    require_instances("others", others, Signal, "a trimmer.Signal")
    _check_names(signals)
    if any(
        (each.values.size, each.sample_rate, each.start)
        != (signal.values.size, signal.sample_rate, signal.start)
        for each in others
    ):
        raise SignalError("signals in one file must have the same number of samples, sample rate and start")
    times = signal.times
    if np.spacing(np.abs(times).max()) * signal.sample_rate > 1e-3:
        raise SignalError(f"samples at {signal.sample_rate:g} Hz cannot be told apart at {times[-1]:g} s")
    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerow([TIME_HEADING, *(each.heading for each in signals)])
    columns = [map(repr, each.tolist()) for each in (times, *(each.values for each in signals))]
    text.write("\n".join(map(",".join, zip(*columns, strict=True))) + "\n")
    write_atomically(target, text.getvalue(), overwrite=overwrite)


def _check_names(signals: tuple[Signal, ...]) -> None:
    names = [signal.name.casefold() for signal in signals]
    for signal, name in zip(signals, names, strict=True):
        if name in TIME_NAMES:
            raise SignalError(f"a signal cannot be named {signal.name!r} in a file: that is the time's name")
        if names.count(name) > 1:
            raise SignalError(f"two signals are named {signal.name!r}; in a file each needs its own name")
