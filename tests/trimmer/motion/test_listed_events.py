"""Which changes of mode are listed as events, and as what."""

from __future__ import annotations

from collections.abc import Iterator
from types import SimpleNamespace

import numpy as np
import pytest

from trimmer.motion import motion as motion_module
from trimmer.motion.motion import Motion, Outcome
from trimmer.motion.relay_component import HELD, MINUS, PLUS, RelayComponent
from trimmer.motion.switched_component import EventKind
from trimmer.motion.tables import Log

FRICTION = RelayComponent(1.0, True)
Change = tuple[int, int, int, EventKind, bool]
"""Component, modes before and after, kind, and whether it is a relay."""


def listed(
    monkeypatch: pytest.MonkeyPatch, starts: list[float], changes: list[Change]
) -> list[tuple[float, EventKind, str, str]]:
    """Return the events of a motion whose segments begin with given changes."""

    def _changes(self: Motion, segment: int) -> Iterator[motion_module._Listed]:
        component, before, after, kind, relay = changes[segment - 1]
        yield motion_module._Listed(starts[segment], component, before, after, kind, relay)

    monkeypatch.setattr(Motion, "_changes", _changes)
    system = SimpleNamespace(labels=("blade", "table"), components=(FRICTION, FRICTION))
    rows = len(starts)
    log = Log(np.array(starts), *([np.zeros(rows)] * 4), np.arange(rows))
    loop = SimpleNamespace(modes=SimpleNamespace(system=system))
    motion = Motion(loop, starts[-1], Outcome.COMPLETED, log)  # type: ignore[arg-type]
    assert motion.touches == rows * (rows - 1) // 2
    assert motion.event_times.tolist() == [event.time for event in motion.events]
    return [(event.time, event.kind, event.component, event.mode) for event in motion.events]


STICK = (0, PLUS, HELD, EventKind.STICK, True)
SLIP = (0, HELD, MINUS, EventKind.SLIP, True)
BACK = (0, HELD, PLUS, EventKind.SLIP, True)
OTHER = (1, PLUS, MINUS, EventKind.SWITCH, True)


def test_what_a_relay_does_at_one_instant_is_one_event(monkeypatch: pytest.MonkeyPatch) -> None:
    for start in (0.0, 0.5):
        starts = [0.0, start, start]
        assert listed(monkeypatch, starts, [STICK, SLIP]) == [(start, EventKind.SWITCH, "blade", "minus")]
        assert listed(monkeypatch, starts, [STICK, BACK]) == []
    # Another that changes in between stays where it is.
    for start in (0.0, 0.5):
        starts = [0.0, start, start, start]
        assert listed(monkeypatch, starts, [STICK, OTHER, SLIP]) == [
            (start, EventKind.SWITCH, "blade", "minus"),
            (start, EventKind.SWITCH, "table", "minus"),
        ]
        assert listed(monkeypatch, starts, [OTHER, STICK, BACK]) == [
            (start, EventKind.SWITCH, "table", "minus")
        ]


def test_later_changes_are_events_of_their_own(monkeypatch: pytest.MonkeyPatch) -> None:
    found = listed(monkeypatch, [0.0, 0.5, 0.7], [STICK, BACK])
    assert found == [(0.5, EventKind.STICK, "blade", "held"), (0.7, EventKind.SLIP, "blade", "plus")]
    found = listed(monkeypatch, [0.0, 0.5, 0.7, 0.7], [STICK, BACK, STICK])
    assert found == [(0.5, EventKind.STICK, "blade", "held")]


def test_what_is_no_relay_is_never_merged_and_rest_is_none(monkeypatch: pytest.MonkeyPatch) -> None:
    play = (0, PLUS, HELD, EventKind.STICK, False), (0, HELD, PLUS, EventKind.SLIP, False)
    assert len(listed(monkeypatch, [0.0, 0.5, 0.5], list(play))) == 2
    rest = (0, PLUS, HELD, EventKind.REST, True)
    assert listed(monkeypatch, [0.0, 0.5], [rest]) == []


def test_the_kind_of_a_change_follows_from_the_modes() -> None:
    kinds = {(PLUS, HELD): EventKind.STICK, (HELD, MINUS): EventKind.SLIP, (PLUS, MINUS): EventKind.SWITCH}
    assert {change: motion_module._kind(*change) for change in kinds} == kinds


def test_messages_are_those_of_the_outcome() -> None:
    log = Log(*([np.zeros(1)] * 6))
    for outcome in Outcome:
        motion = Motion(SimpleNamespace(), 1.0, outcome, log)  # type: ignore[arg-type]
        assert motion.success == (outcome is Outcome.COMPLETED)
        assert motion.message == outcome.value


def test_the_parts_of_a_relay() -> None:
    relay, signals = (
        RelayComponent(2.0, False),
        SimpleNamespace(
            input=np.array([1.0, 3.0]),
            input_rate=np.array([5.0, 7.0]),
            output=np.array([0.5, 0.25]),
            one=np.array([0.0, 1.0]),
        ),
    )
    assert (relay.name, FRICTION.name) == ("relay", "friction")
    assert (relay.continuous_rates, FRICTION.continuous_rates) == (0, 1)
    assert [relay.mirrored(mode) for mode in (PLUS, MINUS, HELD)] == [MINUS, PLUS, HELD]
    assert [relay.output_law(mode).constant for mode in (PLUS, MINUS)] == [2.0, -2.0]
    assert relay.switching_function(signals).tolist() == [1.0, 3.0]
    assert FRICTION.switching_function(signals).tolist() == [5.0, 7.0]
    assert [relay.initial(9.0, value, 9.0)[0] for value in (0.0, 0.1, -0.1)] == [HELD, PLUS, MINUS]
    for mode, side, other in ((PLUS, 1.0, MINUS), (MINUS, -1.0, PLUS)):
        for attracting, kind, target in ((True, EventKind.STICK, HELD), (False, EventKind.SWITCH, other)):
            (function,) = relay.event_functions(mode, signals, attracting)
            assert function.row.tolist() == [side, 3 * side]
            assert (function.reached.kind, function.reached.target) == (kind, target)
            assert function.reached.zeros == ((0, 0) if attracting else (1,))
            assert (function.jumped.kind, function.jumped.target) == (EventKind.SWITCH, other)
            assert function.jumped.zeros == (0,)
            assert function.continuous == 1
    upper, lower = relay.event_functions(HELD, signals, True)
    assert (upper.row.tolist(), lower.row.tolist()) == ([-0.5, 1.75], [0.5, 2.25])
    assert [(each.reached.target, each.reached.zeros) for each in (upper, lower)] == [
        (PLUS, (2,)),
        (MINUS, (2,)),
    ]
    assert [(each.jumped.target, each.jumped.zeros) for each in (upper, lower)] == [
        (PLUS, (1,)),
        (MINUS, (1,)),
    ]
    assert upper.reached.kind is upper.jumped.kind is EventKind.SLIP
