"""``trimmer report``: derive, solve, judge and write the report."""

from __future__ import annotations

import webbrowser
from argparse import ArgumentParser, Namespace
from pathlib import Path
from typing import TYPE_CHECKING

from report.pages.formats import Format, Paper, add_form_options
from report.rendering.request import Request
from trimmer.command_line.command import Command, uses
from trimmer.command_line.file_options import add_overwrite_option, file_to_read, folder_to_write, show
from trimmer.command_line.parser import OptionError, refuse_unused
from trimmer.errors import TrimmerError
from trimmer.files import ERRATA, HTML, JSON, PDF, STANDARD_INPUT, check_target

if TYPE_CHECKING:
    from report.building.build import Built, Content
    from report.copy.reading import ReaderCopy
    from report.judging.changes import ClaimsFile

DIRECTORY = Path("build") / "report"
KINDS = {Format.HTML: HTML, Format.PDF: PDF, Format.CARDS: PDF, Format.JSON: JSON, Format.CSV: ERRATA}


class NothingToOpenError(TrimmerError, ValueError):
    """The report was to be opened in a browser, but not to be written as HTML."""


def add_build_options(parser: ArgumentParser, directory: Path) -> None:
    """Add the options on what is written and where, for reports on any text."""
    parser.add_argument(
        "--directory",
        type=folder_to_write,
        metavar="DIR",
        default=directory,
        help="folder for report.html, report.pdf, cards.pdf, claims.json, errata.csv and what stands beside "
        "them (default: %(default)s)",
    )
    add_form_options(parser, Format, "all", "; cards come with pdf; may be given several times")
    parser.add_argument(
        "--compare",
        type=file_to_read,
        metavar="OLD.json",
        help="claims.json of an earlier build, also that of the same folder: prints which claims are new or "
        "gone, and whose verdict, severity, printed or derived side or explanation has changed",
    )
    parser.add_argument("--open", action="store_true", help="open the HTML in the browser")
    add_overwrite_option(parser)


def _configure(parser: ArgumentParser) -> None:
    add_build_options(parser, DIRECTORY)
    parser.add_argument(
        "--only",
        action="extend",
        nargs="+",
        metavar="CHAPTER",
        default=[],
        help="chapters to show, such as ch5 or appA (default: all); the files then hold this part alone; may "
        "be given several times",
    )
    parser.add_argument(
        "--thesis",
        type=file_to_read,
        metavar="FILE",
        help="your own text copy of the thesis, UTF-8: the HTML then shows each passage beside its card; "
        "another text than the one that was judged is refused",
    )
    parser.add_argument(
        "--other-copy",
        action="store_true",
        help="take another text with --thesis as well; its lines may not fit",
    )


def _run(arguments: Namespace) -> int:
    return made(arguments, _request(arguments))


def made(arguments: Namespace, request: Request, content: Content | None = None) -> int:
    """Build what was asked for, by default of the thesis's report; show it, and return the exit code.

    Raises:
        FileWriteError: if a file is there and of another kind, or cannot be written.
        ClaimsFileError: if the earlier claims cannot be read.
    """
    from report.rendering.render import NAMES

    for form in request.formats:
        check_target(arguments.directory / NAMES[form], KINDS[form], overwrite=request.overwrite)
    earlier = _earlier(arguments)
    from report.building.build import build

    built = build(arguments.directory, request, content)
    show(_summary(built))
    if earlier is not None:
        show(_differences(earlier, built))
    if arguments.open:
        webbrowser.open(built.files[Format.HTML].absolute().as_uri())
    return 0


def _request(arguments: Namespace) -> Request:
    """Read what is wanted, before anything is computed.

    Raises:
        NothingToOpenError: if the HTML is to be opened and not to be written.
        OptionError: if an option would have no effect (a paper without a PDF, a copy without the HTML), or
            if two files are to be read from standard input.
        CopyFileError: if the text copy cannot be read.
        OtherCopyError: if it is another text than the one that was judged.
        UnknownChapterError: if the thesis has no such chapter.
    """
    from report.data.statements import read_inventory
    from report.rendering.selection import chapter_numbers

    chapter_numbers(arguments.only, {entry.chapter for entry in read_inventory().values()})
    formats = formats_of(arguments)
    if Format.HTML not in formats:
        refuse_unused(arguments, ["thesis"], "html among --format")
    if arguments.thesis == arguments.compare == STANDARD_INPUT:
        raise OptionError("--thesis and --compare both read standard input: name a file for one of them")
    copy = _reader_copy(arguments)
    return Request(tuple(arguments.only), formats, Paper(arguments.paper), arguments.overwrite, copy)


def formats_of(arguments: Namespace) -> frozenset[Format]:
    """Return the forms that are wanted.

    Raises:
        NothingToOpenError: if the HTML is to be opened and not to be written.
        OptionError: if a paper is chosen without a PDF.
    """
    formats = frozenset(map(Format, arguments.format)) or frozenset(Format)
    if arguments.open and Format.HTML not in formats:
        raise NothingToOpenError("--open shows the HTML: add html to --format, or leave one of the two out")
    if not formats & {Format.PDF, Format.CARDS}:
        refuse_unused(arguments, ["paper"], "pdf or cards among --format")
    return formats


def _reader_copy(arguments: Namespace) -> ReaderCopy | None:
    if arguments.thesis is None:
        if arguments.other_copy:
            raise OptionError("--other-copy has no effect without --thesis: add that, or leave it out")
        return None
    from report.copy.reading import read_reader_copy
    from report.data.text_copy import read_text_copy

    return read_reader_copy(arguments.thesis, read_text_copy().sha256, accept_other=arguments.other_copy)


def _earlier(arguments: Namespace) -> ClaimsFile | None:
    """Read the earlier claims, before the build may write others in their place."""
    if arguments.compare is None:
        return None
    from report.judging.changes import read_claims

    return read_claims(arguments.compare)


def _differences(earlier: ClaimsFile, built: Built) -> str:
    from report.judging.changes import differences, parsed_claims
    from report.rendering.json import to_json

    now = parsed_claims(to_json(built.document), "this build")
    return differences(earlier, now, {chapter.number for chapter in built.document.omitted})


def _summary(built: Built) -> str:
    from report.judging.verdict import Verdict

    verdicts = [finding.verdict for finding in built.document.findings]
    counts = ", ".join(f"{verdicts.count(verdict)} {verdict.value}" for verdict in Verdict)
    chapters = ", ".join(chapter.number for chapter in built.document.chapters)
    part = f" of {chapters} alone" if built.document.omitted else ""
    return "\n".join(
        (
            f"{len(verdicts)} claims{part} judged in {built.seconds:.1f} s: {counts}",
            *(f"  {path}" for path in (*built.files.values(), *built.beside)),
        )
    )


COMMAND = Command(
    "report",
    "build the report: derive, solve, judge, draw, write HTML, PDF and JSON",
    _configure,
    _run,
    examples=uses("""
    trimmer report
        which statements of the thesis hold, in build/report: report.html, report.pdf, cards.pdf, claims.json
    trimmer report --only ch5 --format html --open
        one chapter alone, as a page, in the browser
    trimmer report --compare claims.json
        what has changed since the claims.json of an earlier report
    """),
)
