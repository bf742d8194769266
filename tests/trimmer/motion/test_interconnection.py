"""What acts on what in an interconnection, where entries stand, and systems that are refused."""

from __future__ import annotations

import math
from typing import Any

import control
import numpy as np
import pytest

from tests.trimmer.motion.hand_made_loop import one_body, ring_of_bodies
from trimmer.errors import IllPosedLoopError, UnsupportedMotionError
from trimmer.motion.backlash_component import BacklashComponent
from trimmer.motion.interconnection import Interconnection, Layout, acts, effect, realized
from trimmer.motion.relay_component import RelayComponent
from trimmer.motion.threshold_component import ThresholdComponent


def changed(**parts: Any) -> Interconnection:
    return Interconnection(**{**vars(one_body()), **parts})


@pytest.mark.parametrize("unit", [1.0, -4e-5, 1e300, 1e-300])
def test_an_effect_is_a_product_over_its_terms(unit: float) -> None:
    sign = math.copysign(1.0, unit)
    row, column = np.array([3.0, -2.0, 0.0]), unit * np.array([1.0, 4.0, 9.0])
    assert effect(row, column) == pytest.approx(-5.0 / 11.0 * sign, rel=1e-14)
    assert effect(-row, column) == pytest.approx(5.0 / 11.0 * sign, rel=1e-14)
    assert effect(abs(row), column) == sign
    nearly = unit * np.array([2.0, 3.0 * (1.0 - 1e-13), 9.0])
    assert effect(row, nearly) == 0.0
    assert not acts(row, nearly)
    assert acts(row, unit * np.array([2.0, 3.0 * (1.0 - 1e-11), 9.0]))
    assert acts(row, unit * np.array([2.0, 3.0 * (1.0 + 1e-11), 9.0]))
    assert effect(row, 0.0 * column) == effect(0.0 * row, column) == 0.0


def test_entries_of_the_extended_state() -> None:
    layout = Layout.of(one_body())
    assert layout == Layout(2, (2, 5), 5, 8)
    assert layout.one.tolist() == [0.0] * 7 + [1.0]
    assert layout.unit(2).tolist() == [0.0, 0.0, 1.0] + [0.0] * 5
    assert Layout.of(ring_of_bodies()) == Layout(6, (6, 7, 7, 7, 7), 7, 10)
    turned = changed(components=one_body().components[::-1])
    assert Layout.of(turned) == Layout(2, (2, 2), 5, 8)


def test_a_feedthrough_is_refused_wherever_it_is() -> None:
    for place, label in (((0, 1), "backlash"), ((1, 0), "friction"), ((1, 1), "friction")):
        D = np.zeros((2, 2))
        D[place] = -1e-9
        with pytest.raises(IllPosedLoopError, match=f"{label}: an output acts on its input at once"):
            changed(D=D)


def test_a_force_must_not_act_on_a_rate_at_once() -> None:
    # The output of the second one acts on x itself.
    B = np.array([[0.0, 1.0], [5.0, -2.0]])
    with pytest.raises(IllPosedLoopError, match="friction: a force acts on its own rate at once"):
        changed(B=B)
    # A relay of the input does not mind, nor does friction that a load pushes without a jump.
    rates = np.array([[1.0, 0.0], [5.0, -2.0]])
    relay = RelayComponent(0.7, False)
    parts = {"components": (BacklashComponent(4e-5, 0.0), relay), "C": np.array([[0.0, 0.0], [1.0, 0.0]])}
    assert changed(B=B, **parts).order == 2
    parts["components"] = (BacklashComponent(4e-5, 0.0), RelayComponent(0.7, True))
    assert changed(B=rates, **parts).order == 2
    # One that jumps does.
    parts["components"] = (relay, RelayComponent(0.7, True))
    with pytest.raises(IllPosedLoopError, match="friction: a force acts on its own rate at once"):
        changed(B=rates, **parts)


def test_an_edge_that_a_relay_would_slide_along() -> None:
    B, C = np.array([[0.0, -1.0], [5.0, -2.0]]), np.array([[0.0, 0.0], [1.0, 0.0]])

    def with_thresholds(off: float, acting: float) -> Interconnection:
        components = (BacklashComponent(4e-5, 0.0), ThresholdComponent(0.7, 0.3, off))
        return changed(components=components, B=np.array([[0.0, acting], B[1]]), C=C)

    with pytest.raises(UnsupportedMotionError, match="friction: without hysteresis it would slide"):
        with_thresholds(0.3, -1.0)
    for off, acting in ((0.1, -1.0), (0.3, 1.0), (0.3, 0.0)):
        assert with_thresholds(off, acting).order == 2


def test_a_transfer_function_is_realized_and_a_model_is_itself() -> None:
    model = control.ss([[-2.0]], [[3.0]], [[4.0]], 0.5)
    assert realized(model) is model
    function = control.tf([3.0, 5.0], [2.0, 8.0, 6.0])
    found = realized(function)
    assert found.nstates == 2
    for s in (0.3j, 1.0 + 2.0j):
        assert found(s) == pytest.approx(function(s), rel=1e-13)
    assert realized(control.tf([2.0, 1.0], [1.0, 1.0])).D.tolist() == [[2.0]]
