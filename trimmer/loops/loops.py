"""Loops whose motion can be simulated: a linear system with a nonlinear element, closed or driven."""

import math
from abc import ABC, abstractmethod
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, Self, cast, final

import control

from trimmer.arguments import finite_number, require_instance
from trimmer.arrays import Reals
from trimmer.elements.control_element import adopted
from trimmer.elements.element import Element
from trimmer.errors import IllPosedLoopError, LoopError
from trimmer.linear.stored_system import restored, stored
from trimmer.loops.components.of_elements import RigidComponent, components_of
from trimmer.loops.drive import Drive, common_omega
from trimmer.loops.interconnection import Connection, Interconnection, interconnected
from trimmer.loops.plant import realized, taken_system
from trimmer.loops.system import LoopModes, LoopSystem
from trimmer.mechanism.place_text import place_text
from trimmer.mechanism.read_only import ReadOnly
from trimmer.messages import near_or_all
from trimmer.motion.signals import Signal

COMPUTED = ("model", "modes")  # What a loop computes from its fields and keeps
AT_REST: Mapping[str, float] = ReadOnly({})


class Loop(ABC):
    """A linear system with switched elements, whose motion ``simulate`` follows.

    Attributes:
        start: States of the linear system with which a motion begins, by name; the others are 0.
    """

    start: Mapping[str, float]

    def __repr__(self) -> str:
        return f"{type(self).__name__}({', '.join(_shown(each) for each in self._parts())})"

    def _parts(self) -> tuple[object, ...]:
        """Return what the loop is made of, as far as it is to be shown."""
        hidden = COMPUTED if self.start else (*COMPUTED, "start")
        return tuple(value for name, value in vars(self).items() if name not in hidden)

    @abstractmethod
    def interconnection(self) -> Interconnection:
        """Return the equations of the loop; the first components are those of the nonlinear element."""

    @property
    @abstractmethod
    def model(self) -> control.StateSpace:
        """The linear system with one input and one output; its states are those of the interconnection."""

    @property
    def title(self) -> str:
        """What it is, in a few words."""
        return repr(self)

    @property
    def length(self) -> str:
        """Unit of the element's input and output: m of a trimmer's states, empty where it is not known."""
        return "m" if self.has_states and "q1" in self.model.state_labels else ""

    @property
    def state_units(self) -> tuple[str, ...]:
        """Units of the states of ``model``, (n,): empty where they are not known."""
        return ("",) * int(self.model.nstates)

    @property
    def driving(self) -> tuple[Drive, ...]:
        """What is prescribed: the drives, if any."""
        drive: Drive | None = getattr(self, "drive", None)
        return () if drive is None else (drive,)

    @property
    def frequency(self) -> float | None:
        """Frequency of which those of the drives are multiples, Hz; None if there is none."""
        common = common_omega(self.driving)
        return common[0] / (2.0 * math.pi) if common and common[0] else None

    @property
    def places(self) -> Mapping[str, str]:
        """The unit of every number, by its dotted place, such as ``{"element.gap": "m"}``."""
        from trimmer.loops.numbers import numbers_of

        return {place_text(place): unit for place, unit in numbers_of(self).items()}

    def value(self, place: str) -> float:
        """Return the number at a dotted place, in its unit.

        Args:
            place: Such as ``element.gap`` or ``frictions.q2-q4.force``.

        Raises:
            LoopError: if there is none.
        """
        from trimmer.loops.numbers import value_at

        return value_at(self, place)

    def with_value(self, place: str, value: float | str) -> Self:
        """Return the loop with another number at a dotted place.

        Args:
            place: Such as ``element.gap`` or ``frictions.q2-q4.force``.
            value: The number in its unit, or text with a unit, such as ``40 um``.

        Raises:
            LoopError: if there is no such place, or the number cannot stand there.
        """
        from trimmer.loops.numbers import with_value_at

        return cast("Self", with_value_at(self, place, value))

    @property
    def has_states(self) -> bool:
        """Whether the states of the model have a meaning, and are not those of some realization."""
        return True

    @property
    def repeats(self) -> bool:
        """Whether the drives, if any, have a period in common."""
        return common_omega(self.driving) is not None

    @property
    def element_sides(self) -> tuple[tuple[Reals, Reals], ...]:
        """What each element does to the rates of the states, (n,), and what it takes of the states, (n,)."""
        return ((self.model.B[:, 0], -self.model.C[0]),)

    def signal_rows(self) -> Mapping[str, Signal]:
        """Return each signal as a functional of the extended state, (N,), in each mode, by its name."""
        from trimmer.loops.loop_signal import READ, row_in_modes

        return {name: row_in_modes(self, signal) for name, signal in READ.items()}

    def own_row(self, signal: object) -> Signal | None:
        """Return a signal of a loop that names its signals itself; else None."""
        return None

    @cached_property
    def modes(self) -> LoopModes:
        """The modes of the loop with their tables, which are kept for the next simulation."""
        return LoopModes(LoopSystem(self.interconnection()))

    def __getstate__(self) -> dict[str, Any]:
        """Return what the loop is made of, for pickling; what is computed from that is computed again."""
        return {name: stored(value) for name, value in vars(self).items() if name not in COMPUTED}

    def __setstate__(self, state: dict[str, Any]) -> None:
        """Take what was pickled."""
        vars(self).update((name, restored(value)) for name, value in state.items())


