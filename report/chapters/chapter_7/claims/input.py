"""Claims of chapter 7 on the input: its amplitude, its frequency, and what shows of it in the output."""

from __future__ import annotations

import numpy as np
import sympy

from derivations.elements import backlash
from derivations.elements.friction import FORCE
from derivations.elements.waveform import describing_function
from derivations.symbols import A, omega
from report.chapters.appendix_a.claims.listings_a_2_to_a_6_describing_functions import friction_expression
from report.chapters.chapter_3.claims.section_3_3_open_loop import SUBHARMONICS
from report.chapters.chapter_5.claims.figures_5_21_to_5_24_equivalent import LISTING
from report.chapters.chapter_5.claims.section_5_2_1_driven import (
    REPEATS,
    line_part,
    open_loop,
    open_loop_harmonic,
    open_loop_repeats,
)
from report.chapters.second_ways import ALL_LOADS
from report.claim import Certainty, Impact, Part, Severity
from report.evidence import Evidence
from report.numbers.drive_amplitudes import SAMPLES
from report.numbers.listed_functions import (
    IN_GAPS,
    equivalent_contour,
    inertia_contour,
    inertia_listing,
    mean_distance,
)
from report.numbers.record import change, line_amplitudes
from report.parts import assertion, close, expression, small, so
from report.record import Record, claim, text
from report.thesis import (
    DRIVE_AMPLITUDE,
    DRIVE_FREQUENCY,
    DRIVE_OMEGA,
    LARGE_GAP,
    MEASURED_DRIVE_FREQUENCY,
    MEASURED_DRIVE_OMEGA,
    TURN,
)
from trimmer import FrictionBacklash, ViscousBacklash

DRIVE_AMPLITUDES = (0.0005, DRIVE_AMPLITUDE, 0.003)
FIFTH = 5
RELAY_FORCE, GAP = 0.15, 2e-3
"""Of figure 5.21, N and m."""
FAST, SLOW = TURN * 1e5, TURN * 10.0
"""Angular frequencies far above that of the drive and below it, rad/s."""
SIMULATED = "exact simulation with 1.5 mm and 100 Hz"
BY_RESPONSE = "fifth harmonic of the derived element times the response of $G$"


@claim(
    "txt-7-input-amplitude",
    source="trimmer/elements/friction_backlash.py",
    impact=Impact.LOCAL,
    lines=(1393, 1394),
    paragraph=9,
)
def input_amplitude(known: Evidence) -> Record:
    decay = max(mode.eigenvalue.real for mode in known.numbers.modes)
    fifth = [open_loop_harmonic(known, FIFTH, amplitude) for amplitude in DRIVE_AMPLITUDES]
    yield assertion(
        "what oscillates in open loop",
        "besides the drive and its harmonics a limit cycle goes on",
        decay >= 0,
        r"""
        the backlash repeats with the drive's period, and behind it every free motion of the linear part
        decays as $e^{[[ decay | f1 ]]\,t}$ or faster
        """,
        numbers={"decay": decay},
        method="periodic input of a stable linear system",
        second=open_loop_repeats(known),
        item="the open loop shows the limit cycle of the closed loop",
        severity=Severity.CONCLUSION,
    )
    below = FrictionBacklash(LARGE_GAP).describing_function(0.49 * LARGE_GAP)
    yield assertion(
        "what it depends on",
        "the amplitude of the input has no effect on the oscillation that is left",
        max(fifth) / min(fifth) < 1.001 and not np.isnan(below),
        """
        for a gap of [[ gap | f0 ]] µm the fifth harmonic of the output is [[ outputs ]] for inputs of
        [[ inputs ]]; below half of the gap there is no output at all
        """,
        numbers={
            "gap": 1e6 * LARGE_GAP,
            "outputs": ", ".join(f"{1e6 * each:.2f} µm" for each in fifth),
            "inputs": ", ".join(f"{1e3 * each:.1f} mm" for each in DRIVE_AMPLITUDES),
        },
        method=BY_RESPONSE,
        second=close(SIMULATED, open_loop(known).harmonics[FIFTH], fifth[1], 1e-4),
        item="the drive's amplitude does not alter the limit cycle",
        severity=Severity.RESULT,
    )
    yield text("""
        In open loop nothing is fed back, so there is no limit cycle that could keep its amplitude: what is
        seen are harmonics of the drive. An input much larger than the gap leaves nearly a square wave of half
        the gap behind the play, whatever its amplitude. From [[ middle ]] to [[ largest ]] mm the fifth
        harmonic grows by [[ growth | f1 ]] %, which is easily taken for nothing.

        The answer holds as an approximation for wide strokes, and not for a limit cycle. On a limit cycle
        under a drive in closed loop see [the drive's amplitude](#txt-5.2.1-drive-amplitude).
    """).given(
        middle=f"{1e3 * DRIVE_AMPLITUDES[1]:g}",
        largest=f"{1e3 * DRIVE_AMPLITUDES[2]:g}",
        growth=100 * (fifth[2] / fifth[1] - 1),
    )


