"""Claims on the figures of section 5.2.5, 5.21 to 5.24: contours of the equivalent nonlinearity."""

import math

import numpy as np
import sympy

from derivations.elements.backlash import friction_waveform
from derivations.elements.friction import FORCE as COULOMB
from derivations.elements.waveform import simplified_describing_function
from derivations.symbols import A, omega
from report.chapters.appendix_a.claims.listings_a_2_to_a_6_describing_functions import (
    REACHED,
    friction_expression,
)
from report.chapters.chapter_5.claims import section_5_2_1_predictions, section_5_2_5
from report.chapters.chapter_5.claims.section_5_2_4 import at_the_merger
from report.chapters.chapter_5.claims.section_5_2_5_friction_term import coulomb_part
from report.chapters.second_ways import NEWTON, by_matching_real_parts
from report.judging.parts import assertion, close, digits, expression, repeated
from report.judging.record import Record, claim, text
from report.numbers.equivalent_nonlinearity import FORCE, FORCES, OTHER_FORCE
from report.numbers.evidence import Evidence
from report.numbers.independent.limit_cycles import friction_exactly
from report.numbers.thesis import DRIVE_OMEGA, LARGER_GAP, PLOT_OFFSET, ROUNDED, SMALL_GAP, TURN

LISTING = friction_expression() - sympy.I * 4 * COULOMB / (sympy.pi * A * omega)  # N of Listing A.6


@claim("fig-5.21")
def three_panels(known: Evidence) -> Record:
    found, system = known.cycles.equivalent.other_gap, known.numbers.displacement_only
    inner, outer = found
    yield coulomb_part(made=repeated)
    yield assertion(
        rf"for $F_c$ = {OTHER_FORCE}, $b$ = $200\times10^{{-5}}$ and the drive's frequency",
        "there is more than one intersection",
        len(found) > 1,
        f"at {inner.frequency:.1f} Hz, unstable, and at {outer.frequency:.1f} Hz, stable",
        method=section_5_2_5.BY_LISTING,
        second=by_matching_real_parts(system, -OTHER_FORCE / DRIVE_OMEGA / LARGER_GAP, len(found)),
    )
    share = OTHER_FORCE / LARGER_GAP / known.numbers.parameters.k2
    yield text(rf"""
        The contours are those of Listing A.6 with its [wrong friction term](#txt-5.2.5-coulomb-term);
        equation 5.14 would give others. With $A$ in gaps the listing's function contains $F_c/(\omega b)$
        alone, so the panels show one family three times. The right term gives one family too, with $F_c/(k_2
        b)$ in its place, {share:.4f} here, bent the other way and without frequency.

        The dependence on frequency is that of the wrong factor. The likeness to viscous-controlled backlash
        comes from the wrong sign, which makes friction a lag, as inertia is.
    """)


@claim("fig-5.22")
def without_force(known: Evidence) -> Record:
    stable, rounded = known.cycles.friction.stable, known.cycles.friction_listing.stable
    ratio, turning = friction_exactly(known.numbers, stable)
    size, derived = SMALL_GAP * stable.amplitude, simplified_describing_function(friction_waveform(), A)
    yield expression("Listing A.6 for $F_c = 0$", LISTING.subs(COULOMB, 0), derived, "N", assume=REACHED)
    cut = math.floor(1e8 * SMALL_GAP * rounded.amplitude) / 1e8
    slip = repeated(f"{ROUNDED}, and the last digit is cut off", cut)
    second, item = close(NEWTON, SMALL_GAP * ratio, size), section_5_2_1_predictions.AMPLITUDE
    yield digits("amplitude", "3.313e-5", size, "m", second=second, slip=slip, item=item)
    second, slip = close(NEWTON, turning / TURN, stable.frequency), repeated(ROUNDED, rounded.frequency)
    item = section_5_2_1_predictions.FREQUENCY
    yield digits("frequency", "733.3", stable.frequency, "Hz", second=second, slip=slip, item=item)
    inner = 1e6 * SMALL_GAP * known.cycles.friction.unstable.amplitude
    yield text(rf"""
        Without force the listing's function is that of backlash, and the intersections are those of figure
        5.8, as the text says. The amplitude and the frequency are those of the [rounded
        coefficients](#txt-5.2.1-prediction). The shorter path that the text mentions is a shorter range of
        amplitudes. The second intersection, at {inner:.2f} µm, would be missing on both curves if they begin
        as in Listing A.9, at $b/2 + {1e6 * PLOT_OFFSET:.0f}$ µm.

        None beyond the last digits. Equation 5.14 cannot have drawn this figure, as its real part lacks the
        factor $A/\pi$.
    """)


@claim("fig-5.23")
def one_force(known: Evidence) -> Record:
    numbers = known.cycles.equivalent
    yield section_5_2_5.intersections_part(numbers)
    yield section_5_2_5.frequency_part(numbers)
    yield from section_5_2_5.peak_parts(known, "b: ")
    both = len(numbers.over_stiffness_both_channels)
    yield text(f"""
        The one intersection comes from line 18 of Listing A.6. It is gone with the right friction term
        ({len(numbers.over_stiffness)} limit cycles), with the sign of that line turned
        ({len(numbers.sign_turned)}), and with the pin's velocity as second input ({both}). For this gap a
        limit cycle lasts up to {numbers.force_of_merger:.4f} N between cutter and guard; the force in the
        caption is {FORCE / numbers.force_of_merger:.0f} times as large.

        The peaks of part b are free vibrations of the loop, [as in the text](#txt-5.2.5-fft): for a start
        much larger than the gap it is linear.
    """)


@claim("fig-5.24")
def forces(known: Evidence) -> Record:
    numbers = known.cycles.equivalent
    listing = [known.cycles.friction.stable.frequency, *(cycle.frequency for cycle in numbers.by_force)]
    right = numbers.in_place.stable.frequency
    by_right, by_listing = (bool(np.all(np.diff(frequencies) > 0)) for frequencies in (right, listing))
    yield assertion(
        "stable intersection",
        "more friction moves it to a higher frequency",
        by_right,
        f"""
        from {right[0]:.2f} Hz without friction it falls to {right[-1]:.2f} Hz at the largest force that has a
        limit cycle
        """,
        method="all solutions of harmonic balance, friction between cutter and guard",
        second=at_the_merger(known),
        slip=repeated(section_5_2_5.LINE_18, by_listing),
    )
    yield text(f"""
        The listing's contours move the intersection up, from {listing[0]:.2f} to {listing[-1]:.2f} Hz at
        {FORCES[-1]} N, as the text says. With the [right friction term](#txt-5.2.5-coulomb-term) the
        frequency falls as the force grows, and the amplitude with it.

        The difference of 0.5705 % that the text explains by friction has the wrong direction.
    """)
