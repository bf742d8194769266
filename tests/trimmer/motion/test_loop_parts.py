"""Loops as equations and as signals: what goes where, and what a loop keeps."""

from __future__ import annotations

import math
import pickle

import control
import numpy as np
import pytest

from trimmer import (
    Body,
    ClosedLoop,
    CoulombFriction,
    Displacement,
    Drive,
    FrictionBacklash,
    OpenLoop,
    TrimmerLoop,
    TrimmerParameters,
    UnsupportedMotionError,
    ViscousFriction,
    WrongTypeError,
)
from trimmer.motion.components_of_elements import RigidComponent
from trimmer.motion.loop_signal import LoopSignal, row_in_modes
from trimmer.motion.loops import Loop, element_around

SYSTEM = control.ss([[0.0, 1.0], [-4.0, -0.5]], [[3.0], [7.0]], [[0.6, 0.0]], 0)
ELEMENT = 2.0 * FrictionBacklash(0.1) + 3.0 * ViscousFriction(0.4)
DRIVE = Drive(0.3, 5.0)


def test_an_element_of_two_parts_in_feedback() -> None:
    system = element_around(SYSTEM, ELEMENT, None)
    assert system.A.tolist() == SYSTEM.A.tolist()
    assert system.B.tolist() == [[6.0, pytest.approx(9.0)], [14.0, pytest.approx(21.0)]]
    assert system.C.tolist() == [[-0.6, 0.0]] * 2
    assert system.D.tolist() == [[0.0, 0.0]] * 2
    assert system.drive_gain.tolist() == [0.0, 0.0]
    assert system.drive is None
    assert system.element_factors == (2.0, pytest.approx(3.0))
    assert system.labels == tuple(component.name for component in system.components)
    assert system.order == 2


def test_a_driven_element_and_none() -> None:
    system = element_around(SYSTEM, ELEMENT, DRIVE)
    assert not system.C.any()
    assert not system.D.any()
    assert system.drive_gain.tolist() == [1.0, 1.0]
    assert system.drive is DRIVE
    direct = control.ss(SYSTEM.A, SYSTEM.B, SYSTEM.C, 0.7)
    assert element_around(direct, ELEMENT, DRIVE).D.tolist() == [[0.0, 0.0]] * 2
    rigid = element_around(SYSTEM, None, None)
    assert rigid.components == (RigidComponent(),)
    assert rigid.B.tolist() == SYSTEM.B.tolist()
    assert rigid.element_factors == (1.0,)


def test_a_drive_has_no_phase_unless_it_is_given_one() -> None:
    assert DRIVE.phase == 0.0
    assert Drive(0.3, frequency=2.0).phase == 0.0
    assert Drive(0.3, 5.0, 0.25).phase == 0.25
    assert (DRIVE.period, DRIVE.frequency) == (2 * math.pi / 5, 5 / (2 * math.pi))
    assert Drive(0.0, 5.0).amplitude == 0.0


@pytest.mark.parametrize("loop", [ClosedLoop(SYSTEM, ELEMENT), OpenLoop(SYSTEM, ELEMENT, DRIVE)])
def test_what_is_computed_is_not_pickled(loop: Loop) -> None:
    assert loop.modes.system.order == loop.model.nstates == 2
    assert {"model", "modes"} <= vars(loop).keys()
    names = ["system", "element", "drive"][: len(loop._parts())]
    assert sorted(loop.__getstate__()) == sorted(names)
    again = pickle.loads(pickle.dumps(loop))
    assert "modes" not in vars(again)
    assert again.model.A.tolist() == SYSTEM.A.tolist()
    assert repr(again) == repr(loop)
    assert repr(loop).startswith(f"{type(loop).__name__}(<StateSpace of order 2>, ")


def test_which_states_have_a_meaning() -> None:
    function = control.tf([1.0], [1.0, 2.0, 3.0])
    for system, meant in ((SYSTEM, True), (function, False)):
        assert ClosedLoop(system, ELEMENT).has_states == meant
        assert OpenLoop(system, ELEMENT, DRIVE).has_states == meant
    assert TrimmerLoop(TrimmerParameters.thesis()).has_states


def rows(loop: Loop, signal: LoopSignal | Displacement) -> np.ndarray:
    return row_in_modes(loop, signal)(loop.modes.mode(0))


def test_signals_as_rows() -> None:
    direct = control.ss(SYSTEM.A, SYSTEM.B, SYSTEM.C, 0.7)
    element = 2.0 * FrictionBacklash(0.1) + 3.0 * CoulombFriction(0.4)
    loop = OpenLoop(direct, element, Drive(0.3, 5.0))
    # The state is that of the system, the load, sine and cosine, and one; friction slides forward.
    output = [0.0, 0.0, 2.0, 0.0, 0.0, pytest.approx(1.2)]
    assert rows(loop, LoopSignal.ELEMENT_OUTPUT).tolist() == output
    assert rows(loop, LoopSignal.ELEMENT_INPUT).tolist() == [0.0, 0.0, 0.0, 0.3, 0.0, 0.0]
    assert rows(loop, LoopSignal.OUTPUT) == pytest.approx([0.6, 0.0, 1.4, 0.0, 0.0, 0.84])
    closed = ClosedLoop(SYSTEM, FrictionBacklash(0.1))
    assert rows(closed, LoopSignal.ELEMENT_INPUT).tolist() == [-0.6, 0.0, 0.0, 0.0, 0.0, 0.0]
    assert rows(closed, LoopSignal.OUTPUT).tolist() == [0.6, 0.0, 0.0, 0.0, 0.0, 0.0]


def test_displacements_as_rows() -> None:
    loop = TrimmerLoop(TrimmerParameters.thesis(), FrictionBacklash(4e-5))
    assert rows(loop, Displacement(Body.GUARD, Body.CUTTER)).tolist() == [0.0, -1.0, 0.0, 1.0] + [0.0] * 8
    assert rows(loop, Displacement(Body.HOUSING)).tolist() == [0.0, 0.0, 1.0] + [0.0] * 9
    named = ClosedLoop(loop.model, FrictionBacklash(4e-5))
    assert rows(named, Displacement(Body.MOTOR)).tolist() == [1.0] + [0.0] * 11
    for system in (SYSTEM, control.tf([1.0], [1.0, 2.0, 3.0])):
        with pytest.raises(UnsupportedMotionError, match="no state q1"):
            rows(ClosedLoop(system, FrictionBacklash(4e-5)), Displacement(Body.MOTOR))
    # States of a realization mean nothing, whatever they are called.
    realization = ClosedLoop(control.ss2tf(loop.model), FrictionBacklash(4e-5))
    vars(realization)["model"] = loop.model
    with pytest.raises(UnsupportedMotionError, match="no state q1"):
        rows(realization, Displacement(Body.MOTOR))
    with pytest.raises(WrongTypeError, match="a LoopSignal or a Displacement"):
        row_in_modes(loop, "q1")  # type: ignore[arg-type]
