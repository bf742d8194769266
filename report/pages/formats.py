"""In which forms a report is written, and on which paper."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping
from concurrent.futures import ThreadPoolExecutor

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


Content = str | bytes


def made_together(
    makers: Mapping[Format, Callable[[], Content]], wanted: Collection[Format]
) -> dict[Format, Content]:
    """Return the content of each form that is wanted, in the order of their makers, in which they are begun.

    They are made side by side: pandoc and Typst do the work, outside of the interpreter's lock.
    """
    with ThreadPoolExecutor() as pool:
        made = {form: pool.submit(make) for form, make in makers.items() if form in wanted}
        return {form: each.result() for form, each in made.items()}
