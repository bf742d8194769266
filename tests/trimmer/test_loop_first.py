"""What works on a loop takes it as its first argument, or a system and an element in its place."""

import warnings

import control
import pytest

from trimmer import (
    CoulombFriction,
    FrictionBacklash,
    Relay,
    TrimmerParameters,
    harmonic_balance,
    harmonic_leakage,
    limit_cycles,
    multi_harmonic_balance,
    periodic_orbits,
)
from trimmer.errors import UndecidedWarning, UnsupportedElementError, WrongTypeError
from trimmer.linear import UnsupportedSystemError, pin_model
from trimmer.loops import BodyFriction, ClosedLoop, Drive, OpenLoop, TrimmerLoop
from trimmer.orbits import OrbitSearch, Simulations

THESIS = TrimmerParameters.thesis()
SYSTEM, PLAY = pin_model(THESIS), FrictionBacklash(4e-5)
LOOP, TRIMMER = ClosedLoop(SYSTEM, PLAY), TrimmerLoop(THESIS, PLAY)
CYCLE = limit_cycles(LOOP)[-1]
OF_LOOPS = (limit_cycles, harmonic_balance, harmonic_leakage, multi_harmonic_balance, periodic_orbits)
SEARCH = OrbitSearch(Simulations.NEVER)


@pytest.mark.parametrize("loop", [LOOP, TRIMMER], ids=["closed loop", "trimmer"])
def test_a_loop_stands_for_system_and_element(loop: ClosedLoop | TrimmerLoop) -> None:
    assert limit_cycles(loop) == limit_cycles(SYSTEM, PLAY)
    assert limit_cycles(loop, (4e3, 6e3)) == limit_cycles(SYSTEM, PLAY, (4e3, 6e3)) != limit_cycles(loop)
    assert limit_cycles(loop, frozen_omega=1e3) == limit_cycles(SYSTEM, PLAY, frozen_omega=1e3)
    assert harmonic_balance(loop) == harmonic_balance(SYSTEM, PLAY)
    assert harmonic_leakage(loop, CYCLE, (3, 5)) == harmonic_leakage(SYSTEM, PLAY, CYCLE, (3, 5))
    found, expected = (multi_harmonic_balance(*each, CYCLE, (1, 3)) for each in ((loop,), (SYSTEM, PLAY)))
    assert [each.amplitude for each in found] == [each.amplitude for each in expected]
    (orbit,), (other,) = (periodic_orbits(*each, [CYCLE], SEARCH) for each in ((loop,), (SYSTEM, PLAY)))
    assert (orbit.amplitude, orbit.period) == (other.amplitude, other.period)


OTHER_LOOPS = {
    "forced_orbit finds": OpenLoop(SYSTEM, PLAY, Drive(1e-3, 700.0)),
    "it has a drive": TrimmerLoop(THESIS, PLAY, Drive(1e-3, 700.0)),
    "it has frictions": TrimmerLoop(THESIS, PLAY, frictions=(BodyFriction("q2", CoulombFriction(1.0)),)),
    "it has no element": TrimmerLoop(THESIS),
}


@pytest.mark.parametrize("function", OF_LOOPS)
@pytest.mark.parametrize("reason", OTHER_LOOPS)
def test_other_loops_are_refused_with_a_reason(function, reason: str) -> None:
    with pytest.raises(WrongTypeError, match=f"loop must be a closed one .*{reason}"):
        function(OTHER_LOOPS[reason], CYCLE)


@pytest.mark.parametrize("function", OF_LOOPS)
def test_mixtures_are_refused(function) -> None:
    for given, named in (((LOOP, PLAY), {}), ((LOOP,), {"element": PLAY}), ((LOOP,), {"system": SYSTEM})):
        with pytest.raises(WrongTypeError, match="a loop holds its system and its element already"):
            function(*given, **named)
    for given, named in (((SYSTEM,), {}), ((PLAY,), {}), ((), {"system": SYSTEM})):
        with pytest.raises(WrongTypeError, match=r"needs a loop, as .* is given without an element"):
            function(*given, **named)
    with pytest.raises(WrongTypeError, match=f"{function.__name__} needs a loop, .*: neither is given"):
        function()
    with pytest.raises(UnsupportedElementError, match=r"give a trimmer\.elements\.Element"):
        function(PLAY, SYSTEM)
    with pytest.raises(UnsupportedSystemError, match="2 inputs"):
        function(control.ss(-1, [[1, 2]], 1, 0), PLAY)
    with pytest.raises(UnsupportedSystemError, match="2 inputs"):
        function(ClosedLoop(control.ss(-1, [[1, 2]], 1, 0), PLAY), CYCLE)


def test_warnings_name_the_line_of_the_caller() -> None:
    system = 1 / control.tf("s") ** 2
    for given in ((system, Relay(1.0)), (ClosedLoop(system, Relay(1.0)),)):
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            limit_cycles(*given)
        assert {(each.category, each.filename) for each in caught} == {(UndecidedWarning, __file__)}
