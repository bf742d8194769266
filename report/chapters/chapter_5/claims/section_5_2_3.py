"""Claims of section 5.2.3 on viscous-controlled backlash: the element (5.9) and predictions (5.10, 5.11)."""

import sympy

from derivations import assumed
from derivations.algebra.identity import UnprovenError
from derivations.elements.backlash import GAMMA, limits, separation_angle
from derivations.elements.proven_step import ProvenStep
from derivations.elements.steps import contours, general_backlash, slopes
from derivations.elements.steps.limits import step as limits_step
from report.chapters.chapter_5.claims import section_5_2_1_predictions, section_5_2_2
from report.chapters.chapter_5.claims.section_5_2_2 import balance_part
from report.chapters.second_ways import ALL_LOADS, NEWTON, by_division_back, by_floquet, by_waveform
from report.judging.claim import ClaimPart, Confirmation
from report.judging.comparisons.assertion import Assertion
from report.judging.parts import assertion, close, digits, expression, repeated
from report.judging.record import Record, claim, text
from report.judging.verdict import Severity
from report.numbers.evidence import Evidence
from report.numbers.independent.limit_cycles import friction_exactly, inertia_exactly
from report.numbers.independent.loci import lies_between_the_limits
from report.numbers.limit_cycle_numbers import TIME_CONSTANTS
from report.numbers.thesis import ROUNDED, TURN
from trimmer import ViscousBacklash

UPPER_END = "815"  # Upper end of the band of equation 5.10, Hz
GAMMAS = (0.01, 0.1, 0.3, 1.0, 1.25, 1.5, 3.0, 10.0, 100.0)


def band_parts(known: Evidence) -> tuple[ClaimPart, ClaimPart]:
    """Return the parts on the two ends of the band, which equation 5.10 and figure 5.17 share."""
    low, high = known.cycles.friction.stable, known.cycles.inertia.stable
    by_friction = close(NEWTON, friction_exactly(known.numbers, low)[1], low.omega)
    by_inertia = close(NEWTON, inertia_exactly(known.numbers, high)[1], high.omega)
    slip = repeated(ROUNDED, known.cycles.friction_listing.stable.frequency)
    wrong = repeated(
        "the prediction of section 5.2.2 is taken, 5120 rad/s", section_5_2_2.PRINTED_OMEGA / TURN
    )
    of_friction, of_inertia = section_5_2_1_predictions.FREQUENCY, section_5_2_2.FREQUENCY
    return (
        digits(
            "lower end",
            "733",
            low.frequency,
            "Hz",
            second=by_friction,
            slip=slip,
            item=of_friction,
            severity=Severity.SLIP,
        ),
        digits("upper end", UPPER_END, high.frequency, "Hz", second=by_inertia, slip=wrong, item=of_inertia),
    )


@claim("eq-5.10")
def band(known: Evidence) -> Record:
    low, high = known.cycles.friction.stable, known.cycles.inertia.stable
    yield from band_parts(known)
    low_both = known.cycles.friction_both_channels.stable
    high_both = known.cycles.inertia_both_channels.stable
    yield text(f"""
        The ends are the two limits of the load: {low.frequency:.1f} Hz without inertia and
        {high.frequency:.1f} Hz without friction. The upper one repeats the wrong
        [prediction](#txt-5.2.2-prediction) of section 5.2.2.

        The band is {high.frequency - low.frequency:.0f} Hz wide instead of 82 Hz. With the pin's velocity as
        second input it runs from {low_both.frequency:.1f} to {high_both.frequency:.1f} Hz.
    """)


@claim("eq-5.11")
def harmonic_balance(_: Evidence) -> Record:
    yield balance_part(r"N\left(\frac{b}{A}, \frac{M}{D}\omega\right)G(j\omega) + 1 = 0")
    yield text(r"""
        The condition is that [of equation 5.7](#eq-5.7), with another describing function. For a measured
        frequency it gives two real equations for $b/A$ and $M\omega/D$, as many as unknowns. The driving
        frequency, which the text asks for, does not appear: the frequency in it is that of the limit cycle.
    """)


@claim("txt-5.2.3-unstable-inner")
def inner(known: Evidence) -> Record:
    unstable = [cycle for cycles in known.cycles.viscous for cycle in cycles if cycle.omega < 4000]
    loads, orbits = len(TIME_CONSTANTS), (known.orbits.friction.unstable, known.orbits.inertia.unstable)
    yield assertion(
        "",
        "all limit cycles on the inner part of the locus are unstable",
        (bool(unstable), not any(cycle.stable for cycle in unstable)),
        f"{len(unstable)} of them over {loads} values of $M/D$, none stable by Loeb's criterion",
        method=ALL_LOADS,
        second=by_floquet(orbits, stable=False),
    )
    yield text("""
        It is so by Loeb's criterion, too. A motion that leaves one of them with a larger amplitude grows to
        the stable one, as the text says; one that leaves it with a smaller amplitude dies out. For $M/D$ near
        0.1 ms there is no inner one at all.
    """)


