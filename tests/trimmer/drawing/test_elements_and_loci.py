"""What is drawn of elements, of loci and of responses: places, limits, and which of them are shown."""

from __future__ import annotations

from types import SimpleNamespace

import control
import numpy as np
import pytest
from matplotlib.colors import to_hex

import trimmer
from tests.trimmer import results
from tests.trimmer.drawing.blank import new_axes
from trimmer.balance.limit_cycle import HarmonicBalance
from trimmer.drawing import describing_function, identification, locus
from trimmer.drawing.describing_function import amplitudes_of
from trimmer.drawing.frequencies import telling_frequencies
from trimmer.drawing.frequency_response import decibels, draw_summary, summary_figure
from trimmer.drawing.look import LINES, UNSTABLE
from trimmer.drawing.plane import inverse
from trimmer.linear.zero_pole_gain import ZeroPoleGain

RELAY = trimmer.Relay(1.0)


def test_amplitudes_begin_at_the_smallest_and_are_close_together_there() -> None:
    smallest = 2e-5  # half of the gap: below it there is no contact
    amplitude = amplitudes_of(results.PLAY, None)
    assert amplitude.size == 1249
    np.testing.assert_allclose(amplitude[[0, 249, -1]] / smallest - 1, [1e-6, 0.1, 99.0], rtol=1e-9)
    assert (np.diff(amplitude) > 0).all()
    far = amplitude[249:]
    np.testing.assert_allclose(far[1:] / far[:-1], (100 / 1.1) ** (1 / 999))
    near = amplitude[:250] / smallest - 1
    np.testing.assert_allclose(near[1:] / near[:-1], 1e5 ** (1 / 249), rtol=1e-7)


def test_any_amplitude_is_within_a_hundred_of_the_scale() -> None:
    amplitude = amplitudes_of(RELAY, None)
    assert amplitude.size == 1000
    np.testing.assert_allclose(amplitude[[0, -1]] / RELAY.amplitude_scale, [0.01, 100.0])
    np.testing.assert_allclose(amplitude[1:] / amplitude[:-1], 1e4 ** (1 / 999))


@pytest.mark.parametrize("element", [results.PLAY, RELAY, trimmer.InertiaBacklash(4e-5)], ids=repr)
def test_magnitude_and_phase_have_axes_of_their_own(element: trimmer.Element) -> None:
    axes = element.plot(new_axes())
    (phases,) = (each for each in axes.figure.axes if each is not axes)
    (magnitude,), (phase,) = axes.lines, phases.lines
    assert [each.get_color() for each in (magnitude, phase)] == [LINES[0]["color"], LINES[1]["color"]]
    assert axes.get_ylim()[0] == 0.0
    degrees = phase.get_ydata()
    assert phases.get_ylim() == pytest.approx((min(degrees.min(), 0) - 10, max(degrees.max(), 0) + 10))
    assert axes.get_xscale() == phases.get_xscale() == "log"
    assert axes.get_ylabel() and phases.get_ylabel()


def test_a_phase_does_not_jump() -> None:
    turns = np.exp(1j * np.radians([170.0, 175.0, 185.0, 200.0]))
    np.testing.assert_allclose(describing_function._degrees(3.0 * turns), [170.0, 175.0, 185.0, 200.0])


def test_a_phase_that_leads_has_room_above() -> None:
    leading = trimmer.FrictionBacklash(4e-5) * -1.0  # half a turn beside the play
    axes = leading.plot(new_axes())
    phases = axes.figure.axes[1]
    degrees = phases.lines[0].get_ydata()
    assert degrees.max() > 90
    assert phases.get_ylim() == pytest.approx((-10.0, degrees.max() + 10.0))


def test_lengths_along_a_curve_are_shares() -> None:
    np.testing.assert_allclose(
        describing_function._shares(np.array([1j, 3 + 1j, 3 - 3j])), [0, 3 / 7, 1], rtol=1e-15
    )
    np.testing.assert_array_equal(describing_function._shares(np.array([2 + 1j])), [0.0])


