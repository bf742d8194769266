"""What samples depend on: how they are drawn, and which of them a mechanism or a loop can have."""

from dataclasses import dataclass, replace

import numpy as np

from trimmer.arrays import Flags, Reals
from trimmer.design.specification.targets import Target, is_stepped
from trimmer.design.trials.trial import MeasureOfPart, all_measures
from trimmer.errors import TrimmerError, UncertaintyError
from trimmer.maps.inputs import varied
from trimmer.motion.subject import Subject
from trimmer.response.flows import require_subject
from trimmer.uncertainty.distributions import Uncertainty
from trimmer.uncertainty.indices import require_independent, saltelli_points
from trimmer.uncertainty.points import Plan

MOST_IMPOSSIBLE = 0.01
"""Share of samples that may be impossible, such as a negative gap, before the distributions are refused."""
MOST_SAMPLES = 1_000_000


@dataclass(frozen=True)
class SampleSettings:
    """How many samples are drawn, how they are spread, and how long each may take to settle.

    Attributes:
        count: How many; of Sobol points the next power of two.
        plan: How points are chosen.
        seed: Of the points.
        most_periods: Drive periods to wait for each to settle.

    Raises:
        UncertaintyError: if there are more than ``MOST_SAMPLES``.
    """

    count: int = 512
    plan: Plan = Plan.LATIN_HYPERCUBE
    seed: int = 0
    most_periods: int = 300

    def __post_init__(self) -> None:
        if self.count > MOST_SAMPLES:
            raise UncertaintyError(
                f"{self.count} samples do not fit into memory: draw at most {MOST_SAMPLES}"
            )


@dataclass(frozen=True, eq=False)
class SampleInputs:
    """All that the samples depend on.

    Attributes:
        subject: The mechanism or loop.
        uncertainty: What scatters.
        settings: How samples are drawn and looked at.
        values: The samples, SI units, shape (n, numbers that scatter).
        possible: Whether a mechanism or loop can have such numbers, shape (n,).
        targets: What is wanted.
    """

    subject: Subject
    uncertainty: Uncertainty
    settings: SampleSettings
    values: Reals
    possible: Flags
    targets: tuple[Target, ...]

    @property
    def stepped(self) -> bool:
        """Whether targets are of a step."""
        return is_stepped(each.measure for each in self.targets)

    @property
    def asked(self) -> tuple[MeasureOfPart, ...]:
        """What is measured of each sample: how it follows a step if targets are of one, else what it does."""
        return all_measures(self.subject, stepped=self.stepped)


def drawn_values(
    uncertainty: Uncertainty, settings: SampleSettings, *, indices: bool = False
) -> tuple[SampleSettings, Reals]:
    """Draw values, (n, numbers); those for Sobol indices follow his sequence, as the settings say then."""
    numbers = len(uncertainty.scatters)
    if indices:
        require_independent(uncertainty)
        settings = replace(settings, plan=Plan.SOBOL)
        shares = saltelli_points(numbers, settings.plan.count(settings.count), settings.seed)
    else:
        shares = settings.plan.points(settings.plan.count(settings.count), numbers, settings.seed)
    return settings, uncertainty.values(shares)


def sample_inputs(
    subject: Subject,
    uncertainty: Uncertainty,
    settings: SampleSettings,
    targets: tuple[Target, ...] = (),
    *,
    indices: bool = False,
) -> SampleInputs:
    """Draw samples, and check which of them are possible.

    Raises:
        UncertaintyError: if too many samples are impossible, or indices of dependent numbers are wanted.
        MechanismError: if there is no number at a place.
    """
    settings, values = drawn_values(uncertainty, settings, indices=indices)
    require_subject(subject)
    for place in uncertainty.places:
        subject.value(place)
    reasons = [_reason_against(subject, uncertainty.places, tuple(row)) for row in values.tolist()]
    possible = np.array([not reason for reason in reasons], dtype=bool)
    if (~possible).mean() > MOST_IMPOSSIBLE:
        reason = next(reason for reason in reasons if reason)
        raise UncertaintyError(
            f"{(~possible).mean():.1%} of the samples are impossible, the first one because {reason}; "
            "let the number scatter less, or uniformly between values that it can have"
        )
    return SampleInputs(subject, uncertainty, settings, values, possible, targets)


def _reason_against(subject: Subject, places: tuple[str, ...], values: tuple[float, ...]) -> str:
    try:
        varied(subject, places, values)
    except TrimmerError as error:
        return str(error)
    return ""
