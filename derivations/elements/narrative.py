"""The derivation of the describing functions told step by step, each closed form proven as it is told."""

from __future__ import annotations

from functools import cache

from derivations.elements.proven_step import ProvenStep
from derivations.elements.steps import (
    contours,
    equivalent,
    friction,
    general_backlash,
    limiting_backlash,
    limits,
    method,
    slopes,
)
from derivations.narrative import Step


def proven_steps() -> tuple[ProvenStep, ...]:
    """Return the steps with what they have to prove.

    Raises:
        UnprovenError: if an antiderivative is wrong or a waveform is not half-wave odd.
        DimensionError: if the units of the equivalent nonlinearity are not as told.
    """
    return (
        method.step(),
        friction.relay(),
        friction.coulomb_friction(),
        friction.viscous_friction(),
        limiting_backlash.friction_backlash(),
        limiting_backlash.inertia_backlash(),
        general_backlash.motion(),
        general_backlash.describing_function(),
        limits.step(),
        slopes.step(),
        contours.step(),
        equivalent.step(),
    )


@cache
def element_narrative() -> tuple[Step, ...]:
    """Prove and tell every step.

    Raises:
        UnprovenError: naming the first equation that is not proven.
        DimensionError: if the units of the equivalent nonlinearity are not as told.
    """
    return tuple(step.tell() for step in proven_steps())
