"""The compiled code of a checkout that was never used, each part of it compiled by one process of a run.

All processes need it, and each that finds it missing compiles it, for half a minute of the processor. A run
begins its tests when the last process has collected them, so what each compiles before that is there for all.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from trimmer import Mechanism

EXAMPLES = Path(__file__).parent.parent / "examples"
MANY = 2000  # Tests from which on a run needs all of it


def warm_up(tests: int) -> None:
    """Compile this process's share, in a worker of a run of many tests; what is there takes no time."""
    worker = os.environ.get("PYTEST_XDIST_WORKER", "")
    if tests < MANY or not worker:
        return
    count = int(os.environ["PYTEST_XDIST_WORKER_COUNT"])
    for move in SHARES[int(worker.removeprefix("gw")) :: count]:
        with suppress(Exception):  # What does not move, the tests tell.
            move()


def _moved(mechanism: Mechanism) -> None:
    """Move for a period, compute a tangent of that, and sample it."""
    from trimmer.contact.flow import MechanismFlow

    flow = MechanismFlow(mechanism)
    course = flow.course(flow.rest(), 1)
    assert course.monodromy.size
    course.states(np.array([0.0]))


def _driven() -> None:
    """What moves a mechanism, also with impacts, and differentiates by a number."""
    import trimmer

    names = "oscillator-stop", "bouncing-ball"
    stopped, bouncing = (trimmer.Mechanism.from_toml(EXAMPLES / f"{name}.toml") for name in names)
    _moved(bouncing)
    trimmer.follow(stopped, "frequency", 1.0, 1.01)


def _sampled_and_large() -> None:
    """What moves a mechanism under samples, and one of so many bodies that its modes are no tables."""
    import trimmer

    _moved(trimmer.Mechanism.from_toml(EXAMPLES / "sampled-axis.toml"))
    names = [f"body {number}" for number in range(24)]
    bodies = {name: trimmer.Body(1.0) for name in names}
    links = {name: trimmer.Link(("ground", name), stiffness=4e4, damping=5.0) for name in names}
    stops = {f"stop {name}": trimmer.Stop(("ground", name), stiffness=5e5, gap=1.0) for name in names}
    forces = {"force": trimmer.Force(names[0], amplitude=20.0)}
    _moved(trimmer.Mechanism(bodies, links=links, stops=stops, forces=forces, frequency=50.0))


SHARES: tuple[Callable[[], None], ...] = (_driven, _sampled_and_large)
"""Each needs little of what the other compiles, and takes as long."""
