"""The exact motion of a loop, period by period of its drive, as all that is asked of motion needs it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np

from trimmer.arrays import Complexes, Reals
from trimmer.hybrid.stretch import Instant
from trimmer.hybrid.system import ARRIVED, ModeEquations, System
from trimmer.hybrid.tables import Modes
from trimmer.loops.components.backlash_component import BacklashComponent
from trimmer.loops.components.relay_component import RelayComponent
from trimmer.loops.initial import resumed
from trimmer.loops.loops import Loop
from trimmer.loops.readouts import contact_measures, friction_measures, part_of
from trimmer.loops.system import LoopModes, LoopSystem
from trimmer.motion.course import Course
from trimmer.motion.flow import Flow
from trimmer.motion.part import Part
from trimmer.motion.part_measures import ContactMeasures, FrictionMeasures
from trimmer.motion.signals import Readout, Signal
from trimmer.motion.subject import Subject
from trimmer.motion.units import Units


@dataclass(frozen=True, eq=False)
class LoopFlow(Flow):
    """The exact motion of a loop: n states of the linear system, then of loads behind backlashes."""

    loop: Loop

    @property
    def subject(self) -> Loop:
        """The loop."""
        return self.loop

    @property
    def modes(self) -> LoopModes:
        """The modes that were met so far, with their ``system``."""
        return self.loop.modes

    @cached_property
    def names(self) -> tuple[str, ...]:
        """What the states are, such as ``q1`` and ``backlash position``."""
        interconnection = self.modes.system.interconnection
        own = zip(interconnection.labels, interconnection.components, strict=True)
        of_parts = (f"{label} {name}" for label, component in own for name in component.state_names)
        return (*self.loop.model.state_labels, *of_parts)

    def rest(self, start: Mapping[str, tuple[float, ...]] | None = None) -> Instant:
        """Return the instant t = 0 at rest, or where the loop's own start, or another one, puts it."""
        state = np.zeros(self.size)
        own = {name: (value,) for name, value in self.loop.start.items()}
        for name, values in {**own, **(start or {})}.items():
            state[self.names.index(name)] = values[0]
        return self.at(state, stretched=False)

    def at(
        self, state: Reals, phase: float = 0.0, stretched: bool = True, like: Instant | None = None
    ) -> Instant:
        """Return the instant at which the loop is in a state, (n,), at a phase of the drive, s.

        Loads behind backlashes are where the state says if it is stretched; else they begin at rest
        in the middle of their gap, or where the pin pushes them. The statuses are those of a
        neighbouring instant ``like``, to which the state is made to fit.
        """
        modes, layout = self.modes, self.modes.system.layout
        extended = np.concatenate([state, layout.forcing_at(phase)])
        zeros = np.zeros((modes.system.part_count, modes.system.action_count), dtype=np.int64)
        if like is None:
            statuses, extended, begun = resumed(modes, extended, anew=not stretched)
            zeros[list(begun), ARRIVED] = 1
        else:
            statuses = like.statuses
            extended = modes.held(modes.number(statuses), extended)
        return Instant(extended[: self.size], statuses, 0, phase, zeros, np.zeros(0))

    def at_other(self, subject: Subject) -> LoopFlow:
        """Return the motion of another loop."""
        assert isinstance(subject, Loop)
        return LoopFlow(subject)

    def between(self, middle: Flow, last: Flow) -> Callable[[Callable[[], Subject], float], System] | None:
        """Return what gives the equations of a loop with a number between; see ``Flow.between``."""
        layout, *others = (each.modes.system.layout for each in (self, middle, last))
        if not all(replace(each, drives=()) == replace(layout, drives=()) for each in others):
            return None
        if any((each.forcing_at(0.0) != layout.forcing_at(0.0)).any() for each in others):
            return None
        return None if any(each.omegas != layout.omegas for each in others) else _system_of

    def with_modes(self, subject: Callable[[], Subject], modes: Modes[Any]) -> LoopFlow:
        """Return the motion of another loop, whose modes are known."""
        loop = subject()
        assert isinstance(loop, Loop)
        vars(loop)["modes"] = modes
        return LoopFlow(loop)

    @cached_property
    def axes(self) -> Mapping[str, tuple[int, ...]]:
        """Places in the state of what a start may give, by name: each state of the linear system."""
        order = self.modes.system.layout.order
        return {name: (place,) for place, name in enumerate(self.names[:order])}

    @property
    def axis_units(self) -> Mapping[str, tuple[str, ...]]:
        """Units of these states."""
        return {name: (unit,) for name, unit in zip(self.axes, self.loop.state_units, strict=True)}

    @property
    def units(self) -> Units:
        """Units of what is measured: those of SI for a trimmer, none where nobody said them."""
        return Units(self.loop.length)

    def force_unit(self, part: str) -> str:
        """Return the unit of the output of a component: of the element, or of a friction between bodies."""
        interconnection = self.modes.system.interconnection
        of_element = interconnection.labels[: len(interconnection.element_factors)]
        return self.units.length if part in of_element else self.units.force

    @cached_property
    def parts(self) -> tuple[Part, ...]:
        """The switched components."""
        system = self.modes.system.interconnection
        return tuple(map(part_of, system.labels, system.components))

    @cached_property
    def outputs(self) -> Mapping[str, Readout]:
        """Output of the linear system, input and output of the element; or what the loop names."""
        return {name: Readout(row, self.loop.length) for name, row in self.loop.signal_rows().items()}

    @property
    def accelerations(self) -> Mapping[str, Signal]:
        """None: a loop has no bodies that it knows of."""
        return {}

    @property
    def rubbing(self) -> tuple[str, ...]:
        """Names of the dry frictions."""
        components = self._components
        return tuple(label for _, label, each in components if isinstance(each, RelayComponent) and each.rubs)

    def impact_speeds(self, course: Course) -> Reals:
        """Return how fast pin and load meet at each impact of a motion, (impacts,)."""
        found = [each.impact_speeds for each in self.contacts(course, 1).values()]
        return np.array([speed for speeds in found for speed in speeds])

    def contacts(self, course: Course, periods: int) -> Mapping[str, ContactMeasures]:
        """Return what pin and load of each backlash do."""
        return {
            label: contact_measures(course, part, periods)
            for part, label, component in self._components
            if isinstance(component, BacklashComponent)
        }

    def frictions(self, course: Course, periods: int) -> Mapping[str, FrictionMeasures]:
        """Return what each dry friction does."""
        return {
            label: friction_measures(course, part, periods)
            for part, label, component in self._components
            if isinstance(component, RelayComponent) and component.rubs
        }

    @property
    def _components(self) -> list[tuple[int, str, object]]:
        system = self.modes.system.interconnection
        numbered = zip(system.labels, system.components, strict=True)
        return [(part, label, component) for part, (label, component) in enumerate(numbered)]

    def positions(self, course: Course) -> Mapping[str, float]:
        """Return what is read of the loop at the start of a motion."""
        extended, mode = course.log.state[0], int(course.log.mode[0])
        return {name: float(each.signal(mode) @ extended) for name, each in self.outputs.items()}

    def forces(self, course: Course, times: Reals) -> Mapping[str, Reals]:
        """Return the output of each component at times, s, that do not decrease."""
        (rows, states), system = course.at(times), self.modes.system
        found = np.empty((len(system.interconnection.labels), len(times)))
        for at, (row, state) in enumerate(zip(rows, states, strict=True)):
            mode = self.modes[int(course.log.mode[row])]
            values = np.array([each.output @ state for each in mode.signals])
            found[:, at] = system.coupled.shared(mode.statuses, values)
        return dict(zip(system.interconnection.labels, found, strict=True))

    @cached_property
    def mirrored_states(self) -> Reals:
        """Factors of the states in the mirror image of a motion, (n,): 1 for the share of a velocity left."""
        layout, signs = self.modes.system.layout, np.full(self.size, -1.0)
        components = self.modes.system.interconnection.components
        for first, component in zip(layout.first_states, components, strict=True):
            end = first + component.state_count
            signs[end - component.even_states : end] = 1.0
        return signs

    @property
    def is_mirror_symmetric(self) -> bool:
        """All elements that move in time are odd, and so is a drive whose orders are."""
        return all(order % 2 for order in self.modes.system.layout.orders)

    @property
    def is_bounded(self) -> bool:
        """Not known of loops."""
        return False

    def damping(self, mode: ModeEquations, states: Complexes, rates: Complexes, margins: Reals) -> Reals:
        """Return the real parts of the rates, exactly zero where rounding cannot tell."""
        real: Reals = rates.real.copy()
        real[abs(real) <= margins] = 0.0
        return real


def _system_of(subject: Callable[[], Subject], share: float) -> LoopSystem:
    """Return the equations of a loop."""
    loop = subject()
    assert isinstance(loop, Loop)
    return LoopSystem(loop.interconnection())
