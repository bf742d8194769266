"""The parts of a mechanism that moves along one line. SI units; ``between`` is (start, end)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from trimmer.choices import Choice

GROUND = "ground"
"""The name of the fixed frame, where an end or a carrier is asked for."""


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
    """A rigid body.

    Attributes:
        mass: Mass, kg.
        symbol: Symbol of the mass in printed equations, such as ``m_1``.
    """

    mass: float
    symbol: str | None = None


@dataclass(frozen=True)
class Pin:
    """A massless point at q_on + offset + velocity t + amplitude sin(2 pi order frequency t + phase).

    Attributes:
        on: The body that carries it, or ``ground``.
        amplitude: m.
        phase: rad.
        offset: m.
        velocity: m/s.
        order: Multiple of the drive's frequency.
        symbol: Symbol of its displacement in printed equations.
    """

    on: str
    amplitude: float = 0.0
    phase: float = 0.0
    offset: float = 0.0
    velocity: float = 0.0
    order: int = 1
    symbol: str | None = None


@dataclass(frozen=True)
class Link:
    """A spring and a damper side by side.

    Attributes:
        between: Names of start and end.
        stiffness: N/m.
        damping: N s/m.
        symbol: Symbol of the stiffness in printed equations; that of the damping begins with c instead.
    """

    between: tuple[str, str]
    stiffness: float = 0.0
    damping: float = 0.0
    symbol: str | None = None

    @property
    def damping_symbol(self) -> str | None:
        """Symbol of the damping: that of the stiffness with c for its first letter, as c_2 beside k_2."""
        return _damping_symbol(self.symbol)


@dataclass(frozen=True)
class Play:
    """A link behind a slot, with contact on both sides.

    Attributes:
        between: Names of start and end.
        stiffness: N/m.
        damping: N s/m.
        gap: Total clearance, m.
        law: The contact law.
        symbol: Symbol of the stiffness in printed equations; that of the damping begins with c instead.
    """

    between: tuple[str, str]
    stiffness: float = 0.0
    damping: float = 0.0
    gap: float = 0.0
    law: ContactLaw = ContactLaw.RELAXING
    symbol: str | None = None

    @property
    def damping_symbol(self) -> str | None:
        """Symbol of the damping: that of the stiffness with c for its first letter, as c_2 beside k_2."""
        return _damping_symbol(self.symbol)


@dataclass(frozen=True)
class Stop:
    """A link that acts while ``end`` is farther from ``start`` than the gap.

    Attributes:
        between: Names of start and end.
        stiffness: N/m.
        damping: N s/m.
        gap: Distance at which contact begins, m; a negative one is a preload.
        law: The contact law.
        symbol: Symbol of the stiffness in printed equations; that of the damping begins with c instead.
    """

    between: tuple[str, str]
    stiffness: float = 0.0
    damping: float = 0.0
    gap: float = 0.0
    law: ContactLaw = ContactLaw.RELAXING
    symbol: str | None = None

    @property
    def damping_symbol(self) -> str | None:
        """Symbol of the damping: that of the stiffness with c for its first letter, as c_2 beside k_2."""
        return _damping_symbol(self.symbol)


@dataclass(frozen=True)
class Friction:
    """Dry friction with true stick, and viscous friction beside it.

    Attributes:
        between: Names of start and end.
        force: Kinetic force, N.
        static: Largest force in stick, N; None for the kinetic one.
        viscous: N s/m.
        symbol: Symbol of the kinetic force in printed equations.
    """

    between: tuple[str, str]
    force: float
    static: float | None = None
    viscous: float = 0.0
    symbol: str | None = None

    @property
    def static_force(self) -> float:
        """Largest force in stick, N."""
        return self.force if self.static is None else self.static


@dataclass(frozen=True)
class Force:
    """constant + amplitude sin(2 pi order frequency t + phase) on a body.

    Attributes:
        on: The body.
        constant: N.
        amplitude: N.
        phase: rad.
        order: Multiple of the drive's frequency.
        unbalance: kg m; it adds unbalance (2 pi order frequency)² to the amplitude.
        symbol: Symbol of the force in printed equations.
    """

    on: str
    constant: float = 0.0
    amplitude: float = 0.0
    phase: float = 0.0
    order: int = 1
    unbalance: float = 0.0
    symbol: str | None = None


@dataclass(frozen=True)
class Output:
    """A displacement that is asked for.

    Attributes:
        weights: Factor of each body's and pin's displacement.
    """

    weights: Mapping[str, float]


def _damping_symbol(symbol: str | None) -> str | None:
    return f"c{symbol[1:]}" if symbol else None
