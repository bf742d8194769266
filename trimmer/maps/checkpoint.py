"""The file of a map: a header with all that the cells depend on, then one line for each cell that is done.

See ``trimmer.runners.record_file``. The keys of the header are ``trimmer map`` (the version of the format),
``program`` (the version of the program), ``mechanism`` (its TOML file as text), ``places``, ``values`` (a
list for each place), ``settings``, and ``inputs``, the SHA-256 of mechanism, places, values and settings. A
line of a cell has ``number``, its place in the map row by row, and ``motions``. Lines come in the order in
which cells were done.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

from trimmer.files import MAP
from trimmer.maps.cells import CellMotion, CellResult
from trimmer.maps.inputs import FORMAT, MapInputs, Settings
from trimmer.mechanism.mechanism import Mechanism
from trimmer.runners.record_file import Records, appended, cut

_MAPS = Records(
    kind=MAP,
    key="trimmer map",
    version=FORMAT,
    many="map",
    one="cell of a map",
    others={
        "mechanism": "another mechanism",
        "places": "other places to vary",
        "values": "other values",
        "settings": "other settings",
        "program": "another version of this program",
        "inputs": "other inputs",
    },
)


def begin(path: Path, inputs: MapInputs, *, overwrite: bool = False) -> None:
    """Write a file with the header alone; errors are those of ``Records.begin``."""
    _MAPS.begin(path, inputs.header, overwrite=overwrite)


def resumed(path: Path, inputs: MapInputs) -> list[CellResult]:
    """Return the cells that a file holds, and cut off what is half-written.

    Raises:
        MapFileError: if the file is not there, is none of a map, is damaged, or has other inputs.
    """
    results = []
    for line, data in _MAPS.entries(path, inputs.header):
        try:
            motions = tuple(CellMotion.from_data(each) for each in data["motions"])
            results.append(CellResult(range(inputs.count)[data["number"]], motions))
        except (ValueError, TypeError, KeyError, IndexError) as error:
            raise _MAPS.damaged(path, line) from error
    cut(path)
    return results


def append(path: Path, results: Iterable[CellResult]) -> Iterator[CellResult]:
    """Write results to the end of a file as they come, and yield them; see ``appended``."""
    return appended(path, results, _as_data)


def read_inputs(path: Path) -> MapInputs:
    """Return the inputs that a file of a map was made from.

    Raises:
        MapFileError: if the file is none of a map.
    """
    header = _MAPS.header(path)
    mechanism = Mechanism.from_toml_text(header["mechanism"], f"the mechanism in {path}")
    values = tuple(tuple(map(float, each)) for each in header["values"])
    return MapInputs(mechanism, tuple(header["places"]), values, Settings(**header["settings"]))


def _as_data(result: CellResult) -> dict[str, Any]:
    return {"number": result.number, "motions": [motion.as_data() for motion in result.motions]}
