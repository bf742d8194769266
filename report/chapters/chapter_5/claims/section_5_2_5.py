"""Claims of section 5.2.5 on backlash with friction: its function (5.14), limit cycle and peaks at 0.6 N."""

from __future__ import annotations

import math
from fractions import Fraction

import sympy

from derivations.elements.friction import FORCE as COULOMB
from derivations.symbols import A, omega
from report.chapters.chapter_2.claims.section_2_4 import printed_backlash_part
from report.chapters.chapter_5.claims.section_5_2_4 import FRICTION, RELAY, at_the_merger
from report.chapters.second_ways import NEWTON
from report.claim import Confirmation, Impact, Part, Severity
from report.evidence import Evidence
from report.numbers.equivalent_nonlinearity import FORCE, EquivalentNumbers, Point
from report.numbers.independent import limit_cycles
from report.numbers.listed_functions import equivalent_listing
from report.numbers.released_bodies import RECORD
from report.parts import assertion, close, digits, equal, expression, made_here, repeated, same, so
from report.record import Record, claim, text
from report.thesis import DRIVE_AMPLITUDE, DRIVE_OMEGA, RELEASED_PEAKS, SMALL_GAP
from trimmer import LimitCycle, response_at

OPERATOR, BODIES = "derivations/elements/friction.py", "report/numbers/released_bodies.py"
PRINTED = "737.514"
PRINTED_TERM = -sympy.I * 4 * COULOMB / (omega * A * sympy.pi)
LINE_18 = "line 18 of Listing A.6 is used for the friction term"
BY_LISTING = "all solutions of harmonic balance with the listing's function"
ONE_LIMIT_CYCLE = "one limit cycle with 0.6 N of friction and a gap of 4e-6 m"
DIFFERENCE = "0.5705 %, difference of 737.514 Hz to friction-controlled backlash"
"""Things that are printed in more than one place."""
DIED_OUT = 1e-9
"""Share of the start that may be left of a motion that has died out."""


def coulomb_part(over: sympy.Expr = sympy.S.One) -> Part:
    """Return the part on the friction term, which equation 5.14 divides by the amplitude once more."""
    by_velocity = sympy.simplify(sympy.I * omega * RELAY.subs(A, omega * A))
    means = r"$j\omega$ times the gain for an amplitude of velocity $\omega A$"
    name = r"the gain for a displacement is divided by $j\omega$"
    form = r"-j\frac{4F_c}{\omega A\pi}"
    return expression(
        "Coulomb term",
        PRINTED_TERM / over,
        FRICTION,
        second=same(means, by_velocity, FRICTION),
        slip=made_here(name + ", and by $A$" * (over != 1), RELAY / (sympy.I * omega) / over),
        printed_form=form if over == 1 else rf"\frac{{1}}{{A}}\left({form}\right)",
        item="-j 4F_c/(omega A pi), friction term of the equivalent nonlinearity",
        severity=Severity.CONCLUSION,
    )


@claim(
    "eq-5.14",
    source=OPERATOR,
    impact=Impact.DOWNSTREAM,
    lines=(1266, 1266),
    paragraph=3,
    severity=Severity.RESULT,
)
def equivalent(_: Evidence) -> Record:
    yield printed_backlash_part("backlash term")
    yield coulomb_part(over=A)
    yield text(r"""
        The backlash part lacks the factor $A/\pi$, [as in equation 2.59](#eq-2.59). The friction part has the
        wrong sign and divides by a frequency that drops out, [as derived above](#txt-5.2.5-coulomb-term);
        here it stands inside a bracket that is divided by $A$ once more.

        Figures 5.21 to 5.24 come from Listing A.6, which has the first part right and the second wrong.
    """)


@claim(
    "txt-5.2.5-coulomb-term",
    source=OPERATOR,
    impact=Impact.DOWNSTREAM,
    lines=(1259, 1261),
    paragraph=2,
    severity=Severity.CONCLUSION,
)
def coulomb_term(_: Evidence) -> Record:
    yield coulomb_part()
    yield text(r"""
        With $G_g = 1/s$ the factor $1/G_g$ is $j\omega$, not $1/(j\omega)$, and friction sees the amplitude
        $\omega A$ of the velocity. Together that is $j\omega \cdot 4F_c/(\pi\omega A) = j\,4F_c/(\pi A)$:
        positive, without frequency, in N/m. The printed term is in N s/m.

        With the printed sign friction feeds the oscillation that it damps. The factor $1/\omega$ makes it
        weak. No contour of section 5.2.5 with a force stands.
    """)


