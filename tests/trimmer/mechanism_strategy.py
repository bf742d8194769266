"""Random mechanisms for property tests: any parts between any ends that may be joined."""

from itertools import permutations

from hypothesis import strategies as st

from trimmer.mechanism.kinds import Kind, kinds_of
from trimmer.mechanism.mechanism import Mechanism
from trimmer.mechanism.parts import GROUND, Body, ContactLaw, Force, Friction, Link, Pin, Play, Point, Stop

POSITIVE = st.floats(0.1, 10.0)
OR_ZERO = st.one_of(st.just(0.0), POSITIVE)
ORDERS = st.integers(1, 3)
SIGNED = st.one_of(st.just(0.0), st.floats(-2.0, 2.0))


@st.composite
def mechanisms(draw, most_bodies=4):
    body = st.one_of(st.builds(Body, POSITIVE), st.builds(Body, inertia=POSITIVE))
    bodies = {f"body {index}": draw(body) for index in range(draw(st.integers(1, most_bodies)))}
    weights = st.dictionaries(st.sampled_from(list(bodies)), st.floats(0.1, 3.0), min_size=1, max_size=2)
    points = {f"point {index}": Point(draw(weights)) for index in range(draw(st.integers(0, 2)))}
    carriers = [*bodies, *points, GROUND]
    pins = {
        f"pin {index}": Pin(draw(st.sampled_from(carriers)), *(draw(SIGNED) for _ in range(4)), draw(ORDERS))
        for index in range(draw(st.integers(0, 2)))
    }
    moved = {GROUND: {}, **{name: {name: 1.0} for name in bodies}}
    moved |= {name: point.weights for name, point in points.items()}
    moved |= {name: moved[pin.on] for name, pin in pins.items()}
    kinds = kinds_of({"bodies": bodies, "points": points, "pins": pins})
    kinds |= {name: draw(st.sampled_from(Kind)) for name, pin in pins.items() if pin.on == GROUND}
    pairs = [
        (first, second)
        for first, second in permutations(moved, 2)
        if moved[first] != moved[second] and len({kinds[end] for end in (first, second) if end in kinds}) == 1
    ]
    between = st.sampled_from(pairs)
    law = st.sampled_from(ContactLaw)
    # A link to the ground for each body, so that none is loose.
    links = {f"mount {name}": Link((GROUND, name), draw(POSITIVE), draw(OR_ZERO)) for name in bodies}
    links |= draw(_parts("link", st.builds(Link, between, OR_ZERO, OR_ZERO)))
    return Mechanism(
        bodies=bodies,
        frequency=draw(POSITIVE),
        points=points,
        pins=pins,
        links=links,
        plays=draw(_parts("play", st.builds(Play, between, POSITIVE, OR_ZERO, OR_ZERO, law))),
        stops=draw(_parts("stop", st.builds(Stop, between, POSITIVE, OR_ZERO, SIGNED, law))),
        frictions=draw(_parts("friction", st.builds(Friction, between, POSITIVE, st.none(), OR_ZERO))),
        forces=draw(
            _parts(
                "force",
                st.builds(
                    Force, st.sampled_from([*bodies, *points]), SIGNED, SIGNED, SIGNED, ORDERS, OR_ZERO
                ),
            )
        ),
    )


def _parts(kind, part):
    return st.lists(part, max_size=2).map(
        lambda parts: {f"{kind} {index}": each for index, each in enumerate(parts)}
    )
