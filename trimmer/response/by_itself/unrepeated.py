"""What is known of a motion without a drive that repeats nothing: chaos or undecided, and how far it goes."""

import numpy as np

from trimmer.hybrid.stretch import Ending
from trimmer.messages import listed
from trimmer.motion.flow import Flow
from trimmer.motion.signals import along
from trimmer.response.by_itself.returns import Returns
from trimmer.response.by_itself.self_excited import STRETCHES, SelfExcited
from trimmer.response.results.response import MotionKind, SettledMotion, SlowingDown, Swings
from trimmer.response.statistics.window import Watched, watch
from trimmer.showing.shown import counted

ALIKE = 0.05  # Share of what factors exceed 1 by up to which they are told as one
RETURNS = 512
"""Returns over which it is watched, or all of the last stretch that was followed if it has fewer."""


def unrepeated(flow: Flow, found: SelfExcited, most_periods: int | None) -> SettledMotion:
    """Return what is known of a motion in which nothing repeated, with its sizes over a window.

    Args:
        flow: What moves.
        found: What was found.
        most_periods: Periods of the slowest mode that were to be waited; None if no number was given.
    """
    returns = found.returns
    chaotic = returns is not None and returns.chaotic
    window = None if returns is None or not returns.count or found.cut_short else _watched(flow, returns)
    kind = MotionKind.CHAOTIC if chaotic else MotionKind.UNDECIDED
    told = _told(found, window) if chaotic else _undecided(flow, found, most_periods)
    if window is not None and returns is not None:
        begin = found.waited - returns.course.duration
        told += f" Figures are those of {window.duration:.6g} s from {begin:.6g} s on."
    swings = _swings(found)
    told += _swings_told(flow, swings)
    return SettledMotion(kind, None, window, 0, None, told, swings=swings, slowing=found.slowing)


def _watched(flow: Flow, returns: Returns) -> Watched | None:
    window = watch(flow, returns.course.begin, RETURNS, returns.seen(RETURNS) / RETURNS)
    return window if window is not None and window.ending is Ending.REACHED_END else None


def _told(found: SelfExcited, window: Watched | None) -> str:
    assert found.returns is not None and found.returns.exponent is not None
    largest = found.returns.exponent if window is None else window.exponents[0]
    return (
        f"It is chaotic: nothing repeats within {found.waited:.6g} s, its largest Lyapunov exponent is "
        f"{largest.value:.3g} +- {largest.uncertainty:.1g} per s, and a neighbouring motion leaves it. "
        f"Its most frequent event comes every {found.returns.mean:.4g} s in the mean, {found.returns.count} "
        "times at last; chaos for so long may still be a transient that ends."
    )


def _swings(found: SelfExcited) -> Swings | None:
    """Return how far it swung from the event on to which it came again, if it was cut short and did."""
    returns = found.returns
    if returns is None or not returns.count or not found.cut_short:
        return None
    flow, course = returns.flow, returns.course
    # So long a motion has too many instants between its events.
    rows = np.arange(returns.rows[0], len(course.log.start))
    values = {
        name: along(course, each.signal, rows, course.log.state[rows]) for name, each in flow.outputs.items()
    }
    since = found.waited - course.duration + float(course.log.start[rows[0]])
    return Swings(since, returns.count, {name: float(np.ptp(each)) for name, each in values.items()})


def _swings_told(flow: Flow, swings: Swings | None) -> str:
    if swings is None:
        return ""
    told = [f"{name} by {size:.6g} {flow.outputs[name].unit}" for name, size in swings.peak_to_peak.items()]
    times = counted(swings.times, "time")
    return (
        f" From {swings.since:.6g} s on it came again {times}; at its events it swings peak to peak: "
        f"{listed(told)}."
    )


def _undecided(flow: Flow, found: SelfExcited, most_periods: int | None) -> str:
    searched = round(found.waited / found.unit)
    told = f"Nothing repeats within {found.waited:.6g} s"
    if found.passed is not None:
        told = (
            f"Within {found.waited:.6g} s it settles to nothing that repeats; it passes an unstable motion "
            f"with a period of {found.passed.period:.9g} s"
        )
    if found.slowing is not None:
        return told_of_slowing(found.slowing, found.waited)
    if found.cut_short:
        return f"{told}, and it was followed no further: {Ending.STEP_LIMIT.value}."
    longer = 10 * max(searched, sum(STRETCHES) if most_periods is None else most_periods)
    loses = " Nothing brings energy into it, so that it comes to rest or slows down for ever."
    told_of_energy = loses if flow.only_loses_energy else ""
    return (
        f"{told}, {searched} periods of its slowest mode; {longer} of them would be followed with "
        f"most_periods={longer} (--periods {longer}), and another start may settle.{told_of_energy}"
    )


def told_of_slowing(seen: SlowingDown, waited: float) -> str:
    """Say in words how a motion slows down that was followed for so long, s."""
    alike = seen.largest - seen.least <= ALIKE * (seen.least - 1.0)
    factors = f"{seen.largest:.4g}" if alike else f"{seen.least:.4g} to {seen.largest:.4g}"
    return (
        "It slows down for ever: it never rests, and never repeats. Between its events it moves on freely, "
        f"and each of its last {seen.returns} returns takes {factors} times as long as the one before, the "
        f"last one {seen.last:.4g} s, with a speed that is as much less. So its speed falls as one over the "
        f"time, and its kinetic energy as one over the square of it, as was seen within {waited:.6g} s."
    )
