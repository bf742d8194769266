"""Which test files are run for a mutant, and in which order."""

import re
from collections.abc import Iterable, Iterator, Sequence
from functools import cache
from pathlib import Path

from scripts.mutation.line_map import LineMap, TestFile
from scripts.mutation.mutants import Mutant

LONGEST = 400.0
"""Most processor time, s, as it was recorded, of the test files that are run for a mutant."""
BATCHES = (4.0, 16.0, 60.0)
"""Recorded times, s, up to which test files are collected and run together."""
JUDGING = "tests/report/"
"""Tests of the report, which are run for changes of the report: claims tell of the other packages."""


def chosen(mutant: Mutant, known: LineMap, root: Path) -> list[TestFile]:
    """Return the test files that may notice a mutant, the fastest first.

    Those that run one of its lines; for compiled code, which is not seen line by line, those that enter
    compiled code made of its source or that name its module. If there is none, as for what a module computes
    when it is imported, those that run anything of the source, or else of one that imports it.
    """
    of_report = mutant.path.startswith("report/")
    lines = range(mutant.lines[0], mutant.lines[1] + 1)
    usable = [file for file in known.usable if of_report or not file.path.startswith(JUDGING)]
    found = [file for file in usable if not file.lines.get(mutant.path, frozenset()).isdisjoint(lines)]
    if mutant.path in compiled_sources(root):
        # A function's first line is run when its module is imported, so lines say nothing here.
        found = [file for file in usable if _enters(file, mutant.path, root)]
    found = found or [file for file in usable if mutant.path in file.lines]
    found = found or [file for file in usable if not _importing(mutant.path, root).isdisjoint(file.lines)]
    named = [file for file in found if _names(file, mutant.path, root)]
    return within([*named, *(file for file in found if file not in named)], LONGEST)


def within(files: Iterable[TestFile], longest: float) -> list[TestFile]:
    """Return the first files that together take no longer than a time, s; the first in any case."""
    taken: list[TestFile] = []
    for file in files:
        if taken and sum(each.seconds for each in taken) + file.seconds > longest:
            break
        taken.append(file)
    return taken


def batches(files: Sequence[TestFile]) -> Iterator[list[TestFile]]:
    """Yield the files in groups that are run in one process: few at first, since most mutants fail early."""
    waiting, sizes = list(files), list(BATCHES)
    while waiting:
        group = within(waiting, sizes.pop(0) if len(sizes) > 1 else sizes[0])
        del waiting[: len(group)]
        yield group


@cache
def compiled_sources(root: Path) -> frozenset[str]:
    """Return the sources of compiled code: with functions that Numba compiles, or imported beside such."""
    found = {"trimmer/arrays.py"}
    for path in (root / "trimmer").rglob("*.py"):
        text, name = path.read_text("utf-8"), path.relative_to(root).as_posix()
        if re.search(r"from trimmer[.]hybrid[.]compilation import .*\b(kept|compiled|inlined)\b", text):
            folder = name.rpartition("/")[0]
            beside = re.findall(rf"from {folder.replace('/', '[.]')}[.](\w+) import", text)
            found |= {name, *(f"{folder}/{module}.py" for module in beside)}
    return frozenset(found)


@cache
def _importing(path: str, root: Path) -> frozenset[str]:
    """Return the sources that import one."""
    sources = (each for each in root.rglob("*.py") if "tests" not in each.relative_to(root).parts)
    return frozenset(each.relative_to(root).as_posix() for each in sources if _imports(each, path))


def _enters(file: TestFile, path: str, root: Path) -> bool:
    folder = path.rpartition("/")[0]
    if folder == "trimmer/hybrid" or path == "trimmer/arrays.py":
        entered = bool(file.entries)
    else:
        entered = path in file.entries or any(each.startswith(folder) for each in file.entries)
    return entered or _names(file, path, root)


def _names(file: TestFile, path: str, root: Path) -> bool:
    return _imports(root / file.path, path)


def _imports(importing: Path, path: str) -> bool:
    module = path.removesuffix(".py").removesuffix("/__init__").replace("/", ".")
    return bool(re.search(rf"(from|import) {re.escape(module)}\b", _text(importing)))


@cache
def _text(path: Path) -> str:
    return path.read_text("utf-8")
