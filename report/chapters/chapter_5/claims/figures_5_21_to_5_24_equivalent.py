"""Claims on the figures of section 5.2.5, 5.21 to 5.24: contours of the equivalent nonlinearity."""

from __future__ import annotations

import math

import numpy as np
import sympy

from derivations.elements.backlash import GAP as TOTAL_GAP
from derivations.elements.backlash import friction_waveform
from derivations.elements.friction import FORCE as COULOMB
from derivations.elements.waveform import simplified_describing_function
from derivations.symbols import A, omega
from report.chapters.appendix_a.claims.listings_a_2_to_a_6_describing_functions import (
    REACHED,
    friction_expression,
)
from report.chapters.chapter_5.claims import section_5_2_5
from report.chapters.second_ways import NEWTON, by_matching_real_parts
from report.claim import Impact
from report.evidence import Evidence
from report.numbers.equivalent_nonlinearity import FORCE, FORCES, OTHER_FORCE, listing_element
from report.numbers.independent.limit_cycles import friction_exactly
from report.parts import assertion, close, digits, equal, expression, made_here, repeated
from report.record import Record, claim, text
from report.thesis import DRIVE_OMEGA, LARGER_GAP, PLOT_OFFSET, ROUNDED, SMALL_GAP, TURN

SOURCE = "report/numbers/equivalent_nonlinearity.py"
LISTING = friction_expression() - sympy.I * 4 * COULOMB / (sympy.pi * A * omega)
"""N of Listing A.6."""


@claim("fig-5.21", source=SOURCE, impact=Impact.DOWNSTREAM)
def three_panels(known: Evidence) -> Record:
    found, system = known.cycles.equivalent.other_gap, known.numbers.displacement_only
    inner, outer = found
    gaps, load = sympy.symbols("a phi", positive=True)
    scaled = LISTING.subs(A, gaps * TOTAL_GAP).subs(COULOMB, load * omega * TOTAL_GAP)
    first = complex(listing_element(0.15, 2e-3, 600.0).describing_function(4e-3))
    alike = complex(listing_element(0.6, 4e-3, 1200.0).describing_function(8e-3))
    means = "the numeric element for another gap, force and frequency with the same quotient"
    yield section_5_2_5.coulomb_part()
    yield assertion(
        "the three panels",
        r"changing $\omega$, $F_c$ or $b$ gives three families of contours",
        not scaled.free_symbols <= {gaps, load},
        r"""
        with $A$ in gaps the listing's function contains $F_c/(\omega b)$ alone, so the panels show one family
        three times
        """,
        method=r"the listing's function with $A = ab$ and $F_c = \varphi\omega b$",
        second=close(means, first, alike),
    )
    yield assertion(
        rf"for $F_c$ = {OTHER_FORCE}, $b$ = $200\times10^{{-5}}$ and the drive's frequency",
        "there is more than one intersection",
        len(found) > 1,
        f"at {inner.frequency:.1f} Hz, unstable, and at {outer.frequency:.1f} Hz, stable",
        method=section_5_2_5.BY_LISTING,
        second=by_matching_real_parts(system, -OTHER_FORCE / DRIVE_OMEGA / LARGER_GAP, len(found)),
    )
    yield text(r"""
        The contours are those of Listing A.6, whose friction term has the wrong sign and a factor $1/\omega$
        that does not belong there; equation 5.14 would give others. With the right term there is one family
        too, with $F_c/(k_2 b)$ in place of $F_c/(\omega b)$ and bent the other way, and frequency has no part
        in it. For this force and gap friction hardly counts: $F_c/(k_2 b)$ is [[ share | f4 ]].

        The dependence on frequency is that of the wrong factor. The likeness to viscous-controlled backlash
        comes from the wrong sign, which makes friction a lag, as inertia is.
    """).given(share=OTHER_FORCE / LARGER_GAP / known.numbers.parameters.k2)


