"""What is refused of a start: ends that are farther apart than a rigid wall lets them be."""

import numpy as np

from trimmer.arrays import Reals
from trimmer.contact.modes.impulses import NEARLY
from trimmer.contact.modes.system import MechanismSystem
from trimmer.errors import MechanismError
from trimmer.mechanism.kinds import kind_of_part
from trimmer.mechanism.mechanism import Mechanism
from trimmer.mechanism.place_text import place_text


def require_within_walls(mechanism: Mechanism, system: MechanismSystem, state: Reals) -> None:
    """Check that walls let a mechanism start from a state, (n,), at t = 0.

    Raises:
        MechanismError: naming the body whose start puts ends most beyond a wall, or else the wall's gap.
    """
    layout = system.layout
    extended = np.concatenate([state, layout.forcing_at(0.0)])
    for name, row in zip(layout.walls, system.machine.wall_distance, strict=True):
        beyond = float(row @ extended)
        if beyond > NEARLY * float(abs(row) @ abs(extended)):
            shares = row[: len(layout.coordinates)] * extended[: len(layout.coordinates)]
            most = int(np.argmax(shares))
            body = layout.coordinates[most] if shares[most] > 0 else None
            place = ("walls", name, "gap") if body is None else ("start", body)
            raise MechanismError(_told(mechanism, name, beyond, body), place=place)


def _told(mechanism: Mechanism, name: str, beyond: float, body: str | None) -> str:
    wall, gap = mechanism.walls[name], place_text(("walls", name, "gap"))
    place, advice = gap, "give another gap, or a body a [start] within it"
    if body is not None:
        place, advice = place_text(("start", body)), f"begin elsewhere, or give {gap} more"
    start, end = wall.between
    unit = kind_of_part(mechanism.kinds, "walls", name, wall).unit("m")
    return (
        f"{place}: at the start {end!r} is {beyond:.6g} {unit} too far from {start!r} "
        f"for the wall {name!r}; {advice}"
    )
