"""The equations of a trimmer with an element and with frictions: which number stands where."""

from __future__ import annotations

import numpy as np
import pytest

from trimmer.displacement import Body, Displacement
from trimmer.elements.backlashes.friction_backlash import FrictionBacklash
from trimmer.elements.coulomb_friction import CoulombFriction
from trimmer.elements.viscous_friction import ViscousFriction
from trimmer.errors import WrongTypeError
from trimmer.linear.model import InputChannels
from trimmer.motion.loops import Drive
from trimmer.motion.trimmer_loop import BodyFriction, TrimmerLoop
from trimmer.parameters import TrimmerParameters

THESIS = TrimmerParameters.thesis()
DRIVE = Drive(1.5e-3, 691.0, 0.3)
BLADES = BodyFriction("q2-q4", 3.0 * CoulombFriction(0.5) + ViscousFriction(0.2))
MOUNT = BodyFriction(Displacement(Body.MOTOR), CoulombFriction(0.7))


def test_components_of_frictions_come_after_those_of_the_element() -> None:
    loop = TrimmerLoop(THESIS, 2.0 * FrictionBacklash(4e-5), DRIVE, frictions=(BLADES, MOUNT))
    system, model = loop.interconnection(), loop.model
    assert system.A.tolist() == model.A.tolist()
    assert system.B[:, 0] == pytest.approx(2.0 * model.B[:, 0], rel=1e-15)
    # Each pushes against its displacement.
    forces = np.zeros((8, 3))
    forces[5, 0], forces[7, 0] = -3.0 / THESIS.m2, 3.0 / THESIS.m4
    forces[5, 1], forces[7, 1] = -1.0 / THESIS.m2, 1.0 / THESIS.m4
    forces[4, 2] = -1.0 / THESIS.m1
    np.testing.assert_allclose(system.B[:, 1:], forces, rtol=1e-14)
    assert system.C.tolist() == [[0.0] * 8, *[[0.0, 1.0, 0.0, -1.0, *[0.0] * 4]] * 2, [1.0, *[0.0] * 7]]
    assert system.D.tolist() == np.zeros((4, 4)).tolist()
    assert system.drive_gain.tolist() == [1.0, 0.0, 0.0, 0.0]
    assert system.labels == ("backlash", "friction q2-q4", "viscous friction q2-q4", "friction q1")
    assert [component.name for component in system.components] == [
        *("backlash", "friction", "viscous friction", "friction"),
    ]
    assert system.element_factors == (2.0,)
    assert system.drive is DRIVE
    assert repr(loop) == (
        f"TrimmerLoop({loop.element!r}, {DRIVE!r}, output {loop.output.label}, {BLADES!r}, {MOUNT!r})"
    )


def test_in_feedback_the_pin_follows_the_output() -> None:
    loop = TrimmerLoop(THESIS, FrictionBacklash(4e-5), output="q3", frictions=[MOUNT])
    system = loop.interconnection()
    assert system.C[0].tolist() == [0.0, 0.0, -1.0, *[0.0] * 5]
    assert (system.drive, system.drive_gain.tolist()) == (None, [0.0, 0.0])
    assert isinstance(loop.frictions, tuple)
    assert repr(loop) == f"TrimmerLoop({loop.element!r}, output q3, {MOUNT!r})"
    assert TrimmerLoop(THESIS).interconnection().labels == ("rigid pin",)


def test_words_and_wrong_parts() -> None:
    assert TrimmerLoop(THESIS).channels is InputChannels.DISPLACEMENT_AND_VELOCITY
    assert TrimmerLoop(THESIS, channels="displacement").channels is InputChannels.DISPLACEMENT_ONLY
    assert BLADES.between == Displacement(Body.CUTTER, Body.GUARD)
    one, both = (TrimmerLoop(THESIS, channels=word).model for word in ("displacement", "both"))
    assert one.B[4:, 0] == pytest.approx([-THESIS.k2 / THESIS.m1, THESIS.k2 / THESIS.m2, 0.0, 0.0])
    assert (one.B != both.B).any()
    for options, message in (
        ({"element": 3.0}, "element"),
        ({"drive": 3.0}, "drive .*a trimmer.Drive"),
        ({"frictions": (MOUNT, 3.0)}, "frictions.*a trimmer.BodyFriction"),
        ({"parameters": 3.0}, "parameters"),
    ):
        with pytest.raises(WrongTypeError, match=message):
            TrimmerLoop(**{"parameters": THESIS, **options})
    with pytest.raises(WrongTypeError, match=r"law .*an element"):
        BodyFriction("q1", 3.0)
