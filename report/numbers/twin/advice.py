"""What a designer is advised: each line a box of speed, friction and gap, searched for its worst motion.

The search tries the corners of the box, random points, and further ones around the worst; what it found is
kept with the code. A build tries the worst point again, and the corners of speed and friction at its gap.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import product
from typing import Any, Final, final

import numpy as np

from report.document.advice import NAME, Advice
from report.numbers.twin.kept_files import FOLDER, digest_of, read_kept, rounded, write_kept
from report.numbers.twin.mechanism import FORCE, GAP, SPEED, STIFFNESS, twin
from trimmer import MotionKind, respond
from trimmer.response.response_json import response_json

FILE: Final = FOLDER / NAME
RANDOM: Final = 120
"""Random points of a box, beside its corners."""
WORST: Final = 4
"""Points around which is looked further."""
NEAR: Final = 6
"""Points that are tried around each of them, in each round."""
REACHES: Final = (0.1, 0.02)
"""How far these lie away at most, in sizes of the box, round by round."""
STARTS: Final = 4
"""Starts from which the worst points are tried besides; the first of them is rest."""
SEED: Final = 30
DIGITS: Final = 5
STARTS_SUFFIX: Final = " from other starts"

REPEATS: Final = (MotionKind.PERIODIC.word,)
BOUNDED: Final = tuple(
    kind.word for kind in (MotionKind.PERIODIC, MotionKind.TORUS, MotionKind.CHAOTIC, MotionKind.UNDECIDED)
)
MOTOR: Final = "bodies.motor.rms_acceleration"
"""Root of the mean square acceleration of the motor, m/s²."""
STROKE: Final = "outputs.stroke.peak_to_peak"
PERIODS: Final = "period_count"

FORCE_OF_BRIDGE: Final = "contacts.bridge.largest_force"
NOMINAL: Final = {STIFFNESS: 30e3}
AROUND_110: Final = (104.5, 115.5)
AROUND_150: Final = (142.5, 157.5)
AROUND_155: Final = (147.25, 162.75)
"""Speeds and 5 % on either side, Hz."""
AROUND_HALF: Final = (0.25, 0.75)
"""Half a newton of friction, and half of that on either side, N."""
SCOPE: Final = "From rest, with 0.25 to 0.75 N of friction."
_regular = {SPEED: AROUND_155, FORCE: AROUND_HALF, GAP: (0.0, 150e-6)}
_soft = {SPEED: AROUND_110, FORCE: AROUND_HALF, GAP: (0.0, 500e-6), STIFFNESS: (4.5e3, 5.5e3)}
_near = {SPEED: AROUND_110, FORCE: AROUND_HALF, GAP: (0.0, 40e-6)}

LINES: Final = (
    Advice(
        "calm-speed",
        "Run at 143 to 157 Hz with a gap below 0.04 mm: the motor has at most 60 m/s².",
        SCOPE,
        True,
        NOMINAL,
        {SPEED: AROUND_150, FORCE: AROUND_HALF, GAP: (0.0, 40e-6)},
        MOTOR,
        (*REPEATS, MotionKind.TORUS.word),
        at_most=60.0,
    ),
    Advice(
        "calm-regular",
        "At 148 to 162 Hz the motion repeats with the drive at any gap up to 0.15 mm.",
        SCOPE,
        True,
        NOMINAL,
        _regular,
        PERIODS,
        REPEATS,
        at_most=1.0,
    ),
    Advice(
        "calm-stroke",
        "At 148 to 162 Hz the stroke is at least 3.1 mm at any gap up to 0.15 mm.",
        SCOPE,
        True,
        NOMINAL,
        _regular,
        STROKE,
        REPEATS,
        at_least=3.1e-3,
    ),
    Advice(
        "soft-motor",
        "At 105 to 115 Hz take a bridge of 5 kN/m instead of 30: the motor has at most 50 m/s² at any gap up "
        "to 0.5 mm.",
        SCOPE,
        True,
        {},
        _soft,
        MOTOR,
        REPEATS,
        at_most=50.0,
    ),
    Advice(
        "soft-force",
        "At 105 to 115 Hz a bridge of 5 kN/m pushes the cutter with at most 2.4 N at any gap up to 0.5 mm.",
        SCOPE,
        True,
        {},
        _soft,
        FORCE_OF_BRIDGE,
        REPEATS,
        at_most=2.4,
    ),
    Advice(
        "little-friction",
        "If it has to be 105 to 115 Hz with the bridge as it is, keep friction below 0.25 N and the gap "
        "below 0.04 mm: the motor has at most 75 m/s².",
        "From rest, from 0.05 N of friction on.",
        True,
        NOMINAL,
        _near | {FORCE: (0.05, 0.25)},
        MOTOR,
        BOUNDED,
        at_most=75.0,
    ),
    Advice(
        "nominal",
        "Run at 105 to 115 Hz with the bridge as it is: even with a gap below 0.04 mm the motor may have "
        "230 m/s², though never more than 260.",
        SCOPE,
        False,
        NOMINAL,
        _near,
        MOTOR,
        BOUNDED,
        at_most=260.0,
    ),
)
"""What is advised, in the order of the first screen."""


@final
@dataclass(frozen=True)
class Tried:
    """A point of a box, in the order of its places, and what the motion from there is.

    Attributes:
        point: Values of the places, SI units.
        kind: Word of the kind of motion.
        value: The measure; None if the motion has none.
    """

    point: tuple[float, ...]
    kind: str
    value: float | None


@final
@dataclass(frozen=True)
class Searched:
    """A line of advice and what a search of its box found.

    Attributes:
        line: The line.
        tried: The points from rest.
        starts: The worst points from ``STARTS`` starts; of each the worst motion.
        again: Points that this build has tried.
    """

    line: Advice
    tried: tuple[Tried, ...]
    starts: tuple[Tried, ...]
    again: tuple[Tried, ...] = ()

    @property
    def worst(self) -> Tried:
        """The point nearest to the bound, or furthest beyond it."""
        return min(self.tried, key=lambda each: spare(self.line, each))

    @property
    def worst_of_starts(self) -> Tried:
        """The same of all starts."""
        return min(self.starts, key=lambda each: spare(self.line, each))

    @property
    def holds(self) -> bool:
        """Whether all points, also those tried again, are as the line says."""
        return all(self.line.holds(each.kind, each.value) for each in (*self.tried, *self.again))

    @property
    def kinds(self) -> Mapping[str, int]:
        """How many points have a kind of motion, by its word."""
        return Counter(each.kind for each in self.tried)


def spare(line: Advice, tried: Tried) -> float:
    """Return what is left to the bound, as a share of it; minus infinity for a kind that may not occur."""
    if tried.kind not in line.kinds or tried.value is None:
        return -np.inf
    low = np.inf if line.at_least is None else tried.value / line.at_least - 1
    high = np.inf if line.at_most is None else 1 - tried.value / line.at_most
    return float(min(low, high))


def attempt(line: Advice, point: tuple[float, ...], starts: int = 1) -> Tried:
    """Return what ``trimmer respond`` finds at a point; of several starts the motion nearest to the bound."""
    mechanism = twin()
    for place, value in (*line.fixed.items(), *zip(line.over, point, strict=True)):
        mechanism = mechanism.with_value(place, value)
    found = response_json(respond(mechanism, starts=starts, seed=SEED))
    motions = [found] if starts == 1 else found["motions"]
    tried = (Tried(point, each["kind"], _measured(each, line.measure)) for each in motions)
    return min(tried, key=lambda each: spare(line, each))


def search(line: Advice) -> Searched:
    """Look for the worst motion in the box of a line."""
    low, high = np.array(list(line.over.values())).T
    draw = np.random.default_rng(SEED)
    corners = np.array(list(product((0.0, 1.0), repeat=len(low))))
    shares = np.vstack([corners, draw.random((RANDOM, len(low)))])
    tried: list[Tried] = []
    for reach in (*REACHES, None):
        points = [tuple(map(float, each)) for each in low + np.clip(shares, 0, 1) * (high - low)]
        tried += [attempt(line, tuple(rounded(value) or 0.0 for value in point)) for point in points]
        if reach is not None:
            worst = sorted(tried, key=lambda each: spare(line, each))[:WORST]
            centres = (np.array([each.point for each in worst]) - low) / (high - low)
            moves = reach * draw.uniform(-1, 1, (WORST, NEAR, len(low)))
            shares = (centres[:, None, :] + moves).reshape(-1, len(low))
    worst = sorted(tried, key=lambda each: spare(line, each))[:WORST]
    return Searched(line, tuple(tried), tuple(attempt(line, each.point, STARTS) for each in worst))


def tried_again(searched: Searched) -> Searched:
    """Try the worst point of a search again, and the corners of speed and friction at its gap."""
    line, worst = searched.line, searched.worst.point
    ends = (
        ends if place in (SPEED, FORCE) else (at,)
        for (place, ends), at in zip(line.over.items(), worst, strict=True)
    )
    again = tuple(attempt(line, point) for point in {worst: None, **dict.fromkeys(product(*ends))})
    return Searched(line, searched.tried, searched.starts, again)


def write_advice(found: Sequence[Searched]) -> None:
    """Keep what was searched, a line of the file for each point."""
    content = {
        f"{each.line.id}{name}": [_row(tried) for tried in rows]
        for each in found
        for name, rows in (("", each.tried), (STARTS_SUFFIX, each.starts))
    }
    write_kept(FILE, inputs_of([each.line for each in found]), content)


def read_advice(lines: Sequence[Advice]) -> tuple[Searched, ...]:
    """Return what was searched.

    Raises:
        KeptDataError: if the file is not there, was made from other lines, or has been changed since.
    """
    content = read_kept(FILE, inputs_of(lines))
    rows = ((line, content[line.id], content[f"{line.id}{STARTS_SUFFIX}"]) for line in lines)
    return tuple(Searched(line, tuple(_tried(rows)), tuple(_tried(starts))) for line, rows, starts in rows)


def inputs_of(lines: Sequence[Advice]) -> str:
    """Return the SHA-256 of the machine, of the boxes with their bounds, and of how they are searched."""
    boxes = [line.told() | {"text": line.id} for line in lines]
    machine = [twin().to_toml(), RANDOM, WORST, NEAR, list(REACHES), STARTS, SEED]
    return digest_of([boxes, machine])


def _measured(found: Mapping[str, Any], measure: str) -> float | None:
    value: Any = found
    for key in measure.split("."):
        value = value.get(key) if isinstance(value, Mapping) else None
    return None if value is None else float(value)


def _row(tried: Tried) -> list[Any]:
    return [*tried.point, tried.kind, rounded(tried.value, DIGITS)]


def _tried(rows: Sequence[Sequence[Any]]) -> Iterator[Tried]:
    return (Tried(tuple(point), kind, value) for *point, kind, value in rows)
