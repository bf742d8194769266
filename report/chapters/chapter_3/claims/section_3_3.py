"""Claims of section 3.3: friction in equation 3.2, the driven open loop, and the peak of the closed loop."""

from __future__ import annotations

import numpy as np
import sympy

from derivations.algebra.identity import prove_equal
from derivations.elements.coulomb_contact import friction_forces, power, relative_velocity
from derivations.elements.friction import FORCE
from derivations.symbols import masses, velocities
from report.chapters.chapter_2.claims.trimmer_printed import accelerations
from report.chapters.chapter_3.claims import driven_steady_motion as driven
from report.claim import Impact, Number
from report.comparisons.printed import over, product, total
from report.evidence import Evidence
from report.numbers.driven_motion import FORCES, transient_peaks
from report.numbers.released_motion import FORCES_OF_FIGURE, INSIDE, OUTSIDE, SCALE, released_peak
from report.parts import assertion, close, digits, expression, made_here, same, so, uncheckable
from report.record import Record, claim, text
from report.thesis import (
    EXPERIMENT_GAP,
    LARGER_GAP,
    LARGEST_GAP,
    MEASURED_DRIVE_FREQUENCY,
    OPEN_LOOP_PEAK,
    TABLE_2,
)

CONTACT, RELEASED = "derivations/elements/coulomb_contact.py", "report/numbers/released_motion.py"
PRINTED_RATE = velocities[1] - velocities[0]
PRINTED_FRICTION = product(FORCE, sympy.sign(total(velocities[1], -velocities[0])))
PRINTED_SIGNS = (-1, 1, 0, 0)
"""Sign of the friction in each line of equation 3.2."""
FIFTH = "549.999"
"""The other peak of figure 3.8, Hz."""
BIN_OF_FIGURE = 1.0
"""Widest bins of which both peaks are whole multiples together with their digits, Hz."""
PEAK, PREDICTED = "350", "488"
"""Peak of figure 3.9 for every gap, and the limit cycle predicted for the same trimmer in section 3.2, Hz."""
PEAK_DIGITS = "3.5e2"
"""The peak to the digits that "about 350" stands for."""
BIN = 10.0
"""Widest bin of the spectra of chapter 3, Hz."""
ALIKE = 1e-9
"""Relative difference of two motions that are alike but for their scale."""
UNMOVED = 0.005
"""Share by which a frequency may change and still be called unaffected."""
RISING = f"{driven.BY_LISTING}, gap 0.2 mm"
IN_TEXT = "read in the text: the two printed frequencies"


def derived_forces(known: Evidence) -> tuple[sympy.Expr, ...]:
    """Return friction between cutter and motor, whose relative velocity equation 3.2 has."""
    motor, cutter, *_ = known.derivation.mechanism.bodies
    return friction_forces(known.derivation.mechanism, cutter, motor)


@claim("eq-3.2", source=CONTACT, impact=Impact.LOCAL)
def equations_of_motion(known: Evidence) -> Record:
    derivation, forces = known.derivation, derived_forces(known)
    takes = same(
        "the power of the two forces, which is $-F_c$ times the relative speed",
        -FORCE * sympy.sign(PRINTED_RATE) * PRINTED_RATE,
        power(derivation.mechanism, forces),
    )
    slip = "friction acts along the relative motion instead of against it"
    for index, (printed, sign) in enumerate(zip(accelerations(), PRINTED_SIGNS, strict=True)):
        _, bracket = printed.args
        friction = {1: (PRINTED_FRICTION,), -1: (-PRINTED_FRICTION,), 0: ()}[sign]
        linear, force = derivation.accelerations[index], forces[index] / masses[index]
        by_newton = same("the forces on the body", derivation.newton[index], linear)
        yield expression(
            f"{('first', 'second', 'third', 'fourth')[index]} line",
            over(total(*bracket.args, *friction), masses[index]),
            linear + force,
            left=rf"\ddot q_{index + 1}",
            second=takes if force != 0 else by_newton,
            slip=made_here(slip, linear - force) if force != 0 else None,
        )
    run, opposite = known.motion.printed_friction.as_printed[0], known.motion.printed_friction.opposite
    yield text("""
        The linear terms are those of equation 2.9. The friction of the first two lines has the wrong sign: it
        pushes either body the way it already slides. Simulated as printed, beside a pin that does not reach
        the bridge, the trimmer's energy rises from [[ start | f0 ]] to [[ end | f0 ]] µJ in [[ time | f1 ]] s
        with [[ force ]] N; with the signs turned it falls below [[ turned | f2 ]] µJ.

        A model built as printed oscillates by itself, with an amplitude that grows with $F_c$. The text
        reports amplitudes that fall, so what was simulated had, it seems, the right sign.
    """).given(
        start=1e6 * run.energy[0],
        end=1e6 * run.energy[-1],
        time=run.times[-1],
        force=run.force,
        turned=1e6 * opposite.energy[-1],
    )


