"""``trimmer design FILE``: the report on a mechanism."""

from __future__ import annotations

import math
import re
import webbrowser
from argparse import ArgumentParser, ArgumentTypeError, Namespace
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

from report.pages.formats import Format, Paper, add_form_options
from trimmer.command_line.command import Command, uses
from trimmer.command_line.file_options import add_overwrite_option, file_to_read, folder_to_write, show
from trimmer.command_line.mechanism_options import add_set_option
from trimmer.command_line.parser import INTERRUPTED, OptionError, refuse_unused, tell
from trimmer.command_line.runner_options import add_runner_options, check_runner_options, chosen_runner
from trimmer.deadline import NEVER, Deadline
from trimmer.files import HTML, LOG, PDF, STANDARD_INPUT, check_target, write_atomically
from trimmer.mechanism.units import UnitError, quantity
from trimmer.messages import shown_value

if TYPE_CHECKING:
    from report.design.building import ReportPlace
    from report.pages.escaping import Markdown
    from trimmer.design.specification.design_file import DesignFile
    from trimmer.runners.runner import Runner

KINDS = {Format.HTML: HTML, Format.PDF: PDF}
DIRECTORY = Path("build") / "design"
BUDGET, SHORTEST = 180.0, 10.0  # Time for the work if none is given, and the least that may be given, s


def _configure(parser: ArgumentParser) -> None:
    parser.add_argument(
        "file", type=file_to_read, metavar="FILE", help="mechanism, a TOML file; - for standard input"
    )
    add_set_option(parser)
    add_report_options(parser)
    parser.add_argument(
        "--full",
        action="store_true",
        help="refine the maps from 24 x 24 cells to 96 x 96; can be interrupted and resumed",
    )
    parser.add_argument("--open", action="store_true", help="open the HTML in the browser")


def add_report_options(parser: ArgumentParser) -> None:
    """Add the options on where and how reports on designs are written."""
    parser.add_argument(
        "--directory",
        type=folder_to_write,
        metavar="DIR",
        default=DIRECTORY,
        help="folder of the report, NAME.html and NAME.pdf, and of .kept, which holds the steps that are "
        "done for the next run; it may be deleted, and steps that were not used for 30 days are deleted "
        "(default: %(default)s)",
    )
    add_form_options(parser, KINDS, "both")
    parser.add_argument(
        "--budget",
        type=time_allowed,
        metavar="TIME",
        help="time that the work may take, with its unit, as 90s or 10min, or none; spent first on what the "
        "verdict needs, and the report says what was left out "
        "(default: 3min, or none with --full of trimmer design)",
    )
    add_runner_options(parser)
    add_overwrite_option(parser)


def time_allowed(text: str) -> float:
    """Return the seconds that a text allows for the work, as the type of an option; infinite for none.

    Raises:
        ArgumentTypeError: if it is no time, or too short for anything.
    """
    if text == "none":
        return math.inf
    try:
        seconds = quantity(text, "s")
    except UnitError:
        raise ArgumentTypeError(f"{shown_value(text)} is no time: write 90s, 10min or none") from None
    if seconds < SHORTEST:
        raise ArgumentTypeError(
            f"{shown_value(text)} is too short: allow at least {SHORTEST:g}s; the pages alone take some of it"
        )
    return seconds


def formats_of(arguments: Namespace) -> frozenset[Format]:
    """Return the forms that are wanted.

    Raises:
        OptionError: if an option would have no effect.
    """
    formats = frozenset(map(Format, arguments.format)) or frozenset(KINDS)
    if Format.PDF not in formats:
        refuse_unused(arguments, ["paper"], "pdf among --format")
    return formats


def runner_of(arguments: Namespace) -> Runner:
    """Return who does the work.

    Raises:
        OptionError: if it cannot be had.
    """
    from trimmer.runners.processes import ProcessRunner

    check_runner_options(arguments)
    return chosen_runner(arguments) or ProcessRunner()


def stem_of(path: Path) -> str:
    """Return the name of the report on a file."""
    return "design" if path == STANDARD_INPUT else path.stem


