"""The generated module is what the derivation gives, and does what SymPy does."""

import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from derivations.linear_trimmer import derive_linear_trimmer
from derivations.symbols import PARAMETERS
from trimmer.code_generation import derive_sources
from trimmer.command_line.main import main
from trimmer.generated import linear_trimmer

GENERATED = Path(linear_trimmer.__file__)


@pytest.fixture(scope="module")
def sources():
    return derive_sources()


def test_committed_module_is_the_derived_one(sources):
    assert GENERATED.read_text(encoding="utf-8") == sources.module, "run `make derive` and commit the result"


@pytest.mark.slow
def test_sources_do_not_depend_on_the_hash_seed(sources):
    code = (
        "from trimmer.code_generation import derive_sources\n"
        "sources = derive_sources(); print(sources.module + sources.latex, end='')"
    )
    environment = os.environ | {"PYTHONHASHSEED": "12345", "PYTHONIOENCODING": "utf-8"}
    printed = subprocess.run([sys.executable, "-c", code], capture_output=True, check=True, env=environment)
    assert printed.stdout.decode("utf-8") == sources.module + sources.latex


def test_latex_has_the_describing_functions_too(sources):
    for title in ("Ideal relay", "Friction-controlled backlash", "Viscous-controlled backlash"):
        assert rf"\section{{{title}}}" in sources.latex


def test_generated_functions_agree_with_sympy():
    derivation = derive_linear_trimmer()
    generator = np.random.default_rng(5)
    values = [float(value) for value in generator.uniform(0.5, 2.0, len(PARAMETERS))]
    point = dict(zip((quantity.symbol for quantity in PARAMETERS), values, strict=True))
    expected = {
        "mass_matrix": derivation.matrices.mass,
        "damping_matrix": derivation.matrices.damping,
        "stiffness_matrix": derivation.matrices.stiffness,
        "state_matrix": derivation.space.a,
        "input_matrix": derivation.space.b,
    }
    for name, matrix in expected.items():
        numeric = np.array(matrix.subs(point), dtype=float)
        np.testing.assert_allclose(getattr(linear_trimmer, name)(*values), numeric, rtol=1e-13)
    rows = {
        "characteristic_polynomial": [derivation.transfer.denominator],
        "displacement_numerators": derivation.transfer.from_displacement,
        "velocity_numerators": derivation.transfer.from_velocity,
    }
    for name, symbolic in rows.items():
        numeric = [[float(entry.subs(point)) for entry in row] for row in symbolic]
        found = np.atleast_2d(getattr(linear_trimmer, name)(*values))
        np.testing.assert_allclose(found, numeric, rtol=1e-12, atol=1e-15)


@pytest.mark.slow
def test_derive_command_writes_both_files(tmp_path, capsys, sources):
    module, document = tmp_path / "deep" / "module.py", tmp_path / "text.tex"
    assert main(["derive", "--module", str(module), "--latex", str(document)]) == 0
    assert module.read_text(encoding="utf-8") == sources.module
    assert document.read_text(encoding="utf-8") == sources.latex
    assert "the same as the one in use" in capsys.readouterr().out


def test_derive_command_says_what_cannot_be_written(tmp_path, capsys):
    assert main(["derive", "--module", str(tmp_path), "--latex", str(tmp_path / "text.tex")]) == 2
    assert "is a folder" in capsys.readouterr().err
