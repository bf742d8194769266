"""The key under which the content of a build is kept, for as long as nothing has changed at all.

It is a digest of every source and data file of the three packages, the versions of the libraries and that of
Python. With it a build that has nothing to do need not import SymPy to find that out.
"""

from __future__ import annotations

import hashlib
from importlib.metadata import version
from pathlib import Path

from report.building.provenance import libraries
from report.building.source_closure import PACKAGES, ROOT

SUFFIXES = (".py", ".csv", ".m.j2")


def content_key() -> str:
    """Return the digest of all that the content depends on."""
    digest = hashlib.sha256()
    for path in _sources():
        digest.update(f"{path.relative_to(ROOT).as_posix()}\0".encode())
        digest.update(path.read_bytes())
    digest.update(repr((libraries(), version("trimmer"))).encode())
    return digest.hexdigest()


def _sources() -> list[Path]:
    files = (
        path for package in PACKAGES for path in (ROOT / package).rglob("*") if path.name.endswith(SUFFIXES)
    )
    return sorted(files)
