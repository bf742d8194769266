"""The parts of a mechanism that moves along one line. SI units; ``between`` is (start, end).

Units are those of translations. A rotation has rad in place of m, N m of N, N m/rad of N/m, N m s/rad of
N s/m, kg m² of kg, and also of kg m, for its unbalance is one of moments.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field

from trimmer.choices import Choice

GROUND = "ground"
"""The name of the fixed frame, where an end or a carrier is asked for."""
Curve = tuple[tuple[float, float], ...]  # Points of a curve: abscissa and force
Row = tuple[float, ...]  # A row of a list of numbers, such as order, amplitude and phase
COUPLINGS = ("links", "plays", "stops", "walls", "frictions")
"""Sections whose parts stand between two ends, and have a force that may be asked for."""


class ContactLaw(Choice):
    """What a contact does when its force would have to pull.

    With z the stretch of the spring behind the slot and T = k z + c z' the force, a relaxing contact ends
    where T would pull, and its spring relaxes by itself (Nordin, Galić and Gutman 1997); a truncated one ends
    there too, but has no memory; a pulling one lasts until the gap is reached again.
    """

    RELAXING = "relaxing"
    TRUNCATED = "truncated"
    PULLING = "pulling"


@dataclass(frozen=True)
class Body:
    """A rigid body, which moves along the line or turns: it has a mass or an inertia.

    Attributes:
        mass: Mass, kg, of a translation.
        symbol: Symbol of the mass or inertia in printed equations, such as ``m_1``.
        inertia: Moment of inertia, kg m², of a rotation.
    """

    mass: float | None = None
    symbol: str | None = None
    inertia: float | None = None

    @property
    def generalised_mass(self) -> float:
        """The mass, kg, or the inertia, kg m²."""
        return self.mass or self.inertia or 0.0


@dataclass(frozen=True)
class Point:
    """A weighted sum of coordinates, which stands wherever a body may: a lever, a gear ratio.

    A force on it acts on each coordinate in proportion to its weight. It is a rotation where all its
    coordinates are, and else a translation; then weights of rotations are lengths, m.

    Attributes:
        weights: Factor of each coordinate.
        by_length: Whether weights of rotations are lengths. It need be said only where all coordinates are
            rotations and the point is a translation, as a rack on a gear: ``Point({"gear": 0.02}, True)``.
    """

    weights: Mapping[str, float]
    by_length: bool = False


@dataclass(frozen=True)
class Pin:
    """A massless point at q_on + offset + velocity t + amplitude sin(2 pi order frequency t + phase).

    Attributes:
        on: The body or point that carries it, or ``ground``.
        amplitude: m.
        phase: rad.
        offset: m.
        velocity: m/s.
        order: Multiple of the drive's frequency.
        symbol: Symbol of its displacement in printed equations.
        harmonics: Order, amplitude, m, and phase, rad, of further waves.
        waveform: Displacement beside these, m, at even phases of a period of the drive from 0 on.
        orders: Highest order of the waveform; None for 20, or fewer if there are not so many.
        drive: Name of what drives it, of which orders count; None for the frequency of the mechanism.
    """

    on: str
    amplitude: float = 0.0
    phase: float = 0.0
    offset: float = 0.0
    velocity: float = 0.0
    order: int = 1
    symbol: str | None = None
    harmonics: tuple[Row, ...] | None = None
    waveform: tuple[float, ...] | None = None
    orders: int | None = None
    drive: str | None = None


class _Damped:
    """A part with a stiffness, and a damping beside it."""

    symbol: str | None

    @property
    def damping_symbol(self) -> str | None:
        """Symbol of the damping: that of the stiffness with c for its first letter, as c_2 beside k_2."""
        return f"c{self.symbol[1:]}" if self.symbol else None


@dataclass(frozen=True)
class Link(_Damped):
    """A spring and a damper side by side.

    Attributes:
        between: Names of start and end.
        stiffness: N/m.
        damping: N s/m.
        symbol: Symbol of the stiffness in printed equations; that of the damping begins with c instead.
        curve: A force beside these, N, over end - start, m: straight between points and beyond them.
    """

    between: tuple[str, str]
    stiffness: float = 0.0
    damping: float = 0.0
    symbol: str | None = None
    curve: Curve | None = None

    @property
    def stiffness_at_rest(self) -> float:
        """Stiffness at no elongation, with that of the curve, N/m; at a corner the mean of both sides."""
        if self.curve is None:
            return self.stiffness
        pairs = list(zip(self.curve[:-1], self.curve[1:], strict=True))
        slopes = [(after[1] - before[1]) / (after[0] - before[0]) for before, after in pairs]
        below = sum(before[0] < 0 for before, _ in pairs[1:])
        above = sum(before[0] <= 0 for before, _ in pairs[1:])
        return self.stiffness + 0.5 * (slopes[below] + slopes[above])

    @property
    def is_odd(self) -> bool:
        """Whether its force is the same in both directions."""
        curve = self.curve or ()
        return sorted((-elongation, -force) for elongation, force in curve) == sorted(curve)


@dataclass(frozen=True)
class Contact(_Damped):
    """A link that acts in contact only: a play or a stop.

    Attributes:
        between: Names of start and end.
        stiffness: N/m.
        damping: N s/m.
        gap: Of a play the total clearance, of a stop the distance at which contact begins, m.
        law: The contact law.
        symbol: Symbol of the stiffness in printed equations; that of the damping begins with c instead.
    """

    between: tuple[str, str]
    stiffness: float = 0.0
    damping: float = 0.0
    gap: float = 0.0
    law: ContactLaw = ContactLaw.RELAXING
    symbol: str | None = None


@dataclass(frozen=True)
class Play(Contact):
    """A link behind a slot, with contact on both sides; its gap is the total clearance.

    Fields: ``Contact``.
    """


@dataclass(frozen=True)
class Stop(Contact):
    """A link that acts while ``end`` is farther from ``start`` than the gap; a negative one is a preload.

    Fields: ``Contact``.
    """


@dataclass(frozen=True)
class Wall:
    """A rigid wall: end - start is never more than the gap, and rebounds there.

    Attributes:
        between: Names of start and end.
        restitution: Speed after an impact over that before it, from 0 to 1.
        gap: Largest distance from start to end, m.
        symbol: Symbol of the restitution in printed equations.
    """

    between: tuple[str, str]
    restitution: float
    gap: float = 0.0
    symbol: str | None = None


@dataclass(frozen=True)
class Friction:
    """Dry friction with true stick, and viscous friction beside it.

    Attributes:
        between: Names of start and end.
        force: Kinetic force, N; None where a curve gives it.
        static: Largest force in stick, N; None for the kinetic one.
        viscous: N s/m.
        symbol: Symbol of the kinetic force in printed equations.
        curve: Kinetic force, N, over the modulus of the sliding speed, m/s, from 0 on: straight between
            points, constant beyond the last.
    """

    between: tuple[str, str]
    force: float | None = None
    static: float | None = None
    viscous: float = 0.0
    symbol: str | None = None
    curve: Curve | None = None

    @property
    def kinetic_force(self) -> float:
        """Kinetic force where sliding begins, N."""
        return self.curve[0][1] if self.curve else self.force or 0.0

    @property
    def static_force(self) -> float:
        """Largest force in stick, N."""
        return self.kinetic_force if self.static is None else self.static


@dataclass(frozen=True)
class Force:
    """A force on a body, constant + amplitude sin(2 pi order frequency t + phase).

    Attributes:
        on: The body or point.
        constant: N.
        amplitude: N.
        phase: rad.
        order: Multiple of the drive's frequency.
        unbalance: kg m; it adds unbalance (2 pi order frequency)² to the amplitude.
        symbol: Symbol of the force in printed equations.
        profile: Time, s, and force, N, of points of a force beside these: straight between them, constant
            after the last, zero before the first.
        harmonics: Order, amplitude, N, and phase, rad, of further waves.
        waveform: Force beside these, N, at even phases of a period of the drive from 0 on.
        orders: Highest order of the waveform; None for 20, or fewer if there are not so many.
        drive: Name of what drives it, of which orders count; None for the frequency of the mechanism.
    """

    on: str
    constant: float = 0.0
    amplitude: float = 0.0
    phase: float = 0.0
    order: int = 1
    unbalance: float = 0.0
    symbol: str | None = None
    profile: tuple[Row, ...] | None = None
    harmonics: tuple[Row, ...] | None = None
    waveform: tuple[float, ...] | None = None
    orders: int | None = None
    drive: str | None = None


class OutputKind(Choice):
    """What an output is. The value of a motion is the order of its time derivative."""

    DISPLACEMENT = 0
    VELOCITY = 1
    ACCELERATION = 2
    FORCE = None
    CONTROL = "what a controller gives"


@dataclass(frozen=True)
class Output:
    """An output: a sum of displacements, velocities or accelerations, or what a part exerts.

    Attributes:
        weights: Factor of each body's, point's and pin's displacement, velocity or acceleration; none of a
            force. If some are rotations and others translations, those of the rotations are lengths, m.
        kind: What it is.
        part: Of a force: the link, play, stop, wall or friction; positive where it pulls its ends together.
            Of a control: the controller, whose acting force is meant.
    """

    weights: Mapping[str, float] = field(default_factory=dict)
    kind: OutputKind = OutputKind.DISPLACEMENT
    part: str | None = None
