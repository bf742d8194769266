"""The notebooks run from top to bottom and show what their text says."""

from pathlib import Path

import nbformat
import pytest

from scripts.site.notebooks import executed, notebooks

SHOWN = {
    "describing-functions": (
        "0.29179141-0.28294212j",
        "175.2 µm   728.4 Hz  stable",
        "exact            :  174.14",
        "limit cycles: 0  complete: True",
        "A = 247.1, period 10.736 s, stable: True",
    ),
    "own-trimmer": (
        "It settles within 16 drive periods",
        "impacts           6 per period, up to 0.33 m/s",
        "12 starts settle to",
        "fold at 63.3 µm",
    ),
}
"""What the text around the cells speaks of; 247.1 is also found by SciPy, tests/trimmer/orbits."""


def test_notebooks_are_those_that_are_known() -> None:
    assert [path.stem for path in notebooks()] == sorted(SHOWN)


@pytest.mark.parametrize("path", notebooks(), ids=lambda path: path.stem)
def test_notebook_is_kept_without_outputs(path: Path) -> None:
    notebook = nbformat.read(path, as_version=4)
    nbformat.validate(notebook)
    cells = [cell for cell in notebook.cells if cell.cell_type == "code"]
    assert all(not cell.outputs and cell.execution_count is None for cell in cells)
    for cell in cells:
        compile(cell.source, path.name, "exec")


@pytest.mark.slow
@pytest.mark.parametrize("path", notebooks(), ids=lambda path: path.stem)
def test_notebook_runs(path: Path, tmp_path: Path) -> None:
    outputs = [output for cell in executed(path, tmp_path).cells for output in cell.get("outputs", ())]
    printed = "".join(output.get("text", "") for output in outputs)
    assert [piece for piece in SHOWN[path.stem] if piece not in printed] == []
    assert sum("image/png" in output.get("data", {}) for output in outputs) == 3
