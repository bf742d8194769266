"""Every script of examples/scripts draws one figure and prints what its docstring says."""

from pathlib import Path

import pytest

from scripts.site.example_scripts import ExampleScript, ScriptError, example_scripts, read_script, run_script
from scripts.site.gallery import gallery_pages

SCRIPTS = example_scripts()
SLOW = {"basin", "branch", "chaos", "den_hartog", "own_element"}


@pytest.mark.parametrize(
    "script",
    [pytest.param(each, id=each.name, marks=[pytest.mark.slow] * (each.name in SLOW)) for each in SCRIPTS],
)
def test_script(script: ExampleScript) -> None:
    run_script(script)


def test_scripts_say_what_they_are() -> None:
    for script in SCRIPTS:
        assert script.title and script.caption and script.printed, script.name
        assert "plt.show()" in script.code


def write(folder: Path, body: str) -> ExampleScript:
    path = folder / "made.py"
    path.write_text(f'"""Made.\n\nA caption.\n\n    6\n"""\n\n{body}', encoding="utf-8")
    return read_script(path)


FIGURE = "import matplotlib.pyplot as plt\nplt.subplots()\nplt.show()\n"


def test_a_script_is_read(tmp_path: Path) -> None:
    script = write(tmp_path, "print(6)\n")
    assert (script.name, script.title, script.caption) == ("made", "Made", "A caption.")
    assert (script.printed, script.code) == ("6", "print(6)\n")


def test_another_output_or_no_figure_is_an_error(tmp_path: Path) -> None:
    picture = tmp_path / "made.svg"
    run_script(write(tmp_path, f"print(6)\n{FIGURE}"), picture)
    assert picture.exists()
    with pytest.raises(ScriptError, match="prints"):
        run_script(write(tmp_path, f"print(7)\n{FIGURE}"))
    with pytest.raises(ScriptError, match="0 figures"):
        run_script(write(tmp_path, "print(6)\n"))


def test_gallery_shows_each_script_once() -> None:
    pages = gallery_pages(SCRIPTS)
    assert set(pages) == {"index", *(script.name for script in SCRIPTS)}
    index = pages["index"][1]
    assert all(index.count(f"({script.name}.md)") == 1 for script in SCRIPTS)
    with pytest.raises(ValueError, match="holds"):
        gallery_pages(SCRIPTS[1:])
