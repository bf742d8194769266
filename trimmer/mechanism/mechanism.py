"""A mechanism: bodies, and what holds, pushes and rubs them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from trimmer.mechanism.parts import Body, Force, Friction, Link, Output, Pin, Play, Stop


@dataclass(frozen=True, eq=False)
class Mechanism:
    """Bodies on one line, with links, plays, stops, frictions and forces between them, by name.

    Attributes:
        bodies: Their order is the order of the displacements.
        frequency: That of the drive, Hz; None for a mechanism that moves by itself.
        title: What it is.
        start: Displacement, m, and velocity, m/s, of bodies at t = 0; the others are at rest at 0.
    """

    bodies: Mapping[str, Body]
    frequency: float | None = None
    pins: Mapping[str, Pin] = field(default_factory=dict)
    links: Mapping[str, Link] = field(default_factory=dict)
    plays: Mapping[str, Play] = field(default_factory=dict)
    stops: Mapping[str, Stop] = field(default_factory=dict)
    frictions: Mapping[str, Friction] = field(default_factory=dict)
    forces: Mapping[str, Force] = field(default_factory=dict)
    outputs: Mapping[str, Output] = field(default_factory=dict)
    start: Mapping[str, tuple[float, float]] = field(default_factory=dict)
    title: str = ""
