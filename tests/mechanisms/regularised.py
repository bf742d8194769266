"""The same mechanisms, all smooth: no events, an implicit integrator, and an error that tends to zero.

Dry friction is F tanh(v / slow). A relaxing contact has a stiff spring between the sides of its slot, so that
its side has a force balance at all times; the other laws fade in over a small distance.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.integrate import solve_ivp
from scipy.special import expit

from tests.mechanisms.brute_force import extend, start_state
from tests.mechanisms.dynamics import Mode, System
from tests.mechanisms.parts import FREE, Contact
from trimmer.mechanism.mechanism import Mechanism
from trimmer.mechanism.parts import ContactLaw


@dataclass(frozen=True)
class Regularised:
    """How smooth.

    Attributes:
        smallness: Of the speed at which friction has its force, and of the distance over which contact fades
            in, relative to usual ones; of the slot's compliance relative to that of the spring.
        tolerance: Relative tolerance of the integrator.
    """

    smallness: float
    tolerance: float = 1e-9

    def final(self, mechanism: Mechanism, duration: float) -> np.ndarray:
        """Return displacements, velocities and z at the end.

        Raises:
            ValueError: if a static friction force exceeds the kinetic one, which has no smooth form.
        """
        system = System(mechanism)
        if any(friction.part.static_force > friction.part.force for friction in system.frictions):
            raise ValueError("a smooth friction force is never above the kinetic one")
        smooth = system.dynamics(
            Mode(tuple(FREE for _ in system.contacts), tuple(1 for _ in system.frictions))
        )
        usual = system.usual[: system.rows.state_size]
        solved = solve_ivp(
            lambda t, x: self._rates(system, smooth.rates, extend(system, x, t)),
            (0.0, duration),
            start_state(system),
            method="Radau",
            rtol=self.tolerance,
            atol=self.tolerance * 1e-3 * usual,
            max_step=duration / 50,
        )
        assert solved.success, solved.message
        return solved.y[:, -1]

    def _rates(self, system: System, all_free: np.ndarray, y: np.ndarray) -> np.ndarray:
        """Rates of the state: what is linear, and in place of sharp forces smooth ones."""
        count, size = len(system.masses), system.rows.state_size
        rates = (all_free @ y)[:size]
        force = np.zeros(count)
        slow = self.smallness * system.usual[count]
        for friction in system.frictions:
            missing = 1 - np.tanh(float(friction.velocity @ y) / slow)
            force += system.rows.direction(friction.part.between) * friction.part.force * missing
        for contact in system.contacts:
            tension = self._tension(contact, y, system.usual[0])
            force -= system.rows.direction(contact.part.between) * tension
            if contact.has_state:
                place = 2 * count + system.rows.relaxing.index(contact.name)
                rates[place] = (tension - contact.part.stiffness * y[place]) / contact.part.damping
        rates[count : 2 * count] += np.linalg.solve(system.mass, force)
        return rates

    def _tension(self, contact: Contact, y: np.ndarray, length: float) -> float:
        total, fade = 0.0, self.smallness * length
        for side in contact.sides:
            if contact.has_state:
                beyond = -float(contact.clearance(side) @ y)
                total += side * contact.part.stiffness / self.smallness * max(beyond, 0.0)
                continue
            beyond = float(contact.beyond(side) @ y)
            pull = side * float(contact.closed_force(side) @ y)
            if contact.part.law is not ContactLaw.PULLING and contact.part.damping:
                pull = max(pull, 0.0)
            total += side * pull * float(expit(beyond / fade))
        return total
