"""Structures: a machine moves alike in other coordinates, and as SciPy integrates it."""

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from scipy.linalg import eigh

from tests.mechanisms.random_mechanisms import random_mechanism
from tests.quick import quick
from tests.trimmer.contact.test_against_brute_force import compare
from trimmer import Body, Force, Friction, Link, Mechanism, forced_orbit, simulate
from trimmer.contact.flow import MechanismFlow
from trimmer.contact.state.frame import frame_of
from trimmer.hybrid.propagation import MANY_STEPS
from trimmer.mechanism import LinearMatrices, ModalModel, Output, Pin, Point, Stop, Structure, linear_matrices

CHAIN = Mechanism(
    {"a": Body(1.0), "b": Body(0.4), "c": Body(2.0)},
    frequency=2.0,
    links={
        "first": Link(("ground", "a"), 400.0, 0.8),
        "second": Link(("a", "b"), 250.0, 0.5),
        "third": Link(("b", "c"), 900.0, 1.8),
    },
    stops={"wall": Stop(("ground", "c"), 5e4, 20.0, 0.01)},
    forces={"shaker": Force("b", amplitude=20.0)},
    outputs={"y": Output({"c": 1.0, "a": -1.0})},
)
"""Its damping is 0.002 of its stiffness, so that its modes are damped each by itself."""


def links_between_bodies(mechanism: Mechanism) -> dict[str, Link]:
    return {
        name: link for name, link in mechanism.links.items() if not mechanism.pins.keys() & set(link.between)
    }


def matrices_of_bodies(mechanism: Mechanism) -> LinearMatrices:
    """Mass, damping and stiffness of the bodies and the links between them."""
    touched = {name: Force(name) for name in mechanism.bodies}
    return linear_matrices(Mechanism(mechanism.bodies, links=links_between_bodies(mechanism), forces=touched))


def in_other_coordinates(mechanism: Mechanism, seed: int) -> Mechanism:
    """Return the mechanism with bodies q = T p that are points of a structure with coordinates p."""
    random, names = np.random.default_rng(seed), list(mechanism.bodies)
    turned, _ = np.linalg.qr(random.normal(size=(len(names),) * 2))
    basis = turned * random.uniform(0.5, 2.0, len(names))
    own = matrices_of_bodies(mechanism)
    mass, damping, stiffness = (basis.T @ each @ basis for each in (own.mass, own.damping, own.stiffness))
    coordinates = [f"p{number}" for number in range(len(names))]
    ends = [f"other.{each}" for each in coordinates]
    begun = np.linalg.solve(basis, [mechanism.start.get(name, (0.0, 0.0)) for name in names])
    inner = links_between_bodies(mechanism)
    weights = {name: dict(zip(ends, row, strict=True)) for name, row in zip(names, basis, strict=True)}
    return replace(
        mechanism,
        bodies={},
        structures={"other": Structure(mass, stiffness, damping, coordinates=coordinates)},
        points={name: Point(each) for name, each in weights.items()},
        links={name: each for name, each in mechanism.links.items() if name not in inner},
        start=dict(zip(ends, map(tuple, begun), strict=True)),
    )


@pytest.mark.parametrize("seed", quick((3, 11, 60, 174), 2))
def test_a_machine_moves_alike_in_other_coordinates(seed: int) -> None:
    first = random_mechanism(seed)
    second = in_other_coordinates(first, seed)
    one, other = (simulate(each, 2 / first.frequency) for each in (first, second))
    happened = ([(each.part, each.kind) for each in motion.events] for motion in (one, other))
    assert next(happened) == next(happened)
    times = np.linspace(0, one.duration, 50)
    expected, found = (
        np.array([motion.displacement(name, times) for name in first.bodies]) for motion in (one, other)
    )
    assert found == pytest.approx(expected, abs=1e-8 * abs(expected).max())
    assert other.energy.residual < 1e-11
    assert other.energy.loss == pytest.approx(one.energy.loss, rel=1e-7)
    assert other.energy.kinetic == pytest.approx(one.energy.kinetic, rel=1e-7, abs=1e-9 * one.energy.loss)


def test_a_large_structure_moves_as_its_bodies_do() -> None:
    """By tables of dense matrices, many steps at once, as by rows of sparse ones."""
    names = [f"body {number}" for number in range(26)]
    links = {
        f"link {at}": Link((first, second), 4e3 * (1 + 200 * (at == 9)), 1.0)
        for at, (first, second) in enumerate(pairwise(["ground", *names]))
    }
    chain = Mechanism(
        {name: Body(0.05 if name != "body 9" else 5e-4) for name in names},
        frequency=30.0,
        links=links,
        stops={
            "first": Stop(("ground", "body 4"), 2e5, 3.0, 2e-4),
            "second": Stop(("body 20", "ground"), 2e5, 3.0, 2e-4),
        },
        forces={"shaker": Force("body 13", amplitude=30.0)},
        outputs={"y": Output({"body 25": 1.0})},
    )
    courses = []
    for machine in (chain, in_other_coordinates(chain, 1)):
        flow = MechanismFlow(machine)
        courses.append(flow.course(flow.rest(), 3))
    one, other = courses
    assert [each.modes.tables.rows is None for each in courses] == [False, True]
    assert [event[1:] for event in one.events] == [event[1:] for event in other.events]
    assert len(one.events) > 6
    steps = np.diff(other.times).max() / other.modes.tables.step[other.log.mode].max()
    assert steps > 4 * MANY_STEPS
    apart = np.linalg.eigvals(one.monodromy), np.linalg.eigvals(other.monodromy)
    first, second = (np.sort(abs(each))[::-1][:12] for each in apart)
    np.testing.assert_allclose(second, first, rtol=1e-6)
    np.testing.assert_allclose(
        [event[0] for event in other.events], [event[0] for event in one.events], rtol=1e-9
    )


