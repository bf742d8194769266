"""Random mechanisms in which contacts are made and frictions stick, reproducible by a seed.

Everything is drawn in units of one length, one mass and the drive's angular frequency; these are drawn over
decades.
"""

import math
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from trimmer import Body, ContactLaw, Force, Friction, Link, Mechanism, Output, Pin, Play, Stop
from trimmer.mechanism import GROUND, Point, Structure, Wall
from trimmer.mechanism.parts import COUPLINGS

LAWS = tuple(ContactLaw)


@dataclass
class Workshop:
    """Draws the parts of one mechanism."""

    random: np.random.Generator  # The source of all draws
    length: float  # m
    mass: float  # kg
    frequency: float  # Hz
    bodies: dict[str, Body] = field(default_factory=dict)
    pins: dict[str, Pin] = field(default_factory=dict)
    links: dict[str, Link] = field(default_factory=dict)

    @property
    def omega(self) -> float:
        return 2 * math.pi * self.frequency

    @property
    def force(self) -> float:
        """What moves the unit mass by the unit length."""
        return self.mass * self.omega**2 * self.length

    def over_decades(self, low: float, high: float) -> float:
        return float(np.exp(self.random.uniform(math.log(low), math.log(high))))

    def happens(self, probability: float) -> bool:
        return bool(self.random.random() < probability)

    def order(self) -> int:
        return int(self.random.choice([1, 2, 3], p=[0.7, 0.15, 0.15]))

    def phase(self) -> float:
        return float(self.random.uniform(0, 2 * math.pi))

    def carrier(self, end: str) -> str:
        return self.pins[end].on if end in self.pins else end

    def reduced_mass(self, between: tuple[str, str]) -> float:
        carriers = [self.carrier(end) for end in between]
        inverse = sum(1 / self.bodies[name].mass for name in carriers if name != GROUND)
        return 1 / inverse

    def between(self) -> tuple[str, str]:
        """Two ends, of which at least one moves freely and which are not carried by the same body."""
        ends = [*self.bodies, *self.pins, GROUND]
        while True:
            start, end = (str(name) for name in self.random.choice(ends, 2, replace=False))
            if self.carrier(start) != self.carrier(end):
                return start, end

    def spring(self, between: tuple[str, str], ratio: float, damping_ratio: float) -> tuple[float, float]:
        """Stiffness and damping of what vibrates at ``ratio`` times the drive."""
        mass, omega = self.reduced_mass(between), ratio * self.omega
        return mass * omega**2, 2 * damping_ratio * mass * omega

    def link(self, between: tuple[str, str]) -> Link:
        return Link(between, *self.spring(between, self.over_decades(0.5, 4), self.over_decades(0.02, 0.3)))

    def contact_spring(self, between: tuple[str, str]) -> tuple[float, float]:
        damping_ratio = 0.0 if self.happens(0.2) else self.over_decades(0.02, 0.5)
        return self.spring(between, self.over_decades(4, 25), damping_ratio)

    def law(self) -> ContactLaw:
        return LAWS[int(self.random.integers(3))]

    def play(self) -> Play:
        between = self.between()
        gap = self.length * self.over_decades(0.03, 1.5)
        return Play(between, *self.contact_spring(between), gap, self.law())

    def stop(self) -> Stop:
        between = self.between()
        gap = self.length * (
            self.over_decades(0.05, 1) if self.happens(0.7) else -self.over_decades(0.01, 0.1)
        )
        return Stop(between, *self.contact_spring(between), gap, self.law())

    def friction(self, between: tuple[str, str], strength: float) -> Friction:
        kinetic = strength * self.force
        static = kinetic * float(self.random.uniform(1.02, 1.6)) if self.happens(0.4) else None
        viscous = 0.1 * kinetic / (self.length * self.omega) if self.happens(0.3) else 0.0
        return Friction(between, kinetic, static, viscous)


def random_mechanism(seed: int) -> Mechanism:
    """Return the mechanism of a seed: 1 to 6 bodies, 0 to 3 plays, 0 to 2 stops, 0 to 4 frictions."""
    random = np.random.default_rng(seed)
    shop = Workshop(
        random,
        float(10 ** random.uniform(-5, 0)),
        float(10 ** random.uniform(-3, 2)),
        float(10 ** random.uniform(-1, 3)),
    )
    _add_bodies(shop)
    _add_pins(shop)
    plays = {f"play {i}": shop.play() for i in range(int(random.integers(0, 4)))}
    stops = {f"stop {i}": shop.stop() for i in range(int(random.integers(0 if plays else 1, 3)))}
    names = list(shop.bodies)
    first, last = names[0], names[-1]
    return Mechanism(
        bodies=shop.bodies,
        frequency=shop.frequency,
        pins=shop.pins,
        links=shop.links,
        plays=plays,
        stops=stops,
        frictions=_frictions(shop),
        forces=_forces(shop),
        outputs={"asked for": Output({last: 1.0} if first == last else {last: 1.0, first: -1.0})},
        start=_start(shop),
        title=f"random mechanism {seed}",
    )


