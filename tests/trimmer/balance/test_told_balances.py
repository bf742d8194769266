"""What results of harmonic balance say of themselves: cycles, certificates, regions that are undecided."""

import math
from dataclasses import replace

import numpy as np
import pytest

from tests.trimmer.balance.loops import THIRD_ORDER, s
from trimmer.balance import Certificate, HarmonicBalance, LimitCycle, UndecidedRegion, harmonic_balance
from trimmer.elements import Element, FrictionBacklash, Relay, ViscousBacklash, ViscousFriction

REGION = UndecidedRegion((1.0, 2.0), (3.0, 4.0))
CERTIFICATE = Certificate("by hand", (1.0, 9.0), True, 12, (), 0.0, 1, 1, False)
CYCLE = LimitCycle(0.5, 4.0 * math.pi, True, 1e-12, 1.0, 1, 0)


def test_a_limit_cycle_tells_its_frequency_and_whether_it_is_near_tangency() -> None:
    assert CYCLE.frequency == pytest.approx(2.0)
    limit = math.radians(5.0)
    assert not replace(CYCLE, crossing_angle=limit).near_tangency
    assert replace(CYCLE, crossing_angle=0.999 * limit).near_tangency


@pytest.mark.parametrize(
    ("changes", "complete", "checked", "doubts", "words"),
    [
        ({}, True, True, 0, ""),
        ({"winding_number": None}, False, False, 1, "cannot be told"),
        ({"winding_number": None, "zero_on_axis": True}, True, True, 0, ""),
        ({"winding_number": 2}, False, False, 1, "is 2 and the sum of the indices 1"),
        ({"winding_number": 2, "zero_on_axis": True}, False, False, 1, "is 2 and the sum of the indices 1"),
        ({"smallest_gain": 1e-10}, False, True, 1, "not excluded, next to a pole of G"),
        ({"smallest_gain": 1e-10, "winding_number": 2}, False, False, 2, "not excluded"),
        # Where something is undecided or unproven, a winding number that differs is no doubt of its own.
        ({"undecided": (REGION,), "winding_number": 2}, False, False, 1, ""),
        ({"unproven": ("nothing is known",), "winding_number": 2}, False, False, 1, "nothing is known"),
    ],
)
def test_a_certificate_is_complete_only_without_doubts(
    changes: dict[str, object], complete: bool, checked: bool, doubts: int, words: str
) -> None:
    found = replace(CERTIFICATE, **changes)  # type: ignore[arg-type]
    assert (found.complete, found.checked, len(found.doubts)) == (complete, checked, doubts)
    assert words in "".join(found.doubts[:1])


def test_what_is_told_of_results() -> None:
    assert repr(CERTIFICATE) == "<Certificate: complete, 1 to 9 rad/s, 0 undecided regions>"
    assert repr(replace(CERTIFICATE, undecided=(REGION,))) == (
        "<Certificate: not complete, 1 to 9 rad/s, 1 undecided region>"
    )
    assert "touch or coincide" in REGION.reason
    assert "smallest amplitude" in replace(REGION, at_edge=True).reason


def test_a_balance_is_confirmed_by_the_winding_number_of_its_own_cycles() -> None:
    balance = HarmonicBalance((CYCLE,), CERTIFICATE)
    two = HarmonicBalance(
        (CYCLE, replace(CYCLE, index=-1)), replace(CERTIFICATE, winding_number=0, index_sum=0)
    )
    unknown = replace(CERTIFICATE, winding_number=None, zero_on_axis=True)
    doubtful = replace(CERTIFICATE, smallest_gain=1e-9)
    for found, confirmed, success in (
        (balance, True, True),
        (two, True, True),
        (replace(two, limit_cycles=(CYCLE,)), False, False),
        (replace(balance, certificate=unknown), None, True),
        (replace(balance, certificate=doubtful), True, False),
    ):
        assert (found.confirmed, found.success) == (confirmed, success)
    assert "1 limit cycle found" in balance.message
    assert "2 limit cycles found" in two.message


def test_a_certificate_holds_what_was_done() -> None:
    element = Relay(2.0) + ViscousFriction(0.1)
    balance = harmonic_balance(THIRD_ORDER, element, omega_range=(0.5, 5.0))
    certificate = balance.certificate
    assert (certificate.omegas, certificate.outside_excluded, certificate.undecided) == (
        (0.5, 5.0),
        False,
        (),
    )
    assert (certificate.smallest_gain, certificate.winding_number, certificate.index_sum) == (0.0, 1, 1)
    assert certificate.boxes > 0
    assert balance.loop is not None
    assert balance.loop.element is element
    # s³ + 3 s² + 2 s + 0.1 s + N: omega² = 2.1, N = 3 omega², A = 4 2/(π N).
    (cycle,) = balance.limit_cycles
    assert (cycle.omega**2, cycle.amplitude) == pytest.approx((2.1, 8.0 / (math.pi * 6.3)))
    assert (cycle.index, cycle.stable, cycle.other_unstable_poles) == (1, True, 0)
    frozen = harmonic_balance(THIRD_ORDER, element, frozen_omega=2.0).loop
    assert frozen is not None
    assert frozen.element != element


@pytest.mark.parametrize(("middle", "counts"), [(1.99, True), (2.01, True), (2.5, False), (0.5, False)])
def test_a_zero_on_the_axis_counts_within_the_range(middle: float, counts: bool) -> None:
    given = (middle - 0.1, middle + 0.1)
    system = 20 * (s**2 + 4) / (s + 1) ** 4
    assert harmonic_balance(system, FrictionBacklash(1.0), given).certificate.zero_on_axis is counts


@pytest.mark.parametrize("element", [FrictionBacklash(1.0), ViscousBacklash(1.0, 0.3)], ids=repr)
def test_the_crossing_angle_and_the_index_are_those_of_differences(element: Element) -> None:
    """Of N over A and of -1/G, less what N changes by itself, over omega: Loeb's rule tells their turn."""
    system = 10 / (s * (s + 1))

    def rest(amplitude: float, omega: float) -> complex:
        return complex(element.describing_function(amplitude, omega)) + 1.0 / complex(system(1j * omega))

    cycles = harmonic_balance(system, element).limit_cycles
    assert sorted(cycle.index for cycle in cycles) == [-1, 1]
    for cycle in cycles:
        A, w, step = cycle.amplitude, cycle.omega, 1e-6
        by_a = rest(A * (1 + step), w) - rest(A * (1 - step), w)
        by_w = rest(A, w * (1 + step)) - rest(A, w * (1 - step))
        sine = math.sin(np.angle(by_w / by_a))
        assert math.sin(cycle.crossing_angle) == pytest.approx(abs(sine), rel=1e-5)
        assert cycle.index == np.sign(sine)
        assert cycle.residual == pytest.approx(abs(rest(A, w) * complex(system(1j * w))), abs=1e-12)
