"""What a report was made from: version, commit and libraries, nothing that depends on the build itself."""

from __future__ import annotations

import platform
import subprocess
from importlib.metadata import version
from pathlib import Path

from report.data.text_copy import read_build_time
from report.document.thesis import Provenance

LIBRARIES = (
    *("sympy", "mpmath", "numpy", "scipy", "numba", "control", "matplotlib"),
    *("Jinja2", "pypandoc_binary", "typst"),
)
RELEASED = "2026-11-21"
"""Date of this version, for a report that is not made in a git checkout."""


def provenance() -> Provenance:
    """Describe the code that is running; in a git checkout by its commit, elsewhere by its version."""
    commit, date = _commit()
    return Provenance(
        version=version("trimmer"),
        commit=commit,
        date=date,
        libraries=libraries(),
        build_time=read_build_time(),
    )


def libraries() -> tuple[tuple[str, str], ...]:
    """Return name and version of Python and of each library that a result depends on."""
    return (("Python", platform.python_version()), *((name, version(name)) for name in LIBRARIES))


def _commit() -> tuple[str, str]:
    tracked = _git("ls-files", "--error-unmatch", Path(__file__).name)
    described = _git("log", "-1", "--format=%h %cI")
    if tracked is None or not described:
        return "none (not a git checkout)", RELEASED
    commit, date = described.split()
    changed = _git("status", "--porcelain", "--untracked-files=no")
    return (f"{commit} with local changes" if changed else commit), date


def _git(*arguments: str) -> str | None:
    try:
        finished = subprocess.run(
            ["git", *arguments], cwd=Path(__file__).parent, capture_output=True, text=True, check=True
        )
    except (OSError, subprocess.CalledProcessError):
        return None
    return finished.stdout.strip()
