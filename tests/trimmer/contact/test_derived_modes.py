"""In every mode that machines with all kinds of parts meet, the equations are those that are derived."""

from itertools import islice

import numpy as np
import pytest
import sympy

from derivations.any_mechanism.contact_law import contact_statement
from derivations.any_mechanism.curve_law import curve_statement, straight_between
from derivations.equations_of_motion import motion_matrices
from derivations.mechanism import elongation, elongation_rate
from derivations.parts import CurvedSpring, Wall
from derivations.symbols import t
from tests.mechanisms.random_mechanisms import with_every_part
from tests.quick import quick
from trimmer import simulate
from trimmer.contact.machine.statuses import MINUS, PLUS, RESTS, STICK
from trimmer.in_symbols.mechanism import symbolic_mechanism

MOST = 16  # Modes of a machine that are looked at


@pytest.mark.parametrize("seed", quick(range(300), 0))
def test_modes_are_as_derived(seed: int) -> None:
    machine = with_every_part(seed)
    course = simulate(machine, 6 / machine.frequency).course
    layout, ends = course.modes.system.layout, [*course.log.start[1:].tolist(), course.duration]
    middles = {
        int(mode): 0.5 * (start + end)
        for mode, start, end in zip(course.log.mode, course.log.start, ends, strict=True)
        if end > start
    }
    derived = Derived(machine, layout)
    assert middles
    for number, time in islice(middles.items(), MOST):
        mode = course.modes[number]
        (state,) = course.states(np.array([time]))
        # Where all sticks nothing is left of the terms that were added up.
        moduli = abs(mode.flow) + abs(course.modes.system.machine.base)
        rates, sizes = mode.flow @ state, moduli @ abs(state)
        expected = derived.accelerations(mode.statuses, time, state[: layout.state_count], rates, sizes)
        at = slice(derived.count, 2 * derived.count)
        np.testing.assert_array_less(abs(expected - rates[at]), 1e-9 * sizes[at] + 1e-9 * sizes[at].max())


