"""Claims of section 5.1.3: eigenvalues, resonances and damping (equations 5.2 and 5.3, figure 5.4)."""

from __future__ import annotations

import math

import numpy as np
import sympy

from derivations.state_space import output_row
from report.claim import Claim, Confirmation, Impact, Part, Slip, Verdict
from report.claims.exact_response import eigenvalues, gain, peak
from report.comparisons.assertion import Assertion
from report.comparisons.digits import CloseNumbers, PrintedDigits
from report.comparisons.expression import SameMatrix
from report.evidence import Evidence
from report.numbers.light_damping import DAMPING_FACTOR, lightly_damped, sum_of_displacements
from report.numbers.linear_numbers import DRIVE_FREQUENCY, MEASURED_DRIVE_FREQUENCY, LinearNumbers
from trimmer import (
    InputChannels,
    filtering_ratio,
    frequency_response,
    resonance_peaks,
    transfer_function,
)

SOURCE = "trimmer/modal_analysis.py"
PRINTED_EIGENVALUES = (
    ("1,2", "-541.6448", "7159.6999"),
    ("3,4", "-80.5896", "3453.172"),
    ("5,6", "-41.8148", "2229.5063"),
    ("7,8", "-24.9984", "1397.0567"),
)
READING_ACCURACY = 0.01
BODIES = 4


