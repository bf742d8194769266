"""Which frictions of a ring go on holding at an instant: three bodies, of which the first one is pushed."""

from __future__ import annotations

import numpy as np
import pytest

from tests.trimmer.motion.hand_made_loop import MASSES, RING, ring_of_bodies
from trimmer.motion.backlash_component import LOWER, BacklashComponent
from trimmer.motion.frictions.complementarity import _at_rest, _forces, complementary_mode
from trimmer.motion.interconnection import Interconnection
from trimmer.motion.loops import Drive
from trimmer.motion.mode_tables import ModeTables
from trimmer.motion.relay_component import HELD, MINUS, PLUS

OMEGA, HALF_GAP = 691.0, 3.8
EVERY = (1, 2, 3, 4)


def pushed() -> Interconnection:
    """Return 0.5, 2 and 4 kg; a wave of 2 m and an offset of 3.8 m are the acceleration of the first one.

    Frictions: 0.3 N between the first two, 0.5 N between the last two, 0.7 N between the first and the last,
    0.9 N between the last one and the ground.
    """
    ring = ring_of_bodies()
    components = (BacklashComponent(2 * HALF_GAP, 0.0), *ring.components[1:])
    return Interconnection(**{**vars(ring), "components": components, "drive": Drive(2.0, OMEGA)})


def decided(
    force: float, rate: float = 0.0, velocities: tuple[float, ...] = (0.0, 0.0, 0.0), relays=EVERY
) -> tuple[int, ...] | None:
    """Return the modes of the frictions under a force on the first body, N, that changes at a rate, N/s."""
    modes = ModeTables(pushed())
    sine, cosine = (force / 0.5 - HALF_GAP) / 2.0, rate / 0.5 / (2.0 * OMEGA)
    state = np.array([0.1, 0.2, 0.3, *velocities, 0.0, sine, cosine, 1.0])
    found = complementary_mode(modes, modes.number((LOWER, MINUS, MINUS, MINUS, MINUS)), state, relays)
    if found is None:
        return None
    first, *others = modes.component_modes(found)
    assert first == LOWER
    return tuple(others)


def test_what_a_force_at_rest_moves() -> None:
    for side, there in ((1.0, PLUS), (-1.0, MINUS)):
        assert decided(0.0) == decided(0.89 * side) == (HELD, HELD, HELD, HELD)
        # The ground gives way; then all three have one acceleration of 0.02 m/s^2 and a bit more.
        assert decided(0.91 * side) == decided(1.0 * side) == (HELD, HELD, HELD, there)
        # 1 N on the other two is more than the ground holds.
        assert decided(5.0 * side) == (there, HELD, there, there)


def test_what_slides_already_is_not_asked() -> None:
    # The last body slides back, and is pulled forward by the ground.
    assert decided(0.0, 0.0, (-0.2, -0.2, -0.2), (1, 2, 3)) == (HELD, HELD, HELD, MINUS)
    assert decided(9.0, 0.0, (-0.2, -0.2, -0.2), (1, 2, 3)) == (PLUS, HELD, PLUS, MINUS)
    assert decided(1.0, 0.0, (0.0, 0.0, 0.0), ()) is None


def test_at_a_limit_the_rate_decides_and_where_that_is_zero_the_next_one() -> None:
    assert decided(0.9, 1e-3) == (HELD, HELD, HELD, PLUS)
    assert decided(0.9, -1e-3) == (HELD, HELD, HELD, HELD)
    assert decided(-0.9, -1e-3) == (HELD, HELD, HELD, MINUS)
    assert decided(-0.9, 1e-3) == (HELD, HELD, HELD, HELD)
    # Below the limit rates do not matter.
    assert decided(0.9 * (1 - 1e-9), 1.0) == (HELD, HELD, HELD, HELD)
    # The wave is at its lowest at 0.9 N, and at its highest at -0.9 N it is not.
    assert decided(0.9, 0.0) == (HELD, HELD, HELD, PLUS)
    assert decided(-0.9, 0.0) == (HELD, HELD, HELD, HELD)


def test_outputs_that_are_no_forces_are_not_decided() -> None:
    system = pushed()
    system.B[3, 2] = 4.0
    modes = ModeTables(system)
    number, state = modes.number((LOWER, PLUS, PLUS, PLUS, PLUS)), np.array([0.0] * 9 + [1.0])
    assert complementary_mode(modes, number, state, EVERY) is None


@pytest.mark.parametrize(("side", "there"), [(1.0, PLUS), (-1.0, MINUS)])
def test_what_exceeds_a_limit_by_rounding_is_at_it(side: float, there: int) -> None:
    assert decided(0.9 * side * (1 + 1e-13), -side) == (HELD, HELD, HELD, HELD)
    assert decided(0.9 * side * (1 - 1e-13), side) == (HELD, HELD, HELD, there)
    # Its terms, of the offset and of the wave, add up to some newtons.
    assert decided(0.9 * side * (1 - 1e-11), side) == (HELD, HELD, HELD, there)
    assert decided(0.9 * side * (1 - 1e-10), side) == (HELD, HELD, HELD, HELD)
    assert decided(0.9 * side * (1 + 1e-9), -side) == (HELD, HELD, HELD, there)


def test_forces_are_outputs_times_scales() -> None:
    # The outputs of the second and the third one push twice and four times as much.
    modes = ModeTables(ring_of_bodies((1.0, 2.0, 4.0)))
    at_rest = _at_rest(modes, (0, PLUS, PLUS, PLUS, PLUS), (1, 2, 3))
    assert at_rest.relays == (1, 2, 3)
    assert at_rest.scales / at_rest.scales[0] == pytest.approx([1.0, 2.0, 4.0], rel=1e-12)
    assert at_rest.limits / at_rest.scales[0] == pytest.approx([0.3, 1.0, 2.8], rel=1e-12)
    influence = (RING / MASSES) @ RING.T
    np.testing.assert_allclose(at_rest.influence * at_rest.scales[0], influence, rtol=1e-12, atol=1e-15)
    assert _at_rest(modes, (0, PLUS, PLUS, PLUS, PLUS), ()) is None
    held = (0, HELD, HELD, HELD, PLUS)
    mode, state = modes.mode(modes.number(held)), np.array([1.0, -2, 3, -4, 5, -6, -7, 8, -9, 1.0])
    rows = np.array(
        [scale * mode.signals[k].output for k, scale in zip((3, 1), at_rest.scales[[2, 0]], strict=True)]
    )
    moduli = abs(rows)
    for order in range(3):
        forces, sizes = _forces(modes, at_rest, np.array([2, 0]), state, order, held)
        assert forces == pytest.approx(rows @ state, rel=1e-12, abs=1e-15)
        assert sizes == pytest.approx(moduli @ abs(state), rel=1e-12)
        rows, moduli = rows @ mode.matrix, moduli @ abs(mode.matrix)
