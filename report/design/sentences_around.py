"""Sentences on what lies around the file's own point: maps, branches, margins, slopes.

They are plain text, or Markdown where the type says so.
"""

import numpy as np

from report.design.pictures import important
from report.design.quantities import percent, place_words, shown, written
from report.design.words.phrases import SPECIAL, capital, count, counted_in, measure_words
from report.design.words.sentences import places_listed
from report.pages.escaping import Markdown, markdown
from trimmer.branches.branch import BranchEnd
from trimmer.design.design import Design
from trimmer.design.parameter_studies.kept_map import DesignMap
from trimmer.design.parameter_studies.paths import NumberPath, PathSide
from trimmer.design.specification.targets import Measure
from trimmer.design.trials.sensitivity import Sensitivity
from trimmer.design.trials.trial import MeasureOfPart
from trimmer.maps.cell_motion import described
from trimmer.mechanism.parts import OutputKind
from trimmer.response.periodic.pace import period_word
from trimmer.response.results.response import MotionKind


def map_sentences(drawn: DesignMap, switched: bool, stepped: bool) -> str:
    """Say what a map shows around the working point, and what failed."""
    result = drawn.result
    own = f"In the cell nearest to the file’s own point the motion is {_cell_words(drawn)}."
    starts = "Each cell has the motion from the file’s start alone; other starts may lead to other motions."
    failed = len(result.failures)
    if stepped:
        told = "Each cell is one motion from the file’s start through its steps. What does not come is white."
        return told + (f" {capital(count(failed, 'cell'))} could not be followed." if failed else "")
    told = "Where a contact does not close its times are left white." if switched else f"{own} {starts}"
    return told + (
        f" {capital(count(failed, 'cell'))} could not be followed and are left white." if failed else ""
    )


def _cell_words(drawn: DesignMap) -> str:
    columns, rows = drawn.result.values
    column = int(np.argmin(abs(columns - drawn.first.value)))
    row = int(np.argmin(abs(rows - drawn.second.value)))
    motion = drawn.result.cells[row * len(columns) + column].motions[0]
    word = period_word(drawn.result.inputs.subject)
    return {
        MotionKind.TORUS: "one that beats and never quite repeats",
        MotionKind.REST: "rest, in which nothing moves",
        MotionKind.CHAOTIC: f"chaotic for all of the {counted_in(word, motion.periods)}",
        MotionKind.DIVERGING: "one that grows without bound",
        MotionKind.UNDECIDED: "not known, because the motion had not settled",
    }.get(motion.kind, f"of {described(motion)}")


def margin_sentences(design: Design) -> str:
    """Say which margin is the narrowest, and what ends each."""
    shares = [
        (side.reaches / path.varied.value - 1, path, side)
        for path in design.paths
        for side in (path.down, path.up)
        if side is not None and side.reaches is not None and path.varied.value
    ]
    if not shares and any(side.cut for path in design.paths for side in (path.down, path.up) if side):
        return "As far as it was followed the motion stays stable."
    if not shares:
        return "Within these ranges the motion stays stable."
    share, path, side = min(shares, key=lambda each: abs(each[0]))
    way = "a smaller" if share < 0 else "a larger"
    told = (
        f"The narrowest margin is towards {way} {place_words(path.varied.place)}: after "
        f"{percent(abs(share))} {_ended(side)}."
    )
    return told + " Beyond each value the mechanism takes another motion, which may still meet the targets."


def _ended(side: PathSide) -> str:
    if side.losing is not None:
        return SPECIAL[side.losing]
    if side.reason is BranchEnd.TORN:
        return "the motion jumps"
    if side.reason is BranchEnd.INFINITE_PERIOD:
        return "its period grows without bound"
    return "the motion becomes unstable, or could not be followed further"


def branch_sentences(path: NumberPath) -> str:
    """Say where each side of a branch ends, and why."""
    told = []
    for side, way, to in ((path.down, "smaller", "down"), (path.up, "larger", "up")):
        if side is None:
            continue
        reach = (
            "stays stable to the end of the range"
            if side.reaches is None and not side.cut
            else f"stays stable to {shown(float(side.values[-1]), path.varied.unit, 4)}"
            if side.reaches is None
            else (f"is stable {to} to {shown(side.reaches, path.varied.unit, 4)}, where {_ended(side)}")
        )
        solved = f"{count(len(side.values), 'orbit')} {'was' if len(side.values) == 1 else 'were'}"
        told.append(f"Towards {way} values it {reach}; {solved} solved.")
        if not side.reason.is_success:
            told.append(f"The branch ends before the range does: {side.reason.value}.")
    if path.varied.bounded:
        told.append("The range ends at the static force, which the kinetic one never exceeds.")
    return " ".join(told)


def first_changes(design: Design) -> Markdown:
    """Say for each important measure which number to change first, and in which direction."""
    found = design.sensitivities
    assert found is not None
    told = []
    for asked in important(design)[:4]:
        ranked = found.ranked(asked)
        if not ranked:
            continue
        # Where an impact or a phase of stick comes or goes nearby a slope says little: better the next one.
        entry = next((each for each in ranked if _is_smooth(each, asked)), ranked[0])
        size = entry.of(asked)
        assert size is not None
        wanted = _shall_rise(asked, design)
        way = "raise" if (size.value > 0) == wanted else "lower"
        effect = "raises" if wanted else "lowers"
        told.append(
            markdown(
                "- To {} the **{}**, {} the {}: one per cent {} it by {} %.",
                "raise" if wanted else "lower",
                measure_words(asked.measure, asked.part),
                *(way, place_words(entry.place), effect, written(abs(size.value), 2)),
            )
        )
    return Markdown("\n").join(told)


def _shall_rise(asked: MeasureOfPart, design: Design) -> bool:
    """Say whether more of a measure is better: as a target says, or of how far an output goes."""
    mine = (asked.measure, asked.part)
    bounds = [each for each in design.verdict.judged if (each.target.measure, each.target.part) == mine]
    if bounds:
        return min(bounds, key=lambda each: each.margin).target.at_least
    outputs = design.file.mechanism.outputs
    return asked.measure is Measure.STROKE and outputs[asked.part].kind is OutputKind.DISPLACEMENT


def _is_smooth(sensitivity: Sensitivity, asked: MeasureOfPart) -> bool:
    found = sensitivity.of(asked)
    return found is not None and found.smooth


def unsmooth(design: Design) -> str:
    """Name the slopes that half of the step does not confirm; empty if there are none."""
    found = design.sensitivities
    if found is None:
        return ""
    rough = [each.place for each in found.entries if any(not e.smooth for e in each.elasticities)]
    told = ""
    if rough:
        told += (
            f"For the {places_listed(rough)} the two differ by more than a tenth, because an impact or a "
            "phase of stick comes or goes nearby: these slopes say little."
        )
    if found.failed:
        told += f" For the {places_listed(found.failed)} no orbit was found beside this one."
    return told
