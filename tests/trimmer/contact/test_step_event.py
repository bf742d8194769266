"""The first event within a step, in plain Python, of event functions whose zeros are known."""

from __future__ import annotations

import numpy as np
import pytest

from tests.trimmer.contact.hand_made import COUNT, tables_of, work_at
from tests.trimmer.uncompiled import uncompile
from trimmer.contact import relaxing_root as relaxing_module
from trimmer.contact import step_event
from trimmer.contact.statuses import ARRIVED, AT_LIMIT, BROKEN, MADE_MINUS, MADE_PLUS
from trimmer.contact.step_event import NO_EVENT, first_event
from trimmer.motion import first_event as first_event_of_motion
from trimmer.motion.first_event import NOWHERE, ROUNDING
from trimmer.motion.taylor import bernstein_from_taylor

FALLING, RISING = (0.3, -1.0), (0.2, 1.0)


@pytest.fixture(autouse=True)
def plain(monkeypatch: pytest.MonkeyPatch) -> None:
    uncompile(monkeypatch, step_event, relaxing_module, first_event_of_motion)


def found(tables, work, at_start=False, recent=-1, mode=0, now=0):
    return step_event.first_event(tables, work, mode, now, at_start, recent)


def test_it_is_the_function_that_falls_first() -> None:
    assert first_event is not step_event.first_event  # It is the plain one.
    tables = tables_of([(0.9, -1.0), FALLING, (0.4, -1.0), RISING], (0, 1, 2, 3), (ARRIVED,) * 4)
    fired, fraction, jumped, close = found(tables, work_at(tables, 5.0, 7.0, 1.0))
    assert (fired, jumped, close) == (1, False, False)
    assert fraction == pytest.approx(0.3, rel=1e-14)


def test_a_state_scales_all_functions() -> None:
    tables = tables_of([(0.9, -1.0), RISING], (0, 1), (ARRIVED,) * 2)
    tables.screen[0, 0, 3 + COUNT :], tables.taylor[0, 1, 0, 0] = -1.0, -1.0
    tables.sizes[0, 1, 0, 0] = 1.0
    # The second one is now 1/5 + s - x; with x = 3 it is negative at once, and with x = -3 it never is.
    assert found(tables, work_at(tables, 3.0, 0.0, 1.0), at_start=True)[:3] == (1, 0.0, True)
    assert found(tables, work_at(tables, -3.0, 0.0, 1.0))[0] == 0


def test_none_falls() -> None:
    tables = tables_of([RISING, (1.0, -0.9)], (0, 1), (ARRIVED,) * 2)
    assert found(tables, work_at(tables, 0.0, 0.0, 1.0)) == (NO_EVENT, NOWHERE, False, False)


@pytest.mark.parametrize("at_start", [True, False])
def test_what_is_negative_at_once_has_jumped_only_at_the_start(at_start: bool) -> None:
    tables = tables_of([(-0.1, 0.0, 1.0)], (1,), (BROKEN,))
    assert found(tables, work_at(tables, 0.0, 0.0, 1.0), at_start) == (0, 0.0, at_start, False)


@pytest.mark.parametrize("recent", [2, 3])
def test_of_several_that_are_negative_at_once_that_of_the_last_event_comes_first(recent: int) -> None:
    tables = tables_of([(-0.1,), (-0.2,), (-0.3,)], (2, 3, 1), (AT_LIMIT,) * 3)
    fired, *_ = found(tables, work_at(tables, 0.0, 0.0, 1.0), True, recent)
    assert fired == recent - 2
    assert found(tables, work_at(tables, 0.0, 0.0, 1.0), True, -2)[0] == 0


def test_what_is_known_to_vanish_is_not_found_again_but_its_next_zero_is() -> None:
    # Rounding has left -1e-18 of what is zero: s (1/2 - s) falls through zero at 1/2.
    tables = tables_of([(-1e-18, 0.5, -1.0)], (1,), (BROKEN,))
    work = work_at(tables, 0.0, 0.0, 1.0)
    work.known_zeros[1], work.known_action[1] = 1, BROKEN
    fired, fraction, jumped, _ = found(tables, work, True)
    assert (fired, jumped) == (0, False)
    assert fraction == pytest.approx(0.5, rel=1e-14)


def test_what_is_known_counts_for_its_own_function_alone_and_only_at_the_start() -> None:
    tables = tables_of([(-0.1, 1.0)], (1,), (BROKEN,))
    work = work_at(tables, 0.0, 0.0, 1.0)
    work.known_zeros[1], work.known_action[1] = 1, MADE_PLUS
    assert found(tables, work, True)[:3] == (0, 0.0, True)
    work.known_action[1] = BROKEN
    assert found(tables, work, True)[0] == NO_EVENT
    assert found(tables, work, False)[:3] == (0, 0.0, False)
    assert step_event._known_zeros(tables, work, 0, 0) == 1
    # Functions of several frictions have no owner: of the last part nothing is known by it.
    joint = tables_of([(-0.1, 1.0)], (-1,), (BROKEN,))
    work.known_zeros[-1], work.known_action[-1] = 1, BROKEN
    assert step_event._known_zeros(joint, work, 0, 0) == 0


