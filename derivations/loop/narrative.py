"""The steps about the loop, in their order, every equation proven."""

from derivations.linear_trimmer import LinearTrimmer
from derivations.loop.dissipation import dissipation_step
from derivations.loop.harmonic_balance import balance_step, solution_step
from derivations.loop.loeb import loeb_step
from derivations.step import NarrativeStep


def loop_narrative(trimmer: LinearTrimmer) -> tuple[NarrativeStep, ...]:
    """Return harmonic balance, its solution, Loeb's rule and the proof of dissipation.

    Raises:
        UnprovenError: if an equation is not proven.
    """
    told = (balance_step(), solution_step(), loeb_step())
    return (*(step.proven() for step in told), dissipation_step(trimmer))
