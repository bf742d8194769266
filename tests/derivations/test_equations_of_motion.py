"""The equations of motion against Newton's law, SymPy's own mechanics package, and laws of mechanics."""

from dataclasses import replace

import pytest
import sympy
from sympy.physics.mechanics import KanesMethod, Particle, Point, ReferenceFrame, dynamicsymbols

from derivations import symbols
from derivations.equations_of_motion import accelerations, motion_matrices
from derivations.mechanism import Mechanism, trimmer
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


def test_power_balance_holds_and_notices_what_is_left_over_and_a_damper_that_pushes(mechanism):
    balance = power_balance(mechanism)
    assert balance.holds
    assert not replace(balance, residual=symbols.c1).holds
    pushing = Damper(-symbols.c1, Ground(), mechanism.bodies[0])
    unstable = replace(mechanism, dampers=(pushing, *mechanism.dampers[1:]))
    assert not power_balance(unstable).holds


def test_nonlinear_mechanism_is_refused():
    body = RigidBody("body", symbols.m1, symbols.q1)
    pin = Pin(body, symbols.u)
    mechanism = Mechanism((body,), (Spring(symbols.k1 * symbols.q1, Ground(), body),), (), (pin,))
    with pytest.raises(ValueError, match="not linear"):
        motion_matrices(mechanism)
