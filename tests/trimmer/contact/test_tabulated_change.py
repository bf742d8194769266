"""What follows an event by the tables, in plain Python, on tables made by hand."""

from __future__ import annotations

import numpy as np
import pytest

from tests.trimmer.contact.hand_made import log_of, tables_of, work_at
from tests.trimmer.uncompiled import uncompile
from trimmer.contact import tabulated_change
from trimmer.contact.statuses import (
    ARRIVED,
    AT_LIMIT,
    BACKWARD,
    BROKEN,
    CONTACT_BROKEN,
    FORWARD,
    KINDS,
    NOTHING,
    REVERSED,
    STICK_BEGUN,
    STICK_ENDED,
)
from trimmer.contact.tabulated_change import AT_REST, NEGLIGIBLE_STRETCH

OWNERS, ACTIONS = (0, 2, 3), (BROKEN, ARRIVED, ARRIVED)
"""One contact that may break, and both frictions slide."""


@pytest.fixture(autouse=True)
def plain(monkeypatch: pytest.MonkeyPatch) -> None:
    uncompile(monkeypatch, tabulated_change)


def sliding(*actions: int):
    tables = tables_of([(0.0,), (0.0, -1.0), (0.5, -1.0)], OWNERS, actions or ACTIONS)
    return tables, work_at(tables, 0.0, 0.0, 1.0)


def is_tabulated(tables, work, fired: int, jumped: bool = False) -> bool:
    return tabulated_change.is_tabulated(tables, work, 0, fired, jumped)


def test_a_target_is_known_for_each_way_of_falling_to_zero() -> None:
    tables, work = sliding()
    assert [is_tabulated(tables, work, 0, jumped) for jumped in (False, True)] == [True, True]
    tables.target[0, 0, 1] = -1
    assert [is_tabulated(tables, work, 0, jumped) for jumped in (False, True)] == [True, False]
    tables.target[0, 0] = -2, 0
    assert [is_tabulated(tables, work, 0, jumped) for jumped in (False, True)] == [False, True]


def test_a_friction_that_has_just_begun_to_slide_has_a_say_in_whether_another_sticks() -> None:
    tables, work = sliding()
    assert is_tabulated(tables, work, 1)
    work.known_zeros[2] = 1  # Its own.
    assert is_tabulated(tables, work, 1)
    work.known_zeros[0] = 1  # A contact's.
    assert is_tabulated(tables, work, 1)
    work.known_zeros[3] = 1
    assert not is_tabulated(tables, work, 1)
    assert is_tabulated(tables, work, 0)


def test_a_limit_that_is_exceeded_at_once_is_decided_with_the_others() -> None:
    tables, work = sliding(BROKEN, AT_LIMIT, ARRIVED)
    work.known_zeros[3] = 1
    assert is_tabulated(tables, work, 1, False)
    assert not is_tabulated(tables, work, 1, True)


@pytest.mark.parametrize("share", [0.9, 1.1])
def test_another_velocity_that_is_zero_to_rounding_has_a_say(share: float) -> None:
    tables, work = sliding()
    work.state[:2] = -3.0, 2.0
    # 1 (-3) + 2 (2) - 1 + excess; its terms are 3 + 4 + 1 now, and change by 5 * 3 over a step.
    tables.taylor[0, 2, :, 0] = 1.0, 2.0, -1.0 - share * AT_REST * 23.0
    tables.sizes[0, 2, 0], tables.sizes[0, 2, 1] = (1.0, 2.0, 1.0), (5.0, 0.0, 0.0)
    assert is_tabulated(tables, work, 1) == (share > 1)
    tables.function_count[0] = 2
    assert is_tabulated(tables, work, 1)


@pytest.mark.parametrize("share", [0.9, -0.9, 1.1, -1.1])
def test_a_small_velocity_is_zero_by_its_small_terms(share: float) -> None:
    tables, work = sliding()
    tables.taylor[0, 2], tables.sizes[0, 2] = 0.0, 0.0
    tables.taylor[0, 2, 2, 0], tables.sizes[0, 2, 1, 2] = share * AT_REST * 1e-9, 1e-9
    assert is_tabulated(tables, work, 1) == (abs(share) > 1)


def counted(tables, log, fired: int, jumped: bool, counts) -> int:
    return tabulated_change._counted_kind(tables, log, 3, 0, fired, jumped, counts)


def stuck_at_once(before: int, after: int):
    """Return tables and a log in which friction 2 slid before row 1, stuck in row 1, and lets go in row 3."""
    tables, _ = sliding(BROKEN, AT_LIMIT, ARRIVED)
    tables.kind[0, 1] = STICK_ENDED, STICK_ENDED
    tables.kind[0, 0] = CONTACT_BROKEN, STICK_ENDED
    tables.statuses[0, 2], tables.statuses[1, 2] = before, after
    tables.target[0, :, 0] = 0
    log = log_of(4)
    log.start[:] = 0.5, 2.0, 2.0, 2.0
    log.kind[1], log.part[1] = STICK_BEGUN, 2
    log.mode[0], log.mode[1] = 0, 1
    return tables, log


