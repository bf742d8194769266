"""Claims of section 5.2 on its references to other places, and on one prediction quoted with other digits."""

from __future__ import annotations

import math

from report.claim import Claim, Confirmation, Impact, Part, Slip, Verdict
from report.comparisons.assertion import Assertion
from report.comparisons.digits import CloseNumbers, PrintedDigits
from report.evidence import Evidence
from report.inventory import read_inventory
from report.numbers.limit_cycle_numbers import LISTING_DENOMINATOR, LISTING_NUMERATOR, friction_by_newton
from report.sections import read_sections

SOURCE = "report/chapters/chapter_5/claims/section_5_2_references.py"
OPEN_LOOP_RESULT = "fig-5.14"
"""What section 5.2.2 describes in the sentence that names figure 5.16."""
BLOCK_IN_TIME = "lst-A.8"
"""What Simulink needs as inertia-controlled backlash; section 5.2.2 names appendix A.11."""
WITHOUT_FRICTION = "fig-5.22"
"""What section 5.2.5 describes in the sentence that names figure 5.8."""
QUOTED = {"section 5.2.1": "733.3", "its percent error": "733.34", "table 5.1 and section 5.2.5": "733.33"}
"""The frequency predicted for b = 4e-6 m, Hz, each place it is quoted."""
COMPARED, DIFFERENCE = 737.514, "0.5705"


def claims(evidence: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    return (_to_the_models(), _of_inertia(), _of_zero_force(), _quoted(evidence))


def _refers(label: str, named: str, meant: str, what: str) -> Part:
    """Return the part on a reference to a figure or a listing: whether it is the one that is described."""
    entries = read_inventory()
    places = {figure: section.number for section in read_sections() for figure in section.figures}
    place = places.get(meant, entries[meant].section)
    return Part(
        label,
        Assertion(
            statement=f"{named.replace('fig-', 'figure ').replace('lst-', 'Listing ')} shows {what}",
            derived=entries[named].title == entries[meant].title,
            evidence=(
                f"that is “{entries[named].title}”; meant is "
                f"{meant.replace('fig-', 'figure ').replace('lst-', 'Listing ')}, “{entries[meant].title}”"
            ),
            method=f"read in the captions of the two; the second stands in section {place}",
        ),
    )


def _to_the_models() -> Claim:
    place = next(section for section in read_sections() if "fig-3.6" in section.figures)
    named = next(section for section in read_sections() if section.number == "3.1")
    return Claim(
        id="txt-5.2.1-references",
        parts=(
            Part(
                "where the models in open loop stand",
                Assertion(
                    statement="the models in open loop are those of section 3.1",
                    derived=place.number == named.number,
                    evidence=(
                        f"section 3.1 is “{named.title}”; the simulations in open loop, figures 3.6 to 3.8, "
                        f"stand in section {place.number}"
                    ),
                    method="read in the headings of the sections and the places of their figures",
                ),
            ),
        ),
        explanation=(
            "Section 3.1 describes the camera and the trial; the models that are compared with it, in open "
            "and in closed loop, are those of section 3.3."
        ),
        consequence="None: the configuration is named in words.",
        impact=Impact.NOTATION,
        source=SOURCE,
    )


def _of_inertia() -> Claim:
    return Claim(
        id="txt-5.2.2-references",
        parts=(
            _refers("figure", "fig-5.16", OPEN_LOOP_RESULT, "the open loop of inertia-controlled backlash"),
            _refers("listing of appendix A.11", "lst-A.10", BLOCK_IN_TIME, "the block that Simulink needs"),
        ),
        explanation=(
            "Two references miss their place. The time response and the spectrum are figure 5.14, as the "
            "next sentences have it; the block over time is Listing A.8 of appendix A.9, while A.11 holds "
            "the describing function. Section 4.2.2 names the two appendices rightly."
        ),
        consequence=(
            "A describing function put where the text says, in the place of a block over time, would give a "
            "gain for an output."
        ),
        impact=Impact.NOTATION,
        source=SOURCE,
    )


def _of_zero_force() -> Claim:
    return Claim(
        id="txt-5.2.5-references",
        parts=(_refers("figure", "fig-5.8", WITHOUT_FRICTION, "the equivalent nonlinearity for $F_c = 0$"),),
        explanation=(
            "The sentence introduces figure 5.22, which follows it and has the force in its caption. Figure "
            "5.8 is the one of friction-controlled backlash that it is compared with."
        ),
        consequence="None: the two show the same intersection.",
        impact=Impact.NOTATION,
        source=SOURCE,
    )


def _quoted(evidence: Evidence) -> Claim:
    predicted = evidence.cycles.friction_listing.stable.frequency
    rounded = f"{predicted:.2f}"
    return Claim(
        id="txt-5.2.5-quoted-prediction",
        parts=(
            _digits(evidence, predicted),
            Part(
                "the difference to 737.514 Hz",
                PrintedDigits(DIFFERENCE, 100 * (COMPARED / float(rounded) - 1), "%"),
                Confirmation(
                    "the difference of logarithms",
                    CloseNumbers(
                        100 * math.expm1(math.log(COMPARED) - math.log(float(rounded))),
                        100 * (COMPARED / float(rounded) - 1),
                    ),
                ),
                Slip(
                    "733.33 Hz, cut off, is used for the rounded 733.34 Hz",
                    100 * (COMPARED / 733.33 - 1),
                    Verdict.EXPLAINED,
                ),
            ),
        ),
        explanation=(
            f"Listing A.9's coefficients give {predicted:.4f} Hz, so 733.3 and 733.34 Hz are right roundings "
            "of one number and 733.33 Hz is not. The amplitude fares alike: $3.3138\\times10^{-5}$ m becomes "
            "$3.313\\times10^{-5}$ m in section 5.2.5. The percentage of that section follows from the "
            "number that is cut off."
        ),
        consequence=(
            "The difference is 0.5692 % from the rounded number; it compares with a wrong term in any case."
        ),
        impact=Impact.LOCAL,
        source="report/numbers/limit_cycle_numbers.py",
    )


def _digits(evidence: Evidence, predicted: float) -> Part:
    _, by_newton = friction_by_newton(
        LISTING_NUMERATOR, LISTING_DENOMINATOR, evidence.cycles.friction_listing.stable
    )
    wrong = [digits for digits in QUOTED.values() if not PrintedDigits(digits, predicted).compare().agrees]
    return Part(
        "the frequency for a gap of $4\\times10^{-6}$ m",
        Assertion(
            statement="one prediction is quoted everywhere, to as many digits as stand there",
            derived=not wrong,
            evidence=(
                ", ".join(f"{digits} Hz in {place}" for place, digits in QUOTED.items())
                + f"; {wrong[0]} is {predicted:.4f} cut off" * bool(wrong)
            ),
            method="each quoted number against the listing's coefficients",
        ),
        Confirmation("Newton's method in 30 digits", CloseNumbers(by_newton / (2 * math.pi), predicted)),
    )
