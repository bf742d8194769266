"""What a report was made from: version, commit and libraries, nothing that depends on the build itself."""

import subprocess
from dataclasses import dataclass
from importlib.metadata import version
from pathlib import Path
from typing import final

from report.cache.libraries import libraries

RELEASED = "2026-11-21"  # Date of this version, for a report that is not made in a git checkout


@final
@dataclass(frozen=True)
class BuildTime:
    """Processor time that the report took from nothing, s, when that version was measured."""

    seconds: float
    version: str


@dataclass(frozen=True)
class Provenance:
    """What the report was made from; nothing in it depends on the time or the machine of the build.

    ``build_time`` is the processor time it took when that was last measured.
    """

    version: str
    commit: str
    date: str
    libraries: tuple[tuple[str, str], ...]
    build_time: BuildTime | None = None

    @property
    def line(self) -> str:
        """The line below a report's title."""
        return f"trimmer {self.version}, commit {self.commit}, {self.date[:10]}"


def provenance(build_time: BuildTime | None = None) -> Provenance:
    """Describe the code that is running; in a git checkout by its commit, elsewhere by its version."""
    commit, date = _commit()
    return Provenance(
        version=version("trimmer"), commit=commit, date=date, libraries=libraries(), build_time=build_time
    )


def _commit() -> tuple[str, str]:
    tracked = _git("ls-files", "--error-unmatch", Path(__file__).name)
    described = _git("log", "-1", "--format=%h %cI")
    if not tracked or not described:
        return "none (not a git checkout)", RELEASED
    commit, date = described.split()
    changed = _git("status", "--porcelain", "--untracked-files=no")
    return (f"{commit} with local changes" if changed else commit), date


def _git(*arguments: str) -> str:
    """Return what git prints; nothing where it fails, or is not there."""
    try:
        finished = subprocess.run(
            ["git", *arguments], cwd=Path(__file__).parent, capture_output=True, text=True
        )
    except OSError:
        return ""
    return finished.stdout.strip()
