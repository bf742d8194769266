"""Forces that follow a profile over time: digits, closed forms, another integrator, and who refuses them."""

from pathlib import Path

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from tests.trimmer.problem_machines import machine_text
from trimmer import Mechanism, MechanismError, UnsupportedMotionError, respond, simulate
from trimmer.command_line.main import main
from trimmer.mechanism import Body, Force, Friction, Link, Output, Pin


def block(profile: object, **parts: object) -> Mechanism:
    return Mechanism(
        {"block": Body(2.0)},
        frictions={"floor": Friction(("ground", "block"), 1.0, 1.5)},
        forces={"push": Force("block", profile=profile)},  # type: ignore[arg-type]
        outputs={"x": Output({"block": 1.0}), "floor": Output(kind="force", part="floor")},
        **parts,  # type: ignore[arg-type]
    )


def test_a_step_breaks_stick_and_its_end_lets_it_come_back() -> None:
    """1 N is left of 2 N while it slides; then friction brakes it, and what is too little never moves it."""
    motion = simulate(block([[0.1, 1.4], [0.3, 1.4], [0.3 + 1e-9, 3.0], [0.5, 3.0], [0.5 + 1e-9, 0.0]]), 2.0)
    ended, begun = motion.events
    assert (ended.kind.word, begun.kind.word) == ("stick-ended", "stick-begun")
    assert ended.time == pytest.approx(0.3, abs=1e-9)
    assert begun.time == pytest.approx(0.5 + 0.2 * 2.0, abs=1e-8)  # v = 0.2 m/s falls by 0.5 m/s²
    assert motion.output("x", 2.0) == pytest.approx(0.5 * 0.2 * (0.2 + 0.4), abs=1e-8)
    assert motion.rest is not None
    assert motion.output("floor", np.array([0.05, 0.1, 0.2, 0.4, 1.0])) == pytest.approx(
        [0.0, 1.4, 1.4, 1.0, 0.0]
    )


def test_before_the_end_of_a_profile_nothing_rests() -> None:
    assert simulate(block([[1.0, 0.0], [2.0, 3.0]]), 0.5).rest is None
    assert simulate(block([[1.0, 0.0], [2.0, 1.2]]), 2.5).rest is not None
    still = simulate(block([[-1.0, 0.0], [1.0, 1.0]]), 0.5)
    assert still.output("floor", np.array([0.0, 0.5])) == pytest.approx([0.5, 0.75])
    assert simulate(block([[-2.0, 3.0]]), 1.0).output("x", 1.0) == pytest.approx(0.5, rel=1e-12)


def test_beside_a_drive_as_another_integrator_says() -> None:
    mechanism = Mechanism(
        {"body": Body(0.5)},
        frequency=3.0,
        pins={"base": Pin("ground", amplitude=0.01)},
        links={"spring": Link(("base", "body"), 200.0, 1.5)},
        forces={
            "push": Force("body", amplitude=0.4, order=2, profile=((0.2, 1.0), (0.45, 2.0), (1.7, -1.0)))
        },
        outputs={"x": Output({"body": 1.0})},
    )
    motion, omega = simulate(mechanism, 3.1), 6 * np.pi

    def rates(t: float, y: np.ndarray) -> list[float]:
        given = 0.0 if t < 0.2 else float(np.interp(t, (0.2, 0.45, 1.7), (1.0, 2.0, -1.0)))
        u, du = 0.01 * np.sin(omega * t), 0.01 * omega * np.cos(omega * t)
        force = 0.4 * np.sin(2 * omega * t) + given + 200.0 * (u - y[0]) + 1.5 * (du - y[1])
        return [y[1], force / 0.5]

    state, begin = np.zeros(2), 0.0
    for until in (0.2, 0.45, 1.7, 3.1):
        # Just inside, so that a step never sees what lies beyond a point.
        span = (begin + 1e-15 * (begin > 0), until - 1e-15)
        state, begin = solve_ivp(rates, span, state, "DOP853", rtol=1e-13, atol=1e-15).y[:, -1], until
        assert motion.states(until) == pytest.approx(state, rel=1e-9, abs=1e-11)
    assert motion.energy.residual < 1e-11
    assert not motion.events


def test_who_asks_for_what_repeats_refuses_a_profile(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    mechanism = Mechanism.from_toml_text(f"frequency = 5.0\n{machine_text('preloaded-stop')}")
    with pytest.raises(UnsupportedMotionError, match=r"forces\.pulse\.profile: the force follows times"):
        respond(mechanism)
    file = tmp_path / "relay.toml"
    file.write_text(mechanism.to_toml())
    for command in (
        ["respond", str(file)],
        ["follow", str(file), "--vary", "frequency", "--from", "5", "--to", "6"],
        ["map", str(file), "--vary", "frequency=5:6:2"],
        ["sweep", str(file), "--vary", "frequency", "--from", "5", "--to", "6"],
    ):
        assert main(command) != 0, command
        assert "forces.pulse.profile" in capsys.readouterr().err, command
    assert main(["simulate", str(file), "--duration", "0.05", "--plot", str(tmp_path / "relay.svg")]) == 0


@pytest.mark.parametrize(
    ("profile", "place", "reason"),
    [
        ([], "", "give at least one row [time in s, force in N], as in [[0.01, 0.0], [0.012, 1.5]]"),
        ([[0.0, 1.0, 2.0]], "", "give at least one row"),
        ([[0.0, 1.0], [0.0, 2.0]], ".2.time", "the time must rise from point to point"),
        ([[0.0, 1.0], [1.0, float("nan")]], ".2.force", "must be finite"),
    ],
)
def test_profiles_that_are_none(profile: object, place: str, reason: str) -> None:
    with pytest.raises(MechanismError) as caught:
        block(profile)
    assert f"forces.push.profile{place}" in str(caught.value)
    assert reason in str(caught.value)
    moved = block([[0.0, 1.0], [1.0, 2.0]]).with_value("forces.push.profile.2.time", "1500 ms")
    assert moved.forces["push"].profile == ((0.0, 1.0), (1.5, 2.0))
