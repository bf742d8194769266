"""The tool that runs the blocks of pages notices what a reader would stumble over."""

from pathlib import Path

import pytest

from scripts.site.blocks import blocks, with_outputs
from scripts.site.running import PageError, run_page

PAGE = """# A page

```toml title="mine.toml"
a = 1
```

```python
from pathlib import Path
number = len(Path("mine.toml").read_text())
```

prints nothing, and

<!-- slow -->
```python
print(number)
```

prints

```text
6
```

<!-- not run: it needs a network -->
```sh
pip install something
```
"""


def run(tmp_path: Path, page: str, *, slow: bool = True) -> dict[int, str]:
    path = tmp_path / "page.md"
    path.write_text(page, encoding="utf-8")
    folder = tmp_path / "run"
    folder.mkdir(exist_ok=True)
    return run_page(path, folder, slow=slow)


def test_blocks_have_their_language_output_title_and_comment() -> None:
    found = blocks(PAGE)
    assert [block.language for block in found] == ["toml", "python", "python", "sh"]
    assert [block.is_run for block in found] == [False, True, True, False]
    assert [block.slow for block in found] == [False, False, True, False]
    assert [block.output for block in found] == [None, None, "6\n", None]
    assert found[0].title == "mine.toml"
    assert [PAGE.splitlines()[block.line - 1] for block in found][2] == "print(number)"


def test_blocks_share_names_and_files_and_print_what_is_shown(tmp_path: Path) -> None:
    assert list(run(tmp_path, PAGE).values()) == ["", "6\n"]
    assert list(run(tmp_path, PAGE, slow=False).values()) == [""]
    run(tmp_path, PAGE.replace("\n6\n", "\n...\n"))  # dots stand for anything
    with pytest.raises(PageError, match=r"page\.md, line 16"):
        run(tmp_path, PAGE.replace("\n6\n", "\n7\n"))


def test_exit_codes_are_compared(tmp_path: Path) -> None:
    page = "```sh\ntrimmer respond nothing.toml\n```\n"
    with pytest.raises(PageError, match="exit code 2 in place of 0"):
        run(tmp_path, page)
    told = "\n```text\ntrimmer: nothing.toml: ...\n```\n"
    run(tmp_path, f"<!-- exit 2 -->\n{page}{told}")
    with pytest.raises(PageError, match=r"Differences"):
        run(tmp_path, f"<!-- exit 2 -->\n{page}{told.replace('nothing', 'something')}")


def test_commands_with_pipes_run_in_a_shell(tmp_path: Path) -> None:
    page = "```sh\ntrimmer --version | tr a-z A-Z | cut -c1-7\n```\n\n```text\nTRIMMER\n```\n"
    run(tmp_path, page)
    with pytest.raises(PageError):
        run(tmp_path, page.replace("\nTRIMMER\n", "\ntrimmer\n"))


def test_outputs_are_written_into_the_page(tmp_path: Path) -> None:
    other = PAGE.replace("\n6\n", "\n")
    assert with_outputs(other, run(tmp_path, other.replace("```text\n", "```text\n...\n"))) == PAGE