def test_limits_leave_a_margin_of_eight_percent() -> None:
    for fit, flat in ((describing_function._fit, 0.5), (locus._frame, 0.08)):
        axes = new_axes()
        fit(axes, np.array([-1 + 10j, 4 + 2j, 0j + 3]))
        assert axes.get_xlim() == pytest.approx((-1.4, 4.4))
        assert axes.get_ylim() == pytest.approx((-0.8, 10.8))
        fit(axes, np.array([-1 + 2j, 1 + 2j]))
        assert axes.get_ylim() == pytest.approx((2 - flat, 2 + flat))


@pytest.mark.parametrize(("element", "reach"), [(results.PLAY, 20.0), (RELAY, 3.0)], ids=repr)
def test_a_locus_is_shown_as_far_as_it_tells_something(element: trimmer.Element, reach: float) -> None:
    axes = element.plot_locus(new_axes())
    drawn, critical = axes.lines
    assert critical.get_xydata().tolist() == [[-1.0, 0.0]]
    assert drawn.get_color() == LINES[1]["color"]
    curve = drawn.get_xydata() @ [1, 1j]
    # |1/N| of a play is 1 at large amplitudes; that of a relay is pi A/4, down to nearly nothing.
    curve = curve[np.isfinite(curve) & (abs(curve) <= reach)]
    for limits, parts in (
        (axes.get_xlim(), np.append(curve.real, -1.0)),
        (axes.get_ylim(), np.append(curve.imag, 0.0)),
    ):
        margin = 0.08 * np.ptp(parts) or 0.5
        assert limits == pytest.approx((parts.min() - margin, parts.max() + margin), rel=1e-3)
    (arrow,) = axes.texts
    begin, end = (complex(*each) for each in (arrow.xyann, arrow.xy))
    at = int(abs(curve - end).argmin())
    assert abs(curve - begin).argmin() == at + 1  # the curve is drawn towards smaller amplitudes
    lengths = abs(np.diff(curve))
    assert lengths[at:].sum() / lengths.sum() == pytest.approx(0.5, abs=0.02)
    assert arrow.arrow_patch.get_facecolor()[:3] != (0, 0, 0)


def test_the_inverse_is_minus_one_over_the_gain() -> None:
    # N of a relay of height 1 at A is 4/(pi A); u = scale/A.
    ratios = np.array([0.5, 4.0])
    expected = -np.pi * RELAY.amplitude_scale / ratios / 4
    np.testing.assert_allclose(inverse(RELAY, ratios), expected, rtol=1e-12)


def test_places_of_a_locus_are_close_together_at_both_ends() -> None:
    shares = locus.ratios_of(results.PLAY, None)
    shares = shares / float(results.PLAY.domain())
    assert shares.size == 1799
    np.testing.assert_allclose(shares[[0, 599]], [1e-6, 0.5])
    np.testing.assert_allclose(1 - shares[[600, -1]], [0.5 * 2e-9 ** (1 / 1199), 1e-9], rtol=1e-6)
    assert (np.diff(shares) > 0).all()
    ratios = locus.ratios_of(RELAY, None)
    assert (ratios[0], ratios[-1], ratios.size) == (pytest.approx(1e-6), pytest.approx(1e6), 1800)
    far = SimpleNamespace(domain=lambda omega: 8.0, constant_from=5.0, has_bounds=False)
    integrated = locus.ratios_of(far, 3.0)
    np.testing.assert_allclose(integrated, 5.0 * locus.SHARES[::9])
    near = SimpleNamespace(domain=lambda omega: omega, constant_from=5.0, has_bounds=True)
    np.testing.assert_allclose(locus.ratios_of(near, 3.0), 3.0 * locus.SHARES)


