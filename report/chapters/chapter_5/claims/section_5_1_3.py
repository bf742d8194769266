"""Claims of section 5.1.3 on eigenvalues and on the resonances that they make (equation 5.2)."""

from __future__ import annotations

import math

import numpy as np

from report.claim import Claim, Confirmation, Impact, Part
from report.comparisons.assertion import Assertion
from report.comparisons.digits import CloseNumbers, PrintedDigits
from report.evidence import Evidence
from report.numbers.exact_response import eigenvalues, gain, peak
from report.numbers.linear_numbers import DRIVE_FREQUENCY, MEASURED_DRIVE_FREQUENCY, LinearNumbers
from trimmer import filtering_ratio, resonance_peaks

SOURCE = "trimmer/modal_analysis.py"
PRINTED_EIGENVALUES = (
    ("1,2", "-541.6448", "7159.6999"),
    ("3,4", "-80.5896", "3453.172"),
    ("5,6", "-41.8148", "2229.5063"),
    ("7,8", "-24.9984", "1397.0567"),
)
READING_ACCURACY = 0.01
"""Share to which a plot can be read."""


def claims(evidence: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    numbers = evidence.numbers
    return (
        _eigenvalues(numbers),
        _hidden_peak(numbers),
        _first_resonance(numbers),
    )


def _eigenvalues(numbers: LinearNumbers) -> Claim:
    exact = sorted((root for root in eigenvalues(numbers) if root.imag > 0), key=lambda root: -root.imag)
    solved = sorted((mode.eigenvalue for mode in numbers.modes), key=lambda root: -root.imag)
    parts = []
    for (index, real, imaginary), value, other in zip(PRINTED_EIGENVALUES, solved, exact, strict=True):
        confirmation = Confirmation("the roots of the exact polynomial", CloseNumbers(other, value))
        parts.append(
            Part(
                f"$\\mathrm{{Re}}\\,\\lambda_{{{index}}}$",
                PrintedDigits(real, value.real, "1/s"),
                confirmation,
            )
        )
        parts.append(
            Part(
                f"$\\mathrm{{Im}}\\,\\lambda_{{{index}}}$",
                PrintedDigits(imaginary, value.imag, "rad/s"),
                confirmation,
            )
        )
    return Claim(
        id="eq-5.2",
        parts=tuple(parts),
        explanation=(
            "All eight eigenvalues agree to every printed digit. They come in four conjugate pairs, one for "
            "each mode; they are poles, never zeros, of the transfer function, which the text leaves open."
        ),
        source=SOURCE,
    )


def _nearest_peak(numbers: LinearNumbers, omega: float) -> float:
    found = (each.omega for each in resonance_peaks(numbers.displacement_only))
    return min(found, key=lambda each: abs(each - omega))


def peak_part(index: str, printed: str, omega: float, confirmation: Confirmation) -> Part:
    """Hold the frequency of a peak against an eigenvalue's imaginary part, as well as a plot can be read."""
    distance = omega / float(printed) - 1
    return Part(
        f"peak near $\\mathrm{{Im}}\\,\\lambda_{{{index}}}$",
        Assertion(
            statement=f"a peak stands at {printed} rad/s, as far as a plot can be read",
            derived=abs(distance) <= READING_ACCURACY,
            evidence=f"it stands at {omega:.2f} rad/s, {100 * distance:+.3f} %",
            method=f"local maxima of the gain; a plot is read to {100 * READING_ACCURACY:.0f} %",
        ),
        confirmation,
    )


def _hidden_peak(numbers: LinearNumbers) -> Claim:
    hidden, *visible = PRINTED_EIGENVALUES
    system = numbers.displacement_only
    found = {printed: _nearest_peak(numbers, float(printed)) for _, _, printed in visible}
    parts = [
        peak_part(
            index,
            printed,
            found[printed],
            Confirmation(
                "the slope of the exact gain",
                CloseNumbers(peak(numbers, found[printed]), found[printed], 1e-7),
            ),
        )
        for index, _, printed in visible
    ]
    *shifts, shift = (100 * (omega / float(printed) - 1) for printed, omega in found.items())
    (stray,) = (each.omega for each in resonance_peaks(system) if each.omega not in found.values())
    return Claim(
        id="txt-5.1.3-hidden-peak",
        parts=(
            *parts,
            _hidden(numbers, float(hidden[2])),
        ),
        explanation=(
            "One resonance is hidden, as the text says, because zeros all but cancel its poles. Two others "
            f"stand within {max(map(abs, shifts)):.1f} % of the imaginary parts, but the one near 1397 "
            f"rad/s, next to a valley, has its peak {shift:.1f} % higher. A further faint maximum, at "
            f"{stray:.1f} rad/s, belongs to no eigenvalue at all."
        ),
        consequence="Hold frequencies in a spectrum against peaks of the gain, not against eigenvalues.",
        impact=Impact.LOCAL,
        source="trimmer/extrema.py",
    )


def _hidden(numbers: LinearNumbers, hidden_omega: float) -> Part:
    system = numbers.displacement_only
    near = [each for each in resonance_peaks(system) if abs(each.omega / hidden_omega - 1) < 0.2]
    pole = next(mode.eigenvalue for mode in numbers.modes if mode.omega_damped > 7000)
    zero = min(system.zeros(), key=lambda each: abs(each - pole))
    slope = float(gain(numbers, hidden_omega * 1.01) - gain(numbers, hidden_omega * 0.99))
    return Part(
        "peak near $\\mathrm{Im}\\,\\lambda_{1,2}$",
        Assertion(
            statement="the output $x_2 - x_4$ shows no peak near 7159.7 rad/s",
            derived=not near,
            evidence=(
                f"a pair of zeros lies {abs(zero - pole):.2f} rad/s from the pair of poles, "
                f"{100 * abs(zero - pole) / abs(pole):.3f} % of their size, and takes the peak away"
            ),
            method="all local maxima of the gain",
        ),
        Confirmation(
            "the gain falls from 0.99 to 1.01 times that frequency",
            CloseNumbers(float(np.sign(slope)), -1.0),
        ),
    )


def _first_resonance(numbers: LinearNumbers) -> Claim:
    frequency = numbers.modes[0].frequency
    exact = min(abs(root.imag) for root in eigenvalues(numbers)) / (2 * math.pi)
    return Claim(
        id="txt-5.1.3-first-resonance",
        parts=(
            Part(
                "first eigenfrequency",
                PrintedDigits("222.35", frequency, "Hz"),
                Confirmation("the roots of the exact polynomial", CloseNumbers(exact, frequency)),
            ),
            _what_follows(numbers),
        ),
        explanation=(
            f"The number is right: the first eigenfrequency is {frequency / DRIVE_FREQUENCY:.1f} times the "
            "drive. The conclusion holds for a purely sinusoidal motion only, since play and friction make "
            f"harmonics. The fifth of {MEASURED_DRIVE_FREQUENCY} Hz, the drive that was measured, lies at "
            f"{5 * MEASURED_DRIVE_FREQUENCY:.1f} Hz, on the highest peak of this gain; the parameters of the "
            "measured trimmer (table C.1) are not given."
        ),
        consequence=(
            "A peak near 550 Hz in a driven spectrum of this trimmer needs no limit cycle: a harmonic of the "
            "drive is amplified there more than anywhere else. Section 3.3 takes its peak at 549.999 Hz for "
            "a fifth harmonic too."
        ),
        impact=Impact.DOWNSTREAM,
        source="trimmer/low_pass.py",
    )


def _what_follows(numbers: LinearNumbers) -> Part:
    system = numbers.displacement_only
    drives = (DRIVE_FREQUENCY, MEASURED_DRIVE_FREQUENCY)
    fifth = {drive: float(filtering_ratio(system, 2 * math.pi * drive, 5)) for drive in drives}
    measured = 2 * math.pi * MEASURED_DRIVE_FREQUENCY
    exact_fifth = float(gain(numbers, 5 * measured) / gain(numbers, measured))
    return Part(
        "what follows for the drive",
        Assertion(
            statement="the resonances do not matter, as the drive is far below the first one",
            derived=max(fifth.values()) < 1,
            evidence=(
                f"the drive's harmonics meet them: the fifth passes {fifth[DRIVE_FREQUENCY]:.1f} "
                f"times better than the drive at {DRIVE_FREQUENCY:.0f} Hz and "
                f"{fifth[MEASURED_DRIVE_FREQUENCY]:.1f} times better at {MEASURED_DRIVE_FREQUENCY} Hz"
            ),
            method="frequency response at multiples of the drive",
        ),
        Confirmation(
            "exact coefficients, 40 digits",
            CloseNumbers(exact_fifth, fifth[MEASURED_DRIVE_FREQUENCY]),
        ),
    )
