"""Which digits of the problems are proven by ball arithmetic, by the theorems kept in ``proofs``.

``python -m benchmarks.problems.proven [NAME ...]`` proves them anew: periods of motions without a drive,
numbers of events, largest multipliers, folds, period doublings, and what harmonic balance predicts. A grazing
stays undecided. No theorem is there for peaks and mean squares, a torus, and motions that do not repeat.
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

from benchmarks.problems import ask
from benchmarks.problems.read import FOLDER, Digit, Problem, problems

if TYPE_CHECKING:
    from trimmer.proof import Proof

PROOFS = FOLDER / "proofs"
ORBITS = {
    "period": r"a period within (?P<off>\S+), relative, of (?P<value>\S+) s",
    "events per period": r"with the (?P<value>\d+) events of this file",
    "largest multiplier": r" is between (?P<lower>\S+) and (?P<upper>\S+)\.$",
}
PLACE = r"exactly one solution .* within (?P<off>\S+), relative, of its place: "
PREDICTED = {
    "predicted amplitude": PLACE + r"A = (?P<value>\S+),",
    "predicted period": PLACE + r"A = \S+, omega = (?P<omega>\S+) rad/s\.$",
}
SPECIAL = {"fold", "period-doubling"}
VALUE = r": a {} within (?P<off>\S+), relative, of v = (?P<value>\S+)\.$"


def file_of(problem: Problem, digit: Digit) -> Path:
    """Return where the proof of a digit is kept if there is one."""
    return PROOFS / f"{problem.name}-{digit.name.replace(' ', '-')}.json"


def digits_of(digit: Digit, theorem: str) -> int:
    """Return how many digits of a number a theorem says, no more than are printed.

    Returns:
        0 if the theorem says nothing of it, or another number.
    """
    kind = digit.ours[2] if digit.ours[1:2] == ("special",) else "nothing"
    found = re.search({**ORBITS, **PREDICTED}.get(digit.name, VALUE.format(kind)), theorem)
    if found is None:
        return 0
    told = {name: float(value) for name, value in found.groupdict().items()}
    if "omega" in told:
        told["value"] = math.tau / told["omega"]
    turns = math.tau if digit.ours[-1:] == ("turns",) else 1.0
    middle = turns * told["value"] if "value" in told else 0.5 * (told["lower"] + told["upper"])
    off = told.get("off", 0.5 * (told.get("upper", middle) - told.get("lower", middle)) / middle)
    # The theorem is told to a last digit, as is what is held against it.
    off = max(off, digit.agreement)
    return math.floor(-math.log10(off)) if abs(digit.value / middle - 1.0) <= off else 0


def proven_digits(problem: Problem, digit: Digit) -> int:
    """Return how many digits of a number its kept proof says; 0 if there is none."""
    path = file_of(problem, digit)
    return digits_of(digit, json.loads(path.read_text(encoding="utf-8"))["theorem"]) if path.exists() else 0


def prove(problem: Problem, digit: Digit) -> Proof | None:
    """Prove what a digit is of; None if that is not covered."""
    from trimmer import ClosedLoop, Mechanism, follow, respond
    from trimmer.proof import prove_limit_cycles, prove_orbit, prove_special_point

    if problem.python:
        if digit.name not in {*ORBITS, *PREDICTED}:
            return None
        named = ask.names_of(problem)
        if digit.name in PREDICTED:
            return prove_limit_cycles(ClosedLoop(named["plant"], named["relay"]), [named["predicted"]])
        orbit = named["motion"].orbit if "motion" in named else named["orbit"]
        return prove_orbit(orbit.subject, orbit)
    with TemporaryDirectory() as folder:
        ask.write_files(problem, Path(folder))
        machine = Mechanism.from_toml(Path(folder) / ask.FILE)
    command = problem.asks[str(digit.ours[0])]
    if digit.name in ORBITS and (command == "respond FILE" or "settles_to" in digit.ours):
        orbit = respond(machine).motion.orbit
        return None if orbit is None else prove_orbit(machine, orbit)
    if digit.ours[1] != "special" or digit.ours[2] not in SPECIAL:
        return None
    words = shlex.split(command)
    options = dict(zip(words[2::2], words[3::2], strict=True))
    place, first, last = options["--vary"], float(options["--from"]), float(options["--to"])
    branch = follow(machine.with_value(place, first), place, first, last)
    value = digit.value / (math.tau if digit.ours[-1] == "turns" else 1.0)
    points = [each for each in branch.special if each.kind.word == digit.ours[2]]
    return prove_special_point(machine, branch, min(points, key=lambda each: abs(each.value - value)))


def main() -> None:
    """Prove what can be proven, and keep it."""
    parser = ArgumentParser(prog="python -m benchmarks.problems.proven", description=__doc__)
    parser.add_argument("names", nargs="*", help="names of problems (default: all)")
    names = parser.parse_args().names
    PROOFS.mkdir(exist_ok=True)
    for problem in problems():
        for digit in problem.digits if not names or problem.name in names else ():
            proof = prove(problem, digit)
            if proof is None:
                continue
            count = digits_of(digit, proof.theorem)
            print(
                f"{problem.name}, {digit.name}: {proof.verdict}, {count} digits. {proof.reason}", flush=True
            )
            if count:
                proof.write(file_of(problem, digit))


if __name__ == "__main__":
    main()
