"""Energy over one second of motion: what the pin gives is stored, or lost in dampers and friction."""

import math
from dataclasses import replace

import control
import numpy as np
import pytest

from tests.quick import quick
from trimmer import UnsupportedMotionError, ViscousFriction, simulate
from trimmer.elements import CoulombFriction, FrictionBacklash, InertiaBacklash, ViscousBacklash
from trimmer.loops import BodyFriction, ClosedLoop, Drive, EnergyBalance, TrimmerLoop, energy_balance
from trimmer.thesis import Displacement, InputChannels, TrimmerBody, TrimmerParameters

THESIS = TrimmerParameters.thesis()
SOFT = replace(THESIS, k1=4e4, k5=3e5, m2=0.004, c2=0.2)
DRIVE = Drive(1.5e-3, 2 * math.pi * 110, phase=0.3)
BLADES = BodyFriction(Displacement(TrimmerBody.CUTTER, TrimmerBody.GUARD), CoulombFriction(2.0))
GUARD = BodyFriction(Displacement(TrimmerBody.GUARD), CoulombFriction(0.3) + ViscousFriction(0.2))
ONE_CHANNEL = InputChannels.DISPLACEMENT_ONLY

LOOPS = {
    "closed, friction-controlled": TrimmerLoop(THESIS, FrictionBacklash(4e-5), channels=ONE_CHANNEL),
    "closed, viscous, both channels": TrimmerLoop(THESIS, ViscousBacklash(4e-5, 3e-4)),
    "closed, inertia-controlled, softer": TrimmerLoop(SOFT, InertiaBacklash(4e-5)),
    "closed, friction": TrimmerLoop(THESIS, FrictionBacklash(4e-5), frictions=(BLADES,)),
    "driven, no play": TrimmerLoop(THESIS, None, DRIVE),
    "driven, play": TrimmerLoop(SOFT, ViscousBacklash(2e-4, 1e-3), DRIVE),
    "play, two frictions": TrimmerLoop(THESIS, FrictionBacklash(2e-4), DRIVE, frictions=(BLADES, GUARD)),
    "friction, one channel": TrimmerLoop(SOFT, None, DRIVE, frictions=(BLADES, GUARD), channels=ONE_CHANNEL),
}


@pytest.mark.parametrize("name", quick(sorted(LOOPS), 2, 3, 6))
def test_energy_balance_closes_over_a_second(name: str) -> None:
    loop = LOOPS[name]
    motion = simulate(loop, 1.0, impulse=1e-6)
    balance = energy_balance(motion)
    assert motion.duration == 1.0
    assert balance.residual < 1e-10
    # A sum of parts would close as well if all were zero, or if one were hidden in another.
    assert balance.damping_loss > 1e-6
    assert (balance.friction_loss > 1e-6) == bool(loop.frictions)
    assert abs(balance.pin_work) > 1e-6


def test_energies_are_those_of_springs_and_masses() -> None:
    q, velocities = [1e-4, -2e-4, 3e-5, 5e-5], [0.1, 0.2, -0.3, 0.05]
    rigid = TrimmerLoop(THESIS, None, Drive(0.0, 1.0), channels=ONE_CHANNEL)
    balance = energy_balance(simulate(rigid, 1e-3, initial_state=[*q, *velocities]))
    p = THESIS
    springs = [(p.k1, q[0]), (p.k2, q[0] - q[1]), (p.k5, q[1] - q[2]), (p.k3, q[2]), (p.k4, q[2] - q[3])]
    masses = zip((p.m1, p.m2, p.m3, p.m4), velocities, strict=True)
    assert balance.potential_at_start == pytest.approx(sum(0.5 * k * x**2 for k, x in springs), rel=1e-13)
    assert balance.kinetic_at_start == pytest.approx(sum(0.5 * m * v**2 for m, v in masses), rel=1e-13)
    assert balance.pin_work == 0.0
    assert balance.residual < 1e-12


