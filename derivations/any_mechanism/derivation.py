"""The whole derivation of any mechanism as one record, from energies to state space and contact laws."""

from dataclasses import dataclass

from derivations.any_mechanism.contact_law import ContactStatement, contact_statement
from derivations.any_mechanism.curve_law import CurveStatement, curve_statement
from derivations.any_mechanism.friction_law import FrictionStatement, friction_statement
from derivations.any_mechanism.wall_law import WallStatement, wall_statement
from derivations.linear_motion import SymbolicMotion, linear_motion
from derivations.mechanism import Mechanism, closed
from derivations.parts import Contact, CurvedSpring, Wall


@dataclass(frozen=True)
class MechanismDerivation:
    """All that follows from a declared mechanism."""

    motion: SymbolicMotion  # With the tensions of contacts and the dry forces of frictions as they come
    closed: SymbolicMotion  # With every contact closed; the same as ``motion`` where there is none
    contacts: tuple[ContactStatement, ...]  # The law of each contact
    frictions: tuple[FrictionStatement, ...]  # The law of each friction
    curves: tuple[CurveStatement, ...]  # The law of each spring with a curve
    walls: tuple[WallStatement, ...]  # The law of each wall

    @property
    def mechanism(self) -> Mechanism:
        """The mechanism that is derived."""
        return self.motion.mechanism


def derive_mechanism(mechanism: Mechanism) -> MechanismDerivation:
    """Derive a mechanism, and check each set of equations by Newton's law and by its power balance.

    Raises:
        UnprovenError: if a check fails; the message names it.
        ValueError: if the equations of motion are not linear.
    """
    motion = linear_motion(mechanism)
    return MechanismDerivation(
        motion=motion,
        closed=linear_motion(closed(mechanism)) if closed(mechanism) != mechanism else motion,
        contacts=tuple(contact_statement(each) for each in mechanism.contacts if isinstance(each, Contact)),
        frictions=tuple(friction_statement(mechanism, friction) for friction in mechanism.frictions),
        curves=tuple(curve_statement(each) for each in mechanism.contacts if isinstance(each, CurvedSpring)),
        walls=tuple(wall_statement(mechanism, each) for each in mechanism.contacts if isinstance(each, Wall)),
    )
