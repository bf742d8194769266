"""What each peer's script prints: a JSON object a line, with the shortest time of some runs."""

import json
import time
from collections.abc import Callable

ROUNDS = 3
LONG = 2.0  # No further run after this, s


def shortest(ask: Callable[[], float]) -> tuple[float, float]:
    """Return what some runs give, and the time of the shortest of them, s."""
    times, value = [], float("nan")
    while len(times) < ROUNDS and sum(times) < LONG:
        started = time.perf_counter()
        value = float(ask())
        times.append(time.perf_counter() - started)
    return value, min(times)


def tell(peer: str, setting: str, problem: str, digit: str, ask: Callable[[], float]) -> None:
    """Ask for a digit some times; print it with the shortest time, s, or what went wrong."""
    told: dict[str, object] = {"peer": peer, "setting": setting, "problem": problem, "digit": digit}
    try:
        value, seconds = shortest(ask)
        told |= {"value": value, "seconds": seconds}
    except Exception as error:  # a peer may fail in any way; the table then says how
        told |= {"failed": f"{type(error).__name__}: {str(error).splitlines()[0] if str(error) else ''}"}
    print(json.dumps(told), flush=True)
