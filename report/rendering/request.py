"""What of the report is wanted, and in which form."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum


class Format(Enum):
    """A form in which the report is written."""

    HTML = "html"
    PDF = "pdf"
    JSON = "json"


class Paper(Enum):
    """Size of the pages of the PDF."""

    A4 = "a4"
    LETTER = "letter"


@dataclass(frozen=True)
class Request:
    """Which chapters (names such as ``ch5`` and ``appA``; none means all), which forms, on which paper."""

    chapters: tuple[str, ...] = ()
    formats: frozenset[Format] = frozenset(Format)
    paper: Paper = Paper.A4


WHOLE_REPORT = Request()
