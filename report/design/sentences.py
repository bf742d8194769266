"""Sentences of the report that depend on what was found, as Markdown."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from report.design.pictures import important
from report.design.quantities import percent, place_words, shown, written
from report.design.words import SPECIAL, capital, count, kind_words, measure_words
from report.rendering.escaping import plain
from trimmer.branches.branch import BranchEnd
from trimmer.design.plausible import Oddity
from trimmer.design.targets import Measure
from trimmer.maps.cells import described
from trimmer.messages import listed
from trimmer.response.response import MotionKind

if TYPE_CHECKING:
    from collections.abc import Iterable

    from trimmer.design.design import Design
    from trimmer.design.kept_map import DesignMap
    from trimmer.design.paths import NumberPath, Side
    from trimmer.design.plausible import Question
    from trimmer.design.spectrum import OutputSpectrum


def places_listed(places: Iterable[str]) -> str:
    """Return places in words, as a list."""
    return listed([plain(place_words(each)) for each in places])


def question_words(question: Question, design: Design) -> str:
    """Ask about a number: where it stands, what it is, and why it is asked about."""
    line = design.file.line(question.place)
    where = f"line {line}, `{question.place_text}`" if line else f"`{question.place_text}`"
    unit = dict(design.file.mechanism.places).get(question.place_text, "")
    value, beside = (plain(shown(each, unit)) for each in (question.value, question.beside))
    depth, stroke = (plain(shown(each, "m")) for each in (question.value, question.beside))
    why = {
        Oddity.HEAVY_BODY: f"{value} is far from the other bodies; the middle one has {beside}. "
        "Grams for kilograms?",
        Oddity.HEAVY_FOR_HAND: f"{value} is much in a machine whose other bodies are light. "
        "Grams for kilograms?",
        Oddity.LONG_STROKE: f"an amplitude of {value} is long for such a machine; the stroke is twice that. "
        "Millimetres for metres?",
        Oddity.GAP_ABOVE_STROKE: f"a gap of {value} is not less than the stroke of the pins, {beside}: "
        "the parts may never meet. Micrometres for millimetres?",
        Oddity.SLOW_OR_FAST: f"{value} is an unusual speed for such a machine. It is in Hz; for turns per "
        'minute write "6600 rpm".',
        Oddity.SOFT_CONTACT: f"the contact gives way by {depth} where the stroke is {stroke}. "
        "Is the stiffness right?",
        Oddity.FRICTION_HOLDS: f"with {value} this friction never slides. Is it meant to hold?",
    }[question.oddity]
    return f"{capital(where)}: {why}"


def inventory(design: Design) -> str:
    """Return what the mechanism is made of, in a sentence or two."""
    mechanism = design.file.mechanism
    live = [each for each in mechanism.frictions.values() if each.force or each.viscous]
    counted = [
        (len(mechanism.bodies), "body", "bodies"),
        (len(mechanism.pins), "pin", "pins"),
        (len(mechanism.links), "spring or damper", "springs and dampers"),
        (len(mechanism.plays), "play", "plays"),
        (len(mechanism.stops), "stop", "stops"),
        (len(live), "friction", "frictions"),
        (len(mechanism.forces), "force", "forces"),
    ]
    there = [count(number, one).replace(one + "s", many) for number, one, many in counted if number]
    lacking = [
        many for number, _, many in counted if not number and many in ("plays", "stops", "frictions", "pins")
    ]
    drive = (
        f"It is driven at {plain(shown(mechanism.frequency, 'Hz', 5))}."
        if mechanism.frequency is not None
        else "It has no drive: it moves by itself, or not at all."
    )
    none = f" There are no {listed(lacking, 'or')}." if lacking else ""
    return f"All of it moves along one line: {listed(there)}. {drive}{none}"


def settled_sentences(design: Design) -> str:
    """Say what the first start settles to."""
    motion, motions = design.motion, design.motions
    assert motion is not None
    begun = "its own start" if design.file.mechanism.start else "rest"
    drive = design.file.mechanism.frequency
    if not motion.repeats:
        exponent = motion.lyapunov
        grown = (
            f" Small distances grow by the factor {plain(written(float(np.exp(exponent.value)), 3))} per "
            f"drive period."
            if exponent is not None and motion.kind is MotionKind.CHAOTIC
            else ""
        )
        return (
            f"From {begun}, the mechanism comes to {kind_words(motion)}; it was followed for "
            f"{motion.drive_periods} drive periods.{grown} Its measures are taken over "
            f"{motion.measured_periods} "
            "drive periods, so the last digits depend on which."
        )
    if drive is None:
        period = plain(shown(motion.period or 0.0, "s", 5))
        return f"From {begun}, the mechanism comes to a motion of its own that repeats after {period}."
    told = (
        f"From {begun}, the mechanism settles within {count(motion.drive_periods, 'drive period')} to "
        f"{kind_words(motion)}. It is an exact orbit, {_steadiness(design)}. "
        f"{capital(count_of(motion.events, 'event'))} happen in a drive period: contacts made or broken, "
        f"slips "
        "reversed, stick begun or ended."
    )
    if motions.message and motion.neighbour_agrees is False:
        told += " A neighbouring start does something else."
    return told


def count_of(number: float, noun: str) -> str:
    """Return a number that need not be whole with what it counts."""
    return count(int(number), noun) if float(number).is_integer() else f"{written(number, 3)} {noun}s"


def _steadiness(design: Design) -> str:
    motion = design.motion
    assert motion is not None
    if not motion.multipliers.size:
        return "and nothing disturbs it for longer than a moment"
    largest = float(abs(motion.multipliers).max())
    if motion.neutral:
        return "of which a shift stays as it is: friction or the lack of a spring holds no place"
    if largest < 1e-6:
        return "to which disturbances return within a period"
    return f"to which a small disturbance returns by the factor {plain(written(largest, 3))} in each period"


def searched_sentences(design: Design) -> str:
    """Say where other motions were looked for, and where not."""
    motions = design.motions
    if design.file.mechanism.frequency is None:
        return "One start was followed. Without a drive, other motions were not looked for."
    told = (
        f"{capital(count(motions.starts, 'start'))} were followed: the first as the file has it, the "
        f"others random, up to "
        f"the displacements and speeds of the first motion (seed {motions.seed})."
    )
    near = motions.neighbours
    if near is not None:
        names = listed([plain(place_words(each)) for each in near.places])
        end = (
            "until nothing new came" if near.complete else "and the search was ended before nothing new came"
        )
        told += (
            f" {capital(count(near.cells, 'neighbour'))} with another {names} (up to "
            f"±{percent(near.reach)}) were followed "
            f"as well, and {near.tried} of their orbits were handed on as starts, {end}; "
            f"{count(near.found, 'motion')} came from there alone."
        )
    if motions.lost:
        told += f" {capital(count(motions.lost, 'motion'))} could not be followed to an end."
    return told + " A motion that none of these leads to was not looked for."


def spectrum_sentences(spectrum: OutputSpectrum, design: Design) -> str:
    """Say what the table of lines leaves out."""
    share = plain(percent(spectrum.share, 4))
    floor = plain(shown(spectrum.floor, "m", 2))
    motion = design.motion
    told = f"These lines hold {share} of the mean square of {plain(spectrum.output)}."
    if motion is not None and not motion.repeats:
        return told + " The motion does not repeat, so the rest is spread between the lines."
    if spectrum.left_out:
        more = capital(count(spectrum.left_out, "further line"))
        told += (
            f" {more} up to the twentieth harmonic {'is' if spectrum.left_out == 1 else 'are'} below {floor}."
        )
    return told + " Harmonics above the twentieth were not computed."


def map_sentences(drawn: DesignMap) -> str:
    """Say what a map shows around the working point, and what failed."""
    result = drawn.result
    own = f"In the cell of the file, or the nearest one, the motion is {_cell_words(drawn)}."
    starts = "Each cell was followed from the file's start alone, so other motions may exist in it."
    failed = len(result.failures)
    told = f"{own} {starts}"
    return told + (
        f" {capital(count(failed, 'cell'))} could not be followed and are left white." if failed else ""
    )


def _cell_words(drawn: DesignMap) -> str:
    columns, rows = drawn.result.values
    column = int(np.argmin(abs(columns - drawn.first.value)))
    row = int(np.argmin(abs(rows - drawn.second.value)))
    motion = drawn.result.cells[row * len(columns) + column].motions[0]
    return {
        MotionKind.TORUS: "on a torus",
        MotionKind.CHAOTIC: "chaotic",
        MotionKind.UNDECIDED: "not known, because the motion had not settled",
    }.get(motion.kind, f"of {described(motion)}")


def no_maps(design: Design) -> str:
    """Say why there is no map."""
    if design.file.mechanism.frequency is None:
        return "Maps are of driven motions, and this mechanism has no drive."
    return "A map needs two of gap, speed and friction, and this mechanism does not have two of them."


def no_branches(design: Design) -> str:
    """Say why there are no branches and margins."""
    motion = design.motion
    if motion is None:
        return "There is no motion to follow."
    if not motion.repeats:
        return (
            "The motion does not repeat, so it is no orbit that could be followed over a number. The maps "
            "say where "
            "motions that repeat are found."
        )
    if motion.neutral:
        return "A shift of the motion stays as it is, so no single orbit goes on when a number changes."
    if design.file.mechanism.frequency is None:
        return "The mechanism moves by itself; `trimmer follow` traces its motion over any number."
    return "The mechanism has no number that branches are followed over."


def margin_sentences(design: Design) -> str:
    """Say which margin is the narrowest, and what ends each."""
    shares = [
        (side.reaches / path.varied.value - 1, path, side)
        for path in design.paths
        for side in (path.down, path.up)
        if side is not None and side.reaches is not None and path.varied.value
    ]
    if not shares:
        return "Within these ranges the motion stays stable: nothing ends it."
    share, path, side = min(shares, key=lambda each: abs(each[0]))
    way = "a smaller" if share < 0 else "a larger"
    told = (
        f"The narrowest margin is towards {way} {plain(place_words(path.varied.place))}: after "
        f"{plain(percent(abs(share)))} {_ended(side)}."
    )
    return told + " Beyond each value the mechanism takes another motion, which may still meet the targets."


def _ended(side: Side) -> str:
    if side.losing is not None:
        return SPECIAL[side.losing]
    if side.reason is BranchEnd.TORN:
        return "the motion jumps"
    return "the orbit could not be followed further, or loses its stability"


def branch_sentences(path: NumberPath) -> str:
    """Say where each side of a branch ends, and why."""
    told = []
    for side, way in ((path.down, "smaller"), (path.up, "larger")):
        if side is None:
            continue
        reach = (
            "stays stable to the end of the range"
            if side.reaches is None
            else (f"is stable up to {plain(shown(side.reaches, path.varied.unit, 4))}, where {_ended(side)}")
        )
        told.append(f"Towards {way} values it {reach}; {len(side.values)} orbits were solved.")
        if not side.reason.is_success:
            told.append(f"It was not followed to the end: {plain(side.reason.value)}.")
    if path.varied.bounded:
        told.append("The range ends at the static force, which the kinetic one never exceeds.")
    return " ".join(told)


def first_changes(design: Design) -> str:
    """Say for each important measure which number to change first, and in which direction."""
    found = design.sensitivities
    assert found is not None
    told = []
    for asked in important(design)[:4]:
        ranked = found.ranked(asked)
        if not ranked:
            continue
        entry = ranked[0]
        size = entry.of(asked)
        assert size is not None
        wanted = asked.measure is Measure.STROKE
        way = "raise" if (size.value > 0) == wanted else "lower"
        effect = "raises" if wanted else "lowers"
        told.append(
            f"- To {'raise' if wanted else 'lower'} the **{measure_words(asked.measure, asked.part)}**, "
            f"{way} the "
            f"{plain(place_words(entry.place))}: one per cent {effect} it by "
            f"{plain(written(abs(size.value), 2))} %."
        )
    return "\n".join(told)


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
            f"phase of stick "
            "comes or goes nearby: these slopes say little."
        )
    if found.failed:
        told += f" For the {places_listed(found.failed)} no orbit was found beside this one."
    return told


def no_sensitivities(design: Design) -> str:
    """Say why there are no slopes."""
    if design.motion is None:
        return "There is no motion whose slopes could be taken."
    if not design.motion.repeats:
        return (
            "The motion does not repeat, so it has no slopes: a small change of a number changes every "
            "detail of it. "
            "The maps say where calmer motions are."
        )
    return "No number of the file changes a measure of the motion."


def exposure_sentences(design: Design) -> str:
    """Say which body is held, and how its vibration was weighted."""
    motion, held = design.motion, design.file.held
    assert motion is not None
    if held is None:
        told = (
            'The file does not say which body is held; write `held = "NAME"` at its top, with the name of a '
            "body. "
            "Until then each line says what a hand would get that holds this body as it moves now."
        )
    else:
        told = f"The hand holds the {plain(held)}."
    if not motion.repeats:
        samples = f"samples of {motion.measured_periods} drive periods were weighted"
        return f"{told} The motion does not repeat, so {samples}."
    each = next(iter(motion.hand_arm.values()))
    largest = max(each.left_out for each in motion.hand_arm.values())
    return (
        f"{told} The weighted values sum {each.lines} lines up to {plain(shown(each.highest, 'Hz'))}; "
        f"what lies above "
        f"adds at most {plain(shown(largest, 'm/s²', 2))}."
    )


def rests_sentences(design: Design) -> str:
    """Say how the numbers were computed, and what was not looked at."""
    return (
        "Motions are computed exactly between events, and events to rounding; nothing is stepped in time "
        "with an error of "
        "its own. What the report says holds for the mechanism of the file: rigid bodies on one line, "
        "contacts with the law "
        "that is given, dry friction with constant forces. Tolerances, heat, wear over time, bending, and "
        "movements across "
        "the line are not modelled. The numbers of the file are taken as exact, except those that it "
        "leaves open."
    )
