"""Claims of chapter 6 before section 6.1, and of section 6.2: how many limit cycles, and filtering."""

from __future__ import annotations

import math

import sympy

from derivations.elements.friction import FORCE, relay_waveform
from derivations.elements.waveform import THETA
from report.chapters.second_ways import by_grid, by_quadrature
from report.claim import Impact
from report.evidence import Evidence
from report.numbers.independent import loci
from report.numbers.independent.exact_response import gain_ratio
from report.numbers.independent.waveforms import coefficient
from report.parts import assertion, close, digits, made_here
from report.record import Record, claim, text
from trimmer import FrictionBacklash, asymptotic_roll_off, harmonic_leakage, real_axis_crossings
from trimmer.balance.limit_cycle import NEAR_TANGENCY


@claim("txt-6-every-case", source="trimmer/balance/solve.py", impact=Impact.LOCAL)
def every_case(known: Evidence) -> Record:
    system = known.numbers.displacement_only
    relay = sum(crossing.value < 0 for crossing in real_axis_crossings(system))
    with_play = min(2, *(len(found) for found in known.cycles.viscous))
    yield digits(
        "least number of limit cycles over the elements",
        "1",
        min(with_play, relay),
        second=by_grid(system, relay),
        slip=made_here("Coulomb friction is left out", with_play),
    )
    yield text("""
        Friction- and inertia-controlled backlash have two limit cycles each, viscous-controlled one or two,
        by its $M/D$. Coulomb friction alone, the fourth case of chapter 5, has none, as section 5.2.4 says
        itself. That two occur under strict conditions only is not so either: they do for every gap.

        Chapter 7 repeats it: all models showed a stable limit cycle.
    """)


HIGH_OMEGA = 1e8


@claim("txt-6.2-filter-order", source="trimmer/linear/low_pass.py", impact=Impact.DOWNSTREAM)
def filter_order(known: Evidence) -> Record:
    order = -asymptotic_roll_off(known.numbers.displacement_only) / 20
    slope = -math.log10(gain_ratio(known.numbers, HIGH_OMEGA, 10))
    second = close("the slope of the exact gain at $10^{8}$ rad/s", slope, order, 1e-6)
    yield digits("", "1", order, second=second)
    yield text("""
        The order is two, see section 5.1.2. So the transfer function is not on the edge of filtering because
        of its order; where the hypothesis fails, it fails because of the resonances.

        The caution that the chapter draws from order one has the wrong ground.
    """)


@claim("txt-6.2-higher-terms", source="trimmer/balance/leakage.py", impact=Impact.NOTATION)
def higher_terms(known: Evidence) -> Record:
    wave, values = relay_waveform(), {FORCE: sympy.Integer(1)}
    zero = [wave.cosine_coefficient(2), wave.cosine_coefficient(3), wave.sine_coefficient(2)]
    b_3 = wave.sine_coefficient(3)
    yield assertion(
        r"$a_n = 0$ and $b_2 = 0$ for $n = 2, 3, \dots$",
        "where these vanish, only the fundamental is left",
        any(sympy.simplify(each) != 0 for each in zero) or sympy.simplify(b_3) == 0,
        f"a relay's square wave has all of these zero and $b_3 = {sympy.latex(b_3)}$",
        method="Fourier coefficients of the relay's waveform",
        second=by_quadrature(b_3, coefficient(wave, sympy.sin(3 * THETA), values), values),
    )
    cycle, exact = known.cycles.friction.stable, known.orbits.friction.stable.amplitude
    element = FrictionBacklash(1.0)
    even, third = (abs(complex(element.describing_function(cycle.amplitude, harmonic=n))) for n in (2, 3))
    (leak,) = harmonic_leakage(known.numbers.displacement_only, element, cycle, (3,))
    error = abs(cycle.amplitude / exact - 1)
    yield assertion(
        "what accuracy asks for",
        "harmonic balance is accurate only if the element's higher terms vanish",
        third <= 0.01 or error >= 0.01,
        """
        at the stable limit cycle the third has [[ third | f1 ]] % of the input, the second [[ even | f0 ]] %;
        the amplitude is predicted to [[ error | f2 ]] %
        """,
        numbers={"third": 100 * third, "even": 100 * even, "error": 100 * error},
        method="harmonics of friction-controlled backlash, and the exact orbit",
        second=close("the exact orbit by two durations", known.orbits.friction_by_durations[0], exact, 1e-6),
    )
    yield text("""
        The index of the sine terms has slipped: $b_2 = 0$ is printed where $b_n = 0$ is meant. Nor do these
        coefficients, which are the element's own, vanish or need to: the linear part takes care of them, so
        that [[ leak | f2 ]] % of the fundamental come back as third harmonic, and that is what the error
        follows.

        None: the filtering hypothesis of equation 2.26 is stated rightly in section 2.3.2.
    """).given(leak=100 * leak)


@claim("txt-6.2-tangency", source="trimmer/balance/limit_cycle.py")
def tangency(known: Evidence) -> Record:
    cycles, system = known.cycles, known.numbers.displacement_only
    pairs = (cycles.friction, cycles.inertia, cycles.friction_both_channels)
    angles = [
        *(cycle.crossing_angle for pair in pairs for cycle in (pair.unstable, pair.stable)),
        *(cycle.crossing_angle for found in cycles.viscous for cycle in found),
    ]
    differences = "small differences of both curves at the stable one of friction-controlled backlash"
    stable = cycles.friction.stable
    by_differences = loci.angle(system, FrictionBacklash(1.0), stable)
    yield assertion(
        "",
        "the curves are nowhere nearly tangent where a limit cycle is predicted",
        min(angles) > NEAR_TANGENCY,
        """
        they cross at [[ smallest | f0 ]] degrees or more, over [[ count ]] limit cycles of backlash of every
        kind
        """,
        numbers={"smallest": math.degrees(min(angles)), "count": len(angles)},
        method="angle of $N$ and $-1/G$ at each solution of harmonic balance",
        second=close(differences, by_differences, stable.crossing_angle, 1e-5),
    )
    yield text(r"""
        No prediction for backlash is in doubt for this reason. Nor do the curves touch for the gap of
        $2\times10^{-8}$ m, as section 5.2.1 has it, since they are the same for every gap. What the
        predictions do depend on is the small distance of $G$ from $-1$ (section A.10).
    """)
