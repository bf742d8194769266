"""Maps: which motion where, over one number of a mechanism or two."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from tqdm import tqdm

from trimmer.arguments import file_path, finite_number, require_instance, shown, whole_number
from trimmer.errors import MechanismError, TrimmerError, WrongTypeError
from trimmer.maps import checkpoint
from trimmer.maps.cells import Cell, CellMotion, CellResult, CellWork, Settings, varied
from trimmer.maps.checkpoint import MapFileError, MapInputs
from trimmer.maps.kinds import MotionKind
from trimmer.maps.runner import ProcessRunner, Runner, SerialRunner
from trimmer.mechanism.mechanism import Mechanism

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from numpy.typing import ArrayLike

    from trimmer.arrays import Integers, Reals

FEW = 12
"""Cells up to which other processes are not worth their beginning."""
SILENCE = 1.0
"""Seconds before a progress bar shows."""


class MapError(TrimmerError, ValueError):
    """A map cannot be made of what is given; the message says what to give."""


class MapInterruptedError(KeyboardInterrupt):
    """A map was interrupted; the message says how many cells are done, and how to go on."""


@dataclass(frozen=True, eq=False)
class MotionMap:
    """Which motion where. Arrays have the shape (n2, n1): the first place varies along a row.

    With one place n2 is 1. All arrays are of the first motion of each cell, which is that from rest, or from
    the mechanism's own start; ``cells`` has the others. Measures of cells that failed are NaN.

    Attributes:
        inputs: Mechanism, places, values and settings.
        cells: The result of each cell, row by row.
    """

    inputs: MapInputs
    cells: tuple[CellResult, ...]

    @property
    def places(self) -> tuple[str, ...]:
        """What is varied, as dotted places."""
        return self.inputs.places

    @property
    def values(self) -> tuple[Reals, ...]:
        """Values of each place, in SI units."""
        return tuple(np.array(values) for values in self.inputs.values)

    @property
    def shape(self) -> tuple[int, int]:
        """(n2, n1)."""
        columns = len(self.inputs.values[0])
        return self.inputs.count // columns, columns

    def _of_each(self, measure: Callable[[CellMotion], float | None]) -> Reals:
        return np.array([measure(cell.motions[0]) for cell in self.cells], dtype=float).reshape(self.shape)

    def _measure(self, name: str, key: str | None = None) -> Reals:
        def value(motion: CellMotion) -> float:
            if motion.measures is None:
                return float("nan")
            found = getattr(motion.measures, name)
            return float(found if key is None else found[key])

        return self._of_each(value)

    @cached_property
    def kind(self) -> np.ndarray[tuple[int, int], np.dtype[np.object_]]:
        """Kinds of motion, ``MotionKind``, (n2, n1)."""
        kinds = np.empty(len(self.cells), dtype=object)
        kinds[:] = [cell.motions[0].kind for cell in self.cells]
        return kinds.reshape(self.shape)

    @cached_property
    def period_count(self) -> Integers:
        """Drive periods after which the motion repeats, 0 where it does not, (n2, n1)."""
        return self._of_each(lambda motion: motion.period_count).astype(np.int64)

    @cached_property
    def periods(self) -> Integers:
        """Drive periods that were waited, (n2, n1)."""
        return self._of_each(lambda motion: motion.periods).astype(np.int64)

    @cached_property
    def motion_count(self) -> Integers:
        """Distinct motions that were found in each cell, (n2, n1)."""
        return np.array([len(cell.motions) for cell in self.cells], dtype=np.int64).reshape(self.shape)

    @cached_property
    def lyapunov(self) -> Reals:
        """Growth of small distances per drive period, as a logarithm; NaN where not measured, (n2, n1)."""
        return self._of_each(lambda motion: motion.lyapunov)

    @cached_property
    def largest_multiplier(self) -> Reals:
        """Largest modulus of the Floquet multipliers, NaN without an exact orbit, (n2, n1)."""
        return self._of_each(lambda motion: motion.largest_multiplier)

    @cached_property
    def stroke(self) -> Reals:
        """Peak to peak of the mechanism's first output, m, (n2, n1).

        Raises:
            MapError: if the mechanism has no output.
        """
        if not self.inputs.mechanism.outputs:
            raise MapError("the mechanism has no output, so there is no stroke: give it one ([outputs])")
        return next(iter(self.peak_to_peak.values()))

    @cached_property
    def peak_to_peak(self) -> Mapping[str, Reals]:
        """Of each output, m, (n2, n1)."""
        return {name: self._measure("peak_to_peak", name) for name in self.inputs.mechanism.outputs}

    @cached_property
    def rms_acceleration(self) -> Mapping[str, Reals]:
        """Of each body, m/s², (n2, n1)."""
        return {name: self._measure("rms_acceleration", name) for name in self.inputs.mechanism.bodies}

    @cached_property
    def wear_power(self) -> Mapping[str, Reals]:
        """Mean power of each dry friction, W, (n2, n1)."""
        return {name: self._measure("wear_power", name) for name in self.inputs.mechanism.frictions}

    @cached_property
    def events(self) -> Reals:
        """Events per drive period, (n2, n1)."""
        return self._measure("events")

    @cached_property
    def impacts(self) -> Reals:
        """Contacts made per drive period, (n2, n1)."""
        return self._measure("impacts")

    @cached_property
    def impact_speed(self) -> Reals:
        """Largest speed at which the sides of a contact meet, m/s, (n2, n1)."""
        return self._measure("impact_speed")

    @property
    def failures(self) -> Mapping[tuple[int, int], str]:
        """Why motions ended before their time, by row and column."""
        columns = self.shape[1]
        return {
            divmod(cell.number, columns): motion.failure
            for cell in self.cells
            for motion in cell.motions[:1]
            if motion.failure
        }

    @property
    def searched(self) -> str:
        """What was looked at, in a sentence."""
        return _searched(self)

    def plot(self, axes: Axes, curves: Iterable[tuple[str, ArrayLike]] = ()) -> None:
        """Draw the kinds of motion into axes, with curves over them; see ``drawing.draw_map``."""
        from trimmer.maps.drawing import draw_map

        draw_map(axes, self, curves)


def motion_map(  # noqa: PLR0913 (each is a choice of its own, all but two with a default)
    mechanism: Mechanism,
    values: Mapping[str, ArrayLike],
    *,
    most_periods: int = 300,
    most_period_count: int = 24,
    starts: int = 1,
    seed: int = 0,
    runner: Runner | None = None,
    file: Path | str | None = None,
    resume: bool = False,
    overwrite: bool = False,
    quiet: bool = False,
) -> MotionMap:
    """Tell over one number of a mechanism or two what it settles to.

    Each cell is followed from rest, or from the mechanism's own start, until it has settled, and no cell knows
    of another, so order and processes never matter. A progress bar shows on a terminal. An interrupt leaves
    the file as it is after the last whole cell.

    Args:
        mechanism: The mechanism; it has a frequency.
        values: Values, in SI units, by their dotted places, one place or two; the first runs along a row.
        most_periods: Drive periods to wait at most in each cell.
        most_period_count: Largest number of drive periods after which a motion may repeat.
        starts: Starts of each cell; those after the first are random.
        seed: Seed of the random starts; each cell has its own numbers.
        runner: Who does the work; by default processes on all cores, for a few cells this one.
        file: Where each cell is kept as soon as it is done; see ``trimmer.maps.checkpoint``.
        resume: Go on with that file.
        overwrite: Replace that file.
        quiet: Show no progress bar.

    Returns:
        The map.

    Raises:
        MechanismError: if there is no such place, or a value cannot stand there with any of the others.
        MapError: if there is not one place or two, or no value, or no drive.
        MapFileError: if the file cannot be gone on with.
        FileWriteError: if the file cannot be written.
        MapInterruptedError: after an interrupt.
    """
    settings = Settings(
        whole_number("most_periods", most_periods, 2),
        whole_number("most_period_count", most_period_count, 1),
        whole_number("starts", starts, 1),
        whole_number("seed", seed, 0),
    )
    inputs = checked_inputs(mechanism, values, settings)
    target = None if file is None else file_path("file", file)
    if target is None and (resume or overwrite):
        raise MapError(f"{'resume' if resume else 'overwrite'} is of a file: name it")
    done: dict[int, CellResult] = {}
    if target is not None and resume:
        done = {result.number: result for result in checkpoint.resumed(target, inputs)}
    elif target is not None:
        checkpoint.begin(target, inputs, overwrite=overwrite)
    for result in _computed(inputs, done, runner, target, quiet):
        done[result.number] = result
    return MotionMap(inputs, tuple(done[number] for number in range(inputs.count)))


def checked_inputs(mechanism: Mechanism, values: Mapping[str, ArrayLike], settings: Settings) -> MapInputs:
    """Return the inputs of a map after all was checked that can be without a motion.

    Raises:
        MechanismError, MapError, WrongTypeError: as ``motion_map`` does.
    """
    require_instance("mechanism", mechanism, Mechanism, "a Mechanism")
    require_instance("values", values, Mapping, "a mapping of dotted places to values")
    if mechanism.frequency is None:
        raise MapError("the mechanism has no frequency, and maps are of driven motions: give it one")
    if not 1 <= len(values) <= 2:
        raise MapError(f"a map is over one place or two, not {len(values)}")
    places = tuple(values)
    lists = tuple(_numbers(place, each) for place, each in values.items())
    if len(places) == 2 and _same_place(mechanism, places):
        raise MapError(f"both places are {places[0]}: vary two different numbers, or one")
    for axis, place in enumerate(places):
        mechanism.value(place)
        others = lists[1 - axis] if len(lists) > 1 else ()
        for value in lists[axis]:
            _check_value(mechanism, places, axis, value, others)
    return MapInputs(mechanism, places, lists, settings)


def _same_place(mechanism: Mechanism, places: tuple[str, ...]) -> bool:
    first, second = places
    if first == second:
        return True
    value = mechanism.value(second)
    changed = mechanism.with_value(second, value)
    return changed.value(first) != mechanism.value(first)


def _numbers(place: str, values: ArrayLike) -> tuple[float, ...]:
    if isinstance(values, str | bytes) or not np.iterable(values):
        raise WrongTypeError(f"values of {place} must be a sequence of numbers, not {shown(values)}")
    numbers = tuple(finite_number(f"{place}[{at}]", value) for at, value in enumerate(values))  # type: ignore[arg-type]
    if not numbers:
        raise MapError(f"there is no value of {place}: give at least one")
    if len(set(numbers)) < len(numbers):
        raise MapError(f"a value of {place} is there twice: give each once")
    return numbers


def _check_value(
    mechanism: Mechanism, places: tuple[str, ...], axis: int, value: float, others: tuple[float, ...]
) -> None:
    """Check that a value can stand at its place with at least one of the other place's values."""
    first = None
    for other in others or (None,):
        pair = (value,) if other is None else (value, other) if axis == 0 else (other, value)
        try:
            varied(mechanism, places, pair)
        except MechanismError as error:
            first = first or error
        else:
            return
    if first is not None:
        raise first


