"""Claims of section 5.2.2 on predictions for inertia-controlled backlash (equations 5.7 and 5.8)."""

import math

import numpy as np
import sympy

from report.chapters.second_ways import LOEB, NEWTON, by_division_back, by_floquet
from report.judging.claim import ClaimPart
from report.judging.comparisons.printed import total
from report.judging.parts import assertion, close, digits, expression, so
from report.judging.record import Record, claim, text
from report.judging.verdict import Certainty
from report.numbers.evidence import Evidence
from report.numbers.independent.limit_cycles import inertia_exactly
from report.numbers.independent.loci import distance_from_curve
from report.numbers.thesis import TURN
from trimmer import InertiaBacklash, harmonic_leakage

BY_DURATIONS = "by two durations, with SciPy's matrix exponential"
ISOLATED = 1e-6  # Distance of a Floquet multiplier from one below which orbits may stand side by side
PRINTED_OMEGA = 5.12e3  # Printed angular frequency of the limit cycle, rad/s
FREQUENCY = "815 Hz, limit cycle predicted for inertia-controlled backlash"
BAND = "732 to 856 Hz, band of stable limit cycles with higher harmonics"
"""Things that are printed in more than one place, or are judged in more than one reading."""
THICK_BAND = (4.6e3, 5.38e3)  # Ends of that band, rad/s
HARMONICS = range(3, 40, 2)


def balance_part(printed_form: str) -> ClaimPart:
    """Return the part on the condition for harmonic balance, which equation 5.11 repeats."""
    element, linear = sympy.symbols("N G")
    return expression(
        "",
        total(element * linear, 1),
        sympy.expand(1 - linear * (-element)),
        printed_form=printed_form,
        derived_form="1 + N G = 0",
        item="N G + 1 = 0, condition for harmonic balance of backlash",
    )


@claim("eq-5.7")
def harmonic_balance(_: Evidence) -> Record:
    yield balance_part(r"N(\beta)\,G(j\omega) + 1 = 0")
    yield text(r"""
        This is [equation 2.25](#eq-2.25) with the ratio $\beta = b/A$ as variable, on which alone the
        describing function depends.
    """)


def thickness_part(known: Evidence) -> ClaimPart:
    """Return the part on the thickness that harmonics give the curve, of which figure 5.15 is an example."""
    system, cycle = known.numbers.displacement_only, known.cycles.inertia.stable
    element = InertiaBacklash(1.0)
    returned = sum(harmonic_leakage(system, element, cycle, HARMONICS))
    thickness = returned / abs(complex(element.describing_function(cycle.amplitude)))
    lines = abs(known.orbits.inertia.stable.harmonics)
    exact = float(lines[1:].sum() / lines[0])
    low, high = (distance_from_curve(system, element, omega) for omega in THICK_BAND)
    means = f"the exact orbit, whose harmonics have {100 * exact:.2f} % of its fundamental together"
    return assertion(
        "as the range in which the limit cycle may lie",
        "harmonics make the curve thick enough to meet $G$ over the whole band",
        max(low, high) <= thickness,
        f"""
        at the ends $G$ is {low:.3f} and {high:.3f} away from the curve; all harmonics that come back together
        are {100 * returned:.2f} % of the fundamental, a thickness of {thickness:.4f}
        """,
        method=f"harmonics 3 to {HARMONICS[-1]} of the element, each with the response of $G$",
        second=so(means, exact < min(low, high)),
        item=BAND,
        certainty=Certainty.READING,
    )


def converted(label: str, printed: str, omega: float, item: str = "") -> ClaimPart:
    """Return the part on a conversion from rad/s."""
    frequency = omega / TURN
    second = by_division_back(omega, frequency)
    return digits(label, printed, frequency, "Hz", second=second, item=item)


