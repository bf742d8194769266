"""What a designer is advised: each line a box of speed, friction and gap, searched for its worst motion.

The search tries the corners of the box, random points inside of it and on its faces and edges, and further
ones around the worst. From the worst that repeat it climbs by ever smaller moves; the worst that it found are
kept with the code. A build tries the worst point again, and the corners of speed and friction at its gap.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import product
from typing import Any, Final, final

import numpy as np

from report.document.advice import NAME, Advice, Bound
from report.numbers.twin.kept_files import FOLDER, digest_of, read_kept, rounded, write_kept
from report.numbers.twin.mechanism import FORCE, GAP, SPEED, STIFFNESS, twin
from trimmer import MotionKind, respond
from trimmer.arrays import Reals
from trimmer.response.results.response_json import response_json

FILE: Final = FOLDER / NAME
RANDOM: Final = 5
"""Random points of a box beside its corners, to the power of how many numbers it varies."""
OUTSIDE: Final = 0.25
"""How far beyond each side they are drawn, in sizes of the box; from outside they move onto it."""
WORST: Final = 6
"""Points nearest to each bound; around these is looked further, and they are kept."""
NEAR: Final = 2
"""Points that are tried around each of them in each round, to the same power."""
REACHES: Final = (0.2, 0.1, 0.05, 0.02, 0.01, 0.005)
"""How far these lie away at most, in sizes of the box, round by round."""
CLIMBED: Final = 3
"""Worst motions that repeat, of each bound, from which is climbed."""
MOVES: Final = (0.03, 0.01, 0.003, 0.001)
"""Lengths of the moves of a climb, in sizes of the box: along each number, and as many at random."""
MOST_MOVES: Final = 12
"""Most moves of a length."""
STARTS: Final = 4
"""Starts from which the worst points are tried besides; the first of them is rest."""
SEED: Final = 30
DIGITS: Final = 5
STARTS_SUFFIX: Final = " from other starts"
KINDS_SUFFIX: Final = " by kind"

REPEATS: Final = (MotionKind.PERIODIC.word,)
BOUNDED: Final = tuple(
    kind.word for kind in (MotionKind.PERIODIC, MotionKind.TORUS, MotionKind.CHAOTIC, MotionKind.UNDECIDED)
)
MOTOR: Final = "bodies.motor.rms_acceleration"
HOUSING: Final = "bodies.housing.rms_acceleration"
"""Roots of the mean square accelerations, m/s²."""
STROKE: Final = "outputs.stroke.peak_to_peak"
PERIODS: Final = "period_count"
FORCE_OF_BRIDGE: Final = "contacts.bridge.largest_force"
IMPACT: Final = "contacts.bridge.impact_speed"
"""Largest speed at which pin and slot meet, m/s."""
NOMINAL: Final = {STIFFNESS: 30e3}
AROUND_110: Final = (104.5, 115.5)
AROUND_150: Final = (142.5, 157.5)
AROUND_155: Final = (147.25, 162.75)
"""Speeds and 5 % on either side, Hz."""
AROUND_HALF: Final = (0.25, 0.75)
"""Half a newton of friction, and half of that on either side, N."""
SCOPE: Final = "From rest, with 0.25 to 0.75 N of friction."
_near = {SPEED: AROUND_110, FORCE: AROUND_HALF, GAP: (0.0, 40e-6)}

LINES: Final = (
    Advice(
        "calm",
        "Run at 143 to 157 Hz with a gap below 0.04 mm",
        SCOPE,
        True,
        NOMINAL,
        {SPEED: AROUND_150, FORCE: AROUND_HALF, GAP: (0.0, 40e-6)},
        (*REPEATS, MotionKind.TORUS.word),
        (
            Bound("motor at most 60 m/s²", MOTOR, at_most=60.0),
            Bound("housing at most 20 m/s²", HOUSING, at_most=20.0),
            Bound("impacts at most 0.2 m/s", IMPACT, at_most=0.2),
        ),
    ),
    Advice(
        "regular",
        "Run at 148 to 162 Hz with a gap up to 0.15 mm",
        SCOPE,
        True,
        NOMINAL,
        {SPEED: AROUND_155, FORCE: AROUND_HALF, GAP: (0.0, 150e-6)},
        REPEATS,
        (
            Bound("it repeats with the drive", PERIODS, at_most=1.0),
            Bound("stroke at least 3.1 mm", STROKE, at_least=3.1e-3),
        ),
    ),
    Advice(
        "soft",
        "At 105 to 115 Hz take a bridge of 5 kN/m instead of 30, with a gap up to 0.5 mm",
        SCOPE,
        True,
        {},
        {SPEED: AROUND_110, FORCE: AROUND_HALF, GAP: (0.0, 500e-6), STIFFNESS: (4.5e3, 5.5e3)},
        BOUNDED,
        (
            Bound("motor at most 50 m/s²", MOTOR, at_most=50.0),
            Bound("housing at most 20 m/s²", HOUSING, at_most=20.0),
            Bound("impacts at most 0.5 m/s", IMPACT, at_most=0.5),
            Bound("bridge at most 3 N", FORCE_OF_BRIDGE, at_most=3.0),
        ),
    ),
    Advice(
        "little-friction",
        "At 105 to 115 Hz with the bridge as it is, keep friction below 0.25 N and the gap below 0.04 mm",
        "From rest, from 0.05 N of friction on.",
        True,
        NOMINAL,
        _near | {FORCE: (0.05, 0.25)},
        BOUNDED,
        (Bound("motor at most 75 m/s²", MOTOR, at_most=75.0),),
    ),
    Advice(
        "nominal",
        "Run at 105 to 115 Hz with the bridge as it is, even with a gap below 0.04 mm",
        SCOPE,
        False,
        NOMINAL,
        _near,
        BOUNDED,
        (Bound("the motor may reach 230 m/s², at most 260", MOTOR, at_most=260.0),),
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
        values: What each bound is of, in their order; None where the motion has no such number.
    """

    point: tuple[float, ...]
    kind: str
    values: tuple[float | None, ...]


