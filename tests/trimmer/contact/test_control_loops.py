"""The linear loops of controlled machines, beside margins of python-control."""

from dataclasses import replace
from pathlib import Path

import control
import numpy as np
import pytest

from tests.trimmer.contact.test_controllers import CONTROLLERS, REFERENCES, machine
from tests.trimmer.servos import SERVO
from trimmer import Mechanism
from trimmer.command_line.main import main
from trimmer.contact.control_loops import (
    ControlLoops,
    control_loops,
    instability_told,
    loops_of,
    sampled_loops,
)

s = control.tf("s")
LAWS = {
    "pid": 2.0 + 20.0 / s + 0.03 * s / (3e-3 * s + 1),
    "transfer": (0.03 * s + 2.0) / (1e-6 * s**2 + 4e-3 * s + 1.0),
    "Padé": (0.8 + 0.02 * s / (5e-3 * s + 1)) * control.tf(*control.pade(4e-3, 3)),
}


@pytest.mark.parametrize("kind", LAWS)
@pytest.mark.parametrize("is_open", [False, True])
def test_margins_are_those_of_python_control(kind: str, is_open: bool) -> None:
    found = control_loops(machine(CONTROLLERS[kind], REFERENCES["step"][0]), ("shaft",) if is_open else ())
    k = 0.0 if is_open else 8.0
    motor, load = 2e-4 * s**2 + 2e-3 * s + k, 5e-4 * s**2 + 1e-3 * s + 0.05 + k
    plant = (load + 0.2 * k) / (motor * load - k**2)
    loop = control.minreal(LAWS[kind] * plant, 1e-9, verbose=False)
    expected = control.stability_margins(loop)
    (ours,) = found.loops.values()
    # At the frequency 0, where the integral is infinite, nothing is crossed.
    gain = expected[0] if expected[0] > 1e-9 else np.inf
    wanted = (gain, np.radians(expected[1]), expected[2])
    assert (ours.gain.value, ours.phase.value, ours.modulus.value) == pytest.approx(wanted, rel=1e-6)
    closed = control.feedback(loop, 1).poles()
    assert (found.grows > 0) == bool((closed.real > 1e-6).any())
    for pole in closed:  # The load behind an open gap moves beside them.
        assert abs(found.rates - pole).min() <= 1e-5 * abs(closed).max()


SAMPLE = 2e-3


def sampled_law() -> control.TransferFunction:
    """The pid by the backward rule, as ``docs/mechanism.md`` writes it."""
    z = control.tf("z")
    z.dt = SAMPLE
    share = SAMPLE / (3e-3 + SAMPLE)
    return 2.0 + 20.0 * SAMPLE * z / (z - 1) + 10.0 * (1 - share * z / (z - 1 + share))


def held_plant(delay: float) -> control.StateSpace:
    """From one demand to what is measured at samples: exact over both parts of a sample."""
    k = 8.0
    A = np.zeros((4, 4))
    A[:2, 2:] = np.eye(2)
    A[2:] = [[-k / 2e-4, k / 2e-4, -10.0, 0.0], [k / 5e-4, -(k + 0.05) / 5e-4, 0.0, -2.0]]
    continuous = control.ss(A, [[0.0], [0.0], [5e3], [0.0]], [[1.0, 0.2, 0.0, 0.0]], 0.0)
    if not delay:
        return control.c2d(continuous, SAMPLE)
    early, late = (control.c2d(continuous, each) for each in (delay, SAMPLE - delay))
    whole = np.block([[late.A @ early.A, late.A @ early.B], [np.zeros((1, 5))]])
    read = np.append(continuous.C, [[0.0]], axis=1)
    return control.ss(whole, np.vstack([late.B, [[1.0]]]), read, 0.0, SAMPLE)


