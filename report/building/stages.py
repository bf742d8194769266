"""The stages that make the report's content: derive, solve, judge, draw and assemble."""

from collections.abc import Mapping
from functools import cache, partial
from importlib.metadata import version
from itertools import chain
from typing import Any

from derivations.elements.narrative import element_narrative
from derivations.narrative import narrative
from report.building.assemble import Parts, assemble
from report.building.background import begun
from report.building.collect import Records, collect
from report.building.extras import EXTRAS
from report.building.progress import Progress
from report.building.tasks import BuildTask, done
from report.cache.libraries import libraries
from report.cache.source_closure import SourceTree
from report.cache.stage_store import StageStore
from report.data.figures import figure_words
from report.data.statements import read_inventory
from report.derivation.code_lines import with_lines
from report.derivation.number_steps import number_steps
from report.derivation.pictures import waveform_pictures
from report.document.document import Document
from report.folders import templates
from report.judging.claim import Statement
from report.judging.finding import Finding
from report.judging.judge import judge
from report.judging.record import ClaimRecord
from report.numbers.evidence import Evidence, derive, solve
from report.numbers.twin.kept_files import digest_of_files
from report.numbers.twin_numbers import solve_twin
from report.octave.contents import contents
from report.octave.listings import corrected_programs
from report.twin.cell_check import seed_of


def make_document(progress: Progress, store: StageStore) -> Document:
    """Derive, solve, judge and draw everything that the report shows.

    What was kept from the last build is taken where nothing that it depends on has changed: for the findings
    of a module and for a figure these are the sources that its module imports, directly or not.

    Raises:
        ClaimIdError: if a claim is not in the inventory or stands twice.
        ContradictionError: if two independent derivations disagree.
        UnprovenError: if an equation of the describing functions is not proven.
        FileWriteError: if a result cannot be kept.
    """
    inventory = read_inventory()
    tree = SourceTree.kept(store)
    evidence = _evidence(progress, store, tree)
    records = collect(inventory)
    results = done(_tasks(evidence, inventory, records, tree), store, progress)
    findings = _in_order([results[f"claims-{module}"] for module in records.claims], inventory)
    parts = Parts(
        findings=findings,
        figures=tuple(results[f"figure-{figure.id}"] for figure in records.figures),
        trimmer_steps=results["trimmer-steps"],
        element_steps=results["element-steps"],
        number_steps=results["number-steps"],
        pictures=results["waveforms"],
        programs=results["programs"],
        extras={extra.name: results[extra.name] for extra in EXTRAS},
    )
    return assemble(parts, evidence.numbers.parameters, inventory)


def _evidence(progress: Progress, store: StageStore, tree: SourceTree) -> Evidence:
    key = _key(tree, ["report.numbers.evidence"])
    kept: Evidence | None = store.load("evidence", key)
    if kept is not None:
        return kept
    with begun(solve_twin) as twin:
        (derived,) = progress.run("derive", [derive], lambda work: work())
        (evidence,) = progress.run("solve", [derived], partial(solve, twin=twin))
    store.keep("evidence", key, evidence)
    return evidence


def _tasks(
    evidence: Evidence, inventory: Mapping[str, Statement], records: Records, tree: SourceTree
) -> list[BuildTask]:
    """List what is made from the evidence; long tasks first, so that the processes end together.

    Proofs, then the figures of motion and the last sections take longest.
    """
    octave = [(path.name, path.read_text("utf-8")) for path in sorted((templates() / "octave").iterdir())]
    key = partial(_key, tree)
    print_programs = partial(corrected_programs, evidence.derivation, evidence.numbers.parameters)
    return [
        BuildTask(
            "element-steps",
            "prove",
            key(["derivations.elements.narrative"]),
            partial(with_lines, element_narrative),
        ),
        BuildTask(
            "trimmer-steps",
            "prove",
            key(["derivations.narrative", "report.numbers.evidence"]),
            partial(with_lines, narrative, evidence.derivation),
        ),
        *(
            BuildTask(extra.name, "extras", digest, partial(extra.make, evidence, seed_of(digest)))
            for extra in EXTRAS
            for digest in [key([extra.module, "report.numbers.evidence"], figure_words())]
        ),
        BuildTask(
            "number-steps",
            "prove",
            key(["report.derivation.number_steps"]),
            partial(with_lines, number_steps, evidence),
        ),
        BuildTask("waveforms", "draw", key(["report.derivation.pictures"]), waveform_pictures),
        BuildTask(
            "programs",
            "print",
            key(["report.octave.listings", "report.numbers.evidence"], octave, contents()),
            print_programs,
        ),
        *(
            BuildTask(
                f"figure-{figure.id}",
                "draw",
                key([figure.draw.__module__, "report.numbers.evidence"], figure.words),
                partial(figure.finished, evidence),
            )
            for figure in reversed(records.figures)
        ),
        *(
            BuildTask(
                f"claims-{module}",
                "judge",
                key([module, "report.numbers.evidence"], statements),
                partial(_judged, group, evidence, statements),
            )
            for module, group in reversed(tuple(records.claims.items()))
            for statements in [{record.id: inventory[record.id] for record in group}]
        ),
    ]


def _key(tree: SourceTree, modules: list[str], *others: Any) -> str:
    return tree.digest(modules, _versions(), *others)


@cache
def _versions() -> tuple[tuple[str, str], ...]:
    return (*libraries(), ("trimmer", version("trimmer")), ("kept data", digest_of_files()))


def _judged(
    records: tuple[ClaimRecord, ...], evidence: Evidence, inventory: Mapping[str, Statement]
) -> tuple[Finding, ...]:
    return tuple(judge(record.claim(evidence), inventory[record.id]) for record in records)


def _in_order(
    by_module: list[tuple[Finding, ...]], inventory: Mapping[str, Statement]
) -> tuple[Finding, ...]:
    place = {claim_id: index for index, claim_id in enumerate(inventory)}
    return tuple(sorted(chain.from_iterable(by_module), key=lambda finding: place[finding.id]))
