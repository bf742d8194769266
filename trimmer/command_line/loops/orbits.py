"""``trimmer orbits``: exact limit cycles of a trimmer, beside the predictions of harmonic balance."""

import warnings
from argparse import ArgumentParser, Namespace

from trimmer.command_line.command import Command, uses
from trimmer.command_line.file_options import PICTURES, check_targets, show
from trimmer.command_line.loops.loop_options import (
    add_element_options,
    add_loop_options,
    closed_loop,
    unusable,
)
from trimmer.command_line.output_options import add_output_options, wanted_picture, write_picture
from trimmer.command_line.parser import INTERRUPTED, tell
from trimmer.command_line.patience import patience


def _configure(parser: ArgumentParser) -> None:
    add_element_options(parser)
    add_loop_options(parser)
    parser.add_argument(
        "--simulate",
        action="store_true",
        help="look for more stable orbits by simulation from 32 initial states",
    )
    add_output_options(parser, "the orbits in the phase plane of the play")


def _run(arguments: Namespace) -> int:
    from trimmer.balance.solve import harmonic_balance
    from trimmer.command_line.loops.orbits_text import as_json, as_text
    from trimmer.errors import OrbitNotFoundWarning
    from trimmer.orbits.periodic_orbits import periodic_orbits
    from trimmer.orbits.search import OrbitSearch, OrbitSearchInterrupted, Simulations

    loop = closed_loop(arguments)
    check_targets(arguments, {"plot": PICTURES}, {"parameters": "the file of the parameters"})
    predictions = harmonic_balance(loop)
    interrupted = False
    with warnings.catch_warnings():
        # The table says it too, beside the prediction.
        warnings.simplefilter("ignore", OrbitNotFoundWarning)
        try:
            search = OrbitSearch(simulations=Simulations.ALWAYS) if arguments.simulate else None
            with patience():
                orbits = periodic_orbits(loop, predictions, search=search)
        except OrbitSearchInterrupted as interrupt:
            orbits, interrupted = interrupt.orbits, True
        except ValueError as error:
            raise unusable(arguments, error) from error
    picture = wanted_picture(arguments, "" if orbits else "no orbit was found")
    if picture is not None:
        from trimmer.drawing.content import figure_of

        write_picture(arguments, figure_of(orbits.plot))
    text = (as_json if arguments.json else as_text)(loop.element, predictions, orbits)
    show(text, picture)
    if interrupted:
        tell("interrupted; what was found until then is printed")
    return INTERRUPTED if interrupted else 0


COMMAND = Command(
    "orbits",
    "exact orbits of a loop that oscillates by itself, with the error of harmonic balance",
    _configure,
    _run,
    examples=uses("""
    trimmer orbits --element friction --gap 4e-5
        what exact vibrations there are, and how far off the predictions of `trimmer limit-cycles` are
    trimmer orbits --element inertia --gap 4e-5 --simulate
        the same with a load of inertia alone, and whether motions from 32 starts settle to others
    """),
)
