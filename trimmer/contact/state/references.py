"""References of controllers over time: which of them force the states by times, and which as the waves do."""

from collections.abc import Iterator
from dataclasses import replace

from trimmer.contact.state.frame import Frame
from trimmer.contact.state.profiles import Profile
from trimmer.mechanism import Mechanism, Reference
from trimmer.mechanism.controls.references import ProfileReference, RampReference, StepReference


def references_in(mechanism: Mechanism) -> Iterator[Reference]:
    """Yield the references that controllers follow."""
    names = (each.reference for each in mechanism.controllers.values())
    return (mechanism.references[name] for name in dict.fromkeys(names) if name is not None)


def profile_of(reference: Reference, frame: Frame) -> Profile | None:
    """Return a reference that changes at times; None for a constant, a wave, or a ramp of a frame."""
    match reference:
        case StepReference(step, at) if at > 0:
            return Profile(((at, step),))
        case RampReference(ramp, at) if not (frame.follows or frame.velocities.any()):
            return Profile(((at, 0.0),), slope=ramp)
        case ProfileReference(points):
            return Profile(points, before=points[0][1])
    return None


def settled_references(mechanism: Mechanism) -> Mechanism:
    """Return a mechanism whose references that change by times have their last values from the start."""
    last: dict[str, Reference] = {}
    for name, reference in mechanism.references.items():
        match reference:
            case StepReference(step, at) if at > 0:
                last[name] = StepReference(step)
            case ProfileReference(points):
                last[name] = StepReference(points[-1][1])
    return replace(mechanism, references={**mechanism.references, **last}) if last else mechanism