@pytest.mark.parametrize(
    ("before", "after", "kind"), [(FORWARD, FORWARD, NOTHING), (FORWARD, BACKWARD, REVERSED)]
)
def test_what_does_not_stick_after_all_goes_on_or_turns_back(before: int, after: int, kind: int) -> None:
    tables, log = stuck_at_once(before, after)
    counts = np.full(KINDS, 5)
    assert counted(tables, log, 1, True, counts) == kind
    assert counts.tolist() == [5, 5, 5, 5, 4, 5]
    assert log.kind.tolist() == [NOTHING] * 4


def test_stick_that_lasts_ends_as_stick() -> None:
    def kind(jumped: bool = True, fired: int = 1, **columns: tuple[int, float]) -> int:
        tables, log = stuck_at_once(FORWARD, BACKWARD)
        for name, (row, value) in columns.items():
            getattr(log, name)[row] = value
        counts = np.zeros(KINDS, dtype=np.int64)
        found = counted(tables, log, fired, jumped, counts)
        assert counts.any() == (found in (REVERSED, NOTHING))
        return found

    assert kind() == REVERSED
    assert kind(jumped=False) == STICK_ENDED
    assert kind(part=(1, 3)) == STICK_ENDED
    assert kind(start=(1, 1.0)) == STICK_ENDED
    assert kind(start=(3, 3.0)) == STICK_ENDED
    assert kind(kind=(2, STICK_BEGUN)) == STICK_ENDED
    assert kind(fired=0, jumped=False) == CONTACT_BROKEN
    assert kind(fired=0) == STICK_ENDED


def test_the_first_row_is_looked_at_and_no_row_before_it() -> None:
    tables, log = stuck_at_once(FORWARD, BACKWARD)
    log.kind[1] = NOTHING
    log.start[:] = 2.0
    log.kind[3], log.part[3] = STICK_BEGUN, 2
    counts = np.zeros(KINDS, dtype=np.int64)
    assert counted(tables, log, 1, True, counts) == STICK_ENDED
    assert not counts.any()


@pytest.mark.parametrize("jumped", [False, True])
def test_a_change_is_made_and_logged(jumped: bool) -> None:
    tables, work = sliding()
    flavour = int(jumped)
    tables.kind[0, 2, flavour], tables.known_action[0, 2, flavour] = STICK_BEGUN, AT_LIMIT
    tables.known_zeros[0, 2, flavour] = 2
    tables.kind[0, 2, 1 - flavour], tables.target[0, 2, 1 - flavour] = REVERSED, 0
    tables.hold[1] = [[1.0, 0.0, 0.0], [0.5, 0.0, 0.0], [0.0, 0.25, 1.0]]
    work.state[:] = 3.0, 4.0, 1.0
    log, counts = log_of(3), np.zeros(KINDS, dtype=np.int64)
    log.start[:2] = 0.1, 0.2
    assert tabulated_change.change(tables, work, log, 1, 0, (2, jumped), counts) == 1
    held = [3.0 + 0.5 * 4.0, 0.25, 1.0]
    assert work.state.tolist() == held
    assert log.state.tolist() == [[0.0] * 3, held, [0.0] * 3]
    assert (log.mode[1], log.part[1], log.kind[1], log.function[1]) == (1, 3, STICK_BEGUN, 2)
    assert log.part.tolist() == [-1, 3, -1]
    assert counts.tolist() == [0, 0, 0, 0, 1, 0]
    assert work.known_zeros.tolist() == [0, 0, 0, 2]
    assert work.known_action.tolist() == [-1, -1, -1, AT_LIMIT]


@pytest.mark.parametrize(("kind", "rate"), [(CONTACT_BROKEN, 0.5), (CONTACT_BROKEN, 0.0), (NOTHING, 9.0)])
def test_a_spring_that_begins_to_relax_is_negligible_below_a_share(kind: int, rate: float) -> None:
    tables, work = sliding()
    tables.kind[0, 0], tables.relaxing_state[0], tables.relaxation[1, 0] = kind, 1, rate
    work.state[:] = 0.0, -3e-5, 1.0
    tabulated_change.change(tables, work, log_of(3), 1, 0, (0, False), np.zeros(KINDS, dtype=np.int64))
    expected = NEGLIGIBLE_STRETCH * (4e-5 + 3e-5) if kind == CONTACT_BROKEN and rate else 0.0
    np.testing.assert_allclose(work.negligible, [expected, 0.0], rtol=1e-14)
