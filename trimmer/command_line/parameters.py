"""``trimmer parameters``: the commented parameter file to start from."""

from argparse import ArgumentParser, Namespace

from trimmer.command_line.command import Command, uses
from trimmer.command_line.file_options import keep, show
from trimmer.command_line.output_options import add_file_option


def _configure(parser: ArgumentParser) -> None:
    add_file_option(
        parser, "--output", "file to write (default: print it); an existing file is kept unless it is empty"
    )


def _run(arguments: Namespace) -> int:
    from trimmer.files import write_atomically
    from trimmer.parameters import TrimmerParameters

    template = TrimmerParameters.thesis().to_toml()
    if arguments.output is None:
        print(template, end="")
        return 0
    keep(arguments.output)
    write_atomically(arguments.output, template)
    show(f"wrote {arguments.output}", arguments.output)
    return 0


COMMAND = Command(
    "parameters",
    "write a commented parameter file (the thesis's trimmer)",
    _configure,
    _run,
    examples=uses("""
    trimmer parameters
        what the parameters of the thesis's trimmer are
    trimmer parameters --output mine.toml
        the same in a file: change the numbers, then `trimmer linear --parameters mine.toml`
    """),
)