def _add_bodies(shop: Workshop) -> None:
    count = int(shop.random.integers(1, 7))
    for number in range(count):
        name = f"body {number}"
        shop.bodies[name] = Body(shop.mass * shop.over_decades(0.3, 3))
        held_by = [GROUND, *list(shop.bodies)[:-1]]
        holder = GROUND if number == 0 else str(shop.random.choice(held_by))
        shop.links[f"link {number}"] = shop.link((holder, name))
    if count > 2 and shop.happens(0.4):
        start, end = (f"body {i}" for i in shop.random.choice(count, 2, replace=False))
        shop.links["extra link"] = shop.link((start, end))


def _add_pins(shop: Workshop) -> None:
    for number in range(int(shop.random.integers(1, 3))):
        carriers = [GROUND, *shop.bodies]
        on = str(shop.random.choice(carriers)) if len(shop.bodies) > 1 else GROUND
        order = shop.order()
        amplitude = shop.length * shop.over_decades(0.3, 2) / order
        name = f"pin {number}"
        shop.pins[name] = Pin(on, amplitude, shop.phase(), order=order)
        driven = str(shop.random.choice([body for body in shop.bodies if body != on]))
        shop.links[f"rod {number}"] = shop.link((name, driven))
    if shop.happens(0.2):
        speed = shop.length * shop.omega * shop.over_decades(0.05, 0.5)
        shop.pins["belt"] = Pin(GROUND, velocity=speed)


def _frictions(shop: Workshop) -> dict[str, Friction]:
    count = int(shop.random.integers(0, 5))
    strengths = [shop.over_decades(0.05, 1.0) for _ in range(count)]
    if count >= 3 and len(shop.bodies) >= 2 and shop.happens(0.5):
        first, second = (f"body {i}" for i in shop.random.choice(len(shop.bodies), 2, replace=False))
        ring = [(first, second), (second, GROUND), (GROUND, first)]
    else:
        ring = []
    if "belt" in shop.pins and count and not ring:
        ring = [("belt", str(shop.random.choice(list(shop.bodies))))]
    pairs = [*ring, *(_rubbing(shop) for _ in range(count - len(ring)))]
    return {
        f"friction {number}": shop.friction(pair, strength)
        for number, (pair, strength) in enumerate(zip(pairs, strengths, strict=False))
    }


def _rubbing(shop: Workshop) -> tuple[str, str]:
    """Two ends; mostly bodies and the ground, so that they can stick."""
    while True:
        between = shop.between()
        if not any(end in shop.pins for end in between) or shop.happens(0.2):
            return between


def _forces(shop: Workshop) -> dict[str, Force]:
    forces = {}
    for number, name in enumerate(shop.bodies):
        if shop.happens(0.35):
            constant = shop.force * float(shop.random.normal()) * 0.3 if shop.happens(0.5) else 0.0
            amplitude = shop.force * shop.over_decades(0.2, 2) if shop.happens(0.7) else 0.0
            unbalance = shop.mass * shop.length * shop.over_decades(0.1, 0.5) if shop.happens(0.3) else 0.0
            order = 1 if unbalance else shop.order()
            forces[f"force {number}"] = Force(name, constant, amplitude, shop.phase(), order, unbalance)
    return forces


def _start(shop: Workshop) -> dict[str, tuple[float, float]]:
    if shop.happens(0.5):
        return {}
    sizes = (shop.length, shop.length * shop.omega)
    return {name: tuple(float(s * shop.random.normal() * 0.5) for s in sizes) for name in shop.bodies}


def all_with(parts: Mapping[str, Any], **factors: float) -> dict[str, Any]:
    """Multiply numbers of all parts of a kind."""

    def changed(part: Any) -> Any:
        given = {name: getattr(part, name) for name in factors}
        return replace(
            part, **{name: value * factors[name] for name, value in given.items() if value is not None}
        )

    return {name: changed(part) for name, part in parts.items()}


