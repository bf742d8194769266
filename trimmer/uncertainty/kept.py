"""The file of samples: a header with all that they depend on, then one line for each that is done.

Each line is JSON. The header is the first line, with the keys ``trimmer sample`` (the version of the format),
``program``, ``mechanism`` (its TOML file as text), ``places``, ``settings`` and ``inputs``, the SHA-256 of
mechanism, places, settings and values. A line of a sample has ``number``, ``kind``, ``period_count`` and
``measures``, a list in the order of ``asked`` in the header; null is no number. A line counts as soon as its
end is there, so what a killed run leaves half-written is dropped.
"""

from __future__ import annotations

import hashlib
import json
import math
import os
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from trimmer.design.trial import Asked, Trial, all_measures
from trimmer.errors import MapFileError
from trimmer.files import SAMPLES, FileWriteError, is_standard_output, is_stream, write_atomically
from trimmer.response.response import MotionKind

if TYPE_CHECKING:
    from trimmer.uncertainty.samples import SampleInputs

FORMAT = 1


@dataclass(frozen=True)
class Keeping:
    """Where samples are kept as soon as they are done.

    Attributes:
        path: The file; None to keep none.
        resume: Go on with it.
        overwrite: Replace it.
    """

    path: Path | None = None
    resume: bool = False
    overwrite: bool = False


NOWHERE = Keeping()


def header(inputs: SampleInputs) -> dict[str, Any]:
    """Return the header of the file of samples."""
    from trimmer import __version__

    settings = inputs.settings
    content = {
        "mechanism": inputs.mechanism.to_toml(),
        "places": list(inputs.uncertainty.places),
        "settings": {
            "count": len(inputs.values),
            "plan": settings.plan.word,
            "seed": settings.seed,
            "most_periods": settings.most_periods,
        },
        "asked": [[each.measure.name.lower(), each.part] for each in all_measures(inputs.mechanism)],
    }
    digest = hashlib.sha256(
        json.dumps(content, sort_keys=True).encode() + inputs.values.tobytes()
    ).hexdigest()
    return {"trimmer sample": FORMAT, "program": __version__, **content, "inputs": digest}


def begin(path: Path, inputs: SampleInputs, *, overwrite: bool = False) -> None:
    """Write a file with the header alone.

    Raises:
        MapFileError: if there are samples already, which would be lost, or a stream.
        FileWriteError: if the file cannot be written, or one of another kind is there.
    """
    if is_stream(path) or is_standard_output(path):
        raise MapFileError(f"{path} is a stream, with which no samples can go on: name a file")
    if not overwrite and path.is_file():
        with path.open("rb") as file:
            if SAMPLES.begins.match(file.read(64)):
                raise MapFileError(
                    f"{path} holds samples already: go on with them (--resume), or replace them (--overwrite)"
                )
    write_atomically(path, _line(header(inputs)), overwrite=overwrite)


def resumed(path: Path, inputs: SampleInputs, asked: tuple[Asked, ...]) -> Iterator[tuple[int, Trial]]:
    """Yield the samples that a file holds, after what is half-written was cut off.

    Raises:
        MapFileError: if the file is not there, is none of samples, is damaged, or has other inputs.
    """
    try:
        content = path.read_bytes()
    except OSError as error:
        raise MapFileError(f"{path} cannot be read: {error.strerror or error}") from error
    whole = content[: content.rfind(b"\n") + 1]
    lines = whole.splitlines()
    _check(path, lines[0] if lines else b"", header(inputs))
    with path.open("rb+") as file:
        file.truncate(len(whole))
    for at, line in enumerate(lines[1:], start=2):
        try:
            data = json.loads(line)
            number = range(len(inputs.values))[data["number"]]
            yield number, _trial(data, tuple(inputs.values[number].tolist()), asked)
        except (ValueError, TypeError, KeyError, IndexError) as error:
            raise MapFileError(
                f"{path}, line {at}: is no sample; take the line out to have the sample done again, or begin "
                "anew (--overwrite)"
            ) from error


def appended(path: Path, results: Iterable[tuple[int, Trial]]) -> Iterator[tuple[int, Trial]]:
    """Write results to the end of a file as they come, and yield them.

    Raises:
        FileWriteError: if one cannot be written, as when the disk is full.
    """
    with path.open("ab") as file:
        for number, trial in results:
            try:
                file.write(_line(_as_data(number, trial)).encode())
                file.flush()
            except OSError as error:
                raise FileWriteError(f"{path} cannot be written: {error.strerror or error}") from error
            yield number, trial
        os.fsync(file.fileno())


def _check(path: Path, line: bytes, wanted: dict[str, Any]) -> None:
    try:
        found = json.loads(line)
    except ValueError:
        found = None
    if not isinstance(found, dict) or "trimmer sample" not in found:
        raise MapFileError(f"{path} is no file of samples: name another one, or begin it anew (--overwrite)")
    for name, value in wanted.items():
        if found.get(name) != value:
            what = {"program": "another version of this program", "inputs": "other distributions"}
            raise MapFileError(
                f"{path} was begun with {what.get(name, f'another {name}')}: go on with what it was begun "
                "with, or begin it anew (--overwrite)"
            )


def _as_data(number: int, trial: Trial) -> dict[str, Any]:
    return {
        "number": number,
        "kind": None if trial.kind is None else trial.kind.word,
        "period_count": trial.period_count,
        "measures": [_to_json(value) for _, value in trial.measures],
    }


def _trial(data: dict[str, Any], values: tuple[float, ...], asked: tuple[Asked, ...]) -> Trial:
    kind = None if data["kind"] is None else MotionKind.chosen(data["kind"], "kind")
    measures = tuple(zip(asked, map(_from_json, data["measures"]), strict=True))
    return Trial(values, kind, data["period_count"], measures)


def _to_json(value: float) -> float | str | None:
    """Return a number as JSON knows it: infinity as a word, no number as null."""
    return value if math.isfinite(value) else None if math.isnan(value) else "infinite"


def _from_json(value: float | str | None) -> float:
    return math.nan if value is None else math.inf if value == "infinite" else float(value)


def _line(data: dict[str, Any]) -> str:
    return json.dumps(data, ensure_ascii=False, allow_nan=False) + "\n"
