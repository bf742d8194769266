"""Claims of chapter 4: section 4.2 on the blocks of backlash and the viscous load, and figures 4.1 to 4.3."""

import math

import numpy as np
import sympy

from derivations import assumed
from derivations.dimensions import FORCE, LENGTH, MASS, TIME, dimension_of
from derivations.elements import backlash
from derivations.elements.waveform import THETA
from derivations.symbols import DIMENSIONS, A, omega
from report.chapters.appendix_a.claims.listings_a_7_and_a_8_over_time import friction_parts
from report.judging.comparisons.digits import PrintedDigits
from report.judging.comparisons.printed import power_of
from report.judging.parts import (
    assertion,
    close,
    digits,
    expression,
    made_here,
    repeated,
    small,
    so,
    uncheckable,
)
from report.judging.record import Record, claim, text
from report.judging.verdict import Certainty, Severity
from report.numbers import listed_blocks as blocks
from report.numbers.evidence import Evidence
from report.numbers.independent import load_in_play
from report.numbers.thesis import (
    DRIVE_AMPLITUDE,
    DRIVE_FREQUENCY,
    DRIVE_OMEGA,
    LISTED_OFFSET,
    TIME_CONSTANT,
    TIMED_GAP,
    TURN,
)
from trimmer import FrictionBacklash, InertiaBacklash

b = assumed.positive("b")
MORE_SAMPLES = 3997  # Samples of a period where Listing A.7 is held against the waveform
ROUNDING = 1e-15
VANISHING = 1e-9 * DRIVE_AMPLITUDE  # Gap that stands for no gap, m
LOAD_MASS, LOAD_DAMPING = assumed.positive("M D")
PRINTED_GAMMA, PRINTED_ANGLE = "634.6652", "0.0016"
SAME_BLOCKS = "own and built-in block of friction-controlled backlash give the same output"
NO_GAP = "for b = 0 the output of the inertia-controlled block is its input"
ANGLE_ITEM = "0.0016, separation angle of section 4.2.3"


@claim("fig-4.1")
def two_blocks(_: Evidence) -> Record:
    distance = float(np.abs(blocks.own_block() - blocks.built_in_block()).max())
    own, settled = (
        blocks.own_block()[blocks.SAMPLES :],
        FrictionBacklash(TIMED_GAP).waveform(blocks.phases(), DRIVE_AMPLITUDE),
    )
    waveform = "the derived waveform in the second period"
    yield assertion(
        "built-in and own block, $b$ = 0.0004 m",
        "the two outputs are the same",
        distance <= ROUNDING,
        f"over two periods from rest they differ by {distance:.1g} m at most",
        method="Listing A.7 and python-control's backlash, sample by sample, on a sine of 1.5 mm",
        second=close(waveform, float(np.ptp(own)), float(np.ptp(settled[blocks.SAMPLES :])), 1e-5),
        item=SAME_BLOCKS,
    )
    yield text("""
        The blocks agree from the start on, not only when settled; Simulink's own block is taken to be what
        its description says, which python-control's is too. Why they agree for any input is shown at Listing
        A.7.
    """)


@claim("fig-4.2")
def block_with_inertia(_: Evidence) -> Record:
    distance = float(np.abs(blocks.listing_a8() - blocks.exact_inertia(TIMED_GAP)).max())
    share = 100 * distance / DRIVE_AMPLITUDE
    lacking = math.pi * DRIVE_AMPLITUDE + TIMED_GAP / 2 - float(LISTED_OFFSET)
    constant = r"what the constant of line 12 lacks of $\pi A + b/2$"
    yield assertion(
        "output of Listing A.8 for its own drive",
        "it behaves as figure 2.10",
        share < 1,  # which a line in the figure hides
        f"it is off the derived waveform by {1e6 * distance:.1f} µm at most, {share:.1f} % of the amplitude",
        method="the listing, repeated line by line, against the derived waveform",
        second=close(constant, lacking, distance, 1e-6),
    )
    yield text("""
        To the width of a line the figure is right. The deviation is the jump from the rounded constant in
        line 12 of Listing A.8. The block would show the same flight for any other input, because there its
        output is a function of time alone.
    """)


@claim("fig-4.3")
def gaps(_: Evidence) -> Record:
    phase, element = blocks.phases()[: blocks.SAMPLES], InertiaBacklash(VANISHING)
    output = element.waveform(phase, DRIVE_AMPLITUDE)
    distance = float(np.abs(output - DRIVE_AMPLITUDE * np.sin(phase)).max())
    vanishes = r"the flight lasts for $\phi$ with $b/A = \phi - \sin\phi$, so it vanishes with the gap"
    share = power_of(distance / DRIVE_AMPLITUDE)
    gain = complex(element.describing_function(DRIVE_AMPLITUDE))
    yield assertion(
        "$b$ = 0",
        "the output is the input",
        (distance <= VANISHING, backlash.inertia_contact_ratio().subs(backlash.CONTACT, 0) == 0),
        f"{vanishes}; at $b = 10^{{-9}}A$ output and input differ by {share} A",
        method="the derived waveform for a vanishing gap",
        second=close("its describing function, which is one", gain, 1.0, 1e-8),
        item=NO_GAP,
    )
    caption = "Inertia-controlled wave characteristics for a variety of backlash widths"
    missing = "the gaps that were drawn, and whether the constants of Listing A.8 were computed for each"
    yield uncheckable("the other curves", caption, missing)
    yield text(f"""
        What is said of $b = 0$ is right. The constants in lines 8 and 12 of Listing A.8 hold for a gap of
        {1e3 * TIMED_GAP} mm only. For other gaps the figure is right if they were replaced each time, as in
        the figure drawn here.
    """)


