"""The file of a map: a header with all that the cells depend on, then one line for each cell that is done.

Each line is JSON. The header is the first line. Its keys are ``trimmer map`` (the version of the format),
``program`` (the version of the program), ``mechanism`` (its TOML file as text), ``places``, ``values`` (a
list for each place), ``settings``, and ``inputs``, the SHA-256 of mechanism, places, values and settings. A
line of a cell has ``number``, its place in the map row by row, and ``motions``. Lines come in the order in
which cells were done. A line counts as soon as its line end is there, so what a killed run leaves
half-written is dropped.
"""

from __future__ import annotations

import json
import os
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

from trimmer.errors import MapFileError
from trimmer.files import MAP, FileWriteError, is_standard_output, is_stream, write_atomically
from trimmer.maps.cells import CellMotion, CellResult
from trimmer.maps.inputs import FORMAT, MapInputs, Settings
from trimmer.mechanism.mechanism import Mechanism

_OTHERS = {
    "mechanism": "another mechanism",
    "places": "other places to vary",
    "values": "other values",
    "settings": "other settings",
    "program": "another version of this program",
    "inputs": "other inputs",
}
"""What a file may have been begun with, by the key of its header."""


def begin(path: Path, inputs: MapInputs, *, overwrite: bool = False) -> None:
    """Write a file with the header alone.

    Raises:
        MapFileError: if there is a map already, which would be lost, or a stream.
        FileWriteError: if the file cannot be written, or one of another kind is there.
    """
    if is_stream(path) or is_standard_output(path):
        raise MapFileError(f"{path} is a stream, with which no map can go on: name a file")
    if not overwrite and path.is_file():
        with path.open("rb") as file:
            if MAP.begins.match(file.read(64)):
                raise MapFileError(
                    f"{path} is a map already: go on with it (--resume), or replace it (--overwrite)"
                )
    write_atomically(path, _line(inputs.header), overwrite=overwrite)


def resumed(path: Path, inputs: MapInputs) -> list[CellResult]:
    """Return the cells that a file holds, and cut off what is half-written.

    Raises:
        MapFileError: if the file is not there, is none of a map, is damaged, or has other inputs.
    """
    results = list(_results(path, inputs))
    with path.open("rb+") as file:
        file.truncate(_whole_length(file.read()))
    return results


def append(path: Path, results: Iterable[CellResult]) -> Iterator[CellResult]:
    """Write results to the end of a file as they come, and yield them.

    Raises:
        FileWriteError: if one cannot be written, as when the disk is full.
    """
    with path.open("ab") as file:
        for result in results:
            try:
                file.write(_line(_as_data(result)).encode())
                file.flush()
            except OSError as error:
                raise FileWriteError(f"{path} cannot be written: {error.strerror or error}") from error
            yield result
        os.fsync(file.fileno())


def read_inputs(path: Path) -> MapInputs:
    """Return the inputs that a file of a map was made from.

    Raises:
        MapFileError: if the file is none of a map.
    """
    header = _header(path, _lines(path))
    mechanism = Mechanism.from_toml_text(header["mechanism"], f"the mechanism in {path}")
    values = tuple(tuple(map(float, each)) for each in header["values"])
    return MapInputs(mechanism, tuple(header["places"]), values, Settings(**header["settings"]))


def _line(data: dict[str, Any]) -> str:
    return json.dumps(data, ensure_ascii=False, allow_nan=False) + "\n"


def _as_data(result: CellResult) -> dict[str, Any]:
    return {"number": result.number, "motions": [motion.as_data() for motion in result.motions]}


def _whole_length(content: bytes) -> int:
    return content.rfind(b"\n") + 1


def _lines(path: Path) -> list[bytes]:
    try:
        content = path.read_bytes()
    except OSError as error:
        raise MapFileError(f"{path} cannot be read: {error.strerror or error}") from error
    return content[: _whole_length(content)].splitlines()


def _header(path: Path, lines: list[bytes]) -> dict[str, Any]:
    try:
        header = json.loads(lines[0]) if lines else None
    except ValueError:
        header = None
    if not isinstance(header, dict) or "trimmer map" not in header:
        raise MapFileError(f"{path} is no file of a map: name another one, or begin it anew (--overwrite)")
    if header["trimmer map"] != FORMAT:
        raise MapFileError(
            f"{path} has format {header['trimmer map']!r} of the files of maps, but this program writes "
            f"{FORMAT}: begin it anew (--overwrite)"
        )
    return header


def _results(path: Path, inputs: MapInputs) -> Iterator[CellResult]:
    lines, wanted = _lines(path), inputs.header
    header = _header(path, lines)
    for name, what in _OTHERS.items():
        if header.get(name) != wanted[name]:
            raise MapFileError(
                f"{path} was begun with {what}: go on with what it was begun with, "
                "or begin it anew (--overwrite)"
            )
    for number, line in enumerate(lines[1:], start=2):
        try:
            data = json.loads(line)
            motions = tuple(CellMotion.from_data(each) for each in data["motions"])
            yield CellResult(range(inputs.count)[data["number"]], motions)
        except (ValueError, TypeError, KeyError, IndexError) as error:
            raise MapFileError(
                f"{path}, line {number}: is no cell of a map; take the line out to have the cell done again, "
                "or begin anew (--overwrite)"
            ) from error
