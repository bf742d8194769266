"""The counts of the summary as a picture: a bar for each grade in each chapter."""

from __future__ import annotations

from typing import Final
from xml.sax.saxutils import escape

from markupsafe import Markup

from report.document.document import Document
from report.judging.verdict import Grade
from report.pages.html import html_templates
from report.rendering.summary import GRADES, SYMBOLS, CountRow, count_table

NAME: Final = "verdicts"
"""Name of the picture among the figures of the report."""

COLOURS: Final = {
    Grade.CONCLUSION: "#a3231f",
    Grade.RESULT: "#8a4b08",
    Grade.SLIP: "#5f5c00",
    Grade.COPY: "#6a4a8c",
    Grade.NOT_CHECKABLE: "#55585e",
    Grade.REPRODUCED: "#17663a",
}
_HEADS: Final = {**GRADES, Grade.CONCLUSION: "conclusion", Grade.RESULT: "result", Grade.COPY: "copy"}
"""One word each, where there is little room."""
_LABEL_WIDTH, _PANEL_WIDTH = 54, 93
"""Widths of the labels of rows and of the bars of a grade; the template has the other sizes."""


def verdict_picture(document: Document) -> str:
    """Return the picture as SVG: a column of bars for each grade, with a row for each chapter.

    Position and heading tell the grades apart, and a number stands at each bar: colour only repeats it.
    """
    *rows, total = count_table(document)
    return (
        html_templates()
        .get_template("verdicts.svg.j2")
        .render(
            **{"name": NAME, "rows": rows, "total": total, "description": description(document)},
            **{"width": _LABEL_WIDTH + _PANEL_WIDTH * len(Grade), "height": 42 + 17 * len(rows) + 4},
            **{"starts": range(_LABEL_WIDTH, 1000, _PANEL_WIDTH), "label": _short_label, "heads": _HEADS},
            longest=max((count.number for row in rows for count in row.counts), default=0),
            **{"colours": COLOURS, "symbols": SYMBOLS, "text": svg_text},
        )
    )


def svg_text(text: str) -> Markup:
    """Return text for a drawing, in which quotation marks stay as they are."""
    return Markup(escape(text))


def description(document: Document) -> str:
    """Return the counts in words, for a reader who does not see the picture."""
    *rows, total = count_table(document)
    return " ".join(f"{_label(row)}: {_in_words(row)}." for row in (total, *rows))


def _in_words(row: CountRow) -> str:
    return ", ".join(f"{count.number} {GRADES[count.grade]}" for count in row.counts if count.number)


def _label(row: CountRow) -> str:
    if row.chapter is None:
        return "All chapters"
    kind = "Chapter" if row.chapter.number.isdigit() else "Appendix"
    return f"{kind} {row.chapter.number}"


def _short_label(row: CountRow) -> str:
    if row.chapter is None:
        return ""
    return f"{'Ch.' if row.chapter.number.isdigit() else 'App.'} {row.chapter.number}"
