"""The trimmer in motion: backlash at the pin, and friction between any two of its bodies."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import final

import control
import numpy as np

from trimmer.arguments import require_instance, require_instances
from trimmer.displacement import CUTTER_RELATIVE_TO_GUARD, Displacement, TrimmerBody
from trimmer.elements.control_element import adopted
from trimmer.elements.element import Element
from trimmer.linear.model import InputChannels, pin_model
from trimmer.loops.components.of_elements import components_of
from trimmer.loops.drive import Drive
from trimmer.loops.interconnection import Connection, Interconnection, interconnected
from trimmer.loops.loops import AT_REST, Loop, connected_around, taken_start
from trimmer.parameters import TrimmerParameters, require_parameters


@final
@dataclass(frozen=True)
class BodyFriction:
    """A force between two bodies that depends on the displacement of one relative to the other.

    Attributes:
        between: The relative displacement, or that of one body from the ground.
        law: Force against that displacement, N: ``CoulombFriction``, ``ViscousFriction``, a sum of them.
            A negative factor would drive the bodies instead.

    Raises:
        DisplacementError: if ``between``, which may be a label such as ``q2-q4``, is no displacement.
    """

    between: Displacement
    law: Element

    def __post_init__(self) -> None:
        object.__setattr__(self, "between", Displacement.parse(self.between))
        require_instance("law", self.law, Element, "an element, such as CoulombFriction(0.5)")


@final
@dataclass(frozen=True, eq=False, repr=False)
class TrimmerLoop(Loop):
    """The linear trimmer with an element between pin and bridge, and with friction between bodies.

    Attributes:
        parameters: The trimmer, SI units.
        element: Backlash between pin and driving bridge; None for a pin without backlash.
        drive: Motion of the pin relative to the motor; None for the closed loop of harmonic balance, where
            the pin follows -y.
        output: The output y, m.
        channels: Whether the bridge is driven by its displacement alone, as in the thesis, or by its velocity
            too.
        frictions: Forces between bodies.
        start: States with which a motion begins, such as ``{"q1": 1e-3}``, by name; the others are 0.

    Output and channels may also be given by their words, such as ``q2-q4`` and ``both``.

    Raises:
        ChoiceError: if there are no such channels.
        DisplacementError: if the output is no displacement.
        LoopError: if the start names what is no state.
    """

    parameters: TrimmerParameters
    element: Element | None = None
    drive: Drive | None = None
    output: Displacement = CUTTER_RELATIVE_TO_GUARD
    channels: InputChannels = InputChannels.DISPLACEMENT_AND_VELOCITY
    frictions: tuple[BodyFriction, ...] = field(default=())
    start: Mapping[str, float] = field(default=AT_REST, kw_only=True)

    def __post_init__(self) -> None:
        object.__setattr__(self, "output", Displacement.parse(self.output))
        object.__setattr__(self, "channels", InputChannels.chosen(self.channels, "channels"))
        require_parameters(self.parameters)
        if self.element is not None:
            object.__setattr__(self, "element", adopted("element", self.element))
        if self.drive is not None:
            require_instance("drive", self.drive, Drive, "a trimmer.Drive")
        frictions = require_instances(
            "frictions", self.frictions, BodyFriction, "a trimmer.loops.BodyFriction"
        )
        object.__setattr__(self, "frictions", frictions)
        object.__setattr__(self, "start", taken_start(self))

    def _parts(self) -> tuple[object, ...]:
        """Return all but the many parameters."""
        moved = [each for each in (self.element, self.drive, self.start or None) if each is not None]
        return (*moved, f"output {self.output.label}", *self.frictions)

    @property
    def title(self) -> str:
        """What it is, in a few words."""
        parts = [] if self.element is None else [repr(self.element)]
        parts += [f"{each.law!r} on {each.between.label}" for each in self.frictions]
        if self.drive is not None:
            parts.append(f"driven by {self.drive.amplitude:g} m at {self.drive.frequency:.6g} Hz")
        return f"Trimmer, {', '.join([*parts, f'output {self.output.label}'])}"

    @property
    def length(self) -> str:
        """Pin, bridge and bodies move by metres."""
        return "m"

    @property
    def state_units(self) -> tuple[str, ...]:
        """Units of the states: of displacements, then of velocities, or of what stands for them."""
        return ("m",) * len(TrimmerBody) + ("m/s",) * len(TrimmerBody)

    @cached_property
    def model(self) -> control.StateSpace:
        """The linear trimmer from the displacement of the bridge (m) to y (m)."""
        return pin_model(self.parameters, self.output, self.channels)

    def interconnection(self) -> Interconnection:
        """Return the equations; after the components of the element come those of the frictions.

        Raises:
            UnsupportedMotionError: if the element or a friction has no motion in time.
            IllPosedLoopError: if the motion is not determined.
        """
        pin = connected_around(self.model, self.element, bool(self.driving))
        frictions = [self._connected(each) for each in self.frictions]
        return interconnected(self.model.A, [pin, *frictions], self.driving, of_elements=1)

    def _connected(self, friction: BodyFriction) -> Connection:
        between, parts = friction.between, components_of(friction.law)
        labels = [f"{component.name} {between.label}" for component, _ in parts]
        row = np.array(between.row + (0.0,) * len(between.row))
        return Connection(parts, labels, self._acceleration(between), row)

    def _acceleration(self, between: Displacement) -> np.ndarray:
        """Return the rates of all states due to a unit force that works against a relative displacement."""
        values = self.parameters
        masses = np.array([values.m1, values.m2, values.m3, values.m4])
        return np.concatenate([np.zeros(len(masses)), -np.array(between.row) / masses])
