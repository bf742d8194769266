"""``trimmer sample``: what a mechanism or a loop does when its numbers scatter as ``[uncertainty]`` says."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import TYPE_CHECKING

from trimmer.command_line.command import Command, uses
from trimmer.command_line.file_options import PICTURES, check_targets, show
from trimmer.command_line.loops.loop_options import ELEMENT_OPTIONS
from trimmer.command_line.loops.motion_options import chosen_loop
from trimmer.command_line.mechanism_options import add_seed_option
from trimmer.command_line.number_options import add_count
from trimmer.command_line.output_options import add_file_option, add_output_options, write_picture
from trimmer.command_line.parser import (
    INTERRUPTED,
    OptionError,
    as_option,
    refuse_unused,
    require_positive,
    tell,
)
from trimmer.command_line.runner_options import (
    add_runner_options,
    check_resuming,
    check_runner_options,
    chosen_runner,
)
from trimmer.command_line.system_options import SOURCES, add_system_options, refuse_loop_options
from trimmer.files import SAMPLES, STANDARD_INPUT

if TYPE_CHECKING:
    from trimmer.uncertainty import SampleFile, SampleSettings, SampleStudy

COUNT = 512
LOOP_ALONE = ("parameters", "drive", "amplitude")
"""Options of loops that predictions of limit cycles do not use."""
PLANS = ("latin-hypercube", "sobol")


def _configure(parser: ArgumentParser) -> None:
    add_system_options(
        parser,
        output_is_file=True,
        file_help="mechanism with [uncertainty], a TOML file, - for standard input; without one, a loop of "
        "the thesis (see --element), whose --parameters FILE has [uncertainty]; for a parameter file here, "
        "with --gap and no --element, limit cycles are predicted",
    )
    add_count(parser, "--count", "samples; of --plan sobol and for --indices the next power of two", COUNT)
    parser.add_argument(
        "--plan", choices=PLANS, default=PLANS[0], help="how samples are chosen (default: %(default)s)"
    )
    add_seed_option(parser, "samples")
    add_count(parser, "--periods", "drive periods to wait for each to settle", 300)
    parser.add_argument(
        "--indices",
        action="store_true",
        help="Sobol indices: the share of each number in the scatter of each measure; for D numbers that "
        "scatter this takes N (D + 2) samples; needs pip install 'trimmer[sensitivity]'",
    )
    add_count(
        parser,
        "--balance",
        "harmonic balance too, for M of the samples that repeat, with its distance to the exact orbit",
        metavar="M",
    )
    add_file_option(
        parser, "--output", "keep each sample in a file as soon as it is done, to be able to go on"
    )
    parser.add_argument("--resume", action="store_true", help="go on with the file of --output")
    add_output_options(parser, "how the measures are distributed")
    add_runner_options(parser)


def _run(arguments: Namespace) -> int:
    from trimmer.command_line.mechanisms.sample_text import as_json, as_text

    _check(arguments)
    if arguments.file is not None and arguments.gap is not None and arguments.element is None:
        return _run_limit_cycles(arguments)
    file = _file(arguments)
    try:
        study = _study(arguments, file)
    except KeyboardInterrupt:
        if arguments.output is None:
            raise
        tell(f"interrupted; what is done is in {arguments.output}: the same call with --resume goes on")
        return INTERRUPTED
    if arguments.plot is not None:
        from trimmer.drawing.mechanisms.scatter import sample_figure

        write_picture(arguments, sample_figure(study.samples))
    show(as_json(study) if arguments.json else as_text(study), arguments.plot, arguments.output)
    return 0


def _file(arguments: Namespace) -> SampleFile:
    """Return what is sampled: the mechanism of a file, or a loop with what its parameter file says."""
    from trimmer.mechanism.places import assignment
    from trimmer.uncertainty.parameter_file import read_uncertainty_of_loop
    from trimmer.uncertainty.sample_file import SampleFile, read_sample_file

    if arguments.file is not None:
        refuse_loop_options(arguments)
        return read_sample_file(arguments.file, [assignment(text) for text in arguments.set])
    if arguments.parameters is None or arguments.parameters == STANDARD_INPUT:
        raise OptionError(
            "say what scatters: name the file of a mechanism with [uncertainty], or of a loop a file with "
            "that table (--parameters FILE), which is read twice"
        )
    refuse_unused(arguments, ["balance"], "a mechanism")
    loop = chosen_loop(arguments)
    if loop.drive is None:
        refuse_unused(arguments, ["periods"], "--drive; the orbits of a loop without it are searched for")
    return SampleFile(loop, (), read_uncertainty_of_loop(arguments.parameters, loop))


def _run_limit_cycles(arguments: Namespace) -> int:
    """Sample the limit cycles of the thesis's loop."""
    from trimmer.command_line.mechanisms.limit_cycle_sample_text import as_json, as_text
    from trimmer.uncertainty.limit_cycle_samples import read_parameter_sample_file, sample_limit_cycles

    require_positive(arguments, "gap", "m")
    refuse_unused(arguments, [each for each in ELEMENT_OPTIONS if each != "gap"], "--element")
    for name in ("friction", "set"):
        if getattr(arguments, name):
            raise OptionError(f"{as_option(name)} has no effect without --element: add that, or leave it out")
    unused = ("balance", "output", "plot", "jobs", "scheduler", "periods", *LOOP_ALONE)
    refuse_unused(
        arguments, unused, "a mechanism or --element; a parameter file with --gap has limit cycles alone"
    )
    samples = sample_limit_cycles(
        read_parameter_sample_file(arguments.file, arguments.gap),
        _settings(arguments),
        indices=arguments.indices,
        output=arguments.displacement,
        channels=arguments.channels,
    )
    print(as_json(samples) if arguments.json else as_text(samples))
    return 0


def _check(arguments: Namespace) -> None:
    """Refuse what cannot be meant, before any work is done."""
    check_resuming(arguments)
    if arguments.indices and arguments.plan != PLANS[0]:
        raise OptionError("--indices chooses the samples itself: leave out --plan")
    check_runner_options(arguments)
    targets = {"plot": PICTURES, "output": {"": SAMPLES}}
    check_targets(arguments, targets, SOURCES)


def _study(arguments: Namespace, file: SampleFile) -> SampleStudy:
    from trimmer.uncertainty.sample_records import Keeping
    from trimmer.uncertainty.study import study_samples

    return study_samples(
        file,
        _settings(arguments),
        indices=arguments.indices,
        balanced=arguments.balance or 0,
        runner=chosen_runner(arguments),
        keeping=Keeping(arguments.output, arguments.resume, arguments.overwrite),
        quiet=arguments.quiet,
    )


def _settings(arguments: Namespace) -> SampleSettings:
    from trimmer.uncertainty.points import Plan
    from trimmer.uncertainty.sample_inputs import SampleSettings

    plan = Plan.chosen(arguments.plan, "plan")
    return SampleSettings(arguments.count, plan, arguments.seed, arguments.periods)


COMMAND = Command(
    "sample",
    "what a mechanism or a loop does when its numbers scatter: distributions, yield, what matters",
    _configure,
    _run,
    examples=uses("""
    trimmer sample examples/scatter.toml --count 64
        in how many of a series of trimmers the motion repeats in every drive period, and how the stroke
        scatters
    trimmer sample examples/scatter.toml --count 32 --indices
        which number of the trimmer is responsible for that
    """),
)
