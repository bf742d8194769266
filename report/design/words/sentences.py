"""Sentences of the report that depend on what was found: plain text, or Markdown where the type says so."""

from collections.abc import Iterable

import numpy as np

from report.design.quantities import percent, place_words, shown, written
from report.design.words.phrases import capital, closings_words, count, kind_words, periods
from report.pages.escaping import Markdown, code, markdown
from trimmer.design import Design, Oddity, OutputSpectrum, Question, Stage
from trimmer.mechanism.kinds import Kind
from trimmer.messages import listed
from trimmer.response.results.response import MotionKind


def places_listed(places: Iterable[str]) -> str:
    """Return places in words, as a list."""
    return listed([place_words(each) for each in places])


def question_words(question: Question, design: Design) -> Markdown:
    """Ask about a number: where it stands, what it is, and why it is asked about."""
    line = design.file.line(question.place)
    place = code(question.place_text)
    where = markdown("Line {}, {}", line, place) if line else place
    unit = dict(design.file.mechanism.places).get(question.place_text, "")
    value, beside = (shown(each, unit) for each in (question.value, question.beside))
    depth, stroke = (shown(each, _length(question, design)) for each in (question.value, question.beside))
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
    return markdown("{}: {}", where, why)


def _length(question: Question, design: Design) -> str:
    """Return the unit of displacements at what is asked about."""
    section, name, *_ = (*question.place, "")
    mechanism = design.file.mechanism
    return mechanism.kind_of(section, name).unit("m") if section in ("plays", "stops") else "m"


STAGES = {
    Stage.MOTIONS: "all starts",
    Stage.RANGES: "all points of the ranges",
    Stage.AROUND: "neighbouring speeds and numbers that scatter",
    Stage.SENSITIVITIES: "the influence of every number",
    Stage.REMEDIES: "all changes that might meet the targets",
    Stage.NEIGHBOURS: "the search for other motions around",
    Stage.MAP: "maps",
    Stage.BRANCH: "branches",
    Stage.SLIDERS: "all motions behind the sliders",
}
"""What is missing if a stage was cut."""


def time_words(design: Design) -> Markdown:
    """Say what was left out or ended early as the time was over; empty if nothing was."""
    if not design.cut:
        return Markdown("")
    return markdown(
        "The {} s that were allowed did not suffice for {}. The same command goes on from what is done; {} "
        "allows more.",
        written(design.deadline.end - design.deadline.begun),
        listed(dict.fromkeys(STAGES[stage] for stage, _ in design.cut)),
        code("--budget"),
    )


def left_out(design: Design, *names: str) -> str:
    """Say where a stage stands that it was left out or ended early as the time was over; else nothing."""
    cut = [(stage, over) for stage, over in design.cut if stage.name in names]
    over = [f"over the {listed([place_words(each) for each in places])}" for _, places in cut if places]
    if not cut:
        return ""
    what = listed(dict.fromkeys(STAGES[stage] for stage, _ in cut))
    return f"There was no time left for {what}{f' ({listed(over)})' if over else ''}: see the verdict."


def helpless_words(design: Design) -> str:
    """Say which numbers were tried and help against no target that is missed; empty if all do against one."""
    assert design.remedies is not None
    mends = design.remedies.mends
    of_none = [each for each in design.remedies.tried if all(each in mend.helpless for mend in mends)]
    if not of_none or not mends:
        return ""
    which = "the target" if len(mends) == 1 else "any of the targets that are missed"
    return f"By itself no value that was tried of the {places_listed(of_none)} meets {which}."


def inventory(design: Design) -> str:
    """Return what the mechanism is made of, in a sentence or two."""
    mechanism = design.file.mechanism
    live = [each for each in mechanism.frictions.values() if each.kinetic_force or each.curve or each.viscous]
    counted = [
        (len(mechanism.bodies), "body", "bodies"),
        (len(mechanism.structures), "structure", "structures"),
        (len(mechanism.points), "point on a lever or gear", "points on levers or gears"),
        (len(mechanism.pins), "pin", "pins"),
        (len(mechanism.links), "spring or damper", "springs and dampers"),
        (len(mechanism.plays), "play", "plays"),
        (len(mechanism.stops), "stop", "stops"),
        (len(mechanism.walls), "wall", "walls"),
        (len(live), "friction", "frictions"),
        (len(mechanism.forces), "force", "forces"),
        (len(mechanism.controllers), "controller", "controllers"),
    ]
    there = [count(number, one).replace(one + "s", many) for number, one, many in counted if number]
    lacking = [
        many for number, _, many in counted if not number and many in ("plays", "stops", "frictions", "pins")
    ]
    if mechanism.frequency is not None:
        drive = f"It is driven at {shown(mechanism.frequency, 'Hz', 5)}."
    elif any(each.profile for each in mechanism.forces.values()):
        drive = "It has no drive; forces that change at given times switch it."
    else:
        drive = "It has no drive; whatever moves on in it does so by itself."
    none = f" There are no {listed(lacking, 'or')}." if lacking else ""
    turning = Kind.ROTATION in mechanism.kinds.values()
    how = "It moves along one line or turns" if turning else "All of it moves along one line"
    return f"{how}: {listed(there)}. {drive}{none}"


