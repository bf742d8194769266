"""What ``trimmer derive FILE`` writes as LaTeX can be set: read by pandoc without a warning, set by Typst."""

import re
import subprocess
from pathlib import Path

import pypandoc
import pytest
import typst

from trimmer import Mechanism
from trimmer.code_generation import derive_mechanism_sources

EXAMPLES = sorted((Path(__file__).parents[3] / "examples").glob("*.toml"))
QUICK = {"oscillator-stop"}
FITTED = re.compile(r"\\resizebox\{\\fitted\}\{!\}\{\$\\displaystyle (.*?)\$\}", re.DOTALL)
"""A formula that LaTeX shrinks to the line, which pandoc does not know."""


@pytest.mark.parametrize(
    "file",
    [
        pytest.param(file, id=file.stem, marks=[] if file.stem in QUICK else [pytest.mark.slow])
        for file in EXAMPLES
    ],
)
def test_the_document_of_each_example_can_be_set(file: Path) -> None:
    latex = derive_mechanism_sources(Mechanism.from_toml(file)).latex
    plain, count = FITTED.subn(lambda found: found[1], latex)
    assert count >= 4
    assert "\\resizebox" not in plain
    pandoc = [pypandoc.get_pandoc_path(), "--fail-if-warnings", "--standalone", "--from=latex", "--to=typst"]
    read = subprocess.run(pandoc, input=plain.encode(), capture_output=True, check=False)
    assert (read.returncode, read.stderr) == (0, b"")
    assert typst.compile({"main": read.stdout}, format="pdf", ignore_system_fonts=True).startswith(b"%PDF")
