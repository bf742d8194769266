"""The linear mechanism with its contacts closed or open, and its outputs as functionals of what moves."""

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from trimmer.arguments import shown
from trimmer.arrays import Reals
from trimmer.choices import Choice
from trimmer.errors import MechanismError, WrongTypeError
from trimmer.mechanism.linear.matrices import displacement_rows
from trimmer.mechanism.mechanism import Mechanism
from trimmer.mechanism.parts import GROUND, Contact, Link
from trimmer.messages import near_or_all


class Contacts(Choice):
    """Whether a play or a stop is taken as closed, so that it is a link, or as open."""

    CLOSED = "closed"
    OPEN = "open"


def with_contacts(mechanism: Mechanism, contacts: Contacts | str | Mapping[str, Contacts | str]) -> Mechanism:
    """Return a mechanism in which closed contacts are links, all or by name; those not named are closed."""
    known: dict[str, Contact] = {**mechanism.plays, **mechanism.stops}
    if not isinstance(contacts, Mapping | str | Contacts):
        raise WrongTypeError(f"contacts must be 'closed', 'open' or a mapping by name, not {shown(contacts)}")
    every, given = (Contacts.CLOSED, contacts) if isinstance(contacts, Mapping) else (contacts, {})
    for name in given:
        if name not in known:
            raise MechanismError(f"no play or stop is called {name!r}; {near_or_all(name, known)}")
    states = dict.fromkeys(known, Contacts.chosen(every, "contacts"))
    states |= {name: Contacts.chosen(each, "contacts") for name, each in given.items()}
    closed = [name for name, each in states.items() if each is Contacts.CLOSED]
    links = {
        f"closed {name}" if name in mechanism.links else name: Link(
            known[name].between, known[name].stiffness, known[name].damping
        )
        for name in closed
    }
    return replace(
        mechanism,
        links={**mechanism.links, **links},
        plays={name: each for name, each in mechanism.plays.items() if name not in closed},
        stops={name: each for name, each in mechanism.stops.items() if name not in closed},
    )


def output_rows(mechanism: Mechanism) -> Mapping[str, Reals]:
    """Return each output as factors, (3, coordinates + pins), of displacements and their two rates.

    Dry friction and open contacts have no part in it.
    """
    rows = displacement_rows(mechanism)
    found = {}
    for name, output in mechanism.outputs.items():
        factors = np.zeros((3, len(rows[GROUND])))
        if output.part is None:
            assert output.kind.value is not None
            factors[output.kind.value] = sum(weight * rows[of] for of, weight in output.weights.items())
        else:
            (start, end), *slopes = _force(mechanism, output.part)
            factors[:2] = np.outer(slopes, rows[end] - rows[start])
        found[name] = factors
    return found


def _force(mechanism: Mechanism, part: str) -> tuple[tuple[str, str], float, float]:
    """Return between which ends a part acts, its stiffness, N/m, and its damping, N s/m."""
    if part in mechanism.links:
        link = mechanism.links[part]
        return link.between, link.stiffness_at_rest, link.damping
    if part in mechanism.frictions:
        return mechanism.frictions[part].between, 0.0, mechanism.frictions[part].viscous
    return (GROUND, GROUND), 0.0, 0.0
