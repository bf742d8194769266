"""The key under which the content of a build is kept, for as long as nothing has changed at all.

It is a digest of every source and data file of the three packages, the versions of the libraries and that of
Python. With it a build that has nothing to do need not import SymPy to find that out.
"""

import hashlib
from collections.abc import Iterable, Mapping
from importlib.metadata import version
from pathlib import Path

from report.cache.libraries import libraries
from report.cache.source_closure import PACKAGES, ROOT
from report.folders import templates

SUFFIXES = (".py", ".pyi", ".csv", ".json", ".toml")


def content_key() -> str:
    """Return the digest of all that the content depends on."""
    return _digest(_sources(), repr((libraries(), version("trimmer"))))


def digest_of_packages(packages: Iterable[str]) -> str:
    """Return the digest of all sources and data files of some of the packages."""
    return _digest(_sources_of(packages))


def _digest(sources: Mapping[str, Path], more: str = "") -> str:
    digest = hashlib.sha256()
    for name, path in sources.items():
        digest.update(f"{name}\0".encode())
        digest.update(path.read_bytes())
    digest.update(more.encode())
    return digest.hexdigest()


def _sources_of(packages: Iterable[str]) -> dict[str, Path]:
    paths = (path for package in packages for path in (ROOT / package).rglob("*"))
    return dict(
        sorted((path.relative_to(ROOT).as_posix(), path) for path in paths if path.name.endswith(SUFFIXES))
    )


def _sources() -> dict[str, Path]:
    listings = {f"templates/octave/{path.name}": path for path in (templates() / "octave").iterdir()}
    return dict(sorted({**_sources_of(PACKAGES), **listings}.items()))
