"""What a file of a proof is about, as frozen data: every key known, every shape and range held.

States come first, then what forces them; together they are Z. ``typed`` of ``json_data`` reads these classes.
"""

from collections.abc import Sequence
from dataclasses import dataclass

Row = tuple[float, ...]
Table = tuple[Row, ...]
Term = dict[str, str | float | Row | None]
"""A part of an element: ``kind``, its numbers (``NUMBERS``), and ``factors``."""
NUMBERS = {
    "relay": ("level", "hysteresis", "dead_zone"),
    "preload": ("level", "slope"),
    "Coulomb friction": ("force",),
    "viscous friction": ("damping",),
    "saturation": ("threshold", "slope"),
    "dead zone": ("threshold", "slope"),
    "backlash": ("gap", "time_constant", "frozen_omega"),
}
FROM_ZERO = ("hysteresis", "dead_zone", "time_constant")
"""What may be zero; all other numbers of an element are positive."""
WITHOUT = ("time_constant", "frozen_omega")  # What may be None: an infinite one, or none


@dataclass(frozen=True)
class Coefficients:
    """A plant by its polynomials, of falling powers."""

    numerator: Row
    denominator: Row


@dataclass(frozen=True)
class Matrices:
    """A plant by its matrices, of one input and one output."""

    A: Table
    B: Table
    C: Table
    D: Table

    def __post_init__(self) -> None:
        size = len(self.A)
        shapes = (self.A, size, size), (self.B, size, 1), (self.C, 1, size), (self.D, 1, 1)
        _require(all(_is(*each) for each in shapes), "the matrices of the plant do not fit together")


@dataclass(frozen=True)
class Place:
    """A limit cycle."""

    amplitude: float
    omega: float


@dataclass(frozen=True)
class LimitCycles:
    """That a loop has these limit cycles and no other."""

    plant: Coefficients | Matrices
    element: tuple[Term, ...]
    omega_range: tuple[float, float] | None
    limit_cycles: tuple[Place, ...]

    def __post_init__(self) -> None:
        omegas = self.omega_range
        _require(omegas is None or 0 < omegas[0] < omegas[1], f"omega_range is {omegas}")


@dataclass(frozen=True)
class Rates:
    """What holds between events: rates of the states, and event functions, by Z."""

    flow: Table
    functions: Table


@dataclass(frozen=True)
class Equations:
    """The numbers of a system: modes, what becomes of Z at instants, the forcing at the start, s."""

    modes: tuple[Rates, ...]
    resets: tuple[Table, ...]
    forcing: Row
    period: float | None


@dataclass(frozen=True)
class Segment:
    """A piece of a motion: its mode and duration, and the event function or clock that ends it."""

    reset: int | None  # The number of what becomes of Z before it; None if Z goes on as it is
    mode: int  # Its number
    duration: float  # As computed, s
    fired: int | None  # What ends it; None for the last one
    together: tuple[int, ...]  # Others that are a multiple of it
    # Event functions, and how many derivatives of each vanish at its start, counting the zeroth
    zeros: tuple[tuple[int, int], ...]
    at: float | None  # When it ends if a clock ends it, s from the start
    strict: Table  # What is positive then, by Z


