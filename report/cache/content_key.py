"""The key under which the content of a build is kept, for as long as nothing has changed at all.

It is a digest of every source and data file of the three packages, the versions of the libraries and that of
Python. With it a build that has nothing to do need not import SymPy to find that out.
"""

from __future__ import annotations

import hashlib
from importlib.metadata import version
from pathlib import Path

from report.cache.source_closure import PACKAGES, ROOT
from report.folders import templates
from report.provenance import libraries

SUFFIXES = (".py", ".pyi", ".csv", ".json", ".toml")


def content_key() -> str:
    """Return the digest of all that the content depends on."""
    digest = hashlib.sha256()
    for name, path in _sources().items():
        digest.update(f"{name}\0".encode())
        digest.update(path.read_bytes())
    digest.update(repr((libraries(), version("trimmer"))).encode())
    return digest.hexdigest()


def _sources() -> dict[str, Path]:
    packages = (path for package in PACKAGES for path in (ROOT / package).rglob("*"))
    sources = {path.relative_to(ROOT).as_posix(): path for path in packages if path.name.endswith(SUFFIXES)}
    listings = {f"templates/octave/{path.name}": path for path in (templates() / "octave").iterdir()}
    return dict(sorted({**sources, **listings}.items()))
