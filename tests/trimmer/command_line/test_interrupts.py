"""An interrupt (Ctrl-C) is heard soon at any moment, tells what was found, and leaves no traceback."""

import signal
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from importlib import import_module
from pathlib import Path
from types import FrameType
from typing import Any

import numpy as np
import pytest

import trimmer
from tests.complaints import complaints
from trimmer.command_line.main import main

PACKAGE = str(Path(trimmer.__file__).parent)
EXAMPLES = Path(__file__).parents[3] / "examples"
LOOP = ["--element", "relay", "--force", "1", "--channels", "displacement"]
THESIS = trimmer.TrimmerParameters.thesis()
NO_RESULT = "trimmer: interrupted before the result was complete\n"


class Interrupter:
    """Interrupts what is done inside once so many functions of the package have been called.

    Attributes:
        calls: Those that are left.
        inside: Which functions count, by a part of the name of their file.
    """

    def __init__(self, calls: int, inside: str = "") -> None:
        self.calls, self.inside = calls, f"{PACKAGE}/{inside}"

    def __call__(self, frame: FrameType, event: str, _: Any) -> None:
        if event == "call" and frame.f_code.co_filename.startswith(self.inside):
            self.calls -= 1
            if self.calls == 0:
                raise KeyboardInterrupt

    @contextmanager
    def at_work(self) -> Iterator[None]:
        before = sys.getprofile()
        sys.setprofile(self)
        try:
            yield
        finally:
            sys.setprofile(before)


def calls_of(words: list[str], inside: str) -> int:
    counter = Interrupter(0, inside)
    with counter.at_work():
        assert main(words) == 0
    return -counter.calls


@pytest.mark.parametrize(
    ("words", "inside"),
    [
        (["limit-cycles", *LOOP], "balance"),
        (["linear"], "linear"),
        (["respond", str(EXAMPLES / "oscillator-stop.toml")], "response"),
    ],
    ids=lambda each: each[0] if isinstance(each, list) else None,
)
def test_at_any_moment_there_is_one_sentence(words: list[str], inside: str, capsys) -> None:
    assert main(words) == 0  # imports and compiles
    count = calls_of(words, inside)
    assert count > 20
    for share in (0.0, 0.3, 0.6, 0.9):
        capsys.readouterr()
        with Interrupter(1 + int(share * count), inside).at_work():
            code = main(words)
        told = capsys.readouterr()
        assert (code, told.out, complaints(told.err)) == (130, "", NO_RESULT)


def test_a_search_for_orbits_tells_what_it_found(capsys) -> None:
    with Interrupter(100, "orbits/settling").at_work():
        assert main(["orbits", *LOOP, "--simulate"]) == 130
    told = capsys.readouterr()
    assert "of 32 initial states" in told.out
    assert complaints(told.err) == "trimmer: interrupted; what was found until then is printed\n"


def test_the_orbits_found_are_kept() -> None:
    loop = trimmer.ClosedLoop(trimmer.pin_model(THESIS), trimmer.InertiaBacklash(4e-5))
    search = trimmer.OrbitSearch(trimmer.orbits.Simulations.ALWAYS)
    whole = trimmer.periodic_orbits(loop, search=search)
    with (
        Interrupter(200, "orbits/settling").at_work(),
        pytest.raises(
            trimmer.orbits.OrbitSearchInterrupted, match="periodic orbits found; the search was"
        ) as caught,
    ):
        trimmer.periodic_orbits(loop, search=search)
    orbits = caught.value.orbits
    assert {each.amplitude for each in orbits} <= {each.amplitude for each in whole}
    assert len(orbits) == 2 and not orbits.success
    assert orbits.search.simulations.starts < orbits.search.simulations.planned == 32


@contextmanager
def interrupted_after(seconds: float) -> Iterator[None]:
    """Send the process an interrupt after some time, as a user at a terminal does."""
    before = signal.signal(signal.SIGALRM, signal.default_int_handler)
    signal.setitimer(signal.ITIMER_REAL, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0.0)
        signal.signal(signal.SIGALRM, before)


def test_a_long_simulation_hears_it(capsys) -> None:
    chosen = ["simulate", "--drive", "110", "--amplitude", "1e-3", "--duration"]
    assert main([*chosen, "0.1"]) == 0  # compiles, which no interrupt ought to fall into
    capsys.readouterr()
    started = time.monotonic()
    with interrupted_after(0.5):
        assert main([*chosen, "1e6"]) == 130
    assert time.monotonic() - started < 30.0  # it would go on for minutes
    printed = capsys.readouterr()
    assert printed.out.startswith("Motion of ") and ": interrupted\n" in printed.out
    assert printed.err.startswith("trimmer: only ")
    assert printed.err.endswith(" s of 1e+06 s: interrupted\n")


@pytest.mark.slow
def test_a_motion_is_known_until_then() -> None:
    loop = trimmer.TrimmerLoop(THESIS, trimmer.FrictionBacklash(2e-4), trimmer.Drive(1.5e-3, frequency=110.0))
    expected = trimmer.simulate(loop, 0.05)
    with (
        interrupted_after(0.3),
        pytest.raises(
            trimmer.loops.SimulationInterrupted, match=r"interrupted after \d\S* s of the motion"
        ) as caught,
    ):
        trimmer.simulate(loop, 1e5)
    motion = caught.value.motion
    assert isinstance(caught.value, KeyboardInterrupt)
    assert (motion.outcome, motion.success, motion.message) == (
        trimmer.loops.Outcome.INTERRUPTED,
        False,
        "interrupted",
    )
    until = min(motion.duration, expected.duration)
    assert until > 0.0
    known = tuple(each for each in motion.events if each.time <= until)
    assert known == tuple(each for each in expected.events if each.time <= until)
    times = np.linspace(0.0, until, 100)
    np.testing.assert_array_equal(motion.state(times), expected.state(times))


MAP = ["map", str(EXAMPLES / "thesis-play.toml"), "--vary", "plays.bridge.gap=40um:60um:2"]
MAP += ["--set", "frictions.blade.force=1", "--jobs", "1"]


STOP = ["map", str(EXAMPLES / "oscillator-stop.toml"), "--vary", "frequency=0.86:0.8825:2", "--special", "1"]
STOP += ["--vary", "stops.stop.gap=9.97:10.03:2", "--jobs", "1"]


@pytest.mark.parametrize(
    ("words", "inside", "kept", "advice"),
    [
        (MAP, "maps/measures", "of 2 cells", ("--resume", "--output")),
        (
            STOP,
            "maps/special_work",
            "",
            ("; the same call with --resume goes on", "name a file (--output) to"),
        ),
    ],
    ids=["cells", "special points"],
)
def test_an_interrupted_map_says_how_to_go_on(
    tmp_path: Path, capsys, words: list[str], inside: str, kept: str, advice: tuple[str, str]
) -> None:
    file = tmp_path / "a.map"
    import_module("trimmer.maps.special_work")  # or else the interrupt would fall into the import
    for more, told in (["--output", str(file)], advice[0]), ([], advice[1]):
        with Interrupter(2 if kept else 1, inside).at_work():
            assert main([*words, *more]) == 130
        out, error = capsys.readouterr()
        assert error.startswith("trimmer: interrupted") and kept in error and told in error
        assert out == "" or not kept
    assert kept or file.exists()
