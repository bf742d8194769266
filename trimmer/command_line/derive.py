"""``trimmer derive``: make the numeric module again, and write the derivations as LaTeX."""

from __future__ import annotations

import sys
from argparse import ArgumentParser, Namespace
from pathlib import Path

from trimmer.command_line.command import Command
from trimmer.command_line.file_options import add_overwrite_option, check_targets, file_to_write, show
from trimmer.files import LATEX, MODULE, write_atomically

DIRECTORY = Path("build") / "derivation"


def _configure(parser: ArgumentParser) -> None:
    parser.add_argument(
        "--module",
        type=file_to_write,
        metavar="FILE",
        default=DIRECTORY / "linear_trimmer.py",
        help="where to write the numeric Python module (default: %(default)s)",
    )
    parser.add_argument(
        "--latex",
        type=file_to_write,
        metavar="FILE",
        default=DIRECTORY / "derivation.tex",
        help="where to write the derivations as LaTeX (default: %(default)s)",
    )
    add_overwrite_option(parser)


def _run(arguments: Namespace) -> int:
    from trimmer.code_generation import derive_sources
    from trimmer.generated import linear_trimmer

    check_targets(arguments, {"module": {"": MODULE}, "latex": {"": LATEX}}, {})
    installed = Path(linear_trimmer.__file__).read_text(encoding="utf-8")
    print("deriving the linear trimmer and the describing functions ...", file=sys.stderr)
    sources = derive_sources()
    write_atomically(arguments.module, sources.module, overwrite=arguments.overwrite)
    write_atomically(arguments.latex, sources.latex, overwrite=arguments.overwrite)
    state = "the same as the one in use" if sources.module == installed else "different from the one in use"
    text = f"{arguments.module}: numeric module, {state}\n{arguments.latex}: derivations"
    show(text, arguments.module, arguments.latex)
    return 0


COMMAND = Command(
    "derive",
    "derive equations of motion and describing functions again; write numeric module and LaTeX",
    _configure,
    _run,
)
