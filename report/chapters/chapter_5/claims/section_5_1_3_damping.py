"""Claims of section 5.1.3 on damping: the output of figure 5.4 (equation 5.3), resonances, antiresonances."""

import math

import numpy as np
import sympy

from derivations.state_space import output_row
from report.chapters.chapter_5.claims.section_5_1_3 import (
    EXACT_SLOPE,
    PLOT_READ,
    PRINTED_EIGENVALUES,
    READING_ACCURACY,
    nearest,
    peak_part,
)
from report.judging.parts import assertion, close, made_here, matrix, small
from report.judging.record import Record, claim, text
from report.judging.verdict import Certainty
from report.numbers.evidence import Evidence
from report.numbers.independent.exact_response import peak
from report.numbers.independent.linear_trimmer import (
    antiresonances,
    antiresonances_without_damping,
    matrix_formula,
)
from report.numbers.linear_numbers import (
    DAMPING_FACTOR,
    lightly_damped,
    lightly_damped_response,
    sum_of_displacements,
)
from trimmer import linear_model, resonance_peaks, response_at
from trimmer.thesis import Displacement, TrimmerBody

OUTPUT, SUM = np.array([0.0, 1.0, 0.0, -1.0]), np.ones(4)
"""Weights of the four displacements in the output of the thesis's loop, and in that of figure 5.4."""
VISIBLE = 3  # Peaks that the output of the thesis shows with all of the damping


@claim("eq-5.3")
def output_matrix(known: Evidence) -> Record:
    parameters, bodies = known.numbers.parameters, len(TrimmerBody)
    tracked = sympy.ImmutableMatrix.vstack(*(output_row(body, None, bodies) for body in range(bodies)))
    added = sympy.ImmutableMatrix(sympy.ones(1, bodies) * tracked)
    model = linear_model(parameters, [Displacement(body) for body in TrimmerBody])
    difference = np.abs(np.array(tracked, dtype=float) - np.asarray(model.C)).max()
    yield matrix(
        "",
        sympy.ImmutableMatrix([[1, 1, 1, 1, 0, 0, 0, 0]]),
        tracked,
        left=sympy.Symbol("C"),
        second=small("the numeric model with each displacement as an output", float(difference)),
        slip=made_here("the four rows are added up into one", added),
    )
    system = lightly_damped_response(parameters)
    highest = known.numbers.undamped[-1].omega
    beside = abs(response_at(system, highest * np.array([1 - READING_ACCURACY, 1 + READING_ACCURACY])))
    spike = nearest(resonance_peaks(system), highest)
    decibels = 20 * math.log10(spike.magnitude / float(beside.max()))
    yield text(f"""
        Tracking four positions, as the text means to, takes four rows. Read as one output in which every body
        takes part, the printed row is right: it is the sum $x_1 + x_2 + x_3 + x_4$, in which motions of
        opposite sign cancel.

        Figure 5.4 shows the sum, and its four peaks are those of the modes. With a thousandth of the damping
        $x_2 - x_4$ shows the highest too, but only as a narrow spike of {decibels:.0f} dB.
    """)


