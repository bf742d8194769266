"""Signals: values, times, names, units and quantities, what is refused, and bands."""

import math
import pickle

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from trimmer import Signal
from trimmer.errors import WrongTypeError
from trimmer.signals import Band, MotionQuantity, SignalError
from trimmer.signals.quantity import MOTION_UNITS, in_si, quantity_of
from trimmer.signals.signal import split_heading


def test_times_and_duration_count_from_the_start() -> None:
    signal = Signal(np.arange(4.0), 8.0, start=-0.5)
    assert signal.times.tolist() == [-0.5, -0.375, -0.25, -0.125]
    assert signal.duration == 0.5


def test_values_are_a_copy_that_cannot_be_changed() -> None:
    given_values = np.zeros(3)
    signal = Signal(given_values, 1.0)
    given_values[0] = 1.0
    assert signal.values[0] == 0.0
    with pytest.raises(ValueError, match="read-only"):
        signal.values[0] = 1.0


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ([], "at least one"),
        ([[1.0, 2.0]], "one dimension"),
        (["1", "2"], "real numbers"),
        ([1j], "real numbers"),
        ([True], "real numbers"),
        ([[1.0], [1.0, 2.0]], "one dimension"),
        ([0.0, np.nan, 1.0, np.inf], r"2 of 4 samples are not finite, the first is sample 2 \(nan\)"),
        ([1e301], "above 1e\\+300 cannot be computed with"),
    ],
)
def test_values_that_are_no_signal_are_refused(values, message: str) -> None:
    with pytest.raises(SignalError, match=message):
        Signal(values, 1.0)


@pytest.mark.parametrize("rate", [0.0, -1.0, np.nan, np.inf, True])
def test_a_sample_rate_must_be_positive_and_finite(rate) -> None:
    with pytest.raises(SignalError, match="sample rate must be a positive number of hertz"):
        Signal(np.zeros(2), rate)


def test_a_start_must_be_finite() -> None:
    with pytest.raises(SignalError, match="start is nan"):
        Signal(np.zeros(2), 1.0, start=np.nan)


@pytest.mark.parametrize(
    ("heading", "name", "unit"),
    [
        ("q2-q4", "q2-q4", ""),
        ("q2-q4 [m]", "q2-q4", "m"),
        ("q2-q4(m)", "q2-q4", "m"),
        ("  Zeit \n  (ms) ", "Zeit", "ms"),
        ("f(x) [m/s]", "f(x)", "m/s"),
        ("x []", "x", ""),
        ("[m]", "[m]", ""),
        ("a [m] b", "a [m] b", ""),
        ("a\x93b", "a\N{REPLACEMENT CHARACTER}b", ""),
        ("", "", ""),
    ],
)
def test_a_heading_is_a_name_and_a_unit(heading: str, name: str, unit: str) -> None:
    assert split_heading(heading) == (name, unit)


@given(st.text())
def test_any_heading_gives_a_name_that_a_signal_can_have(heading: str) -> None:
    name, unit = split_heading(heading)
    if name:
        signal = Signal(np.zeros(1), 1.0, name, unit)
        assert split_heading(signal.heading) == (name, unit)


@pytest.mark.parametrize(
    ("name", "unit"),
    [("", "m"), ("a\nb", ""), (" a", ""), ("a [m]", ""), ("a", "m]"), ("a", " "), ("\x00", "")],
)
def test_a_name_that_would_not_read_back_is_refused(name: str, unit: str) -> None:
    with pytest.raises(SignalError, match="cannot have the name"):
        Signal(np.zeros(1), 1.0, name, unit)


def test_a_signal_that_was_pickled_is_the_same_and_cannot_be_changed_either() -> None:
    signal = Signal([1.0, -2.0, 3.0], 50.0, "stroke", "m", start=0.25, notes=("a note",), converted=2)
    back = pickle.loads(pickle.dumps(signal))
    assert back.values.tolist() == [1.0, -2.0, 3.0]
    assert not back.values.flags.writeable
    for name in ("sample_rate", "name", "unit", "start", "notes", "converted", "full_scale", "trusted"):
        assert getattr(back, name) == getattr(signal, name)


@pytest.mark.parametrize(
    ("options", "error"),
    [
        ({"converted": 0.5}, ValueError),
        ({"interpolated": -1}, ValueError),
        ({"trusted": (0.0, 1.0)}, WrongTypeError),
        ({"full_scale": 0.0}, SignalError),
        ({"full_scale": np.nan}, SignalError),
        ({"notes": (1,)}, WrongTypeError),
        ({"name": 1}, WrongTypeError),
        ({"unit": None}, WrongTypeError),
    ],
)
def test_fields_of_a_signal_are_checked(options: dict[str, object], error: type[Exception]) -> None:
    with pytest.raises(error):
        Signal([1.0], 1.0, **options)  # type: ignore[arg-type]


