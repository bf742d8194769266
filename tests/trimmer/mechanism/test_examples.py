"""The examples and the blocks of docs/mechanism.md are read, and say what they should."""

import math
import re
from pathlib import Path

import pytest

from trimmer import ContactLaw, Mechanism, TrimmerParameters
from trimmer.mechanism import Friction, Link, Play, linear_matrices
from trimmer.mechanism.kinds import Kind

FOLDER = Path(__file__).parents[3]
EXAMPLES = sorted((FOLDER / "examples").glob("*.toml"))
THESIS = TrimmerParameters.thesis()


def example(name: str) -> Mechanism:
    return Mechanism.from_toml(FOLDER / "examples" / f"{name}.toml")


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_every_example_is_read_and_told(path: Path) -> None:
    mechanism = Mechanism.from_toml(path)
    assert mechanism.title
    assert mechanism.outputs
    head = path.read_text(encoding="utf-8").split("\n\n")[0].splitlines()
    assert 2 <= len(head) <= 4
    assert all(line.startswith("# ") for line in head)
    assert f"[{path.name}]({path.name})" in (FOLDER / "examples" / "README.md").read_text(encoding="utf-8")


def test_the_trimmer_of_the_thesis() -> None:
    assert example("thesis") == THESIS.to_mechanism(1.5e-3, 110.0)


def test_the_twin_has_play_in_place_of_the_link_and_friction() -> None:
    linear, twin = example("thesis"), example("thesis-play")
    assert {name: body.mass for name, body in twin.bodies.items()} == {
        name: body.mass for name, body in linear.bodies.items()
    }
    assert twin.plays == {"bridge": Play(("cutter", "pin"), THESIS.k2, THESIS.c2, 40e-6)}
    assert twin.frictions == {"blade": Friction(("guard", "cutter"), 0.5)}
    assert (twin.frequency, twin.pins["pin"].amplitude, twin.pins["pin"].on) == (110.0, 1.5e-3, "motor")
    closed = Mechanism(
        twin.bodies,
        links={**twin.links, "bridge": Link(("cutter", "pin"), THESIS.k2, THESIS.c2)},
        pins=twin.pins,
        frequency=twin.frequency,
    )
    for name in ("mass", "damping", "stiffness", "pin_displacement", "pin_velocity"):
        assert (getattr(linear_matrices(closed), name) == getattr(linear_matrices(linear), name)).all()


def test_a_held_trimmer_is_the_twin_on_a_handle() -> None:
    twin, held = example("thesis-play"), example("held")
    on_the_handle = {
        name: Link(
            tuple("handle" if end == "ground" else end for end in link.between), link.stiffness, link.damping
        )
        for name, link in twin.links.items()
    }
    assert {name: link for name, link in held.links.items() if name != "hand"} == on_the_handle
    assert held.links["hand"].between == ("ground", "handle")
    assert (held.plays, held.frictions, held.pins) == (twin.plays, twin.frictions, twin.pins)
    assert {name: held.bodies[name] for name in twin.bodies} == twin.bodies


def test_the_second_play_takes_the_place_of_the_housing_mount() -> None:
    twin, second = example("thesis-play"), example("second-play")
    assert {**second.links, "housing mount": twin.links["housing mount"]} == twin.links
    assert second.plays["bridge"] == twin.plays["bridge"]
    seat = second.plays["housing seat"]
    assert (seat.between, seat.stiffness, seat.damping) == (("motor", "housing"), THESIS.k3, THESIS.c3)


def test_published_cases_have_the_published_values() -> None:
    two, one, gears = example("two-mass-stop"), example("oscillator-stop"), example("gear-pair")
    matrices = linear_matrices(two)
    assert matrices.mass.tolist() == [[1, 0], [0, 1]]
    assert matrices.stiffness.tolist() == [[1, -1], [-1, 2]]
    assert matrices.damping.tolist() == [[0.03, -0.03], [-0.03, 0.06]]
    assert one.value("links.spring.damping") == 0.1 * math.sqrt(40)
    assert gears.value("plays.mesh.gap") == 2.0
    for mechanism in (two, one, gears, example("den-hartog")):
        (force,) = mechanism.forces.values()
        assert force.phase == math.pi / 2


def test_a_thrown_body_approaches_the_wall() -> None:
    thrown = example("thrown-body")
    assert thrown.start == {"body": (-1.0, 1.0)}
    assert thrown.stops["wall"].law is ContactLaw.RELAXING


@pytest.fixture(scope="module")
def document() -> str:
    return (FOLDER / "docs" / "mechanism.md").read_text(encoding="utf-8")


def test_files_in_the_document_are_read(document: str) -> None:
    blocks = re.findall(r"```toml\n(.*?)```", document, flags=re.DOTALL)
    trimmer, block, motor, housing, axis = map(Mechanism.from_toml_text, blocks)
    assert trimmer.value("plays.bridge.gap") == 40e-6
    assert motor.kinds["gear"] is Kind.ROTATION and motor.kinds["rack"] is Kind.TRANSLATION
    assert block.start == {"block": (0.01, 0.5)}
    assert block.links["spring"].damping_symbol == "c"
    assert (axis.value("references.path.at"), axis.value("controllers.axis.limit")) == (0.01, 2.0)
    assert housing.coordinates == ("housing.u1", "housing.u2", "housing.eta")


def test_python_in_the_document_prints_what_is_shown(document: str, monkeypatch, capsys) -> None:
    monkeypatch.chdir(FOLDER)
    code = re.findall(r"```python\n(.*?)```", document, flags=re.DOTALL)
    assert len(code) == 3
    for block in code:
        exec(compile(block, "mechanism.md", "exec"), {})
    assert capsys.readouterr().out == "".join(re.findall(r"```text\n(.*?)```", document, flags=re.DOTALL))


def test_the_document_names_every_section_and_key(document: str) -> None:
    from dataclasses import fields

    from trimmer.mechanism.quantities import PARTS

    for section, kind in PARTS.items():
        row = next(line for line in document.splitlines() if line.startswith(f"| `[{section}]`"))
        named = set(re.findall(r"`(\w+)`", row.split("|")[2]))
        assert named == {each.name for each in fields(kind)} - {"symbol", "files"}
