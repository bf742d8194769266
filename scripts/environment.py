"""Make .venv and install the packages of a lock file; ``make`` runs this, with the Python to make it of.

It is safe against an interrupt at any place, and against a second one that runs at the same time: what is not
finished says so and is begun anew, and who comes second waits. Only the standard library is there.
"""

import argparse
import os
import shutil
import subprocess
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path

OLDEST = (3, 11)
PROJECT = Path(__file__).resolve().parent.parent
ENVIRONMENT = PROJECT / ".venv"
MADE = ENVIRONMENT / "made-by-make"
"""Says which Python the environment was made of, and where; empty until it is finished."""
UNFINISHED = ENVIRONMENT / "unfinished"
"""Is there while packages are installed."""
ASIDE = PROJECT / ".venv.old"
"""Where an environment goes that is removed, so that half of one is never taken for somebody else's."""
DONE = {"requirements.lock": ("for-use",), "requirements-dev.lock": ("for-development", "for-use")}
"""Files in the environment that say that the packages of a lock file are there; those for development hold
those for use."""


class SetUpError(Exception):
    """The environment cannot be made; the message says why and what to do."""


def main() -> int:
    """Install what a lock file names, unless it is there; return the exit code."""
    parser = argparse.ArgumentParser(description=__doc__)
    what = parser.add_mutually_exclusive_group(required=True)
    what.add_argument("lock", nargs="?", choices=DONE, help="lock file with the packages to install")
    what.add_argument(
        "--find",
        action="store_true",
        help="print the Python to make it of, after = if the environment that is there will do; nothing if "
        f"this one is older than {'.'.join(map(str, OLDEST))}",
    )
    arguments = parser.parse_args()
    if arguments.find:
        if sys.version_info >= OLDEST:
            print(("=" if is_whole() else "") + base_python())
        return 0
    try:
        with only_one():
            install(arguments.lock)
    except SetUpError as error:
        print(f"error: {error}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        print("error: interrupted; the next make begins the installation anew", file=sys.stderr)
        return 130
    return 0


@contextmanager
def only_one() -> Iterator[None]:
    """Wait until no other process installs into the environment, and keep others waiting meanwhile."""
    try:
        import fcntl
    except ImportError:  # a system without such locks
        yield
        return
    with open(PROJECT / ".venv.lock", "w") as file:
        try:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError:
            print("another make is installing packages here; waiting for it", file=sys.stderr)
            fcntl.flock(file, fcntl.LOCK_EX)
        yield


def install(lock: str) -> None:
    """Install the packages of a lock file and the project, in a new environment if need be.

    Raises:
        SetUpError: if the environment is somebody else's, or a command fails.
    """
    if not is_whole():
        make_environment()
    elif is_done(lock):  # by another make, while this one waited
        return
    print(f"installing the packages of {lock}; this takes a minute or two, once", file=sys.stderr)
    UNFINISHED.touch()
    # Wheels only: building a package would fetch build tools that no hash covers.
    wheels = ["--require-hashes", "--no-deps", "--only-binary=:all:", "--no-compile"]
    failed = f"the packages of {lock} were not installed; what pip says is above"
    run([*pip(), *wheels, "--requirement", lock], failed)
    all_cores = ["-m", "compileall", "-qq", "-j", "0", str(ENVIRONMENT / "lib")]
    subprocess.run([python(), "-I", *all_cores], stdout=subprocess.DEVNULL, check=False)
    itself = ["--no-index", "--no-deps", "--no-build-isolation", "--editable", "."]
    run([*pip(), *itself], "the project itself was not installed; what pip says is above")
    for name in DONE[lock]:
        (ENVIRONMENT / name).touch()
    UNFINISHED.unlink()


def stamp() -> str:
    """Return what an environment depends on: it survives neither a move nor another Python.

    A Python is named by the folder that it is installed in; it has itself several names there.
    """
    installed = Path(sys.base_prefix) / "bin" / "python3"
    return f"{installed} {sys.version_info[0]}.{sys.version_info[1]} {PROJECT}"


def is_whole() -> bool:
    """Say whether the environment was made of this Python, here, and no installation was interrupted."""
    try:
        return MADE.read_text(encoding="utf-8") == stamp() and not UNFINISHED.exists()
    except OSError:
        return False


def is_done(lock: str) -> bool:
    """Say whether the packages were installed after the lock file and the project were changed."""
    done = ENVIRONMENT / DONE[lock][0]
    changed = max((PROJECT / name).stat().st_mtime for name in (lock, "pyproject.toml"))
    return done.exists() and done.stat().st_mtime >= changed


def make_environment() -> None:
    """Make the environment in place of one that was made by make."""
    if os.path.lexists(ENVIRONMENT) and not os.path.lexists(MADE):
        raise SetUpError("the folder .venv was not made by make; move it away or remove it")
    shutil.rmtree(ASIDE, ignore_errors=True)
    if os.path.lexists(ENVIRONMENT):
        os.replace(ENVIRONMENT, ASIDE)
        shutil.rmtree(ASIDE, ignore_errors=True)
    fresh = PROJECT / ".venv.new"
    shutil.rmtree(fresh, ignore_errors=True)
    fresh.mkdir()
    (fresh / MADE.name).touch()
    os.replace(fresh, ENVIRONMENT)  # from its first moment it says whose it is
    run(
        [base_python(), "-I", "-m", "venv", str(ENVIRONMENT)], ".venv was not made; what Python says is above"
    )
    MADE.write_text(stamp(), encoding="utf-8")


def base_python() -> str:
    """Return the interpreter behind this one, which may be that of the environment that is replaced."""
    return getattr(sys, "_base_executable", sys.executable)


def python() -> str:
    """Return the interpreter of the environment."""
    return str(ENVIRONMENT / "bin" / "python")


def pip() -> list[str]:
    """Return the command that installs into the environment."""
    return [python(), "-I", "-m", "pip", "--disable-pip-version-check", "--no-input", "install", "--quiet"]


def run(command: Sequence[str], failed: str) -> None:
    """Run a command in the folder of the project.

    Raises:
        SetUpError: with a message, if it fails.
    """
    if subprocess.run(command, cwd=PROJECT, check=False).returncode != 0:
        raise SetUpError(failed)


if __name__ == "__main__":
    sys.exit(main())
