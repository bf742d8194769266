"""Slips that become smaller for ever: an integral moves what sticks again and again, by a like share.

Where the static friction is the kinetic one, a slip begins without a jump. So once the filters of a
controller have forgotten the last one, everything in a slip is in proportion to the error in stick before it,
and each slip makes that error the same multiple of what it was. The wait before it grows as the error falls,
but is known: in stick the states of a controller go on evenly. The limit is where they stand still.
"""

from dataclasses import replace

import numpy as np

from trimmer.arrays import Reals
from trimmer.hybrid.stretch import Instant
from trimmer.hybrid.system import AT_LIMIT, HOLD_BEGUN, ModeEquations
from trimmer.mechanism.mechanism import Mechanism
from trimmer.motion.course import Course
from trimmer.motion.flow import Flow
from trimmer.response.without_events.rest import Rest

MOST_SLIPS = 12  # Slips that are followed
ALIKE = 1e-3  # By how much the shares of two of them may differ
SMALLER = 0.999  # Largest share of an error in the one before
TOLD = 1e-11  # Size of a slip, as a share of the displacements, below which it is none
SOON = 1e-9  # Share of a wait that is left of it
LONG = 16  # Periods of the slowest mode, doubled as often as need be, within which a slip ends
DOUBLED = 6


def asymptotic_rest(flow: Flow, course: Course, unit: float) -> Rest | None:
    """Return where slips lead that become smaller for ever; None if they do not.

    Args:
        flow: The motion.
        course: What was followed of it, which ends in stick.
        unit: A time in which what slips moves, s.
    """
    if not _may_slip_for_ever(flow, course):
        return None
    count = len(flow.modes.system.layout.coordinates)
    instant, errors, last = course.end, list[float](), np.zeros(count)
    for _ in range(MOST_SLIPS):
        waited = _until_slip(flow, instant)
        after = None if waited is None else _stuck_again(flow, waited, unit)
        if after is None:
            return None
        slip = after.state[:count] - instant.state[:count]
        size = float(np.linalg.norm(slip))
        errors.append(size)
        instant = after
        if size <= TOLD * np.linalg.norm(instant.state[:count]):
            return _limit(flow, instant, last if last.any() else slip)
        last = slip
        if _shrinks(errors):
            return _limit(flow, instant, slip)
    return None


def _may_slip_for_ever(flow: Flow, course: Course) -> bool:
    """Say whether all sticks, with no more than the kinetic force, and an integral may tear it out."""
    mechanism, layout = flow.subject, flow.modes.system.layout
    if not isinstance(mechanism, Mechanism) or not (course.log.kind == HOLD_BEGUN).any():
        return False
    integrates = any(each.integrates for each in mechanism.controllers.values())
    drops = any(each.static_force > each.kinetic_force for each in mechanism.frictions.values())
    return integrates and not drops and not course.end.state[layout.kinds[1]].any()


def _shrinks(sizes: list[float]) -> bool:
    """Say whether the last slips become smaller by the same share."""
    if len(sizes) < 3:
        return False
    before, share = sizes[-2] / sizes[-3], sizes[-1] / sizes[-2]
    return share < SMALLER and abs(share - before) <= ALIKE * share


def runs_on(flow: Flow, instant: Instant) -> bool:
    """Say whether all stands still for ever, while an integral runs that cannot change it."""
    layout, mechanism = flow.modes.system.layout, flow.subject
    if not isinstance(mechanism, Mechanism) or not mechanism.controllers:
        return False
    if instant.state[layout.kinds[1]].any():
        return False
    mode, state, rates = _evenly(flow, instant)
    still = not rates[: layout.kinds[1].stop].any()
    falls = any(each.row @ rates < 0 for each in mode.functions)
    return still and not falls and bool((abs(rates) > TOLD * abs(state)).any())


def _evenly(flow: Flow, instant: Instant) -> tuple[ModeEquations, Reals, Reals]:
    """Return the mode in which all sticks, the extended state there without what decays, and its rates."""
    layout, mode = flow.modes.system.layout, flow.modes[flow.modes.number(instant.statuses)]
    state = np.concatenate([instant.state, layout.forcing_at(instant.phase)])
    own = slice(layout.first_control, layout.state_count)
    inner = mode.flow[own, own]
    state[own] -= np.linalg.pinv(inner @ inner) @ (inner @ (mode.flow @ state)[own])
    return mode, state, mode.flow @ state


def _until_slip(flow: Flow, instant: Instant) -> Instant | None:
    """Return the instant just before what sticks breaks away; None if it does not."""
    mode, state, rates = _evenly(flow, instant)
    waits = [
        float((each.row @ state) / -(each.row @ rates))
        for each in mode.functions
        if each.action == AT_LIMIT and each.row @ rates < 0
    ]
    if not waits:
        return None
    state += (1.0 - SOON) * max(min(waits), 0.0) * rates
    quiet = np.zeros_like(instant.zeros)
    return replace(instant, state=state[: flow.size], zeros=quiet, periods=0, phase=0.0)


def _stuck_again(flow: Flow, instant: Instant, unit: float) -> Instant | None:
    """Return the instant at which all sticks again after a slip."""
    count = len(flow.modes.system.layout.coordinates)
    for doubled in range(DOUBLED):
        course = flow.timed(instant, unit * LONG * 2.0**doubled)
        log = course.log
        still = (log.kind == HOLD_BEGUN) & ~log.state[:, count : 2 * count].any(axis=1)
        if still.any():
            row = int(np.flatnonzero(still)[0])
            statuses = flow.modes[int(log.mode[row])].statuses
            return replace(instant, state=log.state[row, : flow.size].copy(), statuses=statuses)
    return None


def _limit(flow: Flow, instant: Instant, slip: Reals) -> Rest:
    """Return the rest along a slip in which no state of a controller changes any more."""
    layout, mode = flow.modes.system.layout, flow.modes[flow.modes.number(instant.statuses)]
    own = slice(layout.first_control, layout.state_count)
    direction = np.zeros(layout.size)
    direction[: len(slip)] = slip
    state = np.concatenate([instant.state, layout.forcing_at(instant.phase)])
    rates = mode.flow[own]
    table = np.column_stack([rates @ direction, rates[:, own]])
    found = np.linalg.lstsq(table, -(rates @ state), rcond=None)[0]
    state += found[0] * direction
    state[own] += found[1:]
    return Rest(
        flow,
        replace(instant, state=state[: layout.state_count], zeros=np.zeros_like(instant.zeros)),
        family=len(layout.coordinates) > 1,
        asymptotic=True,
    )