@pytest.mark.parametrize("element", [None, FrictionBacklash(2e-4)])
def test_rounding_is_not_compared_with_rounding(element: FrictionBacklash | None) -> None:
    """Friction holds the bodies against the pin: no work is done, and nothing is missing."""
    frictions = tuple(
        BodyFriction(Displacement(*bodies), CoulombFriction(force))
        for *bodies, force in (
            (TrimmerBody.HOUSING, 1.0),
            (TrimmerBody.MOTOR, TrimmerBody.CUTTER, 71.0),
            (TrimmerBody.CUTTER, TrimmerBody.GUARD, 62.0),
        )
    )
    loop = TrimmerLoop(THESIS, element, DRIVE, frictions=frictions, channels=ONE_CHANNEL)
    balance = energy_balance(simulate(loop, 0.1))
    assert abs(balance.pin_work) < 1e-12
    assert balance.residual < 1e-10
    assert balance.bridge_energy > 0.01
    missing = replace(balance, damping_loss=balance.damping_loss + 1e-4)
    assert missing.residual > 1e-3


def test_stick_loses_no_energy() -> None:
    friction = replace(BLADES, law=CoulombFriction(1e4))
    stuck = TrimmerLoop(THESIS, None, DRIVE, frictions=(friction,), channels=ONE_CHANNEL)
    balance = energy_balance(simulate(stuck, 0.1))
    assert balance.residual < 1e-10
    assert abs(balance.friction_loss) < 1e-12 * balance.damping_loss


def test_any_other_loop_is_refused() -> None:
    motion = simulate(ClosedLoop(control.tf([1], [1, 1]), FrictionBacklash(1.0)), 1.0)
    with pytest.raises(UnsupportedMotionError, match="TrimmerLoop"):
        energy_balance(motion)


def test_what_is_missing_is_compared_with_the_largest_term() -> None:
    balance = EnergyBalance(1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0)
    # 2 - 1 + 8 - 4 - 16 + 32 + 64 = 85.
    assert (balance.bridge_energy, balance.residual) == (0.0, 85 / 64)
    assert replace(balance, bridge_energy=170.0).residual == 0.5
    assert replace(balance, pin_work=-202.0).residual == 303 / 202
    assert EnergyBalance(*[0.0] * 7).residual == 0.0


def test_a_factor_of_a_friction_counts_in_its_loss_and_the_bridge_at_its_farthest() -> None:
    drive, balances = Drive(1.5e-3, frequency=110.0), []
    for law in (2.0 * CoulombFriction(1.5), CoulombFriction(3.0)):
        loop = TrimmerLoop(THESIS, None, drive, frictions=(BodyFriction("q2-q4", law),))
        balances.append(energy_balance(simulate(loop, 0.02)))
        assert balances[-1].residual < 1e-11
    assert balances[0].friction_loss == pytest.approx(balances[1].friction_loss, rel=1e-9)
    assert balances[0].friction_loss > 1e-3
    assert balances[0].bridge_energy == pytest.approx(0.5 * THESIS.k2 * 1.5e-3**2, rel=1e-4)
    # What the element takes does not reach the bridge.
    half = energy_balance(simulate(TrimmerLoop(THESIS, 0.5 * FrictionBacklash(2e-4), drive), 0.02))
    assert half.bridge_energy == pytest.approx(0.5 * THESIS.k2 * (0.5 * 1.4e-3) ** 2, rel=1e-3)
    assert half.residual < 1e-11


def test_losses_are_those_of_sampled_velocities() -> None:
    """By the trapezium rule over fine samples: dampers from -c v^2, friction from force times velocity."""
    loop = LOOPS["friction, one channel"]
    motion = simulate(loop, 0.02)
    times = np.linspace(0.0, 0.02, 100_001)
    v = motion.state(times)[4:]
    p = SOFT
    dampers = [(p.c1, v[0]), (p.c2, v[0] - v[1]), (p.c3, v[2]), (p.c4, v[2] - v[3])]
    forces = motion.component_outputs(times)[1:]
    rubbed = forces[0] * (v[1] - v[3]) + forces[1:].sum(axis=0) * v[3]
    u = motion.element_output(times)
    pushed = p.k2 * u * (v[1] - v[0]) if loop.channels is ONE_CHANNEL else None
    balance = energy_balance(motion)
    lost = np.trapezoid(sum(c * each**2 for c, each in dampers), times)
    assert balance.damping_loss == pytest.approx(lost, rel=1e-6)
    assert balance.friction_loss == pytest.approx(np.trapezoid(rubbed, times), rel=1e-5)
    assert balance.pin_work == pytest.approx(np.trapezoid(pushed, times), rel=1e-5)
