"""What was found, in words: targets, verdicts, motions, special points."""

import math

from report.design.axis import MEASURES, step_value
from report.design.quantities import place_words, shown
from report.pages.escaping import Markdown
from trimmer.branches.special import SpecialKind
from trimmer.design.analysis.found_motion import FoundMotion
from trimmer.design.specification.targets import OF_CLOSING, Measure, Target
from trimmer.design.trials.remedies import Change, Remedy
from trimmer.messages import listed
from trimmer.response.results.response import MotionKind

COUNTS = (
    "no",
    "one",
    "two",
    "three",
    "four",
    "five",
    "six",
    "seven",
    "eight",
    "nine",
    "ten",
    "eleven",
    "twelve",
)
SPECIAL = {
    SpecialKind.GRAZING: "an impact comes or goes",
    SpecialKind.STICK: "a phase of stick comes or goes",
    SpecialKind.FOLD: "the motion ends in a fold, and another one takes its place",
    SpecialKind.PERIOD_DOUBLING: "the period doubles",
    SpecialKind.TORUS: "the motion begins to beat, on a torus",
    SpecialKind.SYMMETRY_BREAKING: "the motion to one side becomes unlike that to the other",
}


def count(number: int, noun: str) -> str:
    """Return a number of things, such as ``one start`` or ``24 starts``."""
    return f"{number_words(number)} {noun}{'' if number == 1 else 's'}"


def periods(motion: FoundMotion, number: int) -> str:
    """Return a number of what is counted of a motion, as ``24 drive periods`` or ``24 samples``."""
    return counted_in(motion.period_word, number)


def counted_in(word: str, number: int) -> str:
    """Return a number of drive periods or of samples, as their word says."""
    head, *tail = word.split(" of ")
    return " of ".join([count(number, head), *tail])


def number_words(number: int) -> str:
    """Return a whole number, in words up to twelve."""
    return COUNTS[number] if 0 <= number < len(COUNTS) else str(number)


def capital(text: str) -> str:
    """Return text with its first letter in upper case; Markdown stays Markdown."""
    raised = text[:1].upper() + text[1:]
    return Markdown(raised) if isinstance(text, Markdown) else raised


def measure_words(measure: Measure, part: str) -> str:
    """Return what a measure is, as plain text."""
    return {
        Measure.STROKE: f"peak to peak of {part}",
        Measure.RMS_ACCELERATION: f"rms acceleration of {part}",
        Measure.IMPACT_SPEED: f"impact speed in {part}",
        Measure.WEAR_POWER: f"wear power in {part}",
        Measure.PERIOD: "period of the motion",
        Measure.CLOSING_TIME: f"closing time of {part}",
        Measure.BOUNCE_TIME: f"bounce time of {part}",
        **{each: f"{words} of {part}" for each, words in MEASURES.items()},
    }[measure]


def measure_value(measure: Measure, value: float, unit: str = "") -> str:
    """Return a measure's value as plain text, in its unit or in that of translations."""
    if measure is Measure.PERIOD and not math.isnan(value):
        return "it does not repeat" if math.isinf(value) else count(int(value), "drive period")
    if measure in OF_CLOSING and math.isinf(value):
        return "it does not close"
    if measure in MEASURES:
        return step_value(measure, value, unit or measure.unit)
    return shown(value, unit or measure.unit)


def bound_words(target: Target) -> str:
    """Return what a target wants, as plain text."""
    if target.measure is Measure.PERIOD:
        return "that of the drive alone"
    if target.measure is Measure.HUNTING and not target.bound:
        return "none"
    side = "at least" if target.at_least else "at most"
    return f"{side} {shown(target.bound, target.unit or target.measure.unit)}"


def without_margin(target: Target) -> bool:
    """Say whether a target's bound gives no measure of how far it is away: a period, or zero."""
    return target.measure is Measure.PERIOD or not target.bound


def kind_words(motion: FoundMotion) -> str:
    """Return what a motion is, with its article."""
    if motion.kind is MotionKind.PERIODIC:
        if not motion.driven:
            return f"a motion of its own that repeats after {shown(motion.period or 0.0, 's', 5)}"
        return f"a motion that repeats after {periods(motion, motion.period_count or 1)}{_advance(motion)}"
    if motion.steps and motion.kind is MotionKind.UNDECIDED:
        return "hunting that does not repeat"
    return {
        MotionKind.TORUS: "a motion that beats and never quite repeats (a torus)",
        MotionKind.REST: "rest: nothing moves",
        MotionKind.CHAOTIC: f"a motion that stayed chaotic for {periods(motion, motion.drive_periods)}",
        MotionKind.DIVERGING: "a motion that grows without bound",
    }.get(motion.kind, "a motion that had not settled when the wait was over")


def _advance(motion: FoundMotion) -> str:
    """Return by how much outputs advance in the period; empty where none does."""
    if not motion.advances:
        return ""
    units = motion.signals.units
    each = listed([f"{name} by {shown(by, units.get(name, 'm'))}" for name, by in motion.advances.items()])
    return f", up to an advance of {each}"


def closings_words(motion: FoundMotion) -> str:
    """Say how the contacts of a machine that switches close, and whether it rests, as plain text."""
    assert motion.switched is not None
    told = [
        f"{name} closes after {shown(each.closing_time, 's')} and "
        + (f"bounces for {shown(each.bounce_time, 's')}" if each.bounce_time else "does not bounce")
        for name, each in sorted(motion.switched.closings.items(), key=lambda each: each[1].closing_time)
    ]
    last, rests = shown(motion.switched.last, "s"), motion.switched.forces
    end = f"after {last} nothing happens any more" if rests else f"its last event is at {last}"
    return f"{listed(told)}; {end}" if told else f"no contact closes; {end}"


def changes_words(remedy: Remedy) -> str:
    """Return a change of one number or two, as plain text."""
    return listed([change_words(each) for each in remedy.changes])


def change_words(change: Change) -> str:
    """Return another value of a number, as plain text."""
    before, after = (shown(each, change.unit) for each in (change.before, change.after))
    return f"{after} in place of {before} as {place_words(change.place)}"
