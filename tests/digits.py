"""Which tests rest on digits: all but those listed here, so that no new one is forgotten."""

from functools import cache
from pathlib import Path

TESTS = Path(__file__).parent
WITHOUT_DIGITS = (
    "derivations",
    "documentation/test_blocks.py",
    "documentation/test_generated_pages.py",
    "documentation/test_notebooks.py",
    "hostile",
    "project",
    "report/building",
    "report/cache",
    "report/copy",
    "report/pages",
    "report/rendering",
    "trimmer/test_code_generation.py",
    "trimmer/test_files.py",
    "trimmer/test_messages.py",
    "trimmer/test_package.py",
    "trimmer/test_pickling.py",
    "trimmer/test_wrong_types.py",
)
"""Folders and files of tests about symbols, texts, files, pages and processes, which no rounding reaches."""


@cache
def rests_on_digits(path: Path) -> bool:
    """Return whether the tests of a file compare what the processor's rounding may change."""
    if not path.is_relative_to(TESTS):
        return False
    name = path.relative_to(TESTS).as_posix()
    return not any(name == listed or name.startswith(f"{listed}/") for listed in WITHOUT_DIGITS)
