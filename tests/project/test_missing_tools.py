"""A test that needs a program that is not installed is skipped and says why; in CI it fails."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

PACKAGES = {"browser": "chromium", "octave": "octave-control", "poppler": "poppler-utils"}
"""By the marker of the tests that need a program of it."""
EXAMPLE = """
@pytest.mark.{marker}
def test_with_{marker}(): pass
"""
EXAMPLES = "import pytest\n" + "".join(EXAMPLE.format(marker=marker) for marker in PACKAGES)
SETTINGS = "[tool.pytest.ini_options]\nmarkers = ['browser', 'octave', 'poppler']\n"


@pytest.mark.slow
@pytest.mark.parametrize(("ci", "outcome"), [("", "3 skipped"), ("true", "3 errors")])
def test_missing_programs(tmp_path: Path, project_folder: Path, ci: str, outcome: str) -> None:
    shutil.copy(project_folder / "tests" / "conftest.py", tmp_path)
    (tmp_path / "pyproject.toml").write_text(SETTINGS, encoding="utf-8")
    (tmp_path / "test_example.py").write_text(EXAMPLES, encoding="utf-8")
    variables = {name: value for name, value in os.environ.items() if not name.startswith("PYTEST")}
    variables |= {"CI": ci, "PATH": str(tmp_path)}
    ended = subprocess.run(
        [sys.executable, "-m", "pytest", "-rsE", "-p", "no:cacheprovider", "-p", "no:xdist"],
        cwd=tmp_path,
        env=variables,
        capture_output=True,
        text=True,
    )
    assert outcome in ended.stdout
    for package in PACKAGES.values():
        assert f"(package {package})" in ended.stdout