@claim("fig-5.22", source=SOURCE, impact=Impact.LOCAL)
def without_force(known: Evidence) -> Record:
    stable, rounded = known.cycles.friction.stable, known.cycles.friction_listing.stable
    ratio, turning = friction_exactly(known.numbers, stable)
    size, derived = SMALL_GAP * stable.amplitude, simplified_describing_function(friction_waveform(), A)
    yield expression("Listing A.6 for $F_c = 0$", LISTING.subs(COULOMB, 0), derived, "N", assume=REACHED)
    cut = math.floor(1e8 * SMALL_GAP * rounded.amplitude) / 1e8
    slip = repeated(f"{ROUNDED}, and the last digit is cut off", cut)
    yield digits("amplitude", "3.313e-5", size, "m", second=close(NEWTON, SMALL_GAP * ratio, size), slip=slip)
    second, slip = close(NEWTON, turning / TURN, stable.frequency), repeated(ROUNDED, rounded.frequency)
    yield digits("frequency", "733.3", stable.frequency, "Hz", second=second, slip=slip)
    yield text(r"""
        Without force the listing's function is that of backlash, and the intersections are those of figure
        5.8, as the text says. Equation 5.14 for $F_c = 0$ is something else, because its real part lacks the
        factor $A/\pi$. The shorter path is the range of amplitudes that was drawn: the second intersection,
        at [[ inner | f2 ]] µm, lies below $b/2 + [[ offset | f0 ]]$ µm.

        See the prediction in section 5.2.1; equation 5.14 cannot have drawn this figure.
    """).given(inner=1e6 * SMALL_GAP * known.cycles.friction.unstable.amplitude, offset=1e6 * PLOT_OFFSET)


@claim("fig-5.23", source=SOURCE, impact=Impact.DOWNSTREAM)
def one_force(known: Evidence) -> Record:
    numbers, system = known.cycles.equivalent, known.numbers.displacement_only
    both, turned = len(numbers.over_stiffness_both_channels), len(numbers.sign_turned)
    in_place = numbers.in_place_both_channels.limit_cycles(FORCE / SMALL_GAP)
    yield section_5_2_5.intersections_part(numbers)
    yield digits(
        "the same in the loop with both channels of the pin",
        "1",
        both,
        second=equal("friction between cutter and guard in its own place", in_place, both),
        slip=made_here(section_5_2_5.LINE_18, len(numbers.listing_both_channels)),
    )
    yield digits(
        "limit cycles by Listing A.6 with the sign of line 18 turned",
        "1",
        turned,
        second=by_matching_real_parts(system, FORCE / DRIVE_OMEGA / SMALL_GAP, turned),
        slip=made_here(section_5_2_5.LINE_18, len(numbers.listing)),
    )
    yield section_5_2_5.frequency_part(numbers)
    yield from section_5_2_5.peak_parts(known, "b: ")
    yield text(r"""
        The one intersection is an effect of line 18: its sign alone decides. With friction that takes energy
        there is none. For a gap of $4\times10^{-6}$ m a limit cycle bears at most [[ most | f4 ]] N between
        cutter and guard; the force in the caption is [[ times | f0 ]] times as large.

        The peaks of part b are free vibrations of the loop, which is linear for a start much larger than the
        gap: see the peaks of section 5.2.5.
    """).given(most=numbers.force_of_merger, times=FORCE / numbers.force_of_merger)


@claim("fig-5.24", source="report/numbers/friction_in_place.py", impact=Impact.DOWNSTREAM)
def forces(known: Evidence) -> Record:
    numbers = known.cycles.equivalent
    listing = [known.cycles.friction.stable.frequency, *(cycle.frequency for cycle in numbers.by_force)]
    right = numbers.in_place.stable.frequency
    by_right, by_listing = (bool(np.all(np.diff(frequencies) > 0)) for frequencies in (right, listing))
    yield assertion(
        "stable intersection",
        "more friction moves it to a higher frequency",
        by_right,
        """
        from [[ first | f2 ]] Hz without friction it falls to [[ last | f2 ]] Hz at the largest force that has
        a limit cycle
        """,
        numbers={"first": right[0], "last": right[-1]},
        method="all solutions of harmonic balance, friction between cutter and guard",
        second=section_5_2_5.at_the_merger(known),
        slip=made_here(section_5_2_5.LINE_18, by_listing),
    )
    yield text("""
        The listing's contours move the intersection up, from [[ first | f2 ]] to [[ last | f2 ]] Hz at
        [[ force ]] N, and hardly further for any force: the limit is where the real part of $1/G$ is $-1$, in
        which neither gap nor force takes part. With the right term the frequency falls as the force grows,
        and the amplitude with it.

        The explanation of the 0.57 % by friction has the wrong direction.
    """).given(first=listing[0], last=listing[-1], force=FORCES[-1])
