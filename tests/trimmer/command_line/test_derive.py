"""``trimmer derive FILE``: what it writes, what it says, and what it refuses."""

import runpy
from pathlib import Path

import numpy as np
import pytest

from trimmer.command_line.main import main
from trimmer.mechanism import Mechanism, linear_matrices

EXAMPLES = Path(__file__).parents[3] / "examples"
BELT = EXAMPLES / "block-on-belt.toml"
PLAY = EXAMPLES / "thesis-play.toml"


@pytest.fixture
def folder(monkeypatch, tmp_path):
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_module_gives_the_matrices_of_the_mechanism(folder):
    assert main(["derive", str(PLAY), "--module", "module.py"]) == 0
    module = runpy.run_path("module.py")
    mechanism = Mechanism.from_toml(PLAY)
    values = {f"m_{name}": body.mass for name, body in mechanism.bodies.items()}
    for name, part in {**mechanism.links, **mechanism.plays}.items():
        plain = name.replace(" ", "_")
        values |= {f"k_{plain}": part.stiffness, f"c_{plain}": part.damping}
    values |= {"g_bridge": 40e-6, "sigma_bridge": 1.0}
    del values["c_coil_spring"]
    matrices = linear_matrices(mechanism)
    np.testing.assert_allclose(module["mass_matrix"](**values), matrices.mass)
    np.testing.assert_allclose(module["damping_matrix"](**values), matrices.damping)
    np.testing.assert_allclose(module["stiffness_matrix"](**values), matrices.stiffness)
    assert module["contact_directions"](**values) == ((-1,), (1,), (0,), (0,))
    assert module["friction_directions"](**values) == ((0,), (-1,), (0,), (1,))
    closed = np.array(module["closed_stiffness_matrix"](**values)) - matrices.stiffness
    np.testing.assert_allclose(closed[:2, :2], [[30e3, -30e3], [-30e3, 30e3]])
    state = np.array(module["closed_state_matrix"](**values))
    np.testing.assert_allclose(state[4, 0], -(200e3 + 30e3) / 0.035)
    constant = np.array(module["closed_input_matrix"](**values))[4:, -1]
    np.testing.assert_allclose(constant * [0.035, 0.003, 0.005, 0.030], [0.6, -0.6, 0, 0], atol=1e-15)
