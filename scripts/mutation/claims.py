"""What goes on in the process that judges the claims: they are judged without being shown, and compared.

Beside the claims these are all things of a report whose checks can stop its build: the proofs of the
derivation, and the extra chapters with their figures. Other figures and pages are left out.
"""

import hashlib
import re
import time
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import cached_property, partial
from typing import Any

SEED = 1
"""Of the cells of the kept maps that are computed again: the same in each run."""
ADDRESS = re.compile(r" at 0x[0-9a-f]+")
PARTS: Mapping[str, tuple[str, ...]] = {
    "derivation": ("derivations.linear_trimmer",),
    "general": ("derivations.algebra.laplace",),
    "transformed": ("derivations.algebra.laplace",),
    "numbers": ("derivations.linear_trimmer", "report.numbers.linear_numbers"),
    "cycles": ("derivations.linear_trimmer", "report.numbers.limit_cycle_numbers"),
    "motion": ("derivations.linear_trimmer", "report.numbers.motion_numbers"),
    "orbits": ("derivations.linear_trimmer", "report.numbers.motion_numbers"),
    "twin": ("report.numbers.twin_numbers",),
}
"""The modules that each part of the evidence rests on, with all that they import."""
EVIDENCE = "report/numbers/evidence.py"
DEAR = ("motion", "orbits", "twin")


@dataclass(frozen=True)
class Judged:
    """A group of claims, or another thing that is checked."""

    name: str  # Of the module of the claims, or of the function
    # By claim, the verdicts of its parts; empty for what only passes or stops
    verdicts: Mapping[str, str] = field(default_factory=dict)
    # By claim, a digest of what is shown: derived numbers and formulas, explanation
    texts: Mapping[str, str] = field(default_factory=dict)
    needs: tuple[str, ...] = ()  # Parts of the evidence that it asked for
    seconds: float = 0.0  # Processor time, s
    stopped: str = ""  # The error that stopped it, empty if none did


@dataclass(frozen=True)
class Difference:
    """The first difference from the unaltered project."""

    check: str  # A verdict that differs or a check that stopped, in words; empty if there is none
    text: str  # The first claim that shows something else with the same verdict, empty if there is none
    judged: int  # How many groups were judged


def judge_all() -> list[Judged]:
    """Judge everything and return it, what needs little first."""
    return list(_judged(None))


def compare(path: str, known: Iterable[Judged]) -> Difference:
    """Judge what a changed source can have an effect on, until a check differs.

    Args:
        path: The source that was changed.
        known: What the unaltered project gives, ``judge_all``.
    """
    expected = {each.name: each for each in known}
    text, count = "", 0
    for found in _judged(_touched(path, expected)):
        count += 1
        before = expected[found.name]
        if found.stopped:
            return Difference(f"{found.name}: {found.stopped}", text, count)
        for claim, verdict in found.verdicts.items():
            if verdict != before.verdicts[claim]:
                return Difference(f"{claim}: {before.verdicts[claim]} became {verdict}", text, count)
        changed = (name for name, shown in found.texts.items() if shown != before.texts.get(name, shown))
        text = text or next(changed, "")
    return Difference("", text, count)


def _touched(path: str, expected: Mapping[str, Judged]) -> list[Judged]:
    """Return what a source can have an effect on: cheap things first."""
    from report.cache.source_closure import SourceTree

    # Claims import the evidence for its type; what they ask of it is known.
    tree = SourceTree({name: each for name, each in SourceTree.read().sources.items() if name != EVIDENCE})
    closures = {part: frozenset().union(*map(tree.closure, modules)) for part, modules in PARTS.items()}
    touched = [
        each
        for each in expected.values()
        if path in tree.closure(each.name.partition(":")[0])
        or any(path in closures[part] for part in each.needs)
    ]
    return sorted(touched, key=lambda each: (any(part in DEAR for part in each.needs), each.seconds))


