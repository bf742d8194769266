"""The works whose methods this report uses, and where it names them."""

import csv
import re
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import final

PATH = Path(__file__).with_name("bibliography.csv")


@final
@dataclass(frozen=True)
class Work:
    """A work."""

    name: str  # Of its place in the report
    short: str  # Who and when, as a text cites it
    authors: str  # Of the work
    title: str  # Of the work
    published: str  # Where and when
    words: str  # Pattern of the words with which a text speaks of its method


@cache
def works() -> tuple[Work, ...]:
    """Return all works, by their authors."""
    with PATH.open(encoding="utf-8", newline="") as file:
        return tuple(Work(**row) for row in csv.DictReader(file))


def cited(*texts: str) -> tuple[Work, ...]:
    """Return the works whose methods texts speak of, in the order of all works."""
    text = "\n".join(texts)
    return tuple(work for work in works() if re.search(work.words, text))
