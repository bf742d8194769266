"""The comparison of two builds notices what a reader would notice, and nothing else."""

from __future__ import annotations

import importlib.util
import json
from pathlib import Path
from types import ModuleType

import pytest
import typst

PAGE = """<header><p>commit {commit}</p></header><main>
<p>The amplitude is {amplitude} m. <a class="file" href="#code-a">{source}</a></p>
<h2 id="provenance">Provenance</h2><p>{commit}</p><h2 id="errata">Errata sheet</h2><p>None.</p>
<h2 id="code">Code</h2><pre>{source}</pre></main>"""


@pytest.fixture(scope="module")
def comparison(project_folder: Path) -> ModuleType:
    path = project_folder / "scripts" / "compare_builds.py"
    specification = importlib.util.spec_from_file_location("compare_builds", path)
    assert specification is not None and specification.loader is not None
    module = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(module)
    return module


def build(folder: Path, *, amplitude: str = "1.5", commit: str = "a", source: str = "report/a.py") -> Path:
    """Write what a build writes, but for the PDF."""
    folder.mkdir()
    claim = {"id": "eq-1", "verdict": "erratum", "derived": amplitude, "source": source}
    (folder / "claims.json").write_text(json.dumps({"claims": [claim]}), encoding="utf-8")
    page = PAGE.format(amplitude=amplitude, commit=commit, source=source)
    (folder / "report.html").write_text(page, encoding="utf-8")
    return folder


@pytest.fixture
def differences(comparison: ModuleType, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr(comparison.shutil, "which", lambda _: None)
    return lambda old, new: list(comparison.differences(old, new))


def test_commit_and_source_paths_do_not_count(tmp_path: Path, differences) -> None:
    old, new = build(tmp_path / "old"), build(tmp_path / "new", commit="b", source="report/b.py")
    assert differences(old, new) == ["report.pdf: not compared, pdftotext is not installed"]


def test_a_digit_counts_in_the_claims_and_on_the_page(tmp_path: Path, differences) -> None:
    first, second, *others = differences(build(tmp_path / "old"), build(tmp_path / "new", amplitude="1.6"))
    assert first == "eq-1, derived:\n  - 1.5\n  + 1.6"
    assert second.startswith("report.html: -") and "1.5" in second
    assert len(others) == 2


def test_what_a_command_prints_counts(tmp_path: Path, differences) -> None:
    old, new = build(tmp_path / "old"), build(tmp_path / "new")
    (new / "commands.json").write_text("{}\n", encoding="utf-8")
    assert "commands.json: +{}" in differences(old, new)


@pytest.mark.poppler
def test_a_word_of_the_pdf_counts_and_the_provenance_does_not(tmp_path: Path, comparison: ModuleType) -> None:
    provenance = "Provenance\n\nMade from\n\ntypst\n\n0.15.0"
    source = f"trimmer 0.1.0, commit abc\n\nThe gap is 0.25 mm.\n\n{provenance}\n\nErrata"
    for name, text in (
        ("old", source),
        ("other", source.replace("abc", "def")),
        ("new", source.replace("0.25", "0.52")),
    ):
        pdf = typst.compile({"main": f"#v(2cm)\n{text}".encode()}, format="pdf")
        (tmp_path / f"{name}.pdf").write_bytes(pdf)
    old, other, new = (comparison.pdf_words(tmp_path / f"{name}.pdf") for name in ("old", "other", "new"))
    assert {"gap", "0.25", "Errata"} <= set(old)
    assert old == other
    assert set(old) ^ set(new) == {"0.25", "0.52"}
