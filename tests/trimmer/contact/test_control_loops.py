"""The linear loops of controlled machines, beside margins of python-control."""

from __future__ import annotations

from pathlib import Path

import control
import numpy as np
import pytest

from tests.trimmer.contact.test_controllers import CONTROLLERS, REFERENCES, SERVO, machine
from trimmer import Mechanism
from trimmer.command_line.main import main
from trimmer.contact.control_loops import control_loops, instability_told

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
    (ours,) = found.loops
    # At the frequency 0, where the integral is infinite, nothing is crossed.
    gain = expected[0] if expected[0] > 1e-9 else np.inf
    wanted = (gain, np.radians(expected[1]), expected[2])
    assert (ours.gain_margin, ours.phase_margin, ours.modulus_margin) == pytest.approx(wanted, rel=1e-6)
    closed = control.feedback(loop, 1).poles()
    assert (found.grows > 0) == bool((closed.real > 1e-6).any())
    for pole in closed:  # The load behind an open gap moves beside them.
        assert abs(found.rates - pole).min() <= 1e-5 * abs(closed).max()


@pytest.mark.filterwarnings("error")
def test_a_loop_that_an_open_contact_cuts_has_no_crossings() -> None:
    behind = SERVO.replace("angle = { motor = 1 }", "angle = { load = 1 }")
    (cut,) = control_loops(Mechanism.from_toml_text(behind), ("shaft",)).loops
    assert (cut.gain_margin, cut.phase_margin, cut.modulus_margin) == (np.inf, np.inf, 1.0)


def test_an_unstable_loop_is_told_before_anything_moves(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert instability_told(Mechanism.from_toml_text(SERVO)) == ""
    file = tmp_path / "axis.toml"
    file.write_text(SERVO.replace("kd = 0.09", "ki = 9e3"), "utf-8")
    assert main(["simulate", str(file), "--duration", "0.01"]) == 0
    told = capsys.readouterr().err
    assert "controllers: the linear loop is unstable with contacts closed and friction left out" in told
    assert main(["linear", str(file)]) == 0
    assert "With controllers: unstable: it grows by e in" in capsys.readouterr().out
