"""A small report that holds everything which is hard to show."""

import dataclasses

import sympy

from report.building.thesis import THESIS
from report.data.statements import ThesisSection
from report.data.text_copy import TextCopy
from report.document.advice import Advice, Bound
from report.document.document import Document
from report.document.extras import Answer, CorrectedResult, Highlight, Matter, Opening, Overview
from report.document.thesis import Chapter, Program
from report.pages.derivation import DerivationStep, NomenclatureRow, ParameterRow
from report.pages.figure import Equation, Figure
from report.pages.provenance import BuildTime, Provenance
from tests.report.rendering.sample_derivation import CODE, SPREAD, explorable, picture
from tests.report.rendering.sample_figures import figures
from tests.report.rendering.sample_findings import appendix_a, chapter_five, chapter_two
from tests.report.rendering.sample_formulas import (
    CASES,
    DOTS,
    INTEGRAL,
    KINETIC_ENERGY,
    NESTED,
    SPECIAL,
    long_coefficient,
    state_matrix,
)


def derivation() -> tuple[DerivationStep, ...]:
    """Return steps with equations that are long, tall and dotted."""
    return (
        DerivationStep(
            "kinetic",
            "Kinetic energy",
            "Four masses move along one line, so *T* is a sum of squares.\n\nA second paragraph, with $q_i$.",
            (Equation(KINETIC_ENERGY, "2.4"), Equation(DOTS, "2.9", "A sentence before it, with $q_i$.")),
            ("eq-2.9", "eq-2.8"),
            ("txt-5.1.2-roll-off",),
            (CODE,),
        ),
        DerivationStep(
            "state",
            "State space",
            "The states are the displacements and then the velocities.",
            (Equation(f"A = {sympy.latex(state_matrix())}", "2.12"), Equation(long_coefficient())),
            ("eq-2.12",),
            folded=True,
        ),
        DerivationStep(
            "waveform",
            "Waveform",
            "The bridge follows the pin while they touch.",
            (Equation(CASES, "2.36"), Equation(INTEGRAL, "2.30"), Equation(NESTED)),
        ),
    )


def describing_functions() -> tuple[DerivationStep, ...]:
    """Return the one step of the derivation of a describing function."""
    return (
        DerivationStep(
            "relay",
            "Relay",
            "A relay switches.",
            (Equation(r"N = \frac{4 M}{\pi A}", "2.37"),),
            picture=picture(),
        ),
    )


def answers() -> tuple[Answer, ...]:
    """Return answers to two research questions, one of which rests on claims."""
    return (
        Answer(
            "How does the play $b$ influence the vibration?",
            "The amplitude grows with it.",
            r"It is proportional to the play; see [figure 5.1](#fig-5.1). The factor is $\frac{A}{b} = 8.3$.",
            ("fig-5.1", "txt-5.1.2-roll-off"),
        ),
        Answer("Does damping matter?", "It raises the peaks.", "It lowers them."),
    )


def corrected() -> tuple[CorrectedResult, ...]:
    """Return predictions with numbers, with words and with nothing in their place."""
    return (
        CorrectedResult(
            "txt-5.1.2-roll-off",
            "amplitude, stable, $b$ = 4e-6 m",
            "3.3138e-5",
            "3.3261e-05",
            "3.3158e-05",
            "m",
            "the same for every gap, with a remark that is long enough to need more than one line",
        ),
        CorrectedResult("tab-5.1", "frequency", "814.9", "750.63", "750.62", "Hz"),
        CorrectedResult("txt-5.2.1-impulse-1e-8", "smallest gap", "2e-8", "none", "", "m"),
    )


def programs() -> tuple[Program, ...]:
    """Return a program that corrects a listing and one that does not."""
    text = "% Sums & products: A_1 < 2\nfunction y = total(x)\n  y = sum(x .^ 2); # not `this`\nend\n"
    wide = "wide = [" + ", ".join(f"{number}.0" for number in range(60)) + "];\n"
    return (
        Program("listing_a_1.m", "lst-A.1", "Matrices & more", ("Line 58 keeps G_1 < 0.", "A sign."), text),
        Program("main_numbers.m", "", "All numbers", (), wide * 50),
    )