@claim("txt-3.3-friction-force", source=CONTACT, impact=Impact.DOWNSTREAM)
def force_of_friction(known: Evidence) -> Record:
    mechanism, simulated = known.derivation.mechanism, known.motion.printed_friction
    _, cutter, _, guard = mechanism.bodies
    as_one = "cutter and guard moving as one, which do not rub and for which the printed velocity is not zero"
    together = PRINTED_RATE.subs({velocities[0]: 0, velocities[1]: 1, velocities[3]: 1})
    relative = r"$\dot q_2 - \dot q_1$ is the velocity of the cutter relative to the motor"
    yield assertion(
        "which parts rub",
        "the relative velocity in the force is that of cutter and guard",
        prove_equal(PRINTED_RATE, relative_velocity(cutter, guard)).holds,
        rf"{relative}; relative to the guard it is $\dot q_2 - \dot q_4$",
        method="relative velocity of two bodies of the mechanism",
        second=so(as_one, together != 0),
    )
    printed = power(mechanism, tuple(sign * PRINTED_FRICTION for sign in PRINTED_SIGNS))
    first, *_, last = simulated.as_printed
    gain, loss = (run.energy[-1] - run.energy[0] for run in (first, simulated.opposite))
    energy = "the simulated energy, which rises with the printed signs and falls with the others"
    yield assertion(
        "which way it acts",
        "the forces of equation 3.2 resist the relative motion",
        prove_equal(printed, power(mechanism, derived_forces(known))).holds,
        r"their power is $+F_c|\dot q_2 - \dot q_1|$, that of friction $-F_c|\dot q_2 - \dot q_1|$",
        method="sum of force times velocity over the lines, against the dissipation function",
        second=so(energy, gain > 0 > loss),
    )
    yield text("""
        Equation 3.2 lets motor and cutter rub on each other; section 2.3.5 and the text of 3.3 speak of
        cutter and guard, whose forces belong into the second and fourth line. As printed the force feeds the
        motion: beside a pin that does not reach it the trimmer then oscillates at [[ first.frequency | f0 ]]
        Hz, a natural mode, whatever the gap, with [[ least | f0 ]] µm for [[ first.force ]] N and
        [[ most | f0 ]] µm for [[ last.force ]] N.

        This report simulates friction between cutter and guard, against their motion. Between motor and
        cutter it would act much alike, since the guard moves little.
    """).given(first=first, last=last, least=1e6 * first.amplitude, most=1e6 * last.amplitude)


