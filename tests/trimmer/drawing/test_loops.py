"""Pictures of harmonic balance, elements, orbits and identified loads: axes show what was computed."""

from __future__ import annotations

import control
import numpy as np
import pytest
from matplotlib.axes import Axes
from matplotlib.colors import same_color

import trimmer
from tests.trimmer import results
from tests.trimmer.drawing.blank import new_axes
from trimmer.balance.limit_cycle import HarmonicBalance
from trimmer.drawing.frequencies import telling_frequencies
from trimmer.drawing.locus import balance_figure
from trimmer.drawing.look import UNSTABLE
from trimmer.linear.zero_pole_gain import ZeroPoleGain


def line(axes: Axes, label: str) -> np.ndarray:
    """The points of the one line with a label, (n, 2)."""
    (found,) = (each for each in axes.lines if each.get_label() == label)
    return found.get_xydata()


def test_the_locus_is_that_of_the_system_and_finds_its_peak() -> None:
    axes = results.balance().plot(new_axes())
    (drawn,) = (each for each in axes.lines if each.get_label() == "G(jω)")
    expected = control.frequency_response(results.system(), drawn.along.values).complex
    np.testing.assert_allclose(drawn.get_xdata() + 1j * drawn.get_ydata(), expected, rtol=1e-9)
    highest = max(peak.magnitude for peak in results.summary().peaks)
    assert abs(drawn.get_xdata() + 1j * drawn.get_ydata()).max() == pytest.approx(highest, rel=1e-4)


def test_limit_cycles_lie_on_both_curves_full_where_stable() -> None:
    balance = results.balance()
    axes = balance.plot(new_axes())
    element = line(axes, "−1/N(A)") @ [1, 1j]
    marks = [each for each in axes.lines if "Hz" in each.get_label()]
    for mark, cycle in zip(marks, balance.limit_cycles, strict=True):
        (place,) = mark.get_xydata() @ [1, 1j]
        assert place == pytest.approx(trimmer.response_at(results.system(), cycle.omega), rel=1e-12)
        assert abs(element - place).min() < 0.01 * abs(place)
        assert same_color(mark.get_markerfacecolor(), "black" if cycle.stable else "white")
        assert f"{cycle.frequency:.5g} Hz" in mark.get_label()
        assert mark.get_label().startswith("stable" if cycle.stable else "unstable")


def test_an_element_that_depends_on_frequency_has_a_curve_for_each_limit_cycle() -> None:
    balance = trimmer.harmonic_balance(results.system(), trimmer.ViscousBacklash(4e-5, 1e-3))
    axes = balance.plot(new_axes())
    curves = [each for each in axes.lines if each.get_label().startswith("−1/N(A), ")]
    for curve, cycle in zip(curves, balance.limit_cycles, strict=True):
        gain = balance.loop.element.describing_function(curve.along.values, cycle.omega)
        np.testing.assert_allclose(curve.get_xdata() + 1j * curve.get_ydata(), -1 / gain, rtol=1e-9)


def test_a_frozen_frequency_is_that_of_the_curve() -> None:
    element = trimmer.ViscousBacklash(4e-5, 1e-3)
    balance = trimmer.harmonic_balance(results.system(), element, frozen_omega=4000.0)
    axes = balance.plot(new_axes())
    (curve,) = (each for each in axes.lines if each.get_label() == "−1/N(A)")
    gain = element.describing_function(curve.along.values, 4000.0)
    np.testing.assert_allclose(curve.get_xdata() + 1j * curve.get_ydata(), -1 / gain, rtol=1e-9)


def test_a_locus_that_goes_to_infinity_is_shown_near_the_limit_cycle() -> None:
    # 1/(s (s + 1)^2) is -1/2 at 1 rad/s; -1/N of a relay of height 1 is -pi A/4, so A = 2/pi.
    balance = trimmer.harmonic_balance(control.tf([1], [1, 2, 1, 0]), trimmer.Relay(1.0))
    axes = balance.plot(new_axes())
    (low, high), (bottom, top) = axes.get_xlim(), axes.get_ylim()
    assert low < -1 < -0.5 < high
    assert bottom < 0 < top
    assert max(abs(low), abs(bottom)) < 10
    assert line(axes, "−1/N(A)")[:, 0].min() < low  # a relay's locus has no end


