"""Claim of chapter 7 on the drive's frequency: what each kind of play does at low and at high frequency."""

import numpy as np
import sympy

from derivations.elements import backlash
from derivations.elements.friction import FORCE
from derivations.elements.waveform import describing_function
from derivations.symbols import A, omega
from report.chapters.appendix_a.claims.listings_a_2_to_a_6_describing_functions import friction_expression
from report.chapters.chapter_5.claims.figures_5_21_to_5_24_equivalent import LISTING
from report.chapters.chapter_5.claims.section_5_2_1_driven import open_loop, open_loop_harmonic
from report.chapters.chapter_7.claims.input import BY_RESPONSE, FIFTH, SIMULATED
from report.chapters.second_ways import ALL_LOADS
from report.judging.claim import ClaimPart
from report.judging.parts import assertion, close, expression, small, so
from report.judging.record import Record, claim, text
from report.judging.verdict import Certainty, Severity
from report.numbers.evidence import Evidence
from report.numbers.listed_functions import (
    IN_GAPS,
    equivalent_contour,
    inertia_contour,
    inertia_listing,
    mean_distance,
)
from report.numbers.thesis import (
    DRIVE_FREQUENCY,
    DRIVE_OMEGA,
    LARGE_GAP,
    MEASURED_DRIVE_FREQUENCY,
    MEASURED_DRIVE_OMEGA,
    TURN,
)
from trimmer import LimitCycle, ViscousBacklash

RELAY_FORCE, GAP = 0.15, 2e-3  # Of figure 5.21, N and m
FAST, SLOW = TURN * 1e5, TURN * 10.0  # Angular frequencies far above that of the drive and below it, rad/s
BY_ORBITS = "the ratio of the exact orbits' frequencies"


@claim("txt-7-input-frequency")
def input_frequency(known: Evidence) -> Record:
    stable = [cycle for found in known.cycles.viscous for cycle in found if cycle.stable]
    largest = max(cycle.amplitude for cycle in stable)
    yield without_frequency()
    yield output_of_the_driven_trimmer(known)
    yield condition_as_a_whole(known)
    yield what_the_listing_adds()
    yield contours_with_falling_frequency()
    yield range_of_frequencies(known, stable)
    fall = 100 * (1 - known.cycles.inertia.stable.amplitude / largest)
    yield text(f"""
        Two of the functions do not depend on frequency, as the text says. If performance means the predicted
        limit cycle, the drive's frequency indeed does not enter; if it means the vibration, it decides which
        harmonics meet a resonance. Read as a rule for reading off a found intersection, amplitude from $N$
        and frequency from $G$, the condition is right too; where the curves intersect depends on both. The
        contour of Listing A.6 passes by that of inertia because of its [wrong factor](#lst-A.6), and the
        range of frequencies is narrow as stated, though the amplitude falls by {fall:.0f} % over it.

        With the drive of the experiment the fifth harmonic meets a resonance of Listing A.1, another
        trimmer's, which matters more for the vibration than anything in this answer.
    """)


def without_frequency() -> ClaimPart:
    """Return the part on the describing functions of the two limits."""
    friction = describing_function(backlash.friction_waveform(), A)
    inertia = describing_function(backlash.inertia_waveform(), A).subs(
        backlash.GAP, A * backlash.inertia_contact_ratio()
    )
    limits, slow_and_fast = (ViscousBacklash(1.0, each) for each in (1e-9, 1e3)), np.array([1e2, 1e4])
    changes = [abs(complex(np.diff(each.describing_function(2.0, slow_and_fast))[0])) for each in limits]
    general = "the general element with $M/D$ of 1 ns and of 1000 s, at 100 and at 10 000 rad/s"
    return assertion(
        "describing functions",
        "those of friction- and inertia-controlled backlash do not depend on frequency",
        not {omega, backlash.GAMMA} & (friction.free_symbols | inertia.free_symbols),
        "with $A$, the gap and the contact angle they are complete",
        method="symbols of the derived functions",
        second=so(general, max(changes) < 1e-4),
        certainty=Certainty.PROVEN,
    )


