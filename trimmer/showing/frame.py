"""Tables as data frames of pandas, if it is there."""

from __future__ import annotations

from typing import TYPE_CHECKING

from trimmer.choices import Choice
from trimmer.errors import MissingPackageError

if TYPE_CHECKING:
    import pandas

    from trimmer.showing.table import Table


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
