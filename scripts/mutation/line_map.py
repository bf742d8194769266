"""Which test file runs which line: recorded once, and again for what has changed since."""

import hashlib
import json
from collections.abc import Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from functools import cached_property, partial
from pathlib import Path

from scripts.mutation.child import Place, run
from scripts.mutation.tested import recorded
from scripts.mutation.tree import Tree

MAP = "map.jsonl"
LIMIT = 900.0
"""Processor time of a test file, s, when it is recorded."""


@dataclass(frozen=True)
class TestFile:
    """A test file and what it runs."""

    __test__ = False

    path: str  # From the project's folder
    seconds: float  # Processor time that it took, s, while it was recorded
    failed: str  # The first test that failed in the unaltered copy; such a file is not used
    # Numbers of the lines that it ran, by source, those of its imports with them
    lines: Mapping[str, frozenset[int]]
    entries: frozenset[str]  # Modules whose compiled code it entered
    digests: Mapping[str, str]  # Of each source that it ran, and of itself

    def is_current(self, root: Path) -> bool:
        """Say whether nothing that it ran has changed."""
        return all(digest(root / path) == known for path, known in self.digests.items())

    def as_json(self) -> dict[str, object]:
        """Return it as a line of the map."""
        lines = {path: sorted(numbers) for path, numbers in self.lines.items()}
        return {**vars(self), "lines": lines, "entries": sorted(self.entries)}


@dataclass(frozen=True)
class LineMap:
    """All test files that can be used."""

    files: Sequence[TestFile]

    @cached_property
    def usable(self) -> tuple[TestFile, ...]:
        """Those that pass in the unaltered copy, the fastest first."""
        return tuple(sorted((file for file in self.files if not file.failed), key=lambda file: file.seconds))

    @property
    def unusable(self) -> tuple[str, ...]:
        """What fails in the unaltered copy."""
        return tuple(file.failed for file in self.files if file.failed)


def read_map(root: Path, folder: Path) -> LineMap:
    """Read what was recorded and is still true of a tree."""
    path = folder / MAP
    lines = path.read_text("utf-8").splitlines() if path.exists() else []
    latest = {file.path: file for file in map(_read, lines)}
    return LineMap([file for file in latest.values() if file.is_current(root)])


def record(tree: Tree, folder: Path, processes: int, only: str = "") -> Iterator[TestFile]:
    """Run each test file that has no true record, or those of a folder; yield it when it is recorded."""
    missing = [path for path in unrecorded(tree.root, folder) if path.startswith(only)]
    with ThreadPoolExecutor(processes) as pool:
        for file in pool.map(partial(_record, tree, folder), missing):
            with (folder / MAP).open("a", encoding="utf-8") as lines:
                lines.write(json.dumps(file.as_json()) + "\n")
            yield file


def unrecorded(root: Path, folder: Path) -> list[str]:
    """Return the paths of the test files of which nothing is known that still holds."""
    known = {file.path for file in read_map(root, folder).files}
    return [path for path in test_files(root) if path not in known]


def test_files(root: Path) -> list[str]:
    """Return the paths of all test files that are run."""
    return sorted(path.relative_to(root).as_posix() for path in (root / "tests").rglob("test_*.py"))


test_files.__test__ = False  # type: ignore[attr-defined]


def digest(path: Path) -> str:
    """Return a digest of a file, of one that is not there an empty text."""
    return hashlib.sha256(path.read_bytes()).hexdigest()[:16] if path.is_file() else ""


def _record(tree: Tree, folder: Path, path: str) -> TestFile:
    printed = folder / "printed" / f"{path.replace('/', '-')}.txt"
    ended = run(recorded, (path,), Place(tree.root, tree.numba, printed, loaded=True), LIMIT)
    failed, lines, entries = ended.value if isinstance(ended.value, tuple) else (str(ended.value), {}, ())
    digests = {name: digest(tree.root / name) for name in (path, *lines)}
    numbers = {name: frozenset(each) for name, each in lines.items()}
    return TestFile(path, ended.seconds, failed, numbers, frozenset(entries), digests)


def _read(line: str) -> TestFile:
    row = json.loads(line)
    lines = {path: frozenset(numbers) for path, numbers in row["lines"].items()}
    return TestFile(**{**row, "lines": lines, "entries": frozenset(row["entries"])})