@claim("txt-4.2.1-block-equivalence")
def equivalent_blocks(_: Evidence) -> Record:
    yield from friction_parts("Listing A.7, ")
    output, library = blocks.own_block(MORE_SAMPLES), blocks.built_in_block(MORE_SAMPLES)
    waveform = FrictionBacklash(TIMED_GAP).waveform(
        blocks.phases(MORE_SAMPLES)[MORE_SAMPLES:], DRIVE_AMPLITUDE
    )
    distance = float(np.abs(output[MORE_SAMPLES:] - waveform).max())
    between_samples = DRIVE_AMPLITUDE * (1 - math.cos(math.pi / MORE_SAMPLES))
    off, samples = f"it is off by {1e9 * distance:.2f} nm at most", f"{MORE_SAMPLES} samples a period"
    missed = f"what {samples} may miss at the peak of the input, {1e9 * between_samples:.2f} nm"
    means = "python-control's backlash, run over the same two periods"
    yield assertion(
        "second period of a sine of 1.5 mm, $b$ = 0.4 mm",
        "the output is that of backlash without inertia",
        distance <= between_samples * (1 + 1e-6),
        f"{off}, no more than {missed}",
        method="the listing, run over two periods, against the derived waveform",
        second=small(means, library[MORE_SAMPLES] - output[MORE_SAMPLES], 1e-12),
        item=SAME_BLOCKS,
    )
    yield text("""
        The built-in block keeps its output while the input moves inside of the dead band, and outside of it
        follows at half of the band; that block was not at hand, python-control's was. Listing A.7 does the
        same for any input, so the two agree from equal starts, not on a sine alone. The text says that the
        code is that of [equation 2.36](#eq-2.36); the code has the right waveform, two of the equation's
        signs are wrong.
    """)


@claim("txt-4.2.2-zero-gap")
def zero_gap(_: Evidence) -> Record:
    flight, contact = backlash.inertia_contact_ratio(), backlash.inertia_waveform(b).segments[1].value
    slope = sympy.diff(flight, backlash.CONTACT) - 2 * sympy.sin(backlash.CONTACT / 2) ** 2
    root = "the root of the contact equation for a gap of $10^{-9}A$, a flight below 0.002 rad"
    zero = r"$b/A = \phi - \sin\phi$ is zero for $\phi = 0$"
    yield assertion(
        "flight",
        "without a gap there is no flight",
        (flight.subs(backlash.CONTACT, 0), sympy.simplify(slope)) == (0, 0),
        rf"{zero} and rises from there on, since its slope is $2\sin^2(\phi/2)$",
        method="the derived contact equation and its slope",
        second=so(root, load_in_play.contact_angle_by_bisection(1e-9) < 0.002),
        item=NO_GAP,
    )
    at_two = InertiaBacklash(1e-6 * DRIVE_AMPLITUDE).waveform(np.array([2.0]), DRIVE_AMPLITUDE, DRIVE_OMEGA)
    hardly = "the element's waveform for a gap of a millionth of the amplitude"
    second = close(hardly, float(at_two[0]) / DRIVE_AMPLITUDE, math.sin(2.0), 1e-5)
    yield expression(
        "contact, which is left",
        A * sympy.sin(THETA),
        contact.subs(b, 0),
        sympy.Symbol("y"),
        second=second,
        item=NO_GAP,
    )
    phase = np.linspace(0, TURN, 400, endpoint=False)
    pin = DRIVE_AMPLITUDE * np.sin(phase)
    left = 1e3 * float(np.abs(blocks.inertia_block(pin, phase / DRIVE_OMEGA, 0.0) - pin).max())
    yield text(f"""
        Between walls a gap apart the load is never farther than $b/2$ from the pin, so without a gap the
        output is the input. Listing A.8 gives it only if the constants of lines 8 and 12 are computed again
        for each gap: with line 2 alone set to zero its output is off by {left:.2f} mm.
    """)


