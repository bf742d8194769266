"""Reading of a measured signal from a CSV file: columns, sample rate, missing values, unit."""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from trimmer.arguments import file_path, require_instance
from trimmer.arrays import Places, Reals
from trimmer.choices import Choice
from trimmer.signals.cells import numbers_in
from trimmer.signals.columns import ColumnChoice, Columns, chosen_columns
from trimmer.signals.csv_layout import CsvLayout
from trimmer.signals.csv_table import CsvTable, read_table
from trimmer.signals.quantity import SECONDS
from trimmer.signals.recording import Recording
from trimmer.signals.sampling import Sampling, Stamped, TimeStamps, stretches_of
from trimmer.signals.signal import Signal, checked_rate, split_heading
from trimmer.signals.text_file import SignalFileError

LARGEST_SHARE = 0.1  # Largest share of samples that may be interpolated


class MissingValues(Choice):
    """What is done about missing values.

    ``REFUSE``: they are an error. ``INTERPOLATE``: those at the beginning and the end are cut off, those
    between others are interpolated along a straight line. ``GAP``: the record has gaps there.
    """

    REFUSE = "refuse"
    INTERPOLATE = "interpolate"
    GAP = "gap"


@dataclass(frozen=True)
class Filled:
    """Samples without missing values, finite, and their places in the column, from 0, (m,)."""

    values: Reals
    places: Places
    interpolated: int = 0

    @property
    def has_gaps(self) -> bool:
        """Whether places are left out between others."""
        return int(self.places[-1] - self.places[0]) >= self.places.size


def fill(values: Reals, lines: Sequence[int], missing: MissingValues, place: str) -> Filled:
    """Cut off or interpolate the missing values (NaN) of a column, (n,), as far as that is allowed."""
    present = np.flatnonzero(~np.isnan(values))
    absent = np.flatnonzero(np.isnan(values))
    if present.size == 0:
        raise SignalFileError(f"{place}: every value of the column is missing")
    if absent.size == 0:
        return Filled(values, present)
    if missing is MissingValues.GAP:
        return Filled(values[present], present)
    problem = f"{place}, line {lines[int(absent[0])]}: {_count(absent.size)}"
    if missing is MissingValues.REFUSE:
        raise SignalFileError(
            f"{problem}; remove lines at the beginning or end, or have values between others interpolated "
            "(--missing interpolate) or taken as gaps (--missing gap)"
        )
    begin, end = int(present[0]), int(present[-1]) + 1
    inside = np.arange(begin, end)
    interpolated = inside.size - present.size
    if interpolated > LARGEST_SHARE * inside.size:
        raise SignalFileError(
            f"{problem}, more than {100 * LARGEST_SHARE:g} % of the samples, too many to interpolate"
        )
    return Filled(np.interp(inside, present, values[present]), inside, interpolated)


def _count(missing: int) -> str:
    return "a value is missing" if missing == 1 else f"the first of {missing} missing values"


_FOUND_OUT = CsvLayout()
_STRICT = Sampling()


def read_signal(
    path: Path | str,
    *,
    column: ColumnChoice = None,
    time_column: ColumnChoice = None,
    sample_rate: float | None = None,
    layout: CsvLayout = _FOUND_OUT,
    missing: MissingValues | str = MissingValues.REFUSE,
    sampling: Sampling = _STRICT,
) -> Signal:
    """Read a signal from a CSV file: columns of numbers, with a heading or without.

    Lines that begin with ``#`` are skipped. Columns are separated by comma, semicolon or tab, decimals have a
    point or a comma, and the encoding is UTF-8 or Latin-1. A column of time stamps gives the sample rate; it
    is in seconds unless its heading says ``[ms]``, ``[us]`` or ``[ns]``. Values are read to the last digit,
    and never evaluated as anything but numbers. Of a recording with gaps it is the longest stretch.

    Args:
        path: The file; ``-`` is standard input.
        column: Column of the signal, by name or number. Not needed if there is one beside the time stamps.
        time_column: Column of the time stamps. Not needed if it is named ``t``, ``time`` or ``timestamp``.
        sample_rate: Samples per second, Hz. If there are time stamps too, both must agree, and this is used;
            where samples are resampled, it is the new rate.
        layout: Delimiter and decimal sign, where they are not to be found out.
        missing: What to do about empty cells and those that say ``nan``, ``n/a`` or the like: a member,
            or its word (``refuse``, ``interpolate``, ``gap``).
        sampling: What to do about time stamps that are not at equal distances, and about gaps.

    Raises:
        ChoiceError: if ``missing`` is none of these.
        SignalFileError: if the file cannot be read as such, with the line and what to do; for missing and
            infinite values; for time stamps that are not at equal distances; if the sample rate is not known.
        SignalError: if the sample rate is not a positive number.
    """
    options = {"column": column, "time_column": time_column, "sample_rate": sample_rate}
    return read_recording(path, **options, layout=layout, missing=missing, sampling=sampling).longest  # type: ignore[arg-type]


