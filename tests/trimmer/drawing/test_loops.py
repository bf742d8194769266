"""Pictures of harmonic balance, elements, orbits and identified loads: axes show what was computed."""

from __future__ import annotations

import control
import numpy as np
import pytest
from matplotlib.colors import same_color

import trimmer
from tests.quick import quick
from tests.trimmer import results
from tests.trimmer.drawing.pictures import RELAY, VISCOUS, integrated, lines, new_axes, points, viscous
from trimmer.balance.limit_cycle import HarmonicBalance


def test_the_locus_is_that_of_the_system_and_finds_its_peak() -> None:
    axes = results.balance().plot(new_axes())
    (drawn,) = lines(axes, "G(jω)")
    expected = control.frequency_response(results.system(), drawn.along.values).complex
    np.testing.assert_allclose(drawn.get_xdata() + 1j * drawn.get_ydata(), expected, rtol=1e-9)
    highest = max(peak.magnitude for peak in results.summary().peaks)
    assert abs(drawn.get_xdata() + 1j * drawn.get_ydata()).max() == pytest.approx(highest, rel=1e-4)


def test_limit_cycles_lie_on_both_curves_full_where_stable() -> None:
    balance = results.balance()
    axes = balance.plot(new_axes())
    element = points(axes, "−1/N(A)") @ [1, 1j]
    marks = [each for each in axes.lines if "Hz" in each.get_label()]
    for mark, cycle in zip(marks, balance.limit_cycles, strict=True):
        (place,) = mark.get_xydata() @ [1, 1j]
        assert place == pytest.approx(trimmer.response_at(results.system(), cycle.omega), rel=1e-12)
        assert abs(element - place).min() < 0.01 * abs(place)
        assert same_color(mark.get_markerfacecolor(), "black" if cycle.stable else "white")
        assert f"{cycle.frequency:.5g} Hz" in mark.get_label()
        assert mark.get_label().startswith("stable" if cycle.stable else "unstable")


@pytest.mark.parametrize("element", [results.PLAY, RELAY], ids=repr)
def test_a_describing_function_is_drawn_with_its_phase(element: trimmer.elements.Element) -> None:
    axes = element.plot(new_axes())
    (magnitude,) = axes.lines
    (phases,) = (each for each in axes.figure.axes if each is not axes)
    (phase,) = phases.lines
    gain = element.describing_function(magnitude.get_xdata())
    np.testing.assert_allclose(magnitude.get_ydata(), abs(gain), rtol=1e-12)
    np.testing.assert_allclose(phase.get_ydata(), np.degrees(np.angle(gain)), atol=1e-9)
    assert phase.get_linestyle() != magnitude.get_linestyle()


@pytest.mark.parametrize("element", [results.PLAY, RELAY], ids=repr)
def test_the_arrow_of_a_locus_points_to_larger_amplitudes(element: trimmer.elements.Element) -> None:
    axes = element.plot_locus(new_axes())
    (arrow,) = axes.texts
    curve = axes.lines[0]
    points = curve.get_xdata() + 1j * curve.get_ydata()
    begin, end = (complex(*place) for place in (arrow.xyann, arrow.xy))
    amplitudes = [curve.along.values[abs(points - place).argmin()] for place in (begin, end)]
    assert amplitudes[0] < amplitudes[1]


def test_orbits_are_drawn_in_the_phase_plane() -> None:
    orbits = results.orbits()
    axes = orbits.plot(new_axes())
    curves = [each for each in axes.lines if "Hz" in each.get_label()]
    events = [each for each in axes.lines if each.get_label() == "change of mode"]
    for curve, dots, orbit in zip(curves, events, orbits, strict=True):
        x, rate = curve.get_data()
        assert np.ptp(x) / 2 == pytest.approx(orbit.amplitude, rel=1e-6)
        # What is enclosed is the integral of the squared rate over a period.
        times = np.linspace(0, orbit.period, 20001)
        slope = np.gradient(orbit.motion.element_input(times), times)
        area = 0.5 * abs(np.dot(x[:-1], np.diff(rate)) - np.dot(rate[:-1], np.diff(x)))
        assert area == pytest.approx(np.trapezoid(slope**2, times), rel=1e-4)
        assert len(dots.get_xdata()) == len(orbit.switching_times)
        assert curve.get_linestyle() == ("-" if orbit.stable else "--")
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("input of the element, µm", "its rate, m/s")


