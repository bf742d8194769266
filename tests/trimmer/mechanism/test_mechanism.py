import copy
import dataclasses
import pickle
from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.trimmer.mechanism.mechanisms import mechanisms
from trimmer import ContactLaw, Mechanism, MechanismError, WrongTypeError
from trimmer.mechanism import Body, Force, Friction, Link, Output, Pin, Play, Stop, linear_matrices

BODIES = {"a": Body(1.0), "b": Body(2.0)}
LINK = Link(("a", "b"), 3.0)


@settings(max_examples=8)
@given(mechanisms())
def test_copies_are_equal(mechanism: Mechanism) -> None:
    pickled = pickle.loads(pickle.dumps(mechanism))
    for again in (pickled, copy.deepcopy(mechanism), dataclasses.replace(mechanism)):
        assert again == mechanism
        assert hash(again) == hash(mechanism)
        assert list(again.bodies) == list(mechanism.bodies)


def test_numbers_of_all_kinds_are_taken() -> None:
    mechanism = Mechanism(
        {"a": Body(1), "b": Body(np.float32(0.5))},
        frequency=np.int64(50),
        pins={"p": Pin("a", amplitude=np.array(2.0), order=np.int8(3))},
        plays={"c": Play(["b", "p"], 1, 2, 3, "pulling")},
        outputs={"y": Output({"b": 1})},
        start={"a": [0, np.float64(1)]},
    )
    assert mechanism.bodies["b"] == Body(0.5)
    assert mechanism.plays["c"] == Play(("b", "p"), 1.0, 2.0, 3.0, ContactLaw.PULLING)
    assert mechanism.start == {"a": (0.0, 1.0)}
    frequency, play, pin = mechanism.frequency, mechanism.plays["c"], mechanism.pins["p"]
    numbers = [frequency, *dataclasses.astuple(play)[1:4], pin.amplitude]
    assert {type(number) for number in numbers} == {float}
    assert type(mechanism.pins["p"].order) is int


def test_what_was_given_can_change_without_the_mechanism() -> None:
    bodies, weights = dict(BODIES), {"a": 1.0}
    mechanism = Mechanism(bodies, links={"l": LINK}, outputs={"y": Output(weights)})
    bodies.clear()
    weights.clear()
    assert mechanism.bodies == BODIES
    assert mechanism.outputs["y"].weights == {"a": 1.0}


def test_nothing_can_be_changed() -> None:
    mechanism = Mechanism(BODIES, links={"l": LINK}, outputs={"y": Output({"a": 1.0})})
    with pytest.raises(dataclasses.FrozenInstanceError):
        mechanism.frequency = 1.0  # type: ignore[misc]
    for mapping in (mechanism.bodies, mechanism.outputs["y"].weights, mechanism.start):
        with pytest.raises(TypeError):
            mapping["a"] = 1.0  # type: ignore[index]


def test_a_body_that_only_a_force_touches_is_free() -> None:
    assert Mechanism({"a": Body(1.0)}, forces={"weight": Force("a", constant=1.0)}).bodies["a"].mass == 1.0


def test_a_contact_without_spring_and_damper_may_relax() -> None:
    for kind, section in ((Play, "plays"), (Stop, "stops")):
        mechanism = Mechanism(BODIES, links={"l": LINK}, **{section: {"idle": kind(("a", "b"), gap=1.0)}})
        assert mechanism.value(f"{section}.idle.stiffness") == 0.0


def test_the_order_of_the_parts_counts() -> None:
    swapped = {name: BODIES[name] for name in ("b", "a")}
    links = {"l": LINK}
    assert Mechanism(BODIES, links=links) == Mechanism(dict(BODIES), links=dict(links))
    assert Mechanism(BODIES, links=links) != Mechanism(swapped, links=links)
    assert Mechanism(BODIES, links=links) != "mechanism"


def test_the_symbol_of_a_damping_is_that_of_its_stiffness_with_c() -> None:
    assert LINK.damping_symbol is None
    for kind in (Link, Play, Stop):
        assert kind(("a", "b"), symbol="k_2").damping_symbol == "c_2"


@pytest.mark.parametrize("number", [float("nan"), float("inf"), True, "1", "1 kg", None, [1.0], 1j, 10**400])
def test_what_is_no_finite_number_is_refused(number: object) -> None:
    with pytest.raises(MechanismError, match=r"bodies\.a\.mass"):
        Mechanism({"a": Body(number)}, links={"l": Link(("ground", "a"))})


