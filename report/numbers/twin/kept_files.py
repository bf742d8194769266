"""Files of computed data that are kept with the code: what is in them, and from what it was made.

A file is JSON with ``inputs`` (the SHA-256 of all that it was made from), ``program`` (the version of the
program that made it, as a note), ``digest`` (the SHA-256 of its ``content``) and ``content``.
"""

import hashlib
import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any, Final

from trimmer import TrimmerError
from trimmer.files import write_atomically

FOLDER: Final = Path(__file__).parents[2] / "data" / "twin"
REMEDY: Final = "run `make maps`, look at what changes in the report, and commit the file"
DIGITS: Final = 9  # Significant digits of what is exact


class KeptDataError(TrimmerError, ValueError):
    """A kept file is missing, damaged, or made from something else; the message says what to do."""


def read_kept(path: Path, inputs: str) -> Any:
    """Return the content of a kept file, which has to be made from inputs with a given SHA-256.

    Raises:
        KeptDataError: if the file is not there, was made from something else, or has been changed since.
    """
    try:
        kept = json.loads(path.read_text(encoding="utf-8"))
        made_from, digest, content = kept["inputs"], kept["digest"], kept["content"]
    except (OSError, ValueError, KeyError, TypeError) as error:
        raise KeptDataError(f"{path.name} of report/data/twin cannot be read ({error}): {REMEDY}") from error
    if made_from != inputs:
        raise KeptDataError(
            f"{path.name} of report/data/twin was made from another mechanism, other places, values or "
            f"settings than the report now asks for: {REMEDY}"
        )
    if digest != digest_of(content):
        raise KeptDataError(f"{path.name} of report/data/twin was changed after it was made: {REMEDY}")
    return content


def write_kept(path: Path, inputs: str, content: Mapping[str, Any]) -> None:
    """Write a kept file, a line for each entry of the content and for each row of a table in it.

    Raises:
        FileWriteError: if it cannot be written.
    """
    from trimmer import __version__

    head = {"inputs": inputs, "program": __version__, "digest": digest_of(content)}
    lines = [f" {json.dumps(name)}: {json.dumps(value)}," for name, value in head.items()]
    entries = ",\n".join(f"  {json.dumps(name)}: {_rows(value)}" for name, value in content.items())
    write_atomically(path, "\n".join(["{", *lines, ' "content": {', entries, " }", "}", ""]))


def digest_of(content: Any) -> str:
    """Return the SHA-256 of data as JSON."""
    return hashlib.sha256(json.dumps(content, sort_keys=True).encode()).hexdigest()


def rounded(value: float | None, digits: int = DIGITS) -> float | None:
    """Return a number as it is kept; None for what is not a number."""
    return None if value is None or value != value else float(f"{value:.{digits}g}")


def digest_of_files(folder: Path = FOLDER) -> str:
    """Return the SHA-256 of all kept files together."""
    summary = hashlib.sha256()
    for path in sorted(folder.glob("*.json")):
        summary.update(path.name.encode() + b"\0" + path.read_bytes())
    return summary.hexdigest()


def _rows(value: Any) -> str:
    if not (isinstance(value, list) and value and isinstance(value[0], list | str)):
        return json.dumps(value)
    return "[\n" + ",\n".join(f"   {json.dumps(row)}" for row in value) + "\n  ]"
