"""Pictures that pages show: made by running the page's own blocks, and kept until something changes."""

import hashlib
import re
import shutil
from collections.abc import Callable
from pathlib import Path

PROJECT = Path(__file__).resolve().parents[2]
KEPT = PROJECT / "build" / "site-pictures"
TOOLS = ("blocks.py", "example_scripts.py", "notebooks.py", "running.py")
"""What runs pages, scripts and notebooks."""
_DONE = "done"


def own_pictures(page: str, stem: str) -> list[str]:
    """Return the names of pictures that a page shows from the folder of its own name."""
    return re.findall(rf"!\[[^\]]*\]\({re.escape(stem)}/([\w.-]+)\)", page)


def kept(name: str, source: Path, make: Callable[[Path], object]) -> Path:
    """Return a folder that was made from a file and from this package, made again if either has changed.

    Args:
        name: Name of the folder.
        source: The page or script that it is made from.
        make: Fills the folder that it is given.
    """
    folder = KEPT / name
    digest = _digest(source)
    if not (folder / _DONE).exists() or (folder / _DONE).read_text(encoding="utf-8") != digest:
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        make(folder)
        (folder / _DONE).write_text(digest, encoding="utf-8")
    return folder


def _digest(source: Path) -> str:
    digest = hashlib.sha256(source.read_bytes())
    for path in sorted(_sources()):
        digest.update(path.read_bytes())
    return digest.hexdigest()


def _sources() -> list[Path]:
    tools = [PROJECT / "scripts" / "site" / name for name in TOOLS]
    code = [*(PROJECT / "trimmer").rglob("*.py"), *tools]
    return [*code, *(PROJECT / "examples").glob("*.toml"), PROJECT / "requirements-dev.lock"]
