"""The source files that derive what the shown findings rest on: the chapter of code of the HTML report."""

from dataclasses import dataclass
from pathlib import Path

from report.cache.source_closure import ROOT
from report.document.document import Document
from report.document.extras import Observation
from report.judging.finding import Finding
from report.pages.links import BrokenLinkError


@dataclass(frozen=True)
class ShownSource:
    """A source file of what judges, with the findings and observations that name it."""

    path: str  # Where it is, from the folder of the three packages, or from that of another text
    identifier: str  # Its place in the report
    text: str  # What it holds
    # Those that name it, in thesis order, and then observations of extra chapters; never empty
    findings: tuple[Finding | Observation, ...]


def identifier(path: str) -> str:
    """Return the place of a source file in the report, such as ``code-trimmer-balance-solve``."""
    return f"code-{path.removesuffix('.py').replace('/', '-')}"


def sources(document: Document) -> tuple[ShownSource, ...]:
    """Return each source file that a finding of the document or an observation names, by path.

    Raises:
        BrokenLinkError: naming the claim and the file, if a finding names a file that is not there.
    """
    findings: dict[str, list[Finding | Observation]] = {}
    observations = (each for extra in document.extras.values() for each in extra.observations)
    named: tuple[Finding | Observation, ...] = (*document.findings, *observations)
    for finding in named:
        findings.setdefault(finding.source, []).append(finding)
    return tuple(
        ShownSource(
            path,
            identifier(path),
            _text(ROOT / document.subject.root, path, findings[path][0]),
            tuple(findings[path]),
        )
        for path in sorted(findings)
    )


def _text(root: Path, path: str, finding: Finding | Observation) -> str:
    file = root / path
    if not file.is_file():
        raise BrokenLinkError(
            f"the claim {finding.id} is derived in {path!r}, which is not a file of this project; "
            "correct the claim's source"
        )
    return file.read_text(encoding="utf-8")
