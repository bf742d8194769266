"""``trimmer parameters``: the commented parameter file to start from."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from pathlib import Path

from trimmer.command_line.command import Command


def _configure(parser: ArgumentParser) -> None:
    parser.add_argument(
        "--output",
        metavar="FILE",
        type=Path,
        help="file to write (default: print it); a file that is there is kept",
    )


def _run(arguments: Namespace) -> int:
    from trimmer.files import FileWriteError, write_atomically
    from trimmer.parameters import TrimmerParameters

    template = TrimmerParameters.thesis().to_toml()
    if arguments.output is None:
        print(template, end="")
        return 0
    if arguments.output.is_file():
        raise FileWriteError(f"{arguments.output} is there already: name another file, or remove it first")
    write_atomically(arguments.output, template)
    print(f"wrote {arguments.output}")
    return 0


COMMAND = Command("parameters", "write a commented parameter file (the thesis's trimmer)", _configure, _run)