@final
@dataclass(frozen=True)
class Searched:
    """A line of advice and what a search of its box found.

    Attributes:
        line: The line.
        kinds: How many points have a kind of motion from rest, by its word.
        worst: Those nearest to each bound.
        starts: The motions that ``STARTS`` starts led to at the worst points.
        again: Points that this build has tried.
    """

    line: Advice
    kinds: Mapping[str, int]
    worst: tuple[Tried, ...]
    starts: tuple[Tried, ...]
    again: tuple[Tried, ...] = ()

    @property
    def holds(self) -> bool:
        """Whether all points, also those tried again, are as the line says."""
        known = set(self.kinds) <= set(self.line.kinds)
        return known and all(holds(self.line, each) for each in (*self.worst, *self.again))


def spare(line: Advice, number: int, tried: Tried) -> float:
    """Return what is left to a bound, as a share of it; minus infinity for a kind that may not occur."""
    return line.bounds[number].spare(tried.values[number]) if tried.kind in line.kinds else -np.inf


def holds(line: Advice, tried: Tried) -> bool:
    """Return whether a motion is as the line says."""
    return all(spare(line, number, tried) >= 0 for number in range(len(line.bounds)))


def nearest(line: Advice, number: int, tried: Sequence[Tried]) -> list[Tried]:
    """Return what was tried in the order of what is left to a bound, the worst first."""
    return sorted(tried, key=lambda each: spare(line, number, each))


def attempt(line: Advice, point: tuple[float, ...], starts: int = 1) -> list[Tried]:
    """Return what ``trimmer respond`` finds at a point; of several starts all motions."""
    mechanism = twin()
    for place, value in (*line.fixed.items(), *zip(line.over, point, strict=True)):
        mechanism = mechanism.with_value(place, value)
    found = response_json(respond(mechanism, starts=starts, seed=SEED))
    motions = [found] if starts == 1 else found["motions"]
    return [
        Tried(point, each["kind"], tuple(_measured(each, bound.measure) for bound in line.bounds))
        for each in motions
    ]


def search(line: Advice) -> Searched:
    """Look for the worst motion in the box of a line."""
    low, high = np.array(list(line.over.values())).T
    draw = np.random.default_rng(SEED)
    corners = np.array(list(product((0.0, 1.0), repeat=len(low))))
    shares = np.vstack([corners, draw.uniform(-OUTSIDE, 1 + OUTSIDE, (RANDOM ** len(low), len(low)))])
    tried: dict[tuple[float, ...], Tried] = {}
    for reach in (*REACHES, None):
        for point in (_point(line, each) for each in shares):
            if point not in tried:
                (tried[point],) = attempt(line, point)
        found = list(tried.values())
        if reach is not None:
            centres = (np.array([each.point for each in _worst(line, found, WORST)]) - low) / (high - low)
            moves = reach * draw.uniform(-1, 1, (len(centres), NEAR ** len(low), len(low)))
            shares = (centres[:, None, :] + moves).reshape(-1, len(low))
    worst = _worst(line, found, WORST)
    others = (attempt(line, each.point, STARTS) for each in worst)
    kinds = Counter(each.kind for each in found)
    return Searched(line, kinds, worst, tuple(each for found in others for each in found))


def _point(line: Advice, shares: Reals) -> tuple[float, ...]:
    """Return the values at shares of the ranges; from outside of the box they move onto it."""
    low, high = np.array(list(line.over.values())).T
    return tuple(rounded(float(value)) or 0.0 for value in low + np.clip(shares, 0, 1) * (high - low))


