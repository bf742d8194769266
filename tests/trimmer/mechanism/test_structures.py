"""Structures in files: what they give, how they are written again, and every refusal with its line."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from trimmer import MechanismError
from trimmer.mechanism import Mechanism, ModalModel, Stop, Structure

REAL = "%%MatrixMarket matrix array real general\n2 2\n"
FILES = {
    "M.mtx": "%%MatrixMarket matrix coordinate real symmetric\n2 2 3\n1 1 2\n2 1 0.5\n2 2 1\n",
    "K.mtx": REAL + "40\n-10\n-10\n30\n",
    "C.mtx": REAL + "0.4\n0\n0\n0.3\n",
    "three.mtx": "%%MatrixMarket matrix coordinate real symmetric\n3 3 3\n1 1 1\n2 2 1\n3 3 1\n",
    "wide.mtx": "%%MatrixMarket matrix array real general\n1 2\n1\n2\n",
    "skew.mtx": REAL + "4\n1\n1.001\n3\n",
    "nearly.mtx": REAL + "40\n-10\n-10.00000001\n30\n",
    "complex.mtx": "%%MatrixMarket matrix array complex general\n1 1\n1 2\n",
    "massless.mtx": REAL + "1\n1\n1\n1\n",
    "negative.mtx": REAL + "1\n2\n2\n1\n",
    "large.mtx": "%%MatrixMarket matrix coordinate real general\n2000 2000 1\n1 1 1\n",
    "text.mtx": "mass 3\n",
    "modes.csv": "frequency; damping_ratio; tip; rear end\n0; 0; 1; 1\n120; 0.01; 2; -1\n",
    "no-ratio.csv": "frequency\ttip\n100\t1\n",
    "no-point.csv": "frequency, damping_ratio\n100, 0.01\n",
    "below.csv": "frequency, damping_ratio, tip\n100, -0.01, 1\n",
    "word.csv": "frequency, damping_ratio, tip\n# measured\n100, none, 1\n",
    "short.csv": "frequency, damping_ratio, tip\n100, 0.01\n",
    "twice.csv": "frequency, damping_ratio, tip, tip\n100, 0.01, 1, 1\n",
    "taken.csv": "frequency, damping_ratio, mode1\n100, 0.01, 1\n",
    "empty.csv": "frequency, damping_ratio, tip\n",
}
WHOLE = 'mass = "M.mtx"\nstiffness = "K.mtx"\ncoordinates = ["u1", "u2"]\n'
REST = '[stops]\nwall = { between = ["ground", "housing.%s"], stiffness = 1e3 }\n'


@pytest.fixture(name="folder")
def folder_with_files(tmp_path: Path) -> Path:
    for name, text in FILES.items():
        (tmp_path / name).write_text(text)
    return tmp_path


def machine(folder: Path, keys: str, end: str = "u1", more: str = "") -> Mechanism:
    path = folder / "machine.toml"
    path.write_text(f"[structures.housing]\n{keys}{REST % end}{more}")
    return Mechanism.from_toml(path)


def refusal(folder: Path, keys: str, end: str = "u1", more: str = "") -> str:
    """Return what is said against a machine, with the quotation marks of TOML."""
    with pytest.raises(MechanismError) as raised:
        machine(folder, keys, end, more)
    return str(raised.value).replace("'", '"')


def test_a_file_gives_matrices_and_names_and_is_written_out(folder: Path) -> None:
    read = machine(folder, WHOLE + 'damping = "C.mtx"\nrotations = ["u2"]\n')
    assert read.coordinates == ("housing.u1", "housing.u2")
    mass, damping, stiffness = read.structures["housing"].matrices
    assert mass.tolist() == [[2.0, 0.5], [0.5, 1.0]]
    assert damping.tolist() == [[0.4, 0.0], [0.0, 0.3]]
    assert stiffness.tolist() == [[40.0, -10.0], [-10.0, 30.0]]
    assert read.places['start."housing.u2".velocity'] == "rad/s"
    assert "mass = [[2.0, 0.5], [0.5, 1.0]]" in read.to_toml()
    assert Mechanism.from_toml_text(read.to_toml()) == read
    nearly = machine(folder, WHOLE.replace("K.mtx", "nearly.mtx"))
    assert (nearly.structures["housing"].matrices[2] == nearly.structures["housing"].matrices[2].T).all()


def test_modes_have_unit_mass_and_points(folder: Path) -> None:
    read = machine(folder, 'modes = "modes.csv"\n', "rear end", '[start]\n"housing.mode2" = [0, 1]\n')
    assert read.coordinates == ("housing.mode1", "housing.mode2")
    mass, damping, stiffness = read.structures["housing"].matrices
    omega = 2 * np.pi * 120
    assert (mass == np.eye(2)).all()
    assert damping == pytest.approx(np.diag([0.0, 0.02 * omega]))
    assert stiffness == pytest.approx(np.diag([0.0, omega**2]))
    assert Mechanism.from_toml_text(read.to_toml()) == read


@pytest.mark.parametrize(
    "structure",
    [
        Structure(np.eye(2), [[1.0, -1.0], [-1.0, 1.0]], damping_ratio=0.1, coordinates=["tip", "b"]),
        Structure(modes=ModalModel([1.0, 2.0], [0.1, 0.0], {"tip": [1.0, 0.5], "b c": [0.0, 2.0]})),
    ],
)
def test_what_came_from_no_file_is_written_whole(structure: Structure) -> None:
    made = Mechanism(structures={"s": structure}, stops={"wall": Stop(("ground", "s.tip"), 1.0)})
    assert Mechanism.from_toml_text(made.to_toml()) == made
    assert hash(Mechanism.from_toml_text(made.to_toml())) == hash(made)


def test_structures_are_equal_only_with_all_their_numbers_and_names() -> None:
    matrices = Structure(np.eye(2), np.eye(2), damping_ratio=0.1, coordinates=("a", "b"))
    modes = ModalModel(np.ones(2), np.zeros(2), {"tip": np.ones(2)})
    modal = Structure(modes=modes)
    others = [
        replace(matrices, mass=2.0 * np.eye(2)),
        replace(matrices, stiffness=2.0 * np.eye(2)),
        replace(matrices, damping=np.eye(2)),
        replace(matrices, damping_ratio=0.2),
        replace(matrices, coordinates=("a", "c")),
        replace(matrices, rotations=("a",)),
        replace(modal, modes=replace(modes, frequency=np.array([1.0, 2.0]))),
        replace(modal, modes=replace(modes, damping_ratio=np.array([0.0, 0.1]))),
        replace(modal, modes=replace(modes, shapes={"tip": np.array([1.0, 2.0])})),
        replace(modal, modes=replace(modes, shapes={"end": np.ones(2)})),
    ]
    assert len({matrices, modal, *others}) == 12
    assert replace(matrices, files={"mass": "M.mtx"}) == matrices


def test_a_damping_ratio_is_a_place_where_it_says_the_damping(folder: Path) -> None:
    read = machine(folder, WHOLE)
    assert read.value("structures.housing.damping_ratio") == 0.0
    damped = read.with_value("structures.housing.damping_ratio", "0.02")
    assert damped.value("structures.housing.damping_ratio") == 0.02
    assert damped.structures["housing"].matrices[1].any()
    for keys, end in ((WHOLE + 'damping = "C.mtx"\n', "u1"), ('modes = "modes.csv"\n', "tip")):
        assert "structures.housing.damping_ratio" not in machine(folder, keys, end).places


REFUSED = [
    ("", 'line 1: structures.housing.mass: missing; give mass = "M.mtx" and stiffness = "K.mtx", or modes'),
    ('mass = "M.mtx"\n', 'line 1: structures.housing.stiffness: missing; add stiffness = "K.mtx"'),
    (WHOLE.replace("M.mtx", "N.mtx"), 'line 2: structures.housing.mass = "N.mtx": no such file'),
    (WHOLE.replace("M.mtx", "text.mtx"), 'line 2: structures.housing.mass = "text.mtx": is no Matrix Market'),
    (WHOLE.replace("M.mtx", "wide.mtx"), 'mass = "wide.mtx": must be square; its shape is 1 x 2'),
    (WHOLE.replace("M.mtx", "large.mtx"), 'mass = "large.mtx": has 2000 rows; reduce the model'),
    (WHOLE.replace("K.mtx", "complex.mtx"), 'stiffness = "complex.mtx": must be real; a complex stiffness'),
    (WHOLE.replace("M.mtx", "massless.mtx"), 'mass = "massless.mtx": must be positive definite; there is a'),
    (WHOLE.replace("M.mtx", "negative.mtx"), "must be positive definite; it has a negative eigenvalue"),
    (WHOLE.replace("K.mtx", "skew.mtx"), "line 3: structures.housing.stiffness"),
    (WHOLE.replace("K.mtx", "skew.mtx"), "must be symmetric; it holds 1.001 in row 1, column 2, and 1.0"),
    (WHOLE.replace("K.mtx", "negative.mtx"), "must not push away; its eigenvalue -1.0"),
    (WHOLE.replace("K.mtx", "three.mtx"), 'stiffness = "three.mtx": has 3 rows, and the mass matrix 2'),
    (WHOLE.replace('"M.mtx"', "3"), 'line 2: structures.housing.mass = 3: name a file, as in mass = "M.mtx"'),
    (WHOLE.replace('"M.mtx"', "[[1], [1, 2]]"), "mass: must be a matrix, with rows of one length"),
    (WHOLE + 'damping = "C.mtx"\ndamping_ratio = 0.1\n', "housing.damping_ratio = 0.1: there is a damping"),
    (WHOLE + "damping_ratio = -0.1\n", "line 5: structures.housing.damping_ratio = -0.1: must be zero or"),
    (WHOLE + 'ratio = "C.mtx"\n', "line 5: structures.housing.ratio"),
    (WHOLE + 'files = "C.mtx"\n', "line 5: structures.housing.files"),
    (WHOLE.replace('["u1", "u2"]', '["u1"]'), 'coordinates = ["u1"]: holds 1 name for the 2 rows'),
    (WHOLE.replace('["u1", "u2"]', '["u1", "u1"]'), '"u1" is there more than once'),
    (WHOLE.replace('["u1", "u2"]', '"u1"'), 'name each coordinate, as in ["u1", "u2"]'),
    (
        'mass = "M.mtx"\nstiffness = "K.mtx"\n',
        'missing; name the 2 rows of the matrices, as in coordinates = ["u1", "u2"]',
    ),
    (WHOLE + 'rotations = ["u3"]\n', '["u3"]: there is no coordinate "u3"; there are "u1" and "u2"'),
    (WHOLE + 'modes = "modes.csv"\n', 'structures.housing.mass = "M.mtx": the modes say it already'),
    ('modes = "other.csv"\n', 'line 2: structures.housing.modes = "other.csv"'),
    ('modes = "no-ratio.csv"\n', 'there is no column "damping_ratio"; a modal model has frequency (Hz)'),
    ('modes = "no-point.csv"\n', "holds no point; add a column"),
    ('modes = "below.csv"\n', 'column "damping_ratio" must not be negative'),
    ('modes = "word.csv"\n', 'word.csv: line 3: "none" is no finite number'),
    ('modes = "short.csv"\n', "short.csv: line 2: holds 2 cells where 3 columns are named"),
    ('modes = "twice.csv"\n', "twice.csv: line 1: give each column a name of its own"),
    ('modes = "taken.csv"\n', 'a mode is called "mode1" already'),
    ('modes = "empty.csv"\n', "empty.csv: holds no line of numbers"),
]


@pytest.mark.parametrize(("keys", "sentence"), REFUSED)
def test_what_is_no_structure_is_refused(folder: Path, keys: str, sentence: str) -> None:
    assert sentence in refusal(folder, keys)


@pytest.mark.parametrize(
    ("modal", "end", "more", "sentence"),
    [
        (False, "u3", "", 'there is no body or pin "housing.u3"'),
        (False, "u1", '[outputs]\nx = { housing.u1 = 1 }\n', 'line 8: outputs.x.housing: write "housing.u1"'),
        (False, "u1", "[start]\nhousing.u1 = [1, 0]\n", 'start.housing: write "housing.u1" in'),
        (False, "u1", '[points]\np = { housing.u2 = 1 }\n', 'points.p.housing: write "housing.u2"'),
        (False, "u1", "[outputs]\nx = { housing = 1 }\n", '"housing" is a structure; name one of its'),
        (False, "u1", '[bodies]\n"housing.u1" = { mass = 1 }\n', 'something else is called "housing.u1"'),
        (True, "mode1", "", 'no part is attached to a mode; name a point of the structure: "housing.tip" or'),
        (True, "tip", '[forces]\nf = { on = "housing.mode2" }\n', 'forces.f.on = "housing.mode2": no part'),
        (True, "tip", '[pins]\np = { on = "housing.mode2" }\n', 'pins.p.on = "housing.mode2": no part is'),
        (True, "tip", '[points]\np = { "housing.mode1" = 1 }\n', "no part is attached to a mode"),
        (True, "tip", '[start]\n"housing.tip" = [1, 0]\n', "a point of modes starts where these put it"),
    ],
)  # fmt: skip
def test_ends_that_are_none_are_refused(folder, modal, end, more, sentence) -> None:
    keys = 'modes = "modes.csv"\n' if modal else WHOLE
    assert sentence in refusal(folder, keys, end, more)


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"stiffness": [[2.0, np.nan], [np.nan, 2.0]]}, r"stiffness.*must be finite"),
        ({"mass": [["a", "b"], ["b", "c"]]}, r"mass.*must be a matrix of numbers"),
        ({"mass": np.ones(2)}, r"mass.*must be square; its shape is 2"),
        ({"mass": np.ones((0, 0))}, r"mass.*must be square; its shape is 0 x 0"),
        ({"rotations": "u"}, r"rotations.*name those coordinates that are angles"),
        ({"modes": 3}, r"modes.*give a trimmer.mechanism.ModalModel"),
        ({"modes": ModalModel([1.0], [0.1], [1.0])}, r"modes.*with a mapping of shapes"),
        ({"modes": ModalModel([1.0], [0.1], {" tip": [1.0]})}, r"modes.*name each point, by text without"),
        ({"modes": ModalModel([1.0], [0.1], {"tip": ["a"]})}, r"'tip' must hold finite numbers"),
        ({"modes": ModalModel([1.0], [0.1], {"tip": [[1.0]]})}, r"'tip' must hold finite numbers"),
        ({"modes": ModalModel([1.0], [0.1], {"tip": [np.inf]})}, r"'tip' must hold finite numbers"),
        ({"modes": ModalModel([1.0], [0.1], {"tip": [1.0, 2.0]})}, r"'tip' holds 2 numbers for 1 modes"),
    ],
)
def test_arrays_that_are_no_structure_are_refused(given: dict, message: str) -> None:
    matrices = {"mass": np.eye(2), "stiffness": np.eye(2), "coordinates": ("u", "v")}
    structure = Structure(**(given if "modes" in given else {**matrices, **given}))
    with pytest.raises(MechanismError, match=message):
        Mechanism(structures={"housing": structure})


def test_a_mechanism_keeps_its_own_matrices() -> None:
    given = 2.0 * np.eye(2)
    machine = Mechanism(structures={"housing": Structure(given, given, coordinates=("u", "v"))})
    given[0, 0] = 5.0
    kept = machine.structures["housing"].mass
    assert kept is not None and kept.tolist() == [[2.0, 0.0], [0.0, 2.0]]
    with pytest.raises(ValueError, match="read-only"):
        kept[0, 0] = 3.0