def output_of_the_driven_trimmer(known: Evidence) -> ClaimPart:
    """Return the part on the fifth harmonic behind friction-controlled backlash, for two drives."""
    fifth, measured = (
        open_loop_harmonic(known, FIFTH, omega=each) for each in (DRIVE_OMEGA, MEASURED_DRIVE_OMEGA)
    )
    return assertion(
        "what follows for the output, read as that of the driven trimmer",
        "for friction-controlled backlash the input frequency changes nothing",
        abs(measured / fifth - 1) < 0.1,
        f"""
        with Listing A.1 and a gap of {1e6 * LARGE_GAP:.0f} µm the fifth harmonic is {1e6 * fifth:.0f} µm for
        a drive of {DRIVE_FREQUENCY:.0f} Hz and {1e6 * measured:.0f} µm for the {MEASURED_DRIVE_FREQUENCY} Hz
        of the experiment, whose trimmer is another one
        """,
        method=BY_RESPONSE,
        second=close(SIMULATED, open_loop(known).harmonics[FIFTH], fifth, 1e-4),
        severity=Severity.RESULT,
        certainty=Certainty.READING,
    )


def exact_ratio(known: Evidence) -> float:
    """Return the frequency of the exact orbit with inertia alone over that with friction alone."""
    return known.orbits.inertia.stable.frequency / known.orbits.friction.stable.frequency


def condition_as_a_whole(known: Evidence) -> ClaimPart:
    """Return the part on what the frequency of a limit cycle follows from."""
    friction, inertia = (pair.stable.frequency for pair in (known.cycles.friction, known.cycles.inertia))
    return assertion(
        "condition of harmonic balance, read as a whole",
        "the frequency follows from the transfer function alone",
        abs(inertia / friction - 1) < 1e-6,
        f"""
        with the same $G$ it is {friction:.2f} Hz for friction- and {inertia:.2f} Hz for inertia-controlled
        backlash
        """,
        method="all solutions of harmonic balance for both elements",
        second=close(BY_ORBITS, exact_ratio(known), inertia / friction, 0.005),
        severity=Severity.SLIP,
        certainty=Certainty.READING,
    )


def what_the_listing_adds() -> ClaimPart:
    """Return the part on the equivalent nonlinearity at high frequency."""
    added = LISTING - friction_expression()
    far_up = abs(complex(added.subs({FORCE: 1, A: 1, omega: 10**12})))
    return expression(
        "what Listing A.6 adds to backlash, with rising frequency",
        sympy.Integer(0),
        sympy.limit(added, omega, sympy.oo),
        r"\lim (N - N_r)",
        second=small("its size at $10^{12}$ rad/s, raised by one", far_up),
    )


def contours_with_falling_frequency() -> ClaimPart:
    """Return the part on the contour of the equivalent nonlinearity as frequency falls."""
    inertia = inertia_contour(GAP)
    high, drive, low = (
        mean_distance(equivalent_contour(RELAY_FORCE, GAP, each), inertia)
        for each in (FAST, DRIVE_OMEGA, SLOW)
    )
    values = LISTING.subs({FORCE: RELAY_FORCE, backlash.GAP: GAP, omega: SLOW})
    gains = sympy.lambdify(A, values, "numpy")(GAP * IN_GAPS + 0j)
    by_listing = np.array([-1 / inertia_listing(1 / each, 1.0) for each in IN_GAPS])
    return assertion(
        "equivalent nonlinearity, with falling frequency",
        "the contour becomes similar to that of inertia-controlled backlash",
        low < high / 2,
        f"""
        with {RELAY_FORCE} N and {1e3 * GAP:.0f} mm, as in figure 5.21, the contour of Listing A.6 lies
        {high:.2f} from it on average at high frequency, {drive:.2f} at {DRIVE_FREQUENCY:.0f} Hz and {low:.2f}
        at {SLOW / TURN:.0f} Hz; below that it passes by, towards zero
        """,
        method="distances of both contours, point by point",
        second=close(
            "Listing A.4 and the formula of Listing A.6", mean_distance(-1 / gains, by_listing), low
        ),
    )


def range_of_frequencies(known: Evidence, stable: list[LimitCycle]) -> ClaimPart:
    """Return the part on the frequencies of the stable limit cycles over all loads."""
    lowest, highest = (limit(cycle.frequency for cycle in stable) for limit in (min, max))
    return assertion(
        "range of frequencies",
        "stable limit cycles have nearly one frequency whatever $M/D$ is",
        highest / lowest < 1.03,
        f"from {lowest:.1f} to {highest:.1f} Hz",
        method=ALL_LOADS,
        second=close(BY_ORBITS, exact_ratio(known), highest / lowest, 0.005),
    )
