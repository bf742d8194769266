"""The LaTeX document that ``trimmer derive`` writes: both derivations, coefficients and nomenclature."""

from __future__ import annotations

import re

from derivations.elements.quantities import ELEMENT_QUANTITIES
from derivations.latex import latex
from derivations.linear_trimmer import LinearTrimmer
from derivations.narrative import CUTTER, GUARD, Formula, Step, narrative
from derivations.symbols import QUANTITIES

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
END = "\\end{document}\n"


def latex_document(derivation: LinearTrimmer, elements: tuple[Step, ...]) -> str:
    """Return the derivation of the linear trimmer and that of its elements as a LaTeX document.

    Added are all coefficients of the transfer function and the nomenclature.

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
            _all_coefficients(derivation),
            "\\part{The describing functions}",
            *nonlinear,
            _nomenclature(),
            END,
        )
    )


def _section(step: Step) -> str:
    text = re.sub(r"`([^`]*)`", r"\\texttt{\1}", step.text)
    return "\n".join((f"\\section{{{step.title}}}", text, *map(_displayed, step.formulas)))


def _displayed(formula: Formula) -> str:
    if r"\begin{" in formula.latex or r"\dots" in formula.latex:
        tag = f" \\tag{{{formula.thesis}}}" if formula.thesis else ""
        body = f"\\[ {formula.latex}{tag} \\]"
        return f"{{\\small {body}}}" if formula.latex.count("&") > 30 else body
    number = f"[number={{{formula.thesis}}}]" if formula.thesis else ""
    environment = "dmath" if formula.thesis else "dmath*"
    return f"\\begin{{{environment}}}{number}\n{formula.latex}\n\\end{{{environment}}}"


def _all_coefficients(derivation: LinearTrimmer) -> str:
    transfer = derivation.transfer
    rows = zip(transfer.from_displacement[CUTTER], transfer.from_displacement[GUARD], strict=True)
    output = [cutter - guard for cutter, guard in rows]
    lines = ["\\section{All coefficients of the transfer function}"]
    for name, coefficients in (("b", output), ("a", list(transfer.denominator))):
        highest = len(coefficients) - 1
        lines += [
            _displayed(Formula(f"{name}_{{{highest - drop}}} = {latex(coefficient)}"))
            for drop, coefficient in enumerate(coefficients)
        ]
    return "\n".join(lines)


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