@dataclass(frozen=True)
class Course:
    """A motion: one that returns, or one from a state."""

    about: str  # What the equations are said to be of; nothing depends on it
    segments: tuple[Segment, ...]  # Its pieces
    sizes: Row  # Of each state
    state: Row  # At the start
    # Two places of what forces the states that turn together, and how often over the period of the drive
    turning: tuple[tuple[int, int, int], ...]
    periods: float  # How many of them it lasts; 0 without a drive
    signs: tuple[int, ...]  # Of the states, if the end is to be the mirror image of the start; else empty
    clock: tuple[tuple[float, float], ...]  # Sample and delay of each controller that samples, s

    def require_fits(self, equations: Equations) -> None:
        """Hold shapes, and numbers of modes, resets and event functions, against equations."""
        n, forced = len(self.state), len(equations.forcing)
        size, turned = n + forced, [place for *pair, _ in self.turning for place in pair]
        _require(n == len(self.sizes) and min(self.sizes) > 0, "sizes are not positive, one for each state")
        alone = len(set(turned)) == len(turned) and set(turned) <= set(range(forced))
        _require(alone, "what forces the states does not turn by pairs")
        _require(not self.signs or set(self.signs) <= {1, -1}, "signs are other than 1 and -1")
        _require(len(self.signs) in (0, n), "signs do not fit the states")
        _require(all(sample > 0 <= delay for sample, delay in self.clock), "a sample or delay is negative")
        if equations.period is None:
            _require(not (self.periods or self.turning), "nothing turns without a drive")
        else:
            _require(equations.period > 0 < self.periods, "a period is not positive")
        for mode in equations.modes:
            _require(_is(mode.flow, n, size) and _is(mode.functions, None, size), "a mode does not fit")
        _require(all(_is(each, size, size) for each in equations.resets), "a reset does not fit")
        _require(bool(self.segments), "there is no segment")
        _require(self.segments[0].reset is None, "the states jump where the motion begins, without an event")
        for each in self.segments:
            _require(0 <= each.mode < len(equations.modes), f"there is no mode {each.mode}")
            _require(each.reset is None or 0 <= each.reset < len(equations.resets), "there is no such reset")
            _require(_is(each.strict, None, size), "what is positive at a sample does not fit")
            _require(all(1 <= count <= MOST_ZEROS for _, count in each.zeros), "a count of zeros is none")
            ended = each.fired is not None or not each.together
            _require(ended, "an event function is named where none ends a segment")
            fired = [] if each.fired is None else [each.fired]
            for functions in ([function for function, _ in each.zeros], [*fired, *each.together]):
                known = range(len(equations.modes[each.mode].functions))
                _require(all(k in known for k in functions), "there is no such event function")
                _require(len(set(functions)) == len(functions), "an event function is named twice")


MOST_ZEROS = 3  # Derivatives of an event function that may vanish at an event


@dataclass(frozen=True)
class Functional:
    """Something that is read of a motion: what it is said to be, which nothing depends on, and what it is."""

    about: str  # What it is said to be
    rows: Table  # By Z, in each mode
    before: tuple[int, ...]  # Segments at whose end it is told


@dataclass(frozen=True)
class StatedMotion:
    """That a system moves so: periodically, or from a state, with what is read of it."""

    motion: Course
    equations: Equations
    stable: bool | None  # As computed, of one that repeats; None if that is not told
    functionals: tuple[Functional, ...]  # What is read
    levels: tuple[Functional, ...]  # Functionals whose zeros are told

    def __post_init__(self) -> None:
        self.motion.require_fits(self.equations)
        size = len(self.motion.state) + len(self.equations.forcing)
        for each in (*self.functionals, *self.levels):
            _require(_is(each.rows, len(self.equations.modes), size), "a functional does not fit the modes")
            known = all(0 <= k < len(self.motion.segments) for k in each.before)
            _require(known, "a functional is told before an event that is none")


@dataclass(frozen=True)
class Neighbour:
    """The equations at a value of a number."""

    value: float
    equations: Equations


@dataclass(frozen=True)
class StatedSpecialPoint:
    """That the systems on a straight line through two have a special point, near a value."""

    kind: str
    place: str
    value: float
    motion: Course
    beside: tuple[Neighbour, Neighbour]

    def __post_init__(self) -> None:
        first, second = (each.equations for each in self.beside)
        for each in (first, second):
            self.motion.require_fits(each)
        forms = [
            (
                [len(mode.functions) for mode in each.modes],
                len(each.resets),
                len(each.forcing),
                each.period is None,
            )
            for each in (first, second)
        ]
        _require(forms[0] == forms[1], "the equations of two values are not of one form")
        _require(self.value != 0 and self.beside[0].value < self.beside[1].value, "the values are none")
        _require(not self.motion.clock or first.period == second.period, "a clock does not keep its times")
        half = 0.5 if self.motion.signs else 0.0
        _require((self.motion.periods - half).is_integer(), "half of a motion has signs, and no other has")


def _is(table: Sequence[Sequence[float]], rows: int | None, columns: int) -> bool:
    """Return whether a table has a shape; None stands for any number of rows."""
    return rows in (None, len(table)) and all(len(row) == columns for row in table)


def _require(holds: bool, otherwise: str) -> None:
    if not holds:
        raise ValueError(otherwise)
