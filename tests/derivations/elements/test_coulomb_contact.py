"""Coulomb friction between two bodies acts on both, against their relative motion."""

import pytest
import sympy

from derivations.elements.coulomb_contact import friction_forces, power, relative_velocity
from derivations.elements.friction import FORCE
from derivations.mechanism import trimmer
from derivations.symbols import velocities

MOTIONS = [(1, 3, 0, 0), (3, 1, 0, 0), (-2, 1, 5, 4), (0, 2, 0, 7)]


def at(expression, speeds):
    return expression.xreplace(dict(zip(velocities, map(sympy.Integer, speeds), strict=True)))


@pytest.mark.parametrize("pair", [(1, 0), (1, 3), (0, 1)])
@pytest.mark.parametrize("speeds", MOTIONS)
def test_friction_opposes_the_relative_motion_and_takes_its_power(pair, speeds):
    mechanism = trimmer()
    first, second = (mechanism.bodies[index] for index in pair)
    forces = friction_forces(mechanism, first, second)
    sliding = speeds[pair[0]] - speeds[pair[1]]
    values = [at(force, speeds) for force in forces]
    assert sum(values) == 0
    assert values[pair[0]] == -FORCE * sympy.sign(sliding)
    assert at(power(mechanism, forces), speeds) == -FORCE * abs(sliding)


def test_bodies_without_friction_feel_no_force():
    mechanism = trimmer()
    forces = friction_forces(mechanism, mechanism.bodies[1], mechanism.bodies[3])
    assert forces[0] == forces[2] == 0
    assert relative_velocity(mechanism.bodies[1], mechanism.bodies[3]) == velocities[1] - velocities[3]
