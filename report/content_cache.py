"""The content of the last build, kept for as long as nothing that it depends on has changed.

The key is a digest of every source and data file of the three packages, the versions of the libraries and
that of Python. A change anywhere, in a helper of a helper too, gives another key.
"""

from __future__ import annotations

import hashlib
import pickle
from importlib.metadata import version
from pathlib import Path

from report.document import Document
from report.provenance import libraries
from trimmer.files import write_whole

PACKAGES = ("derivations", "trimmer", "report")
SUFFIXES = (".py", ".csv")
ROOT = Path(__file__).parent.parent


def content_key() -> str:
    """Return the digest of all that the content depends on."""
    digest = hashlib.sha256()
    for path in _sources():
        digest.update(f"{path.relative_to(ROOT).as_posix()}\0".encode())
        digest.update(path.read_bytes())
    digest.update(repr((libraries(), version("trimmer"))).encode())
    return digest.hexdigest()


def load(directory: Path, key: str) -> Document | None:
    """Return the content kept under a key, or None if there is none or it cannot be read."""
    try:
        stored_key, document = pickle.loads(_file(directory).read_bytes())
    except (OSError, pickle.UnpicklingError, EOFError, AttributeError, ImportError, ValueError, TypeError):
        return None
    return document if stored_key == key and isinstance(document, Document) else None


def store(directory: Path, key: str, document: Document) -> None:
    """Keep the content of this build in place of the last one.

    Raises:
        FileWriteError: if it cannot be written.
    """
    write_whole(_file(directory), pickle.dumps((key, document)))


def _file(directory: Path) -> Path:
    return directory / ".cache" / "content.pickle"


def _sources() -> list[Path]:
    files = (path for package in PACKAGES for path in (ROOT / package).rglob("*") if path.suffix in SUFFIXES)
    return sorted(files)