@pytest.mark.parametrize("seed", quick(range(1, 40, 4), 0))
def test_random_structures_against_brute_force(seed: int) -> None:
    compare(in_other_coordinates(random_mechanism(seed), seed), 2, known=0.5)


def as_structure(mechanism: Mechanism, structure: Structure) -> Mechanism:
    """Return the mechanism with bodies and links replaced by a structure whose ends have their names."""
    ends = {name: f"chain.{name}" for name in mechanism.bodies}
    stops = {
        name: replace(stop, between=tuple(ends.get(each, each) for each in stop.between))
        for name, stop in mechanism.stops.items()
    }
    forces = {name: replace(force, on=ends[force.on]) for name, force in mechanism.forces.items()}
    outputs = {
        name: Output({ends[of]: weight for of, weight in output.weights.items()})
        for name, output in mechanism.outputs.items()
    }
    return replace(
        mechanism,
        bodies={},
        links={},
        structures={"chain": structure},
        stops=stops,
        forces=forces,
        outputs=outputs,
        start={ends[name]: state for name, state in mechanism.start.items()},
    )


def all_modes(mechanism: Mechanism) -> ModalModel:
    own, names = matrices_of_bodies(mechanism), list(mechanism.bodies)
    values, shapes = eigh(own.stiffness, own.mass)
    omega = np.sqrt(np.maximum(values, 0.0))
    ratios = (shapes.T @ own.damping @ shapes).diagonal() / (2 * np.where(omega > 0.0, omega, 1.0))
    return ModalModel(omega / (2 * np.pi), ratios, dict(zip(names, shapes, strict=True)))


def test_matrices_or_all_modes_of_a_chain_are_the_chain() -> None:
    own, orbit = matrices_of_bodies(CHAIN), forced_orbit(CHAIN)
    names = tuple(CHAIN.bodies)
    compare(as_structure(CHAIN, Structure(modes=all_modes(CHAIN))), 2, known=0.9)
    whole = Structure(own.mass, own.stiffness, own.damping, coordinates=names)
    for structure in (whole, Structure(modes=all_modes(CHAIN))):
        other = forced_orbit(as_structure(CHAIN, structure))
        assert other.measures.peak_to_peak["y"] == pytest.approx(orbit.measures.peak_to_peak["y"], rel=1e-10)
        assert sorted(abs(other.multipliers)) == pytest.approx(sorted(abs(orbit.multipliers)), abs=1e-9)


def test_a_damping_ratio_is_that_of_each_mode_but_rigid_ones() -> None:
    own = matrices_of_bodies(CHAIN)
    free = own.stiffness.copy()
    free[0, 0] -= 400.0
    for stiffness, rigid in ((own.stiffness, 0), (free, 1)):
        structure = Structure(own.mass, stiffness, damping_ratio=0.03, coordinates=("a", "b", "c"))
        values, shapes = eigh(stiffness, own.mass)
        damping = shapes.T @ structure.matrices[1] @ shapes
        expected = 2 * 0.03 * np.sqrt(np.maximum(values, 0.0))
        expected[:rigid] = 0.0
        assert damping == pytest.approx(np.diag(expected), abs=1e-9)
        assert len(structure.shifts.free) == rigid


def test_a_free_structure_rolls_on_and_its_advance_is_that_of_the_belt_that_drives_it() -> None:
    """Two coordinates tied by the structure alone, with weights 1 and 2: one direction is free."""
    strain = np.array([2.0, -1.0])
    mass, stiffness = np.array([[2.0, 0.3], [0.3, 1.0]]), 500 * np.outer(strain, strain)
    structure = Structure(mass, stiffness, coordinates=("a", "b"))
    mechanism = Mechanism(
        structures={"s": structure},
        frequency=3.0,
        pins={"belt": Pin("ground", velocity=0.4)},
        frictions={"rub": Friction(("belt", "s.b"), 0.0, viscous=2.0)},
        forces={"shaker": Force("s.a", amplitude=1.0)},
        outputs={"x": Output({"s.a": 1.0}), "y": Output({"s.b": 1.0})},
    )
    frame = frame_of(mechanism)
    assert frame.leading.tolist() == [0]
    assert frame.directions[:, 0] == pytest.approx([1.0, 2.0])
    orbit = forced_orbit(mechanism)
    assert orbit.measures.outputs["x"].advance == pytest.approx(0.2 / 3, rel=1e-9)
    assert orbit.measures.outputs["y"].advance == pytest.approx(0.4 / 3, rel=1e-9)