@pytest.mark.slow
def test_the_load_is_drawn_over_frequency() -> None:
    found = results.identification()
    axes = found.plot(new_axes())
    (point,) = points(axes, "M/D found")
    assert point == pytest.approx([740.0, found.time_constants[0].time_constant])
    stable = points(axes, "stable limit cycle")
    stable = stable[np.isfinite(stable).all(axis=1)]
    nearest = stable[abs(stable[:, 0] - 740.0).argmin()]
    # The curve is found from M/D, this from the frequency.
    again = trimmer.identify_time_constant(results.system(), results.GAP, nearest[0])
    assert nearest[1] == pytest.approx(again.time_constants[0].time_constant, rel=1e-6)
    assert all(any(band.holds(frequency) for band in found.bands) for frequency, _ in stable)
    assert axes.get_yscale() == "log"


@pytest.mark.parametrize("frozen", [None, 4000.0])
def test_an_element_that_depends_on_frequency_has_a_curve_for_each(frozen: float | None) -> None:
    balance = (
        trimmer.harmonic_balance(results.system(), VISCOUS, frozen_omega=frozen) if frozen else viscous()
    )
    omegas = [frozen] if frozen else [cycle.omega for cycle in balance.limit_cycles]
    curves = [each for each in balance.plot(new_axes()).lines if each.get_label().startswith("−1/N(A)")]
    for curve, omega in zip(curves, omegas, strict=True):
        gain = VISCOUS.describing_function(curve.along.values, omega)
        np.testing.assert_allclose(curve.get_xdata() + 1j * curve.get_ydata(), -1 / gain, rtol=1e-9)


def test_a_locus_that_goes_to_infinity_is_shown_near_the_limit_cycle() -> None:
    axes = integrated().plot(new_axes())
    (low, high), (bottom, top) = axes.get_xlim(), axes.get_ylim()
    assert low < -1 < -0.5 < high
    assert bottom < 0 < top
    assert points(axes, "−1/N(A)")[:, 0].min() < low  # a relay's locus has no end


@pytest.mark.parametrize("near", quick([False, True], 1))
def test_all_limit_cycles_are_within_the_axes(near: bool) -> None:
    for balance in (results.balance(), viscous(), integrated()):
        axes = balance.plot(new_axes(), near=near)
        places = [
            complex(trimmer.response_at(balance.loop.system, each.omega)) for each in balance.limit_cycles
        ]
        for place in [*places, -1.0 + 0j]:
            assert axes.viewLim.contains(place.real, place.imag)


@pytest.mark.parametrize(
    ("draw", "told"),
    [
        (HarmonicBalance((), None).plot, "no loop"),
        (VISCOUS.plot, "depends on frequency"),
        (VISCOUS.plot_locus, "depends on frequency"),
    ],
)
def test_what_cannot_be_drawn_says_what_it_lacks(draw, told: str) -> None:
    with pytest.raises(ValueError, match=told):
        draw(new_axes())


@pytest.mark.parametrize("damping", [1e-3, 1e-5])
def test_a_sharp_resonance_is_met(damping: float) -> None:
    system = control.tf([1], [1, 2 * damping, 1])
    axes = trimmer.harmonic_balance(system, trimmer.FrictionBacklash(1.0)).plot(new_axes())
    curve = points(axes, "G(jω)") @ [1, 1j]
    assert abs(curve).max() == pytest.approx(0.5 / damping, rel=0.02)