@claim("eq-5.8")
def band(known: Evidence) -> Record:
    orbit = known.orbits.inertia.stable
    multipliers = orbit.nontrivial_multipliers
    yield converted("lower end, from 4600 rad/s", "732", 4.6e3)
    yield converted("upper end, from 5380 rad/s", "856", 5.38e3)
    second = close(f"its frequency {BY_DURATIONS}", known.orbits.inertia_by_durations, orbit.frequency, 1e-6)
    yield thickness_part(known)
    yield assertion(
        "as limit cycles side by side",
        "with higher harmonics, stable limit cycles of one gap fill a band of frequencies",
        bool(np.abs(multipliers - 1).min() < ISOLATED),
        f"""
        with all harmonics there is one, at {orbit.frequency:.2f} Hz, and it stands alone: a disturbance keeps
        at most {np.abs(multipliers).max():.4f} of itself over a period
        """,
        method="Floquet multipliers of the exact orbit",
        second=second,
        item=BAND,
        certainty=Certainty.READING,
    )
    beside = abs(orbit.frequency - known.cycles.inertia.stable.frequency)
    yield text(f"""
        The conversions are right. The band is read from figure 5.15, which footnote 10 calls an example. Read
        as the range in which the limit cycle may lie, it is far too wide: the harmonics that come back move
        the curve by a small part of what the band asks for. Read as limit cycles side by side, it does not
        exist: the exact orbit holds all harmonics and is one point, {beside:.2f} Hz from the prediction.

        Higher harmonics do not explain the distance of a peak that [section 5.2.2](#txt-5.2.2-error)
        computes.
    """)


@claim("txt-5.2.2-beta-range")
def beta_range(known: Evidence) -> Record:
    largest = float(InertiaBacklash(1.0).domain(1.0))
    second = close("the contact equation at half a turn", math.pi - math.sin(math.pi), largest)
    item = "0 < beta <= 2, range of the inertia-controlled describing function"
    yield digits(r"largest $\beta = b/A$, $b$ the total gap", "2", largest, second=second, item=item)
    yield assertion(
        r"largest $\beta = b/A$, $b$ half of the gap",
        r"the range ends at $\beta = 2$",
        math.isclose(largest / 2, 2),
        f"it ends at {largest / 2:.4f}, half of what it is with the whole gap",
        method="the numeric element, whose gap is the whole one",
        second=close("half of pi", math.pi / 2, largest / 2),
        item=item,
    )
    beta = 1 / known.cycles.inertia.unstable.amplitude
    yield text(rf"""
        The text gives the gap as $2b$, so that the bound would be $\pi/2$; in the derivation and the listing
        $b$ is the whole gap, and it is $\pi$. With $b$ the whole gap, 2 is where the pin no longer reaches a
        bridge that stays put. A bridge with inertia flies on, and meets the other side within half a period
        as long as $\phi - \sin\phi = \beta$ has a root below $\pi$. Footnote 8 has the conventions of section
        2.3.4 exchanged: there $b$ is half of the gap for friction and all of it for inertia.

        The range from 2 to $\pi$ is left out, and with it a second, unstable limit cycle at $\beta =
        {beta:.1f}$ that the section does not mention.
    """)


@claim("txt-5.2.2-prediction")
def prediction(known: Evidence) -> Record:
    cycles = known.cycles
    cycle = cycles.inertia.stable
    second = close(NEWTON, inertia_exactly(known.numbers, cycle)[1], cycle.omega)
    yield digits("angular frequency", "5.12e3", cycle.omega, "rad/s", second=second, item=FREQUENCY)
    yield digits("frequency", "814.9", cycle.frequency, "Hz", second=second, item=FREQUENCY)
    yield converted("conversion of 5120 rad/s", "814.9", PRINTED_OMEGA, FREQUENCY)
    width = cycle.frequency - cycles.friction.stable.frequency
    both = cycles.inertia_both_channels.stable.frequency
    yield text(rf"""
        With the thesis's own loop and its own describing function the stable solution lies at
        {cycle.omega:.1f} rad/s, {cycle.frequency:.2f} Hz, with $A = {cycle.amplitude:.3f}\,b$. A second,
        unstable one lies at {cycles.inertia.unstable.frequency:.2f} Hz. Listing A.4, called with a second
        argument other than one, moves the intersection up to about 5050 rad/s; what gives 5120 rad/s could
        not be found.

        Friction- and inertia-controlled backlash lie {width:.1f} Hz apart instead of 82 Hz, and so do the
        ends of the band in equation 5.10, which the conclusions quote. With the pin's velocity as second
        input the stable solution is at {both:.2f} Hz.
    """)


@claim("txt-5.2.2-stable")
def stable(known: Evidence) -> Record:
    inner, outer = known.cycles.inertia.unstable, known.cycles.inertia.stable
    yield assertion(
        "",
        "the outer intersection is a stable limit cycle",
        (bool(outer.stable), outer.omega > inner.omega),
        f"Loeb's criterion at {outer.frequency:.2f} Hz",
        method=LOEB,
        second=by_floquet([known.orbits.inertia.stable], stable=True),
    )
    yield text(r"""
        A growing amplitude is a falling $\beta$, which moves $-1/N$ towards $-1$ and out of the locus, as the
        text says.
    """)
