"""What ``make test`` asks of some instances, and ``make test-all`` of all."""

import os
from collections.abc import Iterable
from typing import Any

import pytest


def quick(values: Iterable[Any], *places: int) -> list[Any]:
    """Mark all parameters slow but those at some places; one that is a tuple is several arguments."""
    each = [value if isinstance(value, tuple) else (value,) for value in values]
    slow = [[] if place in places else [pytest.mark.slow] for place in range(len(each))]
    return [pytest.param(*value, marks=marks) for value, marks in zip(each, slow, strict=True)]


def examples(few: int, many: int) -> int:
    """Return how many examples Hypothesis makes; ``make test-all`` sets ALL_TESTS, and asks of many."""
    return many if os.environ.get("ALL_TESTS") else few
