"""Options of how a result is shown: as JSON, or as a picture in a file."""

from __future__ import annotations

from argparse import ArgumentError, ArgumentParser, Namespace
from contextlib import suppress
from typing import TYPE_CHECKING

from trimmer.command_line.file_options import add_overwrite_option, file_to_write
from trimmer.command_line.parser import tell
from trimmer.files import write_atomically

if TYPE_CHECKING:
    from pathlib import Path

    from matplotlib.figure import Figure


def add_json_option(parser: ArgumentParser) -> None:
    """Add ``--json``."""
    parser.add_argument("--json", action="store_true", help="print JSON, with full precision and in SI units")


def add_quiet_option(parser: ArgumentParser) -> None:
    """Add ``--quiet``, unless a command of another package has one of its own."""
    with suppress(ArgumentError):
        parser.add_argument(
            "--quiet",
            action="store_true",
            help="print nothing but errors on standard error: no progress, no notes; results, --json and "
            "files stay as they are; if a file is written to standard output, the text of the result is left "
            "out",
        )


def add_plot_option(parser: ArgumentParser, what: str) -> None:
    """Add ``--plot`` of what is drawn, such as "the branch"."""
    add_file_option(parser, "--plot", f"draw {what} into an .svg, .png or .pdf file")


def add_output_options(parser: ArgumentParser, what: str) -> None:
    """Add ``--json``, ``--plot`` of what is drawn, and ``--overwrite``."""
    add_json_option(parser)
    add_plot_option(parser, what)
    add_overwrite_option(parser)


def add_file_option(parser: ArgumentParser, name: str, meaning: str) -> None:
    """Add an option that names a file to write."""
    parser.add_argument(name, type=file_to_write, metavar="FILE", help=meaning)


def wanted_picture(arguments: Namespace, missing: str) -> Path | None:
    """Return the file that ``--plot`` names; None without one, or if what is missing, in words, is told."""
    target: Path | None = arguments.plot
    if target is None or not missing:
        return target
    tell(f"{target} was not written, because {missing}")
    return None


def write_picture(arguments: Namespace, figure: Figure) -> None:
    """Write the file that ``--plot`` names, as its name ends: SVG, PNG or PDF."""
    from trimmer.drawing.content import content_of

    picture = content_of(figure, arguments.plot.suffix[1:].lower())
    write_atomically(arguments.plot, picture, overwrite=arguments.overwrite)
