"""Which digits of the problems are proven by ball arithmetic, by the theorems kept in ``proofs``.

``python -m benchmarks.problems.proven [NAME ...]`` proves them anew: of motions that repeat the period
without a drive, events, largest multiplier, peaks, mean squares, impact speeds, shares of stick; of motions
from a state times of events, speeds, ends and how they follow a step (``moved``); folds, period doublings,
grazings of what has no events besides, tori, and what harmonic balance predicts. No theorem is there for the
end of infinitely many impacts, and for a grazing of what has events besides.
``trimmer check`` verifies each file again.
"""

from __future__ import annotations

import json
import math
import re
import shlex
from argparse import ArgumentParser
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING

from benchmarks.problems import ask, moved
from benchmarks.problems.read import FOLDER, Digit, Problem, problems

if TYPE_CHECKING:
    from trimmer import Mechanism
    from trimmer.proof import Proof

PROOFS = FOLDER / "proofs"
ORBITS = {
    "period": r"Over this motion, of between (?P<lower>\S+) and (?P<upper>\S+) s",
    "events per period": r"with the (?P<value>\d+) events of this file",
    "largest multiplier": r" is between (?P<lower>\S+) and (?P<upper>\S+)\.$",
}
PLACE = r"exactly one solution .* within (?P<off>\S+), relative, of its place: "
PREDICTED = {
    "predicted amplitude": PLACE + r"A = (?P<value>\S+),",
    "predicted period": PLACE + r"A = \S+, omega = (?P<omega>\S+) rad/s\.$",
}
READ = {
    "peak_to_peak": "peak to peak",
    "advance": "integral",
    "rms": "about the mean",
    "rms_acceleration": "root mean square",
    "share_of_stick": "mean",
    "impact_speeds": r"before event \d+",
}
"""How a theorem calls what is read of a motion."""
READING = (
    r"what this file calls '{}', unchecked, is: [^:]*?\b{} "
    r"between (?P<lower>\S+) and (?P<upper>[^\s,]+\d)[,.] "
)
SPECIAL = {"fold", "period-doubling", "grazing", "torus"}
VALUE = r": a {} within (?P<off>\S+), relative, of v = (?P<value>\S+)\.$"


def file_of(problem: Problem, digit: Digit) -> Path:
    """Return where the proof of a digit is kept if there is one; digits of one motion share it."""
    name = orbit_of(digit) or digit.name.replace(" ", "-")
    if moved.is_of_motion(problem, digit):
        name = str(digit.ours[0])
    return PROOFS / f"{problem.name}-{name}.json"


def orbit_of(digit: Digit) -> str:
    """Return under which name the motion is asked for that repeats and has a digit; empty for others."""
    covered = digit.name in ORBITS or reading_of(digit) is not None
    asked = str(digit.ours[0]) if digit.ours else "motion"
    return ("motion" if asked == "outputs" else asked) * covered


def reading_of(digit: Digit) -> tuple[str, str] | None:
    """Return what of a motion a digit reads, and how a theorem calls that; None if it reads nothing."""
    keys = [str(each) for each in digit.ours]
    place = next((at for at, key in enumerate(keys) if key in READ), 0)
    if place <= 1:
        return None
    kind = "rates" if keys[place] == "advance" else keys[place - 2]
    return f"{kind}.{keys[place - 1]}", READ[keys[place]]


def digits_of(problem: Problem, digit: Digit, theorem: str) -> int:
    """Return how many digits of a number a theorem says, no more than are printed.

    Returns:
        0 if the theorem says nothing of it, or another number.
    """
    if moved.is_of_motion(problem, digit):
        told = moved.bounds_of(problem, digit, theorem)
        return 0 if told is None else _shared(digit, 0.5 * (told[0] + told[1]), 0.5 * (told[1] - told[0]))
    kind = digit.ours[2] if digit.ours[1:2] == ("special",) else "nothing"
    said = {**ORBITS, **PREDICTED}.get(digit.name, VALUE.format(kind))
    if read := reading_of(digit):
        said = READING.format(re.escape(read[0]), read[1])
    found = re.search(said, theorem)
    if found is None:
        return 0
    told = {name: float(value) for name, value in found.groupdict().items()}
    if "omega" in told:
        told["value"] = math.tau / told["omega"]
    factor = {"turns": math.tau, "half": 0.5}.get(str(digit.ours[-1]) if digit.ours else "", 1.0)
    told = {name: each if name == "off" else factor * each for name, each in told.items()}
    middle = told["value"] if "value" in told else 0.5 * (told["lower"] + told["upper"])
    off = told["off"] * abs(middle) if "off" in told else 0.0
    return _shared(digit, middle, off or 0.5 * (told.get("upper", middle) - told.get("lower", middle)))


