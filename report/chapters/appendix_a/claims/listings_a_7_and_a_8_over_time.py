"""Claims of appendices A.8 and A.9 on the blocks of backlash over time (Listings A.7 and A.8)."""

import math
import re

import numpy as np
import sympy

from derivations import assumed
from derivations.elements.backlash import GAP, inertia_waveform
from derivations.elements.waveform import THETA
from derivations.symbols import A
from report.chapters.second_ways import REPEATED
from report.judging.claim import ClaimPart
from report.judging.comparisons.assertion import Assertion
from report.judging.comparisons.printed import product, total
from report.judging.parts import More, assertion, close, digits, expression, made_here, part, so
from report.judging.record import Record, claim, text
from report.judging.verdict import Certainty, Severity
from report.numbers.evidence import Evidence
from report.numbers.independent.load_in_play import contact_angle_by_bisection
from report.numbers.listed_blocks import (
    PERIOD,
    PERIODS,
    contact_time,
    friction_by_python_control,
    inertia_block,
    inertia_block_on_a_sine,
    inertia_difference,
)
from report.numbers.thesis import (
    DRIVE_AMPLITUDE,
    DRIVE_FREQUENCY,
    DRIVE_OMEGA,
    LISTED_CONTACT,
    LISTED_OFFSET,
    MEASURED_DRIVE_FREQUENCY,
    TIMED_GAP,
    TURN,
)
from report.octave.formulas import LOAD, PIN, friction_step
from trimmer import InertiaBacklash

FRICTION_LINES = (
    *("function u = fcn(e, D_size, u_prev)", "if e - u_prev > D_size/2", "u = e - D_size/2;", "else"),
    *("if e - u_prev < -D_size/2", "u = e + D_size/2;", "else", "u = u_prev;"),
    *("end", "end", "end", "end"),
)
"""Listing A.7, line by line."""
b = assumed.positive("b")
SINE = A * sympy.sin(THETA)
BACK = total(product(-A, THETA), sympy.pi * A + b / 2)
LISTED = (total(A * THETA, -b / 2), total(SINE, b / 2), BACK, total(SINE, -b / 2))
"""Lines 10 to 13 of Listing A.8 with theta = omega t, and what the constant of line 12 stands for."""
EQUATION = (*LISTED[:2], product(-A, THETA - sympy.pi), LISTED[3])  # Right sides of equation 2.42
PHASES = (0.5, 2.0, 4.0, 5.5)  # A phase inside of each piece, rad
IN_TEXT = "109.845"
CONTACT_ITEM = f"{LISTED_CONTACT} s, time of contact in Listing A.8"
OFFSET_ITEM = f"{LISTED_OFFSET} m, constant of line 12 of Listing A.8"
FREQUENCY_ITEM = "109.845 Hz, driving frequency seen in the experiment"
ROUNDED_CONSTANT = 0.02
"""Share by which the two digits of line 12's constant may move the output at that phase."""
CLOSE = 0.01  # Share of the gap by which the block may differ from the waveform that it stands for


def friction_parts(place: str = "") -> tuple[ClaimPart, ...]:
    """Return a part for each branch of Listing A.7, held against a load that walls push and never pull.

    ``place`` stands before the lines' numbers in the labels.
    """
    distance = assumed.positive("d")
    values = {PIN: 0.7, GAP: 0.4, distance: 0.25}
    inside = PIN - GAP / 2 + GAP * distance / (1 + distance)
    rows = (
        ("lines 2 and 3", "e - D/2", r"e - u_\text{prev} > D/2", PIN - GAP / 2, PIN - GAP / 2 - distance),
        ("lines 5 and 6", "e + D/2", r"e - u_\text{prev} < -D/2", PIN + GAP / 2, PIN + GAP / 2 + distance),
        ("line 8", r"u_\text{prev}", r"|e - u_\text{prev}| \le D/2", inside, inside),
    )
    parts = []
    for label, value, condition, returned, load in rows:
        derived = sympy.simplify(friction_step().subs(LOAD, load))
        library = friction_by_python_control(values[PIN], values[GAP], float(load.subs(values)))
        second = close("python-control's backlash", float(returned.subs(values)), library)
        form = rf"u = {value} \quad \text{{if }} {condition}"
        more = More(second=second, form=form, item=f"Listing A.7, {label}")
        parts.append(expression(f"{place}{label}", returned, derived, **more))
    return tuple(parts)


