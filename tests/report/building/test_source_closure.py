"""What a module depends on is found from its source."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from report.building import source_closure
from report.building.source_closure import ROOT, digest

LOADED = """
import importlib, sys
importlib.import_module(sys.argv[1])
names = [name for name in sys.modules if name.split(".")[0] in ("derivations", "trimmer", "report")]
print("\\n".join(str(sys.modules[name].__file__) for name in names))
"""


@pytest.mark.parametrize(
    "module", ["derivations.backlash", "trimmer.motion.simulation", "report.claims.section_2_3_6"]
)
def test_everything_that_a_module_loads_is_in_its_closure(module: str) -> None:
    run = subprocess.run(
        [sys.executable, "-c", LOADED, module], capture_output=True, text=True, check=True, cwd=ROOT
    )
    loaded = {Path(line).resolve() for line in run.stdout.split()}
    assert len(loaded) > 3
    assert loaded <= {path.resolve() for path in source_closure.source_closure(module)}


def test_a_claim_does_not_depend_on_another_claim() -> None:
    names = {path.name for path in source_closure.source_closure("report.claims.section_2_3_6")}
    assert "section_2_3_6.py" in names
    assert "section_2_4.py" not in names


def test_other_libraries_are_left_out() -> None:
    assert source_closure.source_closure("numpy") == ()


def test_digest_changes_with_what_is_given() -> None:
    assert digest(["derivations.backlash"]) == digest(["derivations.backlash"])
    assert digest(["derivations.backlash"]) != digest(["derivations.friction"])
    assert digest(["derivations.backlash"], "1.0") != digest(["derivations.backlash"], "1.1")


def test_digest_changes_with_a_helper_of_a_helper(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    package = tmp_path / "report"
    package.mkdir()
    (package / "__init__.py").write_text("")
    (package / "first.py").write_text("def work():\n    from report import second\n    return second\n")
    (package / "second.py").write_text("from report.third import VALUE\n")
    (package / "third.py").write_text("VALUE = 1\n")
    monkeypatch.setattr(source_closure, "ROOT", tmp_path)

    def now() -> str:
        source_closure._imported.cache_clear()
        source_closure._sources_of.cache_clear()
        source_closure._content.cache_clear()
        return digest(["report.first"])

    before = now()
    (package / "third.py").write_text("VALUE = 2\n")
    assert now() != before
