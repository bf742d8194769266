"""What commands tell of loops and of the linear trimmer, of results that are made by hand."""

from __future__ import annotations

from types import SimpleNamespace as Made

import numpy as np
import pytest

from tests.trimmer.command_line.told import cells
from trimmer.command_line.loops import certificate_text, limit_cycles_text, linear_text, orbits_text
from trimmer.command_line.loops import motion_text as of_loop
from trimmer.motion.switched_component import EventKind


def moved(times: list[float], modes: list[str], drive: object = None) -> Made:
    events = [
        Made(time=time, kind=EventKind.IMPACT, mode=mode, component="play")
        for time, mode in zip(times, modes, strict=True)
    ]
    loop = Made(modes=Made(system=Made(drive=drive)))
    return Made(duration=1.0, events=events, loop=loop)


def test_what_repeats_at_the_end_is_told() -> None:
    upper = "upper contact"
    assert of_loop._frequency(moved([0.5, 0.92, 0.94, 0.98], [upper] * 4)) == pytest.approx(2 / 0.06)
    assert of_loop._frequency(moved([0.9, 0.95], [upper, upper])) == pytest.approx(20.0)
    assert of_loop._frequency(moved([0.92, 0.93, 0.96], [upper, "lower contact", upper])) == pytest.approx(
        25.0
    )
    assert of_loop._frequency(moved([0.5, 0.95], [upper, upper])) is None
    assert of_loop._frequency(moved([0.95, 0.95], [upper, upper])) is None
    assert of_loop._frequency(moved([0.92, 0.96], [upper, upper], drive=1)) is None
    other = moved([0.92, 0.96], [upper, upper])
    other.events[1].kind = EventKind.STICK
    assert of_loop._frequency(other) is None


def test_a_certificate_tells_what_is_undecided() -> None:
    region = Made(omegas=(1.0, 2.0), amplitudes=(3.0, np.inf))
    certificate = Made(
        omegas=(10.0, 1e3),
        complete=False,
        outside_excluded=True,
        undecided=[region],
        other_doubts=("doubt",),
    )
    first, second, third = certificate_text.certificate_as_text(certificate)
    assert first.startswith("searched from 10 to 1000 rad/s: there may be others; ")
    assert second == "undecided: 1 to 2 rad/s, amplitude 3 to inf"
    assert third == "doubt"
    assert certificate_text._region(region) == {"amplitudes": [3.0, None], "omegas": [1.0, 2.0]}
    certificate.complete, certificate.outside_excluded = True, False
    assert certificate_text.certificate_as_text(certificate)[0].endswith("none is missing there")


def cycle(**changes: object) -> Made:
    usual = {
        "amplitude": 2e-5,
        "omega": 691.0,
        "frequency": 109.975,
        "stable": True,
        "crossing_angle": np.pi / 6,
    }
    return Made(**usual | {"near_tangency": False} | changes)


