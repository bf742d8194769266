"""Whether a machine under samples is at rest: nothing moves, and controllers hold the same at each sample.

Between samples a motion is linear, and so is what samples make of it, as long as no event comes. So where it
comes to rest is solved for from one period and its derivative, and not waited for.
"""

import numpy as np
from scipy.linalg import matrix_balance

from trimmer.arrays import Reals
from trimmer.contact.machine.statuses import STICK
from trimmer.hybrid.stretch import Ending, Instant
from trimmer.motion.flow import Flow
from trimmer.response.without_events.rest import Rest

GONE = 1e-9  # Share of the sizes of a motion up to which what is left of it is none
NONE = 1e-10  # Share of its size up to which a state is rounding at rest, and zero
SINGULAR = 1e-9
"""Share of the largest singular value up to which one is zero: any place in its direction is one of rest."""
DRIFT = 1e-13
"""Share of the sizes up to which it is rounding that something goes on in such a direction in a period."""


def sampled_rest(flow: Flow, instant: Instant, sizes: Reals, gone: float = GONE) -> Rest | None:
    """Return the rest that a sampled motion is in, None if something moves, or changes from sample to sample.

    Args:
        flow: What moves.
        instant: Where it is, at the start of a period.
        sizes: Of the states in the motion before, (n,).
        gone: Share of them at which what decays is gone.
    """
    layout = flow.modes.system.layout
    if layout.changes_after(instant.periods * layout.period + instant.phase):
        return None
    course = flow.course(instant, layout.recurrence or 1)
    if (
        course.events
        or course.ending is not Ending.REACHED_END
        or not _is_still(course.nodes.states, sizes, gone)
    ):
        return None
    # In scales that make its rows as large as its columns what a matrix leaves singular is seen best.
    scale = matrix_balance(course.monodromy, permute=False, separate=True)[1][0]
    left = (course.end.state - instant.state) / scale
    away = np.eye(len(sizes)) - course.monodromy * scale / scale[:, None]
    outer, values, inner = np.linalg.svd(away)
    moves = values > SINGULAR * values.max(initial=0.0)
    shares = outer.T @ left
    further = inner[moves].T @ (shares[moves] / values[moves])
    # What samples leave as it is stays so up to the rest. Nothing of it is left over where a body moves on.
    stays, places = outer[:, ~moves].T, inner[~moves].T
    further += places @ np.linalg.lstsq(stays @ places, -stays @ further, rcond=SINGULAR)[0]
    size = abs(stays) @ (sizes / scale)
    goes_on, left_over = (abs(each) / size for each in (shares[~moves], stays @ further))
    moved_on = max(goes_on.max(initial=0.0) / DRIFT, left_over.max(initial=0.0) / GONE)
    if moved_on > 1.0 or (abs(further) * scale / sizes).max(initial=0.0) > gone:
        return None
    state = instant.state + scale * further
    state[abs(state) <= NONE * sizes] = 0.0
    limit = flow.at(state, instant.phase, like=instant)
    return Rest(flow, limit, bool((~moves).any()), _slides(flow, limit, sizes))


def _is_still(states: Reals, sizes: Reals, gone: float) -> bool:
    """Say whether states, (count, N), are all the same beside their sizes."""
    found = states[:, : len(sizes)]
    return bool((np.ptp(found, axis=0) <= gone * sizes).all())


def _slides(flow: Flow, limit: Instant, sizes: Reals) -> bool:
    """Say whether a friction slides up to the rest, which is never reached then: its slips become smaller."""
    machine, layout = flow.modes.system.machine, flow.modes.system.layout
    rates, forcing = machine.friction_rate, layout.forcing_at(limit.phase, limit.periods * layout.period)
    slow = abs(rates @ np.append(limit.state, forcing)) <= GONE * (abs(rates[:, : len(sizes)]) @ sizes)
    sliding = np.array(machine.of_frictions(limit.statuses), dtype=int) != STICK
    return bool((slow & sliding).any())
