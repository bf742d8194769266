"""What the folder of the corrected listings says of itself."""

from __future__ import annotations

from collections.abc import Iterable

from jinja2 import Environment, FileSystemLoader, StrictUndefined

from report.document.thesis import Program
from report.folders import templates

NAME = "README.md"


def readme(programs: Iterable[Program]) -> str:
    """Return how the programs are run, and what each is, as Markdown."""
    listed = tuple(programs)
    environment = Environment(
        loader=FileSystemLoader(templates() / "octave"),
        undefined=StrictUndefined,
        autoescape=False,
        trim_blocks=True,
        keep_trailing_newline=True,
    )
    names = {program.name for program in listed}
    return environment.get_template(f"{NAME}.j2").render(programs=listed, names=names)
