"""``trimmer identify``: time constant of the load behind a backlash, from a measured frequency."""

from argparse import ArgumentParser, Namespace

from trimmer.command_line.command import Command, uses
from trimmer.command_line.file_options import PICTURES, check_targets, show
from trimmer.command_line.loops.loop_options import add_loop_options, linear_part
from trimmer.command_line.number_options import positive
from trimmer.command_line.output_options import add_output_options, write_picture
from trimmer.command_line.parser import OptionError


def _configure(parser: ArgumentParser) -> None:
    parser.add_argument("--gap", type=positive("m"), metavar="M", required=True, help="total clearance, m")
    parser.add_argument(
        "--frequency", type=positive("Hz"), metavar="HZ", required=True, help="frequency of the cycle, Hz"
    )
    parser.add_argument(
        "--uncertainty",
        type=float,
        metavar="HZ",
        default=0.0,
        help="how far the frequency may be off, either way, Hz (default: 0); gives M/D as an interval",
    )
    add_loop_options(parser)
    add_output_options(parser, "M/D over the frequency, with what was measured,")


def _run(arguments: Namespace) -> int:
    from trimmer.balance.identification import identify_time_constant
    from trimmer.command_line.loops.limit_cycles_text import identified_as_json, identified_as_text

    if not 0 <= arguments.uncertainty < arguments.frequency:
        raise OptionError(
            f"--uncertainty {arguments.uncertainty:g}: must be zero or positive, less than --frequency (Hz)"
        )
    check_targets(arguments, {"plot": PICTURES}, {"parameters": "the file of the parameters"})
    G = linear_part(arguments)
    try:
        found = identify_time_constant(
            G, arguments.gap, arguments.frequency, frequency_uncertainty=arguments.uncertainty
        )
    except ValueError as error:
        raise OptionError.of(error) from error
    if arguments.plot is not None:
        from trimmer.drawing.content import figure_of

        write_picture(arguments, figure_of(found.plot))
    show((identified_as_json if arguments.json else identified_as_text)(found), arguments.plot)
    return 0


COMMAND = Command(
    "identify",
    "time constant M/D of the load behind a backlash, from a measured frequency",
    _configure,
    _run,
    examples=uses("""
    trimmer identify --gap 4e-5 --frequency 740 --channels displacement
        which M/D of the load gives a limit cycle at 740 Hz, as it was measured
    trimmer identify --gap 4e-5 --frequency 740 --uncertainty 2 --channels displacement
        the same as an interval, if the measurement may be off by 2 Hz
    """),
)
