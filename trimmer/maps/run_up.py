"""``sweep``: run-up and coast-down, as on a test bench, in equal steps of so many drive periods."""

import numpy as np

from trimmer.arguments import whole_number
from trimmer.branches.follow import ends_of, follow
from trimmer.errors import MapError
from trimmer.hybrid.stretch import Ending, Instant
from trimmer.loops.loops import Loop
from trimmer.maps.jumps import jumps
from trimmer.maps.own_plateau import dwell_by_itself
from trimmer.maps.plateau import Plateau, dwell
from trimmer.maps.swept import Sweep, SweepPoint
from trimmer.mechanism.mechanism import Mechanism
from trimmer.mechanism.place_text import parse_place, place_text
from trimmer.motion.flow import Flow
from trimmer.progress import progress_bar
from trimmer.response.exact_orbit import require_repeating
from trimmer.response.flows import called, flow_of, require_subject
from trimmer.response.periodic.pace import pace_of
from trimmer.response.starts import Start, instant_of

PERIODS = 200  # Drive periods at each value, if no number is given


def sweep(  # noqa: PLR0913 (each is a choice of its own, all but four with a default)
    mechanism: Mechanism | Loop,
    place: str,
    start: float | str,
    stop: float | str,
    *,
    steps: int = 100,
    periods: int | None = None,
    back: bool = False,
    state: Start = None,
    branch: bool = False,
    quiet: bool = False,
) -> Sweep:
    """Vary a number in equal steps while the motion goes on: run-up, and coast-down.

    At each value the motion goes on for some drive periods from the state before, and is measured over the
    second half of them. A drive goes on with its phase. Further drives do if their phases return after some
    periods, up to whole returns of which the periods are rounded; else they begin each value at t = 0. Where
    a number changes the place of a contact or the speed of a pin, displacements and velocities of the bodies
    stay as they are.

    Without a drive the motion goes on at each value until it rests or repeats, and is measured there.

    Args:
        mechanism: The mechanism or loop.
        place: Dotted place of the number, such as ``frequency``.
        start: First value in SI units (Hz for a frequency), or text with its unit.
        stop: Last value.
        steps: Equal steps between them, so that there are ``steps`` + 1 values.
        periods: Drive periods at each value, at least 2; 200, or as many samples as do as much, if not given.
            Without a drive periods of the slowest mode in which it must come to rest or repeat; as many as
            ``respond`` waits, if not given.
        back: Whether to go back to the first value too.
        state: Where the motion begins; rest, or the start of the mechanism, if not given.
        branch: Whether to follow the exact periodic motions over the same interval, stable or not.
        quiet: Show no progress bar.

    Returns:
        The sweep. It ends before its time where the motion does, as where it grows without bound.

    Raises:
        MechanismError, LoopError: if there is no such number, or it cannot have these values.
        MapError: if the number is a start.
        UnsupportedMotionError: if the motion never repeats, because a pin goes on for ever and pulls.
        ValueError: if a number is out of its range.
    """
    require_subject(mechanism)
    whole_number("steps", steps, 1)
    if periods is not None:
        whole_number("periods", periods, 2)
    values = _values(mechanism, place, start, stop, steps)
    ways = [False] * len(values) + [True] * (len(values) - 1) * back
    values = [*values, *values[-2::-1]] if back else values

    def flow_at(value: float) -> Flow:
        return flow_of(mechanism.with_value(place, value))

    def step(last: float, value: float, instant: Instant, before: int = 0) -> tuple[Plateau, Instant]:
        new = flow_at(value)
        return _stay(new, carried(flow_at(last), instant, new), periods, before)

    # Only after whole returns of all drives does a value begin with the phases at which the one before ended.
    first = flow_at(values[0])
    require_repeating(first)
    together = first.modes.system.layout.recurrence or 1
    if first.period:
        periods = -(-(periods or PERIODS) * pace_of(mechanism) // together) * together
    plateaus: list[Plateau] = []
    ends: list[Instant] = []
    for number in progress_bar(range(len(values)), "steps", quiet=quiet):
        if number:
            plateau, end = step(values[number - 1], values[number], ends[-1], number * (periods or 0))
        else:
            plateau, end = _stay(first, instant_of(first, state), periods)
        plateaus.append(plateau)
        ends.append(end)
        if plateau.ending is not Ending.REACHED_END:
            break
    jumped = jumps(list(first.outputs), values, plateaus, ends, step)
    points = tuple(map(SweepPoint, values, ways, plateaus))
    followed = follow(mechanism, place, *values[0 : steps + 1 : steps]) if branch else None
    return Sweep(mechanism, place_text(parse_place(place)), steps, periods, back, points, jumped, followed)


def _values(
    mechanism: Mechanism | Loop, place: str, start: float | str, stop: float | str, steps: int
) -> list[float]:
    """Return the values of a sweep, in SI units, once all was checked that can be without a motion."""
    if parse_place(place)[0] == "start":
        raise MapError(
            f"{place}: a sweep begins once; vary a number of the {called(mechanism)}, or use a map"
        )
    begin, end = ends_of(mechanism, place, start, stop)
    return np.linspace(begin, end, steps + 1).tolist()  # type: ignore[no-any-return]


def _stay(flow: Flow, begin: Instant, periods: int | None, before: int = 0) -> tuple[Plateau, Instant]:
    if not flow.period:
        return dwell_by_itself(flow, begin, periods)
    assert periods is not None
    return dwell(flow, begin, periods, before)


def carried(flow: Flow, instant: Instant, new: Flow) -> Instant:
    """Return the instant at which another number comes in: states stay, and contacts are decided anew."""
    if flow.names == new.names:
        return new.at(instant.state)
    known = dict(zip(flow.names, instant.state.tolist(), strict=True))
    return new.at(np.array([known.get(name, 0.0) for name in new.names]), stretched=False)
