"""Compiled code: nothing at import, kept where it can be, and still there where it cannot."""

import os
import pickle
import shutil
import subprocess
import sys
from pathlib import Path

import numba
import numpy as np
import pytest
from numba.core import caching

import trimmer
from trimmer.hybrid import compilation as compiled
from trimmer.hybrid.series import COUNT, ModeTables, tabulate
from trimmer.hybrid.taylor import LEVELS, bernstein_from_taylor

IMPORT_ALONE = """
import numba
from numba.core.dispatcher import Dispatcher

def refuse(self, signature):
    raise AssertionError(f"{self.py_func.__qualname__} is compiled at import")

Dispatcher.compile = refuse
import trimmer.branches.follow, trimmer.contact.flow, trimmer.loops.simulation
"""

SAME_TYPES = """
import numba, sys
from trimmer.hybrid import compilation
kept = compilation.kept

def looked_at(entry):
    call, known = kept(entry), {}
    def look(*arguments):
        types = tuple(map(numba.typeof, arguments))
        assert known.setdefault(tuple(map(type, arguments)), types) == types, (entry, types)
        return call(*arguments)
    return look

compilation.kept = looked_at
import trimmer
for name in ("sampled-axis", "block-on-belt", "bouncing-ball", "second-play", "oscillator-stop"):
    machine = trimmer.Mechanism.from_toml(f"{sys.argv[1]}/{name}.toml")
    trimmer.respond(machine, most_periods=50).motion.measures
trimmer.follow(machine, "frequency", 1.0, 1.02)
loop = trimmer.TrimmerLoop(trimmer.TrimmerParameters.thesis(), trimmer.elements.FrictionBacklash(4e-5))
trimmer.simulate(loop, 0.02, impulse=1e-3).signal("output", 0.01)
"""


IN_PYTHON = """
import trimmer
loop = trimmer.ClosedLoop(([1.0], [1, 1, 0]), trimmer.Relay(1.0, hysteresis=0.1))
print(*(event.time for event in trimmer.simulate(loop, 2.0, state=[0.1, 0.2]).events))
"""


def doubled(value: float) -> float:
    return 2.0 * value


@pytest.mark.slow
def test_nothing_is_compiled_at_import() -> None:
    subprocess.run([sys.executable, "-c", IMPORT_ALONE], check=True, timeout=120)


@pytest.mark.slow
def test_arguments_of_the_same_classes_have_the_same_types(project_folder: Path) -> None:
    """Only then may the machine code be entered without a look at each array."""
    words = [sys.executable, "-c", SAME_TYPES, str(project_folder / "examples")]
    run = subprocess.run(words, capture_output=True, text=True, timeout=120)
    assert (run.returncode, run.stderr[-2000:]) == (0, "")


def test_it_works_without_compiling() -> None:
    words = [sys.executable, "-c", IN_PYTHON]
    environment = {**os.environ, "NUMBA_DISABLE_JIT": "1"}
    run = subprocess.run(words, capture_output=True, text=True, timeout=120, env=environment)
    assert run.stderr == ""
    time = float(run.stdout)  # When y = 0.2 + 1.1 (1 - exp(-t)) - t, with y'' = -y' - 1, has come to -0.1
    assert 0.2 - 1.1 * np.expm1(-time) - time == pytest.approx(-0.1, abs=1e-14)


def test_it_works_where_no_folder_can_be_written(monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(self: object) -> None:
        raise PermissionError("read-only")

    for locator in (
        *(caching.UserProvidedCacheLocator, caching.InTreeCacheLocator),
        caching.UserWideCacheLocator,
    ):
        monkeypatch.setattr(locator, "ensure_cache_path", refuse)
    with pytest.raises(RuntimeError, match="no locator available"):
        numba.njit(cache=True)(doubled)
    assert compiled.kept(doubled)(4.0) == 8.0


@pytest.mark.parametrize(
    ("method", "error"),
    [
        ("save", OSError(28, "No space left on device")),
        ("load", EOFError("a file of length zero")),
        ("load", pickle.UnpicklingError("a part of a file")),
    ],
)
def test_it_works_with_a_full_disk_or_a_damaged_file(
    method: str, error: Exception, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fail(self: object, *arguments: object) -> None:
        raise error

    monkeypatch.setattr(caching.IndexDataCacheFile, method, fail)
    assert compiled.kept(doubled)(4.0) == 8.0


def test_other_errors_are_not_hidden() -> None:
    def failing(value: float) -> float:
        raise ValueError("mine")

    with pytest.raises(ValueError, match="mine"):
        compiled.kept(failing)(1.0)


def test_a_change_in_any_module_with_compiled_code_is_noticed(tmp_path: Path) -> None:
    package = Path(trimmer.__file__).parent
    words = ("@compiled", "@inlined", "kept(entry)")
    using = {
        path.relative_to(package)
        for path in package.rglob("*.py")
        if any(word in path.read_text(encoding="utf-8") for word in words)
    }
    # Entry points may also stand elsewhere: Numba itself notices a change in their own files.
    assert {path.parent.as_posix() for path in using} == {"hybrid", "branches/period_maps"}
    copied = shutil.copytree(package, tmp_path / "trimmer", ignore=shutil.ignore_patterns("__pycache__"))
    asked = "from trimmer.hybrid.compilation import sources; print(sources())"
    (copied / "hybrid/segment.py").write_text((copied / "hybrid/segment.py").read_text() + "\n# changed\n")
    changed = subprocess.check_output([sys.executable, "-c", asked], cwd=tmp_path, text=True, timeout=120)
    assert changed.strip() not in ("", str(compiled.sources()))


def test_the_order_in_memory_of_a_flow_does_not_matter() -> None:
    """Machine code is entered by the classes of its arguments; it takes arrays to be in the order of C."""
    flow, found = np.triu(np.arange(1.0, 10.0).reshape(3, 3)), list[np.ndarray]()
    for order in (np.ascontiguousarray, np.asfortranarray):
        shapes = (3, 3 + COUNT), (3, 3 * COUNT), LEVELS, (1, 3, COUNT), (1, COUNT, 3)
        screen, series, terms, *others = (np.zeros(shape) for shape in shapes)
        rooms = ModeTables(screen, series, terms.astype(np.int64), *others, bernstein_from_taylor())
        tabulate(order(flow), 2, np.eye(1, 3), rooms)
        found.append(series)
    assert (found[0] == found[1]).all()
