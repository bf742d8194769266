"""The kept branches of the thesis's loop, what is simulated from them, and their end in a second way."""

from collections import Counter
from dataclasses import dataclass
from typing import Final

import numpy as np

from report.numbers.friction_in_place import FrictionCycle
from report.numbers.independent.loop_with_friction import largest_friction
from report.numbers.thesis import LARGE_GAP
from report.numbers.twin.closed_loop import FILE, LOOP_COURSES, thesis_loop
from report.numbers.twin.kept_branch import KeptBranch, read_branches
from trimmer import TrimmerLoop, TrimmerParameters, simulate
from trimmer.loops import LoopMotion

SIMULATED: Final = 10  # Every so many kept orbits one is simulated
BESIDE: Final = 0.01  # How far below and above the largest friction two motions are released, relative
DURATION: Final = 0.5  # Length of these motions, s
AROUND: Final = (690.0, 715.0)  # Range of frequencies with the largest friction in it, Hz


@dataclass(frozen=True, eq=False)
class FrictionLoopNumbers:
    """Limit cycles of the thesis's loop with friction between cutter and guard."""

    over_force: KeptBranch  # Kept branch over the friction, for a gap of 40 µm
    over_gap: tuple[KeptBranch, ...]  # Kept branches over the gap, by rising friction
    miss: float  # How far orbits are from their start after a period, at most, relative to the largest states
    # Numbers of events by kind that a period of these orbits has
    events: frozenset[tuple[tuple[str, int], ...]]
    largest: FrictionCycle  # The limit cycle with the largest friction per gap, in a second way
    # Half of peak to peak over 40 µm that is left of a stable limit cycle after ``DURATION``, with friction
    # ``BESIDE`` below the largest one
    left_below: float
    left_above: float  # The same with friction above it

    @property
    def all(self) -> tuple[KeptBranch, ...]:
        """All branches."""
        return (self.over_force, *self.over_gap)

    @property
    def largest_force(self) -> float:
        """Friction at the fold, for a gap of 40 µm, N."""
        (fold,) = self.over_force.special_of("fold")
        return fold


def solve_loop() -> FrictionLoopNumbers:
    """Read the branches, and simulate some of their orbits.

    Raises:
        KeptDataError: if the file is missing, was changed, or was made from something else.
    """
    over_force, *over_gap = branches = read_branches(LOOP_COURSES, FILE)
    chosen = [(each, at) for each in branches for at in range(0, len(each.values), SIMULATED)]
    found = [_period(*each) for each in chosen]
    (fold,) = over_force.special_of("fold")
    return FrictionLoopNumbers(
        over_force=over_force,
        over_gap=tuple(over_gap),
        miss=max(miss for _, miss in found),
        events=frozenset(
            tuple(sorted(Counter(each.kind.value for each in motion.events).items())) for motion, _ in found
        ),
        largest=largest_friction(TrimmerParameters.thesis(), *AROUND),
        left_below=_left(over_force, (1 - BESIDE) * fold),
        left_above=_left(over_force, (1 + BESIDE) * fold),
    )


def _period(branch: KeptBranch, at: int) -> tuple[LoopMotion, float]:
    """Return a period of a kept orbit, and how far it is from its start at the end."""
    *state, load, single = branch.states[at]
    loop = branch.course.subject.with_value(branch.course.place, float(branch.values[at]))
    assert isinstance(loop, TrimmerLoop)
    period = branch.periods * single
    motion = simulate(loop, period, initial_state=state, element_output=load)
    return motion, float(abs(motion.state(period) - state).max() / abs(branch.states[at][:-2]).max())


def _left(branch: KeptBranch, force: float) -> float:
    """Return what is left of the stable limit cycle of less friction at the end of a motion, in gaps."""
    (fold,) = branch.special_of("fold")
    at = int(np.flatnonzero(branch.stable & (branch.values < (1 - BESIDE) * fold)).max())
    *state, load, single = branch.states[at]
    motion = simulate(thesis_loop(LARGE_GAP, force), DURATION, initial_state=state, element_output=load)
    last = motion.output(np.linspace(DURATION - 2 * branch.periods * single, DURATION, 2001))
    return float(np.ptp(last)) / 2 / LARGE_GAP
