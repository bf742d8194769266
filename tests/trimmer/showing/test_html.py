"""Tables and values as HTML, data frames and short lines, of results made by hand."""

import sys
from dataclasses import dataclass, field
from decimal import Decimal
from enum import Enum

import numpy as np
import pytest
from IPython.core.formatters import HTMLFormatter

from trimmer.errors import MissingPackageError
from trimmer.showing import shown as html
from trimmer.showing.shown import LONGEST, ShownFields, Tabular, counted
from trimmer.showing.table import Column, Table
from trimmer.thesis import TrimmerBody


class Colour(Enum):
    RED = "red one"


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (None, ""),
        (Colour.RED, "red one"),
        (TrimmerBody.CUTTER, "q2"),
        (True, "yes"),
        (np.False_, "no"),
        (1234567, "1234567"),
        (np.int64(3), "3"),
        (1234567.0, "1.23457e+06"),
        (np.nan, ""),
        (np.inf, "inf"),
        (2 - 3j, "2 − 3j"),
        (2 + 3j, "2 + 3j"),
        (2 + 0j, "2 + 0j"),
        ("text", "text"),
        (Decimal("1.50"), "1.50"),
    ],
)
def test_values_are_written_for_readers(value: object, text: str) -> None:
    assert html.as_text(value) == text


shown = HTMLFormatter()  # How a notebook shows a result


def made_table(rows: int) -> Table:
    columns = (Column("a<b", "m", lambda row: row), Column("c", "", lambda row: row % 2 == 0))
    return Table("Title & more", range(rows), columns)


def test_a_table_is_cut_off() -> None:
    whole, cut = html.of_table("N", "told", made_table(20)), html.of_table("N", "told", made_table(22))
    assert (whole.count("<tr>"), cut.count("<tr>")) == (21, 21)
    assert "more rows" not in whole
    assert cut.endswith("<p>… and 2 more rows</p>")
    assert "<caption>Title &amp; more</caption>" in cut
    assert '<th scope="col">a&lt;b, m</th><th scope="col">c</th>' in cut
    assert "<tr><td>1</td><td>no</td></tr>" in cut
    assert html.of_table("N", "t", made_table(0)) == html.sentence("N", "t") == "<p><strong>N</strong>: t</p>"


@dataclass(frozen=True, repr=False)
class Made(Tabular):
    told: str

    def _told(self) -> str:
        return self.told

    def _table(self) -> Table:
        return made_table(3)


@dataclass(frozen=True)
class Small(ShownFields):
    value: float
    hidden: int = field(default=3, repr=False)


def test_long_lines_are_cut_at_a_word() -> None:
    assert repr(Made("two\n  words")) == "<Made: two words>"
    assert repr(Made("x" * LONGEST)) == f"<Made: {'x' * LONGEST}>"
    assert repr(Made("x" * (LONGEST + 1))) == f"<Made: {'x' * (LONGEST - 1)}…>"
    assert repr(Made("x" * (LONGEST - 2) + " " + "y" * 9)) == f"<Made: {'x' * (LONGEST - 2)}…>"
    assert shown(Made("told")) == html.of_table("Made", "told", made_table(3))
    row = '<tr><th scope="row">value</th><td>2.5</td></tr>'
    assert shown(Small(2.5)) == f"<table><caption>Small</caption><tbody>{row}</tbody></table>"


def test_a_frame_needs_pandas(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "pandas", None)
    with pytest.raises(MissingPackageError, match="pip install pandas"):
        Made("told").to_dataframe()


@pytest.mark.parametrize(
    ("count", "noun", "text"),
    [
        (0, "orbit", "0 orbits"),
        (2, "body", "2 bodies"),
        (1, "stretch", "1 stretch"),
        (2, "stretch", "2 stretches"),
        (2, "day", "2 days"),
        ("1", "event", "1 event"),
        ("0.5", "event", "0.5 events"),
    ],
)
def test_plurals(count: int | str, noun: str, text: str) -> None:
    assert counted(count, noun) == text