@claim("txt-5.2.3-band")
def only_between(known: Evidence) -> Record:
    cycles, system = known.cycles, known.numbers.displacement_only
    low, high = cycles.friction.stable, cycles.inertia.stable
    stable = [cycle for each in cycles.viscous for cycle in each if cycle.stable]
    loads = [ViscousBacklash(1.0, time_constant) for time_constant in TIME_CONSTANTS]
    least, most = (pick(cycle.frequency for cycle in stable) for pick in (min, max))
    yield assertion(
        "",
        "stable limit cycles lie between the frequencies of the two limits",
        (low.frequency - 1e-3 <= least < most <= high.frequency + 1e-3, len(stable) == len(TIME_CONSTANTS)),
        f"one for each $M/D$, with a frequency that rises from {least:.2f} to {most:.2f} Hz",
        method=ALL_LOADS,
        second=by_waveform(system, list(zip(loads, stable, strict=True))),
    )
    yield text(f"""
        For this trimmer there is exactly one stable limit cycle for every load, and its frequency lies
        between the limits, of which [equation 5.10](#eq-5.10) has the upper one wrong. The amplitude is not
        bounded by them: it reaches {cycles.largest_viscous.amplitude:.2f} gaps, where the limits have
        {low.amplitude:.2f} and {high.amplitude:.2f}.
    """)


@claim("txt-5.2.3-identify-760")
def identify(known: Evidence) -> Record:
    limit = known.cycles.inertia.stable
    highest = max(cycle.frequency for each in known.cycles.viscous for cycle in each if cycle.stable)
    by_newton = inertia_exactly(known.numbers, limit)[1]
    example = 760
    second = by_division_back(example * TURN, example)
    yield digits("conversion", "4775", example * TURN, "rad/s", second=second)
    yield assertion(
        "a ratio M/D for 760 Hz",
        "a measured 760 Hz gives a ratio $M/D$",
        highest >= example,
        f"no $M/D$ has a stable limit cycle above {limit.frequency:.2f} Hz",
        method=ALL_LOADS,
        second=close(f"{NEWTON}, for the limit without friction", by_newton, limit.omega),
        slip=repeated(
            "the band of equation 5.10 is taken, which ends at 815 Hz", float(UPPER_END) >= example
        ),
    )
    width = limit.frequency - known.cycles.friction.stable.frequency
    yield text(f"""
        The conversion is right. The frequency is an example of the thesis, chosen within its own band of
        [equation 5.10](#eq-5.10). With the right band no load gives it.

        The proposed experiment keeps its sense, but has {width:.0f} Hz to resolve instead of 82 Hz.
    """)


@claim("eq-5.9")
def separation(_: Evidence) -> Record:
    mass, damping, omega = assumed.positive("M D omega")
    derived = separation_angle().subs(GAMMA, mass * omega / damping)
    angle = sympy.Symbol("phi_s")
    yield expression("first line", sympy.atan(1 / GAMMA), separation_angle(), left=angle)
    yield expression("second line", sympy.atan(damping / (mass * omega)), derived, left=angle)
    yield text(r"""
        This is [equation 2.44](#eq-2.44) with $\gamma = M\omega/D$ put in. A higher frequency gives an
        earlier separation, as the text says.
    """)


@claim("txt-5.2.3-limits")
def limits_of_the_load(_: Evidence) -> Record:
    delay, ratio = assumed.positive("tau"), r"\frac{b}{A}"
    friction, inertia = limits(sympy.Integer(0)), limits(sympy.oo)
    yield expression(r"$\gamma \to 0$, contact", 1 - sympy.cos(delay), friction.ratio, ratio)
    yield expression(r"$\gamma \to \infty$, contact", delay - sympy.sin(delay), inertia.ratio, ratio)
    yield text(r"""
        Separation, flight and contact of the general element tend to those of friction-controlled backlash
        for $\gamma \to 0$ and of inertia-controlled for $\gamma \to \infty$. The text reads it from figure
        5.16; the limits prove it. $\tau$ is the phase of flight.
    """)


def proven(*steps: ProvenStep) -> bool:
    """Return whether every equation of the steps is proven."""
    try:
        for step in steps:
            step.proven()
    except UnprovenError:
        return False
    return True


@claim("txt-5.2.3-contours-bounded")
def contours_bounded(_: Evidence) -> Record:
    statement = "every viscous contour lies between those of friction and inertia"
    computed = Assertion(
        statement,
        all(lies_between_the_limits(gamma) for gamma in GAMMAS),
        "they lie in the region that the two limits enclose",
        "contours of $N$, computed",
    )
    yield assertion(
        r"for every $\gamma$",
        statement,
        proven(general_backlash.describing_function(), limits_step(), slopes.step(), contours.step()),
        r"""
        $N$ as a map of $b/A$ and $\gamma$ has a Jacobian without zeros, and takes the edge of its domain to
        the two contours and a piece of the imaginary axis
        """,
        method="proof in the derivation of the describing functions",
        second=Confirmation(r"200 points of each of nine contours, $\gamma$ from 0.01 to 100", computed),
    )
    yield text(r"""
        With the right contact equation it is so for every $\gamma$, and each point between the two limits
        belongs to one $b/A$ and one $\gamma$ only. The contours that the thesis drew, for $1 < \gamma < 3/2$,
        come from [complex contact angles](#fig-5.16) and could not show it.
    """)
