"""Say what differs between two states of the project, for a refactoring that must change nothing.

    python scripts/compare_builds.py keep FOLDER      writes the report and what the commands print
    python scripts/compare_builds.py compare OLD NEW  prints each difference; exits with 1 if there is any

Left out are source paths with their lines, the chapter "Code" and the provenance. The text of the PDF needs
pdftotext.
"""

import argparse
import contextlib
import difflib
import io
import json
import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterator
from pathlib import Path

PROJECT = Path(__file__).resolve().parent.parent
COMMANDS = "commands.json"
EXPORTS = "exports.json"
SHOWN = 400
"""Most characters of a difference that are printed."""
SOURCE = re.compile(r"Derived\s+in:\s+(\S+\s+)*?\S+\.py")
PROVENANCE = re.compile(r"^trimmer \d[^\n]*$|^Certificate$.*?\f", re.MULTILINE | re.DOTALL)
CODE_LINK = re.compile(r'<a [^>]*href="#code[^"]*"[^>]*>.*?</a>|(?<=\.py), lines \d+–\d+', re.DOTALL)
GENERATED = re.compile(
    r"%\s+Generated[\s%]+from.*?SI[\s%]+units[\s%]+throughout\.|\b\d+\s+lines\b", re.DOTALL
)
"""What a corrected listing says of its template, and how many lines it has with that."""
PAGE = ["-x", "0", "-y", "55", "-W", "2000", "-H", "730"]
"""Part of a page between its header and its footer, for pdftotext."""


def main() -> int:
    """Keep or compare; return the exit code."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    actions = parser.add_subparsers(dest="action", required=True)
    actions.add_parser("keep").add_argument("folder", type=Path)
    compare = actions.add_parser("compare")
    compare.add_argument("old", type=Path)
    compare.add_argument("new", type=Path)
    arguments = parser.parse_args()
    if arguments.action == "keep":
        return keep(arguments.folder.resolve())
    for folder in (arguments.old, arguments.new):
        if not (folder / "claims.json").is_file():
            parser.error(f"{folder} has no claims.json; write one with keep {folder}")
    found = list(differences(arguments.old, arguments.new))
    print("\n".join(found) or "no difference")
    return 1 if found else 0


def keep(folder: Path) -> int:
    """Build the report into a folder, with the JSON of the commands' examples and the package's names."""
    import trimmer
    from trimmer.command_line.main import main as run

    if code := run(["report", "--directory", str(folder)]):
        return code
    write_json(folder / COMMANDS, {line: printed(run, line) for line in example_commands()})
    write_json(folder / EXPORTS, sorted(trimmer.__all__))
    return 0


def example_commands() -> list[str]:
    """Return the examples of each command's help that print JSON, with ``--json``."""
    from trimmer.command_line.main import installed_commands

    return [
        f"{example.words} --json"
        for command in installed_commands()
        if knows_json(command.configure)
        for example in command.examples
        if "--json" not in example.arguments
    ]


def knows_json(configure: Callable[[argparse.ArgumentParser], None]) -> bool:
    """Say whether a command has the option ``--json``."""
    parser = argparse.ArgumentParser(add_help=False)
    configure(parser)
    return "--json" in parser.format_usage()


def printed(run: object, line: str) -> str:
    """Return what a command prints in a folder that holds the files the examples speak of."""
    assert callable(run)
    here, output = Path.cwd(), io.StringIO()
    with tempfile.TemporaryDirectory() as name, contextlib.redirect_stdout(output):
        os.chdir(name)
        try:
            Path("examples").symlink_to(PROJECT / "examples", target_is_directory=True)
            run(["parameters", "--output", "mine.toml"])
            vibration = "--element friction --gap 4e-5 --drive 110 --amplitude 1.5e-3 --csv vibration.csv"
            run(["simulate", *vibration.split()])
            output.truncate(0)
            output.seek(0)
            code = run(shlex.split(line)[1:])
        finally:
            os.chdir(here)
    return f"{output.getvalue()}exit code {code}"


def differences(old: Path, new: Path) -> Iterator[str]:
    """Yield a sentence for each difference of two folders that ``keep`` has written."""
    yield from claims_that_differ(old / "claims.json", new / "claims.json")
    for name in (COMMANDS, EXPORTS):
        yield from texts_that_differ(name, *(folder_lines(folder / name) for folder in (old, new)))
    yield from texts_that_differ(
        "report.html", *(page_lines(folder / "report.html") for folder in (old, new))
    )
    if shutil.which("pdftotext") is None:
        yield "PDFs: not compared, pdftotext is not installed"
    else:
        yield from texts_that_differ("PDFs", *(pdf_words(folder) for folder in (old, new)))


def claims_that_differ(old: Path, new: Path) -> Iterator[str]:
    """Yield what differs of claims.json, claim by claim and key by key."""
    before, after = (json.loads(path.read_text("utf-8")) for path in (old, new))
    rows = [{claim["id"]: claim for claim in content["claims"]} for content in (before, after)]
    if list(rows[0]) != list(rows[1]):
        yield f"claims.json: ids or their order differ: {sorted(set(rows[0]) ^ set(rows[1]))}"
    for claim_id in filter(rows[1].__contains__, rows[0]):
        first, second = rows[0][claim_id], rows[1][claim_id]
        for key in (first.keys() | second.keys()) - {"source"}:
            if first.get(key) != second.get(key):
                yield f"{claim_id}, {key}:\n  - {first.get(key)}\n  + {second.get(key)}"


def texts_that_differ(name: str, old: list[str], new: list[str]) -> Iterator[str]:
    """Yield the lines that were taken away and added."""
    if old == new:
        return
    for line in difflib.unified_diff(old, new, "old", "new", lineterm="", n=0):
        if line[:3] not in ("---", "+++", "@@ "):
            yield f"{name}: {line[:SHOWN]}"


def folder_lines(path: Path) -> list[str]:
    """Return the lines of a file, none if it is not there."""
    return path.read_text("utf-8").splitlines() if path.exists() else []


def page_lines(path: Path) -> list[str]:
    """Return the lines of the page without what may differ."""
    page = path.read_text("utf-8")
    for start, end in (
        ('<h2 id="certificate">', "<h2 "),
        ('<h2 id="code">', "</main>"),
        ("<header", "</header>"),
    ):
        page = without(page, start, end)
    page = re.sub(r"data:application/zip;base64,[^\"]*", "", GENERATED.sub("", page))
    return re.sub(r">\s*<", ">\n<", CODE_LINK.sub("", page)).splitlines()


def without(text: str, start: str, end: str) -> str:
    """Leave out what stands between two marks."""
    begin = text.index(start) + len(start)
    return text[:begin] + text[text.index(end, begin) :]


def pdf_words(folder: Path) -> list[str]:
    """Return which words and decimal numbers stand in the PDFs, without source paths and the certificate.

    Not how often, and not in which order: where a page breaks depends on the length of source paths, and with
    that page numbers and how often a table's head is repeated.
    """
    text = ""
    for path in sorted(folder.glob("*.pdf")):
        command = ["pdftotext", *PAGE, path, "-"]
        text += subprocess.run(command, capture_output=True, check=True, text=True).stdout
    for varying in (PROVENANCE, GENERATED, SOURCE):
        text = varying.sub("", text)
    return sorted(set(re.findall(r"[^\W\d_]{3,}|\d+[.,]\d+", re.sub(r"(?<=\w)-\s+(?=[a-z])", "", text))))


def write_json(path: Path, content: object) -> None:
    """Write a value as JSON."""
    path.write_text(json.dumps(content, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")


if __name__ == "__main__":
    sys.exit(main())
