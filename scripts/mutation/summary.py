"""What a run says: how many changes were noticed, by what, and how sure the share is."""

import csv
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

from scripts.mutation.exclusions import EXCLUDED
from scripts.mutation.mutants import Mutant
from scripts.mutation.records import Noticed, Outcome

EQUIVALENT = Path(__file__).with_name("equivalent.csv")
"""Mutants that change nothing that can be observed, each with the reason; found by reading them."""
LISTED = f"scripts/mutation/{EQUIVALENT.name}"
CONFIDENCE = 0.95
Judged = tuple[Mutant, Outcome]


@dataclass(frozen=True)
class Counts:
    """How many mutants were noticed.

    Attributes:
        drawn: How many were drawn and judged.
        equivalent: How many of them change nothing, by the list.
        claims: How many claims noticed, tests being asked or not.
        tests: How many only tests noticed, or tests first.
        nothing: How many nothing noticed, without those that change nothing.
        texts: How many of these would show in a report as another number or formula.
        interval: 95 % interval (Wilson) of the share that is noticed.
    """

    drawn: int
    equivalent: int
    claims: int
    tests: int
    nothing: int
    texts: int

    @property
    def noticed(self) -> int:
        """How many were noticed by a claim's verdict, a check or a test."""
        return self.claims + self.tests

    @property
    def share(self) -> float:
        """Share of those noticed among those that change something, 1 where there are none."""
        return self.noticed / (self.noticed + self.nothing) if self.noticed + self.nothing else 1.0

    @cached_property
    def interval(self) -> tuple[float, float]:
        """95 % interval of the share by Wilson's formula (Wilson 1927); from 0 to 1 where there are none."""
        from scipy.stats import binomtest

        total = self.noticed + self.nothing
        if not total:
            return 0.0, 1.0
        found = binomtest(self.noticed, total).proportion_ci(CONFIDENCE, method="wilson")
        return float(found.low), float(found.high)


def count(judged: Iterable[Judged], equivalent: frozenset[tuple[str, ...]]) -> Counts:
    """Count outcomes. A listed mutant counts as equivalent only if nothing has noticed it."""
    judged = list(judged)
    by = {each: [pair for pair in judged if pair[1].noticed is each] for each in Noticed}
    alike = [pair for pair in by[Noticed.NOTHING] if identity(pair[0]) in equivalent]
    missed = [pair for pair in by[Noticed.NOTHING] if pair not in alike]
    return Counts(
        drawn=len(judged),
        equivalent=len(alike),
        claims=len(by[Noticed.CLAIMS]),
        tests=len(by[Noticed.TESTS]),
        nothing=len(missed),
        texts=sum(bool(outcome.text) for _, outcome in missed),
    )


def identity(mutant: Mutant) -> tuple[str, ...]:
    """Return what names a mutant in the list, whatever else changes in its source."""
    return (mutant.path, mutant.function, mutant.context, one_line(mutant.before), one_line(mutant.after))


def read_equivalent(path: Path = EQUIVALENT) -> frozenset[tuple[str, ...]]:
    """Read the list of mutants that change nothing.

    Raises:
        ValueError: if one has no reason.
    """
    with path.open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    if lacking := [row["path"] for row in rows if not row["reason"]]:
        raise ValueError(f"{path.name}: no reason is given for a mutant of {lacking[0]}")
    return frozenset(
        (row["path"], row["function"], row["context"], row["before"], row["after"]) for row in rows
    )


def lines(judged: Sequence[Judged], equivalent: frozenset[tuple[str, ...]]) -> Iterator[str]:
    """Yield what the summary prints."""
    counts = count(judged, equivalent)
    low, high = counts.interval
    yield f"{counts.drawn} changes, {counts.equivalent} of them without an effect ({LISTED})"
    yield f"  {counts.claims:4} noticed by claims: another verdict, or a check or derivation that stops"
    yield f"  {counts.tests:4} noticed by tests"
    yield f"  {counts.nothing:4} noticed by neither; {counts.texts} of them change what the report shows"
    yield f"{counts.share:.1%} of those with an effect are noticed"
    yield f"95 % interval (Wilson): {low:.1%} to {high:.1%}"
    yield "Tests were asked first, and claims if they noticed nothing; for derivations the other way round."
    yield f"Processor time {sum(outcome.seconds for _, outcome in judged):.0f} s. Not drawn:"
    yield from (f"  - {each}" for each in EXCLUDED)
    yield from _table("package", judged, equivalent, lambda mutant: _package(mutant.path))
    yield from _table("kind", judged, equivalent, lambda mutant: mutant.kind.value)
    missed = [
        pair for pair in judged if pair[1].noticed is Noticed.NOTHING and identity(pair[0]) not in equivalent
    ]
    if missed:
        yield "Noticed by neither:"
        yield from (f"  {one_line(mutant)} ({outcome.files} test files)" for mutant, outcome in missed)


def _table(
    title: str, judged: Sequence[Judged], equivalent: frozenset[tuple[str, ...]], name: object
) -> Iterator[str]:
    assert callable(name)
    yield f"{title:28} drawn  claims  tests  neither"
    for each in sorted({name(mutant) for mutant, _ in judged}):
        counts = count([pair for pair in judged if name(pair[0]) == each], equivalent)
        yield f"{each:28} {counts.drawn:5}  {counts.claims:6}  {counts.tests:5}  {counts.nothing:7}"


def _package(path: str) -> str:
    parts = path.split("/")
    return "/".join(parts[: 2 if parts[0] == "trimmer" and len(parts) > 2 else 1])


def one_line(text: object) -> str:
    """Return a text without its line breaks."""
    return " ".join(str(text).split())
