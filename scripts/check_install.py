"""Try what a user without this checkout does: install the wheel, then use it from another folder.

Takes a minute or two and needs the package index, so it is not one of the tests: run ``make check-install``.
"""

import os
import subprocess
import sys
import tempfile
import venv
from argparse import ArgumentParser
from collections.abc import Sequence
from pathlib import Path

PROJECT = Path(__file__).resolve().parent.parent


def main() -> int:
    """Build, install and use the wheel in a temporary folder; return the exit code."""
    with tempfile.TemporaryDirectory(prefix="check install ") as name:
        folder = Path(name)
        elsewhere = folder / "elsewhere"
        elsewhere.mkdir()
        environment = folder / "environment"
        programs = environment / ("Scripts" if os.name == "nt" else "bin")
        build = ["-m", "pip", "wheel", "--quiet", "--no-deps", "--no-build-isolation", "--wheel-dir"]
        run([sys.executable, *build, str(folder), str(PROJECT)], PROJECT)
        (wheel,) = folder.glob("*.whl")
        venv.create(environment, with_pip=True)
        run([str(programs / "python"), "-m", "pip", "install", "--quiet", str(wheel)], elsewhere)
        run([str(programs / "trimmer"), "--version"], elsewhere)
        run([str(programs / "trimmer"), "linear"], elsewhere)
        run([str(programs / "trimmer"), "report"], elsewhere)
        found = sorted(path.name for path in (elsewhere / "build" / "report").iterdir())
        print(*found)
        return 0 if {"report.html", "report.pdf", "cards.pdf", "claims.json"} <= set(found) else 1


def run(command: Sequence[str], folder: Path) -> None:
    """Run a command in a folder with neither this checkout's packages nor its environment in sight."""
    hidden = ("PYTHONPATH", "PYTHONHOME", "VIRTUAL_ENV")
    variables = {name: value for name, value in os.environ.items() if name not in hidden}
    print(">", *command, flush=True)
    subprocess.run(command, cwd=folder, env=variables, check=True)


if __name__ == "__main__":
    ArgumentParser(description=__doc__).parse_args()
    sys.exit(main())
