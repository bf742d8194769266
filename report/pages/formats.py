"""In which forms a report is written, and on which paper."""

from argparse import ArgumentParser
from collections.abc import Callable, Collection, Iterable, Mapping
from concurrent.futures import ThreadPoolExecutor

from trimmer.choices import Choice


class Format(Choice):
    """A form in which the report is written."""

    HTML = "html"
    PDF = "pdf"
    CARDS = "cards"
    JSON = "json"
    CSV = "csv"


class Paper(Choice):
    """Size of the pages of the PDF."""

    A4 = "a4"
    LETTER = "letter"


def add_form_options(parser: ArgumentParser, forms: Iterable[Format], usual: str, more: str = "") -> None:
    """Add the options on forms and paper; the help says which forms are usual, and what more there is."""
    parser.add_argument(
        "--format",
        action="extend",
        nargs="+",
        choices=[form.word for form in forms],
        default=[],
        help=f"forms to write (default: {usual}){more}",
    )
    parser.add_argument(
        "--paper",
        choices=[paper.word for paper in Paper],
        default=Paper.A4.word,
        help="size of the pages of the PDF (default: %(default)s)",
    )


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
