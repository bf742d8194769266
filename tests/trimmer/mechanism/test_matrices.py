from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.trimmer.mechanism.mechanisms import mechanisms
from tests.trimmer.trimmers import trimmers
from trimmer import Mechanism, TrimmerParameters, WrongTypeError, linear_model
from trimmer.mechanism import Body, Force, Friction, Link, Pin, linear_matrices
from trimmer.mechanism.linear.matrices import displacement_rows


@given(trimmers())
def test_the_trimmer_of_the_thesis_has_its_state_space(parameters: TrimmerParameters) -> None:
    matrices = linear_matrices(parameters.to_mechanism(1.5e-3, 110.0))
    model = linear_model(parameters)
    inverse = np.linalg.inv(matrices.mass)
    zeros = np.zeros((4, 4))
    state = np.block([[zeros, np.eye(4)], [-inverse @ matrices.stiffness, -inverse @ matrices.damping]])
    inputs = inverse @ np.hstack([matrices.pin_displacement, matrices.pin_velocity])
    np.testing.assert_allclose(state, model.A, rtol=1e-12)
    np.testing.assert_allclose(np.vstack([np.zeros((4, 2)), inputs]), model.B, rtol=1e-12)


def test_a_mechanism_by_hand() -> None:
    """m a on a moved base p, b hanging on a by a damper that a pin r on a holds; force on b."""
    mechanism = Mechanism(
        {"a": Body(2.0), "b": Body(3.0)},
        pins={"p": Pin("ground"), "r": Pin("a")},
        links={"base": Link(("p", "a"), 10.0, 1.0), "arm": Link(("b", "r"), 5.0, 0.5)},
        frictions={"rub": Friction(("ground", "b"), 1.0, viscous=0.25)},
        forces={"push": Force("b"), "pull": Force("a")},
    )
    matrices = linear_matrices(mechanism)
    # 2 a'' = -10 (a - p) - 5 (a + r - b) + pull, 3 b'' = 5 (a + r - b) + push
    np.testing.assert_array_equal(matrices.mass, [[2, 0], [0, 3]])
    np.testing.assert_array_equal(matrices.stiffness, [[15, -5], [-5, 5]])
    np.testing.assert_array_equal(matrices.damping, [[1.5, -0.5], [-0.5, 0.5]])
    np.testing.assert_array_equal(matrices.pin_displacement, [[10, -5], [0, 5]])
    np.testing.assert_array_equal(matrices.pin_velocity, [[1, -0.5], [0, 0.5]])
    np.testing.assert_array_equal(matrices.forces, [[0, 1], [1, 0]])
    viscous = linear_matrices(mechanism, viscous=True)
    np.testing.assert_array_equal(viscous.damping - matrices.damping, [[0, 0], [0, 0.25]])
    np.testing.assert_array_equal(viscous.stiffness, matrices.stiffness)


def test_a_curve_has_its_slope_where_the_ends_are_together() -> None:
    """At a corner there it is the mean of both sides; beyond the outer points it goes on as straight."""
    slopes = {
        ((-1.0, -3.0), (0.0, 0.0), (2.0, 10.0)): 4.0,
        ((-1.0, -3.0), (1.0, 3.0), (2.0, 10.0)): 3.0,
        ((-2.0, -9.0), (-1.0, -3.0), (2.0, 12.0)): 5.0,
        ((1.0, 0.0), (2.0, 7.0), (3.0, 8.0)): 7.0,
        ((-3.0, 0.0), (-2.0, 7.0), (-1.0, 8.0)): 1.0,
    }
    for curve, slope in slopes.items():
        link = Link(("ground", "a"), 0.5, curve=curve)
        (found,) = linear_matrices(Mechanism({"a": Body(1.0)}, links={"k": link})).stiffness.ravel()
        assert found == 0.5 + slope


