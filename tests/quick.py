"""Parameters of which ``make test`` takes some, and ``make test-all`` all."""

from collections.abc import Iterable
from typing import Any

import pytest


def quick(values: Iterable[Any], *places: int) -> list[Any]:
    """Mark all parameters slow but those at some places; one that is a tuple is several arguments."""
    each = [value if isinstance(value, tuple) else (value,) for value in values]
    slow = [[] if place in places else [pytest.mark.slow] for place in range(len(each))]
    return [pytest.param(*value, marks=marks) for value, marks in zip(each, slow, strict=True)]
