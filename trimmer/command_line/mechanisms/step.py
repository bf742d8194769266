"""``trimmer step``: how a controlled mechanism follows a step of its reference."""

from argparse import ArgumentParser, Namespace

from trimmer.command_line.command import Command, uses
from trimmer.command_line.file_options import PICTURES, check_targets, show
from trimmer.command_line.mechanism_options import add_mechanism_options, note_controllers
from trimmer.command_line.mechanisms.simulation import check_periods
from trimmer.command_line.number_options import add_positive
from trimmer.command_line.output_options import add_output_options, write_picture
from trimmer.command_line.parser import exit_code
from trimmer.command_line.patience import patience


def _configure(parser: ArgumentParser) -> None:
    add_mechanism_options(parser)
    parser.add_argument(
        "--reference",
        metavar="NAME",
        help="the step, a name under [references], such as path (default: the only one)",
    )
    parser.add_argument(
        "--controller",
        metavar="NAME",
        help="whose output is measured (default: that of the only one which follows the reference)",
    )
    add_positive(
        parser, "--duration", "s", "length of the motion, s (default: until what it settles to is known)"
    )
    add_output_options(parser, "reference, output and control over time, with contact and stick marked,")


def _run(arguments: Namespace) -> int:
    from trimmer.command_line.mechanisms.step_text import as_json, as_text
    from trimmer.design.specification.design_file import read_with_targets
    from trimmer.mechanism.places import assignment
    from trimmer.response.step.step import step_response

    check_targets(arguments, {"plot": PICTURES}, {"file": "the file of the mechanism"})
    mechanism, targets = read_with_targets(arguments.file, [assignment(text) for text in arguments.set])
    note_controllers(arguments.file, mechanism)
    if arguments.duration is not None:
        check_periods(arguments.duration, mechanism.frequency)
    with patience():
        response = step_response(
            mechanism, arguments.reference, controller=arguments.controller, duration=arguments.duration
        )
    if arguments.plot is not None:
        from trimmer.drawing.mechanisms.step import step_figure

        write_picture(arguments, step_figure(response))
    show((as_json if arguments.json else as_text)(response, targets), arguments.plot)
    return exit_code(response.motion.success, response.motion.message)


COMMAND = Command(
    "step",
    "how a controlled mechanism follows a step: rise, overshoot, settling, error, hunting",
    _configure,
    _run,
    examples=uses("""
    trimmer step examples/two-mass-servo.toml --plot step.svg
        how a servo with backlash follows a step, and that it hunts; and a picture of it
    trimmer step examples/stiction-pid.toml --set controllers.axis.ki=0
        how a motor with stiction follows it without an integral: it comes to rest, with an error
    """),
)
