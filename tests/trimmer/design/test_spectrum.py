"""What each line of a spectrum is, of outputs whose lines are made by hand."""

import numpy as np
import pytest

from tests.trimmer.design.made import motion, output
from trimmer.design import LinearMode, LinearState, LineKind, OutputSpectrum
from trimmer.design.analysis.spectrum import spectra
from trimmer.mechanism import Contacts


def state(contacts: Contacts, *modes: tuple[float, float]) -> LinearState:
    made = tuple(LinearMode(frequency, ratio, np.ones(1, complex)) for frequency, ratio in modes)
    return LinearState(contacts, ("block",), made, 0, 0, ())


def of(amplitudes: list[complex], *states: LinearState, period_count: int = 1) -> OutputSpectrum:
    moving = motion(outputs={"x": output(0.0, 1e-3, amplitudes, period_count)}, period_count=period_count)
    (found,) = spectra(moving, 110.0, states).values()
    return found


def test_lines_rise_in_frequency_and_have_their_kinds() -> None:
    found = of([2e-4, 3e-3j, 0.0, -5e-4], period_count=2)
    assert found.output == "x"
    assert [(line.kind, line.numerator, line.denominator) for line in found.lines] == [
        (LineKind.FRACTION, 1, 2),
        (LineKind.DRIVE, 1, 1),
        (LineKind.HARMONIC, 2, 1),
    ]
    assert [line.frequency for line in found.lines] == [55.0, 110.0, 220.0]
    assert [line.amplitude for line in found.lines] == pytest.approx([2e-4, 3e-3, 5e-4])
    assert (found.left_out, found.share) == (0, pytest.approx(1.0))
    assert found.floor == pytest.approx(3e-7)


def test_small_lines_are_counted_and_their_share_is_left() -> None:
    # Twice the square of the largest and of what is below the floor of a ten-thousandth.
    found = of([1.0, 1e-4, 0.99e-4, 0.0, 0.5e-4])
    assert [line.numerator for line in found.lines] == [1, 2]
    assert found.left_out == 2
    assert found.floor == 1e-4
    assert 1 - found.share == pytest.approx(0.99e-4**2 + 0.5e-4**2, rel=1e-6)


def test_the_largest_24_are_listed() -> None:
    found = of([1.0 + place for place in range(30)])
    assert [line.numerator for line in found.lines] == list(range(7, 31))
    assert found.left_out == 6
    held = sum((1.0 + place) ** 2 for place in range(6, 30))
    assert found.share == pytest.approx(held / (held + 91), rel=1e-12)


def test_an_output_at_rest_has_no_lines() -> None:
    found = of([0.0, 0.0])
    assert (found.lines, found.left_out, found.floor, found.share) == ((), 0, 0.0, 1.0)


def test_the_nearest_mode_is_named_with_its_state() -> None:
    opened = state(Contacts.OPEN, (0.0, 0.0), (111.0, 0.01), (224.0, 0.0))
    closed = state(Contacts.CLOSED, (108.0, 0.0), (400.0, 0.25))
    first, second, third = of([1.0, 1.0, 1.0], closed, opened).lines
    assert (first.mode, first.contacts) == (opened.modes[1], Contacts.OPEN)
    assert (second.mode, second.contacts) == (opened.modes[2], Contacts.OPEN)
    # A strongly damped mode is as wide as its damping ratio: 330 Hz is 17.5 % from 400 Hz.
    assert (third.mode, third.contacts) == (closed.modes[1], Contacts.CLOSED)
    far = of([1.0], state(Contacts.OPEN, (114.0, 0.0))).lines[0]
    assert (far.mode, far.contacts) == (None, None)


def test_a_motion_by_itself_has_the_lines_of_its_own_period() -> None:
    moving = motion(outputs={"x": output(0.0, 1.0, [1.0, 0.5])}, period=0.25, driven=False)
    lines = spectra(moving, None, ())["x"].lines
    assert [(line.kind, line.numerator, line.frequency) for line in lines] == [
        (LineKind.OWN, 1, 4.0),
        (LineKind.OWN, 2, 8.0),
    ]
    assert spectra(motion(period=None), None, ()) == {}
    assert spectra(motion(period=None), 110.0, ())["stroke"].lines == ()


def test_of_several_modes_the_nearest_is_named() -> None:
    far, near = (115.0, 0.3), (108.0, 0.3)
    for closed, opened, contacts in (
        ([far, near], [], Contacts.CLOSED),
        ([near], [far], Contacts.CLOSED),
        ([far], [near], Contacts.OPEN),
    ):
        (line,) = of([1.0], state(Contacts.CLOSED, *closed), state(Contacts.OPEN, *opened)).lines
        assert line.mode is not None
        assert (line.mode.frequency, line.contacts) == (108.0, contacts)
    (line,) = of([1.0], state(Contacts.OPEN, (0.0, 0.3), (100.0, 0.36), (99.0, 0.09))).lines
    assert (line.mode, line.contacts) == (None, None)
