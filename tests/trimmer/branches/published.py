"""Published examples: special points, rad/s, and branches. Digits: two independent computations."""

import math
from functools import cache

from trimmer import Body, Force, Friction, Link, Mechanism, Output, Pin, Play, follow
from trimmer.branches import FollowedBranch, FollowSettings, SpecialKind

TURN = 2.0 * math.pi
ALONE = FollowSettings(switches=0, quiet=True, largest_step=0.02)

OSCILLATOR_WITH_STOP = [
    (SpecialKind.GRAZING, 5.534678554),
    (SpecialKind.PERIOD_DOUBLING, 5.5567187941),
    (SpecialKind.PERIOD_DOUBLING, 5.7079092816),
    (SpecialKind.FOLD, 8.566393659),
    (SpecialKind.FOLD, 6.9976281194),
    (SpecialKind.GRAZING, 6.997666276),
]
"""An example of pyHarm, from 5 to 12 rad/s."""


@cache
def oscillator_with_a_stop() -> FollowedBranch:
    mechanism = Mechanism.from_toml("examples/oscillator-stop.toml")
    return follow(mechanism, "frequency", 5.0 / TURN, 12.0 / TURN, settings=ALONE)


def two_blocks(speed: float) -> Mechanism:
    """Two blocks on one belt with a spring between them; static friction is twice the kinetic one."""
    return Mechanism(
        bodies={"left": Body(1.0), "right": Body(1.0)},
        pins={"belt": Pin("ground", velocity=speed)},
        links={
            "left spring": Link(("ground", "left"), 1.0, 0.02),
            "right spring": Link(("ground", "right"), 1.0, 0.02),
            "coupling": Link(("left", "right"), 1.2, 0.02),
        },
        frictions={
            "left rubbing": Friction(("belt", "left"), force=0.5, static=1.0),
            "right rubbing": Friction(("belt", "right"), force=0.65, static=1.3),
        },
        outputs={"left": Output({"left": 1})},
    )


def dead_zone(omega: float) -> Mechanism:
    return Mechanism(
        bodies={"body": Body(1.0)},
        frequency=omega / TURN,
        links={"damper": Link(("ground", "body"), damping=0.1)},
        plays={"zone": Play(("ground", "body"), 1.0, gap=2.0)},
        forces={"drive": Force("body", constant=0.1, unbalance=0.05, phase=math.pi / 2.0)},
        outputs={},
    )
