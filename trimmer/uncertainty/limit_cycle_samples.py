"""Limit cycles, by harmonic balance, of samples of the thesis's loop, whose parameters and gap scatter."""

import time
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from trimmer.arrays import Flags, Reals
from trimmer.displacement import CUTTER_RELATIVE_TO_GUARD, Displacement
from trimmer.ensembles.limit_cycles import SampledLimitCycles, sampled_limit_cycles
from trimmer.errors import UncertaintyError
from trimmer.linear.model import InputChannels
from trimmer.parameter_kinds import ParameterKind
from trimmer.parameters import TrimmerParameters, parameter_table, read_parameters
from trimmer.showing.shown import counted
from trimmer.uncertainty.distributions import Uncertainty
from trimmer.uncertainty.indices import Indices, indices_where
from trimmer.uncertainty.parameter_file import GAP, uncertainty_of_file
from trimmer.uncertainty.points import left_out
from trimmer.uncertainty.sample_inputs import MOST_IMPOSSIBLE, SampleSettings, drawn_values


@dataclass(frozen=True)
class ParameterNumbers:
    """The numbers of a trimmer with play as places: the symbols of its parameters, and ``gap``.

    Attributes:
        parameters: The trimmer.
        gap: Total clearance of the play, m.
    """

    parameters: TrimmerParameters
    gap: float

    @property
    def places(self) -> Mapping[str, str]:
        """The SI unit of each place."""
        return {**{each.symbol: each.unit for each in parameter_table()}, GAP: "m"}

    def value(self, place: str) -> float:
        """Return the number at a place, in that unit."""
        return self.gap if place == GAP else float(getattr(self.parameters, place))


@dataclass(frozen=True)
class ParameterSampleFile:
    """A parameter file with what scatters."""

    numbers: ParameterNumbers
    uncertainty: Uncertainty


def read_parameter_sample_file(path: Path, gap: float) -> ParameterSampleFile:
    """Read a parameter file with ``[uncertainty]``.

    Args:
        path: The file, which is read twice, so no stream.
        gap: Total clearance of the play, m.

    Raises:
        ParameterError: if it cannot be read, holds what cannot be used, or nothing in it scatters.
    """
    numbers = ParameterNumbers(read_parameters(path), gap)
    return ParameterSampleFile(numbers, uncertainty_of_file(path, numbers))


@dataclass(frozen=True, eq=False)
class LimitCycleSamples:
    """Limit cycles of samples of a loop, as harmonic balance predicts them.

    Attributes:
        file: The loop and what scatters.
        settings: How samples were drawn.
        values: The samples, SI units, shape (n, numbers that scatter).
        possible: Whether a trimmer can have such numbers, shape (n,).
        found: Limit cycles of the possible ones.
        indices: Sobol indices by what they are of: whether there is a stable limit cycle stands apart from
            how large it is.
        per_second: Samples per second that were computed.
    """

    file: ParameterSampleFile
    settings: SampleSettings
    values: Reals
    possible: Flags
    found: SampledLimitCycles
    indices: Mapping[str, Indices]
    per_second: float

    @property
    def largest(self) -> tuple[Reals, Reals]:
        """Amplitude, m, and frequency, Hz, of the largest stable limit cycle of each; NaN without one."""
        return _largest(self.found)

    @property
    def message(self) -> str:
        """What was drawn and searched, in sentences."""
        told = (
            f"{counted(len(self.values), 'sample')} ({self.settings.plan.word}, seed {self.settings.seed}). "
        )
        left = int((~self.possible).sum())
        if left:
            told += f"{left_out(left, 'trimmer')}. "
        return told + self.found.message


def _largest(found: SampledLimitCycles) -> tuple[Reals, Reals]:
    if not found.amplitude.shape[1]:
        nothing = np.full(len(found.count), np.nan)
        return nothing, nothing
    sizes = np.where(found.stable, found.amplitude, -np.inf)
    column = sizes.argmax(axis=1)[:, None]
    amplitude = np.take_along_axis(found.amplitude, column, axis=1)[:, 0]
    frequency = np.take_along_axis(found.frequency, column, axis=1)[:, 0]
    return np.where(found.exists, amplitude, np.nan), np.where(found.exists, frequency, np.nan)


def sample_limit_cycles(
    file: ParameterSampleFile,
    settings: SampleSettings,
    *,
    indices: bool = False,
    output: Displacement | str = CUTTER_RELATIVE_TO_GUARD,
    channels: InputChannels | str = InputChannels.DISPLACEMENT_AND_VELOCITY,
) -> LimitCycleSamples:
    """Draw samples of the thesis's loop with friction-controlled play, and predict their limit cycles.

    They are those of harmonic balance; ``sample`` finds exact motions of a loop.

    Args:
        file: The loop, and what scatters.
        settings: How samples are drawn; drive periods are of no use here.
        indices: Whether Sobol indices are wanted; they choose the samples themselves.
        output: The displacement at the input of the play.
        channels: How the pin acts.

    Raises:
        UncertaintyError: if too many samples are impossible, or indices of dependent numbers are wanted.
    """
    settings, values = drawn_values(file.uncertainty, settings, indices=indices)
    possible = _possible(file, values)
    begin = time.perf_counter()
    found = _limit_cycles(file, values[possible], output, channels)
    seconds = time.perf_counter() - begin
    told = _indices(file, possible, found, settings.seed) if indices else {}
    return LimitCycleSamples(file, settings, values, possible, found, told, len(found.count) / seconds)


def _limit_cycles(
    file: ParameterSampleFile, values: Reals, output: Displacement | str, channels: InputChannels | str
) -> SampledLimitCycles:
    samples = dict(zip(file.uncertainty.places, values.T, strict=True))
    gap = samples.pop(GAP, np.full(len(values), file.numbers.gap))
    return sampled_limit_cycles(
        samples, gap=gap, base=file.numbers.parameters, output=output, channels=channels
    )


def _possible(file: ParameterSampleFile, values: Reals) -> Flags:
    """Return which samples a trimmer can have, if these are nearly all."""
    positive = {each.symbol for each in parameter_table() if each.quantity is ParameterKind.MASS} | {GAP}
    within = np.array([place in positive for place in file.uncertainty.places])
    right = np.where(within, values > 0, values >= 0)
    possible = np.asarray(right.all(axis=1))
    if (~possible).mean() > MOST_IMPOSSIBLE:
        wrong = file.uncertainty.places[int((~right).sum(axis=0).argmax())]
        raise UncertaintyError(
            f"{(~possible).mean():.1%} of the samples are impossible, most of them as {wrong} would be "
            "negative or zero; let it scatter less, or uniformly between values that it can have"
        )
    return possible


def _indices(
    file: ParameterSampleFile, possible: Flags, found: SampledLimitCycles, seed: int
) -> dict[str, Indices]:
    amplitude, frequency = _largest(found)
    quantities = {
        "whether there is a stable limit cycle": found.exists.astype(float),
        "its amplitude": amplitude,
        "its frequency": frequency,
    }
    places = file.uncertainty.places
    return {name: indices_where(possible, column, places, seed) for name, column in quantities.items()}