@pytest.mark.parametrize(
    ("fields", "message"),
    [
        ({"bodies": {"a": 1.0}}, r"bodies\.a = 1\.0: give a trimmer\.mechanism\.Body"),
        ({"bodies": [Body(1.0)]}, r"bodies = .* must map names to instances of trimmer\.mechanism\.Body"),
        ({"bodies": {"": Body(1.0)}}, "a name must be text on one line"),
        ({"bodies": BODIES, "links": {"l": Friction(("a", "b"), 1.0)}}, r"give a trimmer\.mechanism\.Link"),
        ({"bodies": BODIES, "pins": {"p": Pin(3)}}, "name a body"),
        ({"bodies": BODIES, "outputs": {"y": Output(4)}}, r"y = .*: give a trimmer\.mechanism\.Output with"),
        ({"bodies": BODIES, "outputs": {"y": Output({"a": "1"})}}, r"outputs\.y\.a = '1': give a number"),
        (
            {"bodies": BODIES, "outputs": {"y": Output({"a": 1}, "rate")}},
            r"y\.kind = 'rate': choose displacement",
        ),
        ({"bodies": BODIES, "controllers": [3]}, "controllers = .* must map names to controllers"),
        ({"bodies": BODIES, "start": 3}, "start = 3: must map bodies"),
        ({"bodies": BODIES, "frequency": "110 Hz"}, "frequency = '110 Hz': give a number, in Hz"),
    ],
)
def test_wrong_types_are_refused_in_a_sentence(fields: dict, message: str) -> None:
    with pytest.raises(MechanismError, match=message):
        Mechanism(**fields)


@pytest.mark.parametrize(
    "call",
    [
        lambda mechanism: Mechanism.from_toml(3),
        lambda mechanism: Mechanism.from_toml_text(b"[bodies]"),
        lambda mechanism: mechanism.value(3),
        lambda mechanism: mechanism.with_value(None, 3.0),
    ],
)
def test_wrong_types_of_arguments_are_refused(call: Callable[[Mechanism], object]) -> None:
    with pytest.raises(WrongTypeError, match=r"(path|text|place) must be"):
        call(Mechanism(BODIES, links={"l": LINK}))


WRONG = st.sampled_from(
    [
        None,
        True,
        "x",
        "ground",
        3,
        -1.5,
        1j,
        float("nan"),
        [],
        [1],
        ("a", "b"),
        ("a", 3),
        {},
        {1: 2},
        {"a": "b"},
        b"a",
    ]
)
PARTS = st.one_of(
    WRONG,
    st.builds(Body, WRONG, WRONG),
    st.builds(Pin, WRONG, WRONG, order=WRONG),
    *(st.builds(kind, WRONG, WRONG, WRONG, symbol=WRONG) for kind in (Link, Play, Stop)),
    st.builds(Play, WRONG, law=WRONG),
    st.builds(Friction, WRONG, WRONG, WRONG, WRONG),
    st.builds(Force, WRONG, WRONG),
    st.builds(Output, WRONG),
)


@given(
    st.dictionaries(
        st.sampled_from([each.name for each in dataclasses.fields(Mechanism)]),
        st.one_of(WRONG, st.dictionaries(st.sampled_from(["a", "b", "ground", "", 3, None]), PARTS)),
    )
)
def test_whatever_is_given_ends_in_a_sentence(fields: dict) -> None:
    try:
        Mechanism(**{"bodies": BODIES, "links": {"l": LINK}} | fields)
    except MechanismError as error:
        assert str(error).startswith("the mechanism: ")


def test_several_problems_are_named_at_once() -> None:
    with pytest.raises(MechanismError) as raised:
        Mechanism({"a": Body(0.0), "b": Body(-1.0)})
    assert str(raised.value).splitlines()[0] == "the mechanism: 2 problems:"
    assert len(str(raised.value).splitlines()) == 3


def test_a_mechanism_is_told_in_a_line() -> None:
    pin, force = {"p": Pin("a", 1.0)}, {"f": Force("a", 1.0)}
    mechanism = Mechanism(BODIES, 1.0, pins=pin, links={"l": LINK}, forces=force, title="T")
    assert repr(mechanism) == "<Mechanism: T, 2 bodies, 1 pin, 1 link, 1 force>"
    assert repr(linear_matrices(mechanism)) == "<LinearMatrices: 2 bodies, 1 pin, 1 force>"
