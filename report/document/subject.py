"""The text that a report judges: all that a build has to know of it, whichever text it is."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import final

from report.judging.verdict import Grade


@final
@dataclass(frozen=True)
class Subject:
    """A text that is judged."""

    title: str  # Of the report
    called: str  # What the report calls the text, a noun such as thesis or paper
    command: str  # What makes the report again
    chapters: Mapping[str, str]  # Their titles by number or letter, in their order
    claims: str  # Name of the package whose modules judge the text
    records: str  # Where these modules are, in words
    inventory: str  # Which file has its statements and takes one more, in words
    meanings: Mapping[Grade, str]  # What each grade says, as Markdown
    # Folder below which the sources of claims are; a relative one is below that of this project
    root: str = ""
    # Whether its cards cite works of report/data/bibliography.csv whose methods they name
    cites: bool = False
    by_machine: bool = False  # Whether a machine read it from pages, so that its drawings were not seen

    def file_of(self, module: str) -> str:
        """Name the file of a module of the package; another module keeps its name."""
        inner = module.removeprefix(f"{self.claims}.")
        return module if inner == module else f"{self.records}/{inner.replace('.', '/')}.py"


def usual_meanings(called: str) -> dict[Grade, str]:
    """Return what the grades say of a text that is called so."""
    return {
        Grade.CONCLUSION: f"is wrong, and a conclusion of the {called} changes with it",
        Grade.RESULT: "a number or a formula is wrong; the right one stands beside it",
        Grade.SLIP: "is wrong without effect on anything else",
        Grade.COPY: "differs by what a page read by machine explains; the card says what would decide it",
        Grade.NOT_CHECKABLE: f"needs something the {called} does not give; the card says what",
        Grade.REPRODUCED: f"follows from the {called}'s own model, to every printed digit",
    }
