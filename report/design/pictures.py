"""All pictures of a design, by the names under which its text asks for them."""

from collections.abc import Iterator, Mapping
from functools import partial
from operator import attrgetter

from report.design.axis import hunting_figure, step_figures
from report.design.diagram.diagram import mechanism_diagram
from report.design.diagram.layout import joints_of
from report.design.figures.over_numbers import Curve, branch, influences, kind_map, over_range, target_maps
from report.design.figures.over_time import (
    acceleration_of,
    line_spectrum,
    motion_over_time,
    transfer_functions,
)
from report.design.quantities import percent, place_words, shown
from report.design.words.phrases import bound_words, capital, measure_words
from report.pages.drawing.drawn import drawn
from report.pages.figure import Figure
from trimmer.design.analysis.linear import LinearState, driving
from trimmer.design.design import Design
from trimmer.design.parameter_studies.kept_map import DesignMap
from trimmer.design.parameter_studies.paths import NumberPath
from trimmer.design.specification.targets import Measure, unit_of_measure
from trimmer.design.trials.trial import MeasureOfPart, all_measures
from trimmer.mechanism.kinds import Kind
from trimmer.messages import listed
from trimmer.response.results.response import MotionKind

MEASURES = 4  # Measures whose influences are drawn


def pictures(design: Design) -> dict[str, Figure]:
    """Draw all pictures that a design has something for."""
    found = [
        _diagram(design),
        *_motion(design),
        *_acceleration(design),
        *_transfer(design),
        *_spectra(design),
        *_ranges(design),
        *step_figures(design),
        *_maps(design),
        *_branches(design),
        *_influences(design),
    ]
    return {each.id: each for each in found}


def _maps(design: Design) -> Iterator[Figure]:
    """Draw maps; of an axis the first tells where it hunts too, and one without targets nothing else."""
    stepped = design.file.stepped
    for number, each in enumerate(design.maps, start=1):
        if stepped and number == 1:
            yield hunting_figure(each, number)
        if each.targets or not stepped:
            yield _map(design, each, number)


def _diagram(design: Design) -> Figure:
    mechanism = design.file.mechanism
    joints = [f"{joint.name} between {joint.ends[0]} and {joint.ends[1]}" for joint in joints_of(mechanism)]
    joined = f" {'; '.join(joints)}." if joints else ""
    round_ones = Kind.ROTATION in mechanism.kinds.values()
    sliding = "boxes are bodies, which all move to the left and right alone; "
    only_round = round_ones and Kind.TRANSLATION not in {mechanism.kinds[each] for each in mechanism.bodies}
    sliding = "bodies are round, as they turn; " if only_round and not mechanism.structures else sliding
    turning = "round ones turn; " if round_ones and "round" not in sliding else ""
    turning += "a bar is a point that the bodies joined to it move; " if mechanism.points else ""
    return drawn(
        "diagram",
        "The mechanism",
        f"Drawn from the file: {sliding}{turning}"
        "zigzags are springs, pots are dampers; a bar in a slot is a play, two plates that meet a stop, two "
        "that rub a dry friction; a circle is a pin that moves on its body as prescribed. Nothing is to "
        "scale.",
        f"Bodies: {', '.join((*mechanism.bodies, *mechanism.structures))}.{joined}",
        partial(mechanism_diagram, mechanism),
    )


def _motion(design: Design) -> Iterator[Figure]:
    motion = design.motion
    if motion is None:
        return
    signals = motion.signals
    span = "one period" if motion.repeats else "a stretch of a motion that does not repeat"
    span = "a part of the rest" if motion.kind is MotionKind.REST else span
    span = "the time until nothing happens any more" if motion.switched is not None else span
    shown = [
        *(["the outputs"] if signals.outputs else []),
        *(["the forces of its contacts"] if signals.forces else []),
        *(["when parts touch and stick"] if signals.touching or signals.sticking else []),
    ]
    if not shown:
        return
    pulls = " A positive force pulls the two ends together." if signals.forces else ""
    yield drawn(
        "motion",
        "The motion over time",
        f"{capital(listed(shown))}, over {span}.{pulls}",
        f"Curves over {span} of {listed(shown)}.",
        partial(motion_over_time, motion.signals),
    )


def _acceleration(design: Design) -> Iterator[Figure]:
    motion = design.motion
    if motion is None or motion.kind is MotionKind.REST or not motion.hand_arm:
        return
    body = motion.body_felt(design.file.held, design.file.targets)
    assert body is not None
    rms = shown(motion.rms_acceleration[body], "m/s²")
    lines = "each line an exact one" if motion.repeats else "of samples, as the motion does not repeat"
    yield drawn(
        "acceleration",
        f"The acceleration of {body}",
        f"Above over time, below its spectrum up to 3 kHz, {lines}: what a sensor on it would measure along "
        "this axis, without weighting.",
        f"A curve over time, and lines over frequency; its rms is {rms}.",
        partial(acceleration_of, motion, body),
    )