def test_frequencies_go_beyond_the_outermost_roots() -> None:
    factored = ZeroPoleGain.of(control.tf([1, 3], [1, 0.02, 400, 0]))  # 0, -3, about +-20j
    omega = telling_frequencies(factored, reach=7.0)
    assert omega[[0, -1]] == pytest.approx([3 / 7, 140])
    assert telling_frequencies(factored)[[0, -1]] == pytest.approx([0.03, 2000])
    assert telling_frequencies(factored, (1.0, 50.0))[[0, -1]] == pytest.approx([1.0, 50.0])
    assert telling_frequencies(factored, (3e5, 4e5))[[0, -1]] == pytest.approx([3e5, 4e5])
    # The even ones: 2000 in equal ratios.
    plain = telling_frequencies(ZeroPoleGain.of(control.tf([1], [1, 0])), reach=10.0)
    assert plain[[0, -1]] == pytest.approx([0.1, 10.0])
    np.testing.assert_allclose(plain[1:] / plain[:-1], 100 ** (1 / 1999))


def test_frequencies_are_as_dense_as_the_root_is_damped() -> None:
    # sinh(x) is 1 at 0.8814, and x has 400 places from -6 to 6; sinh(6) is 201.7.
    for damping, width in ((0.01, 0.01), (0.0, 2e-5)):
        roots = np.array([-damping + 20j, -damping - 20j])
        omega = telling_frequencies(SimpleNamespace(roots=roots), reach=2.0)
        within = ((omega > 20 - width) & (omega < 20 + width)).sum()
        assert within in (58, 59, 60)  # the even ones among them
        reached = omega[abs(omega - 20) < 201.8 * width]
        assert np.ptp(reached) == pytest.approx(2 * 201.713 * width, rel=0.01)
        assert omega.size == pytest.approx(2400, abs=1)


@pytest.fixture
def balance() -> HarmonicBalance:
    """1/(s (s + 1)^2) is -1/2 at 1 rad/s; -1/N of a relay of height 1 is -pi A/4, so A is 2/pi."""
    return trimmer.harmonic_balance(control.tf([1], [1, 2, 1, 0]), RELAY)


def test_what_goes_to_infinity_is_cut(balance: HarmonicBalance) -> None:
    places = locus._places(balance, -1.0)
    np.testing.assert_allclose(places, [-0.5, -1.0], atol=1e-9)
    whole, near = locus._spans(balance)
    shown = locus._shown(balance)
    np.testing.assert_allclose(shown[-2:], places)
    np.testing.assert_allclose(whole, [np.ptp(shown.real), np.ptp(shown.imag)])
    np.testing.assert_allclose(near, [0.5, 0.0], atol=1e-9)
    wide = SimpleNamespace(
        loop=balance.loop,
        limit_cycles=balance.limit_cycles,
        certificate=SimpleNamespace(omegas=(1e-3, 10.0)),
    )
    assert 3.9 < abs(locus._shown(wide)).max() <= 4.0  # four times -1
    wide.loop = SimpleNamespace(system=4 * balance.loop.system)
    assert 7.8 < abs(locus._shown(wide)).max() <= 8.0  # four times -2, where the limit cycle is
    axes = balance.plot(new_axes(), near=True)
    assert axes.get_xlim() == pytest.approx((-1.04, -0.46))
    axes = balance.plot(new_axes())
    assert axes.get_xlim()[0] == pytest.approx(shown.real.min() - 0.08 * np.ptp(shown.real))
    assert axes.get_legend().get_title().get_text()
    assert [each.get_color() for each in axes.lines[:2]] == [each["color"] for each in LINES[:2]]
    assert [-1.0, 0.0] in [each.get_xydata()[0].tolist() for each in axes.lines]


def test_a_response_that_ends_is_shown_whole() -> None:
    none = trimmer.harmonic_balance(control.tf([0.1], [1, 1]), trimmer.FrictionBacklash(1.0))
    assert locus._spans(none)[1].size == 0
    axes = none.plot(new_axes(), near=True)
    highest = locus._shown(none).real.max()
    assert axes.get_xlim() == pytest.approx((-1 - 0.08 * (1 + highest), highest + 0.08 * (1 + highest)))
    certificate = SimpleNamespace(omegas=(0.0, np.inf))
    large = SimpleNamespace(system=control.tf([100.0], [1, 1]))
    shown = locus._shown(SimpleNamespace(loop=large, certificate=certificate, limit_cycles=[]))
    assert abs(shown).max() == pytest.approx(100.0, rel=1e-3)
    assert axes.get_legend().get_title().get_text() == ""
    assert len(locus.balance_figure(none).axes) == 1


