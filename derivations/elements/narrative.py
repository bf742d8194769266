"""The derivation of the describing functions step by step, with a proof of each closed form."""

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
    textbook,
)
from derivations.step import NarrativeStep


def proven_steps() -> tuple[ProvenStep, ...]:
    """Return the steps, in their order, with the equalities that are to be proven.

    Raises:
        UnprovenError: if an antiderivative is wrong or a waveform is not half-wave odd.
        DimensionError: if the units of the equivalent nonlinearity are not those that its step states.
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
def textbook_narrative() -> tuple[NarrativeStep, ...]:
    """Prove every equation on the elements that the thesis does not have, and return the steps.

    Raises:
        UnprovenError: naming the first equation that is not proven.
    """
    return tuple(step.proven() for step in textbook.steps())


@cache
def element_narrative() -> tuple[NarrativeStep, ...]:
    """Prove every equation and return the steps for report and LaTeX; some seconds, so the result is kept.

    Raises:
        UnprovenError: naming the first equation that is not proven.
        DimensionError: if the units of the equivalent nonlinearity are not those that its step states.
    """
    return tuple(step.proven() for step in proven_steps())
