"""Claim of section 5.2.5 on the peaks of figure 5.23b, and their readings."""

from __future__ import annotations

from report.claim import Claim, Confirmation, Impact, Part, Slip, Verdict
from report.comparisons.assertion import Assertion
from report.comparisons.digits import CloseNumbers, PrintedDigits
from report.comparisons.printed import power_of
from report.comparisons.second_ways import second_way
from report.evidence import Evidence
from report.numbers.equivalent_nonlinearity import FORCE, GAP
from report.numbers.released_bodies import RECORD, ReleasedBodies

SOURCE = "report/numbers/released_bodies.py"
PEAKS = ("221.989", "369.996", "736.993")
"""Hz."""
SWAPPED = "the last two digits are exchanged"
DIED_OUT = 1e-9
"""Share of the start that may be left of a motion that has died out."""


def claims(evidence: Evidence) -> tuple[Claim, ...]:
    """Return the claim."""
    return (_peaks(evidence),)


def _swapped(frequency: float) -> float:
    """Return a frequency whose last two of three decimals are exchanged."""
    digits = f"{frequency:.3f}"
    return float(digits[:-2] + digits[-1] + digits[-2])


def peak_parts(evidence: Evidence, prefix: str = "") -> tuple[Part, ...]:
    """Return a part for each peak, and one on what the highest of them is."""
    numbers = evidence.motion.closed.released_bodies
    found = [RECORD.frequency(number) for number in numbers.runs[0].peaks]
    parts = tuple(
        Part(
            f"{prefix}peak {number} of {RECORD.duration:.0f} s, all bodies released alike",
            PrintedDigits(printed, frequency, "Hz"),
            Confirmation(
                f"natural mode {number} of the loop without play and friction",
                CloseNumbers(mode, frequency, 2e-3),
            ),
            Slip(SWAPPED, _swapped(frequency), Verdict.ERRATUM),
        )
        for number, (printed, frequency, mode) in enumerate(
            zip(PEAKS, found, numbers.modes, strict=False), start=1
        )
    )
    return (*parts, _reading(evidence, prefix))


def _reading(evidence: Evidence, prefix: str) -> Part:
    numbers, branch = evidence.motion.closed.released_bodies, evidence.cycles.equivalent.in_place
    left = max(run.left / run.displacement for run in numbers.runs)
    return Part(
        f"{prefix}what the peak at {PEAKS[2]} Hz is",
        Assertion(
            statement=f"with {FORCE} N of friction the loop has a limit cycle, which shows there",
            derived=left > DIED_OUT,
            evidence=(
                f"the motion dies out: at the end of the record {power_of(left)} of the start is left at "
                f"most. A gap of 4 µm bears {evidence.cycles.equivalent.force_of_merger:.3f} N at most; the "
                f"peak is the third natural mode of the loop, {numbers.modes[2]:.2f} Hz"
            ),
            method="exact simulation with true stick",
        ),
        second_way("harmonic balance over all forces", branch.limit_cycles(FORCE / GAP) == 0),
    )


def _peaks(evidence: Evidence) -> Claim:
    numbers = evidence.motion.closed.released_bodies
    starts = [_in_words(run) for run in numbers.runs]
    return Claim(
        id="txt-5.2.5-fft",
        parts=(*peak_parts(evidence), _harmonic(evidence)),
        explanation=(
            "All three are free vibrations of the closed loop without play and friction, at "
            f"{numbers.modes[0]:.2f}, {numbers.modes[1]:.2f} and {numbers.modes[2]:.2f} Hz. Released with "
            "all four bodies displaced alike, which is our guess of the start, the thesis's loop with 4 µm "
            f"and 0.6 N has its largest peaks in exactly these bins of one second ({starts[0]} to "
            f"{starts[-1]}), the first with its digits exchanged in print. Nothing of play or friction is in "
            "them: with a start much larger than the gap the loop is linear, and friction ends the motion."
        ),
        consequence=(
            "The agreement of 736.993 with the predicted 737.514 Hz is no evidence for the equivalent "
            "nonlinearity: both are nearly the frequency at which $G$ passes by $-1$."
        ),
        impact=Impact.DOWNSTREAM,
        source=SOURCE,
    )


def _in_words(run: ReleasedBodies) -> str:
    return f"{run.displacement:g} m"


def _harmonic(evidence: Evidence) -> Part:
    second, third = (float(each) for each in PEAKS[1:])
    apart = abs(2 * second - third) / RECORD.bin_width
    modes = evidence.motion.closed.released_bodies.modes
    return Part(
        f"what the peak at {PEAKS[1]} Hz is",
        Assertion(
            statement=f"it is a harmonic of the one at {PEAKS[2]} Hz",
            derived=apart < 1,
            evidence=(
                f"twice {PEAKS[1]} Hz is {apart:.0f} bins away from {PEAKS[2]} Hz; harmonics lie above, and "
                f"odd elements make odd ones. It is the second natural mode, {modes[1]:.2f} Hz"
            ),
            method="the printed frequencies and bins",
        ),
        Confirmation("the natural modes of the loop", CloseNumbers(modes[1], second, 2e-3)),
    )
