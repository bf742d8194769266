"""Claims of section 5.2 on references, on symbols, and on one prediction quoted with other digits."""

import math

from report.chapters.chapter_5.claims.section_5_2_1_predictions import AMPLITUDE
from report.chapters.chapter_5.claims.section_5_2_5 import DIFFERENCE
from report.chapters.second_ways import NEWTON
from report.data.statements import read_inventory, read_sections
from report.judging.claim import ClaimPart
from report.judging.comparisons.digits import PrintedDigits
from report.judging.comparisons.printed import power, power_of
from report.judging.parts import assertion, close, digits, repeated
from report.judging.record import Record, claim, text
from report.numbers.evidence import Evidence
from report.numbers.independent.limit_cycles import friction_as_listed
from report.numbers.thesis import SMALL_GAP, TURN

PREDICTED = "3.3138e-5"  # Printed amplitude by harmonic balance, m
QUOTED = {"section 5.2.1": "733.3", "its percent error": "733.34", "table 5.1 and section 5.2.5": "733.33"}
"""The frequency predicted for b = 4e-6 m, Hz, each place it is quoted."""


def refers(label: str, named: str, meant: str, what: str) -> ClaimPart:
    """Return the part on a reference to a figure or a listing: whether it is the one that is described."""
    entries = read_inventory()
    places = {figure: section.number for section in read_sections() for figure in section.figures}
    first, second = (each.replace("fig-", "figure ").replace("lst-", "Listing ") for each in (named, meant))
    titles = entries[named].title, entries[meant].title
    place = places.get(meant, entries[meant].section)
    return assertion(
        label,
        f"{first} shows {what}",
        titles[0] == titles[1],
        f"that is “{titles[0]}”; meant is {second}, “{titles[1]}”",
        method=f"read in the captions of the two; the second stands in section {place}",
    )


@claim("txt-5.2.1-references")
def to_the_models(_: Evidence) -> Record:
    place = next(section for section in read_sections() if "fig-3.6" in section.figures)
    named = next(section for section in read_sections() if section.number == "3.1")
    yield assertion(
        "where the models in open loop stand",
        "the models in open loop are those of section 3.1",
        place.number == named.number,
        f"""
        section 3.1 is “{named.title}”; the simulations in open loop, figures 3.6 to 3.8, stand in section
        {place.number}
        """,
        method="read in the headings of the sections and the places of their figures",
    )
    yield text("""
        Section 3.1 describes the camera and the trial. The models that are compared with them, in open and in
        closed loop, stand in section 3.3.

        None: the configuration is named in words.
    """)


@claim("txt-5.2.2-references")
def of_inertia(_: Evidence) -> Record:
    yield refers("figure", "fig-5.16", "fig-5.14", "the open loop of inertia-controlled backlash")
    yield refers("listing of appendix A.11", "lst-A.10", "lst-A.8", "the block that Simulink needs")
    yield text("""
        Two references miss their place. The time response and the spectrum are figure 5.14, as the next
        sentences have it. The block over time is Listing A.8 of appendix A.9; A.11 holds the describing
        function. Section 4.2.2 names the two appendices rightly.

        None on numbers. Whoever takes the listing that is named puts a gain where an output belongs.
    """)


@claim("txt-5.2.5-references")
def of_zero_force(_: Evidence) -> Record:
    yield refers("figure", "fig-5.8", "fig-5.22", "the equivalent nonlinearity for $F_c = 0$")
    yield text("""
        The sentence introduces figure 5.22, which follows it and has the force in its caption. Figure 5.8 is
        the one of friction-controlled backlash that it is compared with.

        None: the two show the same intersection.
    """)


@claim("txt-5.2.5-quoted-prediction")
def quoted_prediction(known: Evidence) -> Record:
    cycle = known.cycles.friction_listing.stable
    predicted = cycle.frequency
    _, omega = friction_as_listed(cycle)
    cut_off = [
        printed for printed in QUOTED.values() if not PrintedDigits(printed, predicted).compare().agrees
    ]
    yield assertion(
        "the frequency for a gap of $4\\times10^{-6}$ m",
        "one prediction is quoted everywhere, to as many digits as stand there",
        not cut_off,
        ", ".join(f"{printed} Hz in {place}" for place, printed in QUOTED.items())
        + f"; {cut_off[0]} is {predicted:.4f} cut off" * bool(cut_off),
        method="each quoted number against the listing's coefficients",
        second=close(NEWTON, omega / TURN, predicted),
        item="733.3, 733.34 and 733.33 Hz, one prediction in three roundings",
    )
    compared, rounded = 737.514, float(f"{predicted:.2f}")
    difference, from_cut_off = (100 * (compared / each - 1) for each in (rounded, 733.33))
    by_logarithms = 100 * math.expm1(math.log(compared) - math.log(rounded))
    second = close("the difference of logarithms", by_logarithms, difference)
    slip = repeated("733.33 Hz, cut off, is used for the rounded 733.34 Hz", from_cut_off)
    label = "the difference to 737.514 Hz"
    yield digits(label, "0.5705", difference, "%", second=second, slip=slip, item=DIFFERENCE)
    yield text(rf"""
        The coefficients of Listing A.9 give {predicted:.4f} Hz. 733.3 and 733.34 Hz are right roundings of
        it; 733.33 Hz is cut off. So is the amplitude of section 5.2.5, where $3.3138\times10^{{-5}}$ m has
        become $3.313\times10^{{-5}}$ m. The percentage of that section follows from the number that is cut
        off.

        None beyond a last digit: from the rounded number the difference is {difference:.4f} %.
    """)


@claim("txt-5.2.1-amplitude-symbols")
def amplitude_symbols(known: Evidence) -> Record:
    under_the_symbol, simulated = "3.2995e-5", 3.2995e-5
    cycle = known.cycles.friction_listing.stable
    predicted = cycle.amplitude * SMALL_GAP
    ratio, _ = friction_as_listed(cycle)
    readings = (3.303e-5 - -3.2961e-5) / 2
    yield assertion(
        "nomenclature: the value that section 5.2.1 calls $A_{lcs}$",
        "it is the one predicted by the condition for harmonic balance",
        PrintedDigits(under_the_symbol, predicted).compare().agrees,
        f"""
        {power(under_the_symbol)} m is half of the distance of two readings from a simulation; harmonic
        balance gives {power_of(predicted, 4)} m, which is called $A_{{lch}}$
        """,
        method="both values of section 5.2.1 against harmonic balance with Listing A.9",
        second=close("half of the distance of the two readings", readings, simulated, 2e-5),
    )
    second = close(NEWTON, SMALL_GAP * ratio, predicted)
    label = "footnote 4: $A_{lch}$ is the predicted one"
    yield digits(label, PREDICTED, predicted, "m", second=second, item=AMPLITUDE)
    yield text(f"""
        The nomenclature gives $A_{{lcs}}$ as the predicted amplitude. Footnotes 4 and 5 and the numbers of
        section 5.2.1 have it the other way round: s stands for the simulation, h for harmonic balance.
        Section 5.2.5 writes $f_{{lcs}}$ for both, a frequency read from an intersection and one from a
        spectrum.

        Read with the nomenclature, the error of section 5.2.1 would be relative to the prediction,
        {100 * (1 - simulated / float(PREDICTED)):.4f} % instead of
        {100 * (float(PREDICTED) / simulated - 1):.4f} %.
    """)