def read_recording(
    path: Path | str,
    *,
    column: ColumnChoice = None,
    time_column: ColumnChoice = None,
    sample_rate: float | None = None,
    layout: CsvLayout = _FOUND_OUT,
    missing: MissingValues | str = MissingValues.REFUSE,
    sampling: Sampling = _STRICT,
) -> Recording:
    """Read all stretches of a signal from a CSV file; arguments and errors are those of ``read_signal``."""
    path = file_path("path", path)
    require_instance("layout", layout, CsvLayout, "a trimmer.signals.CsvLayout")
    require_instance("sampling", sampling, Sampling, "a trimmer.signals.Sampling")
    missing = MissingValues.chosen(missing, "missing")
    given = None if sample_rate is None else checked_rate(sample_rate)
    table = read_table(path, layout)
    columns = chosen_columns(table, column, time_column)
    values = numbers_in(table.column(columns.signal), table.lines, layout.decimal, str(path))
    ignored = sampling.stamps is TimeStamps.IGNORE
    times = None if ignored else _times(table, columns, layout)
    if times is None and given is None:
        raise SignalFileError(f"{path}: no sample rate; give it (--rate){_NAME_TIME * (not ignored)}")
    notes = (_IGNORED,) if ignored and columns.time is not None else ()
    filled = fill(values, table.lines, missing, str(path))
    if times is not None:
        times = times[filled.places]
    elif filled.has_gaps and given is not None:
        times = filled.places / given
    heading = _name_and_unit(table, columns.signal)
    if times is None:
        assert given is not None
        signal = Signal(filled.values, given, *heading, 0.0, filled.interpolated, notes=notes)
        return Recording((signal,))
    lines = [table.lines[place] for place in filled.places.tolist()]
    rate, stretches, gaps = stretches_of(Stamped(times, filled.values, lines, str(path)), given, sampling)
    return Recording(
        tuple(
            Signal(
                each.values,
                rate,
                *heading,
                each.start,
                filled.interpolated,
                each.trusted,
                (*notes, *each.notes),
            )
            for each in stretches
        ),
        gaps,
    )


_NAME_TIME = ", or name the column of time stamps (--time)"
_IGNORED = (
    "time stamps are left aside: samples are taken to lie at equal distances, at the rate that was given, "
    "with none missing"
)


def _times(table: CsvTable, columns: Columns, layout: CsvLayout) -> Reals | None:
    if columns.time is None:
        return None
    unit = split_heading(table.headings[columns.time])[1] if table.headings else ""
    if unit not in SECONDS:
        known = ", ".join(unit for unit in SECONDS if unit)
        raise SignalFileError(f"{table.path}: time stamps in {unit!r} are not known; known units: {known}")
    stamps = numbers_in(table.column(columns.time), table.lines, layout.decimal, str(table.path))
    return stamps * SECONDS[unit]


def _name_and_unit(table: CsvTable, place: int) -> tuple[str, str]:
    name, unit = split_heading(table.headings[place]) if table.headings else ("", "")
    return name or f"column {place + 1}", unit
