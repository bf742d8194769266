"""What a module depends on is found from its source."""

import json
import subprocess
import sys
from pathlib import Path

import pytest

from report.cache.source_closure import ROOT, SourceTree
from report.cache.stage_store import StageStore

LOADED = """
import importlib, json, sys
files = []
for module in sys.argv[1:]:
    importlib.import_module(module)
    ours = [name for name in sys.modules if name.split(".")[0] in ("derivations", "trimmer", "report")]
    files.append([str(sys.modules.pop(name).__file__) for name in ours])
print(json.dumps(files))
"""
"""Loads each module as a process does that has loaded nothing of this project."""
MODULES = (
    "derivations.elements.backlash",
    "trimmer.loops.simulation",
    "report.chapters.chapter_2.claims.section_2_3_6",
)


@pytest.fixture
def tree(source_tree: SourceTree) -> SourceTree:
    return source_tree


@pytest.mark.slow
def test_everything_that_a_module_loads_is_in_its_closure(tree: SourceTree) -> None:
    run = subprocess.run(
        [sys.executable, "-c", LOADED, *MODULES], capture_output=True, text=True, check=True, cwd=ROOT
    )
    for module, files in zip(MODULES, json.loads(run.stdout), strict=True):
        loaded = {Path(file).resolve() for file in files}
        assert len(loaded) > 3
        assert loaded <= {(ROOT / path).resolve() for path in tree.closure(module)}


def test_a_claim_does_not_depend_on_another_claim(tree: SourceTree) -> None:
    paths = tree.closure("report.chapters.chapter_2.claims.section_2_3_6")
    assert "report/chapters/chapter_2/claims/section_2_3_6.py" in paths
    assert "report/chapters/chapter_2/claims/section_2_4.py" not in paths


def test_other_libraries_are_left_out(tree: SourceTree) -> None:
    assert tree.closure("numpy") == frozenset()


def test_digest_changes_with_what_is_given(tree: SourceTree) -> None:
    digest = tree.digest
    assert digest(["derivations.elements.backlash"]) == digest(["derivations.elements.backlash"])
    assert digest(["derivations.elements.backlash"]) != digest(["derivations.elements.friction"])
    assert digest(["derivations.elements.backlash"], "1.0") != digest(
        ["derivations.elements.backlash"], "1.1"
    )


@pytest.fixture
def package(tmp_path: Path) -> Path:
    """A package whose first module needs the second, and that the third."""
    package = tmp_path / "report"
    package.mkdir()
    (package / "__init__.py").write_text("")
    (package / "first.py").write_text("def work():\n    from report import second\n    return second\n")
    (package / "second.py").write_text("from report.third import VALUE\n")
    (package / "third.py").write_text("VALUE = 1\n")
    (package / "fourth.py").write_text("VALUE = 1  # of no use\n")
    return package


def test_digest_changes_with_a_helper_of_a_helper(package: Path) -> None:
    before = SourceTree.read(package.parent).digest(["report.first"])
    (package / "fourth.py").write_text("VALUE = 2\n")
    assert SourceTree.read(package.parent).digest(["report.first"]) == before
    (package / "third.py").write_text("VALUE = 2\n")
    assert SourceTree.read(package.parent).digest(["report.first"]) != before


def test_imports_of_a_changed_source_are_read_again(package: Path, tmp_path: Path) -> None:
    root, store = package.parent, StageStore(tmp_path / "kept")
    first = SourceTree.kept(store, root)
    assert first == SourceTree.read(root) == SourceTree.kept(store, root)
    (package / "second.py").write_text("from report.fourth import VALUE\n")
    changed = SourceTree.kept(store, root)
    assert "report/fourth.py" in changed.closure("report.first")
    assert "report/third.py" not in changed.closure("report.first")
