"""The lines of a spectrum with what each is: drive, harmonic, fraction of the drive; modes beside them."""

from collections.abc import Mapping
from dataclasses import dataclass
from enum import Enum

from trimmer.design.analysis.found_motion import FoundMotion
from trimmer.design.analysis.linear import LinearMode, LinearState
from trimmer.mechanism.linear.outputs import Contacts
from trimmer.response.periodic.pace import DRIVE_PERIOD

SMALLEST = 1e-4  # Amplitude of a line, relative to the largest, from which on it is listed
MOST_LINES = 24  # Lines that are listed of an output, the largest
BESIDE = 0.03
"""Distance from a mode, as a share of its frequency, at which it is named; its damping ratio if larger."""
DAMPED = 0.35
"""Damping ratio from which on a mode is not named: at its peak it hardly amplifies, by half at most."""


class LineKind(Enum):
    """The origin of a line of a spectrum."""

    DRIVE = "the drive"
    HARMONIC = "a harmonic"
    FRACTION = "a fraction of the drive"
    OWN = "of the motion itself"


@dataclass(frozen=True, eq=False)
class OutputLine:
    """A line of the spectrum of an output.

    Attributes:
        kind: What it is.
        numerator, denominator: It is at this multiple of the drive's frequency, or of the motion's own.
        frequency: Hz.
        amplitude: a of a cos(...), m.
        mode: A mode near its frequency, which amplifies it; None if there is none.
        contacts: In which state of the contacts the mechanism has that mode.
    """

    kind: LineKind
    numerator: int
    denominator: int
    frequency: float
    amplitude: float
    mode: LinearMode | None
    contacts: Contacts | None


@dataclass(frozen=True, eq=False)
class OutputSpectrum:
    """The lines of an output.

    Attributes:
        output: Its name.
        lines: The largest ones, by rising frequency.
        left_out: How many lines of the first harmonics are smaller than what is listed.
        floor: Amplitude below which none is listed.
        share: Share of the output's mean square that the listed lines hold.
        unit: SI unit of the output.
        period_word: What the motion is counted in: drive periods, or the samples that alone drive.
    """

    output: str
    lines: tuple[OutputLine, ...]
    left_out: int
    floor: float
    share: float
    unit: str = "m"
    period_word: str = DRIVE_PERIOD


def spectra(
    motion: FoundMotion, frequency: float | None, states: tuple[LinearState, ...]
) -> Mapping[str, OutputSpectrum]:
    """Explain the lines of each output of a motion by its drive, Hz, and by modes that may amplify them.

    Without a frequency a period of what drives, as samples or a reference, follows from that of the motion.

    One that does not repeat has its harmonics alone.
    """
    base = frequency
    if base is None and motion.period:
        base = (motion.period_count or 1) / motion.period
    if base is None:
        return {}
    by_itself = frequency is None and not motion.driven
    return {name: _of_output(motion, name, base, by_itself, states) for name in motion.outputs}


def _of_output(
    motion: FoundMotion, name: str, base: float, by_itself: bool, states: tuple[LinearState, ...]
) -> OutputSpectrum:
    measures = motion.outputs[name]
    found = [(p, k, size) for p, k, size in measures.lines if size > 0]
    floor = SMALLEST * max((size for _, _, size in found), default=0.0)
    largest = sorted((each for each in found if each[2] >= floor), key=lambda each: -each[2])[:MOST_LINES]
    lines = tuple(
        _line(p, k, size, base, by_itself, states)
        for p, k, size in sorted(largest, key=lambda e: e[0] / e[1])
    )
    held = sum(0.5 * line.amplitude**2 for line in lines)
    share = min(held / measures.rms**2, 1.0) if measures.rms else 1.0
    unit = motion.signals.units.get(name, "m")
    return OutputSpectrum(name, lines, len(found) - len(lines), floor, share, unit, motion.period_word)


def _line(
    p: int, k: int, size: float, base: float, by_itself: bool, states: tuple[LinearState, ...]
) -> OutputLine:
    frequency = base * p / k
    mode, contacts = _mode_beside(frequency, states)
    if p % k:
        kind = LineKind.FRACTION
    elif by_itself:
        kind = LineKind.OWN
    else:
        kind = LineKind.DRIVE if p == k else LineKind.HARMONIC
    if p % k == 0:
        p, k = p // k, 1
    return OutputLine(kind, p, k, frequency, size, mode, contacts)


def _mode_beside(
    frequency: float, states: tuple[LinearState, ...]
) -> tuple[LinearMode | None, Contacts | None]:
    near = [
        (abs(frequency / mode.frequency - 1), mode, state.contacts)
        for state in states
        for mode in state.modes
        if mode.frequency and mode.damping_ratio < DAMPED
        if abs(frequency / mode.frequency - 1) <= max(BESIDE, mode.damping_ratio)
    ]
    if not near:
        return None, None
    _, mode, contacts = min(near, key=lambda each: each[0])
    return mode, contacts
