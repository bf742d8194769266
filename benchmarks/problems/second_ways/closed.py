"""Second ways on paper, with mpmath at 40 digits: closed forms, and equations of one unknown."""

import mpmath
from mpmath import mp, mpf

AT_40_DIGITS = mp.workdps(40)


@AT_40_DIGITS
def den_hartog() -> dict[str, float]:
    told = {}
    for ratio, force in (("0.7", "0.2"), ("1.2", "0.5"), ("2", "0.3")):
        r, b = mpf(ratio), mpf(force)
        v, u = 1 / (1 - r**2), mpmath.sin(mp.pi / r) / (r * (1 + mpmath.cos(mp.pi / r)))
        told[f"amplitude at r = {ratio}, b = {force}"] = mpmath.sqrt(v**2 - b**2 * u**2)
    return told


@AT_40_DIGITS
def block_on_belt() -> dict[str, float]:
    drop, speed = mpf(1) / 2, mpf("0.2")
    slip, stick = 2 * (mp.pi - mpmath.atan2(drop, speed)), 2 * drop / speed
    return {"amplitude": mpmath.hypot(drop, speed), "stick": stick, "period": slip + stick}


@AT_40_DIGITS
def end_of_stick_slip() -> float:
    """Belt speed at which the damped block's highest velocity after a slip is just that of the belt."""
    delta = mpf("0.05")
    omega = mpmath.sqrt(1 - delta**2)

    def y(t: mpf, v: mpf) -> mpf:
        begin = mpf("0.5") - 2 * delta * v
        return mpmath.exp(-delta * t) * (
            begin * mpmath.cos(omega * t) + (v + delta * begin) / omega * mpmath.sin(omega * t)
        )

    def touches(t: mpf, v: mpf) -> list[mpf]:
        rate = mpmath.diff(lambda x: y(x, v), t)
        return [rate - v, -y(t, v) - 2 * delta * rate]

    return mpmath.findroot(touches, (mpf("5.9"), mpf("0.5")))[1]


@AT_40_DIGITS
def soft_wall() -> dict[str, float]:
    told = {}
    for ratio in ("0.1", "0.3", "0.6"):
        zeta = mpf(ratio)
        eta = mpmath.sqrt(1 - zeta**2)
        angle = mpmath.atan2(2 * zeta * eta, 2 * zeta**2 - 1)
        told[f"rebound at zeta = {ratio}"] = mpmath.exp(-zeta / eta * angle)
    return told


@AT_40_DIGITS
def bouncing_ball() -> dict[str, float]:
    """One impact per period: the ball leaves with g T/2 and comes back with as much."""
    g, e, amplitude, omega = mpf("9.81"), mpf("0.6"), mpf("0.0005"), 40 * mp.pi
    period, unit, share = 2 * mp.pi / omega, g / omega**2, mp.pi * (1 - e) / (1 + e)
    phase = mpmath.acos(share * unit / amplitude)
    leaves, height = g * period / 2, amplitude * mpmath.sin(phase)
    return {
        "impact speed": leaves + amplitude * omega * mpmath.cos(phase),
        "peak to peak of x": height + leaves**2 / (2 * g) - height,
        "largest multiplier": e,  # a complex pair with the product e^2
        "fold": unit * share,
        "period doubling": unit * mpmath.hypot(share, 2 * (1 + e**2) / (1 + e) ** 2),
    }


@AT_40_DIGITS
def ball_to_rest() -> dict[str, float]:
    """Fall from 1 m, then a geometric series of flights, e = 0.8."""
    g, e = mpf("9.81"), mpf("0.8")
    speed = mpmath.sqrt(2 * g)
    return {"time of rest": speed / g + 2 * speed * e / (g * (1 - e)), "first impact": speed / g}
