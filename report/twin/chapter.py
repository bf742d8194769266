"""The chapter on the physical twin: its sections, with what the build computed again."""

from typing import Final

from report.document.extras import Observation, TwinChapter, TwinSection
from report.judging.parts import so
from report.judging.record import text
from report.numbers.evidence import Evidence
from report.numbers.twin.kept_map import KeptMap
from report.numbers.twin_numbers import TwinNumbers
from report.twin.cell_check import MOST_OTHER, CellCheck, check_cells
from report.twin.observation import ObservationRecord, Observed
from report.twin.sections import (
    branch,
    bridge,
    design,
    loop,
    maps,
    measured,
    motion,
    open_questions,
    questions,
)

TITLE: Final = "What play does in the real trimmer"
SECTIONS: Final = (
    bridge.SECTION,
    motion.SECTION,
    maps.SECTION,
    branch.SECTION,
    loop.SECTION,
    measured.SECTION,
    questions.SECTION,
    design.SECTION,
    open_questions.SECTION,
)
ELSEWHERE: Final = (loop.SECTION, questions.SECTION, design.SECTION)
"""What the report shows before or after the chapter."""


def twin_chapter(known: Evidence, seed: int) -> TwinChapter:
    """Return the chapter, after cells of its maps, drawn by a seed, were computed again.

    Raises:
        CellDifferenceError: if a cell comes out differently.
        UnsupportedObservationError: if a check of an observation does not hold.
    """
    checked = of_check(check_cells(maps_of(known.twin), seed)).finished(known)
    return TwinChapter(
        TITLE,
        tuple(_with(section.finished(known), checked) for section in SECTIONS if section not in ELSEWHERE),
        advice=design.SECTION.finished(known),
        loop=loop.SECTION.finished(known),
        questions=questions.SECTION.finished(known),
    )


def maps_of(twin: TwinNumbers) -> list[KeptMap]:
    """Return all kept maps."""
    return [each.kept for each in (twin.friction, twin.speed, twin.stiffness, twin.damping, twin.starts)]


def _with(section: TwinSection, checked: Observation) -> TwinSection:
    """Put what was computed again at the end of the section on maps."""
    if section.id != maps.SECTION.id:
        return section
    return TwinSection(section.id, section.title, (*section.items, checked))


def of_check(check: CellCheck) -> ObservationRecord:
    """Return the observation that says which cells were computed again, and how they came out."""

    def items(_: Evidence) -> Observed:
        by_rounding = f", {check.by_rounding} of them only from a start a nanometre beside rest"
        others = f"""

            These did not: {"; ".join(check.others)}. There the kept motion or the new one does not repeat,
            and how a long transient ends depends on rounding.
        """
        yield text(f"""
            The maps are kept with the code, with the hash of mechanism, places, values and settings. This
            build has drawn {check.drawn} of their {check.total} cells at random (seed {check.seed}, which
            changes with the code and with the data) and computed them again:
            {check.drawn - len(check.others)} came out as kept{by_rounding if check.by_rounding else ""}.
            {others if check.others else ""}
        """)
        yield so(
            "kind, number of drive periods, stroke, accelerations, wear, impacts and second harmonic of each "
            "cell, to seven digits where the motion repeats, and its kind where it does not",
            len(check.others) <= MOST_OTHER,
        )

    return ObservationRecord("twin-cells", "report/twin/cell_check.py", items, "Computed again.")
