"""The laws of plays and stops: what the force of a contact is, as statements beside the equations.

With s the displacement of ``end`` less that of ``start``, the spring and the damper behind the slot are
stretched by z and carry T = k z + c ż. Source of the relaxing law: Nordin, Galić and Gutman, Int. J. Adapt.
Control Signal Process. 11, 1997.
"""

from dataclasses import dataclass

import sympy

from derivations.algebra.unevaluated import product, total
from derivations.mechanism import elongation
from derivations.parts import Contact, ContactLaw, Play
from derivations.symbols import t


@dataclass(frozen=True)
class ContactStatement:
    """The law of one contact."""

    contact: Contact  # The contact
    distance: sympy.Expr  # s in the coordinates of bodies and pins, m
    stretch: sympy.Expr | None  # z as a function of s, m; None where z is a state of its own, or is not used
    stretch_rate: sympy.Expr | None  # ż as a function of s, ṡ and z, m/s; None where z is no state
    tension: sympy.Expr  # T, N, as a function of s and ṡ, or of z and ż

    @property
    def has_stretch(self) -> bool:
        """Whether z occurs in it."""
        return self.stretch is not None or self.stretch_rate is not None


def contact_statement(contact: Contact) -> ContactStatement:
    """State the law of a contact. Without damping the three laws are one, the dead zone."""
    distance, stretch = elongation(contact), contact.stretch
    if contact.damping == 0:
        spring = contact.stiffness * stretch
        return ContactStatement(contact, distance, _undamped_stretch(contact), None, spring)
    match contact.law:
        case ContactLaw.RELAXING:
            force = total(contact.stiffness * stretch, contact.damping * stretch.diff(t))
            return ContactStatement(contact, distance, None, _relaxing_rate(contact), force)
        case ContactLaw.TRUNCATED:
            return ContactStatement(contact, distance, None, None, _force_by_side(contact, pulls=False))
        case ContactLaw.PULLING:
            return ContactStatement(contact, distance, None, None, _force_by_side(contact, pulls=True))


def _undamped_stretch(contact: Contact) -> sympy.Expr:
    """Return z = s less what is free: the dead zone."""
    s, (ahead, behind) = contact.distance, _sides(contact)
    cases = [(total(s, -ahead), _above(s, ahead))]
    if behind is not None:
        cases.append((total(s, -behind), _below(s, behind)))
    return _cases(*cases, (sympy.S.Zero, sympy.true))


def _relaxing_rate(contact: Contact) -> sympy.Expr:
    """Return ż: that of s in contact, unless the spring relaxes away from the side of the slot.

    The force at the side ahead, T = k z + c ṡ, does not pull as long as ṡ is not below the rate −(k/c) z at
    which the spring relaxes, so the greater of the two rates is that of z; behind it is the smaller one.
    """
    s, z = contact.distance, contact.stretch
    ahead, behind = _sides(contact)
    if behind is not None and contact.gap == 0:
        return s.diff(t)
    approach, relaxing = s.diff(t), -contact.stiffness / contact.damping * z
    cases = [(sympy.Max(approach, relaxing), sympy.Ge(total(s, -z), ahead, evaluate=False))]
    if behind is not None:
        cases.append((sympy.Min(approach, relaxing), sympy.Le(total(s, -z), behind, evaluate=False)))
    return _cases(*cases, (relaxing, sympy.true))


def _force_by_side(contact: Contact, pulls: bool) -> sympy.Expr:
    """Return T outside the gap, cut off at zero where it must not pull."""
    s, (ahead, behind) = contact.distance, _sides(contact)
    cases = [(_pressed(contact, ahead, None if pulls else sympy.Max), _above(s, ahead))]
    if behind is not None:
        cases.append((_pressed(contact, behind, None if pulls else sympy.Min), _below(s, behind)))
    return _cases(*cases, (sympy.S.Zero, sympy.true))


def _pressed(contact: Contact, side: sympy.Expr, cut: type[sympy.Expr] | None) -> sympy.Expr:
    force = total(
        product(contact.stiffness, total(contact.distance, -side)), contact.damping * contact.distance.diff(t)
    )
    return force if cut is None else cut(sympy.S.Zero, force)


def _sides(contact: Contact) -> tuple[sympy.Expr, sympy.Expr | None]:
    """Return the distances at which contact begins, m: ahead, and behind where there is such a side."""
    if isinstance(contact, Play):
        return contact.gap / 2, -contact.gap / 2
    return contact.gap, None


def _above(distance: sympy.Expr, side: sympy.Expr) -> sympy.Basic:
    return sympy.Gt(distance, side, evaluate=False)


def _below(distance: sympy.Expr, side: sympy.Expr) -> sympy.Basic:
    return sympy.Lt(distance, side, evaluate=False)


def _cases(*cases: tuple[sympy.Expr, sympy.Basic]) -> sympy.Expr:
    """Return a piecewise function whose conditions stay as they are written."""
    return sympy.Piecewise(*cases, evaluate=False)
