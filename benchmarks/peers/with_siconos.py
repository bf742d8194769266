"""Siconos: a ball that falls on a floor, time stepping after Moreau and Jean, Newton's law of impact."""

import siconos.kernel as sk

from benchmarks.peers.telling import tell

SETTINGS = {"Moreau-Jean, 5 ms, as its example": 5e-3, "Moreau-Jean, 0.1 ms": 1e-4}


def first_impact(step: float) -> float:
    """Return when the ball's velocity first turns upward, to half a step."""
    ball = sk.LagrangianLinearTIDS([1.0], [0.0], [[0.1]])
    ball.setFExtPtr([-0.981])
    floor = sk.Interaction(sk.NewtonImpactNSL(0.8), sk.LagrangianLinearTIR([[1.0]]))
    system = sk.NonSmoothDynamicalSystem(0.0, 5.0)
    system.insertDynamicalSystem(ball)
    system.link(floor, ball)
    stepping = sk.TimeStepping(system, sk.TimeDiscretisation(0.0, step), sk.MoreauJeanOSI(0.5), sk.LCP())
    while stepping.hasNextEvent():
        stepping.computeOneStep()
        if ball.velocity()[0] > 0.0:
            return float(stepping.nextTime()) - 0.5 * step
        stepping.nextStep()
    raise ValueError("no impact")


if __name__ == "__main__":
    for setting, step in SETTINGS.items():
        tell("Siconos", setting, "ball-to-rest", "first impact", lambda s=step: first_impact(s))
