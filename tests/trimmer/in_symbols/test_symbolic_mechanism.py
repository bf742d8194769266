"""From a mechanism of numbers to symbols: the matrices agree, and the symbols are what they should be."""

import re
from dataclasses import replace
from inspect import signature
from pathlib import Path

import numpy as np
import pytest
import sympy
from hypothesis import given, settings
from scipy.io import mmwrite

from derivations.equations_of_motion import accelerations, inputs, motion_matrices
from derivations.linear_trimmer import derive_linear_trimmer
from derivations.mechanism import closed, trimmer
from derivations.state_space import state_space
from derivations.symbols import coordinates, t
from tests.quick import examples
from tests.trimmer.mechanism.mechanisms import mechanisms as mechanisms_with_any_names
from tests.trimmer.mechanism_strategy import mechanisms
from trimmer.code_generation import derive_mechanism_sources
from trimmer.contact.machine.machine import machine_of
from trimmer.generated import linear_trimmer
from trimmer.in_symbols.mechanism import symbolic_mechanism
from trimmer.in_symbols.printed_symbols import printed_symbols
from trimmer.mechanism import GROUND, Body, Link, Mechanism, Output, OutputKind, Pin, Play, linear_matrices
from trimmer.mechanism.linear.matrices import displacement_rows
from trimmer.mechanism.reading import mechanism_of_text

FILES = sorted((Path(__file__).parents[3] / "examples").glob("*.toml"))
# What a controller acts with is a given force there; tests of controllers hold the laws behind it.
EXAMPLES = [path for path in FILES if "[controllers" not in path.read_text("utf-8")]
THESIS = next(path for path in EXAMPLES if path.name == "thesis.toml")
QUICK = ("block-on-belt", "thesis-play")  # of few parts and of many
MARKED = [pytest.param(each, marks=[] if each.stem in QUICK else pytest.mark.slow) for each in EXAMPLES]
each_example = pytest.mark.parametrize("path", MARKED, ids=lambda path: path.stem)


def numbers_of(matrices, symbolic):
    """Put numbers into matrices of expressions by lambdified functions, as NumPy arrays."""
    values = {each.quantity.symbol: each.value for each in symbolic.quantities if each.value is not None}
    symbols = list(values)
    found = {}
    for name, matrix in vars(matrices).items():
        numeric = sympy.lambdify(symbols, matrix, "numpy")(*values.values())
        found[name] = np.array(numeric, dtype=float).reshape(matrix.shape)
    return found


def assert_matrices_agree(mechanism):
    symbolic = symbolic_mechanism(mechanism)
    derived = numbers_of(motion_matrices(symbolic.mechanism), symbolic)
    assembled = linear_matrices(mechanism, viscous=True)
    expected = {
        "mass": assembled.mass,
        "damping": assembled.damping,
        "stiffness": assembled.stiffness,
        "displacement_force": assembled.pin_displacement,
        "velocity_force": assembled.pin_velocity,
        "given_force": assembled.forces,
        "contact_force": -directions(mechanism, {**mechanism.plays, **mechanism.stops, **mechanism.walls}),
        "friction_force": -directions(mechanism, mechanism.frictions),
        "constant_force": np.zeros((len(mechanism.coordinates), 1)),
    }
    assert derived.keys() == expected.keys()
    for name, matrix in expected.items():
        np.testing.assert_allclose(derived[name], matrix, rtol=1e-12, atol=1e-12, err_msg=name)


def directions(mechanism, joints):
    """Rows of end minus start in the displacements of the bodies, as columns."""
    rows, bodies = displacement_rows(mechanism), len(mechanism.coordinates)
    listed = [(rows[each.between[1]] - rows[each.between[0]])[:bodies] for each in joints.values()]
    return np.array(listed).reshape(-1, bodies).T


@each_example
def test_derived_matrices_of_the_examples_are_those_that_solvers_assemble(path):
    assert_matrices_agree(Mechanism.from_toml(path))


@settings(max_examples=examples(4, 30))
@given(mechanisms())
def test_derived_matrices_of_random_mechanisms_are_those_that_solvers_assemble(mechanism):
    assert_matrices_agree(mechanism)


def assert_motion_agrees(mechanism, time):
    """Hold the accelerations of the exact engine, of a state and a time, against the derived ones."""
    symbolic = symbolic_mechanism(mechanism)
    machine, layout = machine_of(mechanism)
    bodies = len(mechanism.coordinates)
    state = np.random.default_rng(bodies).uniform(-1.0, 1.0, layout.state_count)
    pushed = machine.base[bodies : 2 * bodies] @ np.concatenate([state, layout.forcing_at(time)])
    values = values_at(symbolic, state, time)
    for force, law in zip(mechanism.forces.values(), symbolic.mechanism.forces, strict=True):
        if force.profile is not None:  # Any function of the time, there.
            values[law.law] = np.interp(time, *zip(*force.profile, strict=True))
    derived = [float(each.doit().xreplace(values)) for each in laws_inserted(symbolic.mechanism)]
    np.testing.assert_allclose(derived, pushed, rtol=1e-9, atol=1e-9 * np.abs(pushed).max())
    matrices = numbers_of(motion_matrices(symbolic.mechanism), symbolic)
    inverse = np.linalg.inv(matrices["mass"])
    # Walls come last, and push by impulses alone.
    contact_push = (inverse @ matrices["contact_force"]).T[: len(machine.contact_push)]
    np.testing.assert_allclose(machine.contact_push, contact_push, rtol=1e-12)
    np.testing.assert_allclose(machine.friction_push, -(inverse @ matrices["friction_force"]).T, rtol=1e-12)


