"""``trimmer spectrum``: the spectrum of a measured signal, and what its peaks may be."""

from __future__ import annotations

import warnings
from argparse import ArgumentParser, Namespace
from typing import TYPE_CHECKING

from trimmer.command_line.command import Command, uses
from trimmer.command_line.file_options import PICTURES, add_input, add_overwrite_option, check_targets, show
from trimmer.command_line.loops.loop_options import (
    ELEMENT_OPTIONS,
    add_element_options,
    add_loop_options,
    add_response_option,
    chosen_loop,
    chosen_parameters,
)
from trimmer.command_line.mechanism_options import add_set_option, mechanism_with
from trimmer.command_line.number_options import add_count, add_positive
from trimmer.command_line.output_options import (
    add_file_option,
    add_json_option,
    add_plot_option,
    write_picture,
)
from trimmer.command_line.parser import OptionError, as_option, is_given, refuse_unused
from trimmer.command_line.signals.signal_options import ChosenRecording, add_signal_options, chosen_recording
from trimmer.files import CSV, STANDARD_INPUT, WAV

if TYPE_CHECKING:
    from trimmer.command_line.signals.spectrum_text import PredictedFrequencies
    from trimmer.signals import Signal, WavFile
    from trimmer.spectra import AveragedSpectrum, MotionComparison, SpectrumAnalysis

WINDOWS = ("rectangular", "hann", "blackman-harris", "flat-top")
BIT_DEPTHS = (16, 24)


def _configure(parser: ArgumentParser) -> None:
    add_signal_options(parser)
    add_positive(
        parser,
        "--drive",
        "Hz",
        "frequency of the drive, Hz, whose harmonics are fitted, and looked for among the peaks",
        also="--drive-frequency",
    )
    add_positive(
        parser,
        "--gap",
        "m",
        "total clearance of a friction-controlled play, whose stable limit cycles (harmonic balance) "
        "are looked for too",
    )
    add_element_options(parser, required=False, gap=False)
    add_response_option(parser)
    parser.add_argument(
        "--closed-loop",
        action="store_true",
        help="the output is fed back to the pin although there is a drive; without this option a driven "
        "trimmer is taken to have no limit cycle, since that needs the feedback",
    )
    add_input(
        parser,
        "--against",
        "mechanism, a TOML file, whose natural modes, with its contacts closed and open, are looked for "
        "in place of the thesis's, and whose motion is shown for comparison; --output names its output",
    )
    add_set_option(parser)
    add_positive(
        parser,
        "--mains",
        "Hz",
        "frequency of the mains, Hz, whose hum is looked for among the peaks (default: 50 and 60)",
    )
    parser.add_argument("--window", choices=WINDOWS, default="hann", help="window function (default: hann)")
    add_count(parser, "--limit", "number of peaks", 20)
    add_count(
        parser,
        "--average",
        "also average the spectra of N segments that overlap by half (Welch), of all stretches between gaps",
    )
    add_loop_options(parser)
    add_json_option(parser)
    add_plot_option(parser, "the spectrum")
    add_file_option(parser, "--wav", "write the signal as sound into a .wav file")
    add_file_option(
        parser,
        "--csv",
        "write the samples that were analysed, after --scale, --resample and --as, into a CSV file",
    )
    parser.add_argument(
        "--bits", type=int, choices=BIT_DEPTHS, default=16, help="bits of a sample in --wav (default: 16)"
    )
    add_overwrite_option(parser)


def _run(arguments: Namespace) -> int:
    from trimmer.command_line.signals.spectrum_text import ShownSignal, as_json, as_text
    from trimmer.signals.signal import SignalError

    _check(arguments)
    chosen = chosen_recording(arguments)
    signal = chosen.signal
    comparison, drive = None, arguments.drive
    if arguments.against is None:
        predictions = _predictions(arguments)
    else:
        predictions, comparison, drive = _against(arguments, signal)
    try:
        analysis = _analysis(arguments, signal, predictions, drive)
        averaged = _averaged(arguments, chosen)
        _draw(arguments, analysis)
        wav = _written_wav(arguments, signal)
        _write_csv(arguments, signal)
    except SignalError as error:
        raise OptionError(f"{arguments.file}: {error}") from error
    shown = ShownSignal(arguments.file, analysis, predictions, chosen, averaged, wav, comparison)
    show((as_json if arguments.json else as_text)(shown), arguments.plot, arguments.wav, arguments.csv)
    return 0


def _check(arguments: Namespace) -> None:
    """Refuse what cannot be meant, before any work is done."""
    if arguments.against is None and arguments.set:
        raise OptionError("--set is for the mechanism of --against: name its file")
    if arguments.against is not None:
        for name in ("gap", "element", "response", "parameters", "channels"):
            if is_given(arguments, name):
                raise OptionError(f"{as_option(name)} is of a loop: leave it or --against out")
    elif arguments.gap is None and arguments.element is None:
        of_loop = ["displacement", "channels"]
        refuse_unused(arguments, of_loop, "--gap, whose limit cycles are predicted with it")
    if arguments.element is None:
        refuse_unused(
            arguments, ["response", *(each for each in ELEMENT_OPTIONS if each != "gap")], "--element"
        )
    if arguments.wav is None:
        refuse_unused(arguments, ["bits"], "--wav")
    if arguments.file == arguments.parameters == STANDARD_INPUT:
        raise OptionError("signal and --parameters cannot both be read from standard input: name a file")
    if arguments.file == arguments.against == STANDARD_INPUT:
        raise OptionError("signal and --against cannot both be read from standard input: name a file")
    sources = {
        "response": "the file of the response",
        "against": "the file of the mechanism",
        "file": "the file of the signal",
        "parameters": "the file of the parameters",
    }
    check_targets(arguments, {"plot": PICTURES, "wav": {".wav": WAV}, "csv": {"": CSV}}, sources)


