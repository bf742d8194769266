"""Types of arrays by their entries; the docstring of a field or an argument gives shape and unit.

``Flags`` are truth values, ``Places`` indices of entries of another array.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Reals = NDArray[np.float64]
Complexes = NDArray[np.complex128]
Flags = NDArray[np.bool_]
Places = NDArray[np.intp]
Integers = NDArray[np.int64]
