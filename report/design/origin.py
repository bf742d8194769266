"""What a report on designs was made from, and when."""

from collections.abc import Iterable
from dataclasses import dataclass
from datetime import UTC, datetime

from report.pages.escaping import shown_characters
from report.pages.provenance import Provenance, provenance
from trimmer.design.specification.design_file import DesignFile
from trimmer.source_date import source_date

SHOWN_DIGITS = 12  # Digits of a file's hash below the title; the table at the end has all


@dataclass(frozen=True)
class Origin:
    """What a report was made from."""

    date: str  # ISO date of the day on which it was made, UTC
    files: tuple[tuple[str, str, str], ...]  # Name, author and SHA-256 of each mechanism file
    provenance: Provenance  # The program and its libraries

    @property
    def line(self) -> str:
        """The line below the title, plain text."""
        authors = list(dict.fromkeys(author for _, author, _ in self.files if author))
        by = f"by {' and '.join(authors)}; " if authors else ""
        files = " and ".join(f"{name} (SHA-256 {digest[:SHOWN_DIGITS]}…)" for name, _, digest in self.files)
        return f"{by}made on {self.date} with trimmer {self.provenance.version} from {files}"


def origin_of(files: Iterable[DesignFile], date: str) -> Origin:
    """Return what a report on some files is made from, on a day."""
    told = tuple((shown_characters(each.name), each.author, each.digest) for each in files)
    return Origin(date, told, provenance())


def today() -> str:
    """Return the ISO date of today, UTC, or that of ``SOURCE_DATE_EPOCH`` where it is set.

    Raises:
        DateError: if that is no date.
    """
    return (source_date() or datetime.now(UTC)).date().isoformat()
