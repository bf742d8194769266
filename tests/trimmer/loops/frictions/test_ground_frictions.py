"""A backlash and two frictions from the ground: the motion goes on through all sticks and slips."""

import numpy as np
import pytest

from trimmer import FrictionBacklash, InertiaBacklash, TrimmerParameters, ViscousBacklash, simulate
from trimmer.elements import CoulombFriction
from trimmer.loops import BodyFriction, Drive, Outcome, TrimmerLoop, energy_balance

THESIS = TrimmerParameters.thesis()
FORCES = ((-2, 2), (-1, 1), (-3, 0.5))  # Decades of the forces, N


def check(seed: int, duration: float) -> None:
    """Follow a random loop to its end: with or without drive, forces that are random or whole numbers."""
    random = np.random.default_rng([12, seed])
    gap = 10 ** random.uniform(-6, -3)
    plays = (FrictionBacklash(gap), InertiaBacklash(gap), ViscousBacklash(gap, 10 ** random.uniform(-5, -1)))
    forces = 10 ** random.uniform(*FORCES[seed // 3 % 3], 2)
    if random.random() < 0.3:
        forces = 1.0 + np.round(forces)
    bodies = random.choice(4, 2, replace=False) + 1
    drives = (None, Drive(1.5e-3, frequency=110.0), Drive(1e-3, frequency=10 ** random.uniform(1.3, 2.7)))
    drive = drives[random.integers(3)]
    loop = TrimmerLoop(
        THESIS,
        plays[seed % 3],
        drive,
        channels=("both", "displacement")[random.integers(2)],
        frictions=[
            BodyFriction(f"q{body}", CoulombFriction(float(force)))
            for body, force in zip(bodies, forces, strict=True)
        ],
    )
    motion = simulate(loop, duration, impulse=0.0 if drive else 10 ** random.uniform(-6, -2))
    assert motion.outcome is Outcome.COMPLETED
    assert energy_balance(motion).residual < 1e-9


@pytest.mark.parametrize("seed", range(9))
def test_each_play_with_each_decade_of_forces(seed: int) -> None:
    check(seed, 0.05)


def test_a_pin_whose_friction_lets_go_stays_in_contact() -> None:
    """Cutter and guard both stick; what is left of the cutter's velocity parted it from the load for ever."""
    check(1230, 0.5)


@pytest.mark.slow
@pytest.mark.parametrize("chunk", range(1000, 1300, 20))
def test_random_loops(chunk: int) -> None:
    for seed in range(chunk, chunk + 10):
        check(seed, 0.5)