def test_a_link_is_the_same_in_both_directions_if_its_curve_is() -> None:
    ends = ("ground", "a")
    for curve in (None, ((-1.0, -3.0), (1.0, 3.0)), ((-2.0, -9.0), (0.0, 0.0), (2.0, 9.0))):
        assert Link(ends, 1.0, curve=curve).is_odd
    for curve in (((-1.0, -3.0), (1.0, 4.0)), ((-1.0, -3.0), (2.0, 6.0)), ((-1.0, 3.0), (1.0, 3.0))):
        assert not Link(ends, 1.0, curve=curve).is_odd


@settings(max_examples=8)
@given(mechanisms(), st.floats(0.1, 10.0))
def test_matrices_scale_with_masses_springs_and_dampers(mechanism: Mechanism, factor: float) -> None:
    scaled = replace(
        mechanism,
        bodies={
            name: replace(body, **{key: factor * value})
            for name, body in mechanism.bodies.items()
            for key in ("mass", "inertia")
            if (value := getattr(body, key)) is not None
        },
        links={
            name: Link(link.between, factor**2 * link.stiffness, factor**3 * link.damping)
            for name, link in mechanism.links.items()
        },
    )
    before, after = linear_matrices(mechanism), linear_matrices(scaled)
    for name, power in (("mass", 1), ("stiffness", 2), ("damping", 3), ("pin_velocity", 3), ("forces", 0)):
        size = abs(getattr(after, name)).max(initial=0.0)
        np.testing.assert_allclose(
            getattr(after, name), factor**power * getattr(before, name), rtol=1e-12, atol=1e-12 * size
        )


@settings(max_examples=8)
@given(mechanisms())
def test_matrices_are_symmetric_and_swapped_ends_change_nothing(mechanism: Mechanism) -> None:
    swapped = {name: replace(link, between=link.between[::-1]) for name, link in mechanism.links.items()}
    before, after = linear_matrices(mechanism), linear_matrices(replace(mechanism, links=swapped))
    for name in ("mass", "stiffness", "damping", "pin_displacement", "pin_velocity", "forces"):
        np.testing.assert_array_equal(getattr(after, name), getattr(before, name))
    for matrix in (before.mass, before.stiffness, before.damping):
        np.testing.assert_array_equal(matrix, matrix.T)
    assert (before.stiffness.shape, before.pin_velocity.shape) == (
        (len(mechanism.bodies),) * 2,
        (len(mechanism.bodies), len(mechanism.pins)),
    )
    assert before.forces.shape == (len(mechanism.bodies), len(mechanism.forces))


@settings(max_examples=8)
@given(mechanisms())
def test_a_motion_of_everything_together_loads_only_links_to_the_ground(mechanism: Mechanism) -> None:
    matrices, bodies = linear_matrices(mechanism), list(mechanism.bodies)
    carriers = {name: pin.on for name, pin in mechanism.pins.items()} | {"ground": "ground"}
    expected = np.zeros(len(bodies))
    for link in mechanism.links.values():
        on = [carriers.get(end, end) for end in link.between]
        if "ground" in on:
            expected[bodies.index(next(body for body in on if body != "ground"))] += link.stiffness
    size = abs(matrices.stiffness).max()
    loads = matrices.stiffness @ np.ones(len(bodies))
    np.testing.assert_allclose(loads, expected, rtol=1e-9, atol=1e-9 * size)


def test_rows_give_the_displacement_of_each_end() -> None:
    rows = displacement_rows(TrimmerParameters.thesis().to_mechanism(1.5e-3, 110.0))
    assert {name: list(row) for name, row in rows.items()} == {
        "ground": [0, 0, 0, 0, 0],
        "motor": [1, 0, 0, 0, 0],
        "cutter": [0, 1, 0, 0, 0],
        "housing": [0, 0, 1, 0, 0],
        "guard": [0, 0, 0, 1, 0],
        "pin": [1, 0, 0, 0, 1],
    }


def test_parameters_are_no_mechanism() -> None:
    with pytest.raises(WrongTypeError, match=r"mechanism must be a trimmer\.Mechanism"):
        linear_matrices(TrimmerParameters.thesis())  # type: ignore[arg-type]
