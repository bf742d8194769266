"""The exact motion of whatever may move: a mechanism or a loop."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from threading import get_ident
from typing import TYPE_CHECKING

from trimmer.arguments import require_instance
from trimmer.errors import UnsupportedMotionError
from trimmer.mechanism import Mechanism, RampReference
from trimmer.mechanism.place_text import place_text

if TYPE_CHECKING:
    from trimmer.contact.flow import MechanismFlow
    from trimmer.motion.flow import Flow
    from trimmer.motion.subject import Subject

KEPT = 2  # Subjects whose flows are kept, for who asks again
MOST_KEPT = 2**24  # Memory of the tables of a step, bytes, up to which a flow is given again


def flow_of(subject: Subject) -> Flow:
    """Return the motion of a mechanism, in the frame in which it repeats, or of a loop."""
    if isinstance(subject, Mechanism):
        from trimmer.contact.flow import MechanismFlow

        require_no_profile(subject)
        flow = MechanismFlow.returning(subject)
        _require_carried(subject, flow)
        return flow
    from trimmer.loops.flow import LoopFlow
    from trimmer.loops.loops import Loop

    require_subject(subject)
    assert isinstance(subject, Loop)
    if not subject.repeats:
        raise UnsupportedMotionError(
            "the drives have no period in common, so that no motion repeats with them; simulate() follows it"
        )
    return LoopFlow(subject)


@dataclass(frozen=True, eq=False)
class _Same:
    """A subject that equals itself alone."""

    subject: Subject

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _Same) and other.subject is self.subject

    def __hash__(self) -> int:
        return id(self.subject)


@lru_cache(maxsize=KEPT)
def _kept_flow(same: _Same, thread: int) -> Flow:
    return flow_of(same.subject)


def known_flow_of(subject: Subject) -> Flow:
    """Return the same as ``flow_of``; of a subject that was asked for last, with the modes that it has met.

    Modes are added to it, so that each thread has one of its own. One that has met many is not given again:
    the memory for their tables is bounded.
    """
    flow = _kept_flow(_Same(subject), get_ident())
    tables = flow.modes.tables
    is_small = tables.rows is None and tables.screen.nbytes + tables.series.nbytes <= MOST_KEPT
    return flow if is_small else flow_of(subject)


def require_no_profile(mechanism: Mechanism) -> None:
    """Check that no force of a mechanism follows a profile, with which nothing repeats.

    Raises:
        UnsupportedMotionError: if one does; it is named.
    """
    for name, force in mechanism.forces.items():
        if force.profile:
            place = ("forces", name, "profile")
            raise UnsupportedMotionError(
                f"{place_text(place)}: the force follows times, with which nothing "
                "repeats; 'trimmer simulate' follows it, or leave it out",
                place=place,
            )


def _require_carried(mechanism: Mechanism, flow: MechanismFlow) -> None:
    """Check that what follows a ramp can go on with it.

    Raises:
        UnsupportedMotionError: if something else holds it.
    """
    for name, controller in mechanism.controllers.items():
        reference = mechanism.references.get(controller.reference or "")
        if isinstance(reference, RampReference) and reference.ramp and flow.modes.system.layout.frame.pulled:
            place = ("controllers", name, "reference")
            raise UnsupportedMotionError(
                f"{place_text(place)}: what is measured cannot go on with the "
                f"ramp {controller.reference!r}, since shifting it changes another force; "
                "'trimmer simulate' follows it",
                place=place,
            )


def called(subject: Subject) -> str:
    """Return what a sentence calls what moves: a mechanism or a loop."""
    return "mechanism" if isinstance(subject, Mechanism) else "loop"


def is_silent(subject: Subject) -> bool:
    """Say whether nothing happens where something begins, whatever it does from elsewhere: a loop at rest."""
    without_drive = not isinstance(subject, Mechanism) and subject.frequency is None
    return without_drive and not getattr(subject, "start", None)


def searched(loop: Subject) -> str:
    """Return what is looked for in a loop at rest, in words."""
    leads = ", and what they lead to with friction" if getattr(loop, "frictions", ()) else ""
    return (
        f"the stable orbits that are found near predictions of harmonic balance or by simulation{leads}; "
        "where none is, how simulations end, if there were any"
    )


def require_subject(subject: object) -> None:
    """Check that something was given that moves.

    Raises:
        WrongTypeError: if it was not.
    """
    from trimmer.loops.loops import Loop

    kinds = "a trimmer.Mechanism or a loop: a ClosedLoop, OpenLoop, Feedback or TrimmerLoop"
    require_instance("mechanism", subject, (Mechanism, Loop), kinds)
