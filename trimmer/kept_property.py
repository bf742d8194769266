"""``cached_property`` without the lock that Python 3.11 takes for each: two threads may both compute it."""

import functools
import sys
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING or sys.version_info >= (3, 12):  # Types know that of functools as a property.
    from functools import cached_property as cached_property
else:

    class cached_property(functools.cached_property):  # noqa: N801
        """A property that is computed once for an object, and kept in it."""

        def __get__(self, instance: object, owner: type | None = None) -> Any:
            """Return the value; of the class, the property itself."""
            if instance is None:
                return self
            value = vars(instance)[self.attrname] = self.func(instance)
            return value
