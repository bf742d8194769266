"""``trimmer limit-cycles``: the limit cycles that harmonic balance predicts for a trimmer."""

from __future__ import annotations

import math
from argparse import ArgumentParser, Namespace

from trimmer.command_line.command import Command
from trimmer.command_line.file_options import (
    PICTURES,
    add_overwrite_option,
    check_targets,
    file_to_write,
    show,
)
from trimmer.command_line.loop_options import (
    add_element_options,
    add_loop_options,
    closed_loop,
)
from trimmer.command_line.parser import OptionError


def _configure(parser: ArgumentParser) -> None:
    add_element_options(parser)
    add_loop_options(parser)
    parser.add_argument(
        "--omega-range",
        nargs=2,
        type=float,
        metavar=("LOWEST", "HIGHEST"),
        help="angular frequencies to search, rad/s (default: all)",
    )
    parser.add_argument("--json", action="store_true", help="print JSON, with full precision and in SI units")
    parser.add_argument(
        "--plot",
        type=file_to_write,
        metavar="FILE",
        help="draw G and -1/N with the intersections into an .svg, .png or .pdf file",
    )
    add_overwrite_option(parser)


def _run(arguments: Namespace) -> int:
    from trimmer.balance.solve import harmonic_balance
    from trimmer.command_line.limit_cycles_text import as_json, as_text
    from trimmer.command_line.locus_picture import draw
    from trimmer.files import write_atomically

    loop = closed_loop(arguments)
    omegas = _omega_range(arguments)
    check_targets(arguments, {"plot": PICTURES}, {"parameters": "the file of the parameters"})
    balance = harmonic_balance(loop, omegas)
    if arguments.plot is not None:
        picture = draw(loop, balance, arguments.plot.suffix[1:].lower())
        write_atomically(arguments.plot, picture, overwrite=arguments.overwrite)
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
    "limit-cycles", "limit cycles by harmonic balance: amplitude, frequency, stability", _configure, _run
)