def _computed(
    inputs: MapInputs, done: Mapping[int, CellResult], runner: Runner | None, target: Path | None, quiet: bool
) -> Iterator[CellResult]:
    """Yield the cells that are left as they come, behind a progress bar, and keep them in the file."""
    left = [number for number in range(inputs.count) if number not in done]
    if not left:
        return
    if runner is None:
        runner = ProcessRunner() if len(left) > FEW else SerialRunner()
    work = CellWork(inputs.mechanism, inputs.places, inputs.settings)
    cells = (Cell(number, inputs.cell_values(number)) for number in left)
    results = iter(runner.results(work, cells))
    kept = results if target is None else checkpoint.append(target, results)
    finished = len(done)
    bar = tqdm(
        total=inputs.count,
        initial=finished,
        desc="cells",
        delay=SILENCE,
        leave=False,
        disable=True if quiet else None,
    )
    try:
        with bar:
            for result in kept:
                finished += 1
                bar.update()
                yield result
    except KeyboardInterrupt:
        raise MapInterruptedError(_how_to_go_on(finished, inputs.count, target)) from None


def _how_to_go_on(finished: int, count: int, target: Path | None) -> str:
    begun = f"interrupted after {finished} of {count} cells"
    if target is None:
        return f"{begun}, which are lost; name a file (--output) to be able to go on"
    return f"{begun}, which {target} holds; the same call with --resume goes on"


def _searched(result: MotionMap) -> str:
    settings, count = result.inputs.settings, len(result.cells)
    own = "the mechanism's own start" if result.inputs.mechanism.start else "rest"
    several = int((result.motion_count > 1).sum())
    begun = f"{count} cells, each from {own}"
    if settings.starts > 1:
        begun += f" and from {settings.starts - 1} random states (seed {settings.seed})"
    begun += f", for at most {settings.most_periods} drive periods"
    if settings.starts == 1:
        return f"{begun}; other motions were not looked for"
    return f"{begun}; {several} of them have several motions among those found"
