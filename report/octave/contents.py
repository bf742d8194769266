"""What each corrected listing is about, and what was wrong in the thesis's."""

import tomllib
from dataclasses import dataclass
from functools import cache
from pathlib import Path

PATH = Path(__file__).parents[1] / "data" / "listings.toml"


@dataclass(frozen=True)
class Content:
    """A program: the thesis's listing and section that it corrects, its title, and the faults it corrects.

    ``source`` names the file of this project that derives its formulas; it is empty for a program that calls
    others for them. Texts are ASCII, for any editor.
    """

    number: str
    section: str
    title: str
    faults: tuple[str, ...]
    source: str

    @property
    def function(self) -> str:
        """Name of the program's function; its file is called so too."""
        return f"listing_{self.number.lower().replace('.', '_')}"

    @property
    def claim(self) -> str:
        """Id of the claim on the thesis's listing."""
        return f"lst-{self.number}"


@cache
def contents() -> tuple[Content, ...]:
    """Read the corrected listings, in thesis order."""
    listings = tomllib.loads(PATH.read_text(encoding="utf-8"))
    return tuple(Content(number, **of | {"faults": tuple(of["faults"])}) for number, of in listings.items())
