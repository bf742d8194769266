"""From data to derivations and to code.

A mechanism of numbers becomes one of symbols; what is derived from it becomes a module of plain Python
functions and a LaTeX document. The module of the thesis's trimmer is committed, so that a change of a formula
shows up as a readable difference.
"""

from dataclasses import dataclass

from derivations.any_mechanism.derivation import derive_mechanism
from derivations.any_mechanism.numeric_module import numeric_module
from derivations.elements.narrative import element_narrative
from derivations.latex_document import latex_document, mechanism_document
from derivations.linear_trimmer import derive_linear_trimmer
from derivations.mechanism import trimmer
from derivations.symbols import PARAMETERS, coordinates
from trimmer.in_symbols.mechanism import symbolic_mechanism
from trimmer.mechanism.mechanism import Mechanism


@dataclass(frozen=True)
class DerivedSources:
    """What `trimmer derive` writes: the source of a numeric module, and a LaTeX document."""

    module: str
    latex: str


def derive_sources() -> DerivedSources:
    """Derive the linear trimmer as Python source and as LaTeX, and the describing functions as LaTeX."""
    named = (*(quantity.symbol for quantity in PARAMETERS), *coordinates)
    arguments = {symbol: str(symbol).removesuffix("(t)").replace("_", "") for symbol in named}
    return DerivedSources(
        module=numeric_module("Linear trimmer", derive_mechanism(trimmer()), arguments),
        latex=latex_document(derive_linear_trimmer(), element_narrative()),
    )


def derive_mechanism_sources(mechanism: Mechanism) -> DerivedSources:
    """Derive a mechanism as Python source and as LaTeX."""
    symbolic = symbolic_mechanism(mechanism)
    derivation = derive_mechanism(symbolic.mechanism)
    title = mechanism.title or "Mechanism"
    return DerivedSources(
        module=numeric_module(title, derivation, symbolic.arguments),
        latex=mechanism_document(derivation, title, symbolic.quantities),
    )
