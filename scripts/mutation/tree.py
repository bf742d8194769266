"""A copy of the project in which one source at a time is changed."""

import compileall
import fcntl
import os
import shutil
import subprocess
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

from scripts.mutation.mutants import Mutant

LATER = 1000.0
"""How much later, s, than its original a changed source says that it was written: what Python has compiled
from the original is not taken for it, even if both have the same length."""
PACKAGES = ("derivations", "trimmer", "report", "tests", "scripts")


@dataclass(frozen=True)
class Tree:
    """A copy of the working tree."""

    root: Path  # Its folder
    numba: Path  # Folder of the machine code that Numba has made from the unaltered sources

    @contextmanager
    def changed(self, mutant: Mutant, compiled: bool) -> Iterator[Path]:
        """Change a source; yield the folder for Numba's machine code.

        Args:
            mutant: The change.
            compiled: Whether compiled code is made of the source. It then gets an empty folder, since Numba
            does not
                see a change in what a function calls.

        Raises:
            ValueError: if the source is not the one that the mutant was made for.
        """
        path = self.root / mutant.path
        original, times = path.read_bytes(), path.stat()
        changed = mutant.text(original)
        fresh = self.numba.with_name(f"{self.numba.name}-of-mutant")
        shutil.rmtree(fresh, ignore_errors=True)
        try:
            path.write_bytes(changed)
            os.utime(path, (times.st_atime, times.st_mtime + LATER))
            yield fresh if compiled else self.numba
        finally:
            path.write_bytes(original)
            os.utime(path, ns=(times.st_atime_ns, times.st_mtime_ns))
            shutil.rmtree(fresh, ignore_errors=True)


def copied(project: Path, folder: Path) -> Tree:
    """Bring a copy of the working tree up to date: every file that git tracks or would track.

    Files of an unchanged content stay as they are, so that what was compiled from them is used again. The
    copy belongs to this process until it ends.

    Raises:
        BlockingIOError: if another process has the copy.
    """
    folder.mkdir(parents=True, exist_ok=True)
    lock = os.open(folder / "lock", os.O_RDWR | os.O_CREAT)
    fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
    listed = ["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"]
    output = subprocess.run(listed, cwd=project, capture_output=True, check=True).stdout
    names = {name for name in output.decode().split("\0") if name and (project / name).is_file()}
    root = folder / "tree"
    for path in [path for path in root.rglob("*") if path.is_file() and "__pycache__" not in path.parts]:
        if path.relative_to(root).as_posix() not in names:
            path.unlink()
    for name in sorted(names):
        original, copy = project / name, root / name
        if not copy.is_file() or copy.read_bytes() != original.read_bytes():
            copy.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(original, copy)
    for package in PACKAGES:
        compileall.compile_dir(root / package, quiet=2)
    return Tree(root, folder / "numba")