def claims(evidence: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    numbers = evidence.numbers
    return (
        _eigenvalues(numbers),
        _output_matrix(numbers),
        _hidden_peak(numbers),
        _first_resonance(numbers),
        _damping(numbers),
        _bode_plot_without_damping(numbers),
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


def _spike_of_hidden_mode(numbers: LinearNumbers) -> float:
    """Return how far, in dB, x2 - x4 rises above its surroundings at the highest mode with light damping."""
    system = transfer_function(lightly_damped(numbers.parameters), channels=InputChannels.DISPLACEMENT_ONLY)
    highest = numbers.undamped[-1].omega
    spike = min(resonance_peaks(system), key=lambda each: abs(each.omega - highest))
    beside = abs(frequency_response(system, highest * np.array([1 - READING_ACCURACY, 1 + READING_ACCURACY])))
    return 20 * math.log10(spike.magnitude / float(beside.max()))


def _output_matrix(numbers: LinearNumbers) -> Claim:
    tracked = sympy.Matrix.vstack(*(output_row(body, None, BODIES) for body in range(BODIES)))
    added = sympy.ones(1, BODIES) * tracked
    printed = sympy.ImmutableMatrix([[1, 1, 1, 1, 0, 0, 0, 0]])
    return Claim(
        id="eq-5.3",
        parts=(
            Part(
                "",
                SameMatrix(printed, sympy.ImmutableMatrix(tracked), left=sympy.Symbol("C")),
                slip=Slip(
                    "the four rows are added up into one", sympy.ImmutableMatrix(added), Verdict.ERRATUM
                ),
            ),
        ),
        explanation=(
            "To track four positions takes four rows. The printed row gives one output, the sum "
            "$x_1 + x_2 + x_3 + x_4$, in which motions of opposite sign cancel."
        ),
        consequence=(
            "Figure 5.4 shows the sum; its four peaks are those of the modes all the same. With a thousandth "
            "of the damping $x_2 - x_4$ shows the highest too, but only as a narrow spike of "
            f"{_spike_of_hidden_mode(numbers):.0f} dB."
        ),
        impact=Impact.LOCAL,
        source="derivations/state_space.py",
    )


def _nearest_peak(numbers: LinearNumbers, omega: float) -> float:
    found = (each.omega for each in resonance_peaks(numbers.displacement_only))
    return min(found, key=lambda each: abs(each - omega))


def _peak_part(index: str, printed: str, omega: float, confirmation: Confirmation) -> Part:
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
    hidden_omega = float(hidden[2])
    near = [each for each in resonance_peaks(system) if abs(each.omega / hidden_omega - 1) < 0.2]
    pole = next(mode.eigenvalue for mode in numbers.modes if mode.omega_damped > 7000)
    zero = min(system.zeros(), key=lambda each: abs(each - pole))
    slope = float(gain(numbers, hidden_omega * 1.01) - gain(numbers, hidden_omega * 0.99))
    found = {printed: _nearest_peak(numbers, float(printed)) for _, _, printed in visible}
    parts = [
        _peak_part(
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
            Part(
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
            ),
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


def _first_resonance(numbers: LinearNumbers) -> Claim:
    system = numbers.displacement_only
    frequency = numbers.modes[0].frequency
    exact = min(abs(root.imag) for root in eigenvalues(numbers)) / (2 * math.pi)
    drives = (DRIVE_FREQUENCY, MEASURED_DRIVE_FREQUENCY)
    fifth = {drive: float(filtering_ratio(system, 2 * math.pi * drive, 5)) for drive in drives}
    measured = 2 * math.pi * MEASURED_DRIVE_FREQUENCY
    exact_fifth = float(gain(numbers, 5 * measured) / gain(numbers, measured))
    return Claim(
        id="txt-5.1.3-first-resonance",
        parts=(
            Part(
                "first eigenfrequency",
                PrintedDigits("222.35", frequency, "Hz"),
                Confirmation("the roots of the exact polynomial", CloseNumbers(exact, frequency)),
            ),
            Part(
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
            ),
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


def _damping(numbers: LinearNumbers) -> Claim:
    light = transfer_function(lightly_damped(numbers.parameters), channels=InputChannels.DISPLACEMENT_ONLY)
    with_damping = resonance_peaks(numbers.displacement_only)
    shifts = []
    for undamped in numbers.undamped[:3]:
        lightly = min(resonance_peaks(light), key=lambda each: abs(each.omega - undamped.omega))
        damped = min(with_damping, key=lambda each: abs(each.omega - undamped.omega))
        shifts.append((damped.omega / lightly.omega - 1, lightly.magnitude / damped.magnitude))
    largest = max(abs(shift) for shift, _ in shifts)
    eigen = [
        mode.omega_damped / undamped.omega - 1
        for mode, undamped in zip(numbers.modes, numbers.undamped, strict=True)
    ]
    return Claim(
        id="txt-5.1.3-damping",
        parts=(
            Part(
                "height of the peaks",
                Assertion(
                    statement="damping lowers every peak",
                    derived=all(ratio > 1 for _, ratio in shifts),
                    evidence=(
                        "a thousandth of the damping makes the visible peaks "
                        f"{min(r for _, r in shifts):.0f} to {max(r for _, r in shifts):.0f} times higher"
                    ),
                    method="all local maxima of the gain for both dampings",
                ),
            ),
            Part(
                "place of the peaks",
                Assertion(
                    statement="damping does not move the resonances",
                    derived=largest <= READING_ACCURACY,
                    evidence=(
                        "peaks of the gain move by "
                        + ", ".join(f"{100 * shift:+.2f} %" for shift, _ in shifts)
                        + "; eigenfrequencies by "
                        + ", ".join(f"{100 * shift:+.3f} %" for shift in eigen)
                    ),
                    method=(
                        f"peaks with {DAMPING_FACTOR:g} of the damping against peaks with all of it; a plot "
                        f"is read to {100 * READING_ACCURACY:.0f} %"
                    ),
                ),
                Confirmation(
                    "the slope of the exact gain",
                    CloseNumbers(peak(numbers, with_damping[1].omega), with_damping[1].omega, 1e-7),
                ),
            ),
        ),
        explanation=(
            "Damping lowers the peaks, as the text says, and hides the highest one. It also moves them: by "
            f"{100 * largest:.1f} % for the peak near 1400 rad/s, and by {-100 * eigen[3]:.2f} % for the "
            "highest eigenfrequency. On the scale of a Bode plot most of that cannot be seen."
        ),
        consequence=(
            "Small. Chapter 7 sums this up as an increase of the magnitude by damping, and puts the "
            "resonances below the operating frequency; neither is so."
        ),
        impact=Impact.LOCAL,
        source=SOURCE,
    )


def _bode_plot_without_damping(numbers: LinearNumbers) -> Claim:
    found = resonance_peaks(sum_of_displacements(lightly_damped(numbers.parameters)))
    parts, distances = [], []
    for (index, _, printed), undamped in zip(reversed(PRINTED_EIGENVALUES), numbers.undamped, strict=True):
        nearest = min((each.omega for each in found), key=lambda omega: abs(omega - undamped.omega))
        confirmation = Confirmation(
            "the undamped eigenvalue problem", CloseNumbers(nearest, undamped.omega, 1e-4)
        )
        parts.append(_peak_part(index, printed, nearest, confirmation))
        distances.append(abs(nearest / float(printed) - 1))
    return Claim(
        id="fig-5.4",
        parts=tuple(parts),
        explanation=(
            "With a thousandth of the damping the sum of the displacements has four sharp peaks, at the "
            "natural frequencies without damping. They agree with the printed imaginary parts to "
            f"{100 * max(distances):.1f} %, as well as a plot shows. The thesis does not say how small its "
            "damping was."
        ),
        source=SOURCE,
    )