def _shared(digit: Digit, middle: float, off: float) -> int:
    """Return how many digits a number has in common with what is within a distance of a middle."""
    # The theorem is told to a last digit, as is what is held against it.
    off = max(off / abs(middle), digit.agreement)
    return math.floor(-math.log10(off)) if abs(digit.value / middle - 1.0) <= off else 0


def proven_digits(problem: Problem, digit: Digit) -> int:
    """Return how many digits of a number its kept proof says; 0 if there is none."""
    path = file_of(problem, digit)
    return (
        digits_of(problem, digit, json.loads(path.read_text(encoding="utf-8"))["theorem"])
        if path.exists()
        else 0
    )


def prove(problem: Problem, digit: Digit) -> Proof | None:
    """Prove what a digit is of; None if that is not covered."""
    from trimmer import ClosedLoop, Mechanism, follow, respond
    from trimmer.proof import prove_limit_cycles, prove_orbit, prove_special_point

    orbit_name = orbit_of(digit)
    alike = (reading_of(each) for each in problem.digits if orbit_of(each) == orbit_name)
    names = tuple(dict.fromkeys(each[0] for each in alike if each is not None))
    if problem.python:
        if not orbit_name and digit.name not in PREDICTED:
            return None
        named = ask.names_of(problem)
        if digit.name in PREDICTED:
            return prove_limit_cycles(ClosedLoop(named["plant"], named["relay"]), [named["predicted"]])
        orbit = named["motion"].orbit if "motion" in named else named["orbit"]
        return prove_orbit(orbit.subject, orbit, readings=names)
    with TemporaryDirectory() as folder:
        ask.write_files(problem, Path(folder))
        machine = Mechanism.from_toml(Path(folder) / ask.FILE)
    words = shlex.split(problem.asks[str(digit.ours[0])])
    if moved.is_of_motion(problem, digit):
        return _of_motion(problem, machine, words, str(digit.ours[0]))
    if orbit_name and (words[0] == "respond" or "settles_to" in digit.ours):
        for change in words[3::2] if words[0] == "respond" else ():
            place, value = change.split("=")
            machine = machine.with_value(place, float(value))
        orbit = respond(machine).motion.orbit
        return None if orbit is None else prove_orbit(machine, orbit, readings=names)
    if digit.ours[1] != "special" or digit.ours[2] not in SPECIAL:
        return None
    options = dict(zip(words[2::2], words[3::2], strict=True))
    place, first, last = options["--vary"], float(options["--from"]), float(options["--to"])
    branch = follow(machine.with_value(place, first), place, first, last)
    near = digit.value / (math.tau if digit.ours[-1] == "turns" else 1.0)
    points = [each for each in branch.special if each.kind.word == digit.ours[2]]
    return prove_special_point(machine, branch, min(points, key=lambda each: abs(each.value - near)))


def _of_motion(problem: Problem, machine: Mechanism, words: list[str], asked: str) -> Proof:
    from trimmer import simulate
    from trimmer.proof import prove_motion

    digits = [each for each in problem.digits if each.ours[0] == asked]
    names = dict.fromkeys(name for each in digits for name in moved.readings_of(problem, each))
    options = dict(zip(words[2::2], words[3::2], strict=True))
    for change in [options["--set"]] if "--set" in options else ():
        place, value = change.split("=")
        machine = machine.with_value(place, float(value))
    proof = prove_motion(machine, simulate(machine, float(options["--duration"])), readings=tuple(names))
    times = [each.value for each in digits if each.ours[1:2] == ("events",)]
    if not proof and times:
        # Where it ends by a chatter, which is not covered, what comes before it is.
        proof = prove_motion(machine, simulate(machine, 1.1 * min(times)), readings=tuple(names))
    return proof


def main() -> None:
    """Prove what can be proven, and keep it."""
    parser = ArgumentParser(prog="python -m benchmarks.problems.proven", description=__doc__)
    parser.add_argument("names", nargs="*", help="names of problems (default: all)")
    names = parser.parse_args().names
    PROOFS.mkdir(exist_ok=True)
    for problem in problems():
        kept: dict[Path, Proof | None] = {}
        for digit in problem.digits if not names or problem.name in names else ():
            path = file_of(problem, digit)
            kept[path] = proof = kept[path] if path in kept else prove(problem, digit)
            if proof is None:
                continue
            count = digits_of(problem, digit, proof.theorem)
            print(
                f"{problem.name}, {digit.name}: {proof.verdict}, {count} digits. {proof.reason}", flush=True
            )
            if count:
                proof.write(path)


if __name__ == "__main__":
    main()
