"""The nomenclature: every symbol with its meaning, its unit, and the place where it stands first.

Symbols that the derivations declare bring meaning and unit along; the others stand in
``report/data/nomenclature.csv``. A letter with two meanings has a line for each.
"""

import csv
import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

from derivations.elements.quantities import ELEMENT_QUANTITIES
from derivations.latex import latex
from derivations.step import NarrativeStep
from derivations.symbols import QUANTITIES
from report.judging.finding import Finding
from report.pages.derivation import NomenclatureRow
from trimmer.errors import TrimmerError

_GREEK = (
    "alpha|beta|gamma|delta|epsilon|varepsilon|zeta|eta|theta|kappa|lambda|mu|nu|xi|pi|rho|sigma|tau|phi|"
    "varphi|chi|psi|omega|Gamma|Delta|Theta|Lambda|Sigma|Phi|Psi|Omega|ell"
)
_WORDS = re.compile(
    r"\\(?:text|operatorname|mathrm|mathsf|mathit)\*?\{[^{}]*\}"
    r"|\\(?:begin|end)\{[^{}]*\}(?:\{[^{}]*\})?"
)
_ACCENT = re.compile(r"\\(?:dot|ddot|dddot|bar|overline|hat|tilde)(?:\{([^{}]*)\}|\s+([A-Za-z]))")
_COMMAND = re.compile(rf"\\(?!(?:{_GREEK})(?![A-Za-z]))[A-Za-z]+")
_INDEX = r"\{[^{}]*\}|[A-Za-z0-9]|\\[A-Za-z]+"
_SYMBOL = re.compile(rf"(\\(?:{_GREEK})(?![A-Za-z])|(?<![\\A-Za-z])[A-Za-z])(?:_({_INDEX}))?")
_MATHEMATICS = re.compile(r"\$([^$]+)\$")


def symbols(latex: str) -> frozenset[str]:
    """Return the symbols of a formula, such as ``q_2``; an index loses its braces."""
    plain = _WORDS.sub(" ", latex)
    while (without := _ACCENT.sub(lambda match: f" {match[1] or match[2]}", plain)) != plain:
        plain = without
    plain = _COMMAND.sub(lambda match: " " * len(match[0]), plain)
    return frozenset(
        letter + (f"_{index.strip('{}').replace(' ', '')}" if index else "")
        for letter, index in _SYMBOL.findall(plain)
    )


def formulas(prose: str) -> Iterator[str]:
    """Yield the formulas between dollar signs in Markdown prose."""
    yield from _MATHEMATICS.findall(prose)


PATH = Path(__file__).parent.parent / "data" / "nomenclature.csv"


class NomenclatureError(TrimmerError, ValueError):
    """A symbol of the nomenclature is said to stand where it does not."""


@dataclass(frozen=True)
class Entry:
    """A line of the nomenclature before its place is found."""

    symbol: str  # LaTeX
    meaning: str  # In words
    unit: str  # SI unit as plain text; empty where it depends on the place
    covers: frozenset[str]  # The symbols as they stand in formulas that the line explains
    # Id of the step or claim that has it first; empty where it is the first that holds the symbol
    first: str = ""


def entries(path: Path = PATH) -> tuple[Entry, ...]:
    """Return all lines: those of the derivations, then the further ones, in the order of their file."""
    with path.open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    placed = {row["symbol"]: row["first"] for row in rows if not row["meaning"]}
    declared = (
        Entry(name, quantity.meaning, quantity.unit.text, symbols(name), placed.get(name, ""))
        for quantity in QUANTITIES + ELEMENT_QUANTITIES
        for name in (latex(quantity.symbol),)
    )
    further = (
        Entry(
            row["symbol"],
            row["meaning"],
            row["unit"],
            frozenset(row["covers"].split()) | symbols(row["symbol"]),
            row["first"],
        )
        for row in rows
        if row["meaning"]
    )
    return (*declared, *further)


def symbols_of_step(step: NarrativeStep) -> frozenset[str]:
    """Return all symbols in the prose and the formulas of a step."""
    prose = (step.text, *(each.words for each in step.formulas))
    inline = (formula for text in prose for formula in formulas(text))
    return frozenset().union(*map(symbols, (*inline, *(each.latex for each in step.formulas))))


def symbols_of_finding(finding: Finding) -> frozenset[str]:
    """Return all symbols in the prose and the formulas of a card."""
    sides = (str(side) for part in finding.parts for side in (part.printed, part.derived))
    prose = (finding.explanation, finding.consequence, *(part.label for part in finding.parts))
    inline = (formula for text in prose for formula in formulas(text))
    return frozenset().union(*map(symbols, (*inline, *sides)))


def nomenclature(steps: Iterable[NarrativeStep], findings: Iterable[Finding]) -> tuple[NomenclatureRow, ...]:
    """Return the rows with their places, in the order of the alphabet, Greek letters last.

    A symbol that stands in no step and on no card is left out.

    Raises:
        NomenclatureError: naming a symbol that is said to stand in a step which does not hold it.
    """
    of_steps = {step.id: symbols_of_step(step) for step in steps}
    of_cards = {finding.id: symbols_of_finding(finding) for finding in findings}
    rows = []
    for entry in sorted(entries(), key=_alphabetically):
        if entry.first in of_steps and not of_steps[entry.first] & entry.covers:
            raise NomenclatureError(f"{entry.symbol} ({entry.meaning}) does not stand in {entry.first}")
        place = entry.first or _first(entry, of_steps | of_cards)
        if place in of_steps or place in of_cards:
            rows.append(NomenclatureRow(entry.symbol, entry.meaning, entry.unit, place))
    return tuple(rows)


def _first(entry: Entry, held: Mapping[str, frozenset[str]]) -> str:
    return next((place for place, symbols_there in held.items() if symbols_there & entry.covers), "")


def _alphabetically(entry: Entry) -> tuple[bool, str, str]:
    name = entry.symbol.lstrip("\\")
    return entry.symbol.startswith("\\"), name.lower().replace("{", "").replace("}", ""), name
