"""Keep .venv in step with a lock file, and run a command in it. Standard library only.

Three facts make an interrupted or outdated environment recognisable:

- ``.venv/made-by-bootstrap`` is written right after .venv was created here. Only such an environment is ever
  deleted; one that somebody else made is installed into, never removed.
- ``.venv/bootstrap.json`` holds a digest for each lock file that is completely installed. It is removed
  before anything is changed and written when that is done.
- The digest covers the lock file's content, the Python version and the folder: a virtual environment survives
  neither a move nor a change of Python.
"""

from __future__ import annotations

import hashlib
import importlib.util
import json
import os
import shutil
import subprocess
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

from installer import InstallError, compile_packages, run_pip

# A lock file that holds all of another one: installing it installs the other.
CONTAINS = {"requirements-dev.lock": ("requirements-dev.lock", "requirements.lock")}


@dataclass(frozen=True)
class Environment:
    """The virtual environment of a project, named by the project's folder."""

    project: Path

    @property
    def folder(self) -> Path:
        """Folder of the virtual environment."""
        return self.project / ".venv"

    @property
    def programs(self) -> Path:
        """Folder of its programs."""
        return self.folder / ("Scripts" if os.name == "nt" else "bin")

    @property
    def python(self) -> Path:
        """Its interpreter."""
        return self.programs / ("python.exe" if os.name == "nt" else "python")

    @property
    def marker(self) -> Path:
        """File that says that this script made the environment and may delete it."""
        return self.folder / "made-by-bootstrap"

    @property
    def state(self) -> Path:
        """File with the digests of what is completely installed."""
        return self.folder / "bootstrap.json"

    def digest(self, name: str) -> str:
        """Return a digest of a file of the project together with the Python version and the folder."""
        content = (self.project / name).read_bytes()
        identity = f"{sys.implementation.name} {sys.version_info[:2]} {self.folder}"
        return hashlib.sha256(content + identity.encode()).hexdigest()

    def read_state(self) -> dict[str, str]:
        """Return the digests of what is completely installed; empty when nothing is."""
        try:
            state = json.loads(self.state.read_text(encoding="utf-8"))
        except (OSError, ValueError):
            return {}
        return state if isinstance(state, dict) and self.python.exists() else {}

    def write_state(self, state: dict[str, str]) -> None:
        """Record what is completely installed."""
        self.state.write_text(json.dumps(state, indent=2), encoding="utf-8")


