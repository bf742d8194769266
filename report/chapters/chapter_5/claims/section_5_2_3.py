"""Claims of section 5.2.3 on viscous-controlled backlash: the element (5.9) and predictions (5.10, 5.11)."""

from __future__ import annotations

import sympy

from derivations.algebra.identity import UnprovenError
from derivations.elements.backlash import GAMMA, limits, separation_angle
from derivations.elements.proven_step import ProvenStep
from derivations.elements.steps import contours, general_backlash, slopes
from derivations.elements.steps.limits import step as limits_step
from report.chapters.second_ways import ALL_LOADS, NEWTON, by_division_back, by_floquet, by_waveform
from report.claim import Confirmation, Impact, Part
from report.comparisons.assertion import Assertion
from report.comparisons.printed import total
from report.evidence import Evidence
from report.numbers.independent.limit_cycles import friction_exactly, inertia_exactly
from report.numbers.independent.loci import lies_between_the_limits
from report.numbers.limit_cycle_numbers import TIME_CONSTANTS
from report.parts import assertion, close, digits, expression, repeated
from report.record import Record, claim, text
from report.thesis import ROUNDED, TURN
from trimmer import ViscousBacklash

SOLVER = "trimmer/balance/solve.py"
GAMMAS = (0.01, 0.1, 0.3, 1.0, 1.25, 1.5, 3.0, 10.0, 100.0)


def band_parts(known: Evidence) -> tuple[Part, Part]:
    """Return the parts on the two ends of the band, which equation 5.10 and figure 5.17 share."""
    low, high = known.cycles.friction.stable, known.cycles.inertia.stable
    by_friction = close(NEWTON, friction_exactly(known.numbers, low)[1], low.omega)
    by_inertia = close(NEWTON, inertia_exactly(known.numbers, high)[1], high.omega)
    slip = repeated(ROUNDED, known.cycles.friction_listing.stable.frequency)
    return (
        digits("lower end", "733", low.frequency, "Hz", second=by_friction, slip=slip),
        digits("upper end", "815", high.frequency, "Hz", second=by_inertia),
    )


@claim("eq-5.10", source=SOLVER, impact=Impact.DOWNSTREAM)
def band(known: Evidence) -> Record:
    low, high = known.cycles.friction.stable, known.cycles.inertia.stable
    yield from band_parts(known)
    yield text("""
        The ends are the two limits of the load: [[ low.frequency | f1 ]] Hz without inertia and
        [[ high.frequency | f1 ]] Hz without friction. The upper one repeats the wrong prediction of section
        5.2.2.

        The band is [[ width | f0 ]] Hz wide instead of 82 Hz. With the pin's velocity as second input it runs
        from [[ low_both.frequency | f1 ]] to [[ high_both.frequency | f1 ]] Hz.
    """).given(
        low=low,
        high=high,
        width=high.frequency - low.frequency,
        low_both=known.cycles.friction_both_channels.stable,
        high_both=known.cycles.inertia_both_channels.stable,
    )


@claim("eq-5.11", source="report/chapters/chapter_5/claims/section_5_2_3.py")
def harmonic_balance(_: Evidence) -> Record:
    element, linear = sympy.symbols("N G")
    yield expression("", total(element * linear, 1), sympy.expand(1 - linear * (-element)))
    yield text(r"""
        For a measured frequency these are two real equations for $b/A$ and $M\omega/D$, as many as unknowns.
        The driving frequency, which the text asks for, does not appear: the frequency in $\gamma$ is that of
        the limit cycle.
    """)


@claim("txt-5.2.3-unstable-inner", source="trimmer/balance/stability.py")
def inner(known: Evidence) -> Record:
    unstable = [cycle for cycles in known.cycles.viscous for cycle in cycles if cycle.omega < 4000]
    loads, orbits = len(TIME_CONSTANTS), (known.orbits.friction.unstable, known.orbits.inertia.unstable)
    yield assertion(
        "",
        "all limit cycles on the inner part of the locus are unstable",
        bool(unstable) and not any(cycle.stable for cycle in unstable),
        f"{len(unstable)} of them over {loads} values of $M/D$, none stable by Loeb's criterion",
        method=ALL_LOADS,
        second=by_floquet(orbits, stable=False),
    )
    yield text("""
        True by Loeb's criterion. The text lets them merge with the stable ones; they do not: a motion that
        starts near one either decays or grows to the stable one. For $M/D$ near 0.1 ms there is no inner one
        at all.
    """)


