"""Units that multiply, and symbols with their letters and indices, each written out by hand."""

from __future__ import annotations

import math
from fractions import Fraction

import pytest

from tests.trimmer.mechanism.hand_made import MECHANISM
from trimmer.mechanism.mechanism import Mechanism
from trimmer.mechanism.parts import Body, Force
from trimmer.mechanism.printed_symbols import (
    _escaped,
    _split,
    _with_index,
    natural_order,
    plain_name,
    printed_symbols,
    value_of,
)
from trimmer.mechanism.symbols import is_symbol
from trimmer.mechanism.units import Unit, UnitError, quantity, unit


def test_units_multiply_and_rise() -> None:
    metre, second = unit("m"), unit("s")
    assert (metre * second).dimension == (0, 1, 1, 0)
    assert (quantity("1 m", "mm"), quantity("3 mm", "mm")) == (1000.0, 3.0)
    assert (unit("mm") ** 3).scale == Fraction(1, 10**9)
    assert (unit("deg^2").half_turns, unit("deg/deg").half_turns, unit("1/deg").half_turns) == (2, 0, -1)
    assert quantity("2 deg²", "rad^2") == pytest.approx(2.0 * (math.pi / 180) ** 2, rel=1e-15)
    assert quantity("180 1/deg", "1/rad") == pytest.approx(180 * 180 / math.pi, rel=1e-15)
    sizes = {
        "min": 60.0,
        "t": 1000.0,
        "Ns": 1.0,
        "rpm": 1 / 60,
        "MN": 1e6,
        "cm": 0.01,
        "ns": 1e-9,
        "kHz": 1e3,
        "mrad": 1e-3,
    }
    assert {name: pytest.approx(float(unit(name).scale), rel=1e-15) for name in sizes} == sizes
    for name in ("cN", "krad", "Mm", "cs", "nHz", "kt", "mmin"):
        with pytest.raises(UnitError, match="unknown unit"):
            unit(name)
    assert quantity("0e100 m", "m") == 0.0
    for text in ("1e101 m", "1e-101 m", f"{'1' * 61} m"):
        with pytest.raises(UnitError, match="too many digits"):
            quantity(text, "m")
    assert quantity(f"{'0' * 59}7 m", "m") == 7.0


def test_symbols_are_split_and_indexed() -> None:
    splits = {"k": ("k", None), "k12": ("k", "12"), "k1_a": ("k", "1,a"), "mass_2": (r"\text{mass}", "2")}
    splits |= {"φ_μ": ("phi", "mu"), "phi_{a,b}": ("phi", "a,b")}
    assert {symbol: _split(symbol) for symbol in splits} == splits
    indexed = {
        ("k", None): "k",
        ("k", "2"): "k_2",
        ("k", "a"): "k_a",
        ("k", "mu"): "k_mu",
        ("k", "ab"): r"k_{\text{ab}}",
    }
    indexed |= {
        ("k", "²"): r"k_{\text{²}}",
        ("phi", "ab"): r"\phi_{\text{ab}}",
        (r"\hat{k}", "2"): r"\hat{k}_{2}",
    }
    assert {pair: _with_index(*pair) for pair in indexed} == indexed
    assert _escaped(r"a{b}$&#_%") == r"a\{b\}\$\&\#\_\%"
    assert [is_symbol(each) for each in ("k_2", "k_{1,2}", "kb12_x", "k_", "2k", "k 2", "", 3)] == [
        *[True] * 3,
        *[False] * 5,
    ]
    assert sorted(["q_10", "q_2", "p", "q_1a"], key=natural_order) == ["p", "q_1a", "q_2", "q_10"]
    assert plain_name(r"\hat{u}_{2}") == "u2"


def test_symbols_with_what_they_stand_for() -> None:
    found = printed_symbols(MECHANISM)
    assert found["plays", "bridge", "gap"].meaning == "gap of bridge"
    assert found["plays", "bridge", "gap"].unit == "m"
    assert found["pins", "pin", "phase"].symbol == r"\varphi"
    assert found["plays", "bridge", "side"].symbol == r"\sigma_{\text{bridge}}"
    two = Mechanism({"a": Body(1.0, "m_3")}, forces={"f": Force("a", 1.0), "g": Force("a", 2.0, symbol="Q")})
    names = {place: each.symbol for place, each in printed_symbols(two).items()}
    assert (names["forces", "f", "value"], names["forces", "g", "value"]) == ("P_f", "Q")
    assert names["forces", "g", "constant"] == r"\bar{Q}"
    assert (names["bodies", "a", "mass"], names["bodies", "a", "coordinate"]) == ("m_3", "q_3")
    assert value_of(MECHANISM, ("frictions", "rub", "static")) == 0.5
    assert value_of(MECHANISM, ("plays", "bridge", "gap")) == 40e-6
    assert value_of(MECHANISM, ("bodies", "motor", "coordinate")) is None


BASES = {
    "1": (Fraction(1), (0, 0, 0, 0), 0, ""),
    "g": (Fraction(1, 1000), (1, 0, 0, 0), 0, "n u m k"),
    "m": (Fraction(1), (0, 1, 0, 0), 0, "n u m c k"),
    "s": (Fraction(1), (0, 0, 1, 0), 0, "n u m"),
    "N": (Fraction(1), (1, 1, -2, 0), 0, "n u m k M"),
    "Hz": (Fraction(1), (0, 0, -1, 0), 0, "m k M"),
    "rad": (Fraction(1), (0, 0, 0, 1), 0, "m"),
    "t": (Fraction(1000), (1, 0, 0, 0), 0, ""),
    "min": (Fraction(60), (0, 0, 1, 0), 0, ""),
    "rpm": (Fraction(1, 60), (0, 0, -1, 0), 0, ""),
    "Ns": (Fraction(1), (1, 1, -1, 0), 0, ""),
    "deg": (Fraction(1, 180), (0, 0, 0, 1), 1, ""),
    "°": (Fraction(1, 180), (0, 0, 0, 1), 1, ""),
}
"""Size without powers of pi; powers of kilogram, metre, second and radian; power of pi; prefixes."""
PREFIXES = {"n": -9, "u": -6, "µ": -6, "μ": -6, "m": -3, "c": -2, "k": 3, "M": 6}


@pytest.mark.parametrize("name", BASES)
def test_each_unit_has_its_size_and_dimension_with_every_prefix_it_takes(name: str) -> None:
    scale, dimension, half_turns, prefixes = BASES[name]
    assert unit(name) == Unit(scale, dimension, half_turns)
    for prefix, exponent in PREFIXES.items():
        if prefix.replace("µ", "u").replace("μ", "u") in prefixes.split():
            assert unit(prefix + name) == Unit(scale * Fraction(10) ** exponent, dimension)
        elif prefix + name not in ("min", "cm", "m1"):
            with pytest.raises(UnitError, match="unknown unit"):
                unit(prefix + name)
