"""What a report was made from and when stands below its title, and the same input gives the same bytes."""

import hashlib
from importlib.metadata import version
from pathlib import Path

import pytest

from report.cache.stage_store import StageStore
from report.design.building import files_of, report_on
from report.design.origin import origin_of, today
from report.design.tables.judged import provenance_rows
from report.pages.formats import Format, Paper
from report.pages.provenance import RELEASED, provenance
from tests.report.design.conftest import TEXT
from trimmer import MechanismError
from trimmer.command_line.main import main
from trimmer.design import read_design_file
from trimmer.design.specification.design_file import design_file_of_text

BOTH = frozenset({Format.HTML, Format.PDF})


def test_date_version_hash_and_author_stand_below_the_title(tmp_path: Path) -> None:
    path = tmp_path / "desk.toml"
    raw = b"\xef\xbb\xbf" + f'author = "A. <b> Author"\r\n{TEXT}'.encode()
    path.write_bytes(raw)
    file = read_design_file(path)
    digest = hashlib.sha256(raw).hexdigest()
    origin = origin_of([file], "2026-03-01")
    assert origin.line.startswith("by A. <b> Author; made on 2026-03-01 with trimmer ")
    assert origin.line.endswith(f"from {path} (SHA-256 {digest[:12]}…)")
    assert provenance_rows(origin)[1] == [f"`{path}`", f"author: A. <b> Author; SHA-256: {digest}"]
    nobody = origin_of([design_file_of_text(TEXT, "a.toml"), file], "2026-03-01").line
    assert nobody.startswith("by A. <b> Author; made on")
    assert origin_of([design_file_of_text(TEXT, "a.toml")], "2026-03-01").line.startswith("made on")


def test_code_outside_of_a_checkout_is_told_by_its_version(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("GIT_DIR", "nowhere")
    assert provenance().line == f"trimmer {version('trimmer')}, commit none (not a git checkout), {RELEASED}"


@pytest.mark.parametrize("author", ["3", '"a\\nb"', "[]"])
def test_an_author_is_text_on_one_line(author: str) -> None:
    with pytest.raises(MechanismError, match=r"line 1: author.*names who wrote the file"):
        design_file_of_text(f"author = {author}\n{TEXT}", "desk.toml")


def test_source_date_epoch_is_the_date(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("SOURCE_DATE_EPOCH", "86399")
    assert today() == "1970-01-01"
    monkeypatch.setenv("SOURCE_DATE_EPOCH", "86400")
    assert today() == "1970-01-02"


@pytest.mark.parametrize("command", ["design", "compare"])
@pytest.mark.parametrize("given", ["yesterday", "-1", "1e9", "9" * 30, "٣"])
def test_a_wrong_date_is_told_before_any_work(command, given, tmp_path, monkeypatch, capsys) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("SOURCE_DATE_EPOCH", given)
    (tmp_path / "a.toml").write_text(TEXT)
    assert main([command, *(["a.toml"] if command == "design" else ["a.toml", "a.toml"])]) == 2
    assert "SOURCE_DATE_EPOCH=" in capsys.readouterr().err
    assert [path.name for path in tmp_path.iterdir()] == ["a.toml"]


@pytest.mark.slow
def test_the_same_input_on_the_same_day_gives_the_same_bytes(design, report, store, tmp_path) -> None:
    again = report_on(design, StageStore(tmp_path), "2026-03-01")
    first, second, other = (
        files_of(each, BOTH, Paper.A4) for each in (report, again, report_on(design, store, "2026-03-02"))
    )
    assert first == second
    assert all(first[form] != other[form] for form in BOTH)
