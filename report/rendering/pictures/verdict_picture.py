"""The counts of the summary as a picture: a bar for each grade in each chapter."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final
from xml.sax.saxutils import escape

from report.document.document import Document
from report.judging.verdict import Grade
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
_WIDTH = _LABEL_WIDTH + _PANEL_WIDTH * len(Grade)
_LONGEST_BAR = 58
_HEAD_HEIGHT, _ROW_HEIGHT, _BAR_HEIGHT = 42, 17, 10
_TEXT_BASELINE = 12.5


def verdict_picture(document: Document) -> str:
    """Return the picture as SVG: a column of bars for each grade, with a row for each chapter.

    Position and heading tell the grades apart, and a number stands at each bar: colour only repeats it.
    """
    *rows, total = count_table(document)
    longest = max((count.number for row in rows for count in row.counts), default=0)
    height = _HEAD_HEIGHT + _ROW_HEIGHT * len(rows) + 4
    return "".join(
        (
            f'<svg xmlns="http://www.w3.org/2000/svg" class="verdict-picture" role="img" '
            f'viewBox="0 0 {_WIDTH} {height}" width="{_WIDTH}" height="{height}" '
            f'font-family="Libertinus Serif" font-size="12" '
            f'aria-labelledby="{NAME}-title {NAME}-description">',
            f'<title id="{NAME}-title">Grades by chapter</title>',
            f'<desc id="{NAME}-description">{escape(description(document))}</desc>',
            *_heads(total),
            *(line for index, row in enumerate(rows) for line in _row(row, index, longest)),
            "</svg>",
        )
    )


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


def _heads(total: CountRow) -> Iterator[str]:
    for column, count in enumerate(total.counts):
        start = _start(column)
        yield (
            f'<text x="{start}" y="14" class="{count.grade.value}" fill="{COLOURS[count.grade]}">'
            f'<tspan font-family="DejaVu Sans Mono" font-size="11">{SYMBOLS[count.grade]}</tspan> '
            f'<tspan font-size="16" font-weight="bold">{count.number}</tspan></text>'
            f'<text x="{start}" y="30" font-size="10.5" class="{count.grade.value} name" '
            f'fill="{COLOURS[count.grade]}">{_HEADS[count.grade]}</text>'
        )


def _row(row: CountRow, index: int, longest: int) -> Iterator[str]:
    top = _HEAD_HEIGHT + _ROW_HEIGHT * index
    baseline = top + _TEXT_BASELINE
    yield f'<text x="0" y="{baseline}" class="black">{_short_label(row)}</text>'
    for column, count in enumerate(row.counts):
        length = _LONGEST_BAR * count.number / longest if longest else 0.0
        start, bar_top = _start(column), top + (_ROW_HEIGHT - _BAR_HEIGHT) / 2
        yield (
            f'<rect x="{start}" y="{bar_top:g}" width="{length:.2f}" height="{_BAR_HEIGHT}" '
            f'class="{count.grade.value}" fill="{COLOURS[count.grade]}"/>'
            f'<text x="{start + length + 3:.2f}" y="{baseline}" class="black">{count.number or "–"}</text>'
        )


def _start(column: int) -> int:
    return _LABEL_WIDTH + _PANEL_WIDTH * column
