"""What the trimmer with play settles to, an orbit, and an event, beside SciPy in the same run.

Run it with `python -m benchmarks.respond`. The peer of an event is `scipy.integrate.solve_ivp` (DOP853, rtol
1e-10) on the smooth pieces of the same motion, stopped by terminal events.
"""

import time
from argparse import ArgumentParser
from collections.abc import Callable
from pathlib import Path

import numpy as np
from scipy.integrate import solve_ivp

from benchmarks.calibration import sentence
from trimmer.contact.flow import MechanismFlow
from trimmer.contact.machine.statuses import FREE, RELAXING
from trimmer.mechanism.mechanism import Mechanism
from trimmer.orbits.forced_orbit import forced_orbit
from trimmer.response.respond import respond
from trimmer.response.results.response_json import response_json
from trimmer.response.simulation.simulate import simulate

TWIN = Mechanism.from_toml(Path(__file__).parents[1] / "examples" / "thesis-play.toml").with_value(
    "frictions.blade.force", 1.0
)
ROUNDS = 15
PERIODS = 300
PEER_PERIODS = 4
DURATION = 5.0  # Of the motion for an event through simulate, s
TARGETS = {"respond": 4e-3, "orbit": 1.5e-3, "event": 1.5e-6, "simulate": 3e-6, "ratio": 300}


def seconds(function: Callable[[], object], rounds: int = ROUNDS) -> float:
    """Return the shortest time of some calls, s."""
    times = []
    for _ in range(rounds):
        start = time.perf_counter()
        function()
        times.append(time.perf_counter() - start)
    return min(times)


def whole_response() -> object:
    """Find what it settles to, with all measures, from a mechanism that nothing is known of."""
    return response_json(respond(TWIN.with_value("frictions.blade.force", 1.0)))


def orbit_nearby() -> Callable[[], object]:
    """Return a call that finds the orbit with its multipliers from a start 1 % off."""
    state = forced_orbit(TWIN).instant.state
    off = state * (1 + 0.01 * np.random.default_rng(0).uniform(-1, 1, len(state)))
    return lambda: forced_orbit(TWIN, guess=off).multipliers


def events() -> tuple[int, Callable[[], object]]:
    """Return a number of events, and a call that follows the motion through them."""
    flow = MechanismFlow(TWIN)
    instant = flow.strobe(flow.rest(), 100).end
    count = int(flow.strobe(instant, PERIODS).counts.sum())
    return count, lambda: flow.strobe(instant, PERIODS)


def peer() -> tuple[int, float]:
    """Follow the same motion by solve_ivp; return the number of its events and the time taken, s."""
    flow = MechanismFlow(TWIN)
    instant = flow.strobe(flow.rest(), 100).end
    course = flow.course(instant, PEER_PERIODS)
    modes, log = course.modes, course.log
    ends = np.append(log.start[1:], course.duration)
    state, count, start = log.state[0].copy(), 0, time.perf_counter()
    for row, mode in enumerate(log.mode):
        matrix = modes[int(mode)].flow.copy()
        functions = [each.row for each in modes[int(mode)].functions]
        relaxing = modes[int(mode)].statuses[0] == RELAXING
        span = 1.5 * (ends[row] - log.start[row]) if row + 1 < len(ends) else ends[row] - log.start[row]
        events = [_falling(each) for each in functions]
        begin = state.copy()
        if relaxing or modes[int(mode)].statuses[0] == FREE:
            matrix[flow.size - 1] = 0.0  # The relaxing spring is far too stiff for this peer; it is left out.
        ended = solve_ivp(
            lambda _, at, flow=matrix: flow @ at,
            (0.0, span),
            begin,
            method="DOP853",
            events=events,
            rtol=1e-10,
            atol=1e-14,
        )
        count += 1
        state = log.state[row + 1].copy() if row + 1 < len(log.mode) else ended.y[:, -1]
    return count, time.perf_counter() - start


def _falling(row: np.ndarray) -> Callable[[float, np.ndarray], float]:
    def event(_: float, state: np.ndarray) -> float:
        return float(row @ state)

    event.terminal, event.direction = True, -1  # type: ignore[attr-defined]
    return event


def main() -> None:
    """Print times and ratios."""
    print(sentence())
    whole_response()
    taken = seconds(whole_response)
    print(f"respond with all measures      {taken * 1e3:9.2f} ms   (target {TARGETS['respond'] * 1e3:g} ms)")
    taken = seconds(orbit_nearby())
    print(f"orbit from a start 1 % off     {taken * 1e3:9.2f} ms   (target {TARGETS['orbit'] * 1e3:g} ms)")
    count, call = events()
    own = seconds(call) / count
    print(f"an event of the twin           {own * 1e6:9.2f} us   (target {TARGETS['event'] * 1e6:g} us)")
    motion = simulate(TWIN, DURATION)
    each = seconds(lambda: simulate(TWIN, DURATION)) / len(motion.course.events)
    print(f"an event through simulate      {each * 1e6:9.2f} us   (target {TARGETS['simulate'] * 1e6:g} us)")
    theirs = min(spent / number for number, spent in (peer() for _ in range(3)))
    print(f"an event of solve_ivp          {theirs * 1e6:9.2f} us")
    print(f"ratio                          {theirs / own:9.0f}      (target {TARGETS['ratio']})")
    chaos = TWIN.with_value("frictions.blade.force", 0.0)
    print(f"respond, chaotic               {seconds(lambda: respond(chaos), 1):9.2f} s")


if __name__ == "__main__":
    ArgumentParser(description=__doc__).parse_args()
    main()
