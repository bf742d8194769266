"""``trimmer linear``: modes and frequency responses of a mechanism, or of the thesis's linear trimmer."""

from argparse import ArgumentParser, Namespace

from trimmer.command_line.command import Command, uses
from trimmer.command_line.file_options import PICTURES, add_input, check_targets, show
from trimmer.command_line.loops.loop_options import add_loop_options, chosen_parameters
from trimmer.command_line.mechanism_options import add_set_option, chosen_mechanism
from trimmer.command_line.output_options import add_output_options, write_picture
from trimmer.command_line.parser import OptionError, as_option
from trimmer.command_line.system_options import SOURCES, refuse_loop_options


def _configure(parser: ArgumentParser) -> None:
    add_input(
        parser,
        "file",
        "mechanism, a TOML file, - for standard input; without one, the linear trimmer of the thesis",
        optional=True,
    )
    add_set_option(parser)
    parser.add_argument(
        "--contacts",
        action="append",
        default=[],
        metavar="STATE",
        help="of a mechanism: closed, open, or one by name, such as bridge=open, with the others "
        "closed; may be repeated (default: all closed, then all open)",
    )
    add_loop_options(parser)
    add_output_options(
        parser, "the Bode plot with natural modes, or of a mechanism responses and mode shapes,"
    )


def _run(arguments: Namespace) -> int:
    from trimmer.displacement import Displacement

    check_targets(arguments, {"plot": PICTURES}, SOURCES)
    if arguments.file is not None:
        refuse_loop_options(arguments)
        return _of_mechanism(arguments)
    for name in ("set", "contacts"):
        if getattr(arguments, name):
            raise OptionError(f"{as_option(name)} is for mechanisms: name the file of one")
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


def _of_mechanism(arguments: Namespace) -> int:
    from trimmer.command_line.mechanisms.linear_text import as_json, as_text, chosen_states

    mechanism = chosen_mechanism(arguments)
    states = chosen_states(mechanism, arguments.contacts)
    if arguments.plot is not None:
        from trimmer.drawing.mechanisms.linear import linear_figure

        write_picture(arguments, linear_figure(mechanism, states))
    show(as_json(mechanism, states) if arguments.json else as_text(mechanism, states), arguments.plot)
    return 0


COMMAND = Command(
    "linear",
    "modes and frequency responses of a mechanism, or of the linear trimmer of the thesis",
    _configure,
    _run,
    examples=uses("""
    trimmer linear
        at what frequencies the trimmer vibrates by itself, and how much each mode is damped
    trimmer linear examples/thesis-play.toml --plot modes.svg
        modes and responses of the trimmer with play, with its slot closed and open
    trimmer linear --parameters mine.toml --json
        the same of a trimmer of your own, for a program; `trimmer parameters` writes mine.toml
    """),
)
