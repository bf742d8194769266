"""Symbols of printed equations: those that parts carry, and others like them."""

import re

import pytest

from trimmer import Body, Force, Friction, Link, Mechanism, MechanismError, Pin, Play, Stop
from trimmer.in_symbols.printed_symbols import plain_name, printed_symbols
from trimmer.mechanism import GROUND


def one_body(**sections):
    mount = {"mount": Link((GROUND, "a"), 1.0)}
    return Mechanism(**{"bodies": {"a": Body(1.0)}, "links": mount, **sections})


def symbol(mechanism, *place):
    return printed_symbols(mechanism)[place].symbol


def test_what_carries_no_symbol_is_named_after_its_part():
    mechanism = one_body(bodies={"a": Body(1.0), "motor & gear": Body(1.0)}, links={
        "mount_1": Link((GROUND, "a"), 1.0, 1.0),
        "50 % spring": Link(("a", "motor & gear"), 1.0),
    })  # fmt: skip
    assert symbol(mechanism, "bodies", "a", "mass") == "m_a"
    assert symbol(mechanism, "bodies", "motor & gear", "coordinate") == r"q_{\text{motor \& gear}}"
    assert symbol(mechanism, "links", "mount_1", "damping") == r"c_{\text{mount\_1}}"
    assert symbol(mechanism, "links", "50 % spring", "stiffness") == r"k_{\text{50 \% spring}}"


def test_the_only_pin_and_the_only_force_need_no_index():
    mechanism = one_body(pins={"belt": Pin(GROUND)}, forces={"push": Force("a", 1.0)})
    assert symbol(mechanism, "pins", "belt", "displacement") == "u"
    assert symbol(mechanism, "forces", "push", "value") == "P"
    assert symbol(mechanism, "forces", "push", "amplitude") == r"\hat{P}"


def test_the_other_symbols_of_a_part_follow_the_one_it_carries():
    mechanism = one_body(
        bodies={"a": Body(1.0, "m_7")},
        plays={"slot": Play((GROUND, "a"), 1.0, 1.0, 1.0, symbol="k_{bridge}")},
        frictions={"shoe": Friction((GROUND, "a"), 1.0, symbol="N_2")},
        forces={"push": Force("a", 1.0, symbol="Q_3")},
    )
    assert symbol(mechanism, "bodies", "a", "coordinate") == "q_7"
    assert symbol(mechanism, "plays", "slot", "gap") == r"g_{\text{bridge}}"
    assert symbol(mechanism, "frictions", "shoe", "static") == r"N^{\mathrm{s}}_{2}"
    assert symbol(mechanism, "forces", "push", "amplitude") == r"\hat{Q}_{3}"


def test_a_part_takes_another_symbol_where_that_of_its_index_is_carried_by_something_else():
    links = {"one": Link((GROUND, "a"), 1.0, 1.0, "q_2"), "two": Link((GROUND, "a"), 1.0, 1.0, "K_1")}
    mechanism = one_body(bodies={"a": Body(1.0, "m_2")}, links=links)
    found = {place: each.symbol for place, each in printed_symbols(mechanism).items()}
    assert found["bodies", "a", "coordinate"] == "q_a"
    assert found["links", "one", "stiffness"] == "q_2"
    assert len(set(found.values())) == len(found)


def test_parts_of_one_name_in_two_sections_have_different_symbols():
    mechanism = one_body(
        links={"x": Link((GROUND, "a"), 1.0, 1.0)},
        plays={"x": Play((GROUND, "a"), 1.0, 1.0, 1.0)},
        stops={"x": Stop((GROUND, "a"), 1.0, 1.0, 1.0)},
    )
    found = [each.symbol for each in printed_symbols(mechanism).values()]
    assert len(set(found)) == len(found)


@pytest.mark.parametrize(
    ("carried", "printed"),
    [
        ("m", "m"),
        ("m1", "m_1"),
        ("m_12", "m_12"),
        ("mu_1", "mu_1"),
        ("μ_1", "mu_1"),
        ("m_motor", r"m_{\text{motor}}"),
        ("mass", r"\text{mass}"),
        ("mu_bar", r"\mu_{\text{bar}}"),
        ("m_{1,2}", r"m_{\text{1,2}}"),
    ],
)
def test_a_carried_symbol_is_printed_as_it_is_meant(carried, printed):
    """SymPy would print m_bar with a bar over m."""
    assert symbol(one_body(bodies={"a": Body(1.0, carried)}), "bodies", "a", "mass") == printed


@pytest.mark.parametrize(
    ("name", "plain"),
    [
        ("k_2", "k2"),
        ("m_12", "m12"),
        (r"m_{\text{motor mount}}", "m_motor_mount"),
        (r"\mu_{\text{a\_b}}", "mu_a_b"),
        ("lambda", "lambda_"),
        (r"m_{\text{¼ größe}}", "m_gr_e"),
    ],
)
def test_names_of_python(name, plain):
    assert plain_name(name) == plain


def test_a_symbol_that_the_derivation_uses_is_refused():
    with pytest.raises(MechanismError, match=re.escape('bodies.a.symbol = "M": the derivation uses')):
        printed_symbols(one_body(bodies={"a": Body(1.0, "M")}))


def test_two_symbols_that_print_the_same_are_refused():
    bodies = {"a": Body(1.0, "m_1"), "b": Body(1.0, "m1")}
    links = {name: Link((GROUND, name), 1.0) for name in bodies}
    with pytest.raises(MechanismError, match=re.escape('bodies.b.symbol = "m1": several parts carry')):
        printed_symbols(Mechanism(bodies=bodies, links=links))


def test_names_in_letters_that_latex_lacks_are_numbers_in_their_order():
    names = ["theta", "Ж", "ſ", "ƀ", "xЖ"]  # the long s is the last letter that is printed
    mechanism = one_body(
        bodies={name: Body(1.0) for name in names}, links={name: Link((GROUND, name), 1.0) for name in names}
    )
    found = [symbol(mechanism, "bodies", name, "mass") for name in names]
    assert found == ["m_theta", "m_2", r"m_{\text{ſ}}", "m_4", "m_5"]
    assert symbol(mechanism, "links", "ƀ", "stiffness") == "k_4"


def test_a_number_that_is_taken_is_passed_over():
    bodies = {"Ж": Body(1.0), "a": Body(1.0, "m_1")}
    mechanism = one_body(bodies=bodies, links={name: Link((GROUND, name), 1, symbol=None) for name in bodies})
    assert [symbol(mechanism, "bodies", name, "mass") for name in bodies] == ["m_2", "m_1"]
    assert [symbol(mechanism, "bodies", name, "coordinate") for name in bodies] == ["q_1", "q_a"]


@pytest.mark.parametrize("name", ["<a>", "a`b", "a|b|c", "$x$", "x^2", "~", "{x}", "a\\b", "m" * 25])
def test_a_name_that_formulas_cannot_show_is_a_number(name):
    mechanism = Mechanism(bodies={name: Body(1.0)}, links={"k": Link(("ground", name), 1.0)})
    found = printed_symbols(mechanism)["bodies", name, "mass"]
    assert (found.symbol, found.meaning) == ("m_1", f"mass of {name}")
