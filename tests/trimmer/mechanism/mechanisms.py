"""Random mechanisms of one to four bodies, and the text of small ones."""

from hypothesis import strategies as st

from trimmer import Body
from trimmer.mechanism import ContactLaw, Force, Friction, Link, Mechanism, Output, Pin, Play, Point, Stop

NAMES = st.text(min_size=1, max_size=6).filter(
    lambda name: name.isprintable() and name == name.strip() and name != "ground"
)
NUMBERS = st.floats(-1e6, 1e6)
POSITIVE = st.floats(1e-9, 1e9)
NOT_NEGATIVE = st.one_of(st.just(0.0), POSITIVE)


@st.composite
def mechanisms(draw: st.DrawFn) -> Mechanism:
    names = draw(st.lists(NAMES, min_size=2, max_size=6, unique=True))
    count = draw(st.integers(1, len(names) - 1))
    turns = draw(st.booleans())
    bodies, pins = names[:count], names[count:]
    carriers = {name: draw(st.sampled_from(["ground", *bodies])) for name in pins}
    # A pair of ends moves against each other as bodies, and one of them is a body.
    sits = {"ground": "ground", **{body: body for body in bodies}, **carriers}
    pairs = [(a, b) for a in sits for b in sits if sits[a] != sits[b]]
    between = st.sampled_from(pairs)
    laws = st.sampled_from(ContactLaw)

    def parts(kind, *of):
        return draw(st.dictionaries(NAMES, st.builds(kind, *of), max_size=2))

    return Mechanism(
        title=draw(st.text(max_size=8).filter(str.isprintable)),
        frequency=draw(POSITIVE),
        bodies={name: Body(inertia=draw(POSITIVE)) if turns else Body(draw(POSITIVE)) for name in bodies},
        points={
            f"{name} and more": Point({name: each, bodies[0]: 0.5}, draw(st.booleans()) and turns)
            for name, each in draw(st.dictionaries(st.sampled_from(bodies), POSITIVE, max_size=2)).items()
        },
        pins={
            name: draw(st.builds(Pin, st.just(on), NUMBERS, NUMBERS, NUMBERS, NUMBERS, st.integers(1, 9)))
            for name, on in carriers.items()
        },
        links={f"mount {number}": Link(("ground", body), 1.0) for number, body in enumerate(bodies)}
        | parts(Link, between, NOT_NEGATIVE, NOT_NEGATIVE),
        plays=parts(Play, between, POSITIVE, NOT_NEGATIVE, NOT_NEGATIVE, laws),
        stops=parts(Stop, between, POSITIVE, NOT_NEGATIVE, NUMBERS, laws),
        frictions=parts(friction, between, NOT_NEGATIVE, NOT_NEGATIVE, NOT_NEGATIVE),
        forces=parts(Force, st.sampled_from(bodies), *[NUMBERS] * 3, st.integers(1, 9), NUMBERS),
        outputs=parts(Output, st.dictionaries(st.sampled_from(names), NUMBERS, min_size=1)),
        start=draw(st.dictionaries(st.sampled_from(bodies), st.tuples(NUMBERS, NUMBERS))),
    )


def friction(between: tuple[str, str], force: float, more: float, viscous: float) -> Friction:
    return Friction(between, force, force + more if more else None, viscous)
