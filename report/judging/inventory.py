"""Lists of the statements that are to be judged: ids, kinds, sections and subjects."""

from __future__ import annotations

import csv
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from enum import Enum
from pathlib import Path
from typing import TypeVar

from report.judging.claim import Kind, Statement
from report.judging.verdict import Certainty, Impact, Severity
from trimmer.errors import TrimmerError
from trimmer.messages import listed, near_or_all

Word = TypeVar("Word", bound=Enum)
COLUMNS = ("id", "kind", "section", "subject")
"""What a list of statements has."""
FURTHER = ("source", "impact", "first_line", "last_line", "paragraph", "severity", "certainty", "title")
"""What may be said of a statement."""


class InventoryError(TrimmerError, ValueError):
    """The inventory holds an id twice, or a kind that is not known, or what is said of it cannot be used."""


def read_statements(*paths: Path) -> Mapping[str, Statement]:
    """Read the statements of some files together, by id, in their order, with the subjects as titles.

    Raises:
        InventoryError: naming file, line and value, if an id stands twice, or a kind is not known.
    """
    entries: dict[str, Statement] = {}
    for path in paths:
        for line, entry in _entries(path):
            if entry.id in entries:
                raise InventoryError(f"{path.name}, line {line}: the id {entry.id} stands there twice")
            entries[entry.id] = entry
    return entries


def filed(entries: Mapping[str, Statement], path: Path) -> Mapping[str, Statement]:
    """Return the statements with what a table says of each.

    Args:
        entries: The statements by id.
        path: File with the column ``id`` and any of ``source``, ``impact``, ``first_line``, ``last_line``,
            ``paragraph``, ``severity``, ``certainty`` and ``title``, a line for each statement. A title
            stands in the place of the subject. It may be the file of the statements.

    Raises:
        InventoryError: naming file and ids, if a statement has not one line or a line has no statement;
            naming file, line and fault, if what it says is not a number or a word that there is.
    """
    with path.open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    ids = [row["id"] for row in rows]
    if wrong := sorted({each for each in ids if ids.count(each) > 1} | (set(ids) ^ set(entries))):
        raise InventoryError(f"{path.name}: has one line for each statement; see {', '.join(wrong)}")
    found = dict(entries)
    for line, row in enumerate(rows, start=2):
        try:
            found[row["id"]] = _filed(entries[row["id"]], row)
        except ValueError as error:
            raise InventoryError(f"{path.name}, line {line}: {error}") from error
    return found


def _filed(entry: Statement, row: Mapping[str, str]) -> Statement:
    given = {column: (row.get(column) or "").strip() for column in FURTHER}
    first, last = given["first_line"], given["last_line"]
    return replace(
        entry,
        title=given["title"] or entry.title,
        source=given["source"],
        impact=_word("impact", Impact, given["impact"] or Impact.NONE.value),
        lines=(_number("first_line", first), _number("last_line", last)) if first or last else None,
        paragraph=_number("paragraph", given["paragraph"]) if given["paragraph"] else None,
        severity=_word("severity", Severity, given["severity"]) if given["severity"] else None,
        certainty=_word("certainty", Certainty, given["certainty"]) if given["certainty"] else None,
    )


def _number(column: str, text: str) -> int:
    if not (text.isascii() and text.isdigit()):
        raise ValueError(f"{column} {text!r} is no number of a line or paragraph; write one such as 12")
    return int(text)


def _word(column: str, kind: type[Word], text: str) -> Word:
    words = [each.value for each in kind]
    if text not in words:
        raise ValueError(f"{column} {text!r} is not known; there are {listed(words)}")
    return kind(text)


def _entries(path: Path) -> Iterator[tuple[int, Statement]]:
    with path.open(encoding="utf-8", newline="") as file:
        reader = csv.DictReader(file)
        _require_columns(path, reader.fieldnames or ())
        for line, row in enumerate(reader, start=2):
            if None in row or None in row.values():
                raise InventoryError(
                    f"{path.name}, line {line}: not as many columns as line 1 names; quote a comma"
                )
            if row["kind"] not in (kinds := [kind.value for kind in Kind]):
                raise InventoryError(
                    f"{path.name}, line {line}: unknown kind {row['kind']!r}; there are {listed(kinds)}"
                )
            if empty := [column for column in COLUMNS if not row[column].strip()]:
                raise InventoryError(f"{path.name}, line {line}: {listed(empty)} must not be empty")
            yield line, Statement(row["id"], Kind(row["kind"]), row["section"], row["subject"])


def _require_columns(path: Path, names: Sequence[str]) -> None:
    """Check that line 1 names what is needed, and nothing twice or unknown."""
    if lacking := [column for column in COLUMNS if column not in names]:
        raise InventoryError(f"{path.name}, line 1: lacks {listed(lacking)}; it names the columns")
    for name in names:
        known = (*COLUMNS, *FURTHER)
        if name not in known:
            advice = near_or_all(name, known)
            raise InventoryError(f"{path.name}, line 1: {name!r} is no column of it; {advice}")
        if names.count(name) > 1:
            raise InventoryError(f"{path.name}, line 1: names the column {name} twice; keep one")