def _shown(part: object) -> str:
    """Show a part in one line; a system would take many."""
    if isinstance(part, control.LTI):
        return f"<{type(part).__name__} of order {len(part.poles())}>"
    return part if isinstance(part, str) else repr(part)


def taken_start(loop: Loop) -> Mapping[str, float]:
    """Return the start of a loop after it was checked; it names states of the linear system."""
    require_instance("start", loop.start, Mapping, "a mapping of states to numbers")
    for name in loop.start:
        if name not in (labels := loop.model.state_labels):
            there = near_or_all(name, labels)
            raise LoopError(f"the start names {name!r}, which is no state of the loop; {there}")
    return ReadOnly({name: finite_number(f"start.{name}", value) for name, value in loop.start.items()})


def require_loop(loop: object) -> None:
    """Check that a loop was given, or else raise a ``WrongTypeError``."""
    require_instance("loop", loop, Loop, "a loop: a ClosedLoop, OpenLoop, Feedback or TrimmerLoop")


class LoopOfOneElement(Loop):
    """A linear system of one input and one output with one element, in feedback or driven."""

    system: control.LTI
    element: Element

    def __post_init__(self) -> None:
        object.__setattr__(self, "system", taken_system(self.system))
        object.__setattr__(self, "element", adopted("element", self.element))
        if hasattr(self, "drive"):
            require_instance("drive", self.drive, Drive, "a trimmer.Drive")
        object.__setattr__(self, "start", taken_start(self))

    def interconnection(self) -> Interconnection:
        """Return the equations, with the input -y of the element, or the drive as its input."""
        pin = connected_around(self.model, self.element, bool(self.driving))
        return interconnected(self.model.A, [pin], self.driving)

    @property
    def has_states(self) -> bool:
        """Whether the system was given in state space."""
        return isinstance(self.system, control.StateSpace)

    @cached_property
    def model(self) -> control.StateSpace:
        """The system as a state-space model: as it was given, or a realization of its transfer function."""
        return realized(self.system)


@final
@dataclass(frozen=True, eq=False, repr=False)
class ClosedLoop(LoopOfOneElement):
    """Negative feedback without reference: the element's input is -y (figure 2.5 of the thesis).

    Attributes:
        system: Strictly proper, one input, one output, continuous in time: a transfer function or
            state-space model of python-control, a system of SciPy, or a tuple (num, den) of descending
            powers, (z, p, k) with roots in rad/s, or (A, B, C, D).
        element: Any element with a description in time.
        start: States of the linear system with which a motion begins, by name; the others are 0.

    Raises:
        WrongTypeError: if the element is none, such as a class in place of an instance.
        LoopError: if the start names what is no state.
        UnsupportedMotionError: if the system is none of these.
        UnsupportedSystemError: if a tuple makes no system, or a system of SciPy is sampled.
    """

    system: control.LTI
    element: Element
    start: Mapping[str, float] = field(default=AT_REST, kw_only=True)


@final
@dataclass(frozen=True, eq=False, repr=False)
class OpenLoop(LoopOfOneElement):
    """The element's input is the drive; its output drives the linear system.

    Attributes:
        system: As that of ``ClosedLoop``.
        element: Any element with a description in time.
        drive: The motion of the pin.
        start: States of the linear system with which a motion begins, by name; the others are 0.

    Raises:
        WrongTypeError: if element or drive is none.
        LoopError: if the start names what is no state.
        UnsupportedMotionError, UnsupportedSystemError: see ``ClosedLoop``.
    """

    system: control.LTI
    element: Element
    drive: Drive
    start: Mapping[str, float] = field(default=AT_REST, kw_only=True)


def connected_around(model: control.StateSpace, element: Element | None, driven: bool) -> Connection:
    """Return an element, or a rigid connection, before a linear system: driven, or in negative feedback."""
    parts = [(RigidComponent(), 1.0)] if element is None else components_of(element)
    labels = [component.name for component, _ in parts]
    if model.D[0, 0] and not driven:
        raise IllPosedLoopError(
            f"{labels[0]}: an output acts on its input at once; the system must be strictly proper"
        )
    row = (0.0 if driven else -1.0) * model.C[0]
    return Connection(parts, labels, model.B[:, 0], row, (1.0,) if driven else ())
