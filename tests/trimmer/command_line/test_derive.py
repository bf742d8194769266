"""``trimmer derive FILE``: what it writes, what it says, and what it refuses."""

import runpy
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from trimmer.command_line.main import main
from trimmer.generated import linear_trimmer
from trimmer.mechanism.matrices import linear_matrices
from trimmer.mechanism.mechanism import Mechanism

EXAMPLES = Path(__file__).parents[3] / "examples"
BELT = EXAMPLES / "block-on-belt.toml"
PLAY = EXAMPLES / "thesis-play.toml"


@pytest.fixture
def folder(monkeypatch, tmp_path):
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_module_and_latex_are_named_after_the_file(folder, capsys):
    assert main(["derive", str(BELT)]) == 0
    printed = capsys.readouterr()
    assert "deriving Block on a belt ..." in printed.err
    written = {path.name for path in (folder / "build" / "derivation").iterdir()}
    assert written == {"block-on-belt.py", "block-on-belt.tex"}
    assert all(name in printed.out for name in written)


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


def test_the_file_of_the_thesis_gives_the_module_in_use(folder):
    assert main(["derive", str(EXAMPLES / "thesis.toml"), "--module", "module.py"]) == 0
    assert Path("module.py").read_bytes() == Path(linear_trimmer.__file__).read_bytes()


def test_a_dash_prints_the_module(folder, project_folder):
    command = [sys.executable, "-m", "trimmer", "derive", str(BELT), "--module", "-", "--latex", "a.tex"]
    environment = {"PYTHONPATH": str(project_folder), "PYTHONIOENCODING": "utf-8"}
    done = subprocess.run(command, capture_output=True, env=environment)
    assert done.returncode == 0
    assert done.stdout.decode().startswith('"""Block on a belt in numbers.')
    assert "a.tex: derivation" in done.stderr.decode()


def test_a_title_cannot_leave_the_docstring(folder):
    """The title goes into a module that is run."""
    text = BELT.read_text(encoding="utf-8")
    wrong = text.replace('"Block on a belt"', '\'"""\\; raise SystemExit("run") #\'')
    Path("belt.toml").write_text(wrong, encoding="utf-8")
    assert main(["derive", "belt.toml", "--module", "module.py", "--latex", "a.tex"]) == 0
    assert "raise SystemExit" in runpy.run_path("module.py")["__doc__"]


def test_names_with_characters_of_latex_are_printed_as_they_are(folder):
    text = BELT.read_text(encoding="utf-8").replace("spring =", '"50 % {x} _ \\\\input{y}" =')
    Path("belt.toml").write_text(text, encoding="utf-8")
    assert main(["derive", "belt.toml", "--module", "module.py", "--latex", "a.tex"]) == 0
    written = Path("a.tex").read_text(encoding="utf-8")
    assert r"$k_{1}$ & stiffness of 50 \% \{x\} \_ \textbackslash{}input\{y\} &" in written
    assert r"\input" not in written
    assert runpy.run_path("module.py")["mass_matrix"]


def test_files_of_the_user_are_kept(folder, capsys):
    Path("mine.py").write_text("print('mine')\n")
    assert main(["derive", str(BELT), "--module", "mine.py"]) == 2
    assert "mine.py is there already and is no derived module" in capsys.readouterr().err
    Path("belt.toml").write_bytes(BELT.read_bytes())
    assert main(["derive", "belt.toml", "--latex", "belt.toml", "--overwrite"]) == 2
    assert "--latex belt.toml: is the file of the mechanism" in capsys.readouterr().err
    assert Path("belt.toml").read_bytes() == BELT.read_bytes()
    assert main(["derive", str(BELT), "--module", "a.py", "--latex", "a.tex"]) == 0
    assert main(["derive", str(PLAY), "--module", "a.py", "--latex", "a.tex"]) == 0, "files of its own kind"


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("mass = 1.0 }", 'mass = 1.0, symbol = "K" }', 'bodies.block.symbol = "K": the derivation uses'),
        ("mass = 1.0 }", "mass = 0.0 }", "must be greater than zero"),
    ],
)
def test_what_cannot_be_derived_is_said_in_a_sentence(folder, capsys, old, new, message):
    Path("belt.toml").write_text(BELT.read_text(encoding="utf-8").replace(old, new), encoding="utf-8")
    assert main(["derive", "belt.toml"]) == 2
    assert message in capsys.readouterr().err
    assert not Path("build").exists()


def test_a_parameter_file_is_named_as_such(folder, capsys):
    assert main(["parameters", "--output", "p.toml"]) == 0
    assert main(["derive", "p.toml"]) == 2
    assert "this is a parameter file" in capsys.readouterr().err
