"""A folder with a text that somebody else wrote, its list of statements, and the Python that judges them."""

import csv
import re
import tomllib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final, final

from report.copy.pictures import fault_of_picture
from report.copy.reading import CopyFileError, ReaderCopy, read_judged_text
from report.data.statements import ThesisSection
from report.data.text_copy import TextCopy
from report.document.subject import Subject, usual_meanings
from report.judging.claim import Kind, Statement
from report.judging.inventory import InventoryError, filed, read_statements
from trimmer.errors import TrimmerError
from trimmer.messages import did_you_mean, listed, near_words, shown_value

DESCRIPTION: Final = "judge.toml"
INVENTORY: Final = "inventory.csv"
PACKAGE: Final = "judged"  # Name under which the modules of the folder are imported
_KEYS: Final = ("title", "called", "text", "sections")
_ID: Final = re.compile(r"[A-Za-z][\w.:-]*", re.ASCII)
_PICTURE: Final = re.compile(r"!\[[^]]*\]\(([^)\s]+)\)")
_NUMBER: Final = re.compile(r"\w+(\.\w+)*", re.ASCII)


class FolderError(TrimmerError, ValueError):
    """A folder cannot be judged; the message names file and key, and says what to do."""


@final
@dataclass(frozen=True)
class JudgedFolder:
    """A folder that was read; nothing in it has been run."""

    path: Path  # The folder
    subject: Subject  # What the report has to know of the text
    inventory: Mapping[str, Statement]  # The statements by their ids
    sections: tuple[ThesisSection, ...]  # Numbers and titles of the sections
    text: TextCopy  # What is known of the text
    copy: ReaderCopy  # Its lines, which the page shows beside the cards


def read_folder(path: Path) -> JudgedFolder:
    """Read what is judged.

    Raises:
        FolderError: naming file, key and value, if a file is missing or says what cannot be used.
    """
    if not path.is_dir():
        raise FolderError(f"{path}: is no folder; give one with {DESCRIPTION} and {INVENTORY}")
    words = _description(path / DESCRIPTION)
    titles = words["sections"]
    inventory = _inventory(path / INVENTORY, titles)
    try:
        copy = read_judged_text(path / words["text"])
    except CopyFileError as error:
        raise FolderError(
            f"{path / DESCRIPTION}: text = {shown_value(words['text'])}: {error}; name the text "
            "that is judged, a file beside it"
        ) from error
    for line, entry in enumerate(inventory.values(), start=2):
        _require_place(path / INVENTORY, line, entry, len(copy.lines))
    _require_pictures(path / words["text"], copy.lines)
    subject = Subject(
        title=words["title"],
        called=words["called"],
        command=f"trimmer judge {path}",
        chapters={number: title for number, title in titles.items() if "." not in number},
        claims=PACKAGE,
        records=str(path),
        inventory=str(path / INVENTORY),
        meanings=usual_meanings(words["called"]),
        root=str(path.absolute()),
    )
    text = TextCopy(copy.sha256, len(copy.lines), words["text"])
    sections = tuple(ThesisSection(number, title) for number, title in titles.items())
    return JudgedFolder(path, subject, inventory, sections, text, copy)


def _description(path: Path) -> dict[str, Any]:
    try:
        words = tomllib.loads(path.read_text("utf-8"))
    except FileNotFoundError:
        raise FolderError(f"{path}: is not there; write it, with {listed(_KEYS)}") from None
    except (OSError, UnicodeDecodeError, tomllib.TOMLDecodeError) as error:
        raise FolderError(f"{path}: cannot be read: {error}; write it as TOML in UTF-8") from error
    for key in words:
        if key not in _KEYS:
            advice = did_you_mean(near_words(key, _KEYS)) or f"the keys are {listed(_KEYS)}"
            raise FolderError(f"{path}: {shown_value(key)} is no key of it; {advice}")
    if lacking := [key for key in _KEYS if key not in words]:
        raise FolderError(f"{path}: lacks {listed(lacking)}; add {'it' if len(lacking) == 1 else 'them'}")
    for key in ("title", "called", "text"):
        _require_words(path, key, words[key])
    _require_sections(path, words["sections"])
    return words


