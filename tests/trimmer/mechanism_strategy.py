"""Random mechanisms for property tests: any parts between any ends that may be joined."""

from itertools import permutations

from hypothesis import strategies as st

from trimmer import Body, ContactLaw, Force, Friction, Link, Mechanism, Pin, Play, Stop
from trimmer.mechanism import GROUND, ModalModel, Point, Structure
from trimmer.mechanism.kinds import Kind, kinds_of
from trimmer.mechanism.structures.ends import coordinates_in, points_in

POSITIVE = st.floats(0.1, 10.0)
OR_ZERO = st.one_of(st.just(0.0), POSITIVE)
ORDERS = st.integers(1, 3)
SIGNED = st.one_of(st.just(0.0), st.floats(-2.0, 2.0))


def _matrix(first, second, share):
    """Positive definite for a share below one."""
    coupled = share * (first * second) ** 0.5
    return [[first, coupled], [coupled, second]]


SHARES = st.one_of(st.just(0.0), st.floats(-0.9, 0.9))
MATRICES = st.builds(_matrix, POSITIVE, POSITIVE, SHARES)
REDUCED = st.builds(
    lambda mass, stiffness, damping, rotations: Structure(
        mass, stiffness, damping, coordinates=("u", "w"), rotations=rotations
    ),
    *(MATRICES, MATRICES, st.one_of(st.none(), MATRICES), st.sampled_from([(), ("w",)])),
)
MODES = st.builds(
    lambda frequency, ratio, shape: Structure(
        modes=ModalModel([0.0, frequency], [0.0, ratio], {"tip": [1.0, shape]})
    ),
    *(POSITIVE, OR_ZERO, SIGNED),
)
STRUCTURES = st.one_of(st.just({}), *(st.builds(dict, s=each) for each in (REDUCED, MODES)))


@st.composite
def mechanisms(draw, most_bodies=4):
    body = st.one_of(st.builds(Body, POSITIVE), st.builds(Body, inertia=POSITIVE))
    bodies = {f"body {index}": draw(body) for index in range(draw(st.integers(1, most_bodies)))}
    structures = draw(STRUCTURES)
    content = {"bodies": bodies, "structures": structures}
    coordinates, shapes = coordinates_in(content), points_in(content)
    weights = st.dictionaries(st.sampled_from(coordinates), st.floats(0.1, 3.0), min_size=1, max_size=2)
    points = {f"point {index}": Point(draw(weights)) for index in range(draw(st.integers(0, 2)))}
    free = [*coordinates, *points, *shapes]
    carriers = [*free, GROUND]
    pins = {
        f"pin {index}": Pin(draw(st.sampled_from(carriers)), *(draw(SIGNED) for _ in range(4)), draw(ORDERS))
        for index in range(draw(st.integers(0, 2)))
    }
    moved = {GROUND: {}, **{name: {name: 1.0} for name in coordinates}, **shapes}
    moved |= {name: point.weights for name, point in points.items()}
    moved |= {name: moved[pin.on] for name, pin in pins.items()}
    kinds = kinds_of({**content, "points": points, "pins": pins})
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
        structures=structures,
        frequency=draw(POSITIVE),
        points=points,
        pins=pins,
        links=links,
        plays=draw(_parts("play", st.builds(Play, between, POSITIVE, OR_ZERO, OR_ZERO, law))),
        stops=draw(_parts("stop", st.builds(Stop, between, POSITIVE, OR_ZERO, SIGNED, law))),
        frictions=draw(_parts("friction", st.builds(Friction, between, POSITIVE, st.none(), OR_ZERO))),
        forces=draw(
            _parts("force", st.builds(Force, st.sampled_from(free), SIGNED, SIGNED, SIGNED, ORDERS, OR_ZERO))
        ),
    )


def _parts(kind, part):
    return st.lists(part, max_size=2).map(lambda parts: {f"{kind} {i}": each for i, each in enumerate(parts)})
