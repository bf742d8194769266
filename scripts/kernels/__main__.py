"""The runs: which there are here, one after the other, and what came of them."""

import argparse
import os
import subprocess
import sys
import time
import xml.etree.ElementTree as ElementTree
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from difflib import unified_diff
from pathlib import Path

from scripts.kernels import __doc__ as description
from scripts.kernels.processor import KERNELS, Kernel, plain_environment, processor_flags
from scripts.kernels.pythons import PROJECT, environment, interpreter, other_versions

FOLDER = PROJECT / "build" / "kernels"
CHOICES = (("Prescott", 1, False), ("Nehalem", 2, True), ("Haswell", 2, False), ("SkylakeX", 1, False))
"""Kernel, threads of BLAS, and whether Numba compiles for any processor: each pair of two values occurs."""
PYTEST = (
    "-m",
    "pytest",
    "-q",
    "-n",
    "auto",
    "--maxprocesses",
    "4",
    "--dist",
    "loadfile",
    "-p",
    "no:cacheprovider",
)
FEATURES = """
from numpy._core._multiarray_umath import __cpu_dispatch__, __cpu_features__
print(*(each for each in __cpu_dispatch__ if __cpu_features__[each]))
"""
MOST_SHOWN = 40
"""Lines of a difference between two lists of claims that are printed."""


@dataclass(frozen=True)
class Run:
    """The tests once, in a given way."""

    name: str  # What it is called, also its folder
    kernel: Kernel | None  # Of OpenBLAS; None where it cannot be chosen
    threads: int  # Of BLAS
    generic: bool = False  # Whether Numba compiles for any processor
    version: str | None = None  # Of Python; None for that of this process

    def __str__(self) -> str:
        """Return its line of the list."""
        code = "any processor" if self.generic else "this processor"
        python = self.version or "{}.{}".format(*sys.version_info)
        return f"{self.name:12} BLAS threads {self.threads}, Numba for {code}, Python {python}"


@dataclass(frozen=True)
class Result:
    """What came of a run: counts of its tests, whether all claims were judged, and its time, s."""

    run: Run
    passed: int
    failed: int
    skipped: int
    claims: Path | None
    seconds: float


def main(arguments: Sequence[str] | None = None) -> int:
    """Run what the command line says; return the exit code."""
    wanted, rest = _parser().parse_known_args(arguments)
    found, left_out = listed()
    runs = [run for run in found if not wanted.only or run.name in wanted.only]
    for name in sorted(set(wanted.only) - {run.name for run in found}):
        print(f"error: there is no run {name!r} here; see --list", file=sys.stderr)
        return 2
    print("\n".join([*map(str, runs), *(f"left out: {reason}" for reason in left_out)]), flush=True)
    if wanted.list:
        return 0
    marked = "not slow" if wanted.whole else "digits and not slow"
    results = [carried_out(run, ["-m", marked, *rest]) for run in runs]
    return told(results, left_out)


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="python -m scripts.kernels",
        description=description,
        epilog="Other arguments are given to pytest.",
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("--list", action="store_true", help="say what would be run, and run nothing")
    parser.add_argument("--only", nargs="+", metavar="RUN", default=[], help="names of --list (default: all)")
    parser.add_argument("--whole", action="store_true", help="all quick tests, not only those marked digits")
    return parser


def listed() -> tuple[list[Run], list[str]]:
    """Return the runs that are possible here, and why the others are not."""
    flags = processor_flags()
    runs, left_out = [], []
    for name, threads, generic in CHOICES:
        missing = KERNELS[name].missing(flags)
        if "sse2" in flags and not missing:
            runs.append(Run(name, KERNELS[name], threads, generic))
        else:
            left_out.append(f"{name}: this processor has no {', '.join(missing or ['SSE2'])}")
    newest = runs[-1].kernel if runs else None
    runs = runs or [Run("as-it-is", None, 1), Run("generic", None, 2, True)]
    for version in other_versions():
        if interpreter(version) is None:
            left_out.append(f"Python {version}: it is neither on PATH nor below pyenv's versions")
        else:
            runs.append(Run(f"python-{version}", newest, 2, version=version))
    return runs, left_out


