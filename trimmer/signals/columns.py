"""The choice of the columns of a CSV file that hold signal and time stamps."""

from dataclasses import dataclass

from trimmer.arguments import whole_number
from trimmer.messages import did_you_mean, near_words
from trimmer.signals.csv_table import CsvTable
from trimmer.signals.signal import split_heading
from trimmer.signals.text_file import SignalFileError

ColumnChoice = int | str | None
"""A column by its number, which counts from 1, or its name; None if it follows from the others."""

TIME_NAMES = frozenset({"t", "time", "timestamp", "time stamp"})
"""Names of a column of time stamps, whatever their capitals."""

_ADVICE = "choose one by name or number (--column)"


@dataclass(frozen=True)
class Columns:
    """The columns of the signal and of the time stamps, if there are any, counted from 0."""

    signal: int
    time: int | None


def chosen_columns(table: CsvTable, column: ColumnChoice, time_column: ColumnChoice) -> Columns:
    """Find the columns of the signal and of the time stamps.

    Not chosen, the time stamps are the column that has one of ``TIME_NAMES``, if any, and the signal is
    the column beside it.
    """
    signal = None if column is None else _place(table, column)
    time = _time_place(table) if time_column is None else _place(table, time_column)
    if signal is None:
        signal = _only_signal(table, time)
    if signal == time:
        raise SignalFileError(
            f"{table.path}: the signal and the time stamps cannot both be {_described(table, signal)}"
        )
    return Columns(signal, time)


def _place(table: CsvTable, choice: int | str) -> int:
    """Find a column; a text of digits is a number if no column has it as a name."""
    if isinstance(choice, str):
        places = _named(table, choice)
        if len(places) > 1:
            numbers = " and ".join(str(place + 1) for place in places)
            raise SignalFileError(f"{table.path}: columns {numbers} are named {choice!r}; choose by number")
        if places:
            return places[0]
        if not choice.strip().isdecimal():
            raise SignalFileError(f"{table.path}: no column is named {choice!r}{_similar(table, choice)}")
    number = int(choice) if isinstance(choice, str) else whole_number("column", choice)
    if not 1 <= number <= table.width:
        raise SignalFileError(f"{table.path}: there is no column {choice}; {_listed(table)}")
    return number - 1


def _named(table: CsvTable, name: str) -> list[int]:
    """Find the columns with this heading, with or without unit; capitals matter only if they must."""
    for same in (str, str.casefold):
        wanted = same(" ".join(name.split()))
        found = [
            place
            for place, heading in enumerate(table.headings)
            if wanted and wanted in (same(heading), same(split_heading(heading)[0]))
        ]
        if found:
            return found
    return []


def _time_place(table: CsvTable) -> int | None:
    places = [
        place
        for place, heading in enumerate(table.headings)
        if split_heading(heading)[0].casefold() in TIME_NAMES
    ]
    if len(places) > 1:
        listed = " and ".join(_described(table, place) for place in places)
        raise SignalFileError(f"{table.path}: {listed} may both be time stamps; choose one (--time)")
    return places[0] if places else None


def _only_signal(table: CsvTable, time: int | None) -> int:
    places = [place for place in range(table.width) if place != time]
    if not places:
        raise SignalFileError(f"{table.path}: holds time stamps alone; a column of samples is needed")
    if len(places) > 1:
        raise SignalFileError(f"{table.path}: {_listed(table)}; {_ADVICE}{_decimal_hint(table)}")
    return places[0]


def _decimal_hint(table: CsvTable) -> str:
    """A comma may be a decimal sign that was taken as a delimiter: then every cell is a whole number."""
    sample = range(min(100, len(table.data)))
    whole = all(cell.strip().lstrip("+-").isdecimal() for place in sample for cell in table.data.cells(place))
    return ", or say that the comma is the decimal sign (--decimal comma)" if whole else ""


def _similar(table: CsvTable, name: str) -> str:
    names = [split_heading(heading)[0] for heading in table.headings]
    return f"; {did_you_mean(map(repr, near_words(name, names))) or _listed(table)}"


def _listed(table: CsvTable) -> str:
    if table.width == 1:
        return f"the only one is {_described(table, 0)}"
    described = ", ".join(_described(table, place) for place in range(table.width))
    return f"there are {table.width} columns: {described}"


def _described(table: CsvTable, place: int) -> str:
    return f"{place + 1} {table.headings[place]!r}" if table.headings else f"column {place + 1}"
