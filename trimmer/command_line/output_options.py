"""Options of how a result is shown: as JSON, or as a picture in a file."""

from __future__ import annotations

from argparse import ArgumentError, ArgumentParser, Namespace
from contextlib import suppress
from typing import TYPE_CHECKING

from trimmer.command_line.file_options import file_to_write
from trimmer.files import write_atomically

if TYPE_CHECKING:
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
            "files stay as they are, but text that would make way for a file on standard output is left out",
        )


def add_plot_option(parser: ArgumentParser, what: str) -> None:
    """Add ``--plot``.

    Args:
        parser: The parser of the command.
        what: What is drawn, for the help, such as "the branch".
    """
    parser.add_argument(
        "--plot", type=file_to_write, metavar="FILE", help=f"draw {what} into an .svg, .png or .pdf file"
    )


def write_picture(arguments: Namespace, figure: Figure) -> None:
    """Write the file that ``--plot`` names, as its name ends: SVG, PNG or PDF.

    Args:
        arguments: The options, with ``--plot``.
        figure: The picture.

    Raises:
        TrimmerError: if it cannot be written.
    """
    from trimmer.drawing.content import content_of

    picture = content_of(figure, arguments.plot.suffix[1:].lower())
    write_atomically(arguments.plot, picture, overwrite=arguments.overwrite)
