"""Claims of section 5.1.3 on damping, and on the plot with hardly any of it (equation 5.3, figure 5.4)."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
import sympy

from derivations.state_space import output_row
from report.chapters.chapter_5.claims.section_5_1_3 import PRINTED_EIGENVALUES, READING_ACCURACY, peak_part
from report.claim import Claim, Confirmation, Impact, Part, Slip, Verdict
from report.comparisons.assertion import Assertion
from report.comparisons.digits import CloseNumbers
from report.comparisons.expression import SameMatrix
from report.evidence import Evidence
from report.numbers.exact_response import peak
from report.numbers.light_damping import DAMPING_FACTOR, lightly_damped, sum_of_displacements
from report.numbers.linear_numbers import LinearNumbers
from trimmer import (
    Body,
    Displacement,
    InputChannels,
    TrimmerParameters,
    frequency_response,
    linear_model,
    resonance_peaks,
    transfer_function,
)
from trimmer.extrema import Extremum

SOURCE = "trimmer/modal_analysis.py"
BODIES = 4
VISIBLE = 3
"""Peaks that the output of the thesis shows with all of the damping."""


def claims(evidence: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    numbers = evidence.numbers
    return (_output_matrix(numbers), _damping(numbers), _bode_plot_without_damping(numbers))


def _spike_of_hidden_mode(numbers: LinearNumbers) -> float:
    """Return how far, in dB, x2 - x4 rises above its surroundings at the highest mode with light damping."""
    system = transfer_function(lightly_damped(numbers.parameters), channels=InputChannels.DISPLACEMENT_ONLY)
    highest = numbers.undamped[-1].omega
    spike = min(resonance_peaks(system), key=lambda each: abs(each.omega - highest))
    beside = abs(frequency_response(system, highest * np.array([1 - READING_ACCURACY, 1 + READING_ACCURACY])))
    return 20 * math.log10(spike.magnitude / float(beside.max()))


def _difference_from_the_model(numbers: LinearNumbers, rows: sympy.Matrix) -> float:
    """Return the largest difference of an output matrix from that of the numeric model."""
    model = linear_model(numbers.parameters, [Displacement(body) for body in Body])
    return float(np.abs(np.array(rows, dtype=float) - np.asarray(model.C)).max())


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
                Confirmation(
                    "the numeric model with each displacement as an output",
                    CloseNumbers(1 + _difference_from_the_model(numbers, tracked), 1.0),
                ),
                Slip("the four rows are added up into one", sympy.ImmutableMatrix(added), Verdict.ERRATUM),
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


def _visible_peaks(numbers: LinearNumbers) -> list[tuple[Extremum, Extremum]]:
    """Return each visible peak with all of the damping, and the same with a thousandth of it."""
    light = transfer_function(lightly_damped(numbers.parameters), channels=InputChannels.DISPLACEMENT_ONLY)
    with_all, lightly = resonance_peaks(numbers.displacement_only), resonance_peaks(light)
    modes = numbers.undamped[:VISIBLE]
    return [(_nearest(with_all, each.omega), _nearest(lightly, each.omega)) for each in modes]


def _nearest(peaks: Sequence[Extremum], omega: float) -> Extremum:
    return min(peaks, key=lambda peak: abs(peak.omega - omega))


def _gain_of_state_space(parameters: TrimmerParameters, omega: float) -> float:
    """Return |C (jω - A)⁻¹ B| from the pin's displacement, without a transfer function."""
    model = linear_model(parameters)[0, 0]
    resolvent = np.linalg.solve(1j * omega * np.eye(model.nstates) - model.A, model.B)
    return float(abs((model.C @ resolvent)[0, 0]))


def _height(numbers: LinearNumbers, peaks: list[tuple[Extremum, Extremum]]) -> Part:
    light = lightly_damped(numbers.parameters)
    ratios = [lightly.magnitude / damped.magnitude for damped, lightly in peaks]
    second = [
        _gain_of_state_space(light, lightly.omega) / _gain_of_state_space(numbers.parameters, damped.omega)
        for damped, lightly in peaks
    ]
    return Part(
        "height of the peaks",
        Assertion(
            statement="damping lowers every peak",
            derived=all(ratio > 1 for ratio in ratios),
            evidence=(
                "a thousandth of the damping makes the visible peaks "
                f"{min(ratios):.0f} to {max(ratios):.0f} times higher"
            ),
            method="all local maxima of the gain for both dampings",
        ),
        Confirmation("the state space solved at these peaks", CloseNumbers(min(second), min(ratios), 1e-6)),
    )


def _damping(numbers: LinearNumbers) -> Claim:
    peaks = _visible_peaks(numbers)
    shifts = [damped.omega / lightly.omega - 1 for damped, lightly in peaks]
    largest = max(map(abs, shifts))
    eigen = [
        mode.omega_damped / undamped.omega - 1
        for mode, undamped in zip(numbers.modes, numbers.undamped, strict=True)
    ]
    return Claim(
        id="txt-5.1.3-damping",
        parts=(
            _height(numbers, peaks),
            _place(numbers, peaks[0][0], shifts, eigen),
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


def _place(numbers: LinearNumbers, first: Extremum, shifts: Sequence[float], eigen: Sequence[float]) -> Part:
    return Part(
        "place of the peaks",
        Assertion(
            statement="damping does not move the resonances",
            derived=max(map(abs, shifts)) <= READING_ACCURACY,
            evidence=(
                "peaks of the gain move by "
                + ", ".join(f"{100 * shift:+.2f} %" for shift in shifts)
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
            CloseNumbers(peak(numbers, first.omega), first.omega, 1e-7),
        ),
    )


def _bode_plot_without_damping(numbers: LinearNumbers) -> Claim:
    found = resonance_peaks(sum_of_displacements(lightly_damped(numbers.parameters)))
    parts, distances = [], []
    for (index, _, printed), undamped in zip(reversed(PRINTED_EIGENVALUES), numbers.undamped, strict=True):
        nearest = min((each.omega for each in found), key=lambda omega: abs(omega - undamped.omega))
        confirmation = Confirmation(
            "the undamped eigenvalue problem", CloseNumbers(nearest, undamped.omega, 1e-4)
        )
        parts.append(peak_part(index, printed, nearest, confirmation))
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