def laws_inserted(mechanism):
    """Return accelerations with the motions of pins and forces written out, contacts and dry friction off."""
    written = {pin.displacement: pin.law for pin in mechanism.pins}
    written |= {force.value: force.law for force in mechanism.forces}
    written |= {each: 0 for kind in inputs(mechanism)[3:] for each in kind}
    return [acceleration.xreplace(written) for acceleration in accelerations(mechanism)]


def values_at(symbolic, state, time):
    values = {each.quantity.symbol: each.value for each in symbolic.quantities if each.value is not None}
    for index, body in enumerate(symbolic.mechanism.bodies):
        values[body.coordinate] = state[index]
        values[body.coordinate.diff(t)] = state[len(symbolic.mechanism.bodies) + index]
    return {**values, t: time}


@each_example
def test_engine_moves_the_examples_as_they_are_derived(path):
    mechanism = Mechanism.from_toml(path)
    assert_motion_agrees(mechanism, 0.3 / (mechanism.frequency or 1.0))


@settings(max_examples=examples(3, 30))
@given(mechanisms(most_bodies=3))
def test_engine_moves_random_mechanisms_as_they_are_derived(mechanism):
    assert_motion_agrees(mechanism, 0.4)


@settings(max_examples=examples(2, 30))
@given(mechanisms(most_bodies=3))
def test_closed_contacts_are_links(mechanism):
    """With the contacts as links the solvers' matrices are the derived ones of closed contact."""
    contacts = {**mechanism.plays, **mechanism.stops}
    links = {name: Link(each.between, each.stiffness, each.damping) for name, each in contacts.items()}
    linked = replace(mechanism, links={**mechanism.links, **links}, plays={}, stops={})
    symbolic = symbolic_mechanism(mechanism)
    derived = motion_matrices(closed(symbolic.mechanism))
    assembled = linear_matrices(linked, viscous=True)
    for play in symbolic.mechanism.contacts:
        ahead = {side: 1 for side in play.offset.free_symbols if "sigma" in str(side)}
        derived = replace(derived, constant_force=derived.constant_force.subs(ahead))
    found = numbers_of(derived, symbolic)
    offsets = [each.stiffness * each.gap / (2 if isinstance(each, Play) else 1) for each in contacts.values()]
    pushed = directions(mechanism, contacts) @ np.array(offsets)
    np.testing.assert_allclose(found["stiffness"], assembled.stiffness, rtol=1e-12, atol=1e-12)
    np.testing.assert_allclose(found["damping"], assembled.damping, rtol=1e-12, atol=1e-12)
    np.testing.assert_allclose(found["displacement_force"], assembled.pin_displacement, atol=1e-12)
    np.testing.assert_allclose(found["velocity_force"], assembled.pin_velocity, atol=1e-12)
    np.testing.assert_allclose(found["constant_force"].ravel(), pushed, rtol=1e-12, atol=1e-12)


@pytest.fixture(scope="module")
def thesis():
    return Mechanism.from_toml(THESIS)


def test_file_of_the_thesis_gives_its_equations_and_matrices(thesis):
    symbolic = symbolic_mechanism(thesis)
    matrices, expected = motion_matrices(symbolic.mechanism), derive_linear_trimmer()
    assert accelerations(symbolic.mechanism) == expected.accelerations
    assert matrices == expected.matrices
    assert state_space(matrices) == expected.space
    assert [body.coordinate for body in symbolic.mechanism.bodies] == list(coordinates)
    assert symbolic.mechanism.springs[1].stiffness == trimmer().springs[1].stiffness
    assert derive_linear_trimmer(symbolic.mechanism).transfer == expected.transfer


@pytest.mark.slow
def test_file_of_the_thesis_gives_the_generated_module_whatever_its_names_and_order(thesis):
    generated = Path(linear_trimmer.__file__).read_text(encoding="utf-8")
    assert derive_mechanism_sources(thesis).module == generated
    names = dict(zip(thesis.bodies, "abcd", strict=True)) | {GROUND: GROUND, "pin": "p"}
    renamed = replace(
        thesis,
        bodies={names[name]: body for name, body in thesis.bodies.items()},
        pins={"p": replace(thesis.pins["pin"], on="a")},
        links={
            f"part {number}": replace(link, between=tuple(names[end] for end in link.between))
            for number, link in enumerate(reversed(list(thesis.links.values())))
        },
        outputs={},
    )
    assert derive_mechanism_sources(renamed).module == generated


