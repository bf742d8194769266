"""A linear system of any size with any number of elements between its outputs and its inputs."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from itertools import product
from typing import Any, final

import control
import numpy as np

from trimmer.arguments import require_instance
from trimmer.arrays import Reals
from trimmer.elements.control_element import adopted
from trimmer.elements.element import Element
from trimmer.errors import IllPosedLoopError, LoopError, UnsupportedMotionError
from trimmer.linear.plant_forms import is_plain_form
from trimmer.loops.components.of_elements import components_of
from trimmer.loops.components.relay_component import RelayComponent
from trimmer.loops.drive import Drive
from trimmer.loops.interconnection import Connection, Interconnection, effect, interconnected
from trimmer.loops.loop_signal import LoopSignal
from trimmer.loops.loops import AT_REST, ClosedLoop, Loop, taken_start
from trimmer.loops.plant import in_state_space, taken_system
from trimmer.mechanism.read_only import ReadOnly
from trimmer.messages import near_or_all
from trimmer.motion.signals import Signal, Steady

UNDRIVEN: Mapping[str, Drive] = ReadOnly({})


@final
@dataclass(frozen=True, eq=False, repr=False)
class Feedback(Loop):
    """A linear system with elements and drives, joined by the names of its signals.

    The element ``"gap"`` takes the output ``"gap"`` of the plant and feeds its input ``"gap"``, with no sign
    added: where an element works against the motion, as friction does, the plant's B carries the minus. The
    input of ``CoulombFriction`` and ``ViscousFriction`` is a velocity here. Inputs without an element or a
    drive are zero.

    Attributes:
        plant: A system of python-control with named signals. A system of SciPy, or a tuple (num, den),
            (z, p, k) or (A, B, C, D), has no names; with one input and one output they are that of the one
            element.
        elements: The elements by name, at least one.
        drives: What drives other inputs, by their names.
        start: States of the plant with which a motion begins, by name; the others are 0.

    Raises:
        WrongTypeError: if an element or a drive is none.
        LoopError: if a name has no partner, or the start names what is no state.
        IllPosedLoopError: if elements act on each other without delay, or a friction does not work against
            the rate of its input.
        UnsupportedMotionError: if the plant is no such system, or an element has no motion in time.
    """

    plant: control.StateSpace
    elements: Mapping[str, Element]
    drives: Mapping[str, Drive] = UNDRIVEN
    start: Mapping[str, float] = field(default=AT_REST, kw_only=True)

    def __post_init__(self) -> None:
        elements = _named("elements", self.elements, "an element, such as {'gap': DeadZone(0.01)}")
        if not elements:
            raise LoopError("elements: give at least one; without any, python-control has the motion")
        taken = {name: adopted(f"elements[{name!r}]", one) for name, one in elements.items()}
        drives = _named("drives", self.drives, "a Drive, such as {'r': Drive(0.1, frequency=2)}")
        for name, drive in drives.items():
            require_instance(f"drives[{name!r}]", drive, Drive, "a trimmer.Drive")
        object.__setattr__(self, "plant", _plant(self.plant, tuple(taken)))
        object.__setattr__(self, "elements", ReadOnly(taken))
        object.__setattr__(self, "drives", ReadOnly(drives))
        self._require_partners()
        self._require_delays()
        object.__setattr__(self, "start", taken_start(self))
        self._require_resistance()

    @property
    def model(self) -> control.StateSpace:
        """The plant."""
        return self.plant

    @property
    def driving(self) -> tuple[Drive, ...]:
        """The drives, in their order."""
        return tuple(self.drives.values())

    def interconnection(self) -> Interconnection:
        """Return the equations; the components of an element stand together, in the order of the elements."""
        connections = [self._connected(name, element) for name, element in self.elements.items()]
        push = self.plant.B[:, self._driven]
        return interconnected(self.plant.A, connections, self.driving, push)

    def as_closed_loop(self) -> ClosedLoop | None:
        """Return the same as a ``ClosedLoop``; None if it has several elements, a drive or a friction."""
        (name, element), *others = self.elements.items()
        rubs = components_of(element, of_velocity=True) != components_of(element)
        if others or self.drives or rubs:
            return None
        ((column, row),) = self.element_sides
        A, states = self.plant.A, self.plant.state_labels
        system = control.ss(A, column[:, None], -row[None], 0.0, states=states, inputs=[name], outputs=[name])
        return ClosedLoop(system, element, start=self.start)

    def _connected(self, name: str, element: Element) -> Connection:
        parts = components_of(element, of_velocity=True)
        taken, fed = self._places(name)
        labels = _labels(name, [component.name for component, _ in parts])
        gains = tuple(self.plant.D[taken, self._driven].tolist())
        return Connection(parts, labels, self.plant.B[:, fed], self.plant.C[taken], gains)

    def _places(self, name: str) -> tuple[int, int]:
        """Return the numbers of the output that an element takes, and of the input that it feeds."""
        return self.plant.output_labels.index(name), self.plant.input_labels.index(name)

    @property
    def _driven(self) -> list[int]:
        return [self.plant.input_labels.index(name) for name in self.drives]

    @property
    def element_sides(self) -> tuple[tuple[Reals, Reals], ...]:
        """What each element does to the rates of the states, (n,), and what it takes of the states, (n,)."""
        places = map(self._places, self.elements)
        return tuple((self.plant.B[:, fed], self.plant.C[taken]) for taken, fed in places)

    def signal_rows(self) -> Mapping[str, Signal]:
        """Return the outputs of the plant, those of the elements, as ``gap output``, and states, by name.

        Where a state is called like an output, the output is meant.
        """
        rows = {name: self._output(number) for number, name in enumerate(self.plant.output_labels)}
        rows |= {f"{name} output": self._fed(name) for name in self.elements}
        for place, name in enumerate(self.plant.state_labels):
            rows.setdefault(name, Steady(np.eye(1, self.modes.system.layout.size, place)[0]))
        return rows

    def own_row(self, signal: object) -> Signal | None:
        """Return a signal by name; what every loop has is that of the first element.

        Raises:
            LoopError: if there is no such name.
        """
        first, rows = next(iter(self.elements)), self.signal_rows()
        every = {
            LoopSignal.OUTPUT: self.plant.output_labels[0],
            LoopSignal.ELEMENT_INPUT: first,
            LoopSignal.ELEMENT_OUTPUT: f"{first} output",
        }
        name = every.get(signal) if isinstance(signal, LoopSignal) else signal
        if not isinstance(name, str):
            return None
        if name not in rows:
            raise LoopError(f"no signal is called {name!r}; {near_or_all(name, rows)}")
        return rows[name]

    def _fed(self, name: str) -> Signal:
        counts = [len(components_of(element)) for element in self.elements.values()]
        number = list(self.elements).index(name)
        parts = slice(sum(counts[:number]), sum(counts[: number + 1]))
        modes = self.modes
        factors = np.array(modes.system.interconnection.element_factors[parts])

        def row(mode: int) -> Reals:
            fed: Reals = factors @ np.array([each.output for each in modes[mode].signals[parts]])
            return fed

        return row

    def _output(self, number: int) -> Signal:
        layout, plant = self.modes.system.layout, self.plant
        steady = np.zeros(layout.size)
        steady[: layout.order] = plant.C[number]
        for place, (column, drive) in enumerate(zip(self._driven, self.driving, strict=True)):
            steady[layout.sine + 2 * place] = plant.D[number, column] * drive.amplitude
        gains = [(plant.D[number, self._places(name)[1]], self._fed(name)) for name in self.elements]
        through = [(gain, fed) for gain, fed in gains if gain]
        return lambda mode: sum((gain * fed(mode) for gain, fed in through), steady)

    def _require_partners(self) -> None:
        """Check that each element has an output and an input, and each drive an input of its own."""
        sides = (("output", self.plant.output_labels), ("input", self.plant.input_labels))
        for name in self.elements:
            for side, labels in sides:
                if name not in labels:
                    raise LoopError(_missing(f"the element {name!r}", name, side, labels))
        for name in self.drives:
            if name in self.elements:
                raise LoopError(f"the input {name!r} has an element, so that no drive can set it too")
            if name not in self.plant.input_labels:
                raise LoopError(_missing(f"the drive {name!r}", name, "input", self.plant.input_labels))

    def _require_delays(self) -> None:
        """Check that no element acts without delay on an element."""
        for taking, feeding in product(self.elements, repeat=2):
            gain = float(self.plant.D[self._places(taking)[0], self._places(feeding)[1]])
            if gain:
                other = "itself" if feeding == taking else f"the element {taking!r}"
                raise IllPosedLoopError(
                    f"the element {feeding!r} acts on {other} without delay: D of the plant is {gain!r} from "
                    f"its input {feeding!r} to its output {taking!r}, and must be 0; put what lies between "
                    "into the plant, with its lag"
                )

    def _require_resistance(self) -> None:
        """Check that frictions work against velocities."""
        system = self.interconnection()
        for k, (label, component) in enumerate(zip(system.labels, system.components, strict=True)):
            if isinstance(component, RelayComponent) and component.of_velocity:
                works = effect(system.C[k], system.B[:, k])
                if works >= 0:
                    does = "acts not at once on" if works == 0 else "drives"
                    raise IllPosedLoopError(
                        f"{label}: the friction {does} what the output of its name gives (C B is "
                        f"{float(system.C[k] @ system.B[:, k]):.6g}, and must be negative); let this output "
                        "be the velocity at which it slides, and let B carry the minus of its force"
                    )


def _named(name: str, values: Any, wanted: str) -> dict[str, Any]:
    require_instance(name, values, Mapping, f"a mapping of names to {wanted}")
    for each in values:
        require_instance(f"a name in {name}", each, str, "text")
    return dict(values)


def _missing(what: str, name: str, side: str, labels: Sequence[str]) -> str:
    return (
        f"{what} has no partner: the plant has no {side} {name!r}; {near_or_all(name, labels)}. "
        f"Name the signals of the plant, as control.ss(plant, {side}s=[...]) does"
    )


def _labels(name: str, components: Sequence[str]) -> list[str]:
    """Return names of the components of an element: its own if there is one, else numbered where alike."""
    if len(components) == 1:
        return [name]
    before = [components[:place].count(each) for place, each in enumerate(components)]
    numbers = [f" {count + 1}" if count else "" for count in before]
    return [f"{name} {each}{number}" for each, number in zip(components, numbers, strict=True)]


def _plant(system: object, names: tuple[str, ...]) -> control.StateSpace:
    """Return a plant in state space; what has no names takes that of its one element."""
    plant = in_state_space(taken_system(system))
    if not is_plain_form(system):
        return plant
    if len(names) != 1 or (plant.ninputs, plant.noutputs) != (1, 1):
        what = f"{type(system).__name__}{'' if isinstance(system, tuple) else ' of SciPy'}"
        raise UnsupportedMotionError(
            f"plant: a {what} has no names of its {plant.ninputs} inputs and "
            f"{plant.noutputs} outputs; give control.ss(A, B, C, D, inputs=[...], outputs=[...])"
        )
    return control.ss(plant, inputs=list(names), outputs=list(names))