def _require_words(path: Path, key: str, value: object) -> None:
    if not (isinstance(value, str) and value.strip() and value.isprintable()):
        raise FolderError(f'{path}: {key} = {shown_value(value)}: write a line of text, such as {key} = "…"')


def _require_sections(path: Path, sections: object) -> None:
    if not (isinstance(sections, dict) and sections):
        raise FolderError(
            f'{path}: sections = {shown_value(sections)}: write [sections], a line 1 = "Title" each'
        )
    for number, title in sections.items():
        if _NUMBER.fullmatch(number) is None:
            raise FolderError(
                f'{path}: sections: {shown_value(number)} is no number; write 2, "2.1" or A '
                "(quote what has a point)"
            )
        _require_words(path, f"sections.{number}", title)


def _inventory(path: Path, titles: Mapping[str, str]) -> Mapping[str, Statement]:
    if not path.is_file():
        raise FolderError(
            f"{path}: is not there; write it, with the columns id, kind, section and subject and a line for "
            "each statement that is to be judged"
        )
    try:
        inventory = filed(read_statements(path), path)
    except InventoryError as error:
        raise FolderError(f"{path.parent}: {error}") from error
    except (OSError, UnicodeDecodeError, csv.Error) as error:
        raise FolderError(f"{path}: cannot be read: {error}; write it as CSV in UTF-8") from error
    if not inventory:
        raise FolderError(f"{path}: has no statement; add a line for each that is to be judged")
    for line, entry in enumerate(inventory.values(), start=2):
        _require_entry(path, line, entry, titles)
    return inventory


def _require_entry(path: Path, line: int, entry: Statement, titles: Mapping[str, str]) -> None:
    where = f"{path}, line {line}"
    if _ID.fullmatch(entry.id) is None or (entry.kind is not Kind.STATEMENT and "-" not in entry.id):
        raise FolderError(
            f"{where}: the id {shown_value(entry.id)}: write letters, digits and -_.: alone, and what the "
            f"text calls it behind the first -, such as {_example(entry.kind)}"
        )
    for number in (entry.section, entry.chapter):
        if number not in titles:
            raise FolderError(
                f'{where}: {entry.id}: section {shown_value(number)} has no title; add {_key(number)} = "…" '
                f"below [sections] of {path.with_name(DESCRIPTION)}"
            )


def _require_place(path: Path, line: int, entry: Statement, count: int) -> None:
    """Check that a statement stands in the text, and that the file that judges it is there."""
    where = f"{path}, line {line}: {entry.id}"
    if entry.lines is not None and not 1 <= entry.lines[0] <= entry.lines[1] <= count:
        raise FolderError(
            f"{where}: first_line and last_line are {entry.lines[0]} and {entry.lines[1]}; write "
            f"lines of the text, which has {count}, or leave both out"
        )
    if entry.source and not (path.parent / entry.source).is_file():
        raise FolderError(
            f"{where}: source {shown_value(entry.source)} is no file beside it; name one, or leave it out"
        )


def _require_pictures(path: Path, lines: Sequence[str]) -> None:
    """Check the files that a text in Markdown shows as pictures."""
    for number, line in enumerate(lines, start=1):
        for name in _PICTURE.findall(line):
            if "://" in name:
                continue
            where = f"{path}, line {number}: shows the picture {shown_value(name)}, which"
            if not (path.parent / name).is_file():
                raise FolderError(f"{where} is not there; put it beside the text, or mend the line")
            if fault := fault_of_picture(path.parent / name):
                raise FolderError(f"{where} is damaged: {fault}; put a whole one beside the text")


def _example(kind: Kind) -> str:
    return {Kind.EQUATION: "eq-3", Kind.FIGURE: "fig-2", Kind.TABLE: "tab-1", Kind.LISTING: "lst-1"}.get(
        kind, "txt-damping"
    )


def _key(number: str) -> str:
    return f'"{number}"' if "." in number else number
