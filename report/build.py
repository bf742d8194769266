"""Building the report in stages, with a progress bar for each and a log of their times."""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import TypeVar, final

from tqdm import tqdm

from report.assemble import assemble
from report.claim import Finding, judge
from report.claims.all_claims import all_claims
from report.evidence import derive, solve
from report.figures.all_figures import DRAWINGS
from report.inventory import read_inventory
from report.rendering.render import RenderedFiles, render
from trimmer.files import write_whole

Item = TypeVar("Item")
Result = TypeVar("Result")
BAR = "{desc:<8}{percentage:3.0f}% |{bar:30}| {n_fmt}/{total_fmt} {elapsed}"


@dataclass(frozen=True)
class Built:
    """Result of a build: the files, the log of the stages' times, the findings, and the time it took, s."""

    files: RenderedFiles
    log: Path
    findings: tuple[Finding, ...]
    seconds: float


@final
@dataclass
class _Stages:
    """Runs the stages of a build one after the other and keeps their times, s."""

    times: list[tuple[str, float]] = field(default_factory=list)

    def run(self, name: str, items: Sequence[Item], work: Callable[[Item], Result]) -> tuple[Result, ...]:
        """Do the work for each item, behind a progress bar, and return the results in order."""
        started = time.perf_counter()
        results = tuple(work(item) for item in tqdm(items, desc=name, bar_format=BAR))
        self.times.append((name, time.perf_counter() - started))
        return results

    def log(self) -> str:
        """Return one line for each stage and one for the sum."""
        rows = [*self.times, ("sum", sum(seconds for _, seconds in self.times))]
        return "".join(f"{name:<8}{seconds:7.2f} s\n" for name, seconds in rows)


def build(directory: Path) -> Built:
    """Derive, solve, judge, draw and render, and write the report into a folder.

    Nothing is written before everything has been made, so a failure leaves the previous report whole.

    Raises:
        ClaimIdError: if a claim is not in the inventory or stands twice.
        ContradictionError: if two independent derivations disagree.
        FileWriteError: if a file cannot be written.
    """
    started = time.perf_counter()
    stages = _Stages()
    inventory = read_inventory()
    (derived,) = stages.run("derive", [derive], lambda work: work())
    (evidence,) = stages.run("solve", [derived], solve)
    (claims,) = stages.run("claim", [evidence], lambda known: all_claims(known, inventory))
    findings = stages.run("judge", claims, lambda claim: judge(claim, inventory[claim.id]))
    figures = stages.run("draw", DRAWINGS, lambda drawing: drawing.finished(evidence))
    (document,) = stages.run("assemble", [evidence], lambda known: assemble(known, findings, figures, inventory))
    (files,) = stages.run("render", [document], lambda finished: render(finished, directory))
    write_whole(directory / "build.log", stages.log())
    return Built(files, directory / "build.log", findings, time.perf_counter() - started)
