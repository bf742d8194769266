"""``trimmer linear``: modes, resonances, bandwidth and stability of the linear trimmer."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace

from trimmer.command_line.command import Command
from trimmer.command_line.loops.loop_options import add_loop_options, chosen_parameters
from trimmer.command_line.output_options import add_json_option


def _configure(parser: ArgumentParser) -> None:
    add_loop_options(parser)
    add_json_option(parser)


def _run(arguments: Namespace) -> int:
    from trimmer.command_line.loops.linear_text import as_json, as_text
    from trimmer.displacement import Displacement
    from trimmer.linear.summary import summarise

    output = Displacement.parse(arguments.output)
    summary = summarise(chosen_parameters(arguments), output, arguments.channels)
    print(as_json(summary) if arguments.json else as_text(summary))
    return 0


COMMAND = Command(
    "linear", "modes, resonances, bandwidth and stability of the linear trimmer", _configure, _run
)
