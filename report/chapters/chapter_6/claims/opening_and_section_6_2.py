"""Claims of chapter 6 before section 6.1, and of section 6.2: how many limit cycles, and filtering."""

import math

import sympy

from derivations.elements.friction import FORCE, relay_waveform
from derivations.elements.waveform import THETA
from report.chapters.second_ways import ALL_LOADS, by_matching_real_parts, by_quadrature
from report.judging.comparisons.assertion import Assertion
from report.judging.comparisons.printed import power_of
from report.judging.parts import assertion, close, digits, lost_in_the_copy
from report.judging.record import Record, claim, text
from report.judging.verdict import Certainty
from report.numbers.evidence import Evidence
from report.numbers.independent import loci
from report.numbers.independent.exact_response import gain_ratio
from report.numbers.independent.waveforms import coefficient
from trimmer import FrictionBacklash, harmonic_leakage, limit_cycles
from trimmer.balance.limit_cycle import NEAR_TANGENCY
from trimmer.linear import asymptotic_roll_off

EXACT = 1e-6  # Share below which an error counts as none
NARROW = 1e-9  # Gap for which all limit cycles are sought, m; far below every threshold of the thesis
HIGH_OMEGA = 1e8  # Angular frequency at which the slope of the gain is taken, rad/s


@claim("txt-6-every-case")
def every_case(known: Evidence) -> Record:
    system, cycles = known.numbers.displacement_only, known.cycles
    counts = [len(found) for found in cycles.viscous]
    yield assertion(
        "kinds of backlash",
        "each has one limit cycle or two",
        set(counts) <= {1, 2},
        f"{min(counts)} to {max(counts)} for {len(counts)} loads between the limits, two at either limit",
        method=ALL_LOADS,
        second=by_matching_real_parts(system, 0.0, 2),
    )
    narrow = limit_cycles(system, FrictionBacklash(NARROW))
    yield assertion(
        "the second one, with friction or inertia alone",
        "it is there only under strict conditions",
        len(narrow) < 2,
        f"""
        it is there for every gap, since $N$ depends on $b/A$ alone: friction-controlled backlash has it at
        {cycles.friction.unstable.amplitude:.4f} gaps, inertia-controlled at
        {cycles.inertia.unstable.amplitude:.4f}
        """,
        method=f"all solutions of harmonic balance, for a gap of {power_of(NARROW)} m",
        second=by_matching_real_parts(system, 0.0, len(narrow)),
        item="a single limit cycle for 4e-6 m, a second one for a larger gap",
        certainty=Certainty.READING,
    )
    yield text("""
        Every kind of backlash has one limit cycle or two, as the text says. Coulomb friction alone, also a
        case of chapter 5, has none, as section 5.2.4 says; the sentence is read as one on backlash. The text
        does not say which conditions it calls strict. If they are on the gap, as in section 5.2.1, there are
        none: with friction or with inertia alone both limit cycles are there for every gap. If they are on
        the load, the text is right: some ratios $M/D$ between the two limits have one limit cycle only.

        The unstable one is the threshold from which an oscillation grows, see [the second limit
        cycle](#txt-5.2.1-second-limit-cycle).
    """)


@claim("txt-6.2-filter-order")
def filter_order(known: Evidence) -> Record:
    order = -asymptotic_roll_off(known.numbers.displacement_only) / 20
    slope = -math.log10(gain_ratio(known.numbers, HIGH_OMEGA, 10))
    second = close("the slope of the exact gain at $10^{8}$ rad/s", slope, order, 1e-6)
    item = "order 1 and -20 dB per decade, roll-off of the transfer function"
    yield digits("", "1", order, second=second, item=item)
    yield text("""
        The order is two, as [at the roll-off](#txt-5.1.2-roll-off). So it is not the order that puts the
        transfer function on the edge of filtering; where the hypothesis fails, it fails because of the
        resonances.

        The caution that the chapter draws from order one has the wrong ground.
    """)


@claim("txt-6.2-higher-terms")
def higher_terms(known: Evidence) -> Record:
    wave, values = relay_waveform(), {FORCE: sympy.Integer(1)}
    zero = [wave.cosine_coefficient(2), wave.cosine_coefficient(3), wave.sine_coefficient(2)]
    b_3 = wave.sine_coefficient(3)
    vanish = all(sympy.simplify(each) == 0 for each in zero)
    statement, means = "where these vanish, only the fundamental is left", "Fourier coefficients of a relay"
    shown = f"a relay's square wave has $a_2$, $a_3$ and $b_2$ zero and $b_3 = {sympy.latex(b_3)}$"
    index_read = Assertion(statement, not vanish or sympy.simplify(b_3) != 0, shown, means)
    yield assertion(
        r"$a_n = 0$ and $b_2 = 0$ for $n = 2, 3, \dots$",
        statement,
        not vanish or sympy.simplify(b_3) == 0,
        shown,
        method=means,
        second=by_quadrature(b_3, coefficient(wave, sympy.sin(3 * THETA), values), values),
        copy_fault=lost_in_the_copy("the index of the sine terms, $b_n$, is read as $b_2$", index_read),
    )
    cycle, exact = known.cycles.friction.stable, known.orbits.friction.stable.amplitude
    (leak,) = harmonic_leakage(known.numbers.displacement_only, FrictionBacklash(1.0), cycle, (3,))
    error = abs(cycle.amplitude / exact - 1)
    yield assertion(
        "higher terms that come back",
        "even very small ones make a predicted limit cycle inaccurate",
        (leak > 0, error > EXACT),
        f"""
        at the stable limit cycle of friction-controlled backlash the third comes back with {100 * leak:.2f} %
        of the fundamental, and the predicted amplitude is off by {100 * error:.2f} %
        """,
        method="the element's third harmonic with the response of $G$, and the exact orbit",
        second=close("the exact orbit by two durations", known.orbits.friction_by_durations[0], exact, 1e-6),
    )
    yield text("""
        As read, only one sine term has to vanish, which a relay's output fulfils without being a sine. With
        $b_n$ in place of $b_2$ the sentence is right: the page shows whether the copy or the author has the
        wrong index. What has to vanish is what the linear part lets back, as section 2.3.2 says, not the
        output of the element itself.
    """)


@claim("txt-6.2-tangency")
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
        f"""
        they cross at {math.degrees(min(angles)):.0f} degrees or more, over {len(angles)} limit cycles of
        backlash of every kind
        """,
        method="angle of $N$ and $-1/G$ at each solution of harmonic balance",
        second=close(differences, by_differences, stable.crossing_angle, 1e-5),
    )
    yield text(r"""
        No prediction for backlash is in doubt for this reason. The curves are the same for every gap, so they
        do not touch for the gap of $2\times10^{-8}$ m either, as [section 5.2.1](#txt-5.2.1-touching) has it.
        The predictions do depend on the small distance of $G$ from $-1$, see [the two transfer functions of
        Listing A.9](#txt-A.10-two-systems).
    """)