def _predictions(arguments: Namespace) -> PredictedFrequencies:
    """Find natural modes, and limit cycles if an element or a gap is given."""
    from trimmer.command_line.signals.spectrum_text import PredictedFrequencies
    from trimmer.linear.modes import modes

    known, source = None, str(arguments.response)
    if arguments.response is None:
        known = tuple(mode.frequency for mode in modes(chosen_parameters(arguments)))
        source = "the thesis's trimmer" if arguments.parameters is None else str(arguments.parameters)
    if arguments.element is None and arguments.gap is None:
        return PredictedFrequencies(source, known, None, ())
    from trimmer.balance.solve import harmonic_balance

    words = arguments.element
    if words is None:
        arguments, words = (
            Namespace(**{**vars(arguments), "element": "friction"}),
            f"a gap of {arguments.gap:g} m",
        )
    loop = chosen_loop(arguments)
    cycles = harmonic_balance(loop.system, loop.element).limit_cycles
    return PredictedFrequencies(source, known, words, tuple(each.frequency for each in cycles if each.stable))


def _against(
    arguments: Namespace, signal: Signal
) -> tuple[PredictedFrequencies, MotionComparison, float | None]:
    """Return the natural modes of a mechanism, its motion beside the signal, and its drive, Hz, if any.

    Modes with closed contacts come before those with open ones.
    """
    from trimmer.command_line.signals.overlay import chosen_output, compared_motion
    from trimmer.command_line.signals.spectrum_text import PredictedFrequencies
    from trimmer.design.analysis.linear import linear_states

    mechanism = mechanism_with(arguments.against, arguments.set)
    named = arguments.displacement if is_given(arguments, "displacement") else None
    output = chosen_output(arguments.against, mechanism, signal, named)
    comparison, _ = compared_motion(arguments, signal, mechanism, output)
    drive = arguments.drive if mechanism.frequency is None else comparison.frequency
    modes = [mode.frequency for state in linear_states(mechanism, ()) for mode in state.modes]
    source = f"{arguments.against}, contacts closed and open"
    own = comparison.frequency if drive is None else None
    return PredictedFrequencies(source, tuple(dict.fromkeys(modes)), None, (), own), comparison, drive


def _analysis(
    arguments: Namespace, signal: Signal, predictions: PredictedFrequencies, drive: float | None
) -> SpectrumAnalysis:
    from trimmer.errors import SignalWarning
    from trimmer.spectra.analysis import analyse_signal
    from trimmer.spectra.own_lines import MAINS, with_own_lines

    with warnings.catch_warnings():
        # They stand in the text and in the JSON.
        warnings.simplefilter("ignore", SignalWarning)
        analysis = analyse_signal(
            signal,
            drive,
            predictions.natural_frequencies or (),
            predictions.limit_cycles,
            arguments.window,
            arguments.limit,
            closed_loop=arguments.closed_loop,
        )
    mains = MAINS if arguments.mains is None else (arguments.mains,)
    return with_own_lines(analysis, predictions.own_frequency, mains)


def _averaged(arguments: Namespace, chosen: ChosenRecording) -> AveragedSpectrum | None:
    if arguments.average is None:
        return None
    from trimmer.spectra.averaged import averaged_spectrum

    return averaged_spectrum(chosen.recording.stretches, arguments.average, arguments.window)


def _write_csv(arguments: Namespace, signal: Signal) -> None:
    if arguments.csv is not None:
        from trimmer.signals.write import write_signal

        write_signal(arguments.csv, signal, overwrite=arguments.overwrite)


def _draw(arguments: Namespace, analysis: SpectrumAnalysis) -> None:
    if arguments.plot is not None:
        from trimmer.drawing.content import figure_of

        write_picture(arguments, figure_of(analysis.plot))


def _written_wav(arguments: Namespace, signal: Signal) -> WavFile | None:
    if arguments.wav is None:
        return None
    from trimmer.signals.wav import write_wav

    return write_wav(
        arguments.wav, signal.values, signal.sample_rate, arguments.bits, overwrite=arguments.overwrite
    )


COMMAND = Command(
    "spectrum",
    "spectrum of a measured signal, and what its peaks may be",
    _configure,
    _run,
    examples=uses("""
    trimmer spectrum vibration.csv --column q2-q4 --drive 110 --gap 4e-5 --wav vibration.wav
        which peaks are harmonics of the drive, natural modes or limit cycles; and what it sounds like
    trimmer spectrum vibration.csv --column q2-q4 --window flat-top --limit 5 --plot spectrum.svg
        how high the five largest peaks are; see `trimmer simulate --help` for what wrote
        vibration.csv
    trimmer spectrum vibration.csv --column q2-q4 --as acceleration --average 8
        the same as acceleration, with the band that can be trusted, and averaged by Welch's method
    """),
)
