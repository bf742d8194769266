"""How many events at one instant are followed before a motion counts as chattering."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

from trimmer.contact.advance import _Progress
from trimmer.contact.integration import LONGEST_CASCADE


def test_events_at_one_instant_count_from_the_second_on() -> None:
    progress: Any = SimpleNamespace(cascade=0, cascade_at=(-1, -1.0))
    for done, time in ((0, 0.5), (0, 0.25), (1, 0.25)):
        place: Any = SimpleNamespace(done=done, time=time)
        asked = [_Progress._is_finite(progress, place) for _ in range(LONGEST_CASCADE + 3)]
        assert asked == [True] * (LONGEST_CASCADE + 1) + [False] * 2
