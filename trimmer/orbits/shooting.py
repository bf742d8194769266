"""Newton's method for a state that returns, exactly or with its signs changed, after a time."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from trimmer.orbits.return_map import arcs, derivative, follow

if TYPE_CHECKING:
    from trimmer.arrays import Reals
    from trimmer.hybrid.work import Log
    from trimmer.loops.system import LoopModes


MOST_ITERATIONS = 40
MOST_HALVINGS = 8
"""Halvings of a Newton step that would leave the chain of events or enlarge the miss."""
MOST_LENGTHENED = 4.0
"""Factor by which Newton's method may lengthen the span; longer ones have lost the orbit, and take ages."""
CLOSED = 1e-10
"""Miss of the return, relative to the sizes of the states, below which the orbit counts as closed."""
SINGULAR = 1e-12
"""Singular value of Newton's matrix, as a share of the largest one or of 1, that is rounding."""
TOLD_APART = CLOSED / float(np.finfo(float).eps)
"""State over its size beyond which its rounding alone is more than the miss of a closed return."""
SETTLED = 1e-14
"""Miss at which Newton's method stops, since only rounding is left."""


@dataclass(frozen=True)
class Shot:
    """A motion from an extended state of n entries over a span of time.

    Attributes:
        mode: Number of the mode at the start.
        state: Extended state at the start, shape (n,).
        span: Its duration, s.
        log: Its segments.
        end: Extended state at the end, with its signs changed if the return is mirrored, shape (n,).
        slope: Derivative of ``end`` by ``state`` at fixed span, n x n.
        rate: Derivative of ``end`` by the span, 1/s times the units of the states, shape (n,).
        miss: Largest difference of end and state relative to the sizes of the entries, a number.
    """

    mode: int
    state: Reals
    span: float
    log: Log
    end: Reals
    slope: Reals
    rate: Reals
    miss: float


@dataclass(frozen=True)
class Return:
    """The problem of a state that returns: its symmetry, its unknowns and their scale.

    Attributes:
        modes: Modes of the loop.
        mirrored: Whether the state returns with its signs changed, after half a period.
        driven: Whether the span is given by a drive; otherwise it is unknown, as in a loop without drive.
        sizes: Scale of each entry of the state, for comparing them, shape (n,).
    """

    modes: LoopModes
    mirrored: bool
    driven: bool
    sizes: Reals

    @property
    def count(self) -> int:
        """Number of entries of the state that are unknown: all but the drive and the one, which come last."""
        return self.modes.system.layout.sine

    def shoot(self, mode: int, state: Reals, span: float) -> Shot | None:
        """Follow the motion from a state, shape (n,), over a span, s.

        Returns:
            The motion; None if events accumulate, it diverges, or it does not end in the mode of a return.
        """
        log = follow(self.modes, mode, state, span)
        if log is None or not np.isfinite(log.state).all() or int(log.mode[-1]) != self.final(mode):
            return None
        chain = arcs(self.modes, log, span)
        slope, end = derivative(self.modes, chain)
        rate = self.modes[int(log.mode[-1])].flow @ end
        if self.mirrored:
            slope, end, rate = self.signs[:, None] * slope, self.signs * end, self.signs * rate
        miss = float((abs(end - state) / self.sizes)[: self.count].max())
        return Shot(mode, state, span, log, end, slope, rate, miss)

    def matrix(self, shot: Shot) -> Reals:
        """Return the derivative of the miss by the state, both as shares of the sizes."""
        free = slice(self.count)
        scale = self.sizes[free]
        matrix: Reals = (shot.slope[free, free] - np.eye(self.count)) * scale / scale[:, None]
        return matrix

    def step(self, shot: Shot) -> tuple[Reals, float]:
        """Return Newton's correction of the state, shape (n,), and of the span, s.

        Raises:
            LinAlgError: if the derivative is singular.
        """
        free = slice(self.count)
        scale = self.sizes[free]
        matrix = self.matrix(shot)
        gap = (shot.state - shot.end)[free] / scale
        correction = np.zeros_like(shot.state)
        if self.driven:
            correction[free] = np.linalg.solve(matrix, gap) * scale
            return correction, 0.0
        # The state may slide along the orbit; the correction shall be at right angles to it.
        tangent = (self.modes[shot.mode].flow @ shot.state)[free] / scale
        by_span = shot.rate[free] / scale * shot.span
        bordered = np.block([[matrix, by_span[:, None]], [tangent[None], np.zeros((1, 1))]])
        solution = np.linalg.solve(bordered, np.append(gap, 0.0))
        correction[free] = solution[:-1] * scale
        return correction, float(solution[-1]) * shot.span

    @cached_property
    def signs(self) -> Reals:
        """Return the factor, 1 or -1, of each entry of the extended state in the mirrored motion."""
        layout = self.modes.system.layout
        signs = np.full(layout.size, -1.0)
        for first, component in zip(
            layout.first_states, self.modes.system.interconnection.components, strict=True
        ):
            end = first + component.state_count
            signs[end - component.even_states : end] = 1.0
        return signs

    def final(self, mode: int) -> int:
        """Return the mode in which a motion that begins in a mode has to end."""
        if not self.mirrored:
            return mode
        components = self.modes.system.interconnection.components
        each = zip(components, self.modes[mode].statuses, strict=True)
        return self.modes.number(tuple(component.mirrored(one) for component, one in each))