@claim(
    "txt-5.2.5-omega-limit",
    source=OPERATOR,
    impact=Impact.DOWNSTREAM,
    lines=(1280, 1284),
    paragraph=5,
    severity=Severity.RESULT,
)
def large_frequency(_: Evidence) -> Record:
    printed, right = (sympy.limit(term, omega, sympy.oo) for term in (PRINTED_TERM, FRICTION))
    yield expression(
        "limit of the Coulomb term",
        printed,
        right,
        second=same(r"the term does not contain $\omega$", FRICTION.diff(omega), sympy.Integer(0)),
        slip=repeated(r"the printed friction term is taken, which is divided by $\omega$", printed),
        printed_form=r"\lim_{\omega\to\infty}\left(\frac{4F_c}{\omega A\pi}\right) = 0",
    )
    yield text("""
        The limit is right for the printed term, which vanishes at high frequency because of its [wrong
        factor](#txt-5.2.5-coulomb-term). The right term does not depend on frequency: friction weighs the
        same at every speed, and less at larger amplitudes.

        Figure 5.21a, and what chapter 7 says about low and high frequency, describe the factor and not
        friction.
    """)


@claim("txt-5.2.5-zero-fc", source=OPERATOR, lines=(1297, 1297), paragraph=9)
def without_force(_: Evidence) -> Record:
    yield expression("Coulomb term for $F_c = 0$", sympy.Integer(0), FRICTION.subs(COULOMB, 0))
    yield text("""
        Without force the friction term is zero in either form, and friction-controlled backlash is left. The
        shorter path comes from the range of amplitudes that was drawn.
    """)


@claim(
    "txt-5.2.5-difference",
    source="report/chapters/chapter_5/claims/section_5_2_4.py",
    lines=(1301, 1305),
    paragraph=11,
)
def difference(_: Evidence) -> Record:
    percent = 100 * abs(737.514 - 733.33) / 733.33
    in_fractions = float(100 * (Fraction("737.514") / Fraction("733.33") - 1))
    second = close("exact fractions", in_fractions, percent)
    yield digits("arithmetic", "0.5705", percent, "%", second=second, item=DIFFERENCE)
    yield text("""
        The quotient of the two printed frequencies is right. The first of them comes from the [wrong friction
        term](#txt-5.2.5-coulomb-term).
    """)


def intersections_part(numbers: EquivalentNumbers) -> Part:
    """Return the part on the number of limit cycles, which the figure and the text share."""
    found, in_place = len(numbers.over_stiffness), numbers.in_place.limit_cycles(FORCE / SMALL_GAP)
    return digits(
        "limit cycles with 0.6 N of friction",
        "1",
        found,
        second=equal("friction between cutter and guard in its own place", in_place, found),
        slip=repeated(LINE_18, len(numbers.listing)),
        item=ONE_LIMIT_CYCLE,
    )


def frequency_part(numbers: EquivalentNumbers) -> Part:
    """Return the part on the frequency as the listings give it, which the figure and the text share."""
    (cycle,), (less_force,) = numbers.rounded, numbers.rounded_less_force
    _, by_newton = limit_cycles.equivalent_as_listed(cycle, FORCE, SMALL_GAP, DRIVE_OMEGA)
    slip = "0.15 N, the force of figure 5.21, is used instead of 0.6 N, and the last digit is cut off"
    return digits(
        "frequency by Listings A.6 and A.9",
        PRINTED,
        cycle.frequency,
        "Hz",
        second=close(NEWTON, by_newton, cycle.omega),
        slip=made_here(slip, math.floor(1000 * less_force.frequency) / 1000),
        item="737.514 Hz, limit cycle predicted with 0.6 N of friction",
        severity=Severity.SLIP,
    )


