"""Findings as JSON, for machines."""

from __future__ import annotations

import json

from report.claim import Finding, JudgedPart, Shown
from report.document import Document

SCHEMA = 1


def to_json(document: Document) -> str:
    """Return all findings of the document, in thesis order, as indented JSON with a trailing newline."""
    content = {"schema": SCHEMA, "claims": [_claim(finding) for finding in document.findings]}
    return json.dumps(content, ensure_ascii=False, indent=2) + "\n"


def _claim(finding: Finding) -> dict[str, object]:
    return {
        "id": finding.id,
        "kind": finding.kind.value,
        "section": finding.section,
        "title": finding.title,
        "verdict": finding.verdict.value,
        "printed": _joined(finding.parts, [part.printed for part in finding.parts]),
        "derived": _joined(finding.parts, [part.derived for part in finding.parts]),
        "explanation": finding.explanation,
        "consequence": finding.consequence,
        "impact": finding.impact.value,
        "method": _joined(finding.parts, [part.method for part in finding.parts]),
        "slip": _joined(finding.parts, [part.slip for part in finding.parts]),
        "source": finding.source,
        "parts": [_part(part) for part in finding.parts],
    }


def _part(part: JudgedPart) -> dict[str, str]:
    return {
        "label": part.label,
        "verdict": part.verdict.value,
        "printed": str(part.printed),
        "derived": str(part.derived),
        "method": part.method,
        "slip": part.slip,
    }


def _joined(parts: tuple[JudgedPart, ...], texts: list[str] | list[Shown]) -> str:
    """Join what the parts say: once if all say the same, else each behind its label."""
    said = [str(text) for text in texts]
    if len(set(said)) == 1:
        return said[0]
    return "; ".join(f"{part.label}: {text}" for part, text in zip(parts, said, strict=True) if text)
