"""The libraries that results depend on, and their versions."""

import platform
from importlib.metadata import version

LIBRARIES = (
    *("sympy", "mpmath", "numpy", "scipy", "numba", "control", "matplotlib"),
    *("Jinja2", "pypandoc_binary", "typst"),
)


def libraries() -> tuple[tuple[str, str], ...]:
    """Return name and version of Python and of each library that a result depends on."""
    return (("Python", platform.python_version()), *((name, version(name)) for name in LIBRARIES))
