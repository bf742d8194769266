"""Samples with all that is asked of them: indices, and harmonic balance beside them."""

import math
import time
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from trimmer.arrays import Reals
from trimmer.design.specification.targets import Measure
from trimmer.design.trials.trial import MeasureOfPart, TrialWork
from trimmer.errors import UnsupportedMotionError
from trimmer.harmonics.balance import require_balanceable
from trimmer.mechanism.mechanism import Mechanism
from trimmer.response.periodic.pace import is_driven
from trimmer.response.results.response import MotionKind
from trimmer.runners.runner import Runner
from trimmer.uncertainty.balance import BalancedSamples, balanced_samples
from trimmer.uncertainty.indices import Indices, indices_where
from trimmer.uncertainty.sample_file import SampleFile
from trimmer.uncertainty.sample_inputs import SampleSettings, sample_inputs
from trimmer.uncertainty.sample_records import NOWHERE, Keeping
from trimmer.uncertainty.samples import Samples, trials_of


@dataclass(frozen=True)
class QuantityOfInterest:
    """A result whose variance Sobol indices divide among the numbers that scatter.

    Attributes:
        name: What it is, in words.
        asked: The measure whose size it is; None for whether something is so, which is 0 or 1.
    """

    name: str
    asked: MeasureOfPart | None = None


@dataclass(frozen=True, eq=False)
class SampleStudy:
    """Samples, and what else was asked of them.

    Attributes:
        samples: The samples.
        indices: Sobol indices by what they are of; whether something is so stands apart from how large it is.
        balanced: Harmonic balance beside exact orbits.
        per_second: Samples per second that were computed in this run; not a number if none was.
    """

    samples: Samples
    indices: Mapping[QuantityOfInterest, Indices]
    balanced: BalancedSamples | None
    per_second: float


def study_samples(
    file: SampleFile,
    settings: SampleSettings,
    *,
    indices: bool = False,
    balanced: int = 0,
    runner: Runner | None = None,
    keeping: Keeping = NOWHERE,
    quiet: bool = False,
) -> SampleStudy:
    """Draw samples, with Sobol indices and harmonic balance if wanted; errors as of ``sample``.

    Args:
        file: The mechanism or loop, its targets, and what scatters.
        settings: How samples are drawn and looked at.
        runner: Who does the work.
        keeping: Where each sample is kept as soon as it is done.
        quiet: Show no progress bar.
        indices: Whether Sobol indices are wanted; they choose the samples themselves.
        balanced: How many samples are looked at by harmonic balance too.

    Raises:
        UnsupportedMotionError: if harmonic balance is wanted, and is of a loop, or does not know the motions
            of the mechanism.
    """
    if balanced and not isinstance(file.subject, Mechanism):
        raise UnsupportedMotionError(
            "harmonic balance beside samples is of mechanisms: leave it out for a loop"
        )
    if balanced:
        require_balanceable(file.mechanism)
    warm_up(file)
    begin = time.perf_counter()
    inputs = sample_inputs(file.subject, file.uncertainty, settings, file.targets, indices=indices)
    trials = trials_of(inputs, runner, keeping, quiet=quiet)
    samples = Samples(inputs, trials)
    found = _indices(samples) if indices else {}
    seconds = time.perf_counter() - begin
    rate = len(samples.trials) / seconds if not keeping.resume else math.nan
    beside = balanced_samples(samples, balanced) if balanced else None
    return SampleStudy(samples, found, beside, rate)


def warm_up(file: SampleFile) -> None:
    """Follow a motion for two periods, so that all is compiled once, and before the clock runs."""
    TrialWork(file.subject, (), (), 2)(())


def _indices(samples: Samples) -> dict[QuantityOfInterest, Indices]:
    possible, places = samples.inputs.possible, samples.inputs.uncertainty.places
    seed = samples.inputs.settings.seed
    return {each: indices_where(possible, column, places, seed) for each, column in _quantities(samples)}


def _quantities(samples: Samples) -> list[tuple[QuantityOfInterest, Reals]]:
    """Return what is so, as 0 and 1, and then the size of each measure, where it exists."""
    driven = is_driven(samples.inputs.subject)
    told = "whether the motion repeats with the drive" if driven else "whether it comes to rest"
    so = [each.period_count == 1 if driven else each.kind is MotionKind.REST for each in samples.trials]
    found = [(QuantityOfInterest(told), np.array(so, dtype=float))]
    if samples.targets:
        found.append((QuantityOfInterest("whether all targets are met"), samples.met.astype(float)))
    for asked in samples.asked:
        if asked.measure is not Measure.PERIOD:
            found.append((QuantityOfInterest(name_of(asked), asked), samples.measured(asked)))
    return found


def name_of(asked: MeasureOfPart) -> str:
    """Return what is measured, in words."""
    return f"{asked.measure.key.replace('_', ' ')} of {asked.part}"
