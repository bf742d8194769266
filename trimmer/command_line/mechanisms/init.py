"""``trimmer init``: a commented mechanism file to start from."""

from argparse import ArgumentParser, Namespace
from pathlib import Path

from trimmer.command_line.command import Command, Example
from trimmer.command_line.file_options import file_to_write, keep, show
from trimmer.examples import USUAL, examples

FILE = Path("trimmer.toml")


def _configure(parser: ArgumentParser) -> None:
    parser.add_argument(
        "file",
        type=file_to_write,
        nargs="?",
        metavar="FILE",
        default=FILE,
        help="file to write (default: %(default)s); an existing file is kept unless it is empty",
    )
    parser.add_argument(
        "--example",
        choices=examples(),
        default=USUAL,
        help="which mechanism (default: %(default)s, a hair trimmer with play and friction)",
    )


def _run(arguments: Namespace) -> int:
    from trimmer.examples import example_tables, example_text
    from trimmer.files import write_atomically

    target: Path = arguments.file
    tables = {target.parent / name: text for name, text in example_tables(arguments.example).items()}
    for path in (target, *tables):
        keep(path)
    for path, text in tables.items():
        write_atomically(path, text)
    write_atomically(target, example_text(arguments.example))
    show(f"wrote {target}; change it, then: trimmer design {target}", target)
    return 0


COMMAND = Command(
    "init",
    "write a commented mechanism file to start from",
    _configure,
    _run,
    examples=(
        Example("trimmer init machine.toml", "a hair trimmer with play and friction, to change its numbers"),
        Example("trimmer init shaver.toml --example foil-shaver", "two cutters that move against each other"),
    ),
)