def _transfer(design: Design) -> Iterator[Figure]:
    mechanism = design.file.mechanism
    drives = driving(mechanism)
    if not drives or not mechanism.outputs or not design.linear[0].transfer:
        return
    drive, output = drives[0][0], next(iter(mechanism.outputs))
    moving = [state.contacts.value for state in design.linear if _passes(state, drive, output)]
    if not moving:
        return
    states = f" with contacts {' and with contacts '.join(moving)}" if len(design.linear) > 1 else ""
    still = f" With contacts open {drive} does not move it." if len(moving) < len(design.linear) else ""
    yield drawn(
        "transfer",
        f"From {drive} to {output}",
        f"How {output} answers a small vibration of {drive}{states}.{still} The dotted line is the "
        "frequency of the drive. Dry friction is left out.",
        f"Modulus and phase of a transfer function over frequency{states}; its peaks are at the modes in the "
        "table above.",
        partial(transfer_functions, design.linear, drive, output, mechanism.frequency),
    )


def _passes(state: LinearState, drive: str, output: str) -> bool:
    """Say whether a drive moves an output at all."""
    found = [each for each in state.transfer if (each.drive, each.output) == (drive, output)]
    return any(abs(each.response).max() > 0 for each in found)


def _spectra(design: Design) -> Iterator[Figure]:
    for number, each in enumerate(design.spectra.values(), start=1):
        if each.lines:
            yield drawn(
                f"spectrum-{number}",
                f"Lines of {each.output}",
                f"Amplitudes of the lines of {each.output}, down to one ten-thousandth of the largest.",
                f"Upright lines over frequency, the highest at "
                f"{shown(max(each.lines, key=attrgetter('amplitude')).frequency, 'Hz')}.",
                partial(line_spectrum, [("", each)]),
            )


def _ranges(design: Design) -> Iterator[Figure]:
    study = design.ranges
    asked = important(design)[:MEASURES]
    if study is None or not asked:
        return
    first = study.narrowings[0].range
    named = [(each, _words(each)) for each in asked]
    units = {each: unit_of_measure(design.file.mechanism, each.measure, each.part) for each in asked}
    bounds = {MeasureOfPart(each.measure, each.part): each.bound for each in design.file.targets}
    others = (
        " The other numbers that nobody knows are anywhere in their ranges." if len(study.ranges) > 1 else ""
    )
    met = (
        " Full marks meet all targets, open ones do not; the dotted lines are bounds."
        if design.file.targets
        else ""
    )
    yield drawn(
        "ranges",
        f"Over the {place_words(first.place)}",
        f"What the mechanism does from its start over the {place_words(first.place)}.{others}{met}",
        "Points of some measures over the number that nobody knows.",
        partial(
            over_range, study, first, named, bounds if design.file.targets else {}, design.file.targets, units
        ),
    )


def _words(asked: MeasureOfPart) -> str:
    return measure_words(asked.measure, asked.part)


def _map(design: Design, each: DesignMap, number: int) -> Figure:
    if each.targets:
        return _target_map(design, each, number)
    first, second = place_words(each.first.place), place_words(each.second.place)
    rows, columns = each.result.shape
    kinds = each.result.period_count
    share = percent(float((kinds == 1).mean()))
    return drawn(
        f"map-{number}",
        f"Kinds of motion over {place_words(each.first.place)} and {place_words(each.second.place)}",
        f"What the mechanism settles to from its start over the {first} and the {second}: {columns} × {rows} "
        f"cells, each one motion, followed for at most {each.result.inputs.waited}. "
        "The circle is the file’s own point. Edges are known to a cell’s width.",
        f"A map of areas. In {share} of the cells the motion repeats with the drive.",
        partial(kind_map, each),
    )


