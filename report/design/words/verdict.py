"""The verdict on a design in words, what it rests on, and what to change."""

import math
from operator import attrgetter

from report.design.axis import MEASURES, hunting_words
from report.design.quantities import percent, place_words, shown
from report.design.words.phrases import (
    bound_words,
    capital,
    changes_words,
    closings_words,
    count,
    kind_words,
    measure_value,
    measure_words,
    number_words,
    periods,
    without_margin,
)
from report.pages.escaping import Markdown, markdown
from trimmer.design.analysis.found_motion import FoundMotion
from trimmer.design.design import Design, Stage
from trimmer.design.specification.targets import OF_CLOSING, Measure, Target
from trimmer.design.trials.remedies import Remedy
from trimmer.design.trials.surroundings import SPEEDS, Around, Beside, Condition
from trimmer.design.verdict import NEAR, DesignOutcome, JudgedTarget, Sureness
from trimmer.messages import listed
from trimmer.response.results.response import MotionKind

FAR = 10.0  # Share of a bound beyond which it is not said how far it is away
OUTCOMES = {
    DesignOutcome.NO_TARGETS: "No targets",
    DesignOutcome.MET: "Met",
    DesignOutcome.MISSED: "Missed",
    DesignOutcome.DEPENDS: "It depends",
    DesignOutcome.OPEN: "Open",
}


def verdict_sentence(design: Design) -> Markdown:
    """Return the verdict in one sentence, as Markdown."""
    verdict, motion = design.verdict, design.motion
    match verdict.outcome:
        case DesignOutcome.NO_TARGETS:
            return _without_targets(design)
        case DesignOutcome.OPEN:
            return markdown("**Nothing can be said about the targets**: {}", _lowered(design.motions.message))
        case DesignOutcome.MET:
            return _met(design)
        case DesignOutcome.MISSED:
            return _missed(design)
    assert motion is not None
    return _depends(design)


def _without_targets(design: Design) -> Markdown:
    if design.motion is None:
        return markdown("**No motion could be measured**: {}", _lowered(design.motions.message))
    motion = _first(design)
    if motion.switched is not None or motion.steps:
        told = hunting_words(motion) if motion.steps else closings_words(motion)
        return markdown("**The file names no targets**, so nothing is judged; {}.", told)
    return markdown(
        "**The file names no targets**, so nothing is judged; from its start, the mechanism {} to {}.",
        "settles" if motion.repeats else "comes",
        kind_words(motion),
    )


def _first(design: Design) -> FoundMotion:
    if design.motion is None:
        raise ValueError("the design has no motion")
    return design.motion


def _lowered(text: str) -> str:
    return text[:1].lower() + text[1:]


def _met(design: Design) -> Markdown:
    judged = design.verdict.judged
    every = {1: "The target is met", 2: "Both targets are met"}
    all_of = every.get(len(judged), f"All {count(len(judged), 'target')} are met")
    if design.ranges is not None:
        tried = len(design.ranges.trials)
        points = "the one point that was" if tried == 1 else f"each of the {tried} points that were"
        points += " tried over what nobody knows"
        return markdown("**{}** at {}.", all_of, points)
    if design.verdict.beside and design.around is not None:
        told = "; ".join(_beside(design.around, each) for each in design.verdict.beside)
        advice = f"; {_advice(design)}" if design.remedies is not None else ""
        return markdown("**{} in the file, but not beside it**: {}{}.", all_of, told, advice)
    near = min(
        (each for each in judged if each.target.measure is not Measure.PERIOD),
        key=attrgetter("margin"),
        default=None,
    )
    if near is None:
        return markdown("**{}.**", all_of)
    which = measure_words(near.target.measure, near.target.part)
    value = measure_value(near.target.measure, near.value, near.target.unit)
    measured = not without_margin(near.target) and near.margin <= FAR
    away = f" ({percent(near.margin)} away)" if measured else ""
    return markdown(
        "**{}**; nearest to its bound is the {} with {}, where {} is wanted{}.",
        *(all_of, which, value, bound_words(near.target), away),
    )


