"""An interrupt (Ctrl-C) is heard soon, tells what was found until then, and leaves no traceback."""

from __future__ import annotations

import _thread
import threading
import time

import numpy as np
import pytest

from tests.complaints import complaints
from trimmer import (
    ClosedLoop,
    Drive,
    FrictionBacklash,
    InertiaBacklash,
    OrbitSearch,
    OrbitSearchInterrupted,
    Outcome,
    SimulationInterrupted,
    Simulations,
    TrimmerLoop,
    TrimmerParameters,
    periodic_orbits,
    pin_model,
    simulate,
)
from trimmer.command_line.main import main
from trimmer.motion import integration
from trimmer.orbits import settling

THESIS = TrimmerParameters.thesis()
DRIVE = Drive(1.5e-3, frequency=110.0)
PLAY = FrictionBacklash(2e-4)
RELAY = ["orbits", "--element", "relay", "--force", "1"]


def interrupted(*_: object) -> None:
    raise KeyboardInterrupt


def after(count: int, function, monkeypatch: pytest.MonkeyPatch, module) -> None:
    """Let a function of a module be interrupted when it is called once more than so many times."""
    calls = iter([function] * count)
    monkeypatch.setattr(module, function.__name__, lambda *given: next(calls, interrupted)(*given))


@pytest.mark.parametrize("drive", [DRIVE, Drive(1e-5, frequency=110.0)], ids=["with events", "without"])
def test_a_motion_goes_on_after_a_pause_as_if_there_were_none(
    drive: Drive, monkeypatch: pytest.MonkeyPatch
) -> None:
    expected = simulate(TrimmerLoop(THESIS, PLAY, drive), 0.05)
    monkeypatch.setattr(integration, "AT_ONCE", 7)
    motion = simulate(TrimmerLoop(THESIS, PLAY, drive), 0.05)
    assert motion.events == expected.events
    assert motion.touches == expected.touches
    times = np.linspace(0.0, 0.05, 333)
    np.testing.assert_array_equal(motion.state(times), expected.state(times))


def test_the_step_limit_is_the_same_with_pauses(monkeypatch: pytest.MonkeyPatch) -> None:
    loop = TrimmerLoop(THESIS, PLAY, Drive(1e-5, frequency=110.0))
    expected = simulate(loop, 10.0, step_limit=100)
    monkeypatch.setattr(integration, "AT_ONCE", 7)
    motion = simulate(loop, 10.0, step_limit=100)
    assert motion.outcome is expected.outcome is Outcome.STEP_LIMIT
    assert motion.duration == expected.duration


def test_an_interrupted_motion_is_known_until_then(monkeypatch: pytest.MonkeyPatch) -> None:
    loop = TrimmerLoop(THESIS, PLAY, DRIVE)
    expected = simulate(loop, 0.05)
    monkeypatch.setattr(integration, "AT_ONCE", 7)
    after(10, integration.integrate, monkeypatch, integration)
    with pytest.raises(SimulationInterrupted, match=r"interrupted after 0\.0\d+ s of the motion") as caught:
        simulate(TrimmerLoop(THESIS, PLAY, DRIVE), 0.05)
    motion = caught.value.motion
    assert isinstance(caught.value, KeyboardInterrupt)
    assert (motion.outcome, motion.success, motion.message) == (Outcome.INTERRUPTED, False, "interrupted")
    assert 0.0 < motion.duration < 0.05
    assert motion.events == tuple(each for each in expected.events if each.time <= motion.duration)
    times = np.linspace(0.0, motion.duration, 100)
    np.testing.assert_array_equal(motion.state(times), expected.state(times))


def test_a_long_simulation_hears_an_interrupt(capsys: pytest.CaptureFixture[str]) -> None:
    chosen = ["simulate", "--drive", "110", "--amplitude", "1e-3", "--duration"]
    assert main([*chosen, "0.1"]) == 0  # compiles, which no interrupt ought to fall into
    capsys.readouterr()
    threading.Timer(0.5, _thread.interrupt_main).start()
    started = time.monotonic()
    assert main([*chosen, "1e6"]) == 130
    assert time.monotonic() - started < 30.0  # it would go on for minutes
    printed = capsys.readouterr()
    assert printed.out.startswith("Motion of ")
    assert ": interrupted\n" in printed.out
    assert printed.err.startswith("trimmer: only ")
    assert printed.err.endswith(" s of 1e+06 s: interrupted\n")


def test_a_search_for_orbits_tells_what_it_found(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    after(5, settling._follow, monkeypatch, settling)
    assert main(RELAY) == 130
    printed = capsys.readouterr()
    assert "from 5 of 32 initial states" in printed.out
    assert complaints(printed.err) == "trimmer: interrupted; what was found until then is printed\n"


def test_the_orbits_found_are_kept(monkeypatch: pytest.MonkeyPatch) -> None:
    after(3, settling._follow, monkeypatch, settling)
    loop = ClosedLoop(pin_model(THESIS), InertiaBacklash(4e-5))
    with pytest.raises(
        OrbitSearchInterrupted, match="2 periodic orbits found; the search was inter"
    ) as caught:
        periodic_orbits(loop, search=OrbitSearch(Simulations.ALWAYS))
    orbits = caught.value.orbits
    assert len(orbits) == 2
    assert not orbits.success
    assert (orbits.search.simulations.starts, orbits.search.simulations.planned) == (3, 32)


@pytest.mark.parametrize(
    ("interrupted_at", "arguments"),
    [
        ("trimmer.balance.solve.winding_number", ["limit-cycles", "--element", "friction", "--gap", "4e-5"]),
        ("trimmer.orbits.periodic_orbits.relay_orbits", RELAY),
        ("report.building.build.build", ["report"]),
    ],
)
def test_without_a_partial_result_there_is_one_sentence(
    interrupted_at: str,
    arguments: list[str],
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    tmp_path,
) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(interrupted_at, interrupted)
    assert main(arguments) == 130
    printed = capsys.readouterr()
    assert (printed.out, printed.err) == ("", "trimmer: interrupted before the result was complete\n")
