"""The chapter on the physical twin: its sections, with what the build computed again."""

from __future__ import annotations

from typing import Final

from report.document.figure import Figure
from report.document.twin import Observation, TwinChapter, TwinSection
from report.evidence import Evidence
from report.numbers.twin.kept_map import KeptMap
from report.numbers.twin_numbers import TwinNumbers
from report.parts import equal
from report.record import FigureRecord, text
from report.twin.cell_check import CellCheck, check_cells
from report.twin.observation import ObservationRecord, Observed
from report.twin.sections import branch, bridge, design, maps, measured, motion, open_questions, questions

TITLE: Final = "What play does in the real trimmer"
SECTIONS: Final = (
    bridge.SECTION,
    motion.SECTION,
    maps.SECTION,
    branch.SECTION,
    measured.SECTION,
    questions.SECTION,
    design.SECTION,
    open_questions.SECTION,
)


def twin_chapter(known: Evidence, seed: int) -> TwinChapter:
    """Return the chapter, after cells of its maps were computed again.

    Args:
        known: What was solved.
        seed: Of the cells that are drawn.

    Raises:
        CellDifferenceError: if a cell comes out differently.
        UnsupportedObservationError: if a check of an observation does not hold.
    """
    checked = _of_check(check_cells(maps_of(known.twin), seed)).observation(known)
    sections = [
        TwinSection(section.id, section.title, tuple(_finished(item, known) for item in section.items))
        for section in SECTIONS
    ]
    return TwinChapter(TITLE, tuple(_with(section, checked) for section in sections))


def maps_of(twin: TwinNumbers) -> list[KeptMap]:
    """Return all kept maps."""
    return [each.kept for each in (twin.friction, twin.speed, twin.stiffness, twin.damping, twin.starts)]


def _finished(item: ObservationRecord | FigureRecord, known: Evidence) -> Observation | Figure:
    return item.observation(known) if isinstance(item, ObservationRecord) else item.finished(known)


def _with(section: TwinSection, checked: Observation) -> TwinSection:
    """Put what was computed again at the end of the section on maps."""
    if section.id != maps.SECTION.id:
        return section
    return TwinSection(section.id, section.title, (*section.items, checked))


def _of_check(check: CellCheck) -> ObservationRecord:
    def items(_: Evidence) -> Observed:
        yield text("""
            The maps are kept with the code, with the hash of mechanism, places, values and settings. This
            build has drawn [[ drawn ]] of their [[ total ]] cells at random (seed [[ seed ]], which changes
            with the code and with the data) and computed them again: [[ same ]] came out as kept. Of these,
            [[ rounding ]] did so only from a start a nanometre beside rest.
        """).given(
            drawn=check.drawn,
            total=check.total,
            seed=check.seed,
            same=check.drawn - len(check.others),
            rounding=check.by_rounding,
        )
        if check.others:
            yield text("""
                Others came out as something else: [[ others ]]. Kept or now they do not repeat, and how a
                long transient ends depends on rounding.
            """).given(others="; ".join(check.others))
        yield equal(
            "kind, number of drive periods, stroke, accelerations, wear, impacts and second harmonic of each "
            "cell, to seven digits where the motion repeats, and its kind where it does not",
            len(check.cells) - len(check.others),
            check.drawn - len(check.others),
        )

    return ObservationRecord("twin-cells", "report/twin/cell_check.py", items, "Computed again.")
