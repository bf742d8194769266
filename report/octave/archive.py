"""The corrected listings as files with a README, and as one archive of them."""

import io
import zipfile
from collections.abc import Iterable
from pathlib import Path

from jinja2 import Environment, FileSystemLoader, StrictUndefined

from report.document.thesis import Program
from report.folders import templates
from trimmer.files import write_atomically

NAME = "README.md"
_EARLIEST = (1980, 1, 1, 0, 0, 0)
_READABLE = 0o100644 << 16
_UNIX = 3


def readme(programs: Iterable[Program]) -> str:
    """Return how the programs are run, and what each is, as Markdown."""
    listed = tuple(programs)
    names = {program.name for program in listed}
    return environment().get_template(f"{NAME}.j2").render(programs=listed, names=names)


def environment() -> Environment:
    """Return a new environment of the templates of programs and of what is said of them."""
    return Environment(
        loader=FileSystemLoader(templates() / "octave"),
        undefined=StrictUndefined,
        autoescape=False,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
    )


def files(programs: Iterable[Program]) -> dict[str, str]:
    """Return the text of each program by its file name, and what the folder says of them; nothing of none."""
    listed = tuple(programs)
    texts = {program.name: program.text for program in listed}
    return {NAME: readme(listed), **texts} if listed else {}


def write_files(programs: Iterable[Program], folder: Path) -> None:
    """Write each program into a folder, whole or not at all.

    Raises:
        FileWriteError: if a file cannot be written.
    """
    for name, text in files(programs).items():
        write_atomically(folder / name, text)


def archive(programs: Iterable[Program]) -> bytes:
    """Return a zip archive of the programs; the same programs give the same bytes.

    Nothing is compressed, because the bytes would then depend on the version of the compressor.
    """
    content = io.BytesIO()
    with zipfile.ZipFile(content, "w", zipfile.ZIP_STORED) as packed:
        for name, text in files(programs).items():
            entry = zipfile.ZipInfo(name, _EARLIEST)
            entry.create_system, entry.external_attr = _UNIX, _READABLE
            packed.writestr(entry, text)
    return content.getvalue()
