"""Claims of section 5.2.4 on Coulomb friction alone: predictions (5.12, 5.13), simulations, the unit."""

import math

import sympy

from derivations import assumed
from derivations.dimensions import FORCE as DIMENSION_OF_FORCE
from derivations.dimensions import LENGTH, NUMBER, dimension_of
from derivations.elements.friction import FORCE, friction_waveform, relay_waveform
from derivations.elements.waveform import describing_function
from derivations.symbols import DIMENSIONS, A, k2, m2, s
from report.chapters.second_ways import by_grid, by_harmonics, by_quadrature
from report.judging.claim import ClaimPart, Confirmation
from report.judging.comparisons.printed import power_of
from report.judging.parts import assertion, close, digits, expression, made_here, so
from report.judging.record import Record, claim, text
from report.judging.verdict import Certainty, Severity
from report.numbers.evidence import Evidence
from report.numbers.independent import limit_cycles, relay_and_friction
from report.numbers.independent.waveforms import quadrature_gain
from report.numbers.relay_loop import DURATION, HALF_PERIODS, STEP, PeriodicCandidates, RelayNumbers
from report.numbers.thesis import LARGE_GAP, RELAY_LEVEL, SMALL_GAP
from report.numbers.time_stepping import FINE_STEP
from trimmer.linear import real_axis_crossings

VALUES = {FORCE: sympy.Rational(3, 5), A: sympy.Rational(7, 4)}
RELAY = describing_function(relay_waveform(), A)
FRICTION = describing_function(friction_waveform(), A)
OSCILLATION = "an oscillation of high frequency with Coulomb friction"
"""Thing that the section and figure 5.19 state."""
BOUND = 1.0  # Friction that the thesis takes for realistic, N; its upper bound
AGREEMENT = 1e-12
"""Share of the largest displacement that rounding may part two motions by: a hundred times what it does."""
STEADY = 1.0  # Rate below which a frequency may be said to stay, 1/s
PLACES_WITHOUT_UNIT = "figures 5.18 to 5.20, 5.22 and 5.23"


@claim("eq-5.12")
def limit_of_response(known: Evidence) -> Record:
    above, below = relay_and_friction.fraction_of(known.numbers)
    form = r"\lim_{\omega\to+\infty} G(j\omega) \to (0, 0j)"
    derived = sympy.limit(above / below, s, sympy.oo)
    yield expression("", sympy.Integer(0), derived, left=r"\lim G", printed_form=form)
    yield text("""
        The transfer function has two poles more than zeros, so it tends to zero. The text lets it spiral into
        that point. It does not: its phase tends to -180 degrees, so it comes in along the negative real axis.
    """)


@claim("eq-5.13")
def inverse(_: Evidence) -> Record:
    printed, left = -A * sympy.pi / (4 * FORCE), r"-\frac{1}{N}"
    for_friction, gain = sympy.simplify(-1 / FRICTION), quadrature_gain(friction_waveform(), A, VALUES)
    form, item = (
        r"-\frac{1}{N(A)} = -\frac{A\pi}{4F_c}",
        "-A pi/(4 F_c), negative inverse of Coulomb friction",
    )
    label = "for a relay on the loop's signal"
    yield expression(label, printed, -1 / RELAY, left, printed_form=form, item=item)
    yield expression(
        "for friction, in a loop whose signal is a displacement",
        printed,
        for_friction,
        left,
        second=by_quadrature(for_friction, -1 / gain, VALUES),
        slip=made_here("the phase between velocity and displacement is dropped", -1 / RELAY),
        printed_form=form,
        item=item,
        certainty=Certainty.READING,
    )
    yield text(r"""
        Read as the negative inverse of equation 2.52, for a relay on the loop's signal, the equation is
        right. Read for friction it is not: friction acts on a velocity, as section 5.2.5 says itself, and the
        loop's signal is a displacement, for which $-1/N = j\,\pi A/(4F_c)$. Over a given range of amplitudes
        a larger $F_c$ shortens the curve, as the text says; as a whole it is the same half axis for every
        force.

        The picture of the section, and the high-frequency limit cycle expected from it, concern a relay that
        no part of the trimmer is.
    """)