@pytest.mark.parametrize("delay", [0.0, 0.8e-3, 2e-3, 4.5e-3])
def test_margins_of_a_sampled_loop_are_those_of_its_exact_discretisation(delay: float) -> None:
    pid = replace(CONTROLLERS["pid"], sample=SAMPLE, delay=delay)
    found = sampled_loops(machine(pid, REFERENCES["step"][0]))
    assert found is not None
    whole, rest = divmod(round(delay * 1e6), round(SAMPLE * 1e6))
    loop = control.ss(sampled_law()) * held_plant(rest * 1e-6)
    for _ in range(whole):
        loop = loop * control.ss([[0.0]], [[1.0]], [[1.0]], [[0.0]], SAMPLE)
    (ours,) = found.loops.values()

    def of(omega: np.ndarray | float) -> np.ndarray:
        return np.asarray(loop(np.exp(1j * np.asarray(omega) * SAMPLE)))

    for gain in (ours.lower_gain, ours.upper_gain):
        if 0.0 < gain.value < np.inf:
            assert of(gain.omega) == pytest.approx(-1.0 / gain.value, rel=1e-7)
    assert of(ours.phase.omega) == pytest.approx(-np.exp(1j * ours.phase.value), rel=1e-7)
    omegas = np.linspace(1e-3, np.pi / SAMPLE, 4_001)
    values = of(omegas)
    assert ours.modulus.value == pytest.approx(abs(1.0 + values).min(), rel=1e-3)
    limits = -1.0 / values.real[:-1][(np.diff(np.sign(values.imag)) != 0) & (values.real[:-1] < 0)]
    assert ours.gain.value == pytest.approx(min(limits, key=lambda each: abs(np.log(each))), rel=3e-2)
    crossed = values[:-1][np.diff(np.sign(abs(values) - 1.0)) != 0]
    assert abs(ours.phase.value) == pytest.approx(abs(np.angle(-crossed)).min(), abs=3e-2)
    closed = control.feedback(loop, 1).poles()
    assert found.stable == bool((abs(closed) < 1.0).all())
    assert np.exp(found.rates.real.max() * SAMPLE) == pytest.approx(abs(closed).max(), rel=1e-9)


@pytest.mark.filterwarnings("error")
def test_a_loop_that_an_open_contact_cuts_has_no_crossings() -> None:
    behind = SERVO.replace("angle = { motor = 1 }", "angle = { load = 1 }")
    (cut,) = control_loops(Mechanism.from_toml_text(behind), ("shaft",)).loops.values()
    assert (cut.gain.value, cut.phase.value, cut.modulus.value) == (np.inf, np.inf, 1.0)
    assert cut.lower_gain.value == 0.0


@pytest.mark.parametrize("sample", [None, SAMPLE])
def test_a_loop_is_stable_between_its_gain_margins_and_not_beyond(sample: float | None) -> None:
    pid = replace(CONTROLLERS["pid"], ki=60.0, sample=sample, tracking=None)

    def standing(factor: float) -> ControlLoops:
        gains = {name: factor * getattr(pid, name) for name in ("kp", "ki", "kd")}
        (found,) = loops_of(machine(replace(pid, **gains), REFERENCES["step"][0]))
        assert found is not None
        return found

    (ours,) = standing(1.0).loops.values()
    assert standing(1.0).stable
    for limit, inwards in ((ours.lower_gain.value, 1.01), (ours.upper_gain.value, 0.99)):
        if 0.0 < limit < np.inf:
            assert standing(limit * inwards).stable
            assert standing(limit / inwards).grows > 0


