"""The equations of a mechanism, from its derivation."""

from derivations.any_mechanism.derivation import derive_mechanism
from derivations.any_mechanism.narrative import mechanism_narrative
from derivations.latex import latex
from derivations.latex_document import ValuedQuantity
from derivations.step import NarrativeStep
from report.design.quantities import shown
from report.design.report import Equations, SymbolRow
from report.pages.derivation import DerivationStep
from report.pages.figure import Equation
from trimmer.in_symbols.mechanism import symbolic_mechanism
from trimmer.mechanism.mechanism import Mechanism

FIRST = ("parts", "closed-contact")
"""Steps that a designer wants; without a contact, the equations of motion in place of the second."""


def equations_of(mechanism: Mechanism) -> Equations:
    """Derive a mechanism, with the checks of the derivation.

    Raises:
        MechanismError: if two symbols of its parts print the same.
        UnprovenError: if a check fails.
    """
    symbolic = symbolic_mechanism(mechanism)
    steps = mechanism_narrative(derive_mechanism(symbolic.mechanism))
    names = {step.id for step in steps}
    wanted = FIRST if "closed-contact" in names else ("parts", "motion")
    first = [each for each in steps if each.id in wanted or each.id.startswith(("contact-", "friction-"))]
    rest = [each for each in steps if each not in first]
    symbols = tuple(map(_row, symbolic.quantities))
    shown = [_shown(step, number) for number, step in enumerate((*first, *rest), start=1)]
    return Equations(tuple(shown[: len(first)]), tuple(shown[len(first) :]), symbols)


def _row(valued: ValuedQuantity) -> SymbolRow:
    quantity = valued.quantity
    value = "" if valued.value is None else shown(valued.value, quantity.unit.text, 6)
    return SymbolRow(latex(quantity.symbol), quantity.meaning, value or quantity.unit.text)


def _shown(step: NarrativeStep, number: int) -> DerivationStep:
    """Return a step for the page, where its place has a number: its own name may hold that of a part."""
    equations = tuple(Equation(each.latex, "", each.words) for each in step.formulas)
    return DerivationStep(str(number), step.title, step.text, equations)
