"""A page of the site that is opened from a folder loads the site's own files, and nothing else."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from tests.report.rendering.page_checks import visited

PROJECT = Path(__file__).parents[2]
SETTINGS = """
site_name: small
site_dir: site
use_directory_urls: false
hooks: [hook.py]
theme: { name: material, font: false }
extra: { generator: false, polyfills: [javascripts/iframe-worker.js] }
plugins: [search, offline]
"""
HOOK = "from scripts.site.hooks import on_post_page"


@pytest.mark.browser
def test_search_works_under_the_policy_and_nothing_comes_from_elsewhere(browser, tmp_path) -> None:
    (tmp_path / "mkdocs.yml").write_text(SETTINGS)
    (tmp_path / "hook.py").write_text(HOOK)
    shutil.copytree(PROJECT / "docs" / "javascripts", tmp_path / "docs" / "javascripts")
    (tmp_path / "docs" / "index.md").write_text("# Home\n\n![a](http://127.0.0.1:9/a.png)\n")
    (tmp_path / "docs" / "other.md").write_text("# Other\n\nOf gearboxes.\n")
    built = subprocess.run(
        [sys.executable, "-m", "mkdocs", "build", "--quiet"],
        cwd=tmp_path,
        env={**os.environ, "PYTHONPATH": str(PROJECT), "NO_MKDOCS_2_WARNING": "1"},
        capture_output=True,
        text=True,
        check=False,
    )
    assert built.returncode == 0, built.stderr
    address = (tmp_path / "site" / "index.html").as_uri()
    with visited(browser, address) as visit:
        visit.page.locator("input.md-search__input").click()
        visit.page.keyboard.type("gearboxes")
        visit.page.locator(".md-search-result__item").first.wait_for()
        (complaint,) = visit.complaints
        assert "127.0.0.1:9/a.png" in complaint
        assert "Content Security Policy" in complaint
