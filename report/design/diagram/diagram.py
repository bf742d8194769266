"""A mechanism drawn from its data: bodies as boxes in columns, what joins them between them."""

from __future__ import annotations

import textwrap
from collections.abc import Collection
from dataclasses import dataclass
from typing import final

from matplotlib.axes import Axes
from matplotlib.figure import Figure

from report.design.diagram import symbols
from report.design.diagram.layout import DiagramLayout, Run, box_of, layout_of
from report.design.quantities import shown
from report.pages.drawing.marks import arrow
from report.pages.drawing.mechanical_symbols import BRIDGE, GUARD, HOUSING, LINE, MOTOR, body, canvas, wall
from trimmer.drawing.look import plain_label
from trimmer.mechanism import Force, Mechanism
from trimmer.mechanism.kinds import Kind
from trimmer.mechanism.place_text import place_text
from trimmer.mechanism.waves import is_driven, mean_of

WIDTH = 6.5
WALL = 0.16
BOX = 0.72
NARROWEST, WIDEST = 0.85, 1.5
"""Least width of the space between two columns, in inches, and the most where there is room."""
CONTACT = 0.4  # By how much a space is wider in which a play or a stop stands
LANE = 0.84
MARGIN = 0.22  # How far a body reaches beyond its lanes
HEAD = 0.5  # Room above for forces
SYMBOL = 1.0  # Longest symbol of a part
PIN = 0.34
SMALL = 7.0
SHORT = 16  # Characters of a name that stands on one line
COLOURS = (MOTOR, BRIDGE, HOUSING, GUARD, "#e8e6d2", "#d9e4e6")


def mechanism_diagram(mechanism: Mechanism) -> Figure:
    """Draw a mechanism."""
    layout = layout_of(mechanism)
    lanes = [lane for span in layout.spans.values() for lane in span] + [run.lane for run in layout.runs]
    low, high = min(lanes, default=0), max(lanes, default=0)
    ends = {end for run in layout.runs for end in run.joint.ends}
    named = {end for end in ends if end in mechanism.pins or box_of(mechanism, end) != end}
    geometry = _Geometry.of(layout, named, low, high)
    forced = any(_pushes(force) for force in mechanism.forces.values())
    figure, axes = canvas(geometry.width, geometry.height + (HEAD if forced else 0.0))
    _Drawing(axes, mechanism, layout, geometry).draw()
    return figure


def _wrapped(name: str, width: int, lines: int) -> str:
    return plain_label("\n".join(textwrap.wrap(name, width, max_lines=lines, placeholder="…")))


def _pushes(force: Force) -> bool:
    return bool(mean_of(force) or force.profile) or is_driven(force)


@dataclass(frozen=True)
class _Geometry:
    """Places in inches."""

    edges: tuple[tuple[float, float], ...]  # Left and right edge of each column, the walls among them
    low: int  # The lowest lane
    # width, height: Of the drawing, without forces
    width: float
    height: float

    @classmethod
    def of(cls, layout: DiagramLayout, named: Collection[str], low: int, high: int) -> _Geometry:
        left, right = layout.walls
        spaces = _spaces(layout, named)
        bodies = len(layout.bodies)
        widths = [WALL if left else 0.0, *[BOX] * bodies, WALL if right else 0.0]
        edges, x = [], 0.05
        for width, space in zip(widths, [*spaces, 0.0], strict=True):
            edges.append((x, x + width))
            x += width + space
        height = (high - low + 1) * LANE + 0.1
        return cls(tuple(edges), low, x + 0.05, height)

    def level(self, lane: int) -> float:
        """Return the height of a lane."""
        return 0.05 + (lane - self.low + 0.5) * LANE


def _clearance(run: Run) -> float:
    """Return the further room of the symbol of what touches."""
    return CONTACT if run.joint.section in ("plays", "stops", "walls") else 0.0


def _spaces(layout: DiagramLayout, named: Collection[str]) -> list[float]:
    """Return the widths of the spaces between columns: as wide as what stands in each needs."""
    count = len(layout.bodies) + 1
    needed = [NARROWEST] * count
    for is_there, at in zip(layout.walls, (0, -1), strict=True):
        needed[at] = needed[at] if is_there else 0.0
    for run in layout.runs:
        if run.right - run.left == 1:
            own = NARROWEST + _clearance(run) + PIN * sum(end in named for end in run.joint.ends)
            needed[run.left] = max(needed[run.left], own)
    boxes = len(layout.bodies) * BOX + sum(layout.walls) * WALL + 0.1
    spare = max(WIDTH - boxes - sum(needed), 0.0)
    there = [width for width in needed if width]
    return [min(width + spare / len(there), WIDEST + width - NARROWEST) if width else 0.0 for width in needed]


