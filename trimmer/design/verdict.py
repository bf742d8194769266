"""The verdict on the targets, and what it rests on."""

from dataclasses import dataclass
from enum import Enum

from trimmer.design.analysis.found_motion import FoundMotion
from trimmer.design.motions import Motions
from trimmer.design.specification.targets import Measure, Target
from trimmer.design.trials.ranges import RangeStudy
from trimmer.design.trials.surroundings import Around
from trimmer.response.results.response import MotionKind

NEAR = 0.02  # Distance from a bound, as a share of it, that counts as near


class DesignOutcome(Enum):
    """The verdict on all targets together."""

    NO_TARGETS = "there are no targets"
    MET = "all targets are met"
    MISSED = "a target is missed"
    DEPENDS = "it depends on what nobody knows, or on how the motion begins"
    OPEN = "nothing can be said"


class Sureness(Enum):
    """How sure a verdict is, within the model."""

    SURE = "sure"
    LIKELY = "likely"
    UNSURE = "unsure"


@dataclass(frozen=True)
class JudgedTarget:
    """A target, and the measure that was found.

    Attributes:
        target: The target.
        value: The measure of the motion that the first start settles to.
        met: Whether it is met.
    """

    target: Target
    value: float
    met: bool

    @property
    def margin(self) -> float:
        """How far the value is on the good side of the bound, as a share of the bound; negative if missed."""
        if self.target.bound == 0:
            return 0.0 if self.met else -float("inf")
        share = self.value / self.target.bound - 1
        return share if self.target.at_least else -share

    @property
    def near(self) -> bool:
        """Whether the value is near its bound; a period is a whole number, and never is."""
        return self.target.measure is not Measure.PERIOD and abs(self.margin) < NEAR


@dataclass(frozen=True)
class DesignVerdict:
    """Whether the targets are met, and how sure that is.

    Attributes:
        outcome: On all targets together.
        sureness: How sure it is, within the model.
        judged: Each target.
        otherwise: Share of the starts whose motion is judged otherwise than that from rest.
        others_agree: Whether all other motions that were found are judged as that from rest is.
        beside: Targets that are met at the point, but missed at a neighbouring speed or as numbers scatter.
    """

    outcome: DesignOutcome
    sureness: Sureness
    judged: tuple[JudgedTarget, ...]
    otherwise: float
    others_agree: bool
    beside: tuple[Target, ...] = ()

    @property
    def missed(self) -> tuple[Target, ...]:
        """The targets that are missed, at the point or beside it."""
        return (*(each.target for each in self.judged if not each.met), *self.beside)


def verdict_on(
    targets: tuple[Target, ...], motions: Motions, study: RangeStudy | None, around: Around | None = None
) -> DesignVerdict:
    """Judge the targets by the motions, by what was seen over ranges, and around the point."""
    first = motions.first
    if not targets or first is None:
        outcome = DesignOutcome.OPEN if targets else DesignOutcome.NO_TARGETS
        return DesignVerdict(outcome, Sureness.UNSURE, (), 0.0, True)
    judged = tuple(JudgedTarget(each, first.value(each), each.met_by(first.value(each))) for each in targets)
    met = all(each.met for each in judged)
    others = [each for each in motions.found[1:] if each.meets(targets) != met]
    otherwise = sum(each.starts for each in others) / motions.starts
    depends = bool(others) or (study is not None and study.doubt > 0)
    if study is not None and not study.doubt:
        met = bool(study.meeting)
    outcome = DesignOutcome.DEPENDS if depends else DesignOutcome.MET if met else DesignOutcome.MISSED
    missing = () if around is None else around.missed
    beside = tuple(each.target for each in judged if each.met and each.target in missing)
    sureness = _sureness(judged, first, motions, depends)
    if sureness is Sureness.SURE and outcome is DesignOutcome.MET and beside:
        sureness = Sureness.LIKELY
    return DesignVerdict(outcome, sureness, judged, otherwise, not others, beside)


def _sureness(
    judged: tuple[JudgedTarget, ...], first: FoundMotion, motions: Motions, depends: bool
) -> Sureness:
    known = first.repeats or first.kind is MotionKind.REST
    if depends or not known or first.neutral:
        return Sureness.UNSURE
    near = any(each.near for each in judged)
    alone = len(motions.found) == 1 and first.neighbour_agrees is not False and not motions.lost
    return Sureness.SURE if alone and not near else Sureness.LIKELY
