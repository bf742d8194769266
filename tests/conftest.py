"""What all tests share: repeatable property tests, and tools that only some tests need."""

from __future__ import annotations

import os
import shutil
from pathlib import Path

import pytest
from hypothesis import settings

# The same examples in every run and on every computer; how long one takes depends on the computer.
settings.register_profile("repeatable", derandomize=True, deadline=None, database=None)
settings.load_profile("repeatable")

CHROMIUM = ("chromium", "chromium-browser", "google-chrome")
POPPLER = ("pdftotext", "pdfinfo", "pdftoppm")


def find_chromium() -> str | None:
    """Return the path of the first Chromium on PATH, None if there is none."""
    return next((path for name in CHROMIUM if (path := shutil.which(name))), None)


def missing_tool(marker: str) -> str | None:
    """Return what a marker's tests lack on this machine, None if nothing."""
    if marker == "browser" and find_chromium() is None:
        return "Chromium is not installed (package chromium)"
    if marker == "poppler" and not all(shutil.which(name) for name in POPPLER):
        return f"{', '.join(POPPLER)} are not all installed (package poppler-utils)"
    return None


def pytest_runtest_setup(item: pytest.Item) -> None:
    """Skip a test whose tool is missing and say why; in CI let it fail."""
    for marker in ("browser", "poppler"):
        if item.get_closest_marker(marker) is None or (missing := missing_tool(marker)) is None:
            continue
        if os.environ.get("CI") == "true":
            pytest.fail(f"needed in CI: {missing}", pytrace=False)
        pytest.skip(missing)


@pytest.fixture(scope="session")
def chromium() -> str:
    """Path of Chromium, for tests marked ``browser``."""
    path = find_chromium()
    assert path is not None, "mark tests that use this fixture with pytest.mark.browser"
    return path


@pytest.fixture(scope="session")
def project_folder() -> Path:
    """Folder of pyproject.toml."""
    return Path(__file__).parent.parent
