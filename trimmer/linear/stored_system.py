"""Systems of python-control in a form that can be pickled: a state-space model there holds a function."""

from dataclasses import dataclass
from typing import Any

import control

from trimmer.arrays import Reals


@dataclass(frozen=True, eq=False)
class StoredStateSpace:
    """All that a ``control.StateSpace`` is made of: A, B, C and D, its time base, and names."""

    matrices: tuple[Reals, Reals, Reals, Reals]
    dt: float | bool | None
    name: str
    states: list[str]
    inputs: list[str]
    outputs: list[str]

    def system(self) -> control.StateSpace:
        """Build the system again."""
        labels = {"states": self.states, "inputs": self.inputs, "outputs": self.outputs}
        return control.StateSpace(
            *self.matrices, self.dt, name=self.name, remove_useless_states=False, **labels
        )


def stored(value: Any) -> Any:
    """Return a state-space model in a form that can be pickled, and any other value as it is."""
    if not isinstance(value, control.StateSpace):
        return value
    return StoredStateSpace(
        (value.A, value.B, value.C, value.D),
        value.dt,
        value.name,
        value.state_labels,
        value.input_labels,
        value.output_labels,
    )


def restored(value: Any) -> Any:
    """Return what was stored."""
    return value.system() if isinstance(value, StoredStateSpace) else value