@claim("txt-5.2.4-no-crossing")
def no_crossing(known: Evidence) -> Record:
    system = known.numbers.displacement_only
    crossings = real_axis_crossings(system)
    on_the_axis = relay_and_friction.on_the_imaginary_axis(known.numbers)
    highest = relay_and_friction.highest_phase(system)
    yield crossings_part(known)
    means = f"the phase on a grid, which rises to {math.degrees(highest):.1f} degrees"
    yield assertion(
        "what follows for friction",
        "harmonic balance predicts no limit cycle from Coulomb friction",
        max(on_the_axis) < 0,
        f"""
        with the right operator $G$ would have to cross the positive imaginary axis; where it is imaginary, at
        {len(on_the_axis)} frequencies, it lies on the negative one
        """,
        method="all roots of the real part, from exact coefficients",
        second=so(means, highest < math.pi / 2),
    )
    yield text(f"""
        $G$ meets the real axis at {len(crossings)} frequencies, always on its positive side. The conclusion
        stands, though for friction the axis to look at is another one. Friction between parts that rub only
        takes energy, so it cannot keep anything moving.
    """)


def crossings_part(known: Evidence) -> ClaimPart:
    """Return the part on crossings of the negative real axis, which figure 5.18 and the text share."""
    system = known.numbers.displacement_only
    negative = sum(crossing.value < 0 for crossing in real_axis_crossings(system))
    item = "G does not cross the negative real axis"
    label = "crossings of the negative real axis"
    return digits(label, "0", negative, second=by_grid(system, negative), item=item)


def at_the_merger(known: Evidence) -> Confirmation:
    """Confirm the solution with the largest force by solving the equations of motion at its frequency."""
    loop = limit_cycles.loop_at_merger(known.numbers, known.cycles.equivalent.in_place.merger)
    return close("both responses at the last solution, where the loop closes", loop, -1.0, 1e-6)


def relay_part(numbers: RelayNumbers, label: str) -> ClaimPart:
    """Return the part on the oscillation of the loop with an ideal relay."""
    growth = [run.growth for run in numbers.runs]
    means = "a third of the damping that G has at high frequency"
    return assertion(
        label,
        "an oscillation of high frequency remains",
        min(growth) < STEADY,
        rf"""
        the swings become smaller and faster without end: after impulses of
        {power_of(numbers.runs[0].impulse)} to {numbers.runs[-1].impulse:g} s per unit of the relay the
        frequency grows as $e^{{{growth[0]:.2f}\,t}}$ and the swings fall as $e^{{{-2 * growth[0]:.1f}\,t}}$
        """,
        method="exact simulation of the loop with an ideal relay",
        second=close(means, numbers.damping / 3, growth[0], 1e-3),
        item=OSCILLATION,
    )


def friction_part(numbers: RelayNumbers, label: str, item: str = OSCILLATION) -> ClaimPart:
    """Return the part on the loop with friction and viscous friction of the output's velocity."""
    last = max(run.last_turn for run in numbers.friction)
    means = f"Moreau's steps of {1e9 * FINE_STEP:.0f} ns, in which a velocity of zero needs no event"
    return assertion(
        label,
        "an oscillation remains",
        last > DURATION / 2,
        f"""
        it turns for the last time within {1e6 * last:.0f} µs, and then sticks or creeps one way for the rest
        of {1e3 * DURATION:.0f} ms
        """,
        method="exact simulation with true stick, impulses over six decades",
        second=close(means, max(numbers.last_turn_in_steps), last, 0.02),
        item=item,
    )


def candidates_part(
    candidates: PeriodicCandidates, label: str, statement: str, second: Confirmation, item: str = ""
) -> ClaimPart:
    """Return the part on periodic motions with all harmonics."""
    method = "Tsypkin's condition in closed form, which is exact for two switchings a period"
    derived = not all(candidates.in_phase)
    frequencies = " and ".join(f"{frequency:.1f}" for frequency in candidates.frequencies)
    return assertion(
        label,
        statement,
        derived,
        f"""
        from {0.5 / HALF_PERIODS[-1]:g} Hz to {power_of(0.5 / HALF_PERIODS[0])} Hz a square wave returns with
        zeros at its jumps at {frequencies} Hz only, and there in phase with itself, so the relay would work
        against it
        """,
        method=method,
        second=second,
        item=item,
    )


