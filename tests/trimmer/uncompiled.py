"""Compiled modules as plain Python, so that their parts can be tested one by one, without compiling them.

Touches a private name: compiled entries have no other door to their sources.
"""

from __future__ import annotations

from types import ModuleType

import pytest


def uncompile(monkeypatch: pytest.MonkeyPatch, *modules: ModuleType) -> None:
    """Put the Python functions in place of the compiled ones that a module defines or imports."""
    for module in modules:
        for name, value in list(vars(module).items()):
            if hasattr(value, "py_func"):
                monkeypatch.setattr(module, name, value.py_func)
            elif name.startswith("_compiled_"):
                monkeypatch.setattr(module, "kept", lambda entry: entry)
                monkeypatch.setattr(module, name, module._entry(module.sources()))