class Derived:
    """The accelerations that the derived matrices and the laws of the parts give, with numbers put in."""

    def __init__(self, machine, layout):
        found = symbolic_mechanism(machine)
        self.symbolic, self.layout, self.machine = found.mechanism, layout, machine
        self.values = {e.quantity.symbol: e.value for e in found.quantities if e.value is not None}
        self.functions, self.count = {}, len(self.symbolic.bodies)
        matrices = motion_matrices(self.symbolic)
        self.matrices = {name: self.numbers(matrix) for name, matrix in vars(matrices).items()}
        self.waves = [[pin.law.diff(t, order) for order in range(3)] for pin in self.symbolic.pins]

    def value(self, expression, known):
        """Return the value of an expression in the numbers of the machine and others."""
        if expression not in self.functions:
            placed = {each: sympy.Dummy() for each in known}
            names = [*placed.values(), *self.values]
            self.functions[expression] = sympy.lambdify(names, expression.xreplace(placed), "math")
        return float(self.functions[expression](*known.values(), *self.values.values()))

    def numbers(self, matrix):
        return np.array(matrix.xreplace(self.values).tolist(), dtype=float).reshape(matrix.shape)

    def accelerations(self, statuses, time, state, rates, sizes):
        """Solve for accelerations, with the forces of what sticks, or rests on a wall, unknown."""
        of, (q, v) = self.matrices, (state[: self.count], state[self.count : 2 * self.count])
        known, moved = self.motion(time, q, v)
        u = [known[pin.displacement] for pin in self.symbolic.pins]
        u_rate = [known[pin.displacement.diff(t)] for pin in self.symbolic.pins]
        given = [self.value(force.law, {t: time}) for force in self.symbolic.forces]
        forces, columns, aims = self.parts(statuses, known, moved, state, rates, sizes)
        right = of["displacement_force"] @ u + of["velocity_force"] @ u_rate + of["given_force"] @ given
        right = right + forces + of["constant_force"][:, 0] - of["damping"] @ v - of["stiffness"] @ q
        held = len(aims)
        whole = np.zeros((self.count + held, self.count + held))
        whole[: self.count, : self.count] = of["mass"]
        if held:
            directions = np.array(columns).T
            whole[: self.count, self.count :] = -directions
            whole[self.count :, : self.count] = -directions.T
        scale = np.sqrt(np.append(1 / np.diag(of["mass"]), np.ones(held)))
        for at, column in enumerate(columns):
            scale[self.count + at] = 1 / np.sqrt(column @ np.linalg.solve(of["mass"], column))
        balanced = scale[:, None] * whole * scale
        found = np.linalg.lstsq(balanced, scale * np.append(right, -np.array(aims)), rcond=1e-12)[0]
        return (scale * found)[: self.count]

    def motion(self, time, q, v):
        """Return values of coordinates and pins and of their rates, and the accelerations of pins alone."""
        known, moved = {}, {}
        for body, place, speed in zip(self.symbolic.bodies, q, v, strict=True):
            known |= {body.coordinate.diff(t): speed, body.coordinate: place}
            moved[body.coordinate.diff(t, 2)] = 0.0
        for pin, law in zip(self.symbolic.pins, self.waves, strict=True):
            at = [self.value(each, {t: time}) for each in law]
            known |= {pin.displacement: at[0], pin.displacement.diff(t): at[1]}
            moved[pin.displacement.diff(t, 2)] = at[2]
        return known, moved

    def parts(self, statuses, known, moved, state, rates, sizes):
        """Return the known forces of contacts and frictions, and directions and aims of the others."""
        of, machine = self.matrices, self.layout
        forces, columns, aims = np.zeros(self.count), [], []
        names = [*machine.contacts, *machine.frictions]
        by_name = dict(zip(names, statuses, strict=False))
        by_name |= dict(zip(machine.walls, statuses[len(statuses) - len(machine.walls) :], strict=True))
        springs = dict(zip(machine.relaxing, range(2 * self.count, len(state)), strict=True))

        def value(expression):
            return self.value(expression, {**moved, **known})

        for column, contact in zip(of["contact_force"].T, self.symbolic.contacts, strict=True):
            s, s_rate = value(elongation(contact)), value(elongation(contact).diff(t))
            if isinstance(contact, Wall):
                if by_name[contact.name] == RESTS:
                    columns.append(column)
                    aims.append(value(elongation(contact).diff(t, 2)))
                continue
            if isinstance(contact, CurvedSpring):
                tension = self.value(curve_statement(contact).tension, {contact.distance: s})
            else:
                place = springs.get(contact.name)
                z = None if place is None else (state[place], rates[place], sizes[place])
                tension = self.tension(contact, by_name[contact.name], s, s_rate, z)
            forces += column * tension
        for column, friction in zip(of["friction_force"].T, self.symbolic.frictions, strict=True):
            if by_name[friction.name] == STICK:
                columns.append(column)
                aims.append(value(elongation_rate(friction).diff(t)))
                continue
            speed = value(elongation_rate(friction))
            kinetic = friction.kinetic
            if friction.points:
                kinetic = straight_between(friction.points, friction.rate, level=True)
            forces += column * self.value(kinetic, {friction.rate: abs(speed)}) * np.sign(speed)
        return forces, columns, aims

    def tension(self, contact, status, s, s_rate, z):
        """Return T; the rate of a relaxing spring must be the derived one."""
        statement = contact_statement(contact)
        rate_of, place, stretch = contact.distance.diff(t), contact.distance, contact.stretch
        if statement.stretch_rate is None:
            at = {rate_of: s_rate, place: s}
            if statement.stretch is not None:
                at[stretch] = self.value(statement.stretch, dict(at))
            return self.value(statement.tension, at)
        side = self.value(contact.gap / 2 if hasattr(contact, "side") else contact.gap, {})
        # On a side of the slot s - z is that side; in numbers it may lie beside it by rounding.
        beyond = {PLUS: side, MINUS: -side}.get(status)
        inside = s if beyond is None else z[0] + beyond + {PLUS: 1e-12, MINUS: -1e-12}[status] * abs(side)
        at = {rate_of: s_rate, stretch: z[0], place: inside}
        derived = self.value(statement.stretch_rate, at)
        assert z[1] == pytest.approx(derived, rel=1e-9, abs=1e-12 * z[2])
        return self.value(statement.tension, {stretch.diff(t): derived, stretch: z[0]})
