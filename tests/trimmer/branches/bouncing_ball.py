"""A ball of 1 kg under a weight of 1 N on a table that vibrates with 1 rad/s, in closed form.

With r the height of the ball above the table, r'' = -1 + A sin t in flight; in contact the stop adds
- c r' - k r, until r = 0 where the contact may pull. It is independent of the package.
"""

import math

import numpy as np
import scipy.optimize

from trimmer import Body, ContactLaw, Force, Mechanism, Pin, Stop

RESTITUTION = 0.75


def damping(stiffness: float) -> float:
    """Return the damping, N s/m, of a contact that leaves a free ball three quarters of its speed."""
    log = math.log(RESTITUTION)
    return -2.0 * log / math.hypot(math.pi, log) * math.sqrt(stiffness)


def ball(
    stiffness: float, phase: float, amplitude: float = 0.6, law: ContactLaw = ContactLaw.PULLING
) -> Mechanism:
    """Return the mechanism, with the phase of its only drive, rad."""
    return Mechanism(
        bodies={"ball": Body(1.0)},
        frequency=0.5 / math.pi,
        pins={"table": Pin("ground", amplitude=amplitude, phase=phase)},
        stops={"contact": Stop(("ball", "table"), stiffness, damping(stiffness), 0.0, law)},
        forces={"weight": Force("ball", constant=-1.0)},
    )


def thrown(phase: float, amplitude: float = 0.6) -> list[float]:
    """Return height and speed at t = 0 of a ball that a rigid table throws once a period."""
    hit = math.acos(math.pi * (1.0 - RESTITUTION) / (1.0 + RESTITUTION) / amplitude)
    flown = (phase - hit) % (2.0 * math.pi)
    return [amplitude * math.sin(hit) + math.pi * flown - 0.5 * flown**2, math.pi - flown]


def resting(stiffness: float, phase: float, amplitude: float) -> list[float]:
    """Return height and speed at t = 0 of a ball that stays on the table."""
    turn = amplitude * np.exp(1j * phase) * (1.0 + 1.0 / (stiffness - 1.0 + 1j * damping(stiffness)))
    return [float(turn.imag) - 1.0 / stiffness, float(turn.real)]


def fold(stiffness: float) -> float:
    """Return the smallest amplitude with which the table throws the ball once a period, m."""
    rate = damping(stiffness)
    dynamic = stiffness - 1.0 + 1j * rate
    own = complex(-0.5 * rate, math.sqrt(stiffness - 0.25 * rate**2))

    def after(time: float, begun: float, speed: float, amplitude: float) -> tuple[float, float]:
        """Return r and r' in contact a time after r = 0 with a speed."""
        turn = amplitude / (1j * dynamic)

        def forced(at: float) -> tuple[float, float]:
            wave = turn * np.exp(1j * at)
            return wave.real - 1.0 / stiffness, (1j * wave).real

        r, v = (given - each for given, each in zip((0.0, speed), forced(begun), strict=True))
        share = r - 1j * (v - own.real * r) / own.imag
        free = share * np.exp(own * time)
        return tuple(a + b for a, b in zip((free.real, (own * free).real), forced(begun + time), strict=True))  # type: ignore[return-value]

    def amplitude(begun: float) -> float:
        """Return the amplitude with which the ball meets the table at a time."""
        scale = np.array([math.pi / math.sqrt(stiffness), math.pi, 1.0])

        def missing(unknown: np.ndarray) -> list[float]:
            touched, speed, size = unknown * scale
            r, v = after(touched, begun, -speed, size)
            left, flown = begun + touched, 2.0 * math.pi - touched
            # r'' = -1 + A sin t from the time at which it leaves the table.
            v_end = v - flown - size * (math.cos(begun) - math.cos(left))
            r_end = (v + size * math.cos(left)) * flown - 0.5 * flown**2
            r_end -= size * (math.sin(begun) - math.sin(left))
            return [r * math.sqrt(stiffness), r_end, v_end + speed]

        found = scipy.optimize.root(missing, np.array([1.05, 1.0, 0.45]), tol=1e-13)
        return float(found.x[2])

    return float(scipy.optimize.minimize_scalar(amplitude, (-0.1, 0.0, 0.1), tol=1e-10).fun)