def test_the_second_panel_shows_what_is_around_the_limit_cycles() -> None:
    balance = trimmer.harmonic_balance(results.system(), trimmer.ViscousBacklash(4e-5, 1e-3))
    whole, near = balance_figure(balance).axes
    assert np.ptp(near.get_xlim()) < 0.25 * np.ptp(whole.get_xlim())
    for cycle in balance.limit_cycles:
        place = complex(trimmer.response_at(results.system(), cycle.omega))
        assert near.viewLim.contains(place.real, place.imag)


def test_a_result_put_together_by_hand_cannot_be_drawn() -> None:
    balance = HarmonicBalance((), results.balance().certificate)
    with pytest.raises(ValueError, match="no loop"):
        balance.plot(new_axes())


def test_no_limit_cycle_is_drawn_too() -> None:
    balance = trimmer.harmonic_balance(control.tf([0.1], [1, 1]), trimmer.FrictionBacklash(1.0))
    assert not balance.limit_cycles
    axes = balance_figure(balance).axes[0]
    assert axes.viewLim.contains(-1.0, 0.0)


def test_frequencies_are_dense_around_a_sharp_resonance() -> None:
    factored = ZeroPoleGain.of(control.tf([1], [1, 2e-5, 1]))
    omega = telling_frequencies(factored)
    gain = np.exp(factored.log_gain(omega))
    assert gain.max() == pytest.approx(5e4, rel=1e-3)  # 1/(2 zeta)
    assert (np.diff(omega) > 0).all()
    assert telling_frequencies(factored, (1e3, 1e4))[[0, -1]] == pytest.approx([1e3, 1e4])


@pytest.mark.parametrize("element", [results.PLAY, trimmer.Relay(1.0)], ids=repr)
def test_a_describing_function_is_drawn_with_its_phase(element: trimmer.Element) -> None:
    axes = element.plot(new_axes())
    (magnitude,) = axes.lines
    (phases,) = (each for each in axes.figure.axes if each is not axes)
    (phase,) = phases.lines
    gain = element.describing_function(magnitude.get_xdata())
    np.testing.assert_allclose(magnitude.get_ydata(), abs(gain), rtol=1e-12)
    np.testing.assert_allclose(phase.get_ydata(), np.degrees(np.angle(gain)), atol=1e-9)
    assert phase.get_linestyle() != magnitude.get_linestyle()


def test_an_element_is_drawn_from_its_smallest_amplitude_on() -> None:
    (magnitude,) = results.PLAY.plot(new_axes()).lines
    assert magnitude.get_xdata()[0] == pytest.approx(results.GAP / 2, rel=1e-5)


def test_a_frequency_that_is_needed_is_asked_for() -> None:
    with pytest.raises(ValueError, match="depends on frequency"):
        trimmer.ViscousBacklash(4e-5, 1e-3).plot(new_axes())


@pytest.mark.parametrize("element", [results.PLAY, trimmer.Relay(1.0)], ids=repr)
def test_the_arrow_of_a_locus_points_to_larger_amplitudes(element: trimmer.Element) -> None:
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
        solid = curve.get_linestyle() == "-"
        assert solid == orbit.stable
        assert orbit.stable or curve._unscaled_dash_pattern[1] == UNSTABLE[1]
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("input of the element, µm", "its rate, m/s")


def test_the_load_is_drawn_over_frequency() -> None:
    found = results.identification()
    axes = found.plot(new_axes())
    (point,) = line(axes, "M/D found")
    assert point == pytest.approx([740.0, found.time_constants[0].time_constant])
    stable = line(axes, "stable limit cycle")
    stable = stable[np.isfinite(stable).all(axis=1)]
    nearest = stable[abs(stable[:, 0] - 740.0).argmin()]
    # The curve is found from M/D, this from the frequency.
    again = trimmer.identify_time_constant(results.system(), results.GAP, nearest[0])
    assert nearest[1] == pytest.approx(again.time_constants[0].time_constant, rel=1e-6)
    assert all(any(band.holds(frequency) for band in found.bands) for frequency, _ in stable)
    assert axes.get_yscale() == "log"