@final
@dataclass(frozen=True)
class _Drawing:
    axes: Axes
    mechanism: Mechanism
    layout: DiagramLayout
    geometry: _Geometry

    def draw(self) -> None:
        """Draw all parts."""
        for number, name in enumerate(self.layout.bodies):
            self.body(name, number)
        self.walls()
        for run in self.layout.runs:
            self.run(run)
        for name, force in self.mechanism.forces.items():
            if _pushes(force):
                self.force(name, force.on)

    def body(self, name: str, number: int) -> None:
        left, right = self.geometry.edges[number + 1]
        bottom, top = self.ends(name)
        if name in self.mechanism.points:
            self.point(_wrapped(name, SHORT, 2), (left + right) / 2, bottom, top)
            return
        words = _wrapped(name.removesuffix("."), 9, 4)
        fill = COLOURS[number % len(COLOURS)]
        if (structure := self.mechanism.structures.get(name.removesuffix("."))) and name.endswith("."):
            kind, mass = Kind.TRANSLATION, f"{len(structure.names)} {'modes' if structure.modes else 'dof'}"
        else:
            kind = self.mechanism.kinds[name]
            mass = shown(self.mechanism.bodies[name].generalised_mass, kind.unit("kg"))
        if kind is Kind.ROTATION:
            symbols.disc(self.axes, (left, bottom), (right - left, top - bottom), fill)
        else:
            body(self.axes, (left, bottom), (right - left, top - bottom), "", fill)
        self.axes.text((left + right) / 2, (bottom + top) / 2, f"{words}\n{mass}", ha="center", va="center",
                       fontsize=8, zorder=3)  # fmt: skip

    def point(self, words: str, x: float, bottom: float, top: float) -> None:
        """Draw a point: a bar without mass."""
        self.axes.plot([x, x], [bottom, top], **LINE, zorder=2)
        self.axes.text(x, top + 0.02, words, ha="center", va="bottom", fontsize=8, zorder=3)

    def ends(self, name: str) -> tuple[float, float]:
        """Return the lower and the upper edge of a body."""
        low, high = self.layout.spans[name]
        return self.geometry.level(low) - MARGIN, self.geometry.level(high) + MARGIN

    def walls(self) -> None:
        last = len(self.layout.bodies) + 1
        for column, behind, there in zip((0, last), (-1, 1), self.layout.walls, strict=True):
            if there:
                lanes = [run.lane for run in self.layout.runs if column in (run.left, run.right)]
                edge = self.geometry.edges[column][1 if column == 0 else 0]
                bottom, top = self.geometry.level(min(lanes)) - 0.3, self.geometry.level(max(lanes)) + 0.3
                wall(self.axes, edge, bottom, top, behind)

    def run(self, run: Run) -> None:
        """Draw a part along its lane, with pins where its ends are such."""
        y = self.geometry.level(run.lane)
        left, right = self.edge(run.left, 1), self.edge(run.right, 0)
        first, second = run.joint.ends[::-1] if run.turned else run.joint.ends
        start = self.port(first, left, y, 1)
        end = self.port(second, right, y, -1)
        middle, half = 0.5 * (start + end), 0.5 * min(end - start, SYMBOL + _clearance(run))
        for x, towards in ((start, middle - half), (middle + half, end)):
            self.axes.plot([x, towards], [y, y], **LINE, zorder=1)
        self.symbol(run, middle - half, middle + half, y)
        self.name(run, middle, y)

    def edge(self, column: int, side: int) -> float:
        """Return an edge of a column: of a point its middle."""
        edges = self.geometry.edges[column]
        inside = 0 < column <= len(self.layout.bodies)
        is_point = inside and self.layout.bodies[column - 1] in self.mechanism.points
        return 0.5 * sum(edges) if is_point else edges[side]

    def port(self, end: str, edge: float, y: float, sign: int) -> float:
        """Return where a part begins: at a pin, which is drawn, or at the edge."""
        if end not in self.mechanism.pins:
            if box_of(self.mechanism, end) != end:
                own = end.removeprefix(box_of(self.mechanism, end))
                side = "left" if sign > 0 else "right"
                words = plain_label(own, SHORT)
                self.axes.text(edge + 0.03 * sign, y + 0.03, words, ha=side, va="bottom", fontsize=SMALL)
            return edge
        at = symbols.pin(self.axes, edge, y, sign, PIN)
        # The name lies over the arrow, where nothing else is.
        side = "right" if sign > 0 else "left"
        self.axes.text(
            at + 0.07 * sign, y + 0.1, plain_label(end, SHORT), ha=side, va="bottom", fontsize=SMALL
        )
        return at

    def symbol(self, run: Run, left: float, right: float, y: float) -> None:
        part = getattr(self.mechanism, run.joint.section)[run.joint.name]
        match run.joint.section:
            case "points":
                self.axes.plot([left, right], [y, y], **LINE, zorder=1)
            case "links":
                symbols.spring_and_damper(self.axes, left, right, y, part)
            case "plays":
                middle = 0.5 * (left + right)
                symbols.slot(self.axes, left, middle, y)
                symbols.spring_and_damper(self.axes, middle, right, y, part)
            case "stops":
                middle = 0.5 * (left + right)
                symbols.stop(self.axes, left, middle, y, pulls=not run.turned)
                symbols.spring_and_damper(self.axes, middle, right, y, part)
            case "walls":
                symbols.wall(self.axes, left, right, y, pulls=not run.turned)
            case "frictions":
                symbols.sliding(self.axes, left, right, y)
            case "controllers":
                symbols.actuator(self.axes, left, right, y)

    def name(self, run: Run, x: float, y: float) -> None:
        """Write name and main number of a part above and below it."""
        if run.joint.section == "points":
            self.weight(run, x, y)
            return
        part = getattr(self.mechanism, run.joint.section)[run.joint.name]
        unit = self.mechanism.kind_of(run.joint.section, run.joint.name).unit
        number = {
            "links": lambda: (
                "curve"
                if part.curve
                else shown(part.stiffness, unit("N/m"))
                if part.stiffness
                else shown(part.damping, unit("N s/m"))
            ),
            "plays": lambda: f"gap {shown(part.gap, unit('m'))}" if part.gap else "no gap",
            "stops": lambda: f"gap {shown(part.gap, unit('m'))}" if part.gap else "no gap",
            "walls": lambda: f"restitution {part.restitution:.3g}",
            "controllers": lambda: f"by {plain_label(part.measure, SHORT)}",
            "frictions": lambda: (
                shown(part.kinetic_force, unit("N"))
                if part.kinetic_force
                else shown(part.viscous, unit("N s/m"))
            ),
        }[run.joint.section]()
        name = _wrapped(run.joint.name, SHORT, 2)
        self.axes.text(x, y + 0.24, name, ha="center", va="bottom", fontsize=SMALL, linespacing=0.9)
        self.axes.text(x, y - 0.25, number, ha="center", va="top", fontsize=SMALL)

    def weight(self, run: Run, x: float, y: float) -> None:
        """Write below a lever or gear what it weighs its body with."""
        place = place_text(("points", run.joint.name, run.joint.ends[1]))
        value, unit = self.mechanism.value(place), self.mechanism.places[place]
        words = f"× {shown(value)}" if unit == "1" else f"arm {shown(value, unit)}"
        self.axes.text(x, y - 0.06, words, ha="center", va="top", fontsize=SMALL)

    def force(self, name: str, on: str) -> None:
        """Draw a force above its body."""
        box = box_of(self.mechanism, on)
        column = self.layout.bodies.index(box) + 1
        left, right = self.geometry.edges[column]
        top = self.ends(box)[1]
        forces = self.mechanism.forces.items()
        others = [each for each, force in forces if box_of(self.mechanism, force.on) == box]
        y = top + 0.12 + 0.2 * others.index(name)
        arrow(self.axes, (left, y), (right, y), shrinkA=0, shrinkB=0, mutation_scale=9)
        self.axes.text(
            (left + right) / 2, y + 0.04, plain_label(name, SHORT), ha="center", va="bottom", fontsize=SMALL
        )
