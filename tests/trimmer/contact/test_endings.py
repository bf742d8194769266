"""A motion that cannot be continued says so: where frictions at rest tie, events come without end."""

import numpy as np
import pytest

from trimmer import Mechanism, MotionKind, respond, simulate

TIED = """
frequency = 0.5
[bodies]
b0 = { mass = 1.0 }
b1 = { mass = 2.0 }
b2 = { mass = 1.0 }
b3 = { mass = 1.0 }
[links]
l0 = { between = ["ground", "b0"], stiffness = 2.0 }
l1 = { between = ["b0", "b1"], stiffness = 1.0 }
l2 = { between = ["b1", "b2"], stiffness = 2.0 }
l3 = { between = ["b2", "b3"], stiffness = 1.0 }
[frictions]
f0 = { between = ["b1", "b0"], force = 0.2, static = 0.6 }
f1 = { between = ["ground", "b1"], force = 0.5, static = 1.0 }
f2 = { between = ["b3", "b2"], force = 0.2, static = 0.2 }
f3 = { between = ["b2", "b1"], force = 0.5, static = 1.0 }
f4 = { between = ["b3", "b0"], force = 0.2, static = 0.4 }
[forces]
p = { on = "b0", constant = 0.1, amplitude = 2.0 }
"""


def test_frictions_that_tie_end_the_motion_where_they_do() -> None:
    """f0 and f2 break away at 0.85 N; then f4 slides, and f2 has to hold just its limit of 0.2 N."""
    made = Mechanism.from_toml_text(TIED).with_value("frictions.f0.static", 0.65)
    motion = simulate(made, 1.0)
    assert not motion.success
    assert motion.duration == pytest.approx(np.arcsin(0.375) / np.pi, rel=1e-9)
    assert "more events at one instant than can be told apart" in motion.message
    settled = respond(made).motion
    assert settled.kind is MotionKind.UNDECIDED
    assert "more events at one instant than can be told apart" in settled.message
    freed = Mechanism.from_toml_text(TIED).with_value("frictions.f4.static", 0.45)
    assert simulate(freed, 1.0).success
