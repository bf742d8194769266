"""Orbits of a relay with two switches in a period, on an interval of periods: all that are symmetric."""

import numpy as np

from trimmer.arrays import Reals
from trimmer.hybrid.variation import propagator
from trimmer.loops.components.of_elements import RigidComponent, ViscousComponent
from trimmer.loops.components.relay_component import PLUS, RelayComponent
from trimmer.loops.components.switched_component import Component
from trimmer.loops.components.threshold_component import POSITIVE, ThresholdComponent
from trimmer.loops.flow import LoopFlow
from trimmer.loops.integration import instant_in
from trimmer.loops.loops import ClosedLoop
from trimmer.orbits.describe import orbit_of_loop
from trimmer.orbits.distinct import closed, shortest
from trimmer.orbits.half_period import HalfPeriodEquation, Interval, interval_of, zeros
from trimmer.orbits.periodic_orbit import PeriodicOrbit
from trimmer.orbits.search import RelaySearch
from trimmer.orbits.unequal_switches import POINTS, unequal_switches
from trimmer.response.periodic.shooting import Return

CLOSE = 1e-3
"""Miss of the return above which a zero is no orbit: the relay switches in between, or the other way."""
PARTS = 8  # Of half a period, at whose ends the sizes of the states are taken


def relay_orbits(
    loop: ClosedLoop, half_periods: Interval | None
) -> tuple[list[PeriodicOrbit], RelaySearch] | None:
    """Find the orbits; None if the element is not a single relay without dead zone, or Coulomb friction.

    Viscous friction and a gain beside it are linear and may be there. With hysteresis only the orbits are
    found that return with their signs changed.

    Args:
        loop: The closed loop.
        half_periods: Shortest and longest half period, s; chosen from poles and zeros if not given.
    """
    equation = _equation(loop)
    if equation is None:
        return None
    interval = interval_of(equation) if half_periods is None else half_periods
    solved = zeros(equation, interval)
    starts = equation.states(np.array(solved.halves)) if solved.halves else ()
    orbits = [_orbit(loop, half, None, start) for half, start in zip(solved.halves, starts, strict=True)]
    grid = 0 if equation.level else POINTS
    if grid:
        orbits += [_orbit(loop, *pair) for pair in unequal_switches(equation, interval)]
    found = [orbit for orbit in orbits if orbit is not None]
    return found, RelaySearch(interval, len(solved.halves), solved.undecided, grid)


def _plus(loop: ClosedLoop) -> int | None:
    """Return the mode in which the relay is positive; None if there is not one relay."""
    components = loop.modes.system.interconnection.components
    if sum(map(_is_relay, components)) != 1 or not all(
        isinstance(each, RelayComponent | ThresholdComponent | ViscousComponent | RigidComponent)
        for each in components
    ):
        return None
    return loop.modes.number(tuple(_positive(each) for each in components))


def _is_relay(component: Component) -> bool:
    """Return whether a component has two outputs: a relay, with or without hysteresis, or dry friction."""
    return isinstance(component, RelayComponent) or (
        isinstance(component, ThresholdComponent) and not component.has_dead_zone
    )


def _positive(component: Component) -> int:
    return POSITIVE if isinstance(component, ThresholdComponent) else PLUS if _is_relay(component) else 0


def _equation(loop: ClosedLoop) -> HalfPeriodEquation | None:
    number = _plus(loop)
    if number is None:
        return None
    mode, order = loop.modes[number], loop.modes.system.layout.order
    kept = [*range(order), loop.modes.system.layout.size - 1]
    (switching,) = mode.functions
    # The output falls where the row is zero, at minus the hysteresis; it rises where that has the other sign.
    rises = float(switching.row[-1])
    return HalfPeriodEquation(mode.flow[np.ix_(kept, kept)], switching.row[:order], rises)


def _orbit(loop: ClosedLoop, positive: float, negative: float | None, start: Reals) -> PeriodicOrbit | None:
    """Return the orbit of a zero; None if the motion does not return by then.

    Args:
        loop: The closed loop.
        positive: How long the output is positive, s.
        negative: How long it is negative after that, s; None if the motion returns with its signs changed.
        start: State of the linear system where the output becomes positive.
    """
    number, layout = _plus(loop), loop.modes.system.layout
    assert number is not None
    state = np.zeros(layout.size)
    state[: layout.order], state[-1] = start, 1.0
    step = propagator(loop.modes, number, positive / PARTS)
    states = [state]
    for _ in range(PARTS):
        states.append(step @ states[-1])
    sizes = abs(np.array(states)).max(axis=0)
    sizes[sizes == 0.0] = 1.0
    problem = Return(LoopFlow(loop), 0, mirrored=negative is None, alike=True)
    span, sizes = positive if negative is None else positive + negative, sizes[: layout.state_count]
    trial = problem.shoot(instant_in(problem.flow.modes, number, states[PARTS // 2]), span, sizes)
    if trial is None or not trial.miss <= CLOSE:
        return None
    shot = closed(problem, trial.course.begin, trial.duration, sizes)
    return None if shot is None else orbit_of_loop(*shortest(problem, shot))