OPEN = """\
[bodies]
motor = { mass = 1.0 }
load = { mass = 2.0 }
[plays]
nut = { between = ["motor", "load"], stiffness = 1e4, damping = 10.0, gap = 1e-4 }
[links]
bearing = { between = ["ground", "motor"], damping = 3.0 }
rail = { between = ["ground", "load"], damping = 1.0 }
[outputs]
place = { load = 1 }
[controllers.axis]
kind = "pid"
measure = "place"
acts = ["ground", "motor"]
kp = 50.0
ki = 20.0
"""
OF_MOTOR = OPEN.replace("load = 1 }", "motor = 1 }")
MARGINAL = {
    # The load floats: error, integral, speed and place of the motor are each the integral of the last.
    "a measured load": (OPEN, "nothing brings load back, motor and the integral of 'axis' run away"),
    "without an integral": (OPEN.replace("ki = 20.0", ""), "nothing brings load back, motor runs away"),
    "another load": (OF_MOTOR, "nothing brings load back"),
    "an undamped one": (
        OF_MOTOR.replace('"load"], damping = 1.0', '"load"]'),
        "load runs away with the time",
    ),
    "one on a spring": (
        OF_MOTOR.replace('"load"], damping = 1.0', '"load"], stiffness = 32.0'),
        "undamped at 0.6366 Hz",
    ),
}


@pytest.mark.parametrize("case", MARGINAL)
@pytest.mark.parametrize("sample", ["", "sample = 1e-3\n"])
def test_what_nothing_holds_is_marginal_and_named(case: str, sample: str) -> None:
    text, told = MARGINAL[case]
    given = Mechanism.from_toml_text(text.replace("kp = 50.0\n", f"kp = 50.0\n{sample}"))
    (found,) = loops_of(given, ("nut",))
    assert found is not None
    assert found.grows == 0 and not found.stable
    assert found.marginal.startswith(
        told.replace("the integral of 'axis'", "what 'axis' holds") if sample else told
    )
    (closed,) = loops_of(given)
    assert closed is not None
    assert closed.marginal == ""


def test_samples_that_differ_have_no_margins_and_pade_is_named(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    other = OPEN[OPEN.index("[controllers") :].replace(".axis", ".other") + "sample = 3e-3\n"
    (tmp_path / "axis.toml").write_text(f"{OPEN}sample = 1e-3\n{other}")
    assert main(["linear", str(tmp_path / "axis.toml"), "--contacts", "closed"]) == 0
    told = capsys.readouterr().out
    assert "Sampled controllers ('axis' and 'other') are left out, since their samples differ" in told
    assert "with pade = n in place of sample" in told


def test_an_unstable_loop_is_told_before_anything_moves(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert instability_told(Mechanism.from_toml_text(SERVO)) == ""
    # A sampled one that pushes away, beside a continuous one that alone is stable.
    other = OPEN[OPEN.index("[controllers") :].replace(".axis", ".other").replace("kp = 50.0", "kp = -5e4")
    assert "unstable" in instability_told(Mechanism.from_toml_text(f"{OPEN}{other}sample = 1e-3\n"))
    file = tmp_path / "axis.toml"
    file.write_text(SERVO.replace("kd = 0.09", "ki = 9e3"), "utf-8")
    assert main(["simulate", str(file), "--duration", "0.01"]) == 0
    told = capsys.readouterr().err
    assert "controllers: the linear loop is unstable with contacts closed and friction left out" in told
    assert main(["linear", str(file)]) == 0
    assert "With controllers: unstable: it grows by e in" in capsys.readouterr().out


LAGGING = """
[bodies]
slide = { mass = 1.1580472022981074 }
[links]
drag = { between = ["ground", "slide"], damping = 0.2545758633098585 }
[outputs]
place = { slide = 1 }
[controllers.axis]
kind = "transfer"
measure = "place"
acts = ["ground", "slide"]
numerator = [97.84905595783735]
denominator = [0.3123739215764359, 1.0]
sample = 0.005
delay = 0.005
"""


def test_a_zero_at_half_the_sampling_rate_is_no_limit_of_the_gain() -> None:
    """Tustin's 1/(T s + 1) is zero at z = -1: rounding of it gave a margin of 2.5e21."""
    found = sampled_loops(Mechanism.from_toml_text(LAGGING))
    assert found is not None and found.loops["axis"].upper_gain.value == np.inf
