"""All tests, collected when this module is imported: by the server that other processes are forked from.

They find the project and its tests loaded, which takes longer than most test files do.
"""

import os
import sys
from collections.abc import Callable
from contextlib import redirect_stdout
from pathlib import Path
from typing import Any

TREE = "MUTATION_TREE"
"""Names the folder of the copy whose tests are collected, in the environment."""
PACKAGES = ("derivations", "trimmer", "report", "tests")
ENTERED: set[str] = set()
"""Sources whose compiled code was entered."""


def forget() -> None:
    """Import the project and its tests anew from now on, as where a source was changed."""
    for name in [name for name in sys.modules if name.partition(".")[0] in PACKAGES]:
        del sys.modules[name]


def _note_entries() -> None:
    """Write down which compiled code is entered: its lines are not seen one by one."""
    from trimmer.hybrid import compilation

    original = compilation.kept

    def kept(entry: Callable[..., Any]) -> Callable[..., Any]:
        compiled = original(entry)

        def call(*arguments: Any) -> Any:
            ENTERED.add(f"{entry.__module__.replace('.', '/')}.py")
            return compiled(*arguments)

        return call

    compilation.kept = kept


def _collect(root: str) -> None:
    import pytest

    os.chdir(root)
    sys.path.insert(0, root)
    _note_entries()
    with Path(os.devnull).open("w", encoding="utf-8") as nowhere, redirect_stdout(nowhere):
        pytest.main(["-q", "-p", "no:cacheprovider", "-p", "no:xdist", "--collect-only"])


if root := os.environ.get(TREE):
    _collect(root)