def climbed(searched: Searched) -> Searched:
    """Go from the worst motions that repeat to worse ones; means of others scatter, and are left alone."""
    line, draw = searched.line, np.random.default_rng(SEED)
    tried = {each.point: each for each in searched.worst}
    for number in range(len(line.bounds)):
        for start in nearest(line, number, _repeating(searched.worst))[:CLIMBED]:
            _climb(line, number, start, tried, draw)
    new = [each for each in tried.values() if each not in searched.worst]
    worst = _worst(line, list(tried.values()), WORST)
    kept = [each for each in searched.starts if each.point in {one.point for one in worst}]
    more = [found for each in worst if each in new for found in attempt(line, each.point, STARTS)]
    kinds = Counter(searched.kinds) + Counter(each.kind for each in new)
    return Searched(line, kinds, worst, (*kept, *more))


def _climb(
    line: Advice, number: int, worst: Tried, tried: dict[tuple[float, ...], Tried], draw: np.random.Generator
) -> None:
    """Go from a motion nearer to a bound, as long as each length of the moves leads on; add what is tried."""
    low, high = np.array(list(line.over.values())).T
    for reach in MOVES:
        for _ in range(MOST_MOVES):
            moves = np.vstack([np.eye(len(low)), draw.normal(size=(len(low), len(low)))])
            moves *= reach / np.linalg.norm(moves, axis=1, keepdims=True)
            here = (np.array(worst.point) - low) / (high - low)
            around = [_point(line, each) for each in (*(here + moves), *(here - moves))]
            for point in around:
                if point not in tried:
                    (tried[point],) = attempt(line, point)
            before, repeating = worst, _repeating([tried[each] for each in around])
            worst = nearest(line, number, [worst, *repeating])[0]
            if worst is before:
                break


def _repeating(tried: Iterable[Tried]) -> list[Tried]:
    return [each for each in tried if each.kind in REPEATS]


def _worst(line: Advice, tried: Sequence[Tried], count: int = 1) -> tuple[Tried, ...]:
    """Return what was tried nearest to each bound, so many of each, none twice."""
    worst = (each for number in range(len(line.bounds)) for each in nearest(line, number, tried)[:count])
    return tuple(dict.fromkeys(worst))


def tried_again(searched: Searched) -> Searched:
    """Try the worst points of a search again, and the corners of speed and friction at their gaps."""
    line = searched.line
    worst = [each.point for each in _worst(line, searched.worst)]
    corners = (
        corner
        for point in worst
        for corner in product(
            *(
                ends if place in (SPEED, FORCE) else (at,)
                for (place, ends), at in zip(line.over.items(), point, strict=True)
            )
        )
    )
    again = [each for point in dict.fromkeys((*worst, *corners)) for each in attempt(line, point)]
    return replace(searched, again=tuple(again))


def write_advice(found: Sequence[Searched]) -> None:
    """Keep what was searched, a line of the file for each point that is kept."""
    content = {
        f"{each.line.id}{name}": rows
        for each in found
        for name, rows in (
            (KINDS_SUFFIX, each.kinds),
            ("", [_row(tried) for tried in each.worst]),
            (STARTS_SUFFIX, [_row(tried) for tried in each.starts]),
        )
    }
    write_kept(FILE, inputs_of([each.line for each in found]), content)


def read_advice(lines: Sequence[Advice]) -> tuple[Searched, ...]:
    """Return what was searched.

    Raises:
        KeptDataError: if the file is not there, was made from other lines, or has been changed since.
    """
    content = read_kept(FILE, inputs_of(lines))
    return tuple(
        Searched(
            line,
            content[f"{line.id}{KINDS_SUFFIX}"],
            tuple(_tried(content[line.id])),
            tuple(_tried(content[f"{line.id}{STARTS_SUFFIX}"])),
        )
        for line in lines
    )


def inputs_of(lines: Sequence[Advice]) -> str:
    """Return the SHA-256 of the machine, of the boxes with their bounds, and of how they are searched."""
    boxes = [entry | {"text": line.id} for line in lines for entry in line.told()]
    machine = [twin().to_toml(), RANDOM, OUTSIDE, WORST, NEAR, list(REACHES), STARTS, SEED]
    machine += [CLIMBED, list(MOVES), MOST_MOVES]
    return digest_of([boxes, machine])


def _measured(found: Mapping[str, Any], measure: str) -> float | None:
    value: Any = found
    for key in measure.split("."):
        value = value.get(key) if isinstance(value, Mapping) else None
    return None if value is None else float(value)


def _row(tried: Tried) -> list[Any]:
    return [list(tried.point), tried.kind, [rounded(value, DIGITS) for value in tried.values]]


def _tried(rows: Sequence[Sequence[Any]]) -> Iterator[Tried]:
    return (Tried(tuple(point), kind, tuple(values)) for point, kind, values in rows)
