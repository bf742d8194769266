"""The commands: ``map``, ``run`` and ``summary``; ``all`` does one after the other."""

import argparse
import json
import sys
import time
from collections.abc import Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor, as_completed
from dataclasses import asdict
from datetime import date
from functools import cache
from pathlib import Path
from queue import SimpleQueue

from scripts.mutation import __doc__ as description
from scripts.mutation.child import load
from scripts.mutation.claims import Judged
from scripts.mutation.judging import Judge, unaltered
from scripts.mutation.line_map import digest, read_map, record, unrecorded
from scripts.mutation.mutants import Mutant, drawn
from scripts.mutation.records import Noticed, Outcome, Records
from scripts.mutation.summary import count, lines, one_line, read_equivalent
from scripts.mutation.tree import Tree, copied

PROJECT = Path(__file__).resolve().parents[2]
FOLDER = PROJECT / "build" / "mutation"
CLAIMS = "claims.json"
MAPPED = "0"
"""Folder of the copy that is loaded; those in which sources are changed have the next numbers."""
MEASURED = PROJECT / "report" / "data" / "mutation.json"
"""What the report's chapter on the method prints."""


def main(arguments: Sequence[str] | None = None) -> int:
    """Do what the command line says; return the exit code."""
    wanted = _parser().parse_args(arguments)
    FOLDER.joinpath("printed").mkdir(parents=True, exist_ok=True)
    try:
        _act(wanted)
    except BlockingIOError:
        print("error: another run is using build/mutation; wait for it, or end it", file=sys.stderr)
        return 2
    return 0


def _act(wanted: argparse.Namespace) -> None:
    if wanted.action in ("map", "all"):
        record_map(wanted.processes, wanted.tests)
    if wanted.action in ("run", "all"):
        judge_mutants(wanted)
    if wanted.action in ("summary", "all"):
        summarise(wanted)


def record_map(processes: int, tests: str) -> None:
    """Record which test file runs which line, where that is not known."""
    for file in record(_loaded(), FOLDER, processes, tests):
        print(f"{file.seconds:6.1f} s  {file.path}  {file.failed and 'FAILS: ' + file.failed}", flush=True)


@cache
def _loaded() -> Tree:
    """Return the copy whose project and tests are loaded once, for all processes."""
    tree = copied(PROJECT, FOLDER / MAPPED)
    load(tree.root, tree.numba)
    return tree


def judge_mutants(wanted: argparse.Namespace) -> None:
    """Judge what has no outcome yet, in as many copies of the project as there are processes."""
    loaded = _loaded()
    trees = [copied(PROJECT, FOLDER / str(number)) for number in range(1, wanted.processes + 1)]
    if missing_files := unrecorded(trees[0].root, FOLDER):
        raise SystemExit(
            f"error: which lines {len(missing_files)} test files run is not known, or has changed "
            f"({missing_files[0]}); run the action map first"
        )
    line_map = read_map(trees[0].root, FOLDER)
    for failed in line_map.unusable:
        print(f"not used, it fails in the unaltered copy: {failed}", flush=True)
    known = _claims(trees)
    records = _records(wanted)
    mutants = drawn(PROJECT, wanted.seed, wanted.count, wanted.only)
    before = {key: outcome for key, (_, outcome) in records.read().items()}
    missing = [mutant for mutant in mutants if _is_open(before.get(mutant.key), wanted.again)]
    free: SimpleQueue[Judge] = SimpleQueue()
    for tree in trees:
        free.put(Judge(tree, loaded, line_map, known, wanted.both, wanted.every))

    def judge(mutant: Mutant) -> tuple[Mutant, Outcome]:
        with_tree = free.get()
        try:
            return mutant, with_tree.outcome(mutant)
        finally:
            free.put(with_tree)

    pool = ThreadPoolExecutor(wanted.processes)
    try:
        for done, finished in enumerate(
            as_completed([pool.submit(judge, each) for each in missing]), start=1
        ):
            mutant, outcome = finished.result()
            records.add(mutant, outcome)
            print(f"{done}/{len(missing)} {_line(mutant, outcome)}", flush=True)
    finally:
        pool.shutdown(cancel_futures=True)


