"""``trimmer compare A B``: two mechanisms side by side, before and after a change."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import TYPE_CHECKING

from report.design.command import add_report_options, check_files, formats_of, plain_text, runner_of, stem_of
from report.rendering.request import Format, Paper
from trimmer.command_line.command import Command
from trimmer.command_line.file_options import file_to_read
from trimmer.command_line.parser import OptionError
from trimmer.files import STANDARD_INPUT, write_atomically

if TYPE_CHECKING:
    from trimmer.design.comparison import Comparison


def _configure(parser: ArgumentParser) -> None:
    parser.add_argument("before", type=file_to_read, metavar="A", help="mechanism before, a TOML file")
    parser.add_argument("after", type=file_to_read, metavar="B", help="mechanism after, a TOML file")
    add_report_options(parser)


def _run(arguments: Namespace) -> int:
    if arguments.before == arguments.after == STANDARD_INPUT:
        raise OptionError("both files are standard input: name a file for one of them")
    formats, runner = formats_of(arguments), runner_of(arguments)
    from report.design.building import Place, looked_at
    from report.design.progress import ProgressLines
    from trimmer.design.comparison import compared
    from trimmer.design.design_file import read_design_file
    from trimmer.design.settings import USUAL

    files = [read_design_file(path) for path in (arguments.before, arguments.after)]
    stem = f"{stem_of(arguments.before)}-{stem_of(arguments.after)}"
    place = Place(arguments.directory, stem)
    check_files(place, formats, arguments.overwrite)
    told = ProgressLines(arguments.quiet)
    before, after = (looked_at(file, USUAL, runner, place.store, told, short=True) for file in files)
    names = _names(arguments)
    comparison = compared(before, after)
    from report.design.comparison import comparison_sentence

    contents = _contents(comparison, names, formats, Paper(arguments.paper))
    for form, content in contents.items():
        write_atomically(place.file(form), content, overwrite=arguments.overwrite)
    sentence = plain_text(comparison_sentence(comparison, names))
    print("\n".join([sentence, *(f"  {place.file(form)}" for form in contents)]))
    return 0


def _names(arguments: Namespace) -> tuple[str, str]:
    """Return what the two are called: their files' names, or before and after if these are the same."""
    first, second = stem_of(arguments.before), stem_of(arguments.after)
    return (first, second) if first != second else ("before", "after")


def _contents(
    comparison: Comparison, names: tuple[str, str], formats: frozenset[Format], paper: Paper
) -> dict[Format, str | bytes]:
    from report.design.comparison import ComparisonReport, spectra_overlaid
    from report.design.markdown import comparison_to_markdown
    from report.design.render import rendered
    from report.provenance import provenance

    title = f"{names[0]} and {names[1]}"
    figures = spectra_overlaid(comparison, names)
    document = ComparisonReport(title, comparison, names, figures, provenance())
    return rendered(document, comparison_to_markdown(document), formats, paper, None)


COMMAND = Command(
    "compare",
    "report on two mechanisms side by side, before and after a change; HTML and PDF",
    _configure,
    _run,
)