@claim("txt-5.2.3-band", source=SOLVER)
def only_between(known: Evidence) -> Record:
    cycles, system = known.cycles, known.numbers.displacement_only
    low, high = cycles.friction.stable, cycles.inertia.stable
    stable = [cycle for each in cycles.viscous for cycle in each if cycle.stable]
    loads = [ViscousBacklash(1.0, time_constant) for time_constant in TIME_CONSTANTS]
    least, most = (pick(cycle.frequency for cycle in stable) for pick in (min, max))
    between = low.frequency - 1e-3 <= least and most <= high.frequency + 1e-3
    yield assertion(
        "",
        "stable limit cycles lie between the frequencies of the two limits",
        between and len(stable) == len(TIME_CONSTANTS),
        f"one for each $M/D$, with a frequency that rises from {least:.2f} to {most:.2f} Hz",
        method=ALL_LOADS,
        second=by_waveform(system, list(zip(loads, stable, strict=True))),
    )
    yield text("""
        For this trimmer there is exactly one stable limit cycle for every load, and its frequency lies
        between the limits, whose values in equation 5.10 are wrong. The amplitude is not bounded by them: it
        reaches [[ largest | f2 ]] gaps, where the limits have [[ friction | f2 ]] and [[ inertia | f2 ]].
    """).given(largest=cycles.largest_viscous.amplitude, friction=low.amplitude, inertia=high.amplitude)


@claim("txt-5.2.3-identify-760", source=SOLVER, impact=Impact.LOCAL)
def identify(known: Evidence) -> Record:
    limit = known.cycles.inertia.stable
    highest = max(cycle.frequency for each in known.cycles.viscous for cycle in each if cycle.stable)
    by_newton = inertia_exactly(known.numbers, limit)[1]
    yield digits("conversion", "4775", 760 * TURN, "rad/s", second=by_division_back(760 * TURN, 760))
    yield assertion(
        "a ratio M/D for 760 Hz",
        "a measured 760 Hz gives a ratio $M/D$",
        highest >= 760,
        f"no $M/D$ has a stable limit cycle above {limit.frequency:.2f} Hz",
        method=ALL_LOADS,
        second=close(f"{NEWTON}, for the limit without friction", by_newton, limit.omega),
    )
    yield text("""
        The conversion is right. The example lies outside of what the model can give, for any load; in the
        printed band of equation 5.10 it looks possible.

        The proposed experiment keeps its sense, with a band less than a quarter as wide to resolve.
    """)


@claim("eq-5.9", source="derivations/elements/backlash.py")
def separation(_: Evidence) -> Record:
    mass, damping, omega = sympy.symbols("M D omega", positive=True)
    derived = separation_angle().subs(GAMMA, mass * omega / damping)
    yield expression("", sympy.atan(damping / (mass * omega)), derived, left=sympy.Symbol("phi_s"))
    yield text(r"""
        Equation 2.44 with $\gamma = M\omega/D$ put in. A higher frequency gives an earlier separation, as the
        text says.
    """)


@claim("txt-5.2.3-limits", source="derivations/elements/backlash.py")
def limits_of_the_load(_: Evidence) -> Record:
    delay, ratio = sympy.Symbol("tau", positive=True), r"\frac{b}{A}"
    friction, inertia = limits(sympy.Integer(0)), limits(sympy.oo)
    yield expression(r"$\gamma \to 0$, contact", 1 - sympy.cos(delay), friction.ratio, ratio)
    yield expression(r"$\gamma \to \infty$, contact", delay - sympy.sin(delay), inertia.ratio, ratio)
    yield text(r"""
        Separation, flight and contact of the general element tend to those of friction-controlled backlash
        for $\gamma \to 0$ and of inertia-controlled for $\gamma \to \infty$; $\tau$ is the phase of flight.
        The figure shows it, the limits prove it.
    """)


def proven(*steps: ProvenStep) -> bool:
    """Return whether every equation of the steps is proven."""
    try:
        for step in steps:
            step.proven()
    except UnprovenError:
        return False
    return True


@claim("txt-5.2.3-contours-bounded", source="derivations/elements/steps/contours.py")
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
        It is so for every $\gamma$, with the right contact equation. The contours that the thesis drew, for
        $1 < \gamma < 3/2$, come from complex contact angles and could not show it. Besides, each point
        between the two limits belongs to one $b/A$ and one $\gamma$ only.
    """)
