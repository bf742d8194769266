"""The parts of an energy balance, one by one, with numbers that do not repeat each other."""

from __future__ import annotations

import math
from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from trimmer import (
    CoulombFriction,
    Drive,
    FrictionBacklash,
    InputChannels,
    TrimmerLoop,
    TrimmerParameters,
    simulate,
)
from trimmer.motion import energy
from trimmer.motion.energy import NODES, EnergyBalance, energy_balance
from trimmer.motion.trimmer_loop import BodyFriction

BALANCE = EnergyBalance(1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0)


def test_what_is_missing_is_compared_with_the_largest_term() -> None:
    # 2 - 1 + 8 - 4 - 16 + 32 + 64 = 85.
    assert BALANCE.bridge_energy == 0.0
    assert BALANCE.residual == 85 / 64
    assert replace(BALANCE, bridge_energy=170.0).residual == 0.5
    assert replace(BALANCE, bridge_energy=63.0).residual == 85 / 64
    assert replace(BALANCE, pin_work=-202.0).residual == 303 / 202
    assert replace(BALANCE, pin_work=303.0).residual == 202 / 303
    assert EnergyBalance(*[0.0] * 7).residual == 0.0
    assert EnergyBalance(*[0.0] * 6, 0.5).residual == 1.0


def test_what_is_told() -> None:
    assert BALANCE._told() == "work of the pin 16 J; it closes to 1.3e+00 of its largest term"
    names = ["kinetic_at_start", "kinetic_at_end", "potential_at_start", "potential_at_end"]
    names += ["pin_work", "damping_loss", "friction_loss", "bridge_energy"]
    table = BALANCE._table()
    assert table.title == "Energies and works"
    assert list(table.items) == list(zip(names, (1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0, 0.0), strict=True))


def motion_of(begins: list[float], modes: list[int], duration: float) -> Any:
    tables = SimpleNamespace(step=np.array([0.25, 0.5]))
    log = SimpleNamespace(start=np.array(begins), mode=np.array(modes))
    return SimpleNamespace(
        log=log, duration=duration, loop=SimpleNamespace(modes=SimpleNamespace(tables=tables))
    )


@pytest.mark.parametrize("at_once", [3, 10_000])
def test_the_quadrature_over_steps_of_each_segment(at_once: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(energy, "INTERVALS", at_once)
    # Segments of 0.6, 0, 1.0 and 1.1 s with steps of at most 0.25, 0.5, 0.25 and 0.5 s.
    motion = motion_of([0.0, 0.6, 0.6, 1.6], [0, 1, 0, 1], 2.7)
    parts = list(energy._quadrature(motion))
    assert [len(times) // NODES for times, _ in parts] == ([3, 3, 3, 1] if at_once == 3 else [10])
    times, weights = (np.concatenate(each) for each in zip(*parts, strict=True))
    assert (np.diff(times) > 0).all()
    assert weights.reshape(-1, NODES).sum(axis=1) == pytest.approx([0.2] * 3 + [0.25] * 4 + [1.1 / 3] * 3)
    middles = times.reshape(-1, NODES).mean(axis=1)
    assert middles == pytest.approx(
        [0.1, 0.3, 0.5, *(0.725 + 0.25 * np.arange(4)), *(1.6 + 1.1 / 6 * np.array([1, 3, 5]))]
    )
    assert weights @ np.cos(times) == pytest.approx(math.sin(2.7), rel=1e-14)
    assert weights @ times**2 == pytest.approx(2.7**3 / 3, rel=1e-14)
    assert next(energy._quadrature(motion_of([0.0, 1.0], [0, 0], 1.0)))[0].max() < 1.0


def test_powers_with_and_without_the_velocity_of_the_bridge() -> None:
    q = np.zeros((4, 2))
    rate = np.array([[1.0, -2.0], [4.0, 3.0], [0.5, 0.0], [7.0, 1.0]])
    forces, sliding = np.array([[2.0, 3.0], [5.0, -7.0]]), np.array([[11.0, 13.0], [17.0, 19.0]])
    at = energy._Sampled(q, rate, np.array([1e-3, 2e-3]), np.array([0.5, -0.25]), forces, sliding)
    damping = np.diag([3.0, 0.0, 8.0, 1.0])
    damping[0, 1], damping[1, 0] = 0.25, -0.5
    lost = [3.0 - 0.25 * 4.0 + 8.0 * 0.25 + 49.0, 12.0 + 0.25 * 6.0 + 1.0]
    rubbed = [22.0 + 85.0, 39.0 - 133.0]
    parameters = SimpleNamespace(k2=3e4, c2=0.4)
    for channels, pin in (
        (InputChannels.DISPLACEMENT_ONLY, [30.0 * 3.0, 60.0 * 5.0]),
        (InputChannels.DISPLACEMENT_AND_VELOCITY, [30.2 * 3.0, 59.9 * 5.0]),
    ):
        loop: Any = SimpleNamespace(parameters=parameters, channels=channels)
        np.testing.assert_allclose(energy._powers(loop, damping, at), [pin, lost, rubbed], rtol=1e-14)


def test_a_factor_of_a_friction_counts_in_its_loss_and_the_bridge_at_its_farthest() -> None:
    parameters, drive = TrimmerParameters.thesis(), Drive(1.5e-3, frequency=110.0)
    balances = []
    for law in (2.0 * CoulombFriction(1.5), CoulombFriction(3.0)):
        loop = TrimmerLoop(parameters, None, drive, frictions=(BodyFriction("q2-q4", law),))
        balances.append(energy_balance(simulate(loop, 0.02)))
        assert balances[-1].residual < 1e-11
    assert balances[0].friction_loss == pytest.approx(balances[1].friction_loss, rel=1e-9)
    assert balances[0].friction_loss > 1e-3
    assert balances[0].bridge_energy == pytest.approx(0.5 * parameters.k2 * 1.5e-3**2, rel=1e-4)
    # What the element takes does not reach the bridge.
    loop = TrimmerLoop(parameters, 0.5 * FrictionBacklash(2e-4), drive)
    half = energy_balance(simulate(loop, 0.02))
    assert half.bridge_energy == pytest.approx(0.5 * parameters.k2 * (0.5 * 1.4e-3) ** 2, rel=1e-3)
    assert half.residual < 1e-11
