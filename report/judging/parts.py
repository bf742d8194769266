"""Parts of claims, each in one call: what is printed, what is derived, a second way, and a slip.

Second ways: ``close`` for numbers, ``equal`` for counts and what is exactly the same, ``small`` for what has
to vanish, ``same`` for expressions and matrices, ``so`` for a finding of which is known whether it holds.

``second`` confirms the derived side independently; ``slip`` gives the printed side when it is repeated.
"""

from __future__ import annotations

import math
import re
from fractions import Fraction
from typing import Any, TypedDict, Unpack

import numpy as np
import sympy

from report.judging.claim import Check, ClaimPart, Comparison, Confirmation, CopyFault, Slip, Uncheckable
from report.judging.comparisons.assertion import Assertion
from report.judging.comparisons.digits import CloseNumbers, Equal, PrintedDigits, Small
from report.judging.comparisons.expression import SameExpression, SameMatrix
from report.judging.shown import Mathematics, Shown, Words
from report.judging.text import RecordError, one_line
from report.judging.verdict import Certainty, Severity, Verdict

DECIMAL = re.compile(r"[-+]?\d+(\.\d*)?([eE][-+]?\d+)?")


Findings = bool | tuple[bool | np.bool, ...]
"""What was found: one thing, or several of which all have to hold."""
THE_PAGE = "the page itself decides; only a text read from it by machine was at hand"


class More(TypedDict, total=False):
    """What any part may have.

    ``form`` is TeX that is shown on both sides in place of what the comparison holds, ``printed_form`` and
    ``derived_form`` are shown on one side, as TeX if they are strings. ``item`` names the printed thing that
    the part judges; parts of any claims with the same item count once. ``copy_fault`` is what the machine
    that read the page may have lost; ``severity`` and ``certainty`` stand in place of those of the statement.
    """

    second: Confirmation | None
    slip: Slip | None
    form: str
    printed_form: Shown | str
    derived_form: Shown | str
    item: str
    copy_fault: CopyFault | None
    severity: Severity | None
    certainty: Certainty | None


def digits(
    label: str, printed: str, derived: float | Fraction, unit: str = "", **more: Unpack[More]
) -> ClaimPart:
    """Hold printed digits against a number; half a unit of the last printed place is the tolerance.

    Raises:
        RecordError: if what is printed is no string of digits, or what is derived not finite.
    """
    if not (isinstance(printed, str) and DECIMAL.fullmatch(printed)):
        raise RecordError(f"part {label!r}: {printed!r} is no string of digits such as '8.28' or '2.1e-8'")
    if not math.isfinite(derived):
        raise RecordError(f"part {label!r}: {derived} is no number to hold against {printed!r}")
    return part(label, PrintedDigits(printed, derived, unit), **more)


def assertion(
    label: str,
    statement: str,
    derived: Findings,
    evidence: str,
    *,
    method: str,
    asserted: bool = True,
    **more: Unpack[More],
) -> ClaimPart:
    """Hold what the thesis asserts, in our words, against what was found.

    The label is empty for the only part. The statement and its evidence are Markdown; ``asserted`` is False
    where the thesis denies the property. Of several findings all have to hold.
    """
    statement, evidence, method = map(one_line, (statement, evidence, method))
    return part(label, Assertion(statement, _hold(derived), evidence, method, asserted), **more)


def expression(
    label: str,
    printed: sympy.Expr,
    derived: sympy.Expr,
    left: sympy.Basic | str | None = None,
    *,
    assume: sympy.Basic = sympy.true,
    **more: Unpack[More],
) -> ClaimPart:
    """Hold a printed expression against a derived one; for ``left`` and ``assume`` see ``SameExpression``."""
    return part(label, SameExpression(printed, derived, left, assume), **more)


def matrix(
    label: str,
    printed: sympy.ImmutableMatrix,
    derived: sympy.ImmutableMatrix,
    left: sympy.Basic | str | None = None,
    **more: Unpack[More],
) -> ClaimPart:
    """Hold a printed matrix against a derived one, entry by entry."""
    return part(label, SameMatrix(printed, derived, left), **more)


def part(label: str, comparison: Comparison, **more: Unpack[More]) -> ClaimPart:
    """Return a part that makes a comparison."""
    both = more.get("form")
    shown = (more.get("printed_form", both), more.get("derived_form", both))
    printed, derived = (Mathematics(form) if isinstance(form, str) else form for form in shown)
    return ClaimPart(
        one_line(label),
        comparison,
        more.get("second"),
        more.get("slip"),
        printed,
        derived,
        more.get("item", ""),
        more.get("copy_fault"),
        more.get("severity"),
        more.get("certainty"),
    )


def uncheckable(label: str, printed: str, missing: str, *, item: str = "") -> Uncheckable:
    """Return a part that cannot be checked: the words printed, and which data are missing for it."""
    return Uncheckable(one_line(label), Words(one_line(printed)), one_line(missing), item)


def made_here(name: str, derived: Any) -> Slip:
    """Name a slip that was made in this very place, and what is derived when it is repeated."""
    return Slip(one_line(name), derived, Verdict.ERRATUM)


def repeated(name: str, derived: Any) -> Slip:
    """Name a slip that was made somewhere else and is repeated here faithfully."""
    return Slip(one_line(name), derived, Verdict.EXPLAINED)


def same(means: str, first: Any, second: Any) -> Confirmation:
    """Confirm an expression or a matrix by another derivation of it."""
    alike = SameMatrix if isinstance(first, sympy.MatrixBase) else SameExpression
    return Confirmation(one_line(means), alike(first, second))


def lost_in_the_copy(name: str, restored: Check) -> CopyFault:
    """Name what the machine that read the page may have lost; what is restored has to agree."""
    return CopyFault(one_line(name), restored, THE_PAGE)


def close(means: str, first: complex, second: complex, relative: float = 1e-9) -> Confirmation:
    """Confirm a number by another way to it, to a relative accuracy."""
    return Confirmation(one_line(means), CloseNumbers(first, second, relative))


def equal(means: str, first: object, second: object) -> Confirmation:
    """Confirm a count, or anything else that is exactly the same, by another way to it."""
    return Confirmation(one_line(means), Equal(first, second))


def small(means: str, value: float, bound: float = 1e-9) -> Confirmation:
    """Confirm that what has to vanish stays below a bound."""
    return Confirmation(one_line(means), Small(value, bound))


def so(means: str, holds: Findings) -> Confirmation:
    """Confirm a finding by another way to it, of which is known whether it leads to the same finding.

    If it is seen by several things, all have to hold.
    """
    return Confirmation(one_line(means), Equal(_hold(holds), True))


def _hold(findings: Findings) -> bool:
    return all(findings) if isinstance(findings, tuple) else bool(findings)
