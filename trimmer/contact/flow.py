"""The exact motion of a mechanism: the interface of this package."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from trimmer.arrays import Complexes, Reals
from trimmer.contact.machine.machine import machine_of
from trimmer.contact.machine.statuses import CONTACT_MADE, IMPACT
from trimmer.contact.modes.system import MechanismSystem
from trimmer.contact.readouts.impacts import grazed_walls, impact_at
from trimmer.contact.readouts.outputs import forces_at, outputs_of
from trimmer.contact.readouts.readouts import (
    acceleration,
    contact_measures,
    friction_measures,
    parts_of,
    wall_measures,
)
from trimmer.contact.sampled import SampledControllers
from trimmer.contact.stability import NEGLIGIBLE, damping, is_bounded, is_mirror_symmetric, only_loses_energy
from trimmer.contact.start import instant_at, require_within_walls, set_free
from trimmer.contact.state.frame import Frame, frame_of
from trimmer.contact.state.references import settled_references
from trimmer.hybrid.affine_modes import ArrayChange, is_straight
from trimmer.hybrid.stretch import Instant
from trimmer.hybrid.system import ModeEquations, System
from trimmer.hybrid.tables import Modes
from trimmer.kept_property import cached_property
from trimmer.mechanism import Mechanism
from trimmer.mechanism.kinds import Kind
from trimmer.mechanism.parts import COUPLINGS
from trimmer.mechanism.structures.ends import modes_in
from trimmer.motion.course import Course
from trimmer.motion.flow import Flow
from trimmer.motion.part import Part
from trimmer.motion.part_measures import ContactMeasures, FrictionMeasures
from trimmer.motion.signals import Readout, Signal
from trimmer.motion.subject import Subject
from trimmer.motion.units import Units

NO_MORE = 1e-14  # Share of the largest displacement or velocity up to which another one is rounding
STRETCHED = 1e-2  # Least scale of the stretch of a relaxing spring, relative to the largest displacement


@dataclass(frozen=True, eq=False)
class MechanismFlow(Flow):
    """The exact motion of one mechanism.

    The state of n entries holds the coordinates, m, their velocities, m/s, and the stretches
    of relaxing springs, m, plays before stops, in the order of the mechanism.
    """

    mechanism: Mechanism  # The mechanism
    frame: Frame | None = None  # In which displacements are; that of the ground if not given

    @classmethod
    def returning(cls, mechanism: Mechanism) -> MechanismFlow:
        """Return the motion in the frame in which it repeats, if it does: see ``contact.state.frame``."""
        mechanism = settled_references(mechanism)
        return cls(mechanism, frame_of(mechanism))

    @cached_property
    def modes(self) -> Modes[MechanismSystem]:
        """The modes that were met so far, with their ``system``."""
        machine, layout = machine_of(self.mechanism, self.frame)
        sampled = SampledControllers(self.mechanism, layout) if layout.held else None
        return Modes(MechanismSystem(machine, layout, sampled))

    @property
    def sampled(self) -> SampledControllers | None:
        """The sampled controllers; None without any."""
        clockwork = self.modes.system.clockwork
        return clockwork if isinstance(clockwork, SampledControllers) else None

    @cached_property
    def names(self) -> tuple[str, ...]:
        """What the states are, such as ``motor``, ``motor'`` and ``bridge``."""
        layout = self.modes.system.layout
        controls = [" ".join(each) for each in layout.controls]
        if self.sampled is not None:
            controls += [each for name in layout.held for each in self.sampled.names_of(name)]
        return (
            *layout.coordinates,
            *(f"{body}'" for body in layout.coordinates),
            *layout.relaxing,
            *controls,
        )

    def rest(self, start: Mapping[str, tuple[float, ...]] | None = None) -> Instant:
        """Return the instant t = 0 at which bodies have given displacements, m, and velocities, m/s.

        The others are where the mechanism's own start puts them, or at rest at 0.
        """
        state = self._state_of(start)
        require_within_walls(self.mechanism, self.modes.system, state)
        return self._measured(self.at(state, stretched=False))

    def _measured(self, instant: Instant) -> Instant:
        """Return an instant at which what is measured is what was measured at the last sample."""
        sampled, layout = self.sampled, self.modes.system.layout
        if sampled is None:
            return instant
        mode, state = self.modes.number(instant.statuses), instant.state.copy()
        sampled.require_countable(self.modes[mode].flow[: self.size, : self.size])
        extended = np.concatenate([state, layout.forcing_at(0.0)])
        for place, signal in sampled.remembered(self.modes):
            state[place] = signal(mode) @ extended
        return replace(instant, state=state)

    def _state_of(self, start: Mapping[str, tuple[float, ...]] | None) -> Reals:
        layout = self.modes.system.layout
        count = len(layout.coordinates)
        state = np.zeros(self.size)
        for name, (displacement, velocity) in {**self.mechanism.start, **(start or {})}.items():
            body = layout.coordinates.index(name)
            state[body], state[count + body] = displacement, velocity
        return state

    def near(self, start: Mapping[str, tuple[float, ...]]) -> Instant:
        """Return the same as ``rest``, but with ends that walls hold no farther apart than these allow."""
        return self.at(self._state_of(start), stretched=False)

    def at(
        self, state: Reals, phase: float = 0.0, stretched: bool = True, like: Instant | None = None
    ) -> Instant:
        """Return the instant at which the mechanism is in a given state.

        Args:
            state: Displacements, velocities and, if ``stretched``, stretches of relaxing springs, (n,).
            phase: Time since the start of a drive period, s.
            stretched: Whether the stretches are given; otherwise the springs are as short as can be.
            like: An instant of a neighbouring motion, whose contacts hold and whose frictions stick in this
                one too; the state is made to fit.
        """
        return instant_at(self.modes, state, phase, stretched, like)

    def travelling(self, course: Course) -> tuple[MechanismFlow, Course]:
        """Return a motion in the frame that moves evenly, at its leaders' mean velocities, and its flow.

        There a motion that repeats up to a shift returns to where it was; without leaders nothing changes.
        """
        frame = self.modes.system.layout.frame
        if not frame.follows or not self.shifts:
            return self, course
        bodies, nodes = len(self.modes.system.layout.coordinates), course.nodes
        flow = self.moving(nodes.weights @ nodes.states[:, bodies : 2 * bodies] / course.duration)
        periods = course.end.periods - course.begin.periods
        if periods and course.end.phase == course.begin.phase:
            return flow, flow.course(course.begin, periods)
        return flow, flow.timed(course.begin, course.duration)

    @property
    def shifts(self) -> int:
        """Number of directions along which bodies may be shifted without a change of any force."""
        return len(self.modes.system.layout.frame.leading)

    def advances(self, sizes: Reals) -> bool:
        """Say whether the frame moves on, beyond rounding, beside a motion with the sizes of states, (n,)."""
        velocities = self.modes.system.layout.frame.velocities
        fastest = sizes[len(velocities) : 2 * len(velocities)].max(initial=0.0)
        return bool((abs(velocities) > NEGLIGIBLE * fastest).any())

    def reduced(self, states: Reals) -> Reals:
        """Return states, (..., n), shifted along all directions in which no force changes to leaders at 0."""
        return self.modes.system.layout.frame.reduced(states)

    def grounded(self) -> MechanismFlow:
        """Return the same in the frame of the ground."""
        return MechanismFlow(self.mechanism)

    def moving(self, mean: Reals) -> MechanismFlow:
        """Return the same in a frame that moves evenly, at mean velocities, m/s, (bodies,), of leaders."""
        return MechanismFlow(self.mechanism, self.modes.system.layout.frame.steady(mean))

    def watched(self, instant: Instant, periods: int) -> MechanismFlow:
        """Return the motion in the frame that moves as leaders do in the mean over some drive periods."""
        if not self.modes.system.layout.frame.follows or not self.shifts:
            return self
        count = len(self.modes.system.layout.coordinates)
        still = self.moving(np.zeros(count))
        states = still.strobe(instant, periods).states
        gone = states[-1, :count] - states[0, :count]
        return still.moving(gone / (max(len(states) - 1, 1) * self.period))

    @property
    def subject(self) -> Mechanism:
        """The mechanism."""
        return self.mechanism

    def at_other(self, subject: Subject) -> MechanismFlow:
        """Return the motion of another mechanism, in the frame in which it repeats."""
        assert isinstance(subject, Mechanism)
        return MechanismFlow.returning(subject)

    def between(self, middle: Flow, last: Flow) -> Callable[[Callable[[], Subject], float], System] | None:
        """Return what gives the equations of a mechanism with a number between; see ``Flow.between``."""
        layout, *others = (each.modes.system.layout for each in (self, middle, last))
        arrays = [each.modes.system.machine for each in (self, middle, last)]
        if (
            layout.held
            or not all(layout.is_alike(each) for each in others)
            or not all(map(is_straight, *arrays))
        ):
            return None
        machine = arrays[0]
        changes = {
            name: change
            for name, first, end in zip(machine._fields, machine, arrays[2], strict=True)
            if len((change := ArrayChange.between(first, end)).places)
        }

        def system(_: Callable[[], Subject], share: float) -> MechanismSystem:
            changed = {name: change.on(getattr(machine, name), share) for name, change in changes.items()}
            return MechanismSystem(machine._replace(**changed), layout)

        return system

    def with_modes(self, subject: Callable[[], Subject], modes: Modes[Any]) -> MechanismFlow:
        """Return the motion of another mechanism, in the same frame, whose modes are known."""
        flow = object.__new__(_OfModes)
        vars(flow).update(made=subject, frame=self.frame, modes=modes, parts=self.parts)
        return flow

    @cached_property
    def axes(self) -> Mapping[str, tuple[int, ...]]:
        """Places of the displacement and the velocity of each body."""
        bodies = self.modes.system.layout.coordinates
        return {name: (place, len(bodies) + place) for place, name in enumerate(bodies)}

    @property
    def axis_units(self) -> Mapping[str, tuple[str, ...]]:
        """Units of displacement and velocity of each body."""
        units = {name: self.units_of_body(name) for name in self.axes}
        return {name: (each.length, each.speed) for name, each in units.items()}

    @property
    def units(self) -> Units:
        """Units of translations, or of rotations where nothing else moves."""
        rotates = all(self.mechanism.kinds[name] is Kind.ROTATION for name in self.axes)
        return Units("rad" if rotates else "m")

    def units_of_body(self, body: str) -> Units:
        """Return the units of a body by its name."""
        modal = body in modes_in(vars(self.mechanism))
        return Units("m kg^1/2" if modal else self.mechanism.kinds[body].unit("m"))

    def units_of_part(self, part: str) -> Units:
        """Return the units of a part between two ends by its name."""
        sections = (*COUPLINGS, "controllers")
        section = next(each for each in sections if part in getattr(self.mechanism, each))
        return Units(self.mechanism.kind_of(section, part).unit("m"))

    @cached_property
    def parts(self) -> tuple[Part, ...]:
        """The contacts, then the frictions, the curves and the walls."""
        return parts_of(self.modes.system)

    @cached_property
    def outputs(self) -> Mapping[str, Readout]:
        """The outputs of the mechanism."""
        return outputs_of(self.mechanism, self.modes)

    @cached_property
    def accelerations(self) -> Mapping[str, Signal]:
        """Acceleration of each body, and of each point of modes, m/s² or rad/s²."""
        return {name: acceleration(self.modes, name) for name in self.modes.system.layout.shaken}

    def without_rounding(self, sizes: Reals) -> Reals:
        """Return sizes of states, (n,), 0 for what is rounding beside others of its kind.

        A stretch is a difference of displacements, and known no better than their rounding: its own is at
        least a share of theirs.
        """
        layout = self.modes.system.layout
        displacements, velocities = layout.kinds
        found = layout.lengths * sizes
        for kind in (found[displacements], found[velocities]):
            kind[kind <= NO_MORE * kind.max()] = 0.0
        stretches = found[velocities.stop : layout.first_control]
        np.maximum(stretches, STRETCHED * found[displacements].max(), out=stretches)
        return np.asarray(found / layout.lengths)

    def is_alike(self, other: Flow) -> bool:
        """Say whether another mechanism has the same states and parts, and the same leaders."""
        own, layout = self.modes.system.layout, other.modes.system.layout
        if own is layout:
            return True
        alike = (layout.size, layout.contacts, layout.frictions, layout.curves, layout.walls) == (
            *(own.size, own.contacts, own.frictions, own.curves, own.walls),
        )
        return alike and np.array_equal(layout.frame.leading, own.frame.leading)

    def set_free(self, begin: Instant, change: Reals) -> tuple[int, ...]:
        """Return the statuses at an instant, with what a change of the state, (n,), sets free.

        What is just at its edge goes where the change leads. A friction whose kinetic force is less than the
        static one may leave for good; stick is taken to hold.
        """
        return set_free(self.modes, begin, change)

    @property
    def rubbing(self) -> tuple[str, ...]:
        """Names of the frictions."""
        return tuple(self.mechanism.frictions)

    def impact_speeds(self, course: Course) -> Reals:
        """Return how fast the sides of contacts meet at each impact of a motion, m/s, (impacts,)."""
        log, rates = course.log, self.modes.system.machine.contact_rate
        made = np.flatnonzero(log.kind == CONTACT_MADE)
        speeds = abs((rates[log.part[made]] * log.state[made]).sum(axis=1))
        hit = [impact_at(course, row)[0] for row in np.flatnonzero(log.kind == IMPACT).tolist()]
        return np.append(speeds, hit)

    def grazed(self, course: Course) -> tuple[str, ...]:
        """Return the walls, by name, that a motion touches without speed, as near as can be told."""
        return grazed_walls(course)

    def contacts(self, course: Course, periods: int) -> Mapping[str, ContactMeasures]:
        """Return what each play and stop that exerts a force does, and each wall."""
        layout = self.modes.system.layout
        contacts = {name: contact_measures(course, n, periods) for n, name in enumerate(layout.contacts)}
        return contacts | {name: wall_measures(course, n, periods) for n, name in enumerate(layout.walls)}

    def frictions(self, course: Course, periods: int) -> Mapping[str, FrictionMeasures]:
        """Return what each friction that exerts a force does."""
        names = self.modes.system.layout.frictions
        return {name: friction_measures(course, number, periods) for number, name in enumerate(names)}

    def positions(self, course: Course) -> Mapping[str, float]:
        """Return the displacement of each body, m, at the start of a motion."""
        bodies = self.modes.system.layout.coordinates
        return dict(zip(bodies, course.begin.state[: len(bodies)].tolist(), strict=True))

    def forces(self, course: Course, times: Reals) -> Mapping[str, Reals]:
        """Return the force of each link, play, stop and friction, N, at times, s, that do not decrease."""
        return forces_at(self.mechanism, course, times)

    @cached_property
    def mirrored_states(self) -> Reals:
        """All change their signs."""
        return np.full(self.size, -1.0)

    @property
    def is_mirror_symmetric(self) -> bool:
        """Whether with x(t) also -x(t + T/2) is a motion, T the period of the drive.

        Plays and frictions act on both sides alike; stops do not, nor do constant forces, offsets and
        velocities of pins, and even orders.
        """
        return is_mirror_symmetric(self.mechanism, self.modes.system.layout, self.period)

    @property
    def is_bounded(self) -> bool:
        """Whether links hold and damp every displacement of the bodies, so that no motion can grow for ever.

        Contacts and friction only take energy, and periodic forces and pins bring no more than in proportion
        to the speed. So the energy falls wherever it is large, unless a pin goes on for ever.
        """
        return is_bounded(self.mechanism, self.modes.system.machine)

    @property
    def only_loses_energy(self) -> bool:
        """Whether nothing brings energy into a motion, and something takes it away."""
        return only_loses_energy(self.mechanism, self.modes.system.machine)

    def damping(self, mode: ModeEquations, states: Complexes, rates: Complexes, margins: Reals) -> Reals:
        """Return the real parts of λ, exactly zero where nothing damps or rounding cannot tell.

        The matrices of mass, damping and stiffness are symmetric. So λ of an oscillation is a root of
        m λ² + c λ + k = 0 with m = q* M q, c = q* C q, and its real part is -c/2m; without damping that is 0.
        """
        return damping(self.mechanism, mode, states, rates, margins)


class _OfModes(MechanismFlow):
    """The motion of a mechanism whose modes are known; the mechanism is made when it is asked for."""

    @cached_property
    def mechanism(self) -> Mechanism:
        """The mechanism."""
        subject = vars(self)["made"]()
        assert isinstance(subject, Mechanism)
        return settled_references(subject)
