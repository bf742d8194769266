"""What results inherit to show themselves.

A dataclass that inherits from these says ``repr=False``, so that it keeps their ``repr``.
"""

from __future__ import annotations

from dataclasses import fields
from typing import TYPE_CHECKING

from trimmer.showing import html
from trimmer.showing.frame import to_frame

if TYPE_CHECKING:
    import pandas

    from trimmer.showing.table import Table

LONGEST = 160  # Most characters of what is told


class Shown:
    """A result that shows itself in one line, and as a paragraph in a notebook."""

    __slots__ = ()

    def _told(self) -> str:
        """Return what is to be said of the result, in a few words."""
        raise NotImplementedError

    def __repr__(self) -> str:
        return f"<{type(self).__name__}: {_short(self._told())}>"

    def _repr_html_(self) -> str:
        return html.sentence(type(self).__name__, _short(self._told()))


class ShownFields:
    """A small result that is its fields; they are a table in a notebook. Its ``repr`` is the dataclass's."""

    __slots__ = ()

    def _repr_html_(self) -> str:
        content = [(each.name, getattr(self, each.name)) for each in fields(self) if each.repr]  # type: ignore[arg-type]
        return html.of_fields(type(self).__name__, content)


class Tabular(Shown):
    """A result that is a table too."""

    __slots__ = ()

    def _table(self) -> Table:
        """Return the table."""
        raise NotImplementedError

    def to_dataframe(self) -> pandas.DataFrame:
        """Return the table as a data frame of pandas, with the units in ``attrs["units"]``.

        Columns have the names of the keys in the JSON of the command line, where that has them.

        Raises:
            MissingPackageError: if pandas is not installed.
        """
        return to_frame(self._table())

    def _repr_html_(self) -> str:
        return html.of_table(type(self).__name__, _short(self._told()), self._table())


def _short(told: str) -> str:
    line = " ".join(told.split())
    return line if len(line) <= LONGEST else f"{line[: LONGEST - 1].rstrip()}…"


def counted(count: int | str, noun: str) -> str:
    """Return a number with what it counts: ``1 orbit``, ``2 orbits``, ``2 bodies``, ``2 guesses``."""
    if str(count) == "1":
        return f"1 {noun}"
    plural = f"{noun}es" if noun.endswith(("ch", "s")) else f"{noun}s"
    plural = f"{noun[:-1]}ies" if noun.endswith("y") and noun[-2] not in "aeiou" else plural
    return f"{count} {plural}"
