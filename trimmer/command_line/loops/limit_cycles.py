"""``trimmer limit-cycles``: the limit cycles that harmonic balance predicts for a trimmer."""

from __future__ import annotations

import math
from argparse import ArgumentParser, Namespace

from trimmer.command_line.command import Command, uses
from trimmer.command_line.file_options import PICTURES, check_targets, show
from trimmer.command_line.loops.loop_options import (
    add_element_options,
    add_loop_options,
    add_response_option,
    chosen_loop,
)
from trimmer.command_line.output_options import add_output_options, write_picture
from trimmer.command_line.parser import OptionError


def _configure(parser: ArgumentParser) -> None:
    add_element_options(parser)
    add_loop_options(parser)
    add_response_option(parser)
    parser.add_argument(
        "--omega-range",
        nargs=2,
        type=float,
        metavar=("LOWEST", "HIGHEST"),
        help="angular frequencies to search, rad/s (default: all)",
    )
    add_output_options(parser, "G and -1/N with the intersections")


def _run(arguments: Namespace) -> int:
    from trimmer.balance.solve import harmonic_balance
    from trimmer.command_line.loops.limit_cycles_text import as_json, as_text

    omegas = _omega_range(arguments)
    sources = {"parameters": "the file of the parameters", "response": "the file of the response"}
    check_targets(arguments, {"plot": PICTURES}, sources)
    loop = chosen_loop(arguments)
    balance = harmonic_balance(loop.system, loop.element, omegas)
    if arguments.plot is not None:
        from trimmer.drawing.locus import balance_figure

        write_picture(arguments, balance_figure(balance))
    show((as_json if arguments.json else as_text)(loop, balance), arguments.plot)
    return 0


def _omega_range(arguments: Namespace) -> tuple[float, float] | None:
    if arguments.omega_range is None:
        return None
    lowest, highest = arguments.omega_range
    if not 0 < lowest < highest < math.inf:
        raise OptionError(f"--omega-range {lowest:g} {highest:g}: needs 0 < lowest < highest < inf (rad/s)")
    return lowest, highest


COMMAND = Command(
    "limit-cycles",
    "limit cycles by harmonic balance: amplitude, frequency, stability",
    _configure,
    _run,
    examples=uses("""
    trimmer limit-cycles --element friction --gap 4e-5
        which vibrations a play of 40 um can keep up, and which of them are stable
    trimmer limit-cycles --element viscous --gap 4e-5 --time-constant 1e-3 --plot loci.svg
        the same with a heavy load behind the play, and a picture of the curves that meet
    trimmer limit-cycles --element coulomb --force 0.5 --channels displacement
        whether dry friction in place of the play can keep up a vibration
    """),
)