@claim("txt-3.3-open-loop-odd", source=driven.SOURCE, impact=Impact.DOWNSTREAM)
def odd_harmonics(known: Evidence) -> Record:
    runs, odd = driven.runs_with(known, EXPERIMENT_GAP), driven.has_odd_harmonics_only(known)
    second = driven.confirm_odd(known)
    largest = [sorted(range(2, run.harmonics.size), key=lambda n: -run.harmonics[n])[:2] for run in runs]
    sizes = ((run.force, *(1e6 * run.harmonics[order] for order in (3, 5, 7))) for run in runs)
    rows = (f"{force} N: {third:.0f}, {fifth:.0f} and {more:.0f} µm" for force, third, fifth, more in sizes)
    yield assertion(
        "largest harmonics",
        "beside the fundamental the third and the fifth are the largest",
        all(set(pair) == {3, 5} for pair in largest),
        f"third, fifth and seventh with {'; '.join(rows)}",
        method=driven.BY_LISTING,
        second=driven.confirm_play(known, EXPERIMENT_GAP),
    )
    yield assertion(
        "no others",
        "the model shows no further frequencies",
        odd,
        """
        play, friction and linear part are odd, and all motions end with the same velocities; even harmonics
        are rounding in every run
        """,
        method=driven.METHOD,
        second=second,
    )
    measured = range(1, 1 + min(len(row) for row in TABLE_2.values()))
    even = [f"$f_{order}$" for order in measured if order % 2 == 0]
    table = f"table 3.2 has {' and '.join(even)}"
    yield assertion(
        "agreement with the experiment",
        "the experiment with play shows the harmonics of the model",
        not (even and odd),
        f"{table} in all of its {len(TABLE_2)} measurements, which the model cannot have for any parameters",
        method="orders of the tabulated harmonics against the theorem",
        second=second,
    )
    yield text("""
        The model has odd harmonics only, the fifth being raised by the natural mode at [[ mode | f1 ]] Hz.
        The experiment without play agrees with that. With play it shows the second and fourth harmonic as
        well, which takes something that is not symmetric: friction that differs by direction, a spring that
        is stiffer to one side, a pin that does not move as a sine. An uneven play would only shift the mean.

        The model lacks what makes the even harmonics, so the agreement cannot carry the conclusions on larger
        gaps.
    """).given(mode=known.numbers.modes[2].frequency)


@claim("txt-3.3-peak-366", source=driven.SOURCE, impact=Impact.DOWNSTREAM)
def peak_366(known: Evidence) -> Record:
    order = float(OPEN_LOOP_PEAK) / MEASURED_DRIVE_FREQUENCY
    nearest = "the two nearest harmonics, 329.835 and 439.780 Hz, both more than 36 bins away"
    away = min(abs(float(OPEN_LOOP_PEAK) - each) for each in (329.835, 439.78))
    yield assertion(
        "harmonic of the drive",
        "365.999 Hz is a multiple of the drive's frequency",
        abs(order - round(order)) * MEASURED_DRIVE_FREQUENCY < BIN_OF_FIGURE,
        f"it is {order:.3f} times 109.945 Hz",
        method="quotient of the two frequencies",
        asserted=False,
        second=so(nearest, away > 36 * BIN_OF_FIGURE),
    )
    yield assertion(
        "limit cycle",
        "it can be that of a limit cycle",
        not driven.has_the_drives_period(known),
        driven.period_in_words(known),
        method=driven.METHOD,
        second=driven.confirm_period(known),
    )
    missing = "the parameters of that trimmer (table C.1), which are confidential"
    yield uncheckable("which natural mode of the experiment's trimmer it is", "365.999 Hz", missing)
    *peaks, last = transient_peaks(known.motion.driven.run(LARGER_GAP, FORCES[0]))
    mode = known.numbers.modes[1]
    yield text("""
        A driven trimmer with friction has no limit cycle. What is left beside harmonics is the start: with
        Listing A.1 what dies out after it has its peaks at [[ peaks ]] and [[ last | f0 ]] Hz, near natural
        modes, of which the second is at [[ mode | f1 ]] Hz with a time constant of [[ constant | f0 ]] ms. A
        spectrum that begins with the start shows it.

        The evidence for a limit cycle in the open loop is gone. A spectrum of the settled motion, or of two
        records of different length, would have told a transient from an oscillation that lasts.
    """).given(
        peaks=driven.listed(peaks), last=last, mode=mode.frequency, constant=-1000 / mode.eigenvalue.real
    )


@claim("txt-3.3-peak-550", source=driven.SOURCE)
def peak_550(known: Evidence) -> Record:
    fifth = 5 * MEASURED_DRIVE_FREQUENCY
    five = f"five times 109.945 Hz is {fifth:.3f}"
    near = abs(float(FIFTH) - fifth) <= BIN_OF_FIGURE / 2
    yield assertion(
        "five times the drive",
        "549.999 Hz is the fifth harmonic of the drive",
        near and driven.has_odd_harmonics_only(known),
        f"{five} Hz, whose nearest bin of 1 Hz is 550 Hz; the model holds odd harmonics and nothing else",
        method=driven.METHOD,
        second=driven.confirm_odd(known),
    )
    yield text("""
        It is the fifth harmonic, magnified by the natural mode at [[ mode | f1 ]] Hz (Listing A.1). The text
        calls it a subharmonic, which is judged apart. 549.999 and 365.999 Hz read like bins of 1 Hz with one
        sample too many, as in the experiment's tables.
    """).given(mode=known.numbers.modes[2].frequency)


