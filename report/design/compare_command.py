"""``trimmer compare A B``: two mechanisms side by side, before and after a change."""

from __future__ import annotations

import math
import time
from argparse import ArgumentParser, Namespace
from pathlib import Path
from typing import TYPE_CHECKING

from report.design.command import (
    BUDGET,
    add_report_options,
    check_files,
    check_reach,
    formats_of,
    plain_text,
    runner_of,
    stem_of,
    told_how_to_go_on,
)
from report.pages.formats import Format, Paper
from trimmer.command_line.command import Command, uses
from trimmer.command_line.file_options import file_to_read, show
from trimmer.command_line.mechanism_options import add_set_option
from trimmer.command_line.parser import OptionError
from trimmer.deadline import NEVER, Deadline
from trimmer.files import STANDARD_INPUT, write_atomically

if TYPE_CHECKING:
    from trimmer.design.comparison import DesignComparison


def _configure(parser: ArgumentParser) -> None:
    parser.add_argument("before", type=file_to_read, metavar="A", help="mechanism before, a TOML file")
    parser.add_argument("after", type=file_to_read, metavar="B", help="mechanism after, a TOML file")
    add_set_option(parser, " (of B alone)")
    add_report_options(parser)


def _run(arguments: Namespace) -> int:
    if arguments.before == arguments.after == STANDARD_INPUT:
        raise OptionError("both files are standard input: name a file for one of them")
    formats, runner = formats_of(arguments), runner_of(arguments)
    from report.design.building import ReportPlace, looked_at
    from report.design.comparison import comparison_sentence
    from report.design.origin import today
    from report.design.progress import ProgressLines
    from trimmer.design.comparison import compared
    from trimmer.design.settings import USUAL
    from trimmer.design.specification.design_file import read_design_file
    from trimmer.mechanism.places import assignment
    from trimmer.uncertainty.sample_file import with_uncertainty

    date = today()
    changes = [assignment(text) for text in arguments.set]
    before_file, after_file = read_design_file(arguments.before), read_design_file(arguments.after, changes)
    files = [with_uncertainty(each) for each in (before_file, after_file)]
    names = _names(arguments.before, arguments.after)
    place = ReportPlace(arguments.directory, "-".join(names))
    check_files(place, formats, arguments.overwrite)
    check_reach(runner)
    allowed, designs = arguments.budget or BUDGET, []
    whole = Deadline.after(allowed) if allowed < math.inf else NEVER
    told = ProgressLines(place.log, whole)
    for file, share in zip(files, (0.5, 1.0), strict=True):
        deadline = Deadline(time.time(), whole.share(share).end)
        designs.append(looked_at(file, USUAL, runner, place.store, told, deadline, short=True))
    before, after = designs
    comparison = compared(before, after)
    for form, content in _contents(comparison, names, formats, Paper(arguments.paper), date).items():
        write_atomically(place.file(form), content, overwrite=arguments.overwrite)
    place.store.clear_old()
    sentence = plain_text(comparison_sentence(comparison, names))
    show("\n".join([sentence, *(f"  {place.file(form)}" for form in formats)]))
    return 0


def _names(before: Path, after: Path) -> tuple[str, str]:
    """Return what the two are called: their files' names, or before and after if these are the same."""
    first, second = stem_of(before), stem_of(after)
    return (first, second) if first != second else ("before", "after")


def _contents(
    comparison: DesignComparison, names: tuple[str, str], formats: frozenset[Format], paper: Paper, date: str
) -> dict[Format, str | bytes]:
    from report.design.comparison import ComparisonReport, spectra_overlaid
    from report.design.markdown import comparison_to_markdown
    from report.design.origin import origin_of
    from report.design.render import rendered
    from report.pages.escaping import shown_characters

    figures = spectra_overlaid(comparison, names)
    origin = origin_of([comparison.before.file, comparison.after.file], date)
    title = shown_characters(f"{names[0]} and {names[1]}")
    document = ComparisonReport(title, figures, origin, comparison, names)
    return rendered(document, comparison_to_markdown(document), formats, paper)


COMMAND = Command(
    "compare",
    "report on two mechanisms side by side, before and after a change; HTML and PDF",
    _configure,
    told_how_to_go_on(_run),
    examples=uses("""
    trimmer compare examples/thesis-play.toml examples/held.toml --format html
        a page on both: what changed in the file, verdicts, measures side by side, spectra
    trimmer compare examples/thesis-play.toml examples/scatter.toml --format pdf --paper letter
        the same as a PDF, of two trimmers that differ only in what is wanted of them
    """),
)
