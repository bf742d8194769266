import math

import numpy as np
import pytest

from trimmer import Signal
from trimmer.signals import MotionQuantity, SignalError
from trimmer.signals.quantity import MOTION_UNITS, in_si, quantity_of


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
