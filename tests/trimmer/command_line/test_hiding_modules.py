"""Files of the user that are called as modules are neither run nor in the way."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

NAMES = ("report", "numpy", "derivations", "scipy", "json", "pickle", "multiprocessing", "signal", "argparse")
PROJECT = Path(__file__).parents[3]
SPAWNING = """
import threading
from trimmer.runners.processes import ProcessRunner
if __name__ == "__main__":
    threading.Thread(target=threading.Event().wait, daemon=True).start()  # so that processes are no copies
    assert list(ProcessRunner(1).results(abs, [-3])) == [3]
    print("done")
"""


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    for name in NAMES:
        (tmp_path / f"{name}.py").write_text(f"open('ran-{name}', 'w').close()\n", "utf-8")
    return tmp_path


def run(folder: Path, *words: str) -> subprocess.CompletedProcess[str]:
    hidden = ("PYTHONSAFEPATH", "PYTHONPATH")
    variables = {name: value for name, value in os.environ.items() if name not in hidden}
    return subprocess.run(
        [sys.executable, *words], cwd=folder, env=variables, capture_output=True, text=True, timeout=60
    )


@pytest.mark.parametrize("words", [["design", "--help"], ["map", "--help"]], ids=" ".join)
def test_files_of_the_current_folder_are_not_run(folder: Path, words: list[str]) -> None:
    done = run(folder, "-m", "trimmer", *words)
    assert (done.returncode, done.stderr) == (0, "")
    assert not list(folder.glob("ran-*"))


def test_nor_are_they_by_the_linear_model_which_needs_no_sympy(folder: Path) -> None:
    """Python tells on standard error what it imports."""
    done = run(folder, "-X", "importtime", "-m", "trimmer", "linear")
    imported = {line.rpartition("|")[2].strip() for line in done.stderr.splitlines()}
    assert done.returncode == 0 and done.stdout.count("\n") > 10
    assert all(line.startswith("import time:") for line in done.stderr.splitlines())
    assert "control" in imported and "sympy" not in imported
    assert not any(name.startswith("derivations") for name in imported)
    assert not list(folder.glob("ran-*"))


def test_processes_do_not_run_them_either(folder: Path, tmp_path_factory: pytest.TempPathFactory) -> None:
    script = tmp_path_factory.mktemp("script") / "spawning.py"
    script.write_text(SPAWNING, "utf-8")
    done = run(folder, str(script))
    assert (done.stdout, done.stderr) == ("done\n", "")
    assert not list(folder.glob("ran-*"))


def test_a_file_that_is_in_the_way_before_is_named(folder: Path) -> None:
    (folder / "lazy_loader.py").write_text("def attach_stub(*_): return None, None, []\n", "utf-8")
    done = run(folder, "-m", "trimmer", "linear")
    assert done.returncode == 2
    assert done.stderr == (
        f"trimmer: {folder / 'lazy_loader.py'} was taken for the module lazy_loader: give it another name\n"
    )


def test_a_module_in_place_of_a_package_is_named(folder: Path) -> None:
    (folder / "numpy.py").unlink()
    code = f"import sys; sys.path.insert(0, {str(folder)!r}); import report; del sys.path[0]\n"
    code += "from trimmer.command_line.main import main; sys.exit(main(['--help']))"
    done = run(folder, "-P", "-c", code)
    assert done.returncode == 0
    assert "'design' (report.design.command:COMMAND) does not load: " in done.stderr
    assert f"; {folder / 'report.py'} hides the package: give it another name" in done.stderr