@claim(
    "txt-7-input-frequency",
    source="derivations/elements/backlash.py",
    impact=Impact.LOCAL,
    lines=(1395, 1396),
    paragraph=9,
)
def input_frequency(known: Evidence) -> Record:
    friction = describing_function(backlash.friction_waveform(), A)
    inertia = describing_function(backlash.inertia_waveform(), A).subs(
        backlash.GAP, A * backlash.inertia_contact_ratio()
    )
    limits, slow_and_fast = (ViscousBacklash(1.0, each) for each in (1e-9, 1e3)), np.array([1e2, 1e4])
    changes = [abs(complex(np.diff(each.describing_function(2.0, slow_and_fast))[0])) for each in limits]
    general = "the general element with $M/D$ of 1 ns and of 1000 s, at 100 and at 10 000 rad/s"
    yield assertion(
        "describing functions",
        "those of friction- and inertia-controlled backlash do not depend on frequency",
        not {omega, backlash.GAMMA} & (friction.free_symbols | inertia.free_symbols),
        "with $A$, the gap and the contact angle they are complete",
        method="symbols of the derived functions",
        second=so(general, max(changes) < 1e-4),
        certainty=Certainty.PROVEN,
    )
    fifth, measured = (
        open_loop_harmonic(known, FIFTH, omega=each) for each in (DRIVE_OMEGA, MEASURED_DRIVE_OMEGA)
    )
    yield assertion(
        "what follows for the output, read as that of the driven trimmer",
        "for friction-controlled backlash the input frequency changes nothing",
        abs(measured / fifth - 1) < 0.1,
        """
        with Listing A.1 and a gap of [[ gap | f0 ]] µm the fifth harmonic is [[ fifth | f0 ]] µm for a drive
        of [[ drive | f0 ]] Hz and [[ measured | f0 ]] µm for the [[ measured_drive ]] Hz of the experiment,
        whose trimmer is another one
        """,
        numbers={
            "gap": 1e6 * LARGE_GAP,
            "fifth": 1e6 * fifth,
            "drive": DRIVE_FREQUENCY,
            "measured": 1e6 * measured,
            "measured_drive": MEASURED_DRIVE_FREQUENCY,
        },
        method=BY_RESPONSE,
        second=close(SIMULATED, open_loop(known).harmonics[FIFTH], fifth, 1e-4),
        severity=Severity.RESULT,
        certainty=Certainty.READING,
    )
    cycles, orbits = known.cycles, known.orbits
    without_inertia, without_friction = cycles.friction.stable.frequency, cycles.inertia.stable.frequency
    ratio = without_friction / without_inertia
    by_orbits = "the ratio of the exact orbits' frequencies"
    exact_ratio = orbits.inertia.stable.frequency / orbits.friction.stable.frequency
    yield assertion(
        "condition of harmonic balance, read as a whole",
        "the frequency follows from the transfer function alone",
        abs(ratio - 1) < 1e-6,
        """
        with the same $G$ it is [[ friction | f2 ]] Hz for friction- and [[ inertia | f2 ]] Hz for
        inertia-controlled backlash
        """,
        numbers={"friction": without_inertia, "inertia": without_friction},
        method="all solutions of harmonic balance for both elements",
        second=close(by_orbits, exact_ratio, ratio, 0.005),
        severity=Severity.SLIP,
        certainty=Certainty.READING,
    )
    added = LISTING - friction_expression()
    far_up = abs(complex(added.subs({FORCE: 1, A: 1, omega: 10**12})))
    yield expression(
        "what Listing A.6 adds to backlash, with rising frequency",
        sympy.Integer(0),
        sympy.limit(added, omega, sympy.oo),
        r"\lim (N - N_r)",
        second=small("its size at $10^{12}$ rad/s, raised by one", far_up),
    )
    yield contours_with_falling_frequency()
    stable = [cycle for found in cycles.viscous for cycle in found if cycle.stable]
    lowest, highest = (limit(cycle.frequency for cycle in stable) for limit in (min, max))
    yield assertion(
        "range of frequencies",
        "stable limit cycles have nearly one frequency whatever $M/D$ is",
        highest / lowest < 1.03,
        f"from {lowest:.1f} to {highest:.1f} Hz",
        method=ALL_LOADS,
        second=close(by_orbits, exact_ratio, highest / lowest, 0.005),
    )
    yield text("""
        Two of the functions do not depend on frequency, as the text says. If performance means the predicted
        limit cycle, the drive's frequency does not enter indeed; if it means the vibration, it decides which
        harmonics meet a resonance. Read as a rule for reading off a found intersection, amplitude from $N$
        and frequency from $G$, the condition is right too; where the curves intersect depends on both. The
        contour of Listing A.6 passes by that of inertia because of its [wrong factor](#lst-A.6), and the
        range of frequencies is narrow as stated, though the amplitude falls by [[ fall | f0 ]] % over it.

        With the drive of the experiment the fifth harmonic meets a resonance of Listing A.1, which matters
        more for the vibration than anything in this answer.
    """).given(fall=100 * (1 - cycles.inertia.stable.amplitude / max(cycle.amplitude for cycle in stable)))


