"""Drawn waveforms and characteristics obey mechanics: gap, contact, flight, work, and the marks on them."""

import numpy as np
import pytest

from report.chapters.chapter_2.figures import waveforms
from report.chapters.chapter_2.figures.waveforms import AMPLITUDES, GAMMAS, GAP, PHASES
from tests.report.figures.lines import line

HALF = GAP / 2


def contact(axes):
    return line(axes, "load, in contact")


def let_go(axes):
    return line(axes, "load, let go")


@pytest.fixture(scope="module")
def friction():
    return waveforms.friction_controlled.draw(None).axes


@pytest.fixture(scope="module")
def inertia():
    return waveforms.inertia_controlled.draw(None).axes


@pytest.fixture(scope="module")
def viscous():
    axes = waveforms.viscous_controlled.draw(None).axes
    return list(zip(axes[: len(GAMMAS)], axes[len(GAMMAS) :], strict=True))


def test_panels_of_friction_controlled_backlash_show_the_same_motion(friction):
    characteristic, output, drive = friction[:3]
    for part in (contact, let_go):
        x, y = part(characteristic)
        phases, same = part(output)
        x_again, downwards = part(drive)
        np.testing.assert_array_equal(y, same)
        np.testing.assert_allclose(x, np.sin(phases))
        np.testing.assert_allclose(x_again, np.sin(phases))
        np.testing.assert_array_equal(downwards[~np.isnan(downwards)], phases[~np.isnan(y)])
    assert drive.yaxis_inverted()


def test_friction_controlled_load_stays_where_it_is_let_go_and_follows_in_contact(friction):
    characteristic, output, _ = friction[:3]
    x, y = contact(characteristic)
    shown = ~np.isnan(y)
    np.testing.assert_allclose(np.abs(x - y)[shown], HALF, atol=1e-9)
    phases, resting = let_go(output)
    early = (phases > np.pi / 2) & (phases < np.pi - 0.5)
    np.testing.assert_allclose(resting[early], 1 - HALF, atol=1e-12)


def test_corners_lie_on_the_traced_characteristic(friction):
    """A play traced from rest passes each corner; nothing of the library is used."""
    phases = np.linspace(0, 5 * np.pi / 2, 50_001)
    output, traced = 0.0, []
    for position in np.sin(phases):
        output = min(max(output, position - HALF), position + HALF)
        traced.append(output)
    corners = [(p.get_xdata()[0], p.get_ydata()[0]) for p in friction[1].lines if p.get_marker() == "o"]
    assert len(corners) == 5
    for phase, height in corners:
        assert np.interp(phase, phases, traced) == pytest.approx(height, abs=1e-3)


def test_inertia_controlled_load_keeps_its_velocity_and_meets_the_other_wall(inertia):
    positions, velocities, characteristic = inertia[:3]
    _, speed = let_go(velocities)
    _, flown = let_go(positions)
    _, meeting, half_turn, second, _ = velocities.get_xticks()
    inside = (PHASES > 0.05) & (meeting - 0.05 > PHASES)
    np.testing.assert_allclose(speed[inside], 1, atol=1e-9)
    inside = (half_turn + 0.05 < PHASES) & (second - 0.05 > PHASES)
    np.testing.assert_allclose(speed[inside], -1, atol=1e-9)
    assert meeting - np.sin(meeting) == pytest.approx(GAP)
    assert np.interp(meeting, PHASES[~np.isnan(flown)], flown[~np.isnan(flown)]) == pytest.approx(
        np.sin(meeting) + HALF, abs=1e-2
    )
    x, y = contact(characteristic)
    np.testing.assert_allclose(np.abs(x - y)[~np.isnan(y)], HALF, atol=1e-9)


def test_viscous_controlled_load_slows_down_exponentially_in_flight(viscous):
    for gamma, (positions, velocities) in zip(GAMMAS, viscous, strict=True):
        separation, meeting, _ = velocities.get_xticks()
        assert separation == pytest.approx(np.arctan(1 / gamma))
        _, speed = let_go(velocities)
        flying = (separation + 0.05 < PHASES) & (meeting - 0.05 > PHASES)
        decay = np.cos(separation) * np.exp(-(PHASES[flying] - separation) / gamma)
        np.testing.assert_allclose(speed[flying], decay, atol=0.02)
        _, load = let_go(positions)
        within = np.abs(load[flying] - np.sin(PHASES[flying]))
        assert (within < HALF).all()


def test_every_panel_says_what_it_shows(friction, inertia, viscous):
    assert all(axes.get_title() for axes in friction[:3])
    assert inertia[1].get_xlabel() and inertia[0].get_ylabel() and inertia[2].get_ylabel()
    assert [axes.get_title() for axes, _ in viscous] == [rf"$\gamma = {gamma:g}$" for gamma in GAMMAS]


def area(x, y):
    """Area that a closed path runs round, positive if counter-clockwise."""
    return float(np.sum(x[:-1] * y[1:] - x[1:] * y[:-1])) / 2


@pytest.fixture(scope="module")
def backlash():
    (axes,) = waveforms.backlash_characteristic.draw(None).axes
    return axes


@pytest.mark.parametrize("amplitude", AMPLITUDES)
def test_loop_of_backlash_has_slope_one_width_two_and_runs_counter_clockwise(backlash, amplitude):
    (path,) = (each for each in backlash.lines if each.get_label() == f"$A = {amplitude:g}\\,b$")
    x, y = np.asarray(path.get_xdata()), np.asarray(path.get_ydata())
    moving = np.abs(np.diff(y)) > 1e-12
    slopes = np.diff(y)[moving] / np.diff(x)[moving]
    assert np.median(slopes) == pytest.approx(1)
    assert np.ptp(y) == pytest.approx(2 * (amplitude - 1))
    assert area(x, y) == pytest.approx(4 * (amplitude - 1), rel=1e-3)


def test_named_points_are_corners_of_the_larger_loop(backlash):
    amplitude = AMPLITUDES[1]
    places = {text.get_text(): text.xy for text in backlash.texts if hasattr(text, "xy")}
    b, c, d, e = (places[f"${letter}$"] for letter in "BCDE")
    assert b == (amplitude, amplitude - 1)
    assert b[0] - c[0] == pytest.approx(2)
    assert (c[1], e[1]) == (b[1], d[1])
    assert d == (-b[0], -b[1])
    assert e == (-c[0], -c[1])
    assert places["$A$"] == (1, 0)


def test_friction_has_the_sign_of_the_velocity_and_takes_work():
    by_velocity, by_displacement, by_time = waveforms.coulomb_friction.draw(None).axes
    lines = {each.get_label(): np.asarray(each.get_ydata()) for each in by_time.lines}
    velocity, force = lines[r"velocity$/(\omega A)$"], lines["force$/F_c$"]
    decided = np.abs(velocity) > 1e-9
    np.testing.assert_array_equal(force[decided], np.sign(velocity[decided]))
    (path,) = by_displacement.lines
    assert area(np.asarray(path.get_xdata()), np.asarray(path.get_ydata())) == pytest.approx(-4)
    for step in by_velocity.lines[:2]:
        assert step.get_ydata()[1] == np.sign(step.get_xdata()[1])
