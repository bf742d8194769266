"""Claims of appendix A on what the text calls the listings, and on names that these do not define."""

import math
import re

import numpy as np

from derivations.elements.backlash import GAMMA
from derivations.elements.friction import FORCE
from report.chapters.appendix_a.claims.listings_a_7_and_a_8_over_time import FRICTION_LINES, ROUNDED_CONSTANT
from report.chapters.chapter_5.claims.figures_5_21_to_5_24_equivalent import LISTING
from report.chapters.second_ways import REPEATED
from report.judging.comparisons.assertion import Assertion
from report.judging.parts import assertion, close, lost_in_the_copy, so
from report.judging.record import Record, claim, text
from report.numbers.evidence import Evidence
from report.numbers.listed_blocks import (
    PERIOD,
    friction_block,
    friction_by_python_control,
    inertia_block_on_a_sine,
)
from report.numbers.thesis import DRIVE_AMPLITUDE, DRIVE_OMEGA, TIMED_GAP
from trimmer import InertiaBacklash

FRICTION_FUNCTION = "function N = backlash_describing_func_2(A, b)"  # First line of Listings A.2 and A.3
CALL = "N = @(A) backlash_describing_func_2(A, b)"  # Line 8 of Listing A.9
LISTING_A_2 = ("N = zeros(size(A));", "N(A < b) = 0;", "N.re = ...", "N.im = ...", "N = N_re + 1i*N_im;")
LISTING_A_3 = ("N = zeros(size(A));", "N(A < b) = 0;", "N_re = ...", "N_im = ...", "N = N_re + 1i*N_im;")
"""Lines of Listings A.2 and A.3 that set or use N, right sides of the long ones left out."""
LISTING_A_5 = ("np = ...", "nq = ...", "N = np + li*nq;")  # The same of Listing A.5
NAME = r"[A-Za-z_]\w*"
ASSIGNED = "what it adds up has been assigned before"
BOTH_SIDES = "names on both sides of the listing's assignments"
IS_FUNCTION = "it is a describing function"


def undefined_names(lines: tuple[str, ...]) -> set[str]:
    """Return the names on the right side of the last line that no line before it assigns."""
    assigned = {match[1] for line in lines[:-1] if (match := re.match(rf"({NAME})\s*=", line))}
    used = set(re.findall(rf"(?<![\w.]){NAME}", lines[-1].split("=", 1)[1]))
    return used - assigned


def assigned_in(lines: tuple[str, ...]) -> Assertion:
    """Return whether the last of some lines adds up only what the others assign."""
    missing = undefined_names(lines)
    return Assertion(ASSIGNED, not missing, f"without {len(missing)} of its names", BOTH_SIDES)


@claim("txt-A.3-names")
def fields(_: Evidence) -> Record:
    missing = undefined_names(LISTING_A_2)
    with_underscores = tuple(re.sub(r"^N\.", "N_", line) for line in LISTING_A_2)
    yield assertion(
        "last line of Listing A.2",
        ASSIGNED,
        not missing,
        f"{' and '.join(sorted(missing))} are not; lines 9 to 11 assign N.re and N.im",
        method=BOTH_SIDES,
        second=so("Listing A.3, with the same last line", not undefined_names(LISTING_A_3)),
        copy_fault=lost_in_the_copy(
            "two underscores are read as points, N.re and N.im for N_re and N_im",
            assigned_in(with_underscores),
        ),
    )
    yield text("""
        As read, `N.re` asks for a field of what line 5 has made a matrix, `N_re` is not defined, and the
        listing stops with an error. With underscores it is Listing A.3 and runs. The page shows which of them
        it has.
    """)


@claim("txt-A.6-imaginary-unit")
def imaginary_unit(_: Evidence) -> Record:
    missing = undefined_names(LISTING_A_5)
    corrected = (*LISTING_A_5[:-1], LISTING_A_5[-1].replace("li", "1i"))
    yield assertion(
        "last line of Listing A.5",
        ASSIGNED,
        not missing,
        f"{', '.join(sorted(missing))} is not",
        method=BOTH_SIDES,
        second=so("the same line of Listing A.3, with 1i", not undefined_names(LISTING_A_3)),
        copy_fault=lost_in_the_copy("the digit 1 of 1i is read as the letter l", assigned_in(corrected)),
    )
    yield text("""
        As read, the letter l stands where the imaginary unit `1i` has the digit 1, and the listing stops with
        an error at its last line. Listings A.3 and A.6 have the digit. The two look alike in many typefaces;
        the page shows which it has.
    """)


@claim("txt-A.7-captions")
def captions(_: Evidence) -> Record:
    names = ", ".join(sorted(str(symbol) for symbol in LISTING.free_symbols))
    yield assertion(
        "caption of Listing A.6",
        "it is the describing function of viscous-controlled backlash",
        (GAMMA in LISTING.free_symbols, FORCE not in LISTING.free_symbols),
        f"it depends on {names}, so on a force of friction, and on no $M/D$",
        method="read in the listing: the names in its formula",
    )
    once, twice = (friction_block(scale * 0.7, scale * 0.4, scale * 0.1) for scale in (1.0, 2.0))
    library = friction_by_python_control(0.7, 0.4, 0.1)
    yield assertion(
        "caption of Listing A.7",
        IS_FUNCTION,
        math.isclose(once, twice),
        """
        with all displacements doubled its result doubles, so it is a displacement; a describing function, a
        ratio, stays
        """,
        method=REPEATED,
        second=close("python-control's backlash, whose output it is", library, once),
    )
    times = np.array([0.3, 0.4]) * PERIOD
    right, _later = 1e3 * InertiaBacklash(TIMED_GAP).waveform(DRIVE_OMEGA * times, DRIVE_AMPLITUDE)
    then, later = 1e3 * inertia_block_on_a_sine(times)
    waveform = "the waveform of inertia-controlled backlash, which has the first of them then"
    yield assertion(
        "caption of Listing A.8",
        IS_FUNCTION,
        math.isclose(then, later),
        f"for one amplitude and frequency it returns {then:.2f} and {later:.2f} mm at two instants",
        method=REPEATED,
        second=close(waveform, float(right), then, ROUNDED_CONSTANT),
    )
    listed, other = (line[line.index("(") :].strip("()") for line in (FRICTION_FUNCTION, FRICTION_LINES[0]))
    yield assertion(
        "text of A.4",
        "Listing A.3 takes the input wave, the dead band and the previous output",
        listed.split(", ") == ["e", "D_size", "u_prev"],
        f"it takes {listed}; these three are the arguments of Listing A.7, {other}",
        method="read in the first lines of the two listings",
    )
    yield assertion(
        "heading of A.10",
        "its code is for Coulomb friction",
        "friction" in CALL.lower(),
        f"line 8 calls `{CALL.split()[-2].split('(')[0]}`, the function of Listing A.3",
        method="read in line 8 of Listing A.9",
    )
    yield text("""
        Three captions, a heading and a text name another function than the one that stands there. Listing A.6
        is the equivalent nonlinearity, as its heading says. Listings A.7 and A.8 are blocks over time and no
        describing functions. The text of A.4 describes Listing A.7, and under the heading of A.10 stands
        friction-controlled backlash, which section 5.2.1 tells the reader to put there.

        Whoever takes a listing by its caption solves with friction instead of a heavy load, or puts a
        displacement where a gain belongs.
    """)
