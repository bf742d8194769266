"""Systems of python-control in a form that can be pickled: a state-space model there holds a function."""

from __future__ import annotations

from functools import partial
from typing import Any

import control


def stored(value: Any) -> Any:
    """Return a call that builds a state-space model again, which can be pickled; any other value as it is."""
    if not isinstance(value, control.StateSpace):
        return value
    labels = {"states": value.state_labels, "inputs": value.input_labels, "outputs": value.output_labels}
    matrices = (value.A, value.B, value.C, value.D)
    return partial(
        control.StateSpace, *matrices, value.dt, name=value.name, remove_useless_states=False, **labels
    )


def restored(value: Any) -> Any:
    """Return what was stored."""
    return value() if isinstance(value, partial) else value