def _beside(around: Around, target: Target) -> str:
    condition, value = around.worst(target, *Beside) or (Condition(Beside.POINT), math.nan)
    return f"{condition_words(condition)} {_miss(JudgedTarget(target, value, met=False))}"


def _missed(design: Design) -> Markdown:
    missed = [each for each in design.verdict.judged if not each.met]
    told = "; ".join(_miss(each) for each in missed)
    many = "A target is missed" if len(missed) == 1 else f"{capital(count(len(missed), 'target'))} are missed"
    rest = "; " + _advice(design) if design.remedies is not None else ""
    if design.ranges is not None:
        rest = ", at every point that was tried over what nobody knows"
    return markdown("**{}**: {}{}.", many, told, rest)


def _miss(judged: JudgedTarget) -> str:
    which = measure_words(judged.target.measure, judged.target.part)
    if judged.target.measure is Measure.PERIOD and math.isinf(judged.value):
        return f"the motion does not repeat, and {bound_words(judged.target)} is wanted as its period"
    if judged.target.measure in OF_CLOSING and math.isinf(judged.value):
        part, bound = judged.target.part, bound_words(judged.target)
        return f"{part} does not close, where {bound} is wanted as the {which}"
    if judged.target.measure in MEASURES and math.isinf(judged.value):
        verb = "rises" if judged.target.measure is Measure.RISE_TIME else "settles"
        part, bound = judged.target.part, bound_words(judged.target)
        return f"what {part} measures never {verb}, where {bound} is wanted as the {which}"
    value = measure_value(judged.target.measure, judged.value, judged.target.unit)
    return f"the {which} is {value}, where {bound_words(judged.target)} is wanted"


def _advice(design: Design) -> str:
    """Return what to change, as plain text."""
    assert design.remedies is not None
    found, nearest = design.remedies.found, design.remedies.nearest
    if found:
        best = found[0]
        sure = "" if best.meeting in (design.remedies.starts, None) else ", though not from every start"
        spare = f"with at least {percent(best.margin)} to spare"
        return f"{changes_words(best)} would meet all targets{sure}{and_beside(design)}, {spare}"
    told = f"no change of one number or of two at once was found{in_the_time(design)} that meets all of them"
    if nearest is None:
        return told
    if meets_at_its_point(nearest):
        meets = f"{changes_words(nearest)} would meet all targets at its own point"
        return f"{meets}, but there was no time to compute it {beside_words(design)}"
    return f"{told}{and_beside(design)}; nearest comes {changes_words(nearest)}"


def in_the_time(design: Design) -> str:
    """Say that the search for changes was ended early, between commas; empty if it was not."""
    ended = any(stage is Stage.REMEDIES for stage, _ in design.cut)
    return ", in the time that was allowed," if ended else ""


def meets_at_its_point(remedy: Remedy) -> bool:
    """Say whether a change meets all targets, but was not looked at beside its point for want of time."""
    return not remedy.beside and remedy.around.margin(Beside.POINT) >= 0


def beside_words(design: Design) -> str:
    """Return beside which point targets are looked at, as plain text."""
    machines = min((len(each.around.beside(Beside.SCATTER)) for each in _remedies(design)), default=0)
    driven = design.file.mechanism.frequency is not None
    told = [
        *([f"at speeds up to {percent(max(SPEEDS))} away"] if driven else []),
        *([f"in {number_words(machines)} machines as their numbers scatter"] if machines else []),
    ]
    return " and ".join(told)


def and_beside(design: Design) -> str:
    """Say that targets are met beside the point too, between commas; empty if nothing is beside it."""
    where = beside_words(design)
    return f", {where} too" if where else ""


def around_sentence(design: Design) -> str:
    """Say beside which point the targets were looked at; empty if nowhere."""
    around = design.around
    speeds, machines = (len(around.beside(kind)) if around else 0 for kind in (Beside.SPEED, Beside.SCATTER))
    where = [
        *([f"at speeds up to {percent(max(SPEEDS))} lower and higher"] if speeds else []),
        *([f"for {machines} machines whose numbers scatter as the file says"] if machines else []),
    ]
    if not where:
        return ""
    places = ", and ".join(where)
    return f"The motion was also computed {places}; the columns hold the worst that came out there."


