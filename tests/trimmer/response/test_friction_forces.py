"""Dry frictions that hold the same bodies: their forces, breaking away together, slips that die away."""

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from scipy.optimize import minimize

from tests.mechanisms.comparison import trusted
from tests.mechanisms.random_mechanisms import random_mechanism
from tests.mechanisms.shifted_phases import shifted, state_at
from tests.quick import quick
from trimmer import Body, Force, Friction, Mechanism, Output, respond, simulate
from trimmer.command_line.main import main

PUSHED = """
frequency = 1.0
[bodies]
block = {{ mass = 1.0 }}
[links]
spring = {{ between = ["ground", "block"], stiffness = 100.0 }}
[frictions]
{frictions}
[forces]
push = {{ on = "block", amplitude = {load} }}
"""


def pushed(limits: dict[str, float], load: float) -> Mechanism:
    frictions = [f'{name} = {{ between = ["ground", "block"], force = {F} }}' for name, F in limits.items()]
    return Mechanism.from_toml_text(PUSHED.format(frictions="\n".join(frictions), load=load))


@pytest.mark.parametrize("load", [0.15, 0.9, 1.8, 2.1 * (1 - 1e-15)])
def test_of_two_frictions_side_by_side_the_weak_one_holds_no_more_than_it_can(load: float) -> None:
    motion = simulate(pushed({"weak": 0.1, "strong": 2.0}, load), 1.0)
    times = np.linspace(0.0, 1.0, 41)
    weak, strong = motion.friction_force("weak", times), motion.friction_force("strong", times)
    assert weak + strong == pytest.approx(load * np.sin(2 * np.pi * times), abs=1e-12)
    assert (abs(weak) <= 0.1).all()
    assert (abs(strong) <= 2.0).all()
    assert motion.undetermined_frictions == ("weak", "strong")
    assert motion.energy.frictions == {"weak": 0.0, "strong": 0.0}
    assert motion.energy.undetermined == ()  # There is no pin whose work could rest on it.


def test_equal_frictions_share_equally_and_their_order_does_not_matter() -> None:
    limits = {"one": 0.5, "other": 0.5, "weak": 0.1}
    times = np.linspace(0.0, 1.0, 101)
    motion = simulate(pushed(limits, 1.05), 1.0)
    again = simulate(pushed(dict(reversed(limits.items())), 1.05), 1.0)
    forces = {name: motion.friction_force(name, times) for name in limits}
    assert forces["one"] == pytest.approx(forces["other"], abs=1e-12)
    for name in limits:
        assert again.friction_force(name, times) == pytest.approx(forces[name], abs=1e-12)


def test_as_outputs_they_stay_within_their_limits() -> None:
    weak, strong = (Output(kind="force", part=name) for name in ("weak", "strong"))
    mechanism = replace(pushed({"weak": 0.1, "strong": 2.0}, 2.05), outputs={"weak": weak, "strong": strong})
    found = respond(mechanism).motion.rest
    # Without limits the strong one would bear 2.05 times 4 / 4.01.
    assert found.measures.outputs["strong"].peak_to_peak == pytest.approx(4.0, rel=1e-12)
    assert found.measures.outputs["weak"].peak_to_peak == pytest.approx(0.1, rel=1e-9)


def test_one_friction_alone_is_determined() -> None:
    assert simulate(pushed({"rub": 1.0}, 0.5), 1.0).undetermined_frictions == ()


def ring(limits: np.ndarray, loads: np.ndarray) -> Mechanism:
    """Return two blocks, each rubbing on the ground and on the other, and a second contact between them."""
    between = [("ground", "a"), ("ground", "b"), ("a", "b"), ("a", "b")]
    rubbing = "\n".join(
        f'f{number} = {{ between = ["{start}", "{end}"], force = {limit!r} }}'
        for number, ((start, end), limit) in enumerate(zip(between, limits.tolist(), strict=True))
    )
    first, second = loads.tolist()
    return Mechanism.from_toml_text(f"""
        frequency = 1.0
        [bodies]
        a = {{ mass = 1.0 }}
        b = {{ mass = 3.0 }}
        [frictions]
        {rubbing}
        [forces]
        one = {{ on = "a", amplitude = {first!r} }}
        other = {{ on = "b", amplitude = {second!r} }}
    """)


SHARING = np.array([[1.0, 0.0, -1.0, -1.0], [0.0, 1.0, 1.0, 1.0]])  # resultants on a and b


