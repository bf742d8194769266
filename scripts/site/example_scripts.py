"""The scripts of ``examples/scripts``: what each says of itself, what it prints, and its picture.

The docstring of a script holds its title, a caption, and, indented, what it prints.
"""

import ast
import contextlib
import inspect
import io
import os
import runpy
import textwrap
from dataclasses import dataclass
from pathlib import Path

SCRIPTS = Path(__file__).resolve().parents[2] / "examples" / "scripts"
_INDENT = "    "


class ScriptError(AssertionError):
    """A script does not do what it says; the message names it."""


@dataclass(frozen=True)
class ExampleScript:
    """A script."""

    path: Path  # Where it is
    title: str  # First line of its docstring
    caption: str  # What its picture shows
    printed: str  # What it prints
    code: str  # Its code below the docstring

    @property
    def name(self) -> str:
        """Name of the file, without its end."""
        return self.path.stem


def example_scripts() -> list[ExampleScript]:
    """Return all scripts, by name."""
    return [read_script(path) for path in sorted(SCRIPTS.glob("*.py"))]


def read_script(path: Path) -> ExampleScript:
    """Read what a script says of itself."""
    source = path.read_text(encoding="utf-8")
    docstring = inspect.cleandoc(ast.get_docstring(ast.parse(source)) or "")
    title, _, rest = docstring.partition("\n\n")
    lines = rest.splitlines(keepends=True)
    shown = [line for line in lines if line.startswith(_INDENT)]
    told = "".join(line for line in lines if not line.startswith(_INDENT)).strip()
    code = source.split('"""', 2)[2].lstrip()
    return ExampleScript(path, title.rstrip("."), told, textwrap.dedent("".join(shown)), code)


def run_script(script: ExampleScript, picture: Path | None = None) -> None:
    """Run a script without a window; it must draw one figure and print what it says.

    Args:
        script: The script.
        picture: Where to write its figure, if anywhere.

    Raises:
        ScriptError: if it prints something else, or draws another number of figures.
    """
    os.environ["MPLBACKEND"] = "agg"
    from matplotlib import pyplot

    pyplot.close("all")
    with contextlib.redirect_stdout(io.StringIO()) as printed:
        runpy.run_path(str(script.path), run_name="__main__")
    try:
        figures = pyplot.get_fignums()
        if len(figures) != 1:
            raise ScriptError(f"{script.path} draws {len(figures)} figures; it should draw one")
        if picture is not None:
            pyplot.figure(figures[0]).savefig(picture, bbox_inches="tight")
    finally:
        pyplot.close("all")
    if textwrap.dedent(printed.getvalue()).rstrip() != script.printed.rstrip():
        raise ScriptError(
            f"{script.path} prints\n{printed.getvalue()}\nand its docstring says\n{script.printed}"
        )
