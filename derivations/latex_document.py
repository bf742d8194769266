"""The LaTeX documents that ``trimmer derive`` writes: of the thesis's trimmer, and of any mechanism."""

from collections.abc import Callable
from dataclasses import dataclass

from derivations.any_mechanism.checks import mechanism_checks
from derivations.any_mechanism.derivation import MechanismDerivation
from derivations.any_mechanism.narrative import mechanism_narrative
from derivations.dimension_checks import require_consistent
from derivations.elements.quantities import ELEMENT_QUANTITIES
from derivations.latex import latex, latex_number, latex_prose, latex_text
from derivations.linear_trimmer import LinearTrimmer
from derivations.loop.narrative import loop_narrative
from derivations.narrative import narrative
from derivations.step import Formula, NarrativeStep
from derivations.symbols import QUANTITIES, Quantity

PREAMBLE = r"""\documentclass[11pt,a4paper]{article}
\usepackage[margin=20mm]{geometry}
\usepackage{amsmath}
\usepackage{breqn}
\setcounter{MaxMatrixCols}{20}
\title{The trimmer: derivation}
\author{}
\date{}
\begin{document}
\maketitle
Numbers at the right are those of the same equation in the thesis.
"""
MECHANISM_PREAMBLE = r"""\documentclass[11pt,a4paper]{article}
%% Derived from a mechanism by `trimmer derive`.
\usepackage[margin=20mm]{geometry}
\usepackage{amsmath}
\usepackage{graphicx}
\usepackage{longtable}
\usepackage{breqn}
\setcounter{MaxMatrixCols}{%d}
\newcommand{\fitted}{\ifdim\width>\linewidth\linewidth\else\width\fi}
\title{%s: derivation}
\author{}
\date{}
\begin{document}
\maketitle
SI units throughout; the last section lists all symbols with their values.
"""
END = "\\end{document}\n"


def latex_document(derivation: LinearTrimmer, elements: tuple[NarrativeStep, ...]) -> str:
    """Return the derivation of the linear trimmer, of its elements and of their loop as a LaTeX document.

    Added is the nomenclature.

    Args:
        derivation: The linear trimmer.
        elements: Steps of the derivation of the describing functions.

    Raises:
        DimensionError: if a derived equation is not consistent in its dimensions.
        ValueError: if the power balance does not hold.
    """
    linear = (_section(step) for step in narrative(derivation))
    nonlinear = (_section(step) for step in elements)
    return "\n".join(
        (
            PREAMBLE,
            "\\part{The linear trimmer}",
            *linear,
            "\\part{The describing functions}",
            *nonlinear,
            "\\part{The loop}",
            *(_section(step) for step in loop_narrative(derivation)),
            _nomenclature(),
            END,
        )
    )


@dataclass(frozen=True)
class ValuedQuantity:
    """A quantity of a mechanism for its table of symbols."""

    quantity: Quantity  # Symbol, meaning and unit
    value: float | None  # Its number in that unit; None for a function of time


def mechanism_document(
    derivation: MechanismDerivation, title: str, quantities: tuple[ValuedQuantity, ...]
) -> str:
    """Return the derivation of a mechanism as a LaTeX document, with a table of its symbols.

    Args:
        derivation: The derivation.
        title: What the mechanism is, in plain words.
        quantities: All that the equations hold.

    Raises:
        DimensionError: if a derived equation is not consistent in its dimensions.
    """
    require_consistent(mechanism_checks(derivation, tuple(each.quantity for each in quantities)))
    widest = max(matrix.cols for matrix in (derivation.motion.space.a, derivation.motion.space.b))
    preamble = MECHANISM_PREAMBLE % (max(20, widest), latex_text(title))
    steps = (_section(step, _fitted) for step in mechanism_narrative(derivation))
    return "\n".join((preamble, *steps, _table_of_values(quantities), END))


def _table_of_values(quantities: tuple[ValuedQuantity, ...]) -> str:
    rows = (
        f"${latex(each.quantity.symbol)}$ & {latex_text(each.quantity.meaning)} & "
        f"{'' if each.value is None else latex_number(each.value)} & {each.quantity.unit.text} \\\\"
        for each in quantities
    )
    head = ("\\section{Symbols}", "\\begin{longtable}{llll}", "symbol & meaning & value & unit \\\\ \\hline")
    return "\n".join((*head, *rows, "\\end{longtable}\n"))


def _section(step: NarrativeStep, displayed: Callable[[Formula], str] | None = None) -> str:
    head = (f"\\section{{{latex_text(step.title)}}}", latex_prose(step.text))
    return "\n".join((*head, *map(displayed or _displayed, step.formulas)))


def _displayed(formula: Formula) -> str:
    return "\n".join(filter(None, (formula.words, _equation(formula))))


def _equation(formula: Formula) -> str:
    if r"\begin{" in formula.latex or r"\dots" in formula.latex:
        tag = f" \\tag{{{formula.thesis}}}" if formula.thesis else ""
        body = f"\\[ {formula.latex}{tag} \\]"
        return f"{{\\small {body}}}" if formula.latex.count("&") > 30 else body
    number = f"[number={{{formula.thesis}}}]" if formula.thesis else ""
    environment = "dmath" if formula.thesis else "dmath*"
    return f"\\begin{{{environment}}}{number}\n{formula.latex}\n\\end{{{environment}}}"


def _fitted(formula: Formula) -> str:
    """Return a formula, made smaller where a matrix or cases would leave the line."""
    if r"\begin{" not in formula.latex:
        return _displayed(formula)
    return f"\\[ \\resizebox{{\\fitted}}{{!}}{{$\\displaystyle {formula.latex}$}} \\]"


def _nomenclature() -> str:
    rows = (
        f"${latex(quantity.symbol)}$ & {quantity.meaning} & {quantity.unit.text} \\\\"
        for quantity in QUANTITIES + ELEMENT_QUANTITIES
    )
    return (
        "\n".join(
            (
                "\\section{Nomenclature}",
                "\\begin{tabular}{lll}",
                "symbol & meaning & unit \\\\ \\hline",
                *rows,
            )
        )
        + "\n\\end{tabular}\n"
    )
