"""Every block of the site and of the README does what its page says."""

import re
from pathlib import Path

import pytest

from scripts.site.blocks import blocks
from scripts.site.running import run_page

PROJECT = Path(__file__).parents[2]
PAGES = [PROJECT / "README.md", *sorted((PROJECT / "docs").rglob("*.md"))]
RUN = [page for page in PAGES if any(block.is_run for block in blocks(page.read_text("utf-8")))]
NAMES = [page.relative_to(PROJECT).as_posix() for page in RUN]
READ_FIRST = PROJECT / "README.md"
"""The others are run, whole, by `make docs` too, and otherwise with the slow tests."""


def test_fast_blocks(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("MPLBACKEND", "agg")
    run_page(READ_FIRST, tmp_path, slow=False)


@pytest.mark.slow
@pytest.mark.parametrize("page", RUN, ids=NAMES)
def test_all_blocks(page: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("MPLBACKEND", "agg")
    run_page(page, tmp_path, slow=True)


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.relative_to(PROJECT).as_posix())
def test_no_block_goes_unseen(page: Path) -> None:
    """Each fence opens or closes a block that is known; what is not run says why."""
    text = page.read_text("utf-8")
    found = blocks(text)
    outputs = sum(block.output is not None for block in found)
    assert len(re.findall(r"^\s*(?:```|~~~)", text, re.MULTILINE)) == 2 * (len(found) + outputs)
    assert {block.language for block in found} <= {"python", "sh", "text", "toml"}
    for block in found:
        comments = ("", "slow") if block.language != "sh" else ("", "slow", "exit 2", "exit 3")
        assert block.comment in comments or re.match(r"not run: \w+", block.comment), block
        assert block.language != "text" or block.title is not None, f"line {block.line}: output of nothing"


def test_most_blocks_are_run() -> None:
    found = [block for page in PAGES for block in blocks(page.read_text("utf-8"))]
    skipped = [block for block in found if block.comment.startswith("not run")]
    assert len(skipped) <= 8
    assert sum(block.is_run for block in found) >= 45
