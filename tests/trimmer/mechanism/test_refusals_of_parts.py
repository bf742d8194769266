"""What parts of a machine refuse, each with its sentence: structures, points, curves, walls, outputs."""

from pathlib import Path

import numpy as np
import pytest
from scipy.io import mmwrite

from trimmer import MechanismError
from trimmer.mechanism.reading import mechanism_of_text

MATRICES = {
    "M": np.diag([1.0, 2.0]),
    "K": np.array([[3.0, -1.0], [-1.0, 1.0]]),
    "loss": np.array([[3.0 + 1j, 0.0], [0.0, 1.0 + 1j]]),
}
BODIES = "[bodies]\na = { mass = 1.0 }\ng = { inertia = 1.0 }\n"
LINKS = """
[links]
first = { between = ["ground", "a"], stiffness = 1.0 }
second = { between = ["ground", "g"], stiffness = 1.0 }
"""
HOUSING = '[structures.h]\nmass = "M.mtx"\nstiffness = "K.mtx"\ncoordinates = ["u1", "u2"]\n'
RUBBING = '[frictions]\nrub = {{ between = ["ground", "a"], {} }}\n'
WALL = '[walls]\nwall = {{ between = ["ground", "a"]{} }}\n'
REFUSED = {
    HOUSING.replace(', "u2"', ""): "structures.h.coordinates = ['u1']: holds 1 name for the 2 rows",
    HOUSING.replace("K.", "loss."): "structures.h.stiffness = 'loss.mtx': must be real; a complex stiffness",
    HOUSING
    + 'damping = "K.mtx"\ndamping_ratio = 0.1\n': "damping_ratio = 0.1: there is a damping matrix too",
    HOUSING + 'rotations = ["u3"]\n': "['u3']: there is no coordinate 'u3'; there are 'u1' and 'u2'",
    HOUSING + "[outputs]\nx = { h.u1 = 1 }\n": 'outputs.x.h: write "h.u1" in quotation marks; without them',
    '[structures.h]\nmodes = "modes.csv"\n': "there is no column 'damping_ratio'; a modal model has",
    '[points]\np = { a = "3 mm" }\n': "points.p.a = '3 mm': 'a' is a translation, so that its weight is",
    '[points]\np = { g = "3 N" }\n': "points.p.g = '3 N': 'N' does not measure what",
    RUBBING.format("curve = [[1, 1], [2, 1]]"): "curve.1.speed = 1.0: the curve of a friction begins at the",
    RUBBING.format("curve = [[0, 1], [2, -1]]"): "curve.2.force = -1: must be zero or greater, in N",
    RUBBING.format("curve = [[0, 1], [2, 1]], force = 1"): "force = 1: the curve gives the kinetic force",
    RUBBING.format("curve = [[0, 1], [2, 1]], static = 0.5"): "static = 0.5: the static force is less than",
    WALL.format(""): "walls.wall.restitution: missing; add restitution = 0.5",
    WALL.format(", restitution = 1.2"): "walls.wall.restitution = 1.2: must be from 0 to 1",
    WALL.format(", restitution = -0.1"): "walls.wall.restitution = -0.1: must be from 0 to 1",
    "[outputs]\nx = { velocity = { a = 1 }, a = 1 }\n": "outputs.x.velocity = {'a': 1}: give a number",
    "[outputs]\nx = { velocity = { c = 1 } }\n": "outputs.x.velocity.c = 1: there is no body or pin 'c'",
}


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    made = tmp_path_factory.mktemp("models")
    for name, matrix in MATRICES.items():
        mmwrite(made / f"{name}.mtx", matrix)
    (made / "modes.csv").write_text("frequency,tip\n10,1.0\n", "utf-8")
    return made


@pytest.mark.parametrize("text", REFUSED)
def test_it_is_refused_with_its_sentence(text: str, folder: Path) -> None:
    with pytest.raises(MechanismError) as error:
        mechanism_of_text(BODIES + LINKS + text, "mine.toml", {}, folder)
    assert REFUSED[text] in str(error.value)
    assert "mine.toml: line " in str(error.value)


def test_without_any_of_it_the_file_is_taken(folder: Path) -> None:
    assert mechanism_of_text(BODIES + LINKS + HOUSING, "mine.toml", {}, folder).structures
