"""A load that nothing damps in its gap bounces ever slower: by restitution, Kelvin and Voigt, or a servo."""

from math import atan2, exp, prod, sqrt

import pytest

from trimmer import Mechanism, MotionKind, respond
from trimmer.response import step_response
from trimmer.response.results.response_json import motion_json

FLYING = """
[bodies]
load = { mass = 0.5 }
[outputs]
load = { load = 1 }
[start]
load = [0, 1]
"""
WALLS = """
[walls]
a = { between = ["ground", "load"], gap = 0.02, restitution = 0.8 }
b = { between = ["load", "ground"], gap = 0.02, restitution = 0.9 }
"""
STOPS = """
[stops]
a = { between = ["ground", "load"], gap = 0.02, stiffness = 1e3, damping = 5 }
b = { between = ["load", "ground"], gap = 0.02, stiffness = 3e3, damping = 1 }
"""
SERVO = """
[bodies]
motor = { mass = 1.0 }
load = { mass = 0.5 }
[links]
rail = { between = ["motor", "ground"], damping = 2.0 }
[plays]
gear = { between = ["motor", "load"], gap = 0.02, stiffness = 1e3, damping = 0.5 }
[references]
path = { step = 0.1 }
[outputs]
motor = { motor = 1 }
load = { load = 1 }
[controllers.servo]
kind = "pid"
kp = 50.0
kd = 8.0
filter_time = 0.01
measure = "motor"
reference = "path"
acts = ["ground", "motor"]
"""
RINGING = """
[bodies]
base = { mass = 1 }
[links]
mount = { between = ["ground", "base"], stiffness = 1e3, damping = 0.02 }
[plays]
gear = { between = ["base", "load"], gap = 0.02, stiffness = 1e3, damping = 0.01 }
"""


def rebound(stiffness: float, damping: float, mass: float = 0.5) -> float:
    """Return the share of a speed that a Kelvin-Voigt wall gives back that cannot pull."""
    zeta = damping / (2 * sqrt(stiffness * mass))
    root = sqrt(1 - zeta**2)
    return exp(-zeta / root * atan2(2 * zeta * root, 2 * zeta**2 - 1))


@pytest.mark.parametrize(
    ("parts", "shares"),
    [(WALLS, (0.8, 0.9)), (STOPS, (rebound(1e3, 5), rebound(3e3, 1)))],
    ids=["walls", "stops"],
)
def test_each_return_takes_longer_by_what_contacts_take_of_the_speed(
    parts: str, shares: tuple[float, ...]
) -> None:
    motion = respond(Mechanism.from_toml_text(FLYING + parts)).motion
    assert motion.kind is MotionKind.UNDECIDED and motion.slowing is not None
    assert motion.slowing.least == pytest.approx(1 / prod(shares), rel=1e-4)
    assert motion.slowing.largest == pytest.approx(1 / prod(shares), rel=1e-4)
    assert motion.message.startswith("It slows down for ever: it never rests, and never repeats.")
    assert motion_json(motion)["slowing"]["last"] == motion.slowing.last > 1e3


@pytest.mark.parametrize("sample", ["", "sample = 5e-3"])
def test_a_servo_does_not_hunt_whose_load_flies_ever_slower(sample: str) -> None:
    """A contact is so short that both masses hit as if they were free."""
    stiff = SERVO.replace("stiffness = 1e3, damping = 0.5", "stiffness = 1e6, damping = 100")
    step = step_response(Mechanism.from_toml_text(stiff + sample))
    slowing = step.settles_to.motion.slowing
    assert slowing is not None and step.hunting is None
    both = 1.5 / (rebound(1e6, 100, mass=1 / 3) - 0.5)  # What a load of 0.5 kg loses to a motor of 1 kg
    assert slowing.largest == pytest.approx(both, rel=5e-3)
    assert step.ending == "while it slows down for ever"


def test_what_only_loses_energy_is_not_chaotic_however_long_it_looks_so() -> None:
    text = RINGING.replace("base = { mass = 1 }", "base = { mass = 1 }\nload = { mass = 0.5 }")
    text += FLYING.replace("[bodies]\nload = { mass = 0.5 }", "")
    assert "Nothing brings energy into it" in respond(Mechanism.from_toml_text(text)).message
    undamped = text.replace("damping = 0.02", "damping = 0").replace("damping = 0.01", "damping = 0")
    assert respond(Mechanism.from_toml_text(undamped)).kind is MotionKind.CHAOTIC
