"""Two renderings of one document, in two processes and two folders."""

import os
import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path

import pytest

from report.command import KINDS
from report.pages.formats import Format
from trimmer.files import check_replaceable

PROGRAM = """
import sys
from pathlib import Path
from report.rendering.render import render
from tests.report.rendering.sample import sample
render(sample(), Path(sys.argv[1]))
"""


@pytest.mark.slow
def test_the_same_document_gives_the_same_bytes(rendered, tmp_path, project_folder) -> None:
    elsewhere = tmp_path / "another folder"
    environment = {**os.environ, "PYTHONHASHSEED": "7", "TZ": "Asia/Tokyo", "PYTHONPATH": str(project_folder)}
    subprocess.run([sys.executable, "-c", PROGRAM, str(elsewhere)], cwd=tmp_path, env=environment, check=True)
    for path in (rendered[Format.HTML], rendered[Format.PDF], rendered[Format.CARDS], rendered[Format.JSON]):
        assert (elsewhere / path.name).read_bytes() == path.read_bytes(), path.name


def test_importing_the_rendering_loads_no_converter() -> None:
    program = (
        "import sys; import report.rendering.render; "
        "print(*({'pypandoc', 'typst', 'matplotlib', 'sympy', 'numpy'} & set(sys.modules)))"
    )
    finished = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    assert finished.stdout.strip() == ""


def test_a_build_may_replace_what_the_last_one_wrote(rendered: Mapping[Format, Path]) -> None:
    assert set(rendered) == set(Format) == set(KINDS)
    for form, path in rendered.items():
        check_replaceable(path, KINDS[form])
