"""The equations of motion against Newton's law, SymPy's own mechanics package, and laws of mechanics."""

from dataclasses import replace

import pytest
import sympy
from sympy.physics.mechanics import KanesMethod, Particle, Point, ReferenceFrame, dynamicsymbols

from derivations import symbols
from derivations.energies import kinetic_energy, potential_energy, rayleigh_function
from derivations.equations_of_motion import accelerations, motion_matrices
from derivations.mechanism import Mechanism, elongation, trimmer
from derivations.newton_euler import newton_accelerations
from derivations.parts import Damper, Ground, Pin, RigidBody, Spring
from derivations.power_balance import power_balance


@pytest.fixture(scope="module")
def mechanism() -> Mechanism:
    return trimmer()


def test_energy_method_and_force_method_agree(mechanism):
    for energy, force in zip(accelerations(mechanism), newton_accelerations(mechanism), strict=True):
        assert sympy.expand(energy - force) == 0


def test_kanes_method_of_sympy_gives_the_same_accelerations(mechanism, monkeypatch):
    """Kane's method in sympy.physics.mechanics, with the forces on each body written down by hand."""
    monkeypatch.setattr(dynamicsymbols, "_t", symbols.t)
    frame = ReferenceFrame("N")
    q1, q2, q3, q4 = symbols.coordinates
    v = dynamicsymbols("v1:5")
    v1, v2, v3, v4 = v
    bridge = symbols.k2 * (q2 - q1 - symbols.u) + symbols.c2 * (v2 - v1 - symbols.u_dot)
    plate = symbols.k4 * (q4 - q3) + symbols.c4 * (v4 - v3)
    coil = symbols.k5 * (q2 - q3)
    forces = (
        -symbols.k1 * q1 - symbols.c1 * v1 + bridge,
        -bridge - coil,
        -symbols.k3 * q3 - symbols.c3 * v3 + plate + coil,
        -plate,
    )
    particles, loads = [], []
    for index, (mass, velocity, force) in enumerate(zip(symbols.masses, v, forces, strict=True)):
        point = Point(f"P{index}")
        point.set_vel(frame, velocity * frame.x)
        particles.append(Particle(f"body{index}", point, mass))
        loads.append((point, force * frame.x))
    kinematics = [velocity - q.diff(symbols.t) for velocity, q in zip(v, symbols.coordinates, strict=True)]
    method = KanesMethod(frame, symbols.coordinates, v, kd_eqs=kinematics)
    method.kanes_equations(particles, loads)
    rates = method.mass_matrix.LUsolve(method.forcing)
    names = dict(zip((q.diff(symbols.t) for q in symbols.coordinates), v, strict=True))
    for rate, derived in zip(rates, accelerations(mechanism), strict=True):
        assert sympy.simplify(rate - derived.subs(names)) == 0


def test_matrices_are_symmetric_and_dissipation_is_not_negative(mechanism):
    matrices = motion_matrices(mechanism)
    for matrix in (matrices.mass, matrices.damping, matrices.stiffness):
        assert matrix == matrix.T
    rates = sympy.Matrix([coordinate.diff(symbols.t) for coordinate in symbols.coordinates])
    quadratic = (rates.T * matrices.damping * rates)[0] / 2
    without_pin = rayleigh_function(mechanism).subs(symbols.u, 0).doit()
    assert sympy.expand(quadratic - without_pin) == 0


def test_power_balance_holds_and_notices_what_is_left_over_and_a_damper_that_pushes(mechanism):
    balance = power_balance(mechanism)
    assert balance.holds
    assert not replace(balance, residual=symbols.c1).holds
    pushing = Damper(-symbols.c1, Ground(), mechanism.bodies[0])
    unstable = replace(mechanism, dampers=(pushing, *mechanism.dampers[1:]))
    assert not power_balance(unstable).holds


def test_pin_rides_on_the_motor(mechanism):
    bridge = mechanism.springs[1]
    assert sympy.expand(elongation(bridge) - (symbols.q2 - symbols.q1 - symbols.u)) == 0


def test_a_mechanism_of_ones_own():
    """One mass on a spring and a damper, driven through a pin on the mass's own foundation body."""
    foundation = RigidBody("foundation", symbols.m1, symbols.q1)
    load = RigidBody("load", symbols.m2, symbols.q2)
    pin = Pin(foundation, symbols.u)
    mechanism = Mechanism(
        (foundation, load), (Spring(symbols.k2, pin, load),), (Damper(symbols.c2, pin, load),), (pin,)
    )
    first, second = accelerations(mechanism)
    assert sympy.simplify(symbols.m1 * first + symbols.m2 * second) == 0, (
        "no outer force: momentum is constant"
    )
    assert kinetic_energy(mechanism).diff(symbols.q1) == 0
    assert potential_energy(mechanism).subs({symbols.q2: symbols.q1 + symbols.u}) == 0


def test_nonlinear_mechanism_is_refused():
    body = RigidBody("body", symbols.m1, symbols.q1)
    pin = Pin(body, symbols.u)
    mechanism = Mechanism((body,), (Spring(symbols.k1 * symbols.q1, Ground(), body),), (), (pin,))
    with pytest.raises(ValueError, match="not linear"):
        motion_matrices(mechanism)