def contours_with_falling_frequency() -> Part:
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
        """
        with [[ force ]] N and [[ gap | f0 ]] mm, as in figure 5.21, the contour of Listing A.6 lies
        [[ high | f2 ]] from it on average at high frequency, [[ drive | f2 ]] at [[ drive_frequency | f0 ]]
        Hz and [[ low | f2 ]] at [[ low_frequency | f0 ]] Hz; below that it passes by, towards zero
        """,
        numbers={
            "force": RELAY_FORCE,
            "gap": 1e3 * GAP,
            "high": high,
            "drive": drive,
            "drive_frequency": DRIVE_FREQUENCY,
            "low": low,
            "low_frequency": SLOW / TURN,
        },
        method="distances of both contours, point by point",
        second=close(
            "Listing A.4 and the formula of Listing A.6", mean_distance(-1 / gains, by_listing), low
        ),
    )


@claim(
    "txt-7-subharmonics",
    source="report/numbers/drive_amplitudes.py",
    impact=Impact.LOCAL,
    lines=(1397, 1400),
    paragraph=9,
    severity=Severity.CONCLUSION,
)
def subharmonics(known: Evidence) -> Record:
    run, orbit = open_loop(known), known.orbits.friction.stable
    first, second = run.output[:SAMPLES], run.output[SAMPLES:]
    between_periods = change(first, second)
    fifth = open_loop_harmonic(known, FIFTH)
    by_response = "the fifth harmonic by describing function and frequency response"
    yield assertion(
        "open loop: what the peaks are",
        "they are subharmonics of the drive",
        between_periods > REPEATS,
        """
        two periods differ by [[ change | power0 ]] of the output, and at half of the [[ drive | f0 ]] Hz
        there are [[ half | power0 ]] of the first harmonic; the lines are at three, five and seven times the
        drive
        """,
        numbers={
            "change": between_periods,
            "drive": DRIVE_FREQUENCY,
            "half": float(line_amplitudes(run.output)[1]) / run.harmonics[1],
        },
        method="exact simulation; two periods of the settled open loop",
        second=close(by_response, fifth, run.harmonics[FIFTH], 1e-4),
        item=SUBHARMONICS,
        severity=Severity.SLIP,
    )
    yield line_part(known, "a limit cycle on top of the drive's oscillation, in open loop")
    largest = 100 * abs(orbit.harmonics[2] / orbit.harmonics[0])
    elsewhere = "a motion that starts elsewhere, 0.1 % outside of the unstable orbit, and ends on it"
    yield assertion(
        "closed loop without input",
        "the limit cycle is the only oscillation that stays",
        orbit.stable,
        f"every disturbance of it decays; its own harmonics stay with it, the largest with {largest:.2f} %",
        method="Floquet multipliers of the exact orbit",
        second=close(elsewhere, known.orbits.left_by[1], orbit.amplitude, 1e-5),
    )
    yield text("""
        The peaks that are meant lie at multiples of the drive: they are harmonics, not subharmonics. A
        subharmonic, at a fraction of the drive's frequency, needs a motion with several times its period,
        which a stable linear system behind play does not have. A limit cycle on top of the driven oscillation
        shows where the output is fed back to the pin, not in open loop.

        In a spectrum of this open loop no peak can be that of a limit cycle: what is no harmonic is a free
        vibration that has not died out.
    """)
