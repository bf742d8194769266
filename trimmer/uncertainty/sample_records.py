"""The file of samples: a header with all that they depend on, then one line for each that is done.

See ``trimmer.runners.record_file``. The header has the keys ``trimmer sample`` (the version of the format),
``program``, ``mechanism`` (its TOML file as text, or a loop as data), ``places``, ``settings`` and
``inputs``, the SHA-256 of mechanism, places, settings and values. A line of a sample has ``number``,
``kind``, ``period_count`` and ``measures``, a list in the order of ``asked`` in the header; null is no
number.
"""

import hashlib
import json
import math
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path

from trimmer.design.specification.targets import Measure
from trimmer.design.trials.trial import MeasureOfPart, Trial
from trimmer.files import SAMPLES
from trimmer.json_data import DataError, typed
from trimmer.maps.inputs import described
from trimmer.messages import shown_value
from trimmer.response.results.response import MotionKind
from trimmer.runners.record_file import RecordFile, appended, cut
from trimmer.uncertainty.sample_inputs import SampleInputs

FORMAT = 1
_SAMPLES = RecordFile(
    kind=SAMPLES,
    key="trimmer sample",
    version=FORMAT,
    many="samples",
    one="sample",
    others={
        "mechanism": "another mechanism or loop",
        "places": "other numbers that scatter",
        "settings": "other settings",
        "program": "another version of this program",
        "inputs": "other distributions",
    },
)


@dataclass(frozen=True)
class Keeping:
    """The file in which samples are kept as soon as they are done.

    Attributes:
        path: The file; None to keep none.
        resume: Go on with it.
        overwrite: Replace it.
    """

    path: Path | None = None
    resume: bool = False
    overwrite: bool = False


NOWHERE = Keeping()


def header(inputs: SampleInputs) -> dict[str, object]:
    """Return the header of the file of samples."""
    from trimmer import __version__

    settings = inputs.settings
    content = {
        "mechanism": described(inputs.subject),
        "places": list(inputs.uncertainty.places),
        "settings": {
            "count": len(inputs.values),
            "plan": settings.plan.word,
            "seed": settings.seed,
            "most_periods": settings.most_periods,
        },
        "asked": [[each.measure.name.lower(), each.part] for each in inputs.asked],
    }
    digest = hashlib.sha256(
        json.dumps(content, sort_keys=True).encode() + inputs.values.tobytes()
    ).hexdigest()
    return {"trimmer sample": FORMAT, "program": __version__, **content, "inputs": digest}


def begin(path: Path, inputs: SampleInputs, *, overwrite: bool = False) -> None:
    """Write a file with the header alone; errors are those of ``RecordFile.begin``."""
    _SAMPLES.begin(path, header(inputs), overwrite=overwrite)


def resumed(path: Path, inputs: SampleInputs) -> dict[int, Trial]:
    """Return the samples that a file holds by their numbers, and cut off what is half-written."""
    results: dict[int, Trial] = {}
    for line, data in _SAMPLES.entries(path, header(inputs)):
        try:
            said = typed(_Kept, data)
            if said.number in results:
                raise DataError(f"number is {said.number}, as in a line before")
            results[said.number] = _trial(said, inputs, inputs.asked)
        except DataError as error:
            raise _SAMPLES.damaged(path, line, error) from error
    cut(path)
    return results


def append(path: Path, results: Iterable[tuple[int, Trial]]) -> Iterator[tuple[int, Trial]]:
    """Write results to the end of a file as they come, and yield them; see ``appended``."""
    return appended(path, results, _as_data)


def _as_data(result: tuple[int, Trial]) -> dict[str, object]:
    number, trial = result
    return {
        "number": number,
        "kind": None if trial.kind is None else trial.kind.word,
        "period_count": trial.period_count,
        "measures": [_to_json(value) for _, value in trial.measures],
    }


@dataclass(frozen=True)
class _Kept:
    """A line of a sample."""

    number: int
    kind: MotionKind | None
    period_count: int | None
    measures: tuple[float | str | None, ...]


def _trial(said: _Kept, inputs: SampleInputs, asked: tuple[MeasureOfPart, ...]) -> Trial:
    if not 0 <= said.number < len(inputs.values):
        raise DataError(f"number is {said.number}, and there are {len(inputs.values)} samples, from 0 on")
    if len(said.measures) != len(asked):
        raise DataError(f"measures has {len(said.measures)} entries, not {len(asked)}")
    values = tuple(inputs.values[said.number].tolist())
    trial = Trial(
        values, said.kind, said.period_count, tuple(zip(asked, map(_from_json, said.measures), strict=True))
    )
    problem = _problem(trial)
    if problem:
        raise DataError(problem)
    return trial


def _problem(trial: Trial) -> str:
    """Say what cannot be together in a trial; empty if all can."""
    count = trial.period_count
    if count is not None and (count < 1 or trial.kind is None):
        return f"period_count is {count}, which does not fit kind"
    for asked, value in trial.measures:
        if trial.kind is None and not math.isnan(value):
            return f"a measure is {value:g}, where the motion failed"
        if asked.measure is Measure.PERIOD and trial.kind is not None and value != (count or math.inf):
            return f"the period is {value:g}, which is not period_count"
        if asked.measure is not Measure.WEAR_POWER and value < 0.0:  # that may round to less than nothing
            return f"a measure is {value:g}, which is no size of it"
    return ""


def _to_json(value: float) -> float | str | None:
    """Return a number as JSON knows it: infinity as a word, no number as null."""
    return value if math.isfinite(value) else None if math.isnan(value) else "infinite"


def _from_json(value: float | str | None) -> float:
    if isinstance(value, str):
        if value != "infinite":
            raise DataError(f"a measure is {shown_value(value)}, and the only word there is infinite")
        return math.inf
    return math.nan if value is None else value
