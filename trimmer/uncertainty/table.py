"""The table ``[uncertainty]`` of a file: how numbers of a mechanism or a loop scatter."""

from collections.abc import Iterator, Mapping
from typing import Any, Protocol

import numpy as np

from trimmer.errors import MechanismError, UncertaintyError
from trimmer.mechanism.place_text import parse_place, place_text
from trimmer.mechanism.problems import Problem, in_one
from trimmer.mechanism.quantities import if_plain, is_number
from trimmer.mechanism.units import UnitError, quantity
from trimmer.messages import listed, near_match, near_or_all
from trimmer.uncertainty.distributions import (
    Distribution,
    JointScatter,
    Normal,
    Scatter,
    Uncertainty,
    Uniform,
)

SECTION = "uncertainty"
COVARIANCE = "covariance"
_SHORT: Mapping[str, str] = {}
FORMS = '{ normal = "5 um" }, { normal = "5 %" } or { uniform = ["20 um", "60 um"] }'


class Numbers(Protocol):
    """Anything with numbers at dotted places, such as a mechanism or a loop."""

    @property
    def places(self) -> Mapping[str, str]:
        """The SI unit of each place."""
        ...

    def value(self, place: str) -> float:
        """Return the number at a place, in that unit."""
        ...


def uncertainty_from(subject: Numbers, table: Mapping[str, object]) -> Uncertainty:
    """Return how numbers of a mechanism or a loop scatter, in the words of a file.

    Args:
        subject: The mechanism or loop, whose own numbers are the means that are not given.
        table: What would stand in ``[uncertainty]``, such as ``{"element.gap": {"normal": "5 um"}}``.

    Raises:
        UncertaintyError: if there is no such number, or it cannot scatter so; every problem is named.
    """
    problems: list[Problem] = []
    uncertainty = uncertainty_of(table, subject, problems)
    if not uncertainty.scatters and not problems:
        problems.append(Problem((SECTION,), f"nothing scatters: say what does, as in {FORMS}"))
    if problems:
        raise UncertaintyError(in_one([each.sentence() for each in problems], "what scatters"))
    return uncertainty


def uncertainty_of(
    content: object,
    mechanism: Numbers,
    problems: list[Problem],
    known: tuple[Scatter, ...] = (),
    short: Mapping[str, str] = _SHORT,
) -> Uncertainty:
    """Read what scatters; what cannot be used is added to the problems.

    Means that are not given are the mechanism's own numbers. Some scatter without being in the table,
    such as ranges of what nobody knows.
    """
    if not isinstance(content, Mapping):
        reason = f"is a section: write [{SECTION}] on a line of its own"
        problems.append(Problem((SECTION,), reason, content))
        return Uncertainty(())
    found: dict[str, Scatter] = {}
    joints: list[JointScatter] = []
    for key, value in content.items():
        if key == COVARIANCE:
            for joint, scatters in _joints(value, mechanism, problems, short):
                joints.append(joint)
                _add(found, scatters, (SECTION, COVARIANCE), problems)
        elif (place := _place((SECTION, key), key, mechanism, problems, short)) is not None:
            distribution = _distribution((SECTION, key), place, value, mechanism, problems)
            if distribution is not None:
                scatter = Scatter(place, mechanism.places[place], distribution)
                _add(found, [scatter], (SECTION, key), problems)
    others = (each for each in known if each.place not in found)
    return Uncertainty((*found.values(), *others), tuple(joints))


def _add(
    found: dict[str, Scatter], scatters: list[Scatter], place: tuple[str, ...], problems: list[Problem]
) -> None:
    for each in scatters:
        if each.place in found:
            problems.append(Problem(place, f"{each.place} scatters twice; say it once"))
        found[each.place] = each


def _place(
    where: tuple[str, ...],
    text: object,
    mechanism: Numbers,
    problems: list[Problem],
    short: Mapping[str, str],
) -> str | None:
    try:
        place = place_text(parse_place(short.get(str(text), str(text))))
    except MechanismError as error:
        problems.append(Problem(where, str(error)))
        return None
    if place in mechanism.places:
        return place
    problems.append(Problem(where, f"there is no number {place!r}; {near_or_all(place, mechanism.places)}"))
    return None


def _distribution(
    where: tuple[str, ...], place: str, value: object, mechanism: Numbers, problems: list[Problem]
) -> Distribution | None:
    if not isinstance(value, Mapping):
        problems.append(Problem(where, f"say how it scatters, as in {FORMS}", value))
        return None
    reader = _DistributionReader(where, mechanism.places[place], mechanism.value(place), problems)
    unknown = [key for key in value if key not in ("normal", "mean", "uniform")]
    if unknown:
        advice = near_match(unknown[0], ("normal", "mean", "uniform")) or f"write {FORMS}"
        problems.append(Problem((*where, unknown[0]), f"unknown key; {advice}"))
        return None
    if ("normal" in value) == ("uniform" in value) or ("mean" in value and "uniform" in value):
        problems.append(Problem(where, f"say how it scatters in one way, as in {FORMS}"))
        return None
    return reader.uniform(value["uniform"]) if "uniform" in value else reader.normal(value)