@claim("lst-A.7")
def friction_controlled(_: Evidence) -> Record:
    yield from friction_parts()
    as_read = blocks_closed(FRICTION_LINES)
    one_less = blocks_closed(FRICTION_LINES[:-1])
    yield part(
        "blocks",
        as_read,
        second=so("without line 12 each block is closed once", one_less.compare().agrees),
        severity=Severity.SLIP,
        certainty=Certainty.READING,
    )
    yield text("""
        The three branches are those of a load without inertia between walls a total $D$ apart, for any input.
        Line 12 is one `end` too many, and the function cannot be run; without it, it can. A machine that read
        the page could have read an `end` twice, but it would have had to invent the number of its line as
        well. So the line is rather the author's; the page shows it.

        Nothing else is touched: what was simulated cannot have had that line. Caption and arguments are
        [judged apart](#txt-A.7-captions).
    """)


def blocks_closed(lines: tuple[str, ...]) -> Assertion:
    """Return whether each block that a line opens is closed by an end."""
    opened = sum(bool(re.match(r"\b(function|if|for|while|switch)\b", line)) for line in lines)
    closed = lines.count("end")
    return Assertion(
        "each block that is opened is closed once",
        opened == closed,
        f"{opened} lines open a block, {closed} close one",
        "read in the printed lines, and counted",
    )


def at_phase(piece: sympy.Expr, phase: float) -> float:
    """Return a piece of the waveform at a phase (rad) for the constants of Listing A.8, m."""
    return float(piece.subs({THETA: phase, A: DRIVE_AMPLITUDE, b: TIMED_GAP}))


def element_at_phase(phase: float) -> float:
    """Return the same of the numeric element."""
    (output,) = InertiaBacklash(TIMED_GAP).waveform(np.array([phase]), DRIVE_AMPLITUDE, DRIVE_OMEGA)
    return float(output)


@claim("lst-A.8")
def inertia_controlled(_: Evidence) -> Record:
    pieces = [segment.value for segment in inertia_waveform(b).segments]
    for line, printed, piece, phase in zip(range(10, 14), LISTED, pieces, PHASES, strict=True):
        remark = r", with its constant as $\pi A + b/2$" if line == 12 else ""
        label = rf"line {line}{remark}, $\theta = \omega t$"
        by_element, exact = element_at_phase(phase), at_phase(piece, phase)
        second = close("the numeric element at a phase inside", by_element, exact)
        yield expression(label, printed, piece, left="y", second=second)

    angle, offset = DRIVE_OMEGA * contact_time(), at_phase(pieces[2], 0)
    flight = DRIVE_AMPLITUDE * angle - TIMED_GAP / 2
    wall = DRIVE_AMPLITUDE * math.sin(angle) + TIMED_GAP / 2
    second = close("flight and wall at that time", flight, wall)
    label = "line 8, phi, the time of contact"
    yield digits(label, LISTED_CONTACT, contact_time(), "s", second=second, item=CONTACT_ITEM)
    half_turn = DRIVE_AMPLITUDE * DRIVE_OMEGA * PERIOD / 2
    second = close(r"its value $b/2$ above $A \theta$ half a period on", TIMED_GAP / 2 + half_turn, offset)
    label = r"line 12, the constant $\pi A + b/2$"
    yield digits(label, LISTED_OFFSET, offset, "m", second=second, item=OFFSET_ITEM)

    instant = float(LISTED_CONTACT)
    (output,) = inertia_block_on_a_sine(np.array([instant]))
    beside = min(inertia_block_on_a_sine(instant + np.array([-1e-9, 1e-9]))) > 0
    second = so("a nanosecond before and after, where the output is that of flight and of contact", beside)
    pin = 1e3 * DRIVE_AMPLITUDE * math.sin(DRIVE_OMEGA * instant)
    yield assertion(
        "conditions of lines 10 to 13",
        "every instant belongs to one of the pieces",
        output != 0,
        f"""
        at $t$ = {LISTED_CONTACT} s, where the pin is at {pin:.2f} mm, the output is {output:.0f}: two
        conditions ask for more and for less, none for equal
        """,
        method=REPEATED,
        second=second,
    )

    lacking = offset - float(LISTED_OFFSET)
    yield text(f"""
        The four pieces are those of the derived waveform, and the contact time is right to every digit. The
        offset of line 12 is cut to two digits, so the output jumps by {1e6 * lacking:.1f} µm at half a
        period, {100 * lacking / TIMED_GAP:.0f} % of the gap. Only at the very instants of contact does no
        line apply, and the block returns zero there. Its flight is a function of time alone, so it is right
        for the input that the text names and for no other: behind a drive it can stand, in a closed loop it
        cannot.

        None on figures 4.2 and 5.14, where a drive of {DRIVE_FREQUENCY:.0f} Hz stands before it.
    """)


