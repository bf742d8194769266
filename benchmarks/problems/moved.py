"""Digits of motions from an initial state: what is to be read of them, and what a theorem says of it."""

import re
import shlex
import tomllib

from benchmarks.problems.read import Digit, Problem

Bounds = tuple[float, float]
AXES = "displacements", "velocities"
BETWEEN = r"between (\S+) and ([^\s,;]+\d)"
RISE, BAND = (0.1, 0.9), 0.02
"""Shares of the step between which it rises, and about it within which it has settled."""


def is_of_motion(problem: Problem, digit: Digit) -> bool:
    """Say whether a digit is one of a motion from an initial state."""
    words = shlex.split(problem.asks.get(str(next(iter(digit.ours), "")), ""))
    return bool(words) and words[0] in ("simulate", "step") and "settles_to" not in digit.ours


def readings_of(problem: Problem, digit: Digit) -> list[str]:
    """Return what is to be read of the motion."""
    machine = tomllib.loads(problem.machine)
    key = str(digit.ours[1])
    if key == "final":
        return [f"{AXES[int(digit.ours[3])]}.{digit.ours[2]}"]
    if key == "events":
        parts = [name for kind in ("plays", "stops", "walls") for name in machine.get(kind, {})]
        return [f"contacts.{name}" for name in parts] if digit.ours[-1] == "speed" else []
    output, size, _ = _step(problem)
    levels = {"rise_time": RISE, "settling_time": (1.0 - BAND, 1.0 + BAND)}.get(key, ())
    return [output, *(f"{output} = {share * size!r}" for share in levels)]


def _step(problem: Problem) -> tuple[str, float, float]:
    """Return the output that follows the step of a reference, its size and its time, s."""
    machine = tomllib.loads(problem.machine)
    (control,) = machine["controllers"].values()
    reference = machine["references"][control["reference"]]
    return f"outputs.{control['measure']}", reference["step"], reference["at"]


def bounds_of(problem: Problem, digit: Digit, theorem: str) -> Bounds | None:
    """Return between which bounds a theorem says that a digit is; None if it says nothing of it."""
    key = str(digit.ours[1])
    if key == "final":
        found = _read(theorem, readings_of(problem, digit)[0], "at the end")
        return (-found[1], -found[0]) if found and digit.ours[-1] == "minus" else found
    if key == "events":
        return _of_events(problem, digit, theorem)
    if "references" not in tomllib.loads(problem.machine):
        return None
    output, size, at = _step(problem)
    largest, end = (_read(theorem, output, name) for name in ("largest", "at the end"))
    zeros = [_zeros(theorem, name) for name in readings_of(problem, digit)[1:]]
    if largest is None or end is None or None in zeros:
        return None
    if key == "overshoot":
        return 100 * (largest[0] / size - 1), 100 * (largest[1] / size - 1)
    if key == "final_error":
        return size - end[1], size - end[0]
    instants = [each or [] for each in zeros]
    if key == "rise_time":
        first, last = (each[0] for each in instants)
        return last[0] - first[1], last[1] - first[0]
    settled = max(each for found in instants for each in found)
    inside = max(abs(each / size - 1) for each in end) < BAND
    return (settled[0] - at, settled[1] - at) if key == "settling_time" and inside else None


def _of_events(problem: Problem, digit: Digit, theorem: str) -> Bounds | None:
    if digit.ours[2] == "count":
        count = re.search(r"with the (\d+) events of this file", theorem)
        return (float(count[1]), float(count[1])) if count else None
    events = re.findall(rf"event (\d+) {BETWEEN} s[;.]", theorem)
    if not events:
        return None
    number, *times = events[int(digit.ours[2])]
    if digit.ours[3] == "time":
        return float(times[0]), float(times[1])
    speeds = (_read(theorem, name, f"before event {number}") for name in readings_of(problem, digit))
    return next((each for each in speeds if each), None)


def _read(theorem: str, name: str, called: str) -> Bounds | None:
    told = re.search(rf"calls '{re.escape(name)}', unchecked, is: [^:]*?\b{called} {BETWEEN}[,.]", theorem)
    return (float(told[1]), float(told[2])) if told else None


def _zeros(theorem: str, name: str) -> list[Bounds] | None:
    told = re.search(
        rf"calls '{re.escape(name.replace(' = ', ' - '))}', unchecked, is zero at ([^;]*?)\. ", f"{theorem} "
    )
    return [(float(low), float(high)) for low, high in re.findall(BETWEEN, told[1])] if told else None