def test_a_function_that_falls_from_a_known_zero_is_negative_after_it_without_a_jump() -> None:
    tables = tables_of([(0.0, -0.5, 1.0)], (1,), (BROKEN,))
    work = work_at(tables, 0.0, 0.0, 1.0)
    work.known_zeros[1], work.known_action[1] = 1, BROKEN
    assert found(tables, work, True) == (0, 0.0, False, False)


def test_what_stays_at_zero_is_no_event() -> None:
    tables = tables_of([(-1e-17, 1e-17)], (1,), (BROKEN,))
    tables.sizes[:, 0, 0] = 1.0
    assert found(tables, work_at(tables, 0.0, 0.0, 1.0), True)[0] == NO_EVENT
    nothing = tables_of([()], (1,), (BROKEN,))
    assert found(nothing, work_at(nothing, 0.0, 0.0, 1.0), True)[0] == NO_EVENT


def test_leading_coefficients_below_rounding_are_zero_at_the_start_alone() -> None:
    state, sizes = np.array([-2.0, 1.0, 1.0]), np.ones((COUNT, 3))
    sizes[1] = 5.0
    small = 3.9 * ROUNDING

    def zeros(known: int, at_start: bool, *leading: float) -> tuple[int, list[float]]:
        taylor = np.ones(COUNT)
        taylor[: len(leading)] = leading
        number = step_event._zeros(taylor, state, sizes, known, at_start)
        return number, taylor[: len(leading)].tolist()

    assert zeros(0, True, small, 1.0) == (1, [0.0, 1.0])
    assert zeros(0, True, 1.1 * small) == (0, [1.1 * small])
    assert zeros(0, False, small) == (0, [small])
    assert zeros(0, False, 0.0, 0.5) == (1, [0.0, 0.5])
    # The second is measured by its own terms, 20 units, and the third by the first, 4.
    assert zeros(0, True, -small, 4.9 * small, 1.1 * small) == (2, [0.0, 0.0, 1.1 * small])
    assert zeros(2, True, 0.5, 0.5, 0.5) == (2, [0.0, 0.0, 0.5])
    assert zeros(2, False, 0.5, 0.5, -small) == (2, [0.0, 0.0, -small])
    assert zeros(0, False, *[0.0] * COUNT)[0] == COUNT


def relaxing(coefficients, stretch: float, rate: float, contact: int = 1):
    """Return tables in which the first mode relaxes to the second, and the work space at a stretch."""
    tables = tables_of([RISING, coefficients], (0, contact), (MADE_MINUS, MADE_PLUS))
    tables.relaxing_state[contact], tables.relaxation[0, contact], tables.settled[0] = 1, rate, 1
    tables.taylor[0, 1, 1, 0] = 1.0
    work = work_at(tables, 0.0, stretch, 1.0)
    work.margins[contact] = abs(stretch)
    return tables, work


def test_a_relaxing_spring_brings_contact_forward() -> None:
    # 1/2 - s + z exp(-4 t) = 0 with t = s / 4, for z = -1/20.
    tables, work = relaxing((0.5, -1.0), -0.05, 16.0)
    fired, fraction, jumped, close = found(tables, work, mode=0, now=1)
    assert (fired, jumped, close) == (1, False, False)
    assert 0.5 - fraction == pytest.approx(0.05 * np.exp(-4.0 * fraction), rel=1e-13)
    assert fraction < 0.5
    # Without the margin of its contact it is the polynomial alone.
    work.margins[1] = 0.0
    assert found(tables, work, mode=0, now=1)[1] == pytest.approx(0.5, rel=1e-14)


def test_close_to_contact_the_spring_must_be_heeded() -> None:
    tables, work = relaxing((0.04, -1.0), -0.05, 16.0)
    assert found(tables, work, mode=0, now=1)[3]
    # What is known to vanish cannot be searched with a margin.
    tables, work = relaxing((0.5, -1.0), -0.05, 16.0)
    work.known_zeros[1], work.known_action[1] = 1, MADE_PLUS
    assert found(tables, work, True, mode=0, now=1)[3]
    assert not found(tables, work, False, mode=0, now=1)[3]


def test_far_from_contact_a_glance_is_enough() -> None:
    tables, work = relaxing((0.5, -0.1), -0.05, 16.0)
    work.taylor[:] = 9.0
    assert found(tables, work, mode=0, now=1)[0] == NO_EVENT
    assert (work.taylor == 9.0).all()
    # In the mode itself margins do not count.
    tables, work = relaxing((0.5, -1.0), -0.05, 16.0)
    assert found(tables, work, mode=1, now=1)[1] == pytest.approx(0.5, rel=1e-14)


def test_what_is_rounding_of_its_terms_is_no_event() -> None:
    for excess, fires in ((1e-15, False), (1e-13, True)):
        tables = tables_of([(0.0,)], (0,), (MADE_PLUS,))
        tables.taylor[0, 0, :2, 0], tables.sizes[0, 0, 0, :2] = 1.0, 1.0
        tables.screen[0, :, 3:] = tables.taylor[0, 0] @ bernstein_from_taylor()[0]
        fired, fraction, jumped, _ = found(tables, work_at(tables, -1.0, 1.0 - excess, 1.0))
        assert (fired, jumped) == (0 if fires else NO_EVENT, False)
        assert fires == (fraction == 0.0)
