"""The lock files name every package exactly, with hashes, and nothing about where packages come from."""

import re
import tomllib
from pathlib import Path

import pytest

LOCKS = ("requirements.lock", "requirements-dev.lock")
PIN = re.compile(r"^([a-z0-9][a-z0-9.-]*)==([^ ;\\]+)(?: ; ([^\\]+?))? \\$")
HASH = re.compile(r"^    --hash=sha256:[0-9a-f]{64}(?: \\)?$")


def pins(path: Path) -> dict[tuple[str, str], str]:
    """Return the version of each (name, marker) of a lock file."""
    found = [PIN.match(line) for line in path.read_text(encoding="utf-8").splitlines()]
    return {(match[1], match[3] or ""): match[2] for match in found if match}


def names(requirements: list[object]) -> set[str]:
    """Return the normalised names of requirements as pyproject.toml writes them."""
    texts = [item for item in requirements if isinstance(item, str)]
    return {re.split(r"[<>=!~\[; ]", text)[0].lower().replace("_", "-") for text in texts}


@pytest.mark.parametrize("lock", LOCKS)
def test_every_line_is_a_pin_with_its_hashes(project_folder: Path, lock: str) -> None:
    lines = (project_folder / lock).read_text(encoding="utf-8").splitlines()
    assert [line for line in lines if not PIN.match(line) and not HASH.match(line)] == []
    following = zip(lines, [*lines[1:], ""], strict=True)
    assert [line for line, after in following if PIN.match(line) and not HASH.match(after)] == []


def test_development_lock_holds_the_other_one(project_folder: Path) -> None:
    """Else `make report` after `make test` would find other versions than it asks for."""
    small, large = (pins(project_folder / lock) for lock in LOCKS)
    assert small
    # What the small one needs on one system only, the large one may need everywhere.
    assert {(n, marker): large.get((n, marker), large.get((n, ""))) for n, marker in small} == small


def test_locks_name_what_pyproject_asks_for(project_folder: Path) -> None:
    settings = tomllib.loads((project_folder / "pyproject.toml").read_text(encoding="utf-8"))
    groups = settings["dependency-groups"]
    small, large = ({name for name, _ in pins(project_folder / lock)} for lock in LOCKS)
    assert names(settings["project"]["dependencies"] + groups["build"]) <= small
    assert names(groups["dev"]) <= large
    for extra in settings["project"]["optional-dependencies"].values():
        assert names(extra) <= large
