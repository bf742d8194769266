"""Run the peers on the problems they can do, in one run with ours; run by ``make peers``.

What pip installs goes into an environment of its own, build/peers; Debian's packages are used where they are.
"""

import json
import math
import os
import shutil
import subprocess
import sys
import venv
from argparse import ArgumentParser
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from benchmarks.calibration import sentence
from benchmarks.peers.telling import shortest
from benchmarks.problems import ask
from benchmarks.problems.read import Digit, Problem, problems

PROJECT = Path(__file__).resolve().parents[2]
ENVIRONMENT = PROJECT / "build" / "peers"
PACKAGES = ("control==0.10.2", "mpmath", "mujoco==4.0.0", "pyHarm-os==1.2.2", "scipy==1.17.1")
LONGEST = 600.0  # A peer that takes longer, s, is ended; what it told until then is shown
OWN = "trimmer"


@dataclass(frozen=True)
class Peer:
    """A peer: its script, the Python that has it, and how to get it."""

    name: str
    script: str
    python: str
    how: str


PEERS = (
    Peer("SciPy", "with_scipy", str(ENVIRONMENT / "bin" / "python"), "pip install scipy"),
    Peer("python-control", "with_python_control", str(ENVIRONMENT / "bin" / "python"), "pip install control"),
    Peer("MuJoCo", "with_mujoco", str(ENVIRONMENT / "bin" / "python"), "pip install mujoco"),
    Peer("pyHarm", "with_pyharm", str(ENVIRONMENT / "bin" / "python"), "pip install pyHarm-os"),
    Peer("Siconos", "with_siconos", "/usr/bin/python3", "apt install python3-siconos"),
    Peer("AUTO-07p", "with_auto", "/usr/bin/python3", "apt install auto-07p gfortran"),
    Peer("NLvib", "with_nlvib", sys.executable, "from its authors, for Octave; let NLVIB name its folder"),
)
HEAD = """## Peers

Each peer at its defaults or at the settings of its own example, and at a finer one; ours in the same run, by
`make peers`. A time is the shortest of up to three runs and includes what a peer needs to settle, without
imports and compiling; ours, by the same rule, has all that the command tells.
The error is relative to the digits above.
These programs were made for more than these problems: SciPy integrates anything, python-control designs
controllers, MuJoCo moves robots in real time, Siconos follows many contacts with friction in space.
`trimmer follow` tells stability, all special points and the branches that part; pyHarm tells the branch, and
AUTO-07p stability, folds and period doublings of the stop as it was smoothed.

{calibration}; a loop that takes much longer tells of other work beside, and then times mean little.
{faster}

"""


def environment() -> None:
    """Make the environment of what pip installs, if it is not there."""
    if not (ENVIRONMENT / "bin" / "python").exists():
        venv.create(ENVIRONMENT, with_pip=True)
    pip = [str(ENVIRONMENT / "bin" / "python"), "-m", "pip", "install", "--quiet", *PACKAGES]
    subprocess.run(pip, check=False)


def told_by(peer: Peer, longest: float = LONGEST) -> tuple[list[dict[str, Any]], str]:
    """Return what a peer's script prints, and why that is not all; empty if it is."""
    if shutil.which(peer.python) is None:
        return [], f"not run here: {peer.how}"
    lack = ""
    with TemporaryDirectory() as folder:  # some peers leave files where they are run
        try:
            ended = subprocess.run(
                [peer.python, "-m", f"benchmarks.peers.{peer.script}"],
                cwd=folder,
                env={**os.environ, "PYTHONPATH": str(PROJECT)},
                capture_output=True,
                timeout=longest,
            )
            printed = ended.stdout
            if ended.returncode:
                lack = f"not run here: {peer.how}"
        except subprocess.TimeoutExpired as late:
            printed, lack = late.stdout or b"", f"not ended after {longest:g} s"
    return [json.loads(line) for line in printed.decode().splitlines() if line.startswith("{")], lack


def ours(problem: Problem, digit: Digit) -> dict[str, Any]:
    """Return the digit as the package finds it, with its time."""
    ask.one(problem, digit)  # Compiles, where nothing has done so before
    value, seconds = shortest(lambda: ask.one(problem, digit))
    told = {"peer": OWN, "setting": "as it is", "problem": problem.name, "digit": digit.name}
    return {**told, "value": value, "seconds": seconds}


def asked() -> tuple[list[tuple[dict[str, Any], Digit]], dict[str, str]]:
    """Return what peers and ours told of each digit, ours last, and why not all of a peer is there."""
    known = {problem.name: problem for problem in problems()}
    told = {peer.name: told_by(peer) for peer in PEERS}
    entries = [entry for found, _ in told.values() for entry in found]
    pairs = []
    for name, wanted in dict.fromkeys((entry["problem"], entry["digit"]) for entry in entries):
        problem = known[name]
        digit = next(each for each in problem.digits if each.name == wanted)
        of_it = [entry for entry in entries if (entry["problem"], entry["digit"]) == (name, wanted)]
        pairs += [(entry, digit) for entry in [*of_it, ours(problem, digit)]]
    return pairs, {name: lack for name, (_, lack) in told.items() if lack}


def faster(pairs: list[tuple[dict[str, Any], Digit]]) -> str:
    """Return a sentence on which peers took less time than ours."""
    own = {(e["problem"], e["digit"]): e["seconds"] for e, _ in pairs if e["peer"] == OWN}
    found = [
        f"{e['peer']} ({e['setting']}) on `{e['problem']}`"
        for e, _ in pairs
        if e["peer"] != OWN and e.get("seconds", math.inf) < own[e["problem"], e["digit"]]
    ]
    return f"Faster than ours: {'; '.join(dict.fromkeys(found))}." if found else "None was faster than ours."


def written(pairs: list[tuple[dict[str, Any], Digit]], missing: dict[str, str], calibration: str) -> str:
    """Return the whole table, Markdown."""
    head = "| problem | digit | peer | settings | time | error |\n| --- | --- | --- | --- | --- | --- |\n"
    lines = [HEAD.format(calibration=calibration, faster=faster(pairs)), head]
    lines += [row(entry, digit) for entry, digit in pairs]
    lines += [f"| | | {name} | {why} | | |\n" for name, why in missing.items()]
    return "".join(lines)


def row(entry: dict[str, Any], digit: Digit) -> str:
    """Return a row of the table."""
    head = f"| `{entry['problem']}` | {entry['digit']} | {entry['peer']} | {entry['setting']} |"
    if "failed" in entry:
        return f"{head} | {entry['failed']} |\n"
    error = abs(entry["value"] / digit.value - 1.0)
    shown = f"below {digit.agreement:.0e}" if error < digit.agreement else f"{error:.0e}"
    return f"{head} {1e3 * entry['seconds']:.3g} ms | {shown} |\n"


def main() -> None:
    """Write the table, and print it."""
    parser = ArgumentParser(prog="python -m benchmarks.peers.run", description=__doc__)
    parser.add_argument("--output", type=Path, default=PROJECT / "benchmarks" / "peers" / "table.md")
    output: Path = parser.parse_args().output
    environment()
    table = written(*asked(), sentence().capitalize())
    output.write_text(table, encoding="utf-8")
    print(table)


if __name__ == "__main__":
    main()
    sys.exit(0)
