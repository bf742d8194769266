"""A result as a table: columns with names and units, a row for each thing in it."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import islice
from operator import attrgetter, itemgetter
from typing import TYPE_CHECKING, Any

from trimmer.choices import Choice
from trimmer.errors import MissingPackageError

if TYPE_CHECKING:
    import pandas


@dataclass(frozen=True)
class Column:
    """A column: its name, that of JSON where there is one, its SI unit, and how a row gives its value."""

    name: str
    unit: str
    of: Callable[[Any], object]


@dataclass(frozen=True)
class Table:
    """A table whose values, by columns of what each row is about, are computed when they are asked for."""

    title: str
    items: Sequence[Any]
    columns: tuple[Column, ...]

    def __post_init__(self) -> None:
        names = [column.name for column in self.columns]
        assert len(set(names)) == len(names), names

    @property
    def units(self) -> dict[str, str]:
        """Units by the names of the columns."""
        return {column.name: column.unit for column in self.columns}

    def rows(self, most: int | None = None) -> Iterator[tuple[object, ...]]:
        """Yield the values of each row, of all or of the first ones."""
        for item in islice(self.items, most):
            yield tuple(column.of(item) for column in self.columns)


def attributes(**units: str) -> tuple[Column, ...]:
    """Return columns of attributes: by the name of each its unit."""
    return tuple(Column(name, unit, attrgetter(name)) for name, unit in units.items())


def arrays(**given: tuple[str, Any]) -> tuple[Column, ...]:
    """Return columns of arrays, (rows,), for rows that are numbered from 0: by name, unit and values."""
    return tuple(Column(name, unit, values.__getitem__) for name, (unit, values) in given.items())


def of_harmonics(title: str, frequency: float, unit: str, orders: Any, coefficients: Any) -> Table:
    """Return amplitude and phase of the harmonics of a frequency, Hz, whose orders are given."""
    from numpy import angle

    columns = arrays(
        order=("", orders),
        frequency=("Hz", frequency * orders),
        amplitude=(unit, abs(coefficients)),
        phase=("rad", angle(coefficients)),
    )
    return Table(title, range(len(orders)), columns)


def over_time(title: str, times: Any, signals: Mapping[str, tuple[str, Any]]) -> Table:
    """Return signals over time: by name unit and values; one that is called time is ``outputs.time``."""
    named = {"outputs.time" if name == "time" else name: each for name, each in signals.items()}
    return Table(title, range(len(times)), arrays(time=("s", times), **named))


TERMS = (Column("term", "", itemgetter(0)), Column("energy", "J", itemgetter(1)))
"""Columns of an energy balance, whose rows are names and energies."""


def to_frame(table: Table) -> pandas.DataFrame:
    """Return a table as a data frame, with the units of its columns in ``attrs["units"]``."""
    try:
        import pandas
    except ImportError as error:
        raise MissingPackageError(
            "to_dataframe needs pandas, which is not installed: install it with 'pip install pandas'"
        ) from error
    rows = [tuple(map(_plain, values)) for values in table.rows()]
    frame = pandas.DataFrame(rows, columns=[column.name for column in table.columns])
    frame.attrs.update(title=table.title, units=table.units)
    return frame


def _plain(value: object) -> object:
    return value.word if isinstance(value, Choice) else value
