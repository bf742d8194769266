"""In which forms a report is written, and on which paper."""

from __future__ import annotations

from trimmer.choices import Choice


class Format(Choice):
    """A form in which the report is written."""

    HTML = "html"
    PDF = "pdf"
    JSON = "json"
    CSV = "csv"


class Paper(Choice):
    """Size of the pages of the PDF."""

    A4 = "a4"
    LETTER = "letter"
