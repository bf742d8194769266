"""Judging a mutant: by tests and by claims, until one of them notices it."""

from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from dataclasses import dataclass, replace

from scripts.mutation.child import End, Ended, Place, run
from scripts.mutation.choice import batches, chosen, compiled_sources
from scripts.mutation.claims import Difference, Judged, compare, judge_all
from scripts.mutation.line_map import LineMap
from scripts.mutation.mutants import Mutant
from scripts.mutation.patching import Patch, patch_of, with_patch
from scripts.mutation.records import Noticed, Outcome
from scripts.mutation.tested import failure, failures
from scripts.mutation.tree import Tree

CLAIMS_LIMIT = 240.0
"""Processor time, s, for all claims."""
COMPILING = 120.0
"""Further processor time, s, where code has to be compiled."""


class _NotLoadedError(Exception):
    """The function is not loaded, or cannot be given other code."""


@dataclass(frozen=True)
class Judge:
    """Judges mutants in one copy of the project."""

    tree: Tree  # The copy
    loaded: Tree  # The copy that is loaded already, in which nothing is changed but what is loaded
    lines: LineMap  # Which test file runs which line
    known: Sequence[Judged]  # What claims the unaltered project gives
    both: bool = False  # Whether tests and claims are asked even if the first of them has noticed a mutant
    every: bool = False  # Whether all tests are asked even if one has noticed it

    def outcome(self, mutant: Mutant) -> Outcome:
        """Change a function that is loaded, or else the source; ask tests and claims; change it back."""
        compiled = mutant.path in compiled_sources(self.tree.root)
        patch = None if compiled else patch_of(mutant, (self.tree.root / mutant.path).read_bytes())
        printed = self.tree.root.with_name("printed.txt")
        if patch is not None:
            with suppress(_NotLoadedError):
                return self._asked(mutant, Place(self.loaded.root, self.loaded.numba, printed, True), patch)
        with self.tree.changed(mutant, compiled) as numba:
            return self._asked(mutant, Place(self.tree.root, numba, printed), None)

    def _asked(self, mutant: Mutant, place: Place, patch: Patch | None) -> Outcome:
        """Ask claims first for the derivations, which they rest on, tests for the rest."""
        ways = [self._ask_tests, self._ask_claims]
        if mutant.path.startswith("derivations/"):
            ways.reverse()
        outcome = Outcome()
        for ask in ways:
            outcome = ask(mutant, place, patch, outcome)
            if outcome.noticed is not Noticed.NOTHING and not self.both:
                break
        return outcome

    def _ask_tests(self, mutant: Mutant, place: Place, patch: Patch | None, before: Outcome) -> Outcome:
        files = chosen(mutant, self.lines, self.tree.root)
        compiling = self._compiling(place)
        seconds, failed = before.seconds, list[str]()
        for group in batches(files):
            limit = 20.0 + 4.0 * sum(file.seconds for file in group) + compiling
            ask = failures if self.every else failure
            ended = run(with_patch, (patch, ask, [file.path for file in group]), place, limit)
            seconds += ended.seconds
            fault = _fault(ended)
            failed += [fault] if fault else ended.value if self.every else filter(None, [ended.value])
            if failed and not self.every:
                break
        every = tuple(failed) if self.every else ()
        return replace(before, tests="".join(failed[:1]), files=len(files), seconds=seconds, every=every)

    def _ask_claims(self, mutant: Mutant, place: Place, patch: Patch | None, before: Outcome) -> Outcome:
        limit = CLAIMS_LIMIT + self._compiling(place)
        ended = run(with_patch, (patch, compare, mutant.path, self.known), place, limit)
        seconds = before.seconds + ended.seconds
        if fault := _fault(ended):
            return replace(before, claims=fault, seconds=seconds)
        found: Difference = ended.value
        return replace(before, claims=found.check, text=found.text, seconds=seconds)

    def _compiling(self, place: Place) -> float:
        return 0.0 if place.numba in (self.tree.numba, self.loaded.numba) else COMPILING


def unaltered(trees: Sequence[Tree]) -> list[Judged]:
    """Judge the claims of the unaltered project in each copy; leave out texts that are not the same in all.

    Raises:
        RuntimeError: if something stops, or if a verdict is not the same.
    """
    with ThreadPoolExecutor(len(trees)) as pool:
        runs = list(pool.map(_judged, trees))
    same = []
    for groups in zip(*runs, strict=True):
        first = groups[0]
        if any(each.stopped or each.verdicts != first.verdicts for each in groups):
            raise RuntimeError(f"{first.name}: not the same in two runs, or stopped: {first.stopped}")
        texts = {
            claim: text
            for claim, text in first.texts.items()
            if all(each.texts[claim] == text for each in groups)
        }
        same.append(replace(first, texts=texts))
    return same


def _judged(tree: Tree) -> list[Judged]:
    place = Place(tree.root, tree.numba, tree.root.with_name("printed.txt"))
    ended = run(judge_all, (), place, CLAIMS_LIMIT + COMPILING)
    if ended.end is not End.DONE:
        raise RuntimeError(
            f"the claims of the unaltered project were not judged: {ended.value}\n{ended.printed}"
        )
    groups: list[Judged] = ended.value
    return groups


def _fault(ended: Ended) -> str:
    if ended.end is End.DONE and ended.value is None:
        raise _NotLoadedError
    return "" if ended.end is End.DONE else f"{ended.end.value}: {ended.value}"
