"""``trimmer linear``: modes, resonances, bandwidth and stability of the linear trimmer."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace

from trimmer.command_line.command import Command
from trimmer.command_line.loop_options import add_loop_options


def _configure(parser: ArgumentParser) -> None:
    add_loop_options(parser)
    parser.add_argument("--json", action="store_true", help="print JSON, with full precision and in SI units")


def _run(arguments: Namespace) -> int:
    from trimmer.command_line.linear_text import as_json, as_text
    from trimmer.displacement import Displacement
    from trimmer.linear.summary import summarise
    from trimmer.parameters import TrimmerParameters

    output = Displacement.parse(arguments.output)
    chosen = arguments.parameters
    parameters = TrimmerParameters.thesis() if chosen is None else TrimmerParameters.from_toml(chosen)
    summary = summarise(parameters, output, arguments.channels)
    print(as_json(summary) if arguments.json else as_text(summary))
    return 0


COMMAND = Command(
    "linear", "modes, resonances, bandwidth and stability of the linear trimmer", _configure, _run
)
