"""What is kept from the last build is given up when anything that it was made from has changed."""

import shutil
import subprocess
import sys
from pathlib import Path

import pytest

KEYS = """
import sys
from report.cache.content_key import content_key
print(content_key())
for name in sys.argv[1:]:
    open(name, "a").write("\\n")
    print(content_key())
"""
CHANGED = (
    "report/data/thesis.toml",
    "report/data/twin/branches.json",
    "report/command.py",
    "derivations/parts.py",
    "trimmer/files.py",
)


@pytest.fixture(scope="module")
def copy(tmp_path_factory: pytest.TempPathFactory, project_folder: Path) -> Path:
    """The three packages, as another user has them."""
    folder = tmp_path_factory.mktemp("copy")
    ignored = shutil.ignore_patterns("__pycache__", "fonts")
    for name in ("derivations", "trimmer", "report", "templates"):
        shutil.copytree(project_folder / name, folder / name, ignore=ignored)
    return folder


def keys(folder: Path, *changed: str) -> list[str]:
    """Return the key, and the key after each file has been changed."""
    run = subprocess.run(
        [sys.executable, "-c", KEYS, *changed], capture_output=True, text=True, check=True, cwd=folder
    )
    return run.stdout.split()


def test_the_key_changes_with_any_source_or_file_of_data(copy: Path) -> None:
    found = keys(copy, *CHANGED)
    assert len(set(found)) == len(found) == len({len(each) for each in found}) * (len(CHANGED) + 1)
    shutil.rmtree(copy / "trimmer" / "__pycache__", ignore_errors=True)
    assert keys(copy) == found[-1:]