@claim("txt-4.2.3-roles")
def roles(_: Evidence) -> Record:
    free = load_in_play.free_speed(LOAD_MASS, LOAD_DAMPING)
    lighter, usual, heavier = (
        load_in_play.speed_left(each * TIME_CONSTANT, TIME_CONSTANT) for each in (0.5, 1, 2)
    )
    means = "numeric integration, by which twice the $M$ leaves more speed and twice the $D$ less"
    yield assertion(
        "$D$ as the amount of inertia, $M$ as the amount of friction",
        "the load keeps its speed longer with a larger $D$ or a smaller $M$",
        (free.diff(LOAD_DAMPING).is_positive is True, free.diff(LOAD_MASS).is_negative is True),
        f"a load in free flight has $v/v_0 = {sympy.latex(free)}$",
        method=r"sign of the derivatives of the solution of $M\dot v + Dv = 0$",
        second=so(means, 0 < lighter < usual < heavier < 1),
    )
    ratio = r"\frac{v}{v_0}"
    flies_on = "$D = 0$ is inertia-controlled: the load flies on with the speed it has"
    yield expression(flies_on, sympy.Integer(1), free.subs(LOAD_DAMPING, 0), ratio)
    stops = "$M = 0$ is friction-controlled: the load stops at once"
    yield expression(stops, sympy.Integer(0), sympy.limit(free, LOAD_MASS, 0, "+"), ratio)
    yield text("""
        $M$ is the inertia and $D$ the friction; the sentence has them exchanged. The next one, on what is
        left for $D = 0$ and for $M = 0$, is right and contradicts it.

        None in the thesis, which uses both letters rightly elsewhere. By this sentence a measured ratio $M/D$
        would be taken for its inverse.
    """)


@claim("txt-4.2.3-gamma")
def gamma(_: Evidence) -> Record:
    right = TIME_CONSTANT * DRIVE_OMEGA
    decay = "the decay of a free load over a radian of the drive, integrated numerically"
    by_decay = -1 / math.log(load_in_play.speed_left(TIME_CONSTANT, 1 / DRIVE_OMEGA))
    slip = made_here("1/0.99 is put in for 1/99", DRIVE_OMEGA / 0.99)
    second = close(decay, by_decay, right)
    yield digits("value", PRINTED_GAMMA, right, second=second, slip=slip)
    units = DIMENSIONS | {LOAD_MASS: MASS, LOAD_DAMPING: FORCE * TIME / LENGTH}
    unit = dimension_of(LOAD_MASS / LOAD_DAMPING * omega, units)
    milliseconds = "its value in milliseconds, which is that in seconds"
    yield assertion(
        "unit",
        r"$\gamma$ is a frequency, in hertz",
        unit == TIME**-1,
        rf"$M/D$ is a time and $\omega$ its inverse: the unit is {unit}",
        method="dimension check of equation 2.45",
        second=close(milliseconds, (1000 * TIME_CONSTANT) * (DRIVE_OMEGA / 1000), right),
        certainty=Certainty.PROVEN,
    )
    yield text(rf"""
        With the printed ratio $\gamma = 200\pi/99 = {right:.4f}$, a pure number. The printed value is a
        hundred times as large and comes out with $M/D = 1/0.99$, so the ratio, which is arbitrary, may be the
        one that is mistyped. It is printed twice, so a decimal point lost in the copy would have to be lost
        twice.

        None beyond this section: the separation angle that follows belongs to 1/0.99, a load nearly without
        friction; with 1/99 it is a hundred times larger.
    """)


@claim("txt-4.2.3-separation-angle")
def angle_of_separation(_: Evidence) -> Record:
    gammas = (float(PRINTED_GAMMA), TIME_CONSTANT * DRIVE_OMEGA)
    printed, right = (float(backlash.separation_angle().subs(backlash.GAMMA, each)) for each in gammas)
    of_printed, of_right = (float(np.angle(each + 1j)) for each in gammas)
    means = r"the angle of $\gamma + j$"
    second = close(means, of_printed, printed)
    label = f"arithmetic, from {PRINTED_GAMMA}"
    yield digits(label, PRINTED_ANGLE, printed, "rad", second=second, item=ANGLE_ITEM)
    second, slip = close(means, of_right, right), repeated("the value printed for gamma is used", printed)
    yield digits(
        "for $M/D = 1/99$ at 100 Hz",
        PRINTED_ANGLE,
        right,
        "rad",
        second=second,
        slip=slip,
        item=ANGLE_ITEM,
        severity=Severity.SLIP,
    )
    as_time = printed / DRIVE_OMEGA
    share = math.degrees(printed) / 360 / DRIVE_FREQUENCY
    yield assertion(
        "unit",
        "0.0016 is a time, in seconds",
        PrintedDigits(PRINTED_ANGLE, as_time).compare().agrees,
        f"the arctangent is an angle in radians; at 100 Hz that angle takes {1e6 * as_time:.2f} µs",
        method="angle over angular frequency",
        second=close("the share of a turn, of the period of 10 ms", share, as_time),
        severity=Severity.SLIP,
        certainty=Certainty.PROVEN,
    )
    yield text(rf"""
        The arctangent is right for the printed $\gamma$. For the stated ratio it is {right:.4f} rad, or
        {math.degrees(right):.2f} degrees, and it is an angle, not a time.

        None on later numbers: the section computes no waveform from it.
    """)