def levered(mechanism: Mechanism, seed: int) -> Mechanism:
    """Return a mechanism in which some ends of its parts are points on levers between two bodies."""
    random, names = np.random.default_rng(seed), list(mechanism.bodies)
    points: dict[str, Point] = {}

    def lever(end: str) -> str:
        if end not in mechanism.bodies or random.random() < 0.4:
            return end
        name = f"point {len(points)}"
        other = str(random.choice(names))
        share = float(random.uniform(0.5, 1.5))
        points[name] = Point(
            {end: share} if other == end else {end: share, other: float(random.normal() * 0.5)}
        )
        return name

    sections = {
        section: {
            name: replace(part, between=tuple(map(lever, part.between)))
            for name, part in getattr(mechanism, section).items()
        }
        for section in COUPLINGS
    }
    forces = {name: replace(force, on=lever(force.on)) for name, force in mechanism.forces.items()}
    pins = {name: replace(pin, on=lever(pin.on)) for name, pin in mechanism.pins.items()}
    return replace(mechanism, **sections, forces=forces, pins=pins, points=points)


def turned(mechanism: Mechanism, arms: np.ndarray) -> Mechanism:
    """Return the mechanism with bodies that turn at arms, whose ends are where the bodies were."""
    arm = dict(zip(mechanism.bodies, map(float, arms), strict=True))

    def moved(end: str) -> str:
        return f"end of {end}" if end in arm else end

    def turn(body: str, part: Any) -> Body:
        return Body(inertia=part.mass * arm[body] ** 2)

    sections = {
        section: {
            name: replace(part, between=tuple(map(moved, part.between)))
            for name, part in getattr(mechanism, section).items()
        }
        for section in COUPLINGS
    }
    return replace(
        mechanism,
        **sections,
        bodies={name: turn(name, body) for name, body in mechanism.bodies.items()},
        points={moved(name): Point({name: length}, by_length=True) for name, length in arm.items()},
        forces={name: replace(force, on=moved(force.on)) for name, force in mechanism.forces.items()},
        pins={name: replace(pin, on=moved(pin.on)) for name, pin in mechanism.pins.items()},
        outputs={},
        start={name: (q / arm[name], v / arm[name]) for name, (q, v) in mechanism.start.items()},
    )


def curved(mechanism: Mechanism, seed: int) -> Mechanism:
    """Return a mechanism whose first link is a curve beside its spring, and whose frictions fall or rise."""
    random = np.random.default_rng(seed)
    (name, first), *_ = mechanism.links.items()
    length = float(max(abs(pin.amplitude) for pin in mechanism.pins.values()))
    d = np.cumsum(random.uniform(0.1, 0.6, 4)) * length - length
    forces = np.cumsum(random.uniform(-0.3, 1.5, 4)) * first.stiffness * length
    link = {name: replace(first, curve=tuple(zip(d.tolist(), forces.tolist(), strict=True)))}
    speed = length * 2 * np.pi * mechanism.frequency

    def falling(friction: Friction) -> Friction:
        v = np.append(0.0, np.cumsum(random.uniform(0.1, 0.8, 2))) * speed
        forces = friction.force * np.append(1.0, random.uniform(0.4, 1.3, 2))
        points = tuple(zip(v.tolist(), forces.tolist(), strict=True))
        return replace(friction, force=None, curve=points)

    frictions = {name: falling(each) for name, each in mechanism.frictions.items()}
    return replace(mechanism, links={**mechanism.links, **link}, frictions=frictions)


def with_every_part(seed: int) -> Mechanism:
    """Return a random mechanism with curves, harmonics, a wall and a structure, on levers or turning."""
    mechanism, random = curved(random_mechanism(seed), seed), np.random.default_rng(seed)
    length = float(max(abs(pin.amplitude) for pin in mechanism.pins.values()))
    name, body = next(iter(mechanism.bodies.items()))
    stiffness = body.mass * (2 * np.pi * mechanism.frequency) ** 2
    structure = Structure(
        body.mass * np.array([[0.5, 0.1], [0.1, 0.7]]),
        stiffness * np.array([[3.0, -1.0], [-1.0, 2.0]]),
        damping_ratio=0.02,
        coordinates=("u", "w"),
    )
    seat = Link(("frame.u", name), float(random.uniform(0.5, 4)) * stiffness)
    walls = {
        f"wall {at}": Wall(pair, float(random.uniform(0, 0.9)), length * float(random.uniform(0.02, 0.5)))
        for at, pair in enumerate([(GROUND, name), ("frame.w", "frame.u"), (name, "frame.u")][seed % 2 :])
    }
    pins = {
        each: replace(pin, harmonics=((2, 0.2 * pin.amplitude, 1.0),)) if pin.amplitude else pin
        for each, pin in mechanism.pins.items()
    }
    made = replace(
        mechanism,
        pins=pins,
        links={**mechanism.links, "seat": seat},
        structures={"frame": structure},
        walls=walls,
        start={},
    )
    if seed % 3 == 0:
        return levered(made, seed)
    return turned(made, random.uniform(0.5, 2.0, len(made.bodies))) if seed % 3 == 1 else made