def one_body(**sections):
    mount = {"mount": Link((GROUND, "a"), 1.0)}
    return Mechanism(**{"bodies": {"a": Body(1.0)}, "links": mount, **sections})


@settings(max_examples=examples(5, 30))
@given(mechanisms_with_any_names())
def test_symbols_and_names_of_random_mechanisms_are_unique(mechanism):
    found = [each.symbol for each in printed_symbols(mechanism).values()]
    assert len(set(found)) == len(found)
    names = list(symbolic_mechanism(mechanism).arguments.values())
    assert len(set(names)) == len(names)
    assert all(name.isidentifier() for name in names)


@pytest.mark.slow
@settings(max_examples=8)
@given(mechanisms_with_any_names())
def test_random_mechanisms_pass_all_checks_of_their_derivation(mechanism):
    """Newton's law, the power balance and the dimensions; the module is Python that runs."""
    assert_sources_are_usable(mechanism)


@pytest.mark.slow
@settings(max_examples=30)
@given(mechanisms(most_bodies=6))
def test_larger_mechanisms_pass_all_checks_of_their_derivation(mechanism):
    assert_sources_are_usable(mechanism)
    assert_matrices_agree(mechanism)


def test_a_structure_that_turns_passes_all_checks_of_its_derivation(tmp_path):
    """Its matrices mix kg, kg m and kg m²."""
    mmwrite(tmp_path / "matrix.mtx", np.array([[3.0, 1.0], [1.0, 2.0]]))
    text = """
        [structures.h]
        mass = "matrix.mtx"
        damping = "matrix.mtx"
        stiffness = "matrix.mtx"
        coordinates = ["u", "phi"]
        rotations = ["phi"]
    """
    assert_sources_are_usable(mechanism_of_text(text, "turning.toml", {}, tmp_path))


def assert_sources_are_usable(mechanism):
    sources = derive_mechanism_sources(mechanism)
    module = {}
    exec(sources.module, module)
    assert callable(module["mass_matrix"])
    unescaped = re.sub(r"\\[\\{}]", "", sources.latex)
    assert unescaped.count("{") == unescaped.count("}")


@pytest.mark.parametrize(("body", "q"), [(Body(1.0), "q"), (Body(inertia=1.0), r"\theta")])
def test_outputs_are_told_in_motions_of_bodies_and_pins(body, q):
    mechanism = one_body(
        bodies={"a": body},
        pins={"p": Pin("a", symbol="u")},
        outputs={
            "half": Output({"p": 0.5}),
            "whole": Output({"a": 1, "p": -1}),
            "rate": Output({"a": 1}, OutputKind.VELOCITY),
            "bend": Output({"a": 1}, OutputKind.ACCELERATION),
        },
    )
    latex = derive_mechanism_sources(mechanism).latex.replace(q, "q")
    assert r"y_{\text{half}} = \frac{q_{a}}{2} + \frac{u}{2}" in latex
    assert r"y_{\text{whole}} = q_{a} - q_{a} - u" in latex
    assert r"y_{\text{rate}} = \dot{q}_{a}" in latex
    assert r"y_{\text{bend}} = \ddot{q}_{a}" in latex


WALLS = """
[bodies]
a = { mass = 2.0 }
b = { mass = 0.5 }
[links]
spring = { between = ["a", "b"], stiffness = 1.0 }
[walls]
floor = { between = ["ground", "b"], gap = 0.1, restitution = 0.3 }
"""
BETWEEN = 'between = { between = ["a", "b"], gap = 0.01, restitution = 0.6 }'


@pytest.mark.parametrize("more", ["", BETWEEN], ids=["one wall", "two walls"])
def test_the_module_resets_velocities_by_momentum_and_restitution(more):
    module = {}
    exec(derive_mechanism_sources(Mechanism.from_toml_text(WALLS + more)).module, module)
    masses, velocities = np.array([2.0, 0.5]), np.array([3.0, -2.0])
    given = {"m_a": masses[0], "m_b": masses[1], "k_spring": 1.0, "r_floor": 0.3, "r_between": 0.6}
    walls = {"_1": ([0.0, 1.0], 0.3), "_2": ([-1.0, 1.0], 0.6)} if more else {"": ([0.0, 1.0], 0.3)}
    for number, (direction, restitution) in walls.items():
        function = module[f"impact_matrix{number}"]
        after = np.array(function(*(given[name] for name in signature(function).parameters))) @ velocities
        assert direction @ after == pytest.approx(-restitution * (direction @ velocities))
        impulse = masses * (after - velocities)
        assert impulse == pytest.approx(impulse[1] * np.array(direction))
