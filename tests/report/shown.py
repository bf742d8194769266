"""Numbers and formulas that a report shows, in files that are read in a diff when they change.

``python -m tests.report.shown`` writes the files anew. Of prose only the numbers are kept, so that words may
change; what the thesis prints is left out.
"""

import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import fields, is_dataclass
from pathlib import Path
from typing import Any

from report.data.statements import read_inventory
from report.derivation.number_steps import number_steps
from report.future_work.chapter import SECTIONS as FUTURE_WORK
from report.judging.finding import Finding
from report.judging.judge import judge
from report.numbers.evidence import Evidence, gather
from report.overview.page import overview
from report.twin.chapter import SECTIONS
from report.twin.observation import ObservationRecord, SectionRecord

FOLDER = Path(__file__).with_name("shown_numbers")
NUMBER = re.compile(r"(?<![\w.])-?\d+(?:\.\d+)?(?:e[-+]?\d+)?")
WHOLE = {"latex", "digits", "unit", "largest", "holds", "symbols"}
"""Fields that are kept with their words: formulas, and what stands in a cell by itself."""
LEFT_OUT = {
    *("id", "title", "label", "item", "section", "lines", "paragraph", "source", "code", "svg"),
    *("printed", "thesis", "question", "claim", "claims", "quantity", "caption", "alternative_text"),
}
"""Fields that say what something is and where it stands, and what the thesis prints."""


def told(thing: Any, name: str = "") -> Iterator[str]:
    """Yield a line for each field, at any depth, that shows a number or a formula."""
    if is_dataclass(thing):
        for field in fields(thing):
            if field.name not in LEFT_OUT:
                yield from told(getattr(thing, field.name), field.name)
    elif isinstance(thing, str):
        shown = thing if name in WHOLE else " ".join(NUMBER.findall(thing))
        if shown:
            yield f"{name}: {' '.join(shown.split())}"
    elif isinstance(thing, Mapping | Iterable):
        for each in thing.values() if isinstance(thing, Mapping) else thing:
            yield from told(each, name)


def headed(things: Mapping[str, Any]) -> str:
    """Return what things show, each below its name; those that show nothing are left out."""
    return "".join(
        f"# {name}\n{chr(10).join(lines)}\n" for name, thing in things.items() if (lines := [*told(thing)])
    )


def texts(known: Evidence, findings: Mapping[str, Finding]) -> Mapping[str, str]:
    """Return the contents of the files by their names: findings by chapter, first pages, and so on."""
    steps = {step.id: step for step in number_steps(known)}
    first = overview(known)
    pages = {
        "opening": first.opening,
        **{f"answer {number}": each for number, each in enumerate(first.answers, start=1)},
        **{f"{row.claim}, {row.quantity}": row for row in first.corrected},
    }
    chapters = {
        f"findings-{chapter}": headed({n: each for n, each in findings.items() if each.section[0] == chapter})
        for chapter in sorted({each.section[0] for each in findings.values()})
    }
    others = {"steps": headed(steps), "overview": headed(pages), "twin": observed(SECTIONS, known)}
    others["future-work"] = observed(FUTURE_WORK, known)
    return {**chapters, **others, "items": items_of(findings), "second-ways": ways_of(findings)}


def observed(sections: Iterable[SectionRecord], known: Evidence) -> str:
    """Return the texts of the observations in sections."""
    records = (each for section in sections for each in section.items)
    return headed({each.id: each.finished(known) for each in records if isinstance(each, ObservationRecord)})


def items_of(findings: Mapping[str, Finding]) -> str:
    """Return which claims judge each printed thing that has a name: parts of one name count once."""
    judging: dict[str, dict[str, None]] = {}
    for name, finding in findings.items():
        for part in finding.parts:
            if not f"{part.item}, ".startswith(f"{name}, "):
                judging.setdefault(part.item, {})[name] = None
    return "".join(f"# {item}\n{', '.join(claims)}\n" for item, claims in sorted(judging.items()))


def ways_of(findings: Mapping[str, Finding]) -> str:
    """Return by what each part is confirmed, in words: a part must not have the second way of another."""
    ways = {
        name: [part.method.partition("; confirmed by ")[2] or "-" for part in finding.parts]
        for name, finding in findings.items()
    }
    return "".join(f"# {name}\n{chr(10).join(each)}\n" for name, each in ways.items())


def _renew() -> None:
    from report.building.collect import collect

    known, inventory = gather(), read_inventory()
    records = collect(inventory).by_id
    findings = {name: judge(records[name].claim(known), entry) for name, entry in inventory.items()}
    for name, text in texts(known, findings).items():
        (FOLDER / f"{name}.txt").write_text(text, "utf-8")


if __name__ == "__main__":
    _renew()