class _DistributionReader:
    """Reads a distribution at a place of the file, in an SI unit; what is wrong goes to the problems."""

    def __init__(self, where: tuple[str, ...], unit: str, nominal: float, problems: list[Problem]) -> None:
        self._where, self._unit, self._nominal, self._problems = where, unit, nominal, problems

    def normal(self, value: Mapping[str, Any]) -> Normal | None:
        """Read a standard deviation, and a mean if there is one."""
        mean = self._number("mean", value["mean"]) if "mean" in value else self._nominal
        if mean is None:
            return None
        deviation = self._number("normal", value["normal"], of=mean)
        if deviation is None:
            return None
        if deviation <= 0:
            self._wrong("normal", "a standard deviation is positive", value["normal"])
        return Normal(mean, deviation)

    def uniform(self, value: object) -> Uniform | None:
        """Read both ends, or how far they lie from the number in the file."""
        if isinstance(value, str) and value.strip().endswith("%"):
            half = self._number("uniform", value, of=self._nominal)
            ends: tuple[float | None, float | None] = (
                (None, None) if half is None else (self._nominal - half, self._nominal + half)
            )
        elif isinstance(value, list) and len(value) == 2:
            ends = (self._number("uniform", value[0]), self._number("uniform", value[1]))
        else:
            self._wrong("uniform", 'give both ends, as in ["20 um", "60 um"], or "10 %"', value)
            return None
        if ends[0] is None or ends[1] is None:
            return None
        if not ends[0] < ends[1]:
            self._wrong("uniform", "the first end is the smaller one", value)
        return Uniform(ends[0], ends[1])

    def _number(self, key: str, value: object, of: float | None = None) -> float | None:
        """Read a number in the SI unit, as text with a unit, or as a share of another number."""
        text = value.strip() if isinstance(value, str) else ""
        try:
            if of is not None and text.endswith("%"):
                return quantity(text[:-1], "1") / 100.0 * abs(of)
            if text:
                return quantity(text, self._unit)
        except UnitError as error:
            self._wrong(key, f"{error}", value)
            return None
        if is_number(value) and np.isfinite(float(value)):  # type: ignore[arg-type]
            return float(value)  # type: ignore[arg-type]
        self._wrong(key, f"give a number in {self._unit}, or text with a unit", value)
        return None

    def _wrong(self, key: str, reason: str, value: object) -> None:
        self._problems.append(Problem((*self._where, key), reason, if_plain(value)))


def _joints(
    value: object, mechanism: Numbers, problems: list[Problem], short: Mapping[str, str]
) -> Iterator[tuple[JointScatter, list[Scatter]]]:
    where = (SECTION, COVARIANCE)
    for each in value if isinstance(value, list) else [value]:
        if not isinstance(each, Mapping) or set(each) != {"places", "matrix"} or not _is_list(each["places"]):
            reason = 'write { places = ["plays.bridge.gap", "bodies.cutter.mass"], matrix = [[...], [...]] }'
            problems.append(Problem(where, reason))
            continue
        places = [_place(where, text, mechanism, problems, short) for text in each["places"]]
        if None in places:
            continue
        names = tuple(place for place in places if place is not None)
        if reason := _reason_against(each["matrix"], names):
            problems.append(Problem((*where, "matrix"), reason))
            continue
        matrix = np.array(each["matrix"], dtype=float)
        scatters = [
            Scatter(place, mechanism.places[place], Normal(mechanism.value(place), float(deviation)))
            for place, deviation in zip(names, np.sqrt(np.diag(matrix)), strict=True)
        ]
        yield JointScatter(names, tuple(map(tuple, matrix.tolist()))), scatters


def _is_list(value: object) -> bool:
    return isinstance(value, list) and len(value) > 0


def _reason_against(matrix: object, places: tuple[str, ...]) -> str:
    """Return why something is no covariance matrix; empty if it is one."""
    count = len(places)
    rows = matrix if isinstance(matrix, list) else []
    if len(rows) != count or any(not isinstance(row, list) or len(row) != count for row in rows):
        return f"give {count} rows of {count} numbers, one for each of {listed(places)}"
    if not all(is_number(entry) and np.isfinite(float(entry)) for row in rows for entry in row):
        return "give numbers, in products of SI units"
    values = np.array(rows, dtype=float)
    scale = np.sqrt(np.abs(np.diag(values)))
    if not (np.diag(values) > 0).all():
        return "variances, on the diagonal, are positive"
    if not np.allclose(values, values.T, rtol=1e-9, atol=0.0):
        return "a covariance matrix is symmetric"
    if np.linalg.eigvalsh(values / np.outer(scale, scale)).min() < -1e-9:
        return "no numbers scatter like this: a correlation would exceed 1"
    return ""
