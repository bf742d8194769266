"""The notebooks of ``examples/notebooks``: run from top to bottom, and shown as pages with outputs."""

import base64
import os
import re
from collections.abc import Iterator
from pathlib import Path

import nbformat
from nbclient import NotebookClient
from nbformat import NotebookNode

PROJECT = Path(__file__).resolve().parents[2]
NOTEBOOKS = PROJECT / "examples" / "notebooks"
MOST_SECONDS = 300
_STYLE = re.compile(r"<style.*?</style>", re.DOTALL)


def notebooks() -> list[Path]:
    """Return the notebooks, by name."""
    return sorted(NOTEBOOKS.glob("*.ipynb"))


def executed(path: Path, folder: Path) -> NotebookNode:
    """Run a notebook in a folder; return it with its outputs.

    Raises:
        nbclient.exceptions.CellExecutionError: if a cell fails.
    """
    notebook = nbformat.read(path, as_version=4)
    client = NotebookClient(
        notebook,
        timeout=MOST_SECONDS,
        kernel_name="python3",
        resources={"metadata": {"path": str(folder)}},
        extra_arguments=["--log-level=ERROR"],
    )
    variables = os.environ | {
        "PYTHONPATH": str(PROJECT),
        "MPLBACKEND": "module://matplotlib_inline.backend_inline",
    }
    client.execute(env=variables)
    return notebook


def write_page(path: Path, folder: Path) -> None:
    """Run a notebook and write it into a folder as ``page.md``, with its pictures."""
    cells = executed(path, folder).cells
    parts = [
        part for number, cell in enumerate(cells) for part in _told(cell, f"{path.stem}-{number}", folder)
    ]
    link = f"[{path.name}](../examples/notebooks/{path.name}), with what it prints.\n"
    title, *others = parts
    (folder / "page.md").write_text("\n\n".join([title, link, *others]) + "\n", encoding="utf-8")


def _told(cell: NotebookNode, name: str, folder: Path) -> Iterator[str]:
    if cell.cell_type == "markdown":
        title, _, rest = cell.source.partition("\n\n")
        yield title
        if rest:
            yield rest
        return
    yield f"```python\n{cell.source}\n```"
    if printed := "".join(output.text for output in cell.outputs if output.output_type == "stream"):
        yield f"```text\n{printed.rstrip()}\n```"
    shown = [output for output in cell.outputs if output.output_type != "stream"]
    for number, output in enumerate(shown):
        yield _shown(output, folder / f"{name}-{number}.png")


def _shown(output: NotebookNode, picture: Path) -> str:
    """Return an output as Markdown; a picture is written to its file."""
    if "image/png" in output.data:
        picture.write_bytes(base64.b64decode(output.data["image/png"]))
        return f"![]({picture.name})"
    if "text/html" in output.data:
        shown = re.sub(r"\n\s*\n", "\n", _STYLE.sub("", output.data["text/html"]))
        return f'<div class="wide">{shown}</div>'
    return f"```text\n{output.data['text/plain']}\n```"