def settled_sentences(design: Design) -> str:
    """Say what the first start settles to."""
    motion, motions = design.motion, design.motions
    assert motion is not None
    begun = "its own start" if design.file.mechanism.start else "rest"
    if motion.steps and not motion.repeats and motion.kind is MotionKind.UNDECIDED:
        return (
            f"From {begun}, with the reference at its last value, the machine comes to {kind_words(motion)}. "
            "What follows was measured after the step for half as long again as the step was followed."
        )
    if motion.switched is not None:
        return f"The machine switches. From {begun}, {closings_words(motion)}."
    if motion.kind is MotionKind.REST:
        where = " Where it stays depends on its start." if motion.neutral else ""
        return f"From {begun}, the mechanism comes to rest, and nothing sets it in motion.{where}"
    if not motion.repeats:
        exponent = motion.lyapunov
        grown = (
            f" Small distances grow by the factor {written(float(np.exp(exponent.value)), 3)} per "
            f"{motion.period_word}, so that nobody can foresee it. It may still calm down after a longer "
            "time."
            if exponent is not None and motion.kind is MotionKind.CHAOTIC
            else ""
        )
        return (
            f"From {begun}, the mechanism comes to {kind_words(motion)}; it was followed for "
            f"{periods(motion, motion.drive_periods)}.{grown} Its measures are taken over "
            f"{periods(motion, motion.measured_periods)}, so the last digits depend on which."
        )
    if not motion.driven:
        return f"From {begun}, the mechanism comes to {kind_words(motion)}."
    told = (
        f"From {begun}, the mechanism settles within {periods(motion, motion.drive_periods)} to "
        f"{kind_words(motion)}. It was solved for exactly, {_steadiness(design)}. "
        f"{capital(count_of(motion.events, 'event'))} happen in a {motion.period_word}: contacts made "
        "or broken, slips reversed, stick begun or ended."
    )
    if motions.message and motion.neighbour_agrees is False:
        told += " A start that differs by a millionth ends in another motion, so that chance decides."
    return told


def count_of(number: float, noun: str) -> str:
    """Return a number that need not be whole with what it counts."""
    return count(int(number), noun) if float(number).is_integer() else f"{written(number, 3)} {noun}s"


def _steadiness(design: Design) -> str:
    motion = design.motion
    assert motion is not None
    if not motion.multipliers.size:
        return "and every disturbance is gone at once"
    largest = float(abs(motion.multipliers).max())
    if motion.neutral:
        return "which may lie anywhere: nothing, neither spring nor friction, brings a shifted part back"
    if largest < 1e-6:
        return "and a small disturbance is gone within a period"
    return f"and of a small disturbance {percent(largest, 3)} are left after a period"


def searched_sentences(design: Design) -> str:
    """Say where other motions were looked for, and where not."""
    motions = design.motions
    if design.motion is not None and design.motion.switched is not None:
        return "One start was followed, that of the file, with which a machine that switches always begins."
    if design.motion is not None and design.motion.steps:
        return (
            "One start was followed, that of the file, with which each step begins; from other starts the "
            "machine may rest where it hunts here, or hunt where it rests."
        )
    if design.file.mechanism.frequency is None:
        return "One start was followed. Without a drive, other motions were not looked for."
    told = (
        f"{capital(count(motions.starts, 'start'))} were followed: the first as the file has it, the others "
        f"at random within what the first motion reaches (seed {motions.seed})."
    )
    if motions.starts == 1:
        told = "One start was followed, that of the file."
    near = motions.neighbours
    if near is not None:
        names = places_listed(near.places)
        end = (
            "until nothing new turned up" if near.complete else "and the search was ended before that was all"
        )
        told += (
            f" The same was done for {near.cells} machines with another {names} (up to "
            f"±{percent(near.reach)}); {near.tried} of their motions were taken as starts here, {end}. "
            f"{capital(count(near.found, 'motion'))} turned up only in this way."
        )
    if motions.lost:
        told += f" {capital(count(motions.lost, 'motion'))} could not be followed to an end."
    return told + " A motion to which none of these starts leads would not have been noticed."


def spectrum_sentences(spectrum: OutputSpectrum, design: Design) -> str:
    """Say what the table of lines leaves out."""
    share = percent(spectrum.share, 4)
    floor = shown(spectrum.floor, spectrum.unit, 2)
    motion = design.motion
    told = f"These lines hold {share} of the mean square of {spectrum.output}."
    if motion is not None and not motion.repeats and motion.kind is not MotionKind.REST:
        return told + " The motion does not repeat, so the rest is spread between the lines."
    if spectrum.left_out:
        more = capital(count(spectrum.left_out, "further line"))
        told += (
            f" {more} up to the twentieth harmonic {'is' if spectrum.left_out == 1 else 'are'} below {floor}."
        )
    return told + " Harmonics above the twentieth were not computed."


def exposure_sentences(design: Design) -> Markdown:
    """Say which body is held, and how its vibration was weighted."""
    motion, held = design.motion, design.file.held
    assert motion is not None
    if not motion.hand_arm:
        return Markdown("All bodies turn; what a hand feels is known of bodies that move along a line alone.")
    if held is None:
        told = Markdown(
            'The file does not say which body is held; write `held = "NAME"` at its top, with the name of a '
            "body. Until then each line says what a hand would get that holds this body as it moves now."
        )
    else:
        told = markdown("The hand holds the {}.", held)
    if not motion.repeats:
        samples = f"samples of {periods(motion, motion.measured_periods)} were weighted"
        return markdown("{} The motion does not repeat, so {}.", told, samples)
    each = next(iter(motion.hand_arm.values()))
    largest = max(each.left_out for each in motion.hand_arm.values())
    return markdown(
        "{} The weighted values sum {} lines up to {}; what lies above adds at most {}.",
        *(told, each.lines, shown(each.highest, "Hz"), shown(largest, "m/s²", 2)),
    )