def _line(mutant: Mutant, outcome: Outcome) -> str:
    how = outcome.claims or outcome.tests or (outcome.text and f"shown otherwise in {outcome.text}")
    return f"{outcome.noticed.value:8}{outcome.seconds:6.0f} s  {one_line(mutant)}  [{one_line(how)[:120]}]"


def summarise(wanted: argparse.Namespace) -> None:
    """Print what was noticed; write it for the report if that is wanted."""
    found = _records(wanted).read()
    keys = [mutant.key for mutant in drawn(PROJECT, wanted.seed, wanted.count, wanted.only)]
    judged = [found[key] for key in keys if key in found]
    if len(judged) < len(keys):
        print(f"{len(keys) - len(judged)} of {len(keys)} are not judged yet")
    if not judged:
        return
    equivalent = read_equivalent()
    print("\n".join(lines(judged, equivalent)))
    if wanted.write:
        if len(judged) < len(keys) or wanted.only:
            raise SystemExit("error: only a whole run over all packages is kept for the report")
        counts = count(judged, equivalent)
        content = {
            "date": date.today().isoformat(),
            "command": f"make mutate ARGS='--seed {wanted.seed} --count {wanted.count}'",
            **{
                name: getattr(counts, name)
                for name in ("drawn", "equivalent", "claims", "tests", "nothing", "texts")
            },
            "interval": [round(end, 6) for end in counts.interval],
        }
        MEASURED.write_text(json.dumps(content, indent=1) + "\n", encoding="utf-8")


def _claims(trees: Sequence[Tree]) -> list[Judged]:
    """Return the claims of the unaltered project, judged again if a source or datum has changed."""
    key = list(_digests(trees[0].root))
    path = FOLDER / CLAIMS
    if path.exists():
        kept = json.loads(path.read_text(encoding="utf-8"))
        if kept["key"] == key:
            return [Judged(**{**each, "needs": tuple(each["needs"])}) for each in kept["claims"]]
    started = time.monotonic()
    known = unaltered(trees)
    content = {"key": key, "claims": [asdict(each) for each in known]}
    path.write_text(json.dumps(content), encoding="utf-8")
    print(f"claims of the unaltered project judged in {time.monotonic() - started:.0f} s", flush=True)
    return known


def _digests(root: Path) -> Iterator[str]:
    for folder in ("derivations", "trimmer", "report"):
        for path in sorted((root / folder).rglob("*")):
            if path.suffix in (".py", ".csv", ".json", ".toml", ".gz", ".npz"):
                yield f"{path.relative_to(root)} {digest(path)}"


def _is_open(outcome: Outcome | None, again: bool) -> bool:
    return outcome is None or (again and outcome.noticed is Noticed.NOTHING)


def _records(wanted: argparse.Namespace) -> Records:
    return Records(FOLDER / f"seed-{wanted.seed}.jsonl")


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="python -m scripts.mutation",
        description=description,
        formatter_class=argparse.RawTextHelpFormatter,
    )
    parser.add_argument("action", choices=("map", "run", "summary", "all"))
    parser.add_argument("--seed", type=int, default=1, help="of the choice of places and changes (1)")
    parser.add_argument("--count", type=int, default=150, help="how many; a larger number goes on (150)")
    parser.add_argument(
        "--only", default="", metavar="PATH", help="a folder or source, such as trimmer/balance"
    )
    parser.add_argument("--tests", default="", metavar="PATH", help="map only: a folder of tests, or a file")
    parser.add_argument("--processes", type=int, default=2, help="how many at a time (2)")
    parser.add_argument(
        "--both", action="store_true", help="ask tests and claims, even if the first notices it"
    )
    parser.add_argument(
        "--every", action="store_true", help="note all tests that notice a change, not the first; takes long"
    )
    parser.add_argument("--again", action="store_true", help="judge those again that nothing has noticed")
    parser.add_argument(
        "--write", action="store_true", help=f"write the counts to {MEASURED.relative_to(PROJECT)}"
    )
    return parser


if __name__ == "__main__":
    sys.exit(main())