@pytest.mark.parametrize(
    ("near", "panels"), [((1.0, 1.0), 2), ((1.01, 0.0), 1), ((0.0, 1.01), 1), ((), 1)], ids=str
)
def test_what_is_close_together_is_enlarged(
    balance: HarmonicBalance, monkeypatch: pytest.MonkeyPatch, near: tuple[float, ...], panels: int
) -> None:
    monkeypatch.setattr(locus, "_spans", lambda _: (np.array([4.0, 4.0]), np.array(near)))
    figure = locus.balance_figure(balance)
    assert len(figure.axes) == panels
    if panels == 2:
        assert tuple(figure.get_size_inches()) == (7.2, 8.2)
        upper, lower = figure.axes
        assert np.ptp(lower.get_xlim()) < np.ptp(upper.get_xlim())
        assert upper.get_title() != lower.get_title() != ""


def test_curves_are_at_the_frequencies_of_limit_cycles() -> None:
    element = SimpleNamespace(depends_on_frequency=True)
    cycles = [SimpleNamespace(omega=691.0), SimpleNamespace(omega=2 * np.pi * 740)]
    certificate = SimpleNamespace(omegas=(4.0, 100.0))
    told = SimpleNamespace(
        loop=SimpleNamespace(element=element), limit_cycles=cycles, certificate=certificate
    )
    assert [omega for _, omega in locus._frequencies(told)] == [691.0, 2 * np.pi * 740]
    assert locus._frequencies(told)[1][0] == "−1/N(A), 740 Hz"
    told.limit_cycles = []
    assert [omega for _, omega in locus._frequencies(told)] == [pytest.approx(20.0)]
    element.depends_on_frequency = False
    assert locus._frequencies(told) == [("−1/N(A)", None)]


def test_decibels_are_of_the_modulus() -> None:
    np.testing.assert_allclose(decibels(np.array([-10.0, 3 - 4j, 1j])), [20.0, 20 * np.log10(5.0), 0.0])


def test_peaks_and_dips_are_marked_where_the_response_has_them() -> None:
    summary = results.summary()
    axes = draw_summary(summary, new_axes())
    marked = {each.get_label(): each for each in axes.lines}
    curve = axes.lines[0]
    assert curve.get_color() == LINES[0]["color"]
    for label, found in (("peak", summary.peaks), ("dip", summary.antiresonances)):
        wanted = [each for each in found if 0 < each.magnitude < np.inf]
        assert wanted
        frequencies, levels = marked[label].get_data()
        np.testing.assert_allclose(frequencies, [each.omega / (2 * np.pi) for each in wanted])
        np.testing.assert_allclose(levels, [20 * np.log10(each.magnitude) for each in wanted])
    dotted = [each for each in axes.lines if each.get_linestyle() == ":"]
    assert len(dotted) > 1
    assert dotted[0].get_label() == "natural mode, damped"
    handles, _ = axes.get_legend_handles_labels()
    assert not set(dotted[1:]) & set(handles)
    frequency = curve.get_xdata()
    assert axes.get_xlim() == pytest.approx((frequency[0], frequency[-1]))
    sizes = abs(summary.factored.roots[summary.factored.roots != 0])
    np.testing.assert_allclose(2 * np.pi * frequency[[0, -1]], [sizes.min() / 10, sizes.max() * 10])


def test_extrema_without_a_level_are_not_marked() -> None:
    summary = results.summary()
    places = [SimpleNamespace(magnitude=size, omega=5.0) for size in (0.0, np.inf)]
    told = SimpleNamespace(
        output=summary.output,
        factored=summary.factored,
        peaks=places,
        antiresonances=[],
        modes=[SimpleNamespace(frequency=0.0)],
    )
    axes = draw_summary(told, new_axes())
    assert len(axes.lines) == 1