@claim("txt-3.3-subharmonic", source=driven.SOURCE, impact=Impact.NOTATION)
def subharmonic(_: Evidence) -> Record:
    yield assertion(
        "the peak at 549.999 Hz",
        "it is a subharmonic",
        float(FIFTH) < MEASURED_DRIVE_FREQUENCY,
        "a subharmonic has a fraction of the drive's frequency, and this has five times it",
        method="read in the text, against the two frequencies printed there",
    )
    yield text("""
        It is a harmonic, the fifth. Chapter 7 uses the same word.

        None: only the word is wrong.
    """)


@claim("txt-3.3-peak-350", source=RELEASED, impact=Impact.DOWNSTREAM)
def peak_350(known: Evidence) -> Record:
    mode, least = known.numbers.modes[1].frequency, FORCES_OF_FIGURE[0]
    inside, outside = (
        [known.motion.released.released(gap, least, start) for gap in (EXPERIMENT_GAP, LARGEST_GAP)]
        for start in (INSIDE, OUTSIDE)
    )
    small, large = peaks = [released_peak(run) for run in inside]
    for run, peak in zip(inside, peaks, strict=True):
        yield digits(
            f"released inside of its play, gap {1e3 * run.gap:g} mm, {run.force} N",
            PEAK_DIGITS,
            peak,
            "Hz",
            second=close("the second natural mode", mode, peak, 5e-3),
            printed_form=Number(PEAK, "Hz"),
        )
    inside_peaks = f"inside of the play the peaks are at {small:.1f} and {large:.1f} Hz"
    goes_on, scaled = (run.frequency for run in outside)
    outside_peaks = f"the limit cycle is at {goes_on:.1f} and {scaled:.1f} Hz"
    yield assertion(
        "why it should be a limit cycle",
        "a frequency that does not depend on the gap belongs to a limit cycle",
        abs(large - small) > BIN or any(run.goes_on for run in inside),
        f"{inside_peaks} for gaps of 0.2 and 20 mm, and the motion dies out; {outside_peaks}",
        method=f"{driven.BY_LISTING}, two starts for each gap",
        second=close("the second natural mode, which knows no gap", mode, small, 5e-3),
    )
    yield assertion(
        "prediction of section 3.2 for the same trimmer",
        "the peak is at the limit cycle's predicted frequency",
        abs(float(PREDICTED) - float(PEAK)) < BIN,
        f"{PREDICTED} Hz was predicted, whatever the gap",
        method=IN_TEXT,
    )
    distance = float(OPEN_LOOP_PEAK) - float(PEAK)
    higher = f"{OPEN_LOOP_PEAK} Hz lies {distance:.0f} Hz higher"
    yield assertion(
        "agreement with the open loop",
        "the peak of the open loop agrees with it",
        abs(distance) < BIN,
        f"{higher}, {distance:.0f} bins of the open loop's spectrum; rounded as 350 is it would read 370",
        method=IN_TEXT,
    )
    missing = "the parameters of that trimmer (table C.1), and from which state the loop was released"
    yield uncheckable(
        "which it is in the experiment's trimmer", "this peak belongs to a limit cycle", missing
    )
    yield text("""
        That a frequency does not depend on the gap says nothing: natural modes do not know the gap either.
        Released inside of its play the loop with Listing A.1 dies out, sooner with more friction, and has its
        peak at the second natural mode for either gap, which is how the figure is described; released outside
        it goes on at [[ lasting | f0 ]] Hz. The thesis's own prediction for its trimmer is [[ predicted ]]
        Hz.

        The peak reads as a natural mode that is dying out. Chapter 7 takes from this section that friction
        suppresses limit cycles.
    """).given(lasting=goes_on, predicted=PREDICTED)


