"""Claims of appendices A.3 and A.6 on names that a listing uses and does not define."""

from __future__ import annotations

import re

from report.claim import Claim, Confirmation, Impact, Part
from report.comparisons.assertion import Assertion
from report.evidence import Evidence

SOURCE = "report/chapters/appendix_a/claims/names.py"
NAME = r"[A-Za-z_]\w*"
LISTING_A_2 = ("N = zeros(size(A));", "N(A < b) = 0;", "N.re = ...", "N.im = ...", "N = N_re + 1i*N_im;")
LISTING_A_3 = ("N = zeros(size(A));", "N(A < b) = 0;", "N_re = ...", "N_im = ...", "N = N_re + 1i*N_im;")
"""Lines of Listings A.2 and A.3 that set or use N, right sides of the long ones left out."""
LISTING_A_5 = ("np = ...", "nq = ...", "N = np + li*nq;")
"""The same of Listing A.5."""
COPY = "The listing is judged as it stands in the copy at hand; reading the page by machine may have done it."


def claims(_: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    return (_fields(), _imaginary_unit())


def undefined_names(lines: tuple[str, ...]) -> set[str]:
    """Return the names on the right side of the last line that no line before it assigns."""
    assigned = {match[1] for line in lines[:-1] if (match := re.match(rf"({NAME})\s*=", line))}
    used = set(re.findall(rf"(?<![\w.]){NAME}", lines[-1].split("=", 1)[1]))
    return used - assigned


def _fields() -> Claim:
    missing = undefined_names(LISTING_A_2)
    return Claim(
        id="txt-A.3-names",
        parts=(
            Part(
                "last line of Listing A.2",
                Assertion(
                    statement="what it adds up has been assigned before",
                    derived=not missing,
                    evidence=f"{' and '.join(sorted(missing))} are not; lines 9 and 10 assign N.re and N.im",
                    method="names on both sides of the listing's assignments",
                ),
                Confirmation(
                    "Listing A.3, with the same last line",
                    Assertion(
                        statement="what it adds up has been assigned before",
                        derived=not undefined_names(LISTING_A_3),
                        evidence="its lines 9 and 10 assign N_re and N_im",
                        method="the lines of Listing A.3",
                    ),
                ),
            ),
        ),
        explanation=(
            "A point stands for an underscore: N.re asks for a field of what line 5 has made a matrix, and "
            f"N_re is not defined. {COPY} Listing A.3 has the underscores and runs."
        ),
        consequence="Listing A.2 stops with an error; Listing A.3 is the one to use.",
        impact=Impact.NOTATION,
        source=SOURCE,
    )


def _imaginary_unit() -> Claim:
    missing = undefined_names(LISTING_A_5)
    return Claim(
        id="txt-A.6-imaginary-unit",
        parts=(
            Part(
                "last line of Listing A.5",
                Assertion(
                    statement="what it adds up has been assigned before",
                    derived=not missing,
                    evidence=f"{', '.join(sorted(missing))} is not",
                    method="names on both sides of the listing's assignments",
                ),
                Confirmation(
                    "the same line with 1i, the imaginary unit",
                    Assertion(
                        statement="what it adds up has been assigned before",
                        derived=not undefined_names((*LISTING_A_5[:-1], LISTING_A_5[-1].replace("li", "1i"))),
                        evidence="1i is a number",
                        method="names on both sides of the corrected line",
                    ),
                ),
            ),
        ),
        explanation=(
            "The letter l stands for the digit 1 of the imaginary unit 1i, which Listing A.3 has right. "
            f"{COPY}"
        ),
        consequence="As it stands the listing stops with an error at its last line.",
        impact=Impact.NOTATION,
        source=SOURCE,
    )
