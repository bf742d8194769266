"""``trimmer sample``: what a mechanism does when its numbers scatter as ``[uncertainty]`` says."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import TYPE_CHECKING

from trimmer.command_line.command import Command, Example
from trimmer.command_line.file_options import (
    PICTURES,
    add_overwrite_option,
    check_targets,
    file_to_read,
    file_to_write,
    show,
)
from trimmer.command_line.number_options import positive, positive_whole
from trimmer.command_line.output_options import add_json_option, add_plot_option, write_picture
from trimmer.command_line.parser import INTERRUPTED, OptionError, refuse_unused, tell
from trimmer.command_line.runner_options import (
    add_runner_options,
    check_resuming,
    check_runner_options,
    chosen_runner,
)
from trimmer.files import SAMPLES

if TYPE_CHECKING:
    from trimmer.uncertainty.sample_file import SampleFile
    from trimmer.uncertainty.sample_inputs import SampleSettings
    from trimmer.uncertainty.study import SampleStudy

COUNT = 512
CHANNELS = ("both", "displacement")
PLANS = ("latin-hypercube", "sobol")


def _configure(parser: ArgumentParser) -> None:
    parser.add_argument(
        "file",
        type=file_to_read,
        metavar="FILE",
        help="mechanism with [uncertainty], a TOML file, - for standard input; or a parameter file of the "
        "thesis's loop, with --gap",
    )
    parser.add_argument(
        "--gap", type=positive("m"), metavar="M", help="of a parameter file: total clearance of the play, m"
    )
    parser.add_argument(
        "--channels",
        choices=CHANNELS,
        help="of a parameter file: whether the pin acts by its displacement alone, or by its velocity too "
        f"(default: {CHANNELS[0]})",
    )
    parser.add_argument(
        "--count",
        type=positive_whole,
        default=COUNT,
        metavar="N",
        help=f"samples; of --plan sobol and for --indices the next power of two (default: {COUNT})",
    )
    parser.add_argument(
        "--plan", choices=PLANS, default=PLANS[0], help="how samples are chosen (default: %(default)s)"
    )
    parser.add_argument("--seed", type=int, default=0, metavar="N", help="of the samples (default: 0)")
    parser.add_argument(
        "--periods",
        type=positive_whole,
        default=300,
        metavar="N",
        help="drive periods to wait for each to settle (default: 300)",
    )
    parser.add_argument(
        "--indices",
        action="store_true",
        help="Sobol indices: which number matters for what; of D numbers that scatter this takes N (D + 2) "
        "samples; needs pip install 'trimmer[sensitivity]'",
    )
    parser.add_argument(
        "--balance",
        type=positive_whole,
        metavar="M",
        help="harmonic balance too, for M of the samples that repeat, with its distance to the exact orbit",
    )
    parser.add_argument(
        "--output",
        type=file_to_write,
        metavar="FILE",
        help="keep each sample in a file as soon as it is done, to be able to go on",
    )
    parser.add_argument("--resume", action="store_true", help="go on with the file of --output")
    add_json_option(parser)
    add_plot_option(parser, "how the measures are distributed")
    add_overwrite_option(parser)
    add_runner_options(parser)


def _run(arguments: Namespace) -> int:
    from trimmer.command_line.mechanisms.sample_text import as_json, as_text
    from trimmer.uncertainty.sample_file import read_sample_file

    _check(arguments)
    if arguments.gap is not None:
        return _run_loop(arguments)
    refuse_unused(arguments, ["channels"], "--gap and a parameter file")
    file = read_sample_file(arguments.file)
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


def _run_loop(arguments: Namespace) -> int:
    """Sample the thesis's loop."""
    from trimmer.command_line.mechanisms.loop_sample_text import as_json, as_text
    from trimmer.uncertainty.loop_samples import read_loop_file, sample_loop

    unused = ("balance", "output", "plot", "jobs", "scheduler")
    refuse_unused(arguments, unused, "a mechanism, and with --gap the samples are of the thesis's loop")
    file = read_loop_file(arguments.file, arguments.gap)
    channels = arguments.channels or CHANNELS[0]
    samples = sample_loop(file, _settings(arguments), indices=arguments.indices, channels=channels)
    print(as_json(samples) if arguments.json else as_text(samples))
    return 0


def _check(arguments: Namespace) -> None:
    """Refuse what cannot be meant, before any work is done."""
    check_resuming(arguments)
    if arguments.seed < 0:
        raise OptionError(f"--seed {arguments.seed}: give a whole number from 0 on")
    if arguments.indices and arguments.plan != PLANS[0]:
        raise OptionError("--indices chooses the samples itself: leave out --plan")
    check_runner_options(arguments)
    targets = {"plot": PICTURES, "output": {"": SAMPLES}}
    check_targets(arguments, targets, {"file": "the file of the mechanism"})


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
    "what a mechanism does when its numbers scatter: distributions, yield, what matters",
    _configure,
    _run,
    examples=(
        Example(
            "trimmer sample examples/scatter.toml --count 64",
            "in how many of a series of trimmers the motion keeps to the drive, and how the stroke scatters",
        ),
        Example(
            "trimmer sample examples/scatter.toml --count 32 --indices",
            "which number of the trimmer is to blame for that",
        ),
    ),
)
"""The subcommand ``trimmer sample``."""
