"""A mechanism of numbers in symbols, with what they stand for and what code calls them."""

import math
from collections.abc import Mapping
from dataclasses import dataclass
from itertools import chain, count

import sympy
from sympy.core.function import AppliedUndef

from derivations import parts, symbols
from derivations.any_mechanism.contact_law import contact_statement
from derivations.latex_document import ValuedQuantity
from derivations.mechanism import Mechanism as SymbolicMechanism
from derivations.symbols import Quantity, Unit, t
from trimmer.in_symbols.printed_symbols import (
    WEIGHT,
    Place,
    PrintedSymbol,
    natural_order,
    plain_name,
    printed_symbols,
    value_of,
)
from trimmer.in_symbols.structure_symbols import DAMPING_RATIO, FREQUENCY
from trimmer.in_symbols.translation import Translation
from trimmer.mechanism.mechanism import Mechanism

UNITS = {unit.text: unit for unit in vars(symbols).values() if isinstance(unit, Unit)}
OF_MODES = (FREQUENCY, DAMPING_RATIO, "shape")
ARGUMENTS = (
    "mass",
    "inertia",
    "mobility",
    WEIGHT,
    *OF_MODES,
    "stiffness",
    "damping",
    "viscous",
    "gap",
    "side",
    "restitution",
)
"""What functions of a module take, in this order."""


@dataclass(frozen=True)
class SymbolsOfMechanism:
    """A mechanism in symbols, with what they stand for."""

    mechanism: SymbolicMechanism  # The mechanism; what is zero in numbers is left out
    quantities: tuple[ValuedQuantity, ...]  # All its symbols and functions of time, with their values
    # A name of Python for each symbol of its matrices and for each displacement of a body
    arguments: Mapping[sympy.Expr, str]


def symbolic_mechanism(mechanism: Mechanism) -> SymbolsOfMechanism:
    """Turn a mechanism of numbers into one of symbols.

    Symbols are those that its parts carry, and others like them; coefficients that are zero stay zero.
    """
    printed = printed_symbols(mechanism)
    translated = Translation(mechanism, printed).mechanism()
    occurring = _occurring(translated)
    return SymbolsOfMechanism(
        translated, _quantities(mechanism, printed, occurring), _arguments(printed, occurring)
    )


def _occurring(mechanism: SymbolicMechanism) -> set[sympy.Basic]:
    """Return the symbols and functions of time that the parts of a mechanism hold."""
    listed = (each for kind in vars(mechanism).values() for each in kind)
    values = (value for part in listed for value in vars(part).values() if isinstance(value, sympy.Basic))
    weights = [weight for point in mechanism.points for _, weight in point.weights]
    for each in mechanism.structures:
        weights += [
            entry for matrix in (each.mass, each.damping, each.stiffness, each.mobility) for entry in matrix
        ]
    slots = (each for each in mechanism.contacts if isinstance(each, parts.Contact))
    unused = {each.stretch for each in slots if not contact_statement(each).has_stretch}
    return set().union(*(value.atoms(sympy.Symbol, AppliedUndef) for value in (*values, *weights))) - unused


def _quantities(
    mechanism: Mechanism, printed: Mapping[Place, PrintedSymbol], occurring: set[sympy.Basic]
) -> tuple[ValuedQuantity, ...]:
    """Return the table of symbols: those of the parts in their order, then what has no part."""
    by_name = {_name(symbol): symbol for symbol in occurring}
    of_parts = (
        ValuedQuantity(
            Quantity(by_name[each.symbol], each.meaning, UNITS[each.unit]), value_of(mechanism, place)
        )
        for place, each in printed.items()
        if each.symbol in by_name
    )
    drive = Quantity(symbols.omega, "angular frequency of the drive", symbols.RADIAN_PER_SECOND)
    omega = 2 * math.pi * (mechanism.frequency or 0.0)
    return (
        *of_parts,
        *([ValuedQuantity(drive, omega)] if symbols.omega in occurring else []),
        ValuedQuantity(Quantity(t, "time", symbols.SECOND), None),
    )


def _arguments(printed: Mapping[Place, PrintedSymbol], occurring: set[sympy.Basic]) -> dict[sympy.Expr, str]:
    """Name the symbols of matrices, by kind and then by name, and the displacements of bodies."""
    by_name = {_name(symbol): symbol for symbol in occurring}
    found: dict[sympy.Expr, str] = {}
    for kind in (*ARGUMENTS, "coordinate"):
        listed = (each.symbol for (_, _, of), each in printed.items() if _is_kind(of, kind))
        for name in sorted(set(listed) & by_name.keys(), key=natural_order):
            plain, taken = plain_name(name), set(found.values())
            others = (f"{plain}_{number}" for number in count(2))
            found[by_name[name]] = next(each for each in chain((plain,), others) if each not in taken)
    return found


def _is_kind(of: str, kind: str) -> bool:
    return of.startswith(WEIGHT) if kind == WEIGHT else of == kind or of.startswith(f"{kind} ")


def _name(symbol: sympy.Basic) -> str:
    return symbol.func.__name__ if isinstance(symbol, AppliedUndef) else str(symbol)
