"""What is remembered of a system: never more than its coefficients."""

import copy

import control
import pytest

from tests.trimmer.balance.loops import THIRD_ORDER
from trimmer import Relay, limit_cycles
from trimmer.balance.loop import inverse_response
from trimmer.linear import UnsupportedSystemError


def test_the_same_system_is_factored_once() -> None:
    again = control.TransferFunction(THIRD_ORDER)
    assert inverse_response(again) is inverse_response(THIRD_ORDER)


@pytest.mark.parametrize(
    "G", [control.tf([1.0], [1.0, 3.0, 2.0, 0.0]), control.tf2ss(THIRD_ORDER)], ids=["fraction", "states"]
)
def test_a_system_that_was_changed_in_place_is_factored_again(G) -> None:
    changed = copy.deepcopy(G)
    (before,) = limit_cycles(changed, Relay(1.0))
    if isinstance(changed, control.StateSpace):
        changed.C *= 2.0
    else:
        changed.num_array[0, 0] = 2.0 * changed.num_array[0, 0]
    (after,) = limit_cycles(changed, Relay(1.0))
    assert after.amplitude == pytest.approx(2.0 * before.amplitude, rel=1e-12)
    assert after.omega == pytest.approx(before.omega, rel=1e-12)


def test_a_system_that_is_refused_is_refused_again() -> None:
    for _ in range(2):
        with pytest.raises(UnsupportedSystemError, match="more zeros than poles"):
            limit_cycles(control.tf([1.0, 0.0, 1.0], [1.0, 1.0]), Relay(1.0))