@claim("txt-5.2.4-high-frequency")
def high_frequency(known: Evidence) -> Record:
    numbers = known.motion.closed.relay
    frequency, amplitude = numbers.sampled
    yield relay_part(numbers, "ideal relay on the output, after an impulse")
    yield candidates_part(
        numbers.alone,
        "explanation by higher harmonics near the origin",
        "with harmonics there may be a periodic motion that the describing function misses",
        by_harmonics(known.numbers.displacement_only, numbers.alone.frequencies),
    )
    yield friction_part(numbers, "friction, which acts on velocity")
    yield text(f"""
        Near the origin $G$ is a double integrator with a little damping, on which a relay oscillates ever
        faster and smaller: the motion ends, and is no limit cycle. A simulation cannot follow that; one that
        looks at the sign every {1e6 * STEP:.0f} µs keeps up {frequency:.0f} Hz by its own delay, with
        {amplitude:.2f} times the relay's size. The text offers harmonics as a possible explanation. Tsypkin's
        condition, which holds them all, finds no periodic motion with two switchings.

        The small limit cycles for which the section neglects [friction](#txt-5.2.4-force-unit) do not exist.
    """)


@claim("txt-5.2.4-linear-in-fc")
def linear_in_force(known: Evidence) -> Record:
    factor, signal = assumed.positive("k"), assumed.real("y")
    scaled = FRICTION.subs({FORCE: factor * FORCE, A: factor * A}, simultaneous=True)
    difference = relay_and_friction.difference_of_scaled(known.numbers.parameters, RELAY_LEVEL)
    of_scaled, of_signal = (factor * FORCE * sympy.sign(each) for each in (factor * signal, signal))
    yield expression("$N(kA, kF_c) = N(A, F_c)$", scaled, FRICTION, left=sympy.Symbol("N"))
    yield assertion(
        "exact loop with a relay of 0.015 and of 0.15",
        "ten times the force, and the impulse, gives ten times the motion",
        difference < AGREEMENT,
        f"over 20 ms the motions differ by less than {power_of(AGREEMENT)} of the largest displacement",
        method="exact simulation of both",
        second=so("the relay's law, which is of first degree in signal and level", of_scaled == of_signal),
    )
    yield text("""
        The describing function depends on $F_c/A$ alone, so any solution scales with the force. So does the
        exact loop, in which the switching force is the only scale. Whatever is observed scales so, a trace of
        the solver too; it does not show that there is a limit cycle.
    """)


@claim("txt-5.2.4-force-unit")
def force_unit(known: Evidence) -> Record:
    displacement, acceleration = sympy.symbols("u a")
    units = {**DIMENSIONS, displacement: LENGTH, acceleration: DIMENSION_OF_FORCE / DIMENSIONS[m2]}
    beside, inertia = (dimension_of(term, units) for term in (k2 * displacement, m2 * acceleration))
    newtons = str(beside).replace("^-2", "⁻²")
    means = r"$m_2\ddot q_2$ in the same equation, which is a force"
    yield assertion(
        "unit",
        "$F_c$ is a number without unit, as behind 0.015, 1.5 and 0.6",
        beside == NUMBER,
        f"""
        in equation 3.2 it stands beside $k_2u$, in {newtons}; the thesis writes [-] at {PLACES_WITHOUT_UNIT},
        and [N] at the bound of 1.0
        """,
        method="dimension check of equation 3.2",
        second=so(means, inertia == DIMENSION_OF_FORCE),
    )
    per_gap = known.cycles.equivalent.in_place.merger.force_per_gap
    yield assertion(
        "what the section concludes, read as said of the limit cycles of backlash",
        "friction below 1.0 N may be neglected when limit cycles are predicted",
        per_gap * SMALL_GAP > BOUND,
        f"""
        between cutter and guard {per_gap * SMALL_GAP:.3f} N end the limit cycle for a gap of 4 µm,
        {per_gap * LARGE_GAP:.2f} N for 40 µm
        """,
        method="all solutions of harmonic balance, friction between cutter and guard",
        second=at_the_merger(known),
        severity=Severity.SLIP,
        certainty=Certainty.READING,
    )
    yield text(f"""
        A Coulomb force is in newtons, as section 3.3 and the bound of 1.0 N have it; the captions and
        sections 5.2.4 and 5.2.5 write [-]. In a loop with $G$ as its linear part it is neither: the relay's
        output enters as a displacement of the pin, so 0.015 is 15 mm of its travel, ten times the
        eccentricity. Read as said of limit cycles that friction makes by itself, the conclusion is right,
        since there are none. Read as said of those of backlash it is wrong: friction in newtons, between
        cutter and guard, ends the limit cycle of a small gap. The section is about friction alone, so the
        first reading is the likelier one, and the card is graded by it and by the unit that is printed.

        The force that ends a limit cycle is in proportion to the gap. The bound of 1.0 N ends it for gaps up
        to {1e6 * BOUND / per_gap:.0f} µm; for a larger gap a limit cycle is left. The small amplitude for
        which the section neglects friction was found with the relay of 0.015.
    """)