def test_limit_cycles_that_nearly_vanish_are_told(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(limit_cycles_text, "harmonic_leakage", lambda loop, cycle: (0.125,) * 9)
    monkeypatch.setattr(limit_cycles_text, "certificate_as_text", lambda _: ["certified"])
    balance = Made(limit_cycles=[cycle(), cycle(stable=False)], certificate=None)
    lines = limit_cycles_text.as_text(Made(element="E"), balance).splitlines()
    assert cells(lines)[2][:6] == ["2e-05", "691", "109.975", "yes", "30", "0.125"]
    assert cells(lines)[3][3] == "no"
    assert lines[-1] == "certified"
    balance.limit_cycles[1].near_tangency = True
    assert "5 degrees" in limit_cycles_text.as_text(Made(element="E"), balance).splitlines()[-1]


def identified(**changes: object) -> Made:
    usual = {"frequency": 740.0, "frequency_uncertainty": 0.0, "time_constants": [], "intervals": []}
    return Made(**usual | {"bands": [], "nearest": None} | changes)


def test_what_was_identified_is_told_with_its_band() -> None:
    found = Made(time_constant=1.5e-3, limit_cycle=cycle(frequency=743.0))
    interval = Made(lowest=1e-3, highest=2e-3, frequencies=(738.0, 742.0))
    band = Made(frequencies=(700.0, 800.0), lower=Made(time_constant=0.0), upper=Made(time_constant=np.nan))
    text = limit_cycles_text.identified_as_text
    lines = text(
        identified(time_constants=[found], frequency_uncertainty=2.0, intervals=[interval], bands=[band])
    ).splitlines()
    assert lines[0] == "Time constants M/D"
    assert cells(lines)[1][:2] == ["M/D, s", "amplitude"] and len(cells(lines)[1]) == 6
    assert cells(lines)[2][:2] == ["0.0015", "2e-05"]
    assert lines[3] == "M/D within 740 +- 2 Hz: 0.001 to 0.002 s (738 to 742 Hz)"
    assert lines[4] == "feasible: 700 to 800 Hz, with M/D from 0 s to no end"
    assert len(lines) == 5
    lines = text(identified(nearest=found, frequency_uncertainty=1e-3)).splitlines()
    assert lines[0].startswith("no M/D gives")
    assert lines[1].startswith("no M/D gives a limit cycle within 740 +- 0.001 Hz")
    assert lines[2].startswith("feasible: no frequency")
    assert lines[3] == "The nearest limit cycle, +3 Hz from there"
    assert len(text(identified()).splitlines()) == 2


def test_orbits_stand_beside_their_predictions() -> None:
    prediction, missed = cycle(), cycle(amplitude=3e-5)
    usual = {"amplitude": 2e-5, "frequency": 110.0, "stable": False, "largest_multiplier": 1.25}
    usual["neutral"] = False
    orbit = Made(**usual, prediction=prediction, amplitude_error=0.0125, frequency_error=-0.001)
    assert orbits_text._row(orbit) == (
        *("2e-05", "110", "no", "1.25"),
        *("2e-05", "+1.25%", "109.975", "-0.100%"),
    )
    assert orbits_text._row(Made(**usual, prediction=None))[4:] == ("none", "", "", "")
    assert orbits_text._row(Made(**{**usual, "neutral": True}, prediction=None))[2] == "neutral"
    assert orbits_text._without_orbit([prediction, missed], [orbit]) == [missed]


def test_roots_and_extrema_of_the_linear_trimmer() -> None:
    factored = Made(poles=np.array([-1 + 2j, -1 - 2j, -3 + 0j]), zeros=np.array([5j, -5j]), static_gain=2.0)
    low, high = Made(omega=2 * np.pi, magnitude=10.0), Made(omega=4 * np.pi, magnitude=0.0)
    summary = Made(factored=factored, peaks=(high,), antiresonances=(low,))
    assert list(linear_text._root_rows(summary)) == [("-1 ± 2j", "0 ± 5j"), ("-3", "")]
    rows = list(linear_text._extremum_rows(summary))
    assert rows == [("dip", "6.28319", "1", "10", "20"), ("peak", "12.5664", "2", "0", "-inf")]
    mode = Made(eigenvalue=-1 + 2j)
    assert linear_text._is_stable(Made(modes=[mode]))
    assert not linear_text._is_stable(Made(modes=[mode, Made(eigenvalue=0j)]))
    assert linear_text._table("T", ("a", "b"), iter(())) == ["T", "  none"]
    assert linear_text._table("T", ("a", "b"), [("long", "x")]) == ["T", "  a     b", "  long  x"]


def test_gains_of_the_linear_trimmer() -> None:
    summary = Made(
        factored=Made(static_gain=0.0), gain_crossings=[], low_pass=None, roll_off=-40.0, encirclements=None
    )
    told = dict(linear_text._gain_rows(summary))
    assert told["|G| = 1 (0 dB) at"] == "no frequency"
    assert told["bandwidth"].startswith("not defined")
    assert told["roll-off"] == "-40 dB per decade"
    assert told["clockwise encirclements of -1"].startswith("not defined")
    summary.low_pass, summary.encirclements = Made(bandwidth=5.0, crossings=[5.0, 7.0]), 0
    told = dict(linear_text._gain_rows(summary))
    assert told["bandwidth (-3 dB from G(0))"] == "5 rad/s"
    assert told["-3 dB from G(0) at"] == "5, 7 rad/s"
    assert told["clockwise encirclements of -1"] == "0"
