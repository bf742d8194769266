"""The mechanisms that come with the package."""

from pathlib import Path

from trimmer.errors import TrimmerError
from trimmer.messages import near_or_all

_PACKAGE = Path(__file__).parent
USUAL = "thesis-play"  # The example to start from, if none is named


class UnknownExampleError(TrimmerError, ValueError):
    """There is no example of this name; the message lists those there are."""


def examples() -> tuple[str, ...]:
    """Return the names of the examples, in alphabetical order."""
    return tuple(sorted(path.stem for path in _folder().glob("*.toml")))


def example_text(name: str = USUAL) -> str:
    """Return the commented file of an example."""
    if name not in examples():
        raise UnknownExampleError(f"there is no example {name!r}; {near_or_all(name, examples())}")
    return (_folder() / f"{name}.toml").read_text(encoding="utf-8")


def example_tables(name: str) -> dict[str, str]:
    """Return the text of the tables that an example names, by their names; they are to stand beside it."""
    return {path.name: path.read_text(encoding="utf-8") for path in sorted(_folder().glob(f"{name}*.csv"))}


def example_proof(name: str) -> str:
    """Return the text of a kept proof, by the name of its file."""
    return (_folder() / "proofs" / f"{name}.json").read_text(encoding="utf-8")


def _folder() -> Path:
    """Return their folder: in an installed package inside of it, in a checkout at the top."""
    installed = _PACKAGE / "examples"
    return installed if installed.is_dir() else _PACKAGE.parent / "examples"