def test_sizes_parts_and_scales() -> None:
    assert Signal([0.0, -7.5e299, 7.5e299], 1.0).rms == pytest.approx(np.sqrt(2 / 3) * 7.5e299)
    assert Signal([-5.0, -5.0], 1.0).rms == 0.0
    scaled = Signal([1.0, -2.0], 1.0, unit="V", full_scale=5.0).scaled(-3.0, "mm")
    assert (scaled.values.tolist(), scaled.unit, scaled.full_scale) == ([-3.0, 6.0], "mm", 15.0)
    signal = Signal(np.arange(10.0), 10.0, "stroke", "mm", start=1.0)
    assert repr(signal) == "<Signal: stroke [mm], 10 samples at 10 Hz, 1 s>"
    # Both ends belong to a part, and a millionth of a sample.
    for begin, end, values in (
        (1.2, 1.5, [2, 3, 4, 5]),
        (1.2 + 9e-8, 1.5 - 9e-8, [2, 3, 4, 5]),
        (1.81, 9, [9]),
    ):
        assert signal.between(begin, end).values.tolist() == values
    assert signal.between(1.2 + 2e-7, 1.5 - 2e-7).values.tolist() == [3, 4]
    with pytest.raises(SignalError, match=r"no sample lies from 1\.21 s to 1\.29 s: the record goes from 1"):
        signal.between(1.21, 1.29)


def test_bands_have_the_narrower_ends_with_their_reasons() -> None:
    wide, narrow = Band(2.0, 90.0, "a", "b"), Band(5.0, 80.0, "c", "d")
    assert wide.within(narrow) == narrow.within(wide) == narrow
    assert wide.within(Band(1.0, 80.0, "c", "d")) == Band(2.0, 80.0, "a", "d")
    assert wide.within(Band(2.0, 90.0, "c", "d")) == wide
    assert [each in wide for each in (2.0, 90.0, 1.9, 90.1)] == [True, True, False, False]
    assert wide.sentence == "trusted from 2 Hz (a) up to 90 Hz (b)"
    assert Band(2.0, lowest_reason="a").sentence == "trusted from 2 Hz (a)"
    assert Band().sentence == "trusted at all frequencies up to half of the sample rate"


@pytest.mark.parametrize(
    ("unit", "quantity", "size"),
    [
        ("m", MotionQuantity.DISPLACEMENT, 1.0),
        ("µm", MotionQuantity.DISPLACEMENT, 1e-6),
        ("mm/s", MotionQuantity.VELOCITY, 1e-3),
        ("m/s^2", MotionQuantity.ACCELERATION, 1.0),
        ("g", MotionQuantity.ACCELERATION, 9.80665),
        ("mg", MotionQuantity.ACCELERATION, 9.80665e-3),
        ("V", MotionQuantity.OTHER, 1.0),
        ("", MotionQuantity.OTHER, 1.0),
    ],
)
def test_a_unit_tells_quantity_and_size(unit: str, quantity: MotionQuantity, size: float) -> None:
    assert quantity_of(unit) is quantity
    assert in_si(unit) == pytest.approx(size, rel=1e-15)
    signal = Signal([1.0, -2.0], 1.0, "a", unit, full_scale=4.0).in_si()
    assert signal.values.tolist() == pytest.approx([size, -2.0 * size])
    assert signal.full_scale == pytest.approx(4.0 * size)
    assert signal.unit == (quantity.unit or unit)
    assert signal.quantity is quantity


def test_units_of_si_have_size_one() -> None:
    for quantity in MotionQuantity:
        assert in_si(quantity.unit) == 1.0
    assert all(0 < size < 10 for _, size in MOTION_UNITS.values())


def test_what_is_no_motion_has_no_derivatives() -> None:
    assert [each.derivatives for each in MotionQuantity if each is not MotionQuantity.OTHER] == [0, 1, 2]
    with pytest.raises(ValueError, match="not known how the signal follows"):
        _ = MotionQuantity.OTHER.derivatives


def test_a_part_of_a_signal_keeps_its_times() -> None:
    signal = Signal(np.arange(100.0), 10.0, start=2.0)
    part = signal.between(3.0, 4.95)
    assert (part.start, part.values[0], part.values[-1]) == (3.0, 10.0, 29.0)
    assert signal.between().values.size == 100
    with pytest.raises(SignalError, match=r"the record goes from 2 s to 11\.9 s"):
        signal.between(20.0)


@pytest.mark.parametrize("factor", [0.0, math.inf, math.nan])
def test_a_factor_that_makes_no_signal_is_refused(factor: float) -> None:
    with pytest.raises(SignalError, match="the factor must be finite and not 0"):
        Signal([1.0], 1.0).scaled(factor)