def test_a_bode_plot_has_one_axis_of_frequency() -> None:
    figure = summary_figure(results.summary())
    upper, lower = figure.axes
    assert (upper.get_xlabel(), lower.get_xlabel()) == ("", "frequency, Hz")
    assert tuple(figure.get_size_inches()) == (7.2, 6.0)
    assert figure.get_suptitle()
    assert all(axes.xaxis.get_gridlines()[0].get_visible() for axes in (upper, lower))
    assert (upper.get_ylabel(), lower.get_ylabel()) == ("magnitude, dB", "phase, degrees")
    ticks = lower.yaxis.get_major_locator().tick_values(-200.0, 10.0)
    assert set(np.diff(ticks)) == {90.0}
    assert lower.lines[0].get_color() == LINES[0]["color"]
    np.testing.assert_array_equal(lower.lines[0].get_xdata(), upper.lines[0].get_xdata())


def identified(frequency: float, time_constants: list[float], uncertainty: float) -> SimpleNamespace:
    return SimpleNamespace(
        frequency=frequency,
        frequency_uncertainty=uncertainty,
        time_constants=[SimpleNamespace(time_constant=each) for each in time_constants],
    )


def test_time_constants_are_around_one_over_the_frequency() -> None:
    middle = 1 / (2 * np.pi * 740)
    found = identification._time_constants(identified(740.0, [0.0, np.inf, middle], 2.0))
    assert len(found) == 49
    np.testing.assert_allclose([found[0], found[24], found[-1]], [middle / 1e3, middle, middle * 1e3])
    wide = identification._time_constants(identified(740.0, [middle / 1e5, middle * 1e4], 2.0))
    np.testing.assert_allclose([wide[0], wide[-1]], [middle / 1e5, middle * 1e4])


def test_an_identified_load_is_drawn_over_its_bands() -> None:
    found = identified(740.0, [0.0, 3e-3, np.inf], 2.0)
    # The frequency rises with M/D, and the limit cycle is stable from 1e-3 s on.
    found.limit_cycles_with = lambda tau: [
        SimpleNamespace(frequency=740.0 + 100 * np.log10(tau), stable=tau >= 1e-3)
    ]
    found.bands = [SimpleNamespace(holds=lambda frequency: frequency > 300.0)]
    axes = identification.draw_identification(found, new_axes())
    unstable, stable, measured, point = axes.lines
    taus = np.array(identification._time_constants(found))
    frequencies = 740.0 + 100 * np.log10(taus)
    for line, wanted in ((stable, taus >= 1e-3), (unstable, (taus < 1e-3) & (frequencies > 300))):
        np.testing.assert_allclose(line.get_xydata(), np.transpose([frequencies, taus])[wanted])
    assert (stable.get_linestyle(), stable.get_color()) == ("-", LINES[0]["color"])
    assert (unstable.get_linestyle(), unstable.get_color()) == ("--", LINES[1]["color"])
    assert unstable._unscaled_dash_pattern[1] == UNSTABLE[1]
    assert measured.get_xdata() == [740.0, 740.0]
    assert point.get_xydata().tolist() == [[740.0, 3e-3]]
    (span,) = axes.patches
    assert [span.get_x(), span.get_width()] == pytest.approx([738.0, 4.0])
    assert to_hex(span.get_facecolor()) == "#d9d9d9"
    assert axes.get_yscale() == "log"
    assert axes.get_xlabel() == "frequency of the limit cycle, Hz"


def test_a_load_that_is_not_found_has_no_point() -> None:
    found = identified(740.0, [0.0, np.inf], 2.0)
    found.bands = []
    found.limit_cycles_with = lambda tau: []
    assert [each.get_label() for each in identification.draw_identification(found, new_axes()).lines] == [
        "measured"
    ]