@claim("txt-3.3-friction-suppresses", source=RELEASED)
def suppression(known: Evidence) -> Record:
    released, branches = known.motion.released, known.cycles.equivalent.in_place_both_channels
    lasting = [run for run in released.by_force if run.goes_on]
    weak, predicted = lasting[1], branches.stable
    balance = np.interp(weak.force / EXPERIMENT_GAP, predicted.force_per_gap, predicted.amplitude)
    yield assertion(
        "amplitude",
        "the amplitude of the limit cycle falls as friction rises",
        bool((np.diff([run.amplitude for run in lasting]) < 0).all()),
        ", ".join(f"{1e6 * run.amplitude:.0f} µm with {run.force:g} N" for run in lasting),
        method=RISING,
        second=close(f"harmonic balance at {weak.force} N", balance, weak.amplitude / EXPERIMENT_GAP, 0.02),
    )
    *_, before, last = released.by_force
    merger = EXPERIMENT_GAP * branches.merger.force_per_gap
    merge = f"harmonic balance, whose two solutions merge at {merger:.3f} N"
    yield assertion(
        "existence",
        "enough friction suppresses it",
        before.goes_on and not last.goes_on,
        f"with {before.force} N it lasts, with {last.force} N the motion comes to rest",
        method=RISING,
        second=so(merge, before.force < merger < last.force),
    )
    scale, rate = sympy.symbols("lambda", positive=True), sympy.Symbol("w", real=True)
    same_force = FORCE * scale * sympy.sign(scale * rate) == scale * FORCE * sympy.sign(rate)
    small, large = released.by_force[1].output, released.scaled.output
    distance = float(np.abs(large - SCALE * small).max() / np.abs(large).max())
    alike = f"exact simulation with a factor of {SCALE}, whose two motions agree to a billionth"
    yield assertion(
        "larger gap",
        "a larger gap needs more friction",
        bool(same_force),
        """
        displacements, gap and $F_c$ times the same factor give the same motion times that factor, so the
        force that ends it is proportional to the gap
        """,
        method="every equation is of first degree in displacements, gap and force",
        second=so(alike, distance < ALIKE),
    )
    least, *_, most = (released.released(LARGEST_GAP, force, OUTSIDE) for force in FORCES_OF_FIGURE)
    yield text("""
        With friction between cutter and guard that resists their motion, all of it holds, and the force
        needed is proportional to the gap. With Listing A.1 and 0.2 mm the limit cycle lasts up to [[ force ]]
        N, so the forces below 1 N that the text assumes weaken it and do not end it. For 20 mm the largest
        force of figure 3.9 takes [[ share | f1 ]] % of its [[ amplitude | f0 ]] mm, which no figure shows;
        what was suppressed there was, it seems, another peak.
    """).given(
        force=lasting[-1].force,
        share=100 * (1 - most.amplitude / least.amplitude),
        amplitude=1e3 * least.amplitude,
    )


@claim("txt-3.3-friction-frequency", source=RELEASED, impact=Impact.DOWNSTREAM)
def frequency_under_friction(known: Evidence) -> Record:
    yield assertion(
        "oscillations of the driven trimmer",
        "friction leaves their frequency",
        driven.has_the_drives_period(known),
        "they are harmonics of the drive, whatever the friction",
        method=driven.METHOD,
        second=driven.confirm_period(known),
    )
    lasting = [run for run in known.motion.released.by_force if run.goes_on]
    without, weak, *_, strong = lasting
    slower = without.frequency - strong.frequency
    predicted = known.cycles.equivalent.in_place_both_channels.stable
    balance = np.interp(weak.force / EXPERIMENT_GAP, predicted.force_per_gap, predicted.frequency)
    yield assertion(
        "self-sustained oscillation",
        "friction leaves its frequency",
        slower < UNMOVED * without.frequency,
        ", ".join(f"{run.frequency:.1f} Hz with {run.force:g} N" for run in lasting),
        method=RISING,
        second=close(f"harmonic balance at {weak.force} N", balance, weak.frequency, 1e-3),
    )
    yield text("""
        What is observed, peaks that friction lowers and does not move, is right and is what harmonics of the
        drive do. The reason given, that a self-sustained oscillation loses amplitude and not frequency, does
        not hold: backlash acts by the ratio of amplitude and gap, so a smaller oscillation is slower, by
        [[ slower | f0 ]] Hz at [[ force ]] N.

        A peak that stays in its place while friction changes speaks for a harmonic of the drive and against a
        limit cycle; the text takes it for the opposite.
    """).given(slower=slower, force=strong.force)
