"""The mechanisms of the definition's reference cases, built in Python."""

from trimmer import Body, ContactLaw, Friction, Link, Mechanism, Pin, Play


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