def carried_out(run: Run, options: list[str]) -> Result:
    """Run the tests and judge the claims; what the tests print is printed."""
    print(f"\n{run}", flush=True)
    begin = time.monotonic()
    folder = FOLDER / run.name
    folder.mkdir(parents=True, exist_ok=True)
    counted, judged = folder / "tests.xml", folder / "claims.json"
    for earlier in (counted, judged):
        earlier.unlink(missing_ok=True)
    python = _interpreter(run)
    if python is None:
        return Result(run, 0, 1, 0, None, time.monotonic() - begin)
    variables = _variables(run, python)
    subprocess.run(
        [python, *PYTEST, f"--junitxml={counted}", *options], cwd=PROJECT, env=variables, check=False
    )
    kernel = [run.kernel.name] if run.kernel else []
    judging = [python, "-m", "scripts.kernels.claims", judged, *kernel]
    told = subprocess.run(judging, cwd=PROJECT, env=variables, check=False).returncode
    passed, failed, skipped = _counts(counted)
    return Result(run, passed, failed, skipped, judged if told == 0 else None, time.monotonic() - begin)


def _interpreter(run: Run) -> Path | None:
    """Return the interpreter of a run, in an environment with the locked packages; None if that fails."""
    if run.version is None:
        return Path(sys.executable)
    base = interpreter(run.version)
    try:
        return environment(base, run.version, PROJECT / "build") if base else None
    except subprocess.CalledProcessError as error:
        print(f"error: no environment for Python {run.version}: {error}", file=sys.stderr, flush=True)
        return None


def _variables(run: Run, python: Path) -> dict[str, str]:
    """Return the variables of a run; bytecode is kept, or else each process compiles all sources again."""
    plain = plain_environment() | {"PYTHONDONTWRITEBYTECODE": ""}
    plain["PATH"] = os.pathsep.join([str(python.parent), plain.get("PATH", "")])
    if run.kernel is None:
        chosen = {"OPENBLAS_NUM_THREADS": str(run.threads)}
        return plain | chosen | ({"NUMBA_CPU_NAME": "generic"} if run.generic else {})
    asked = subprocess.run([python, "-c", FEATURES], env=plain, capture_output=True, text=True, check=True)
    return plain | run.kernel.environment(run.threads, run.generic, asked.stdout.split())


def _counts(report: Path) -> tuple[int, int, int]:
    """Return how many tests passed, failed and were skipped; a run that wrote no report has failed."""
    try:
        suite = next(ElementTree.parse(report).getroot().iter("testsuite"))
    except (OSError, ElementTree.ParseError, StopIteration):
        return 0, 1, 0
    number = {key: int(suite.get(key, 0)) for key in ("tests", "failures", "errors", "skipped")}
    failed = number["failures"] + number["errors"]
    passed = number["tests"] - failed - number["skipped"]
    return passed, failed + (passed == 0 and failed == 0), number["skipped"]


def told(results: list[Result], left_out: list[str]) -> int:
    """Print what came of all runs, ending with the sums; return the exit code."""
    print()
    failed = sum(result.failed for result in results)
    for result in results:
        counts = f"{result.passed} passed, {result.failed} failed, {result.skipped} skipped"
        print(f"{result.run}: {counts}, {result.seconds:.0f} s")
        if result.claims is None:
            print("  error: its claims were not judged")
            failed += 1
    for reason in left_out:
        print(f"left out: {reason}")
    differing = list(_differences([result for result in results if result.claims]))
    print("\n".join(differing) or "the claims have the same verdicts, texts and digits in all runs")
    failed += sum(not line.startswith("  ") for line in differing)
    print(f"{sum(result.passed for result in results)} passed, {failed} failed")
    return 1 if failed else 0


def _differences(results: list[Result]) -> Iterator[str]:
    """Yield a line for each run whose claims are not those of the first, then how they differ."""
    texts = [
        (result.run.name, result.claims.read_text(encoding="utf-8").splitlines())
        for result in results
        if result.claims
    ]
    for name, lines in texts[1:]:
        if lines != texts[0][1]:
            yield f"error: the claims of {name} are not those of {texts[0][0]}:"
            difference = unified_diff(texts[0][1], lines, texts[0][0], name, n=0, lineterm="")
            yield from (f"  {line[:300]}" for line, _ in zip(difference, range(MOST_SHOWN), strict=False))


if __name__ == "__main__":
    sys.exit(main())
