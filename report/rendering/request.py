"""What of the report is wanted, and in which form."""

from dataclasses import dataclass

from report.copy.reading import ReaderCopy
from report.pages.formats import Format, Paper


@dataclass(frozen=True)
class Request:
    """Which chapters (names such as ``ch5`` and ``appA``; none means all), which forms, on which paper.

    The PDF leads into that of the cards, which therefore comes with it. ``overwrite`` lets files of another
    kind be replaced, where there are such. Forms and paper may also be given by their words. ``copy`` is the
    reader's own text copy, whose passages the HTML then shows.

    Raises:
        ChoiceError: if a form or paper is none of those there are.
    """

    chapters: tuple[str, ...] = ()
    formats: frozenset[Format] = frozenset(Format)
    paper: Paper = Paper.A4
    overwrite: bool = False
    copy: ReaderCopy | None = None

    def __post_init__(self) -> None:
        formats = frozenset(Format.chosen(form, "format") for form in self.formats)
        beside = {Format.CARDS} if Format.PDF in formats else frozenset()
        object.__setattr__(self, "formats", formats | beside)
        object.__setattr__(self, "paper", Paper.chosen(self.paper, "paper"))


WHOLE_REPORT = Request()
