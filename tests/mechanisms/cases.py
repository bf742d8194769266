"""The mechanisms of the definition's reference cases, built in Python."""

import math

from trimmer import Body, ContactLaw, Force, Friction, Link, Mechanism, Pin, Play, Stop


def trimmer(
    law: ContactLaw = ContactLaw.RELAXING, friction: float = 1.0, gap: float = 40e-6, damping: float = 0.4
) -> Mechanism:
    """The thesis's trimmer with play; the damping is that of the bridge, and a friction of 0 N is none."""
    return Mechanism(
        bodies={"motor": Body(0.035), "cutter": Body(0.003), "housing": Body(0.005), "guard": Body(0.030)},
        frequency=110.0,
        pins={"pin": Pin("motor", 1.5e-3)},
        links={
            "motor mount": Link(("ground", "motor"), 200e3, 3.5),
            "housing mount": Link(("ground", "housing"), 150e3, 1.0),
            "guard spring": Link(("housing", "guard"), 100e3, 4.0),
            "coil spring": Link(("housing", "cutter"), 1e3),
        },
        plays={"bridge": Play(("cutter", "pin"), 30e3, damping, gap, law)},
        frictions={"blade": Friction(("guard", "cutter"), friction)} if friction else {},
    )


def block_on_belt(start: tuple[float, float]) -> Mechanism:
    return Mechanism(
        bodies={"block": Body(1.0)},
        pins={"belt": Pin("ground", velocity=0.2)},
        links={"spring": Link(("ground", "block"), 1.0)},
        frictions={"rub": Friction(("belt", "block"), 0.5, 1.0)},
        start={"block": start},
    )


def thrown(damping_ratio: float, law: ContactLaw) -> Mechanism:
    """A body of mass 1 thrown with speed 1 from 0.125 before a wall of stiffness 1."""
    return Mechanism(
        bodies={"body": Body(1.0)},
        stops={"wall": Stop(("ground", "body"), 1.0, 2 * damping_ratio, 0.0, law)},
        start={"body": (-0.125, 1.0)},
    )


def driven_oscillator(stops: dict[str, Stop], frictions: dict[str, Friction], **changes: float) -> Mechanism:
    """One body on a spring of 4 N/m and a damper of 0.25 N s/m; omega and amplitude as given."""
    given = {"omega": 3.0, "amplitude": 3.0, "velocity": 0.0} | changes
    return Mechanism(
        bodies={"body": Body(1.0)},
        frequency=given["omega"] / (2 * math.pi),
        links={"spring": Link(("ground", "body"), 4.0, 0.25)},
        stops=stops,
        frictions=frictions,
        forces={"drive": Force("body", amplitude=given["amplitude"])},
        start={"body": (0.0, given["velocity"])},
    )
