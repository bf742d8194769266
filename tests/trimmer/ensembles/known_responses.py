"""Responses of three trimmers at three frequencies, made by hand."""

from __future__ import annotations

import numpy as np

from trimmer.ensembles.responses import Responses

# G = K/(s (s + 1)) twice, with other K, and 1/(s + 1) in between: N + 1/G = 0 for K = 4 at about 1 rad/s.
THREE = Responses(
    np.array([[0.0, 4.0], [1.0, 0.0], [0.0, 9.0]]),
    np.array([[1.0, 1.0, 0.0], [1.0, 3.0, 2.0], [1.0, 1.0, 0.0]]),
    np.array([1.0, 2.0, 3.0]),
)
