"""The file of a map: a header with all that the cells depend on, then one line for each cell that is done.

See ``trimmer.runners.record_file``. The keys of the header are ``trimmer map`` (the version of the format),
``program`` (the version of the program), ``mechanism`` (its TOML file as text), ``places``, ``values`` (a
list for each place), ``settings``, and ``inputs``, the SHA-256 of mechanism, places, values and settings. A
line of a cell has ``number``, its place in the map row by row, and ``motions``. Lines come in the order in
which cells were done.
"""

from collections.abc import Iterable, Iterator
from itertools import chain
from pathlib import Path
from typing import Any

from trimmer.files import MAP
from trimmer.json_data import DataError, typed
from trimmer.maps.cell_motion import CellMotion
from trimmer.maps.cells import CellResult
from trimmer.maps.inputs import FORMAT, MapInputs, varied
from trimmer.maps.measures import CellMeasures
from trimmer.motion.flow import Flow
from trimmer.response.flows import flow_of
from trimmer.response.results.response import MotionKind
from trimmer.runners.record_file import RecordFile, appended, cut
from trimmer.sizes import LARGEST

_MAPS = RecordFile(
    kind=MAP,
    key="trimmer map",
    version=FORMAT,
    many="map",
    one="cell of a map",
    others={
        "mechanism": "another mechanism or loop",
        "places": "other places to vary",
        "values": "other values",
        "settings": "other settings",
        "program": "another version of this program",
        "inputs": "other inputs",
    },
)


def begin(path: Path, inputs: MapInputs, *, overwrite: bool = False) -> None:
    """Write a file with the header alone; errors are those of ``RecordFile.begin``."""
    _MAPS.begin(path, inputs.header, overwrite=overwrite)


def resumed(path: Path, inputs: MapInputs) -> list[CellResult]:
    """Return the cells that a file holds, and cut off what is half-written.

    Raises:
        MapFileError: if the file is not there, is none of a map, is damaged, or has other inputs.
    """
    results = []
    flow = flow_of(inputs.subject)
    numbers: set[int] = set()
    for line, data in _MAPS.entries(path, inputs.header):
        try:
            result = typed(CellResult, data)
        except DataError as error:
            raise _MAPS.damaged(path, line, error) from error
        twice = f"number is {result.number}, as in a line before" if result.number in numbers else ""
        problem = _problem(result, inputs, flow) or twice
        if problem:
            raise _MAPS.damaged(path, line, problem)
        results.append(result)
        numbers.add(result.number)
    cut(path)
    return results


def append(path: Path, results: Iterable[CellResult]) -> Iterator[CellResult]:
    """Write results to the end of a file as they come, and yield them; see ``appended``."""
    return appended(path, results, _as_data)


def _problem(result: CellResult, inputs: MapInputs, flow: Flow) -> str:
    """Say why a result is none of a cell of this map; empty if it may be one.

    Args:
        result: The result.
        inputs: The inputs of the map.
        flow: The motion of what is varied, as it is without the values of the cell.
    """
    if not 0 <= result.number < inputs.count:
        return f"number is {result.number}, and the map has {inputs.count} cells, from 0 on"
    if not result.motions:
        return "motions is empty, and each start leads to one"
    for at, motion in enumerate(result.motions):
        problem = _problem_of_motion(motion, flow)
        sizes = {len(state) for state in motion.states} - {flow.size}
        if not problem and sizes and sizes != {_states(inputs, result.number)}:
            problem = "states are not of as many numbers as the motion has states"
        if problem:
            return f"motions[{at}].{problem}"
    return ""


def _problem_of_motion(motion: CellMotion, flow: Flow) -> str:
    if min(motion.period_count, motion.periods, motion.starts - 1) < 0:
        return "period_count, periods or starts are too small"
    if not motion.failure.isprintable():
        return "failure is no text on one line"
    if motion.failure or motion.kind is MotionKind.DIVERGING:
        return ""
    if motion.measures is None:
        return "measures is null, and there is no failure"
    return _problem_of_kind(motion, motion.measures, flow) or _problem_of_sizes(motion, motion.measures)


def _problem_of_kind(motion: CellMotion, measures: CellMeasures, flow: Flow) -> str:
    """Say what of a motion does not fit its kind or the mechanism."""
    repeats = motion.kind is MotionKind.PERIODIC
    if repeats is not (motion.period_count > 0):
        return f"period_count is {motion.period_count}, which does not fit kind"
    if motion.holding and motion.kind is not MotionKind.REST:
        return "holding is of a motion at rest, and this is none"
    if len(motion.states) != (motion.period_count if repeats else 1) or not motion.states:
        return f"states are {len(motion.states)}, which does not fit kind and period_count"
    for name, parts in (
        ("peak_to_peak", flow.outputs),
        ("rms_acceleration", flow.accelerations),
        ("wear_power", flow.rubbing),
    ):
        if {*getattr(measures, name)} != {*parts}:
            return f"measures.{name} is not of the parts of what moves"
    return ""


def _problem_of_sizes(motion: CellMotion, measures: CellMeasures) -> str:
    """Say which number of a motion is of no size that it can have; wear may round to less than nothing."""
    sizes = {
        "largest_multiplier": motion.largest_multiplier or 0.0,
        **{
            f"measures.{name}.{part}": size
            for name in ("peak_to_peak", "rms_acceleration")
            for part, size in getattr(measures, name).items()
        },
        **{f"measures.{name}": getattr(measures, name) for name in ("events", "impacts", "impact_speed")},
    }
    for name, size in sizes.items():
        if not 0.0 <= size <= LARGEST:
            return f"{name} is {size:g}, which is no size of it"
    others = (motion.lyapunov or 0.0, *measures.wear_power.values(), *chain.from_iterable(motion.states))
    strange = [number for number in others if abs(number) > LARGEST]
    return f"states, lyapunov or wear_power hold {strange[0]:g}, which no motion reaches" if strange else ""


def _states(inputs: MapInputs, number: int) -> int:
    """Return the number of states of a cell: damping of a stop adds one, and may be varied."""
    return flow_of(varied(inputs.subject, inputs.places, inputs.cell_values(number))).size


def _as_data(result: CellResult) -> dict[str, Any]:
    return {"number": result.number, "motions": [motion.as_data() for motion in result.motions]}
