"""Findings as JSON, for machines."""

import json
from collections import Counter

from report.document.document import Document
from report.judging.finding import Finding, JudgedPart
from report.judging.items import Item, items
from report.judging.shown import Shown
from report.judging.verdict import Certainty, Severity, Verdict

SCHEMA = 2


def to_json(document: Document) -> str:
    """Return all findings of the document, in thesis order, as indented JSON with a trailing newline."""
    return claims_json(document.findings, document.text_copy.sha256)


def claims_json(findings: tuple[Finding, ...], sha256: str) -> str:
    """Return findings in the same way; the digest is that of the text copy that was judged."""
    content = {
        "schema": SCHEMA,
        "thesis": {"sha256": sha256},
        "items": _numbers(items(findings)),
        "claims": [_claim(finding) for finding in findings],
    }
    return json.dumps(content, ensure_ascii=False, indent=2) + "\n"


def _numbers(judged: tuple[Item, ...]) -> dict[str, object]:
    verdicts = Counter(item.verdict for item in judged)
    severities = Counter(item.severity for item in judged)
    return {
        "total": len(judged),
        "verdicts": {verdict.value: verdicts[verdict] for verdict in Verdict},
        "severities": {severity.value: severities[severity] for severity in Severity},
    }


def _claim(finding: Finding) -> dict[str, object]:
    return {
        "id": finding.id,
        "kind": finding.kind.value,
        "section": finding.section,
        "title": finding.title,
        "lines": list(finding.lines) if finding.lines else None,
        "paragraph": finding.paragraph,
        "verdict": finding.verdict.value,
        "severity": finding.severity.value,
        "certainty": _value(finding.certainty),
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


def _part(part: JudgedPart) -> dict[str, object]:
    return {
        "label": part.label,
        "item": part.item,
        "verdict": part.verdict.value,
        "severity": part.severity.value,
        "certainty": _value(part.certainty),
        "printed": str(part.printed),
        "derived": str(part.derived),
        "method": part.method,
        "slip": part.slip,
        "decided_by": part.decided_by,
    }


def _value(certainty: Certainty | None) -> str | None:
    return certainty.value if certainty else None


def _joined(parts: tuple[JudgedPart, ...], texts: list[str] | list[Shown]) -> str:
    """Join what the parts say: once if all say the same, else each behind its label."""
    said = [str(text) for text in texts]
    if len(set(said)) == 1:
        return said[0]
    return "; ".join(f"{part.label}: {text}" for part, text in zip(parts, said, strict=True) if text)