def _target_map(design: Design, each: DesignMap, number: int) -> Figure:
    first, second = place_words(each.first.place), place_words(each.second.place)
    rows, columns = each.result.shape
    names = [f"{measure_words(one.measure, one.part)}, {bound_words(one)}" for one in each.targets]
    found = design.remedies.found if design.remedies else ()
    marks = [
        (changes[each.first.place], changes[each.second.place])
        for changes in ({one.place: one.after for one in remedy.changes} for remedy in found)
        if set(changes) == {each.first.place, each.second.place}
    ]
    moved = f"These two numbers move {'it' if len(names) == 1 else 'them'} most. "
    if design.file.stepped and number == 1:  # It is over gap and gain, whatever moves them most.
        moved = ""
    star = " The star is what is recommended." if marks else ""
    blue = (
        " Where the motion repeats with the drive the area is blue, elsewhere grey."
        if any(one.measure is Measure.PERIOD for one in each.targets)
        else ""
    )
    return drawn(
        f"map-{number}",
        f"{capital(listed(names))} over the {first} and the {second}",
        f"{moved}The black line is the bound "
        f"that is wanted, the circle the file’s own point.{star}{blue} Each of {columns} × {rows} cells is "
        "the motion that follows from the start; edges are known to a cell’s width.",
        f"Coloured areas over the {first} and the {second}, one picture for each target.",
        partial(target_maps, each, names, marks),
    )


def _branches(design: Design) -> Iterator[Figure]:
    asked, mechanism = curves_of(design), design.file.mechanism
    units = {each: unit_of_measure(mechanism, each.measure, each.part) for each, *_ in asked}
    for number, each in enumerate(design.paths, start=1):
        if asked and any(side is not None and len(side.values) > 1 for side in (each.down, each.up)):
            yield _branch(each, number, asked, units)


def curves_of(design: Design) -> list[Curve]:
    """Return what is drawn along branches: what missed targets bound, then others, then the first output.

    What targets of a step bound is of the way to a motion, and not of it.
    """
    missed = design.verdict.missed
    bounded = () if design.file.stepped else design.file.targets
    targets = [each for each in bounded if each.measure is not Measure.PERIOD]
    ordered = sorted(targets, key=lambda each: each not in missed)
    wanted = [each for each in ordered if each in missed][:2] or ordered[:1]
    found: list[Curve] = [
        (MeasureOfPart(each.measure, each.part), measure_words(each.measure, each.part), each.bound)
        for each in wanted
    ]
    output = next(iter(design.file.mechanism.outputs), None)
    if not found and output is not None:
        asked = MeasureOfPart(Measure.STROKE, output)
        found = [(asked, _words(asked), None)]
    return found


def _branch(path: NumberPath, number: int, asked: list[Curve], units: Mapping[MeasureOfPart, str]) -> Figure:
    words = place_words(path.varied.place)
    return drawn(
        f"branch-{number}",
        f"{capital(listed([name for _, name, _ in asked]))} over the {words}",
        "The motion of the file, solved for again and again while the number changes. Solid: the motion is "
        "stable, the machine runs so. Dashed: it is unstable, the slightest disturbance leads elsewhere. A "
        "dotted line is what is wanted.",
        f"Curves over the {words}, with marks where the motion changes.",
        partial(branch, path, asked, units),
    )


def _influences(design: Design) -> Iterator[Figure]:
    found = design.sensitivities
    if found is None or not found.entries:
        return
    asked = [each for each in important(design) if found.ranked(each)][:MEASURES]
    if asked:
        named = [(each, _words(each)) for each in asked]
        yield drawn(
            "influence",
            "What each number changes",
            "By how many per cent a measure changes when a number rises by one per cent; to the right it "
            "grows, to the left it shrinks. At most seven numbers each, the most influential first.",
            "Bars for the most influential numbers of each measure, to the right where the measure grows "
            "with them.",
            partial(influences, found, named),
        )


def important(design: Design) -> list[MeasureOfPart]:
    """Return the measures to look at first: of targets, then of steps, or stroke, held body, impact, wear."""
    motion, mechanism = design.motion, design.file.mechanism
    if motion is None:
        return []
    found = [
        MeasureOfPart(each.measure, each.part)
        for each in design.file.targets
        if each.measure is not Measure.PERIOD
    ]
    if design.file.stepped:
        return list(dict.fromkeys((*found, *all_measures(mechanism, stepped=True))))
    if mechanism.outputs:
        found.append(MeasureOfPart(Measure.STROKE, next(iter(mechanism.outputs))))
    if motion.rms_acceleration:
        shaken = design.file.held or max(motion.rms_acceleration, key=motion.rms_acceleration.__getitem__)
        found.append(MeasureOfPart(Measure.RMS_ACCELERATION, shaken))
    hit = [name for name, each in motion.contacts.items() if each.impact_speed > 0]
    if hit:
        found.append(
            MeasureOfPart(Measure.IMPACT_SPEED, max(hit, key=lambda name: motion.contacts[name].impact_speed))
        )
    worn = [name for name, each in motion.frictions.items() if each.power > 0]
    if worn and motion.switched is None:
        found.append(
            MeasureOfPart(Measure.WEAR_POWER, max(worn, key=lambda name: motion.frictions[name].power))
        )
    return list(dict.fromkeys(found))