@pytest.mark.parametrize("seed", quick(range(12), 0, 3, 7))
def test_the_split_is_the_least_among_those_within_the_limits(seed: int) -> None:
    random = np.random.default_rng(seed)
    limits = 10.0 ** random.uniform(-1.5, 0.5, 4)
    loads = SHARING @ (random.uniform(-1.3, 1.3, 4) * limits)
    motion = simulate(ring(limits, loads), 1.0)
    stuck = next((each.time for each in motion.events), 1.0)
    times = np.linspace(0.0, stuck * (1 - 1e-9), 9)
    held = np.array([motion.friction_force(f"f{number}", times) for number in range(4)])
    assert (abs(held) <= limits[:, None]).all()
    wanted = np.outer(loads, np.sin(2 * np.pi * times))
    assert SHARING @ held == pytest.approx(wanted, abs=1e-9 * limits.max())
    for force, resultant in zip(held.T, wanted.T, strict=True):
        found = minimize(
            lambda share: share @ share,
            np.zeros(4),
            jac=lambda share: 2 * share,
            bounds=[(-1.0, 1.0)] * 4,
            constraints={"type": "eq", "fun": lambda s, r=resultant: SHARING @ (s * limits) - r},
            method="SLSQP",
            options={"ftol": 1e-14},
        )
        assert force / limits == pytest.approx(found.x, abs=1e-5)


def test_a_pin_s_work_names_the_share_it_rests_on(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    text = """
        frequency = 1.0
        [bodies]
        block = { mass = 1.0 }
        [pins]
        left = { on = "ground", amplitude = 0.01 }
        right = { on = "ground", amplitude = 0.01 }
        [frictions]
        weak = { between = ["left", "block"], force = 0.1 }
        strong = { between = ["right", "block"], force = 2.0 }
    """
    energy = simulate(Mechanism.from_toml_text(text), 1.3, state={"block": (0.0, 0.02 * np.pi)}).energy
    gained = energy.kinetic[1] - energy.kinetic[0]
    assert energy.residual < 1e-12
    assert sum(energy.pins.values()) == pytest.approx(gained, rel=1e-12)
    assert energy.pins["left"] == pytest.approx(gained * 0.1**2 / (0.1**2 + 2.0**2), rel=1e-9)
    file = tmp_path / "two.toml"
    file.write_text(text)
    assert main(["simulate", str(file), "--duration", "1", "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["undetermined_frictions"] == ["weak", "strong"]
    assert main(["simulate", str(file), "--duration", "1"]) == 0
    assert "weak and strong stick" in capsys.readouterr().out


ON_TOP = {"floor": Friction(("ground", "lower"), 0.8, 0.9), "between": Friction(("lower", "upper"), 0.5, 1.0)}


def test_a_block_breaks_away_from_one_that_stays() -> None:
    """At their static forces both would go."""
    machine = Mechanism(
        {"lower": Body(1.0), "upper": Body(1.0)},
        frictions=ON_TOP,
        forces={"push": Force("upper", constant=4.0)},
    )
    motion = simulate(machine, 2.0)
    assert motion.success
    # But the floor holds 0.5 N, and the upper block has 3.5 of 4 N left.
    places = [motion.displacement(name, np.array([2.0]))[0] for name in ("lower", "upper")]
    assert places == pytest.approx([0.0, 7.0], abs=1e-13)


@pytest.mark.slow
def test_from_rest_the_motion_is_that_by_brute_force() -> None:
    machine = random_mechanism(5030)
    duration = 3 / machine.frequency
    motion, reference = simulate(machine, duration), trusted(machine, duration)
    assert motion.success
    assert reference.horizon > 0.99 * duration
    assert [(each.part, each.kind.value) for each in motion.events] == [
        (each.part, each.kind.value) for each in reference.motion.events
    ]
    times = np.linspace(0.0, reference.horizon, 50)
    ours = np.transpose([motion.displacement(name, times) for name in machine.bodies])
    assert np.allclose(ours, reference.motion.states(times)[:, :2], rtol=0.0, atol=1e-7 * abs(ours).max())


@pytest.mark.parametrize(("seed", "share"), quick([(1069, 0.22), (1125, 0.72)]))
def test_where_slips_die_away_the_motion_is_neutral_whenever_the_clock_begins(seed, share) -> None:
    """On the way their multiplier is below 1, and the return is closed to rounding."""
    machine = random_mechanism(seed)
    others = respond(shifted(machine, share), state=state_at(machine, share), most_periods=300).motion
    motion = respond(machine, most_periods=300).motion
    for each in (motion, others):
        assert (each.orbit.success, each.orbit.stable, each.orbit.neutral) == (True, False, True)
        assert abs(each.orbit.multipliers[0]) == pytest.approx(1.0, abs=1e-7)
        # The brief slips are gone: one friction slides and sticks once a period or not at all.
        assert each.orbit.events_per_period == motion.orbit.events_per_period
    assert np.allclose(*(abs(each.orbit.multipliers[1:]) for each in (motion, others)), atol=1e-6)
