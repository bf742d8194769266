"""Generalised forces of contacts, dry frictions and given forces, from their virtual work."""

import sympy

from derivations.mechanism import Mechanism, displacement, elongation


def virtual_work(mechanism: Mechanism, displacements: tuple[sympy.Expr, ...]) -> sympy.Expr:
    """Return the work, J, of contacts, dry frictions and given forces over displacements of the bodies, m.

    A contact with the tension T does the work −T δs as its ends move apart by δs, a dry friction −f δs; a
    given force P does P δq at its place. Pins do not move in a virtual displacement.
    """
    moved = dict(zip((body.coordinate for body in mechanism.bodies), displacements, strict=True))
    works = (
        *(-contact.tension * _variation(elongation(contact), moved) for contact in mechanism.contacts),
        *(-friction.force * _variation(elongation(friction), moved) for friction in mechanism.frictions),
        *(force.value * _variation(displacement(force), moved) for force in mechanism.forces),
    )
    return sympy.Add(*works)


def generalised_forces(mechanism: Mechanism) -> tuple[sympy.Expr, ...]:
    """Return the generalised force Q_i of each coordinate, N: the factor of its virtual displacement."""
    displacements = tuple(sympy.Dummy(f"delta_{body.name}", real=True) for body in mechanism.bodies)
    work = virtual_work(mechanism, displacements)
    return tuple(sympy.diff(work, displacement) for displacement in displacements)


def _variation(length: sympy.Expr, moved: dict[sympy.Expr, sympy.Expr]) -> sympy.Expr:
    return sympy.Add(*(length.diff(coordinate) * change for coordinate, change in moved.items()))
