"""What has changed between two versions of ``claims.json``."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass
from itertools import takewhile
from pathlib import Path
from typing import Any

from trimmer.errors import TrimmerError
from trimmer.files import read_content
from trimmer.json_data import DataError, parsed_json
from trimmer.messages import shown_value

COMPARED = ("verdict", "severity", "printed", "derived", "explanation")
JUDGED = {"verdict", "severity"}
SCHEMAS = (1, 2)
ADDED = {"severity": 2}
"""Schema that a field came with; the others are in all."""
LONGEST = 60
"""Most characters of a text that are shown whole."""
BEFORE = 15
"""Characters shown before the first difference of two long texts."""

Fields = Mapping[str, str]


class ClaimsFileError(TrimmerError, ValueError):
    """A file of claims cannot be read, or is none."""


@dataclass(frozen=True)
class ClaimsFile:
    """A file of claims: what it is called, its schema, and the fields of each claim by its id."""

    name: str
    schema: int
    claims: Mapping[str, Fields]


def read_claims(path: Path) -> ClaimsFile:
    """Read ``claims.json`` of this version or of an earlier one.

    Raises:
        ClaimsFileError: naming the file and what is wrong with it.
    """
    try:
        content = read_content(path)
    except OSError as error:
        raise ClaimsFileError(f"--compare {path}: cannot be read: {error.strerror or error}") from error
    try:
        return parsed_claims(content, path.name)
    except DataError as error:
        raise ClaimsFileError(f"--compare {path}: {error}; give a claims.json of trimmer report") from error


def parsed_claims(text: bytes | str, name: str) -> ClaimsFile:
    """Return the claims of the text of a file of claims.

    Raises:
        DataError: if it is no such text.
    """
    content = parsed_json(text)
    if not isinstance(content, dict) or not isinstance(content.get("claims"), list):
        raise DataError("it has no list of claims")
    schema = content.get("schema")
    if type(schema) is not int or schema not in SCHEMAS:
        known = " and ".join(map(str, SCHEMAS))
        raise DataError(f"its schema is {shown_value(schema)}, and this version reads {known}")
    claims: dict[str, Fields] = {}
    for number, claim in enumerate(content["claims"], start=1):
        fields = _fields(claim, schema, number)
        if fields["id"] in claims:
            raise DataError(f"it has the claim {shown_value(fields['id'])} twice")
        claims[fields["id"]] = fields
    return ClaimsFile(name, schema, claims)


def _fields(claim: Any, schema: int, number: int) -> Fields:
    names = ("id", "section", *(name for name in COMPARED if ADDED.get(name, 1) <= schema))
    given = claim if isinstance(claim, dict) else {}
    found = {name: given[name] for name in names if isinstance(given.get(name), str)}
    for name in names:
        if name not in found:
            raise DataError(f"its claim {number} has no text as {name}")
    return found


def differences(old: ClaimsFile, new: ClaimsFile, omitted: Collection[str] = ()) -> str:
    """Return as lines to print which claims are new, gone or changed, and how; new verdicts come first.

    What chapters hold that the new file leaves out, by their numbers, is not gone.
    """
    added = [claim for claim in new.claims if claim not in old.claims]
    gone = [
        claim
        for claim, fields in old.claims.items()
        if claim not in new.claims and fields["section"].split(".")[0] not in omitted
    ]
    changed = {
        claim: changes
        for claim, fields in new.claims.items()
        if claim in old.claims and (changes := dict(_changes(old.claims[claim], fields)))
    }
    judged_anew = [claim for claim, changes in changed.items() if changes.keys() & JUDGED]
    in_order = dict.fromkeys((*judged_anew, *changed))
    numbers = (
        f"{len(changed)} changed, of which {len(judged_anew)} in verdict or severity, {len(added)} new, "
        f"{len(gone)} gone"
    )
    lines = [
        f"compared with {_visible(old.name)} (schema {old.schema}, {len(old.claims)} claims): {numbers}",
        *(line for claim in in_order for line in _told(claim, changed[claim])),
        *(
            f"  {what}: {', '.join(map(_visible, ids))}"
            for what, ids in (("new", added), ("gone", gone))
            if ids
        ),
        *(
            f"  {name} is not compared: schema {old.schema} has none"
            for name, schema in ADDED.items()
            if old.schema < schema <= new.schema
        ),
    ]
    return "\n".join(lines)


def _changes(old: Fields, new: Fields) -> Iterator[tuple[str, str]]:
    for name in COMPARED:
        if name in old and name in new and old[name] != new[name]:
            before, after = _excerpts(old[name], new[name])
            yield name, f"{before} → {after}"


def _told(claim: str, changes: Mapping[str, str]) -> Iterator[str]:
    yield f"  {_visible(claim)}"
    yield from (f"    {name}: {change}" for name, change in changes.items())


def _excerpts(before: str, after: str) -> tuple[str, str]:
    """Show two texts, from shortly before their first difference if one of them is long."""
    if max(len(before), len(after)) <= LONGEST:
        return _visible(before) or "(nothing)", _visible(after) or "(nothing)"
    alike = sum(1 for _ in takewhile(lambda pair: pair[0] == pair[1], zip(before, after, strict=False)))
    start = max(0, alike - BEFORE)
    return _excerpt(before, start), _excerpt(after, start)


def _excerpt(text: str, start: int) -> str:
    end = start + LONGEST
    return f"{'…' if start else ''}{_visible(text[start:end])}{'…' if end < len(text) else ''}"


def _visible(text: str) -> str:
    """Leave out what would act on a terminal."""
    return "".join(character if character.isprintable() else " " for character in text)
