"""Mutants are made in a copy, their outcomes are kept, and the summary counts them."""

import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import pytest
from scipy.stats import norm

from scripts.mutation.choice import chosen
from scripts.mutation.line_map import LineMap, TestFile
from scripts.mutation.mutants import Mutant, drawn, mutants_of, places_of
from scripts.mutation.operators import Kind
from scripts.mutation.patching import patch_of
from scripts.mutation.records import Outcome
from scripts.mutation.summary import count, identity, read_equivalent
from scripts.mutation.tree import copied

SOURCE = "def area(a, b):\n    return a * b\n"


def mutant(number: int = 1, kind: Kind = Kind.ARITHMETIC) -> Mutant:
    places = (2, "return a * b", (2, 2), (27, 32), "digest")
    return Mutant("trimmer/area.py", "area", kind, "a * b", f"(a - {number} * b)", *places)


def file(name: str, seconds: float, lines: set[int], failed: str = "") -> TestFile:
    return TestFile(
        f"tests/{name}.py", seconds, failed, {"trimmer/area.py": frozenset(lines)}, frozenset(), {}
    )


@pytest.fixture
def project(tmp_path: Path) -> Path:
    root = tmp_path / "project"
    for folder in ("trimmer", "derivations", "tests"):
        (root / folder).mkdir(parents=True)
    (root / "trimmer" / "__init__.py").touch()
    (root / "trimmer" / "area.py").write_text(SOURCE, encoding="utf-8")
    subprocess.run(["git", "init", "-q"], cwd=root, check=True)
    return root


def test_a_mutant_is_made_in_the_copy_and_taken_back(project: Path, tmp_path: Path) -> None:
    tree = copied(project, tmp_path / "copy")
    (change,) = [each for each in drawn(project, 1, 9) if each.kind is Kind.ARITHMETIC]
    copy = tree.root / "trimmer" / "area.py"
    times = copy.stat().st_mtime_ns
    command = [sys.executable, "-c", "from trimmer.area import area; print(area(6, 2))"]
    with tree.changed(change, compiled=False) as numba:
        assert numba == tree.numba
        assert subprocess.run(command, cwd=tree.root, capture_output=True, check=True).stdout == b"3.0\n"
        assert (project / "trimmer" / "area.py").read_text("utf-8") == SOURCE
    assert copy.read_text("utf-8") == SOURCE
    assert copy.stat().st_mtime_ns == times
    assert subprocess.run(command, cwd=tree.root, capture_output=True, check=True).stdout == b"12\n"


LOADED = """
from functools import cache


class Plate:
    def __init__(self, width):
        self.width = width

    @property
    def area(self):
        return area(self.width, 2)


@cache
def area(a, b=3):
    return a * b
"""


def test_a_function_that_is_loaded_gets_its_changed_code(tmp_path: Path, monkeypatch) -> None:
    path = tmp_path / "plates.py"
    path.write_text(LOADED, encoding="utf-8")
    monkeypatch.syspath_prepend(tmp_path)
    import plates

    changes = [each for place in places_of(tmp_path, path) for each in mutants_of(place)]
    product = next(each for each in changes if each.kind is Kind.ARITHMETIC)
    default = next(each for each in changes if each.kind is Kind.DEFAULT)
    assert patch_of(default, path.read_bytes()) is None
    patch = patch_of(product, path.read_bytes())
    assert patch is not None and patch.apply(tmp_path)
    assert plates.Plate(6).area == 3.0
    assert not replace(patch, name="volume", source="def volume(): pass", line=1).apply(tmp_path)


def test_test_files_are_those_that_run_a_line_the_one_that_names_the_module_first(tmp_path: Path) -> None:
    (tmp_path / "trimmer").mkdir()
    (tmp_path / "tests").mkdir()
    for name in ("a", "b", "c", "d"):
        (tmp_path / "tests" / f"{name}.py").write_text("import trimmer.area\n" if name == "c" else "")
    failed = file("d", 0.1, {2}, failed="tests/d.py::test_x")
    known = LineMap([file("a", 2.0, {1, 2}), file("b", 1.0, {1}), file("c", 9.0, {2}), failed])
    assert [each.path for each in chosen(mutant(), known, tmp_path)] == ["tests/c.py", "tests/a.py"]
    only_imported = LineMap(known.files[1:2])
    assert [each.path for each in chosen(mutant(), only_imported, tmp_path)] == ["tests/b.py"]
    assert known.unusable == ("tests/d.py::test_x",)


def test_the_share_is_of_those_with_an_effect() -> None:
    noticed = [(mutant(k), Outcome(tests="x")) for k in range(40)]
    noticed += [(mutant(k), Outcome(claims="x", tests="y")) for k in range(40, 57)]
    missed = [(mutant(k), Outcome(tests="", claims="", text="eq-2.8" * (k == 57))) for k in range(57, 61)]
    counts = count([*noticed, *missed], frozenset({identity(mutant(60)), identity(mutant(3))}))
    told = counts.drawn, counts.equivalent, counts.claims, counts.tests, counts.nothing
    assert told == (61, 1, 17, 40, 3)
    assert counts.texts == 1
    assert counts.share == pytest.approx(57 / 60)
    # Wilson 1927: the roots p of (p - 57/60)**2 = z**2 p (1 - p)/60.
    z = norm.ppf(0.975)
    for end in counts.interval:
        assert (end - 57 / 60) ** 2 == pytest.approx(z**2 * end * (1 - end) / 60, rel=1e-9)
    assert counts.interval[0] < 57 / 60 < counts.interval[1]


def test_each_listed_equivalent_has_a_reason(tmp_path: Path) -> None:
    assert all(len(row) == 5 for row in read_equivalent())
    path = tmp_path / "equivalent.csv"
    path.write_text("path,function,context,before,after,reason\ntrimmer/a.py,f,x,y,z,\n", encoding="utf-8")
    with pytest.raises(ValueError, match="no reason"):
        read_equivalent(path)
