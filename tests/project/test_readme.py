"""The README points at what is there; its blocks are run with those of the site."""

import re
from pathlib import Path

import pytest


@pytest.fixture(scope="module")
def readme(project_folder: Path) -> str:
    return (project_folder / "README.md").read_text(encoding="utf-8")


def test_files_it_points_at_are_there(readme: str, project_folder: Path) -> None:
    targets = re.findall(r"\]\(([^)#:]+)\)", readme)
    assert len(targets) >= 10
    assert [target for target in targets if not (project_folder / target).exists()] == []


def test_make_targets_it_names_exist(readme: str, project_folder: Path) -> None:
    makefile = (project_folder / "Makefile").read_text(encoding="utf-8")
    named = set(re.findall(r"`make ([a-z-]+)`", readme))
    assert {"docs", "report", "test"} <= named
    assert [name for name in named if not re.search(rf"^{name}:", makefile, flags=re.MULTILINE)] == []