def _judged(wanted: list[Judged] | None) -> Iterator[Judged]:
    evidence = LazyEvidence()
    try:
        work = dict(_works(evidence))
    except Exception as error:  # whatever a mutant does
        yield _stopped("load", error)
        return
    for name in work if wanted is None else [each.name for each in wanted]:
        evidence.asked.clear()
        started = time.process_time()
        try:
            verdicts, texts = work[name]()
        except Exception as error:
            yield _stopped(name, error)
            continue
        yield Judged(name, verdicts, texts, tuple(sorted(evidence.asked)), time.process_time() - started)


def _stopped(name: str, error: Exception) -> Judged:
    return Judged(name, stopped=f"{type(error).__name__}: {error}"[:300])


Work = Callable[[], tuple[dict[str, str], dict[str, str]]]


def _works(evidence: Any) -> Iterator[tuple[str, Work]]:
    """Yield what is judged, by the module that does it."""
    from derivations.elements.narrative import element_narrative
    from derivations.narrative import narrative
    from report.building.collect import collect
    from report.building.extras import EXTRAS
    from report.data.statements import read_inventory
    from report.derivation.number_steps import number_steps

    inventory = read_inventory()
    for module, records in collect(inventory).claims.items():
        yield module, partial(_claims, records, evidence, inventory)
    others: dict[str, Callable[[], Any]] = {
        "derivations.elements.narrative": element_narrative,
        "derivations.narrative": lambda: narrative(evidence.derivation),
        "report.derivation.number_steps": lambda: number_steps(evidence),
        **{extra.module: partial(extra.make, evidence, SEED) for extra in EXTRAS},
    }
    for name, make in others.items():
        yield name, partial(_other, name, make)


def _claims(records: Iterable[Any], evidence: Any, inventory: Any) -> tuple[dict[str, str], dict[str, str]]:
    from report.judging.judge import judge

    findings = [judge(record.claim(evidence), inventory[record.id]) for record in records]
    verdicts = {each.id: ", ".join(part.verdict.value for part in each.parts) for each in findings}
    shown = {
        each.id: (each.explanation, each.consequence, [(part.derived, part.slip) for part in each.parts])
        for each in findings
    }
    return verdicts, {claim: _digest(text) for claim, text in shown.items()}


def _other(name: str, make: Callable[[], Any]) -> tuple[dict[str, str], dict[str, str]]:
    return {}, {name: _digest(make())}


def _digest(shown: object) -> str:
    return hashlib.sha256(ADDRESS.sub("", repr(shown)).encode()).hexdigest()[:16]


class LazyEvidence:
    """What ``report.numbers.evidence.Evidence`` holds, each part solved when it is first asked for."""

    def __init__(self) -> None:
        self.asked: set[str] = set()

    def __getattribute__(self, name: str) -> Any:
        if name in PARTS:
            object.__getattribute__(self, "asked").add(name)
        return object.__getattribute__(self, name)

    @cached_property
    def derivation(self) -> Any:
        """The linear trimmer."""
        from derivations.linear_trimmer import derive_linear_trimmer

        return derive_linear_trimmer()

    @cached_property
    def general(self) -> Any:
        """A general system."""
        from derivations.algebra.laplace import general_system

        return general_system()

    @cached_property
    def transformed(self) -> Any:
        """The general system in the Laplace domain."""
        from derivations.algebra.laplace import transform

        return transform(self.general)

    @cached_property
    def numbers(self) -> Any:
        """The thesis's trimmer."""
        from report.numbers.linear_numbers import solve_linear
        from trimmer import TrimmerParameters

        return solve_linear(self.derivation, TrimmerParameters.thesis())

    @cached_property
    def cycles(self) -> Any:
        """Its predicted limit cycles."""
        from report.numbers.limit_cycle_numbers import solve_limit_cycles

        return solve_limit_cycles(self.numbers)

    @cached_property
    def motion(self) -> Any:
        """Its motion."""
        from report.numbers.motion_numbers import solve_motion

        return solve_motion(self.numbers, self.cycles)

    @cached_property
    def orbits(self) -> Any:
        """Its exact orbits."""
        return self.motion.closed.orbits

    @cached_property
    def twin(self) -> Any:
        """The physical twin."""
        from report.numbers.twin_numbers import solve_twin

        return solve_twin()