@claim("txt-A.9-constants")
def constants(_: Evidence) -> Record:
    angle = contact_angle_by_bisection(TIMED_GAP / DRIVE_AMPLITUDE)
    offset = math.pi * DRIVE_AMPLITUDE + TIMED_GAP / 2
    middle = math.pi + angle / 2
    by_wave = element_at_phase(middle) + DRIVE_AMPLITUDE * middle
    second = close("bisection", angle / DRIVE_OMEGA, contact_time(), 1e-12)
    label = "`phi`, the time of contact"
    yield digits(label, LISTED_CONTACT, contact_time(), "s", second=second, item=CONTACT_ITEM)
    second = close("the waveform half a flight after half a period", by_wave, offset, 1e-12)
    label = r"the constant of line 12, $\pi A + b/2$"
    yield digits(label, LISTED_OFFSET, offset, "m", second=second, item=OFFSET_ITEM)
    share = 100 * (offset - float(LISTED_OFFSET)) / TIMED_GAP
    yield text(rf"""
        Both are right to their digits, for {DRIVE_FREQUENCY:.0f} Hz: the contact angle is {angle:.5f} rad,
        and `phi` is that angle over $\omega$, in seconds. Two digits are few for the second one:
        {1e3 * offset:.4f} mm is meant. The {1e6 * (offset - float(LISTED_OFFSET)):.1f} µm that are missing
        lower every second flight by {share:.0f} % of the gap, so the output holds even harmonics that
        backlash cannot make.
    """)


@claim("txt-A.9-equation")
def equation(_: Evidence) -> Record:
    names = ("first", "second", "third", "fourth")
    pieces = [segment.value for segment in inertia_waveform(b).segments]
    listed = inertia_block_on_a_sine(np.array(PHASES) / DRIVE_OMEGA)
    rows = zip(range(10, 14), names, EQUATION, pieces, PHASES, listed, strict=True)
    for line, name, printed, piece, phase, output in rows:
        label, exact = rf"line {line} against the {name} piece, $\theta = \omega t$", at_phase(piece, phase)
        second = close("the listing, repeated, inside of the piece", output, exact, ROUNDED_CONSTANT)
        slip = made_here("equation 2.42 lacks the offset b/2", piece - b / 2)
        item = "third piece without b/2, output of inertia-controlled backlash" if line == 12 else ""
        yield expression(label, printed, piece, left="y", second=second, slip=slip, item=item)
    yield text(f"""
        The text says that the code gives [equation 2.42](#eq-2.42). Three of its pieces do. Line 12 contains
        the offset $b/2$ that the equation has lost, so on the way back the code lies half a gap above it. The
        code is right, up to the digits of its constant.

        None on what the code gives. Whoever writes the block anew from the equation gets an output that jumps
        by half a gap twice a period, here by {1e3 * TIMED_GAP / 2:.1f} mm.
    """)


@claim("txt-A.9-frequency")
def frequency(_: Evidence) -> Record:
    angle, in_text = contact_angle_by_bisection(TIMED_GAP / DRIVE_AMPLITUDE), float(IN_TEXT)
    belonging = angle / (TURN * float(LISTED_CONTACT))
    instants = (0.5 + np.array([0.0, TURN])) / (TURN * in_text)
    earlier, later = inertia_block(np.full(2, DRIVE_AMPLITUDE * math.sin(0.5)), instants)
    another = abs(later - earlier) > CLOSE * TIMED_GAP
    own, other = (inertia_difference(each) for each in (DRIVE_FREQUENCY, in_text))
    label = "frequency to which the contact time of line 8 belongs"
    second = close("line 5 of the listing", DRIVE_FREQUENCY, belonging, 1e-5)
    yield digits(label, IN_TEXT, belonging, "Hz", second=second, item=FREQUENCY_ITEM)
    yield assertion(
        f"the listing with an input of {IN_TEXT} Hz",
        "it gives the waveform of inertia-controlled backlash",
        other < CLOSE,
        f"within {PERIODS} periods it is off by {other:.1f} gaps; with 100 Hz by {own:.3f} gaps",
        method=f"{REPEATED}, beside the derived waveform",
        second=so("its output a whole period of that input later, which is another one", another),
        item=FREQUENCY_ITEM,
    )
    yield text(f"""
        Contact time and period of the listing are those of {DRIVE_FREQUENCY:.0f} Hz. With the text's
        frequency the pieces run at {DRIVE_FREQUENCY:.0f} Hz while the input does not, so the output has the
        period of neither; the contact time would have to be {angle / (TURN * in_text):.7f} s. Table 3.1 has
        {MEASURED_DRIVE_FREQUENCY} Hz for the same drive.

        None on figures: what was drawn with the listing was drawn for {DRIVE_FREQUENCY:.0f} Hz.
    """)
