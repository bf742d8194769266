"""Compiled code of the contact package: nothing at import, and no stale machine code."""

import ast
import hashlib
import subprocess
import sys
from pathlib import Path

import trimmer.contact
from trimmer.contact.compilation import SOURCES, sources
from trimmer.motion import compilation as of_motion

IMPORT_ALONE = """
from numba.core.dispatcher import Dispatcher

def refuse(self, signature):
    raise AssertionError(f"{self.py_func.__qualname__} is compiled at import")

Dispatcher.compile = refuse
import trimmer.contact.flow
"""
FOLDER = Path(trimmer.contact.__file__).parent


def imported(module: str) -> set[str]:
    """Return the modules of the package that a module imports when it is run."""
    tree = ast.parse((FOLDER / f"{module}.py").read_text())
    names = {node.module for node in tree.body if isinstance(node, ast.ImportFrom) and node.module}
    return {name.rsplit(".", 1)[1] for name in names if name.startswith("trimmer.contact.")}


def test_nothing_is_compiled_at_import() -> None:
    subprocess.run([sys.executable, "-c", IMPORT_ALONE], check=True, timeout=120)


def test_a_change_in_any_module_with_compiled_code_is_noticed() -> None:
    compiled = {
        path.stem
        for path in FOLDER.glob("*.py")
        if any(word in path.read_text() for word in ("kept(entry)", "@inlined", "@compiled"))
    }
    assert {"integration", "step_event", "relaxing_root", "series", "nodes"} <= compiled <= set(SOURCES)
    # Constants that compiled code closes over come from these.
    assert {"statuses"} <= imported("integration") & set(SOURCES)


def test_the_digest_is_that_of_all_modules() -> None:
    motion = Path(of_motion.__file__).parent
    of_loops = b"".join((motion / f"{module}.py").read_bytes() for module in of_motion.SOURCES)
    assert of_motion.sources() == hashlib.sha256(of_loops).digest()
    own = b"".join((FOLDER / f"{module}.py").read_bytes() for module in SOURCES)
    assert sources() == hashlib.sha256(of_motion.sources() + own).digest()