def _another(figure: Figure, name: str) -> Figure:
    """Return the same drawing with another id, inside of it too."""
    return dataclasses.replace(figure, id=name, svg=figure.svg.replace(figure.id, name))


def opening() -> Opening:
    """Return the first screen."""
    return Opening(
        "The predictions do not: see $k_1$.",
        (
            Highlight(
                ("eq-2.9", "eq-2.12"),
                r"The first equation of motion has a wrong sign at $k_1 (q_1 - q_2)$.",
                r"Turn it: the pole moves by $3\,\%$.",
            ),
            Highlight(("txt-5.1.2-roll-off",), "The roll-off is 40 dB per decade, not 60.", "Use 40."),
        ),
        _another(figures()[0], "opening"),
        (
            _advice("Compute *your* trimmer", True),
            _advice("Trust $G$ blindly", False),
            _advice("Tune", False),
        ),
    )


def _advice(words: str, wanted: bool) -> Advice:
    bounds = (Bound("it repeats", "period_count", at_most=1.0), Bound("it moves", "rms"))
    return Advice("line", words, "", wanted, {}, {"frequency": (1.0, 2.0)}, ("periodic",), bounds)


def matter() -> Matter:
    """Return what is right beside what is not, of one matter."""
    return Matter("Model & numbers", "The *locus*.", ("eq-2.8",), "Its sign.", ("eq-2.9", "tab-5.1"))


def short() -> DerivationStep:
    """Return a step told in short, with a picture of its own."""
    drawn = _another(picture(), "short-picture")
    formulas = (Equation("a = b"), Equation(INTEGRAL, words="Loeb's rule, with *words*:"))
    return DerivationStep("short-relay", "Relay, in short", "Harmonic balance.", formulas, picture=drawn)


def sample() -> Document:
    """Return the report."""
    return Document(
        subject=dataclasses.replace(THESIS, title="The linear trimmer & its claims: 100 % of A_1 <checked>"),
        chapters=(
            Chapter("chapter-2", "2", "Modelling & method", chapter_two()),
            Chapter("chapter-5", "5", "Results", chapter_five()),
            Chapter("chapter-A", "A", "Listings", appendix_a()),
        ),
        statements_in_thesis=253,
        derivation=derivation(),
        figures=figures(),
        nomenclature=(
            NomenclatureRow("k_{1}", "stiffness between masses 1 and 2", "N/m", "kinetic"),
            NomenclatureRow(r"\dot{q}_{1}", f"velocity {SPECIAL}", "m/s"),
            NomenclatureRow("N", "describing function", "", "eq-2.37"),
        ),
        parameters=(
            ParameterRow("m_{1}", "mass of the pin", "3.1e-3", "kg"),
            ParameterRow("k_{5}", "stiffness of the flexure", "-1200", "N/m"),
        ),
        provenance=Provenance(
            "0.1.0",
            "0123abc",
            "2026-05-04T10:11:12+02:00",
            (("sympy", "1.14.0"), ("typst", "0.15.0")),
            BuildTime(61.7, "0.1.0"),
        ),
        text_copy=TextCopy(
            "0" * 64, 1200, "Trimmers & <b>play</b>", "Thesis", "A *company*", ("author", "appendix_C")
        ),
        programs=programs(),
        describing_functions=describing_functions(),
        solution=(DerivationStep("solved", "Solved", "With numbers.", (Equation("f = 733.63"),)),),
        step_of={"eq-2.9": "kinetic", "eq-2.37": "relay"},
        explorable=explorable(),
        spread=SPREAD,
        overview=Overview(opening(), answers(), corrected(), matters=(matter(),), short=(short(),)),
        sections=(
            ThesisSection("2.2.1", "Mechanism & masses"),
            ThesisSection("2.2.2", "Linear system", ("fig-2.3",)),
            ThesisSection("2.3.4", "Describing functions"),
            ThesisSection("5.1.1", "Transfer function", ("fig-5.1",)),
            ThesisSection("5.1.2", "Low-pass filter", ("fig-5.2",)),
        ),
    )
