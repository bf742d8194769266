"""``trimmer linear``: modes, resonances, bandwidth and stability of the linear trimmer."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace

from trimmer.command_line.command import Command, Example
from trimmer.command_line.file_options import PICTURES, add_overwrite_option, check_targets, show
from trimmer.command_line.loops.loop_options import add_loop_options, chosen_parameters
from trimmer.command_line.output_options import add_json_option, add_plot_option, write_picture


def _configure(parser: ArgumentParser) -> None:
    add_loop_options(parser)
    add_json_option(parser)
    add_plot_option(parser, "the Bode plot with natural modes, peaks and dips")
    add_overwrite_option(parser)


def _run(arguments: Namespace) -> int:
    from trimmer.displacement import Displacement

    check_targets(arguments, {"plot": PICTURES}, {"parameters": "the file of the parameters"})
    output, parameters = Displacement.parse(arguments.displacement), chosen_parameters(arguments)
    # These take their time to be imported, which what cannot be used need not wait for.
    from trimmer.command_line.loops.linear_text import as_json, as_text
    from trimmer.linear.summary import summarise

    summary = summarise(parameters, output, arguments.channels)
    if arguments.plot is not None:
        from trimmer.drawing.frequency_response import summary_figure

        write_picture(arguments, summary_figure(summary))
    show(as_json(summary) if arguments.json else as_text(summary), arguments.plot)
    return 0


COMMAND = Command(
    "linear",
    "modes, resonances, bandwidth and stability of the linear trimmer",
    _configure,
    _run,
    examples=(
        Example(
            "trimmer linear",
            "at what frequencies the trimmer vibrates by itself, and how much each mode is damped",
        ),
        Example(
            "trimmer linear --output q2 --channels displacement",
            "the same where the cutter is watched from the ground, and the pin acts as in the thesis",
        ),
        Example(
            "trimmer linear --parameters mine.toml --json",
            "the same of a trimmer of your own, for a program; `trimmer parameters` writes mine.toml",
        ),
    ),
)
