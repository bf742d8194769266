"""Where the parts of a mechanism stand in a drawing: bodies in columns, what joins them in lanes.

The ground is a wall at the left and one at the right. A part runs along a lane from one body to another; a
body is as high as its lanes need. A part may pass a body only in a lane that the body does not cover.
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import permutations
from typing import final

from trimmer.mechanism.mechanism import Mechanism
from trimmer.mechanism.parts import COUPLINGS, GROUND

ACTING = {"frictions": ("static_force", "viscous", "curve"), "walls": ("between",)}
"""What makes a part act, if it is not a stiffness or a damping."""
MOST_ORDERS = 6  # Number of bodies up to which every order of columns is tried
FARTHEST = 12  # Lanes above and below the first that are tried
CROSSING = 100  # What a part that passes through a body costs, in widths of a column


@dataclass(frozen=True)
class Joint:
    """A part that joins two ends; a lever or gear that moves a point is one too, from the point to a body."""

    section: str  # Such as ``links``
    name: str  # Its name
    ends: tuple[str, str]  # The two ends: bodies, points, pins, or the ground
    carriers: tuple[str, str]  # The bodies or points of the ends, or the ground


@dataclass(frozen=True)
class Run:
    """A part in its place, from left to right."""

    joint: Joint  # The part
    # left, right: Columns of its ends; 0 is the left wall, bodies count from 1, the last is the right wall
    left: int
    right: int
    lane: int  # Its lane; higher ones are above
    turned: bool  # Whether its second end is the left one


@dataclass(frozen=True)
class DiagramLayout:
    """Places of all parts."""

    bodies: tuple[str, ...]  # Names of the bodies, points and structures from left to right
    runs: tuple[Run, ...]  # The parts between them
    spans: Mapping[str, tuple[int, int]]  # Lowest and highest lane of each body

    @property
    def walls(self) -> tuple[bool, bool]:
        """Whether there is a wall at the left, and at the right."""
        last = len(self.bodies) + 1
        return any(run.left == 0 for run in self.runs), any(run.right == last for run in self.runs)

    @property
    def crossings(self) -> tuple[tuple[Run, str], ...]:
        """Each part that passes through a body, as no free lane was found for it or for another, and this."""
        spans = [(column, body, *self.spans[body]) for column, body in enumerate(self.bodies, start=1)]
        return tuple(
            (run, body)
            for run in self.runs
            for column, body, low, high in spans
            if run.left < column < run.right and low <= run.lane <= high
        )

    @property
    def cost(self) -> int:
        """How far parts reach, how many lanes there are, and how often a body is crossed."""
        lanes = {run.lane for run in self.runs}
        reach = sum(run.right - run.left for run in self.runs)
        return reach + 2 * len(lanes) + CROSSING * len(self.crossings)


def layout_of(mechanism: Mechanism) -> DiagramLayout:
    """Return places for the parts of a mechanism, in the order of bodies that is best to read."""
    joints = tuple(joints_of(mechanism))
    return min((_placed(order, joints) for order in _orders(mechanism, joints)), key=lambda each: each.cost)


def joints_of(mechanism: Mechanism) -> Iterator[Joint]:
    """Return the parts that join two ends, as far as they do something."""
    for section in COUPLINGS:
        for name, part in getattr(mechanism, section).items():
            sizes = ACTING.get(section, ("stiffness", "damping", "curve"))
            if any(getattr(part, size, None) for size in sizes):
                first, second = (box_of(mechanism, end) for end in part.between)
                if first != second:  # what joins two ends of a structure is inside of its box
                    yield Joint(section, name, part.between, (first, second))
    for name, controller in mechanism.controllers.items():
        first, second = (box_of(mechanism, end) for end in controller.acts)
        if first != second:
            yield Joint("controllers", name, controller.acts, (first, second))
    for name, point in mechanism.points.items():
        for of, weight in point.weights.items():
            if weight != 0:
                yield Joint("points", name, (name, of), (name, box_of(mechanism, of)))


def box_of(mechanism: Mechanism, end: str) -> str:
    """Return the box that an end is part of: its carrier, or the structure of this."""
    carrier = mechanism.pins[end].on if end in mechanism.pins else end
    return next((f"{name}." for name in mechanism.structures if _has(mechanism, name, carrier)), carrier)


def boxes_of(mechanism: Mechanism) -> tuple[str, ...]:
    """Return bodies, points and structures, whose names have a dot behind them here."""
    return (*mechanism.bodies, *mechanism.points, *(f"{name}." for name in mechanism.structures))


def _has(mechanism: Mechanism, name: str, end: str) -> bool:
    own = end.removeprefix(f"{name}.")
    structure = mechanism.structures[name]
    return own != end and (own in structure.names or own in structure.points)


def _orders(mechanism: Mechanism, joints: Sequence[Joint]) -> Iterable[tuple[str, ...]]:
    bodies = boxes_of(mechanism)
    return permutations(bodies) if len(bodies) <= MOST_ORDERS else (_from_ground(bodies, joints),)


def _from_ground(bodies: tuple[str, ...], joints: Sequence[Joint]) -> tuple[str, ...]:
    """Return many bodies in the order in which they are met from the ground, neighbours first."""
    beside: dict[str, list[str]] = {GROUND: [], **{body: [] for body in bodies}}
    for joint in joints:
        first, second = joint.carriers
        beside[first].append(second)
        beside[second].append(first)
    met, waiting = [], [GROUND, *bodies]
    while waiting:
        body = waiting.pop(0)
        if body not in met:
            met.append(body)
            waiting = [*beside[body], *waiting]
    return tuple(body for body in met if body != GROUND)


def _placed(bodies: tuple[str, ...], joints: Sequence[Joint]) -> DiagramLayout:
    columns = {body: place for place, body in enumerate(bodies, start=1)}
    lanes = _Lanes(columns)
    found = sorted(((*_ends(joint, columns), joint) for joint in joints), key=lambda each: each[1] - each[0])
    runs = tuple(lanes.run(joint, left, right, turned) for left, right, turned, joint in found)
    spans = {body: lanes.covered.get(body, (0, 0)) for body in bodies}
    return DiagramLayout(bodies, runs, spans)


def _ends(joint: Joint, columns: Mapping[str, int]) -> tuple[int, int, bool]:
    """Return left and right column of a part, and whether its second end is the left one."""
    first, second = joint.carriers
    last = len(columns) + 1
    if GROUND in joint.carriers:
        body = columns[second if first == GROUND else first]
        # A stop on the ground stands where its body runs into it.
        at_left = body <= last - body if joint.section not in ("stops", "walls") else second == GROUND
        left, right = (0, body) if at_left else (body, last)
        return left, right, (first == GROUND) != at_left
    left, right = columns[first], columns[second]
    return min(left, right), max(left, right), left > right


@final
@dataclass
class _Lanes:
    """Lanes that are being filled."""

    columns: Mapping[str, int]  # Of each body
    # Lowest and highest lane of each body so far
    covered: dict[str, tuple[int, int]] = field(default_factory=dict)
    taken: list[Run] = field(default_factory=list)  # The parts so far

    def run(self, joint: Joint, left: int, right: int, turned: bool) -> Run:
        """Put a part into the first lane that is free for it."""
        lanes = sorted(range(-FARTHEST, FARTHEST + 1), key=lambda lane: (abs(lane), lane < 0))
        free = [lane for lane in lanes if self._is_empty(lane, left, right)]
        lane = next((each for each in free if self._fits(each, joint, left, right)), free[0])
        run = Run(joint, left, right, lane, turned)
        self.taken.append(run)
        for body in set(joint.carriers) & set(self.columns):
            low, high = self.covered.get(body, (run.lane, run.lane))
            self.covered[body] = min(low, run.lane), max(high, run.lane)
        return run

    def _is_empty(self, lane: int, left: int, right: int) -> bool:
        return not any(run.lane == lane and run.left < right and left < run.right for run in self.taken)

    def _fits(self, lane: int, joint: Joint, left: int, right: int) -> bool:
        """Say whether no body is crossed: none that the part passes, nor by those that pass its own."""
        for body, column in self.columns.items():
            low, high = self.covered.get(body, (lane, lane))
            if left < column < right and body in self.covered and low <= lane <= high:
                return False
            if body in joint.carriers:
                low, high = min(low, lane), max(high, lane)
                if any(run.left < column < run.right and low <= run.lane <= high for run in self.taken):
                    return False
        return True
