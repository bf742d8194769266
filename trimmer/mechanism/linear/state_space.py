"""The linear mechanism as a state space of python-control, with its contacts closed or open."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np

from trimmer.arguments import shown
from trimmer.errors import MechanismError, WrongTypeError
from trimmer.mechanism.coordinates import Inertia
from trimmer.mechanism.linear.matrices import displacement_rows, linear_matrices
from trimmer.mechanism.linear.outputs import Contacts, output_rows, with_contacts
from trimmer.messages import near_or_all

if TYPE_CHECKING:
    import control

    from trimmer.arrays import Reals
    from trimmer.mechanism.mechanism import Mechanism


def state_space_of(
    mechanism: Mechanism,
    contacts: Contacts | str | Mapping[str, Contacts | str] = Contacts.CLOSED,
    inputs: Iterable[str] | None = None,
    outputs: Iterable[str] | None = None,
) -> control.StateSpace:
    """Return the linear mechanism; arguments and errors are those of ``Mechanism.state_space``.

    With M q'' + C q' + K q = P_u u + P_v u' + F f the second half of the states is w = q' - M^-1 P_v u, so
    that the rate of a pin is no input of its own.
    """
    import control

    mechanism = with_contacts(mechanism, contacts)
    forces = [name for name in mechanism.forces if name not in mechanism.pins]
    named = _chosen("input", inputs, [*mechanism.pins, *forces], "pin or force")
    known = _known(mechanism)
    wanted = _chosen("output", outputs, list(known), "output or coordinate", [*mechanism.outputs])
    matrices = linear_matrices(mechanism, viscous=True)
    of_mass = Inertia(matrices.mass).accelerations
    count = len(matrices.mass)
    flow = matrices.state_matrix
    bound, damped = np.split(flow[count:], 2, axis=1)
    pins = np.array([[pin == name for name in named] for pin in mechanism.pins], dtype=float)
    pushed = np.array([[each == name for name in named] for each in mechanism.forces], dtype=float)
    pins, pushed = (each.reshape(-1, len(named)) for each in (pins, pushed))
    kick = of_mass(matrices.pin_velocity) @ pins
    push = of_mass(matrices.pin_displacement) @ pins + of_mass(matrices.forces) @ pushed + damped @ kick
    rows, direct = [], []
    for name in wanted:
        (at, rate, second), (at_pin, rate_pin, second_pin) = np.split(known[name], [count], axis=1)
        _require_proper(name, named, rate_pin @ pins + second @ kick, second_pin @ pins)
        rows.append(np.concatenate([at + second @ bound, rate + second @ damped]))
        direct.append(at_pin @ pins + rate @ kick + second @ push)
    return control.ss(
        flow,
        np.vstack([kick, push]),
        np.array(rows).reshape(-1, 2 * count),
        np.array(direct).reshape(-1, len(named)),
        inputs=named,
        outputs=wanted,
        states=[*mechanism.coordinates, *(f"{name}'" for name in mechanism.coordinates)],
    )


def _known(mechanism: Mechanism) -> Mapping[str, Reals]:
    """Return all that may be an output, as ``output_rows`` does: outputs, then the other coordinates."""
    rows = displacement_rows(mechanism)
    others = {name: np.array([rows[name], 0 * rows[name], 0 * rows[name]]) for name in mechanism.coordinates}
    return {**others, **output_rows(mechanism)}


def _chosen(
    what: str, names: Iterable[str] | None, known: Sequence[str], kinds: str, usual: Sequence[str] = ()
) -> list[str]:
    """Return the names of inputs or outputs: those given, else the usual ones, else all."""
    if names is None:
        return list(usual or known)
    given = [] if isinstance(names, str) else list(names)
    if isinstance(names, str) or not all(isinstance(name, str) for name in given):
        raise WrongTypeError(f"{what}s must be a sequence of names, not {shown(names)}")
    for name in given:
        if name not in known:
            raise MechanismError(f"no {kinds} is called {name!r}; {near_or_all(name, known)}")
    return given


def _require_proper(name: str, inputs: Sequence[str], rates: Reals, seconds: Reals) -> None:
    """Refuse an output that takes the rate of an input, or its acceleration."""
    for column, pin in enumerate(inputs):
        if rates[column] or seconds[column]:
            raise MechanismError(
                f"output {name!r} takes the {'acceleration' if seconds[column] else 'velocity'} of pin "
                f"{pin!r}, which no state space has whose input is a displacement: leave out one of them "
                "(inputs, outputs)"
            )
