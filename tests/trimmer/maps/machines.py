"""Mechanisms that maps are tested on."""

import numpy as np

from trimmer.mechanism import Body, Force, Link, Mechanism, Output, Stop

SQUARE_ROOT_OF_40 = float(np.sqrt(40.0))


def impact_oscillator(omega: float = 7.5) -> Mechanism:
    """m = 1, k = 40, force 100 cos, a stop of stiffness 1000 with gap 10: a published example of pyHarm.

    Its branch turns at folds; between the grazing at 6.997666 rad/s, where the motion without contact begins,
    and the fold at 8.566394 rad/s, where that with contact ends, both are stable.
    """
    return Mechanism(
        {"mass": Body(1.0)},
        frequency=omega / (2 * np.pi),
        links={"spring": Link(("ground", "mass"), stiffness=40.0, damping=0.1 * SQUARE_ROOT_OF_40)},
        stops={"wall": Stop(("ground", "mass"), stiffness=1000.0, gap=10.0)},
        forces={"push": Force("mass", amplitude=100.0, phase=np.pi / 2)},
        outputs={"x": Output({"mass": 1.0})},
        title="Impact oscillator",
    )


def linear_oscillator() -> Mechanism:
    """m = 1, k = 40, force 100 cos at 7.5 rad/s."""
    return Mechanism(
        {"mass": Body(1.0)},
        frequency=7.5 / (2 * np.pi),
        links={"spring": Link(("ground", "mass"), stiffness=40.0, damping=0.1 * SQUARE_ROOT_OF_40)},
        forces={"push": Force("mass", amplitude=100.0, phase=np.pi / 2)},
        outputs={"x": Output({"mass": 1.0})},
    )
