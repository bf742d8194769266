"""Formulas that were not written for this report: shown where pandoc can read them, told apart where not."""

import json
import re
import subprocess
from collections.abc import Sequence

from report.pages.formulas.mathml import repaired

_PARAGRAPH = re.compile(r"<p>(.*?)</p>", re.DOTALL)
_NOT_IN_XML = re.compile("[^\t\n\r\u0020-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")
_API = [1, 23, 1]
_SECONDS = 60
_LONGEST = 20_000


def to_mathml(formulas: Sequence[str]) -> tuple[str | None, ...]:
    """Return LaTeX formulas as MathML, and None for each that pandoc cannot read.

    The formulas reach pandoc as data, not as Markdown; nothing in them is carried out. Pandoc escapes what
    becomes text.
    """
    readable = [formula for formula in formulas if len(formula) <= _LONGEST]
    written = dict(zip(readable, _written(readable), strict=True)) if readable else {}
    return tuple(written.get(formula) for formula in formulas)


def _written(formulas: Sequence[str]) -> Sequence[str | None]:
    import pypandoc  # here, so that importing the package does not look for the binary

    document = {"pandoc-api-version": _API, "meta": {}, "blocks": [_block(formula) for formula in formulas]}
    command = [pypandoc.get_pandoc_path(), "--from=json", "--to=html5", "--mathml", "--wrap=none", "--quiet"]
    nothing = [None] * len(formulas)
    try:
        finished = subprocess.run(
            command, input=json.dumps(document).encode(), capture_output=True, check=True, timeout=_SECONDS
        )
    except (subprocess.CalledProcessError, subprocess.TimeoutExpired):
        return nothing
    found = _PARAGRAPH.findall(finished.stdout.decode())
    if len(found) != len(formulas):
        return nothing
    return [repaired(html) if html.startswith("<math ") else None for html in found]


def _block(formula: str) -> object:
    mathematics = {"t": "Math", "c": [{"t": "DisplayMath"}, _NOT_IN_XML.sub("\ufffd", formula)]}
    return {"t": "Para", "c": [mathematics]}
