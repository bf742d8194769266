import math
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from trimmer.mechanism.units import UnitError, quantity, unit


@pytest.mark.parametrize(
    ("text", "si_unit", "number"),
    [
        ("40 um", "m", 40e-6),
        ("40um", "m", 40e-6),
        ("40 µm", "m", 40e-6),  # the micro sign
        ("40 μm", "m", 40e-6),  # the Greek letter
        (" -0.2mm ", "m", -0.2e-3),
        ("7 nm", "m", 7e-9),
        ("2 km", "m", 2e3),
        ("3 cm", "m", 0.03),
        ("35 g", "kg", 0.035),
        ("35 mg", "kg", 35e-6),
        ("1.5 t", "kg", 1500.0),
        ("+.5N", "N", 0.5),
        ("5. mN", "N", 5e-3),
        ("2 kN", "N", 2e3),
        ("30 N/mm", "N/m", 30e3),
        ("30 kN/m", "N/m", 30e3),
        ("3.5 N s/m", "N s/m", 3.5),
        ("3.5 N*s/m", "N s/m", 3.5),
        ("3.5 N·s/m", "N s/m", 3.5),
        ("3.5 Ns/m", "N s/m", 3.5),
        ("3.5 kg/s", "N s/m", 3.5),
        ("3.5e-1 N s / mm", "N s/m", 350.0),
        ("3 kg m/s²", "N", 3.0),
        ("3 kg*m*s^-2", "N", 3.0),
        ("3 kg m/s/s", "N", 3.0),
        ("3 kg m/s**2", "N", 3.0),
        ("3 s⁻¹", "Hz", 3.0),
        ("3 1/s", "Hz", 3.0),
        ("0.11 kHz", "Hz", 110.0),
        ("110e3 mHz", "Hz", 110.0),
        ("6600 rpm", "Hz", 110.0),
        ("6600 1/min", "Hz", 110.0),
        ("90 deg", "rad", math.pi / 2),
        ("180°", "rad", math.pi),
        ("90 arcmin", "rad", math.pi / 120),
        ("90 arcsec", "rad", math.pi / 7200),
        ("3 N/(mm s)", "N/m/s", 3e3),
        ("3 N*m/(rad·s) ", "N m/rad/s", 3.0),
        ("0.5 rad", "rad", 0.5),
        ("20 mm/s", "m/s", 0.02),
        ("50 g mm", "kg m", 50e-6),
        ("2", "1", 2.0),
        ("2 1", "1", 2.0),
        ("2 N/mm/mm", "N/m^2", 2e6),
        ("5 mm^2", "m²", 5e-6),
        ("4 s⁻²", "1/s^2", 4.0),
        ("2 °/s", "rad/s", math.pi / 90),
        ("1 m", "mm", 1000.0),
        ("0e100 m", "m", 0.0),
        (f"{'0' * 59}7 m", "m", 7.0),
    ],
)
def test_quantities_are_converted_exactly(text: str, si_unit: str, number: float) -> None:
    assert quantity(text, si_unit) == number


@pytest.mark.parametrize(
    ("text", "si_unit", "reason"),
    [
        ("3 kg", "m", "'kg' does not measure what m does"),
        ("7 rad/s", "Hz", "'rad/s' does not measure what Hz does"),
        ("3 N/m", "N s/m", "does not measure"),
        ("3", "m", "has no unit"),
        ("", "m", "no number with a unit"),
        ("m", "m", "no number with a unit"),
        ("1+1", "m", "unknown unit '\\+1'"),
        ("40 mu", "m", "unknown unit 'mu'"),
        ("40 UM", "m", "did you mean"),
        ("40 kmm", "m", "unknown unit"),
        ("3 N/m s", "N s/m", "two ways"),
        ("3 N/(m/s)", "N s/m", "unknown unit"),
        ("3 /s", "Hz", "unknown unit"),
        ("3 N//m", "N/m", "unknown unit"),
        ("3 m^0", "m", "unknown unit"),
        ("__import__('os')", "m", "not evaluated"),
        ("nan m", "m", "no number"),
        ("inf m", "m", "no number"),
        ("٣ m", "m", "no number"),
        ("1,5 mm", "m", "unknown unit"),
        ("1_000 m", "m", "unknown unit"),
        ("1e400 m", "m", "too large"),
        ("1e308 km", "m", "too large"),
        ("1e-323 nm", "m", "too small"),
        ("1e999999999 m", "m", "too large or too small"),
        ("0x10 m", "m", "unknown unit"),
        ("1" * 61 + " m", "m", "too many digits"),
        ("1e101 m", "m", "too many digits"),
        ("1e-101 m", "m", "too many digits"),
    ],
)
def test_what_does_not_fit_is_refused(text: str, si_unit: str, reason: str) -> None:
    with pytest.raises(UnitError, match=reason):
        quantity(text, si_unit)


@given(st.integers(-(10**6), 10**6), st.integers(-12, 12))
def test_a_prefix_is_the_power_of_ten(digits: int, exponent: int) -> None:
    assert quantity(f"{digits}e{exponent} um", "m") == float(f"{digits}e{exponent - 6}")


@given(st.text(max_size=12), st.sampled_from(["m", "N s/m", "rad", "1"]))
def test_any_text_is_a_finite_number_or_refused(text: str, si_unit: str) -> None:
    try:
        assert math.isfinite(quantity(text, si_unit))
    except UnitError as error:
        assert str(error)


@given(st.sampled_from(["kg", "m", "s", "N", "Hz", "deg", "min"]), st.sampled_from(["mm", "g", "kN", "rad"]))
def test_products_and_quotients_are_those_of_the_units(first: str, second: str) -> None:
    assert unit(f"{first} {second}") == unit(f"{second}*{first}")
    assert unit(f"{first} {second}/{second}") == unit(first)
    assert unit(f"{first}^2/{first}") == unit(first)
    assert unit(f"{first}/{first}").dimension == (0, 0, 0, 0)
    assert unit(f"{first}/{first}").scale == Fraction(1)


PREFIXES = {"n": -9, "u": -6, "µ": -6, "μ": -6, "m": -3, "c": -2, "k": 3, "M": 6}
UNITS = {
    "g": ("kg", -3, "nuµμmk"),
    "m": ("m", 0, "nuµμmck"),
    "s": ("s", 0, "nuµμm"),
    "N": ("N", 0, "nuµμmkM"),
    "Hz": ("1/s", 0, "mkM"),
    "rad": ("rad", 0, "m"),
    "t": ("kg", 3, ""),
    "rpm": ("1/min", 0, ""),
    "Ns": ("N s", 0, ""),
}
"""Another unit, the power of ten between both, and the prefixes that the first one takes."""


@pytest.mark.parametrize("name", UNITS)
def test_each_unit_takes_its_prefixes_and_no_others(name: str) -> None:
    other, power, prefixes = UNITS[name]
    assert quantity(f"1 {name}", other) == float(f"1e{power}")
    for prefix, exponent in PREFIXES.items():
        if prefix in prefixes:
            assert quantity(f"1 {prefix}{name}", other) == float(f"1e{power + exponent}")
        else:
            with pytest.raises(UnitError, match="unknown unit"):
                unit(prefix + name)
