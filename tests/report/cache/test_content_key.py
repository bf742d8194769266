"""What is kept from the last build is given up when anything that it was made from has changed."""

from __future__ import annotations

from report.cache import content_key as module
from report.cache.content_key import content_key
from report.cache.source_closure import ROOT


def test_all_data_and_sources_count():
    counted = set(module._sources())
    files = (path for path in (ROOT / "report" / "data").rglob("*") if path.is_file())
    data = {path.relative_to(ROOT).as_posix() for path in files}
    assert "report/data/twin/branches.json" in data
    assert data <= counted
    assert "report/command.py" in counted


def test_the_key_changes_with_the_content_of_a_file_of_data(monkeypatch, tmp_path):
    before = content_key()
    sources = module._sources()
    changed = tmp_path / "thesis.toml"
    changed.write_text("lines = 1\n")
    monkeypatch.setattr(module, "_sources", lambda: {**sources, "report/data/thesis.toml": changed})
    assert content_key() != before
    monkeypatch.undo()
    assert content_key() == before
