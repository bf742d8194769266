"""Claims of appendix A.8: the block of friction-controlled backlash over time (Listing A.7)."""

from __future__ import annotations

import re

import control
import sympy

from derivations.backlash import GAP
from report.chapters.appendix_a.claims.time_domain import SOURCE
from report.claim import Claim, Confirmation, Impact, Mathematics, Part
from report.comparisons.assertion import Assertion
from report.comparisons.digits import CloseNumbers
from report.comparisons.expression import SameExpression
from report.evidence import Evidence
from report.octave.formulas import LOAD, PIN, friction_step

FRICTION_LINES = (
    *("function u = fcn(e, D_size, u_prev)", "if e - u_prev > D_size/2", "u = e - D_size/2;", "else"),
    *("if e - u_prev < -D_size/2", "u = e + D_size/2;", "else", "u = u_prev;"),
    *("end", "end", "end", "end"),
)
"""Listing A.7, line by line."""
OPENING = r"\b(function|if|for|while|switch)\b"


def claims(_: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    return (_friction(),)


def friction_block(pin: float, gap: float, load: float) -> float:
    """Return what Listing A.7 returns for its arguments e, D_size and u_prev."""
    if pin - load > gap / 2:
        return pin - gap / 2
    if pin - load < -gap / 2:
        return pin + gap / 2
    return load


def friction_parts(place: str = "") -> tuple[Part, ...]:
    """Return a part for each branch of Listing A.7, held against a load that walls push and never pull.

    ``place`` stands before the lines' numbers in the labels.
    """
    distance = sympy.Symbol("d", positive=True)
    inside = PIN - GAP / 2 + GAP * distance / (1 + distance)
    rows = (
        ("lines 2 and 3", "e - D/2", r"e - u_\text{prev} > D/2", PIN - GAP / 2, PIN - GAP / 2 - distance),
        ("lines 5 and 6", "e + D/2", r"e - u_\text{prev} < -D/2", PIN + GAP / 2, PIN + GAP / 2 + distance),
        ("line 8", r"u_\text{prev}", r"|e - u_\text{prev}| \le D/2", inside, inside),
    )
    return tuple(
        Part(
            f"{place}{label}",
            SameExpression(returned, sympy.simplify(friction_step().subs(LOAD, load))),
            Confirmation("python-control's backlash", _as_the_library(returned, load, distance)),
            printed_form=(form := Mathematics(rf"u = {value} \quad \text{{if }} {condition}")),
            derived_form=form,
        )
        for label, value, condition, returned, load in rows
    )


def _as_the_library(returned: sympy.Expr, load: sympy.Expr, distance: sympy.Expr) -> CloseNumbers:
    values = {PIN: 0.7, GAP: 0.4, distance: 0.25}
    library = control.friction_backlash_nonlinearity(values[GAP])
    library.center = float(load.subs(values))
    return CloseNumbers(float(returned.subs(values)), library(values[PIN]))


def _friction() -> Claim:
    opened = sum(bool(re.match(OPENING, line)) for line in FRICTION_LINES)
    closed = FRICTION_LINES.count("end")
    return Claim(
        id="lst-A.7",
        parts=(
            *friction_parts(),
            Part(
                "blocks",
                Assertion(
                    statement="each block that is opened is closed once",
                    derived=opened == closed,
                    evidence=f"{opened} lines open a block (1, 2 and 5), {closed} close one (9 to 12)",
                    method="read in the printed lines, and counted",
                ),
            ),
        ),
        explanation=(
            "The three branches are those of a load without inertia between walls a total $D$ apart, for any "
            "input. Line 12 has one `end` too many, so the function cannot be read as printed. The caption "
            "calls it a describing function, which it is not; its arguments are described in A.4."
        ),
        consequence=(
            "None once line 12 is deleted. What runs has the right waveform, unlike equation 2.36, whose "
            "first and third piece have the wrong sign."
        ),
        impact=Impact.NOTATION,
        source=SOURCE,
    )