@claim("txt-5.1.3-damping")
def damping(known: Evidence) -> Record:
    numbers, parameters = known.numbers, known.numbers.parameters
    systems = numbers.displacement_only, lightly_damped_response(parameters)
    damped, light = (
        [nearest(resonance_peaks(system), mode.omega) for mode in numbers.undamped[:VISIBLE]]
        for system in systems
    )
    ratios = [each.magnitude / other.magnitude for each, other in zip(light, damped, strict=True)]
    least, most = min(ratios), max(ratios)
    solved = [
        abs(matrix_formula(lightly_damped(parameters), 1j * each.omega))
        / abs(matrix_formula(parameters, 1j * other.omega))
        for each, other in zip(light, damped, strict=True)
    ]
    yield assertion(
        "height of the peaks",
        "damping lowers every peak",
        least > 1,
        f"a thousandth of the damping makes the visible peaks {least:.0f} to {most:.0f} times higher",
        method="all local maxima of the gain for both dampings",
        second=close("the state space solved at these peaks", min(solved), least, 1e-6),
    )
    shifts = [100 * (each.omega / other.omega - 1) for each, other in zip(damped, light, strict=True)]
    modes = zip(numbers.modes, numbers.undamped, strict=True)
    of_modes = [100 * (mode.omega_damped / undamped.omega - 1) for mode, undamped in modes]
    of_peaks = ", ".join(f"{shift:+.2f} %" for shift in shifts)
    of_eigenvalues = ", ".join(f"{shift:+.3f} %" for shift in of_modes)
    first = damped[0].omega
    item = "damping does not move the resonances"
    undamped = numbers.undamped[-1].omega
    slowest = nearest(resonance_peaks(sum_of_displacements(lightly_damped(parameters))), undamped).omega
    yield assertion(
        "place of the eigenfrequencies",
        "damping does not move the resonances, as far as a plot can be read",
        max(map(abs, of_modes)) <= 100 * READING_ACCURACY,
        f"eigenfrequencies move by {of_eigenvalues}",
        method=f"eigenvalues with and without damping; {PLOT_READ}",
        second=close("the peaks with a thousandth of the damping", slowest, undamped, 1e-4),
        item=item,
        certainty=Certainty.READING,
    )
    yield assertion(
        "place of the peaks",
        "damping does not move the resonances, as far as a plot can be read",
        max(map(abs, shifts)) <= 100 * READING_ACCURACY,
        f"peaks of the gain move by {of_peaks}",
        method=f"peaks with {DAMPING_FACTOR:g} of the damping against peaks with all of it; {PLOT_READ}",
        second=close(EXACT_SLOPE, peak(numbers, first), first, 1e-7),
        item=item,
        certainty=Certainty.READING,
    )
    yield text(f"""
        Damping lowers the peaks, as the text says, and hides the highest one. It hardly moves the
        eigenfrequencies, by {max(map(abs, of_modes)):.2f} % at most. Of the peaks it moves the one at
        {first:.0f} rad/s farthest, by {max(map(abs, shifts)):.1f} %, less than half a millimetre between two
        plots. Chapter 7 [sums this up the other way round](#txt-7-damping).
    """)


@claim("fig-5.4")
def bode_plot_without_damping(known: Evidence) -> Record:
    found = resonance_peaks(sum_of_displacements(lightly_damped(known.numbers.parameters)))
    farthest = 0.0
    for (index, _, printed), mode in zip(reversed(PRINTED_EIGENVALUES), known.numbers.undamped, strict=True):
        omega = nearest(found, mode.omega).omega
        farthest = max(farthest, abs(omega / float(printed) - 1))
        second = close("the undamped eigenvalue problem", omega, mode.omega, 1e-4)
        yield peak_part(index, printed, omega, second)
    yield text(f"""
        With a thousandth of the damping the sum of the displacements has four sharp peaks, at the natural
        frequencies without damping. They agree with the printed imaginary parts to {100 * farthest:.1f} %,
        too little to see in a plot. The thesis does not say how small its damping was.
    """)


@claim("txt-5.1.3-antiresonances")
def valleys(known: Evidence) -> Record:
    parameters = known.numbers.parameters
    first = antiresonances(known.numbers.displacement_only)
    other = antiresonances(sum_of_displacements(lightly_damped(parameters)))
    undamped = antiresonances(lightly_damped_response(parameters))
    free = "frequencies where a constrained system without damping is free to swing"
    of_sum, of_output = (antiresonances_without_damping(parameters, weights)[1] for weights in (SUM, OUTPUT))
    in_5_2, in_5_4 = (", ".join(f"{omega:.0f}" for omega in omegas) for omegas in (first, other))
    apart, shift = (float(np.abs(each / first - 1).max()) for each in (other, undamped))
    yield assertion(
        "figure 5.4 beside figure 5.2",
        "the antiresonances of the two figures are the same, as far as a plot can be read",
        apart < READING_ACCURACY,
        f"at {in_5_2} rad/s in figure 5.2 and {in_5_4} rad/s in figure 5.4, up to {100 * apart:.1f} % apart",
        method=f"zeros of the two transfer functions; {PLOT_READ}",
        second=close(free, of_sum, other[1], 1e-4),
        certainty=Certainty.READING,
    )
    yield assertion(
        "damping itself, for one output",
        "damping does not move the antiresonances, as far as a plot can be read",
        shift < READING_ACCURACY,
        f"those of $q_2 - q_4$ move by {100 * shift:.2f} % at most",
        method="zeros with all and with a thousandth of the damping",
        second=close(free, of_output, undamped[1], 1e-4),
    )
    yield text(f"""
        Resonances belong to the system, antiresonances to the output that is looked at. Figure 5.2 shows a
        difference of two displacements, figure 5.4 the sum of all four. Both have three valleys, which may be
        all that the text means. They do not stand at the same places: the one at {first[1]:.0f} rad/s is at
        {other[1]:.0f} rad/s in figure 5.4.

        None, since no later number uses an antiresonance. For one and the same output damping hardly moves
        them, as the text says.
    """)