def check_files(place: ReportPlace, formats: frozenset[Format], overwrite: bool) -> None:
    """Check that the files of a report may be written, before any work is done.

    Raises:
        FileWriteError: if one is there and of another kind, or cannot be made.
    """
    for form in (each for each in KINDS if each in formats):
        check_target(place.file(form), KINDS[form], overwrite=overwrite)
    check_target(place.log, LOG, overwrite=overwrite)


def check_reach(runner: Runner) -> None:
    """Check that a cluster is there, since the first steps need none.

    Raises:
        WorkerError: if it cannot be reached.
    """
    from trimmer.runners.cluster import ClusterRunner

    if isinstance(runner, ClusterRunner):
        runner.check()


def told_how_to_go_on(run: Callable[[Namespace], int]) -> Callable[[Namespace], int]:
    """Return a command's action that tells after an interrupt how to go on."""

    def told(arguments: Namespace) -> int:
        from report.design.building import DesignInterruptedError

        try:
            return run(arguments)
        except DesignInterruptedError as interruption:
            tell(str(interruption))
            return INTERRUPTED

    return told


def _run(arguments: Namespace) -> int:
    from report.design.building import ReportPlace
    from report.design.origin import today
    from trimmer.design.specification.design_file import read_design_file
    from trimmer.in_symbols.printed_symbols import printed_symbols
    from trimmer.mechanism.places import assignment
    from trimmer.uncertainty.sample_file import with_uncertainty

    formats = formats_of(arguments)
    if arguments.open and Format.HTML not in formats:
        raise OptionError("--open shows the HTML: add html to --format, or leave one of the two out")
    runner, date = runner_of(arguments), today()
    file = with_uncertainty(read_design_file(arguments.file, [assignment(text) for text in arguments.set]))
    printed_symbols(
        file.mechanism
    )  # two that print the same are told now, not when the equations are derived
    place = ReportPlace(arguments.directory, stem_of(arguments.file))
    check_files(place, formats, arguments.overwrite)
    check_reach(runner)
    _make(arguments, file, place, formats, runner, date)
    if arguments.open:
        webbrowser.open(place.file(Format.HTML).absolute().as_uri())
    return 0


def _make(
    arguments: Namespace,
    file: DesignFile,
    place: ReportPlace,
    formats: frozenset[Format],
    runner: Runner,
    date: str,
) -> None:
    from report.design.building import files_of, going_on_from, looked_at, report_on
    from report.design.progress import ProgressLines
    from report.design.words.verdict import verdict_sentence
    from trimmer.design.motions import periods_within
    from trimmer.design.settings import FULL_CELLS, USUAL, DesignSettings

    periods_within(file.mechanism, 1, 0.0)  # so that kernels that are compiled once take none of the time
    allowed = arguments.budget or (math.inf if arguments.full else BUDGET)
    deadline = Deadline.after(allowed) if allowed < math.inf else NEVER
    told = ProgressLines(place.log, deadline)
    settings = DesignSettings(cells=FULL_CELLS) if arguments.full else USUAL
    design = looked_at(file, settings, runner, place.store, told, deadline)
    with going_on_from(place.store):
        told.say("equations, pictures and pages ...")
        contents = files_of(report_on(design, place.store, date), formats, Paper(arguments.paper))
    for form, content in contents.items():
        write_atomically(place.file(form), content, overwrite=arguments.overwrite)
    place.store.clear_old()
    told.say("done")
    show("\n".join([plain_text(verdict_sentence(design)), *(f"  {place.file(form)}" for form in contents)]))


def plain_text(markdown: Markdown) -> str:
    """Return a sentence of the report for the terminal: without marks of Markdown."""
    return re.sub(r"\\([!-~])|\*\*", lambda mark: mark[1] or "", markdown)


COMMAND = Command(
    "design",
    "report on a mechanism: verdict, motions, maps, margins, what to change; HTML and PDF",
    _configure,
    told_how_to_go_on(_run),
    examples=uses("""
    trimmer design examples/den-hartog.toml --format html
        a report on an oscillator with dry friction, as build/design/den-hartog.html
    trimmer design examples/thesis.toml --format html --jobs 1
        the same of a trimmer without play, on one core
    """),
)