def by_listing_a6(solution: LimitCycle | Point, turning: float) -> complex:
    """Return N of Listing A.6 at a solution, with an angular frequency (rad/s) in its friction term."""
    return equivalent_listing(solution.amplitude, FORCE, SMALL_GAP, turning)


def loop_closes(known: Evidence, turning: float, element: complex) -> Confirmation:
    """Confirm a solution by the loop, with its angular frequency (rad/s) and the element's value there."""
    response = complex(response_at(known.numbers.displacement_only, turning))
    return close("$NG$ at that amplitude and frequency", element * response, -1)


@claim(
    "txt-5.2.5-prediction",
    source="report/numbers/equivalent_nonlinearity.py",
    impact=Impact.DOWNSTREAM,
    lines=(1299, 1299),
    paragraph=10,
    severity=Severity.CONCLUSION,
)
def prediction(known: Evidence) -> Record:
    numbers = known.cycles.equivalent
    (rounded,), (listing,) = numbers.rounded, numbers.listing
    yield intersections_part(numbers)
    yield frequency_part(numbers)
    yield text(r"""
        With the right friction term there is no limit cycle at [[ force ]] N: friction between cutter and
        guard ends it at [[ most | f4 ]] N for this gap. The printed one comes from line 18 of Listing A.6,
        whose [friction term](#txt-5.2.5-coulomb-term) feeds the oscillation. The listings give
        [[ rounded | f3 ]] Hz; the printed last digits come out with 0.15 N, the force of figure 5.21.
        Equation 5.14, which the text names as what is drawn, gives [[ as_printed | f0 ]] Hz.

        The comparison with 733.33 Hz, figures 5.23 and 5.24 and the peak of 736.993 Hz that is taken for this
        limit cycle lose their ground. Its amplitude of [[ amplitude | f1 ]] mm, which the text does not give,
        would have shown it.
    """).given(
        force=FORCE,
        most=numbers.force_of_merger,
        rounded=rounded.frequency,
        as_printed=numbers.as_printed.frequency,
        amplitude=1e3 * listing.amplitude,
    )


@claim(
    "txt-5.2.5-amplitude",
    source="report/numbers/friction_in_place.py",
    impact=Impact.DOWNSTREAM,
    lines=(1317, 1317),
    paragraph=12,
    severity=Severity.CONCLUSION,
)
def amplitude(known: Evidence) -> Record:
    numbers, friction = known.cycles.equivalent, known.cycles.friction.stable
    (listing,) = numbers.listing
    without = SMALL_GAP * friction.amplitude
    growth, shift = listing.amplitude / without, listing.frequency / friction.frequency - 1
    yield assertion(
        "by Listing A.6",
        "the amplitude changes much, the frequency little",
        growth > 10 and abs(shift) < 0.01,
        """
        from [[ without | f1 ]] µm without friction to [[ amplitude | f1 ]] mm at [[ force ]] N,
        [[ growth | f0 ]] times; the frequency rises by [[ shift | f2 ]] %
        """,
        numbers={
            "without": 1e6 * without,
            "amplitude": 1e3 * listing.amplitude,
            "force": FORCE,
            "growth": growth,
            "shift": 100 * shift,
        },
        method=BY_LISTING,
        second=loop_closes(known, listing.omega, by_listing_a6(listing, DRIVE_OMEGA)),
    )
    yield assertion(
        "with the right friction term",
        "a limit cycle with another amplitude is left at 0.6 N",
        numbers.in_place.limit_cycles(FORCE / SMALL_GAP) > 0,
        """
        the amplitude falls from [[ without | f1 ]] µm to [[ last | f1 ]] µm at [[ most | f4 ]] N; beyond that
        force there is no limit cycle
        """,
        numbers={
            "without": 1e6 * without,
            "last": 1e6 * SMALL_GAP * numbers.in_place.merger.amplitude,
            "most": numbers.force_of_merger,
        },
        method="all solutions of harmonic balance, friction between cutter and guard",
        second=at_the_merger(known),
        slip=repeated(LINE_18, len(numbers.listing) > 0),
        item=ONE_LIMIT_CYCLE,
    )
    yield text("""
        The text says that the amplitude has changed much, and gives none. Its own function makes it
        [[ times | f0 ]] times that of the pin, and larger still with more friction. The right term acts the
        other way: friction makes the oscillation smaller and then ends it.

        The section's model contradicts the conclusion of section 3.3 and chapter 7 that friction suppresses
        the limit cycle; the right one supports it.
    """).given(times=listing.amplitude / DRIVE_AMPLITUDE)