def solve(
    problem: Return, mode: int, state: Reals, span: float, most_iterations: int = MOST_ITERATIONS
) -> Shot | None:
    """Solve a return by Newton's method from a guess of mode, state (shape (n,)) and span (s).

    Returns:
        The solution; None if Newton's method does not converge.
    """
    first = shot = problem.shoot(mode, state, span)
    for _ in range(most_iterations):
        if shot is None or shot.miss <= SETTLED:
            break
        following = _improved(problem, shot, MOST_LENGTHENED * span)
        if following is None:
            break
        shot = following
    if first is None or shot is None or shot.miss > CLOSED or _gone_away(problem, shot):
        return None
    return _left_in_place(problem, first, shot) if problem.driven else shot


def _left_in_place(problem: Return, first: Shot, shot: Shot) -> Shot:
    """Undo what rounding moved of that which may stand anywhere, as a machine on no springs to the ground."""
    free = slice(problem.count)
    scale = problem.sizes[free]
    _, values, rows = np.linalg.svd(problem.matrix(shot))
    anywhere = rows[values <= SINGULAR * max(1.0, values.max())]
    moved = np.zeros_like(shot.state)
    moved[free] = scale * (anywhere.T @ (anywhere @ ((shot.state - first.state)[free] / scale)))
    back = problem.shoot(shot.mode, shot.state - moved, shot.span) if moved.any() else None
    return back if back is not None and back.miss <= CLOSED else shot


def _gone_away(problem: Return, shot: Shot) -> bool:
    """Say whether the state is so large that it returns to rounding, whatever moves it on in each period.

    So Newton's method answers at the resonance of an undamped mode, where there is no orbit.
    """
    free = slice(problem.count)
    scale = problem.sizes[free]
    if not problem.driven or (abs(shot.state[free]) <= TOLD_APART * scale).all():
        return False
    values = np.linalg.svd(problem.matrix(shot), compute_uv=False)
    return bool(values.min() <= SINGULAR * max(1.0, values.max()))


def _improved(problem: Return, shot: Shot, longest: float) -> Shot | None:
    """Take Newton's step, shortened as long as it does not reduce the miss; None if nothing does."""
    try:
        correction, longer = problem.step(shot)
    except np.linalg.LinAlgError:
        return None
    share = 1.0
    for _ in range(MOST_HALVINGS):
        trial_span = shot.span + share * longer
        allowed = 0 < trial_span <= longest
        trial = problem.shoot(shot.mode, shot.state + share * correction, trial_span) if allowed else None
        if trial is not None and trial.miss < shot.miss:
            return trial
        share *= 0.5
    return None