def main(arguments: Sequence[str]) -> int:
    """Bring .venv up to date with a lock file, then run a command in it.

    Args:
        arguments: ``LOCK -- COMMAND ARGUMENT...``.

    Returns:
        The exit code: that of the command, 1 when the environment could not be made, 2 for wrong use.
    """
    if len(arguments) < 3 or arguments[1] != "--":
        print("usage: bootstrap.py LOCK -- COMMAND [ARGUMENT ...]", file=sys.stderr)
        return 2
    environment = Environment(Path(__file__).resolve().parent.parent)
    try:
        with exclusive():
            update(environment, arguments[0])
        return run_command(environment, arguments[2:])
    except InstallError as error:
        print(error, file=sys.stderr)
        return 1
    except OSError as error:
        print(f"error: cannot write the environment {environment.folder}: {error}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        print("interrupted; the same command starts again", file=sys.stderr)
        return 130


def update(environment: Environment, lock: str) -> None:
    """Install what is missing so that .venv holds the lock file's packages and this project.

    Raises:
        InstallError: if .venv cannot be made, or pip fails.
    """
    wanted = {name: environment.digest(name) for name in CONTAINS.get(lock, (lock,))}
    project = environment.digest("pyproject.toml")
    state = environment.read_state()
    if state.get(lock) == wanted[lock] and state.get("pyproject.toml") == project:
        return
    outdated = state.get(lock, wanted[lock]) != wanted[lock]
    if not state or outdated:
        state = {}
        make_environment(environment)
    environment.state.unlink(missing_ok=True)
    if lock not in state:
        install_packages(environment, lock)
        state |= wanted
        environment.write_state(state)
    install_project(environment)
    environment.write_state(state | {"pyproject.toml": project})


def make_environment(environment: Environment) -> None:
    """Make an empty .venv, unless somebody else's working one is there.

    Raises:
        InstallError: if this Python cannot make virtual environments.
    """
    if environment.marker.exists():
        shutil.rmtree(environment.folder)
    if environment.python.exists():
        return
    if environment.folder.exists() and any(environment.folder.iterdir()):
        raise InstallError(
            f"error: {environment.folder} holds no working Python and was not made by make; remove it"
        )
    python = base_python()
    show("making .venv with Python {}.{}".format(*sys.version_info[:2]))
    environment.folder.mkdir(exist_ok=True)
    environment.marker.touch()
    command = [python, "-m", "venv", str(environment.folder)]
    made = subprocess.run(command, capture_output=True, text=True, errors="replace")
    if made.returncode != 0:
        lines = (made.stdout + made.stderr).strip().splitlines()[-8:]
        raise InstallError(f"error: {python} -m venv failed; its last lines are:", lines)


def base_python() -> str:
    """Return an interpreter that can make virtual environments.

    It is the one behind a virtual environment, if this is one: .venv may be active and just removed.

    Raises:
        InstallError: if the standard library's modules for that are not installed.
    """
    python: str = getattr(sys, "_base_executable", sys.executable)
    for module in ("venv", "ensurepip"):
        if importlib.util.find_spec(module) is None:
            package = "python{}.{}-venv".format(*sys.version_info[:2])
            raise InstallError(
                f"error: {python} cannot make virtual environments because its module {module} is missing; "
                f"on Debian or Ubuntu run: apt install {package}"
            )
    return python


def install_packages(environment: Environment, lock: str) -> None:
    """Install a lock file's packages, hashes checked, and compile them."""
    show(f"installing the packages of {lock}; this happens once and takes a minute or two")
    # Wheels only: building a source distribution would fetch build tools that no hash covers.
    options = ["--require-hashes", "--no-deps", "--only-binary=:all:", "--no-compile"]
    run_pip(environment.python, ["install", *options, "--requirement", str(environment.project / lock)])
    compile_packages(environment.python)


def install_project(environment: Environment) -> None:
    """Install this project's sources in place, with the locked build backend and no network."""
    show("installing the project")
    options = ["--no-index", "--no-deps", "--no-build-isolation"]
    run_pip(environment.python, ["install", *options, "--editable", str(environment.project)])


def run_command(environment: Environment, command: Sequence[str]) -> int:
    """Run a program of .venv from the project's folder; on POSIX this process becomes that program.

    Raises:
        InstallError: if .venv has no such program.
    """
    program = shutil.which(command[0], path=str(environment.programs))
    if program is None:
        raise InstallError(f"error: there is no program {command[0]} in {environment.programs}")
    path = os.pathsep.join([str(environment.programs), os.environ.get("PATH", os.defpath)])
    variables = os.environ | {"PATH": path, "VIRTUAL_ENV": str(environment.folder)}
    variables.pop("PYTHONHOME", None)
    os.chdir(environment.project)
    if os.name == "nt":
        return subprocess.run([program, *command[1:]], env=variables).returncode
    os.execve(program, [program, *command[1:]], variables)


def show(text: str) -> None:
    """Say what takes time, on standard error."""
    print(text, file=sys.stderr, flush=True)


@contextmanager
def exclusive() -> Iterator[None]:
    """Let one process at a time change .venv; the lock falls with the process that holds it."""
    try:
        import fcntl
    except ImportError:  # Windows
        yield
        return
    handle = os.open(Path(__file__).parent, os.O_RDONLY)
    try:
        fcntl.flock(handle, fcntl.LOCK_EX)
        yield
    finally:
        os.close(handle)