def peak_parts(known: Evidence, prefix: str = "") -> tuple[Part, ...]:
    """Return a part for each peak, and one on what the highest of them is."""
    numbers, branch = known.motion.closed.released_bodies, known.cycles.equivalent.in_place
    read = [RECORD.frequency(number) for number in numbers.runs[0].peaks]
    parts = []
    for number, printed, frequency, mode in zip((1, 2, 3), RELEASED_PEAKS, read, numbers.modes, strict=False):
        label = f"{prefix}peak {number} of {RECORD.duration:.0f} s, all bodies released alike"
        second = close(f"natural mode {number} of the loop without play and friction", mode, frequency, 2e-3)
        shown = f"{frequency:.3f}"
        slip = made_here("the last two digits are exchanged", float(shown[:-2] + shown[-1] + shown[-2]))
        item = f"{printed} Hz, peak of the spectrum with 0.6 N of friction"
        severity = Severity.SLIP
        parts.append(
            digits(label, printed, frequency, "Hz", second=second, slip=slip, item=item, severity=severity)
        )
    left = max(run.left / run.displacement for run in numbers.runs)
    reading = assertion(
        f"{prefix}what the peak at {RELEASED_PEAKS[2]} Hz is",
        f"with {FORCE} N of friction the loop has a limit cycle, which shows there",
        left > DIED_OUT,
        """
        the motion dies out: at the end of the record [[ left | power0 ]] of the start is left at most. A gap
        of 4 µm bears [[ most | f3 ]] N at most; the peak is the third natural mode of the loop,
        [[ mode | f2 ]] Hz
        """,
        numbers={"left": left, "most": known.cycles.equivalent.force_of_merger, "mode": numbers.modes[2]},
        method="exact simulation with true stick",
        second=so("harmonic balance over all forces", branch.limit_cycles(FORCE / SMALL_GAP) == 0),
        item="736.993 Hz, peak read as the limit cycle with 0.6 N of friction",
        severity=Severity.RESULT,
    )
    return (*parts, reading)


@claim(
    "txt-5.2.5-fft",
    source=BODIES,
    impact=Impact.DOWNSTREAM,
    lines=(1317, 1317),
    paragraph=12,
    severity=Severity.SLIP,
)
def peaks(known: Evidence) -> Record:
    numbers = known.motion.closed.released_bodies
    modes, (_, second, third) = numbers.modes, map(float, RELEASED_PEAKS)
    apart = abs(2 * second - third) / RECORD.bin_width
    yield from peak_parts(known)
    yield assertion(
        f"what the peak at {RELEASED_PEAKS[1]} Hz is",
        f"it is a harmonic of the one at {RELEASED_PEAKS[2]} Hz",
        apart < 1,
        """
        twice [[ peaks[1] ]] Hz is [[ apart | f0 ]] bins away from [[ peaks[2] ]] Hz; harmonics lie above, and
        odd elements make odd ones. It is the second natural mode, [[ mode | f2 ]] Hz
        """,
        numbers={"peaks": RELEASED_PEAKS, "apart": apart, "mode": modes[1]},
        method="the printed frequencies and bins",
        second=close("the natural modes of the loop", modes[1], second, 2e-3),
    )
    yield text("""
        All three are free vibrations of the closed loop without play and friction, at [[ modes[0] | f2 ]],
        [[ modes[1] | f2 ]] and [[ modes[2] | f2 ]] Hz, each in its line of a spectrum over one second; in the
        first number two digits are exchanged. The start is not given. With all four bodies displaced alike,
        by [[ least | g ]] to [[ most | g ]] m, which is our guess, these are the three largest peaks. A start
        so much larger than the gap leaves nothing of play or friction in them.

        That 736.993 Hz agrees with the predicted 737.514 Hz is no evidence for the equivalent nonlinearity:
        both are nearly the frequency at which $G$ passes by $-1$.
    """).given(modes=modes, least=numbers.runs[0].displacement, most=numbers.runs[-1].displacement)