def _remedies(design: Design) -> tuple[Remedy, ...]:
    found = design.remedies
    return () if found is None else (*found.found, *([found.nearest] if found.nearest else []))


def condition_words(condition: Condition) -> str:
    """Return where beside the point something holds, as plain text."""
    if condition.beside is Beside.SCATTER:
        return "in one of the machines as they scatter"
    if condition.beside is Beside.POINT:
        return "at the point itself"
    return f"at a speed {percent(abs(condition.speed))} {'lower' if condition.speed < 0 else 'higher'}"


def _depends(design: Design) -> Markdown:
    verdict, study = design.verdict, design.ranges
    if study is not None and study.doubt > 0 and study.meeting is not None:
        return markdown(
            "**It depends on what nobody knows:** of {} points over the {}, {} meet the targets; it would "
            "help most to measure the {}.",
            len(study.trials),
            listed([place_words(each.place) for each in study.ranges]),
            percent(study.meeting),
            place_words(study.narrowings[0].range.place),
        )
    met = all(each.met for each in verdict.judged)
    others = round(verdict.otherwise * design.motions.starts)
    leads = "leads" if others == 1 else "lead"
    share = (
        f"{number_words(others)} of {design.motions.starts} starts {leads}"
        if others
        else "a disturbance may lead"
    )
    return markdown(
        "**It depends on how the motion begins:** from its first start the mechanism {} the targets, but {} "
        "to a motion that {} them.",
        *("meets" if met else "misses", share, "misses" if met else "meets"),
    )


def sureness_sentences(design: Design) -> str:
    """Return how sure the verdict is, and on what that rests, as plain text."""
    motion = design.motion
    if motion is None:
        return ""
    level = {
        Sureness.SURE: "Within the model this is sure",
        Sureness.LIKELY: "Within the model this is likely, not sure",
        Sureness.UNSURE: "This is unsure",
    }[Sureness.LIKELY if design.cut and design.verdict.sureness is Sureness.SURE else design.verdict.sureness]
    if design.verdict.outcome is DesignOutcome.NO_TARGETS:
        level = "How that was found"
    varied = design.ranges is not None or design.file.uncertainty is not None
    exact = "All other numbers" if varied else "Numbers"
    return f"{level}: {'; '.join(_grounds(design, motion))}. {exact} of the file are taken as exact."


def _grounds(design: Design, motion: FoundMotion) -> list[str]:
    motions = design.motions
    measured = (
        f"the motion was followed for {shown(motion.signals.times[-1], 's')} more, in which it did not repeat"
        if motion.steps
        else f"the motion does not repeat and was measured over {periods(motion, motion.measured_periods)}"
    )
    if motion.repeats:
        measured = "the motion repeats exactly, and was solved for to rounding"
    elif motion.switched is not None:
        end = "until all of it rests" if motion.switched.forces else "for as long as the report says"
        measured = f"the motion was followed from event to event, each known to rounding, {end}"
    elif motion.kind is MotionKind.REST:
        still = "after the last step all comes to rest" if motion.steps else "nothing moves"
        measured = f"{still}, and what holds each part is known to rounding"
    grounds = [measured]
    if motions.starts > 1:
        share = f"{number_words(motion.starts)} of {motions.starts} starts"
        whose = f"all {motions.starts} starts" if motion.starts == motions.starts else share
        lead = "leads" if motion.starts == 1 else "lead"
        one = motion.repeats or motion.kind is MotionKind.REST
        grounds.append(f"{whose} {lead} to {'it' if one else 'a motion of this kind'}")
    others = len(motions.found) - 1
    if others:
        same = "judged as it is" if design.verdict.others_agree else "not all judged as it is"
        grounds.append(f"{count(others, 'other motion')} {'is' if others == 1 else 'are'} there, {same}")
    elif motions.neighbours is not None:
        grounds.append(
            f"no other motion was found from {count(motions.neighbours.tried, 'motion')} of similar machines"
        )
    if any(each.near for each in design.verdict.judged):
        grounds.append(f"a bound is less than {percent(NEAR)} away")
    if design.ranges is not None:
        grounds.append("numbers that nobody knows were varied together")
    return grounds
