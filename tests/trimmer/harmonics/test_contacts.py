"""Plays and stops in harmonic balance by hand: when they are in contact, and what their ends add."""

from __future__ import annotations

import math

import numpy as np
import pytest

from trimmer.harmonics.contact import Contact
from trimmer.harmonics.forces import Harmonics, Pieces, with_moving_ends
from trimmer.harmonics.waveform import Decay, Waveform
from trimmer.mechanism.parts import ContactLaw, Play, Stop

BETWEEN = ("ground", "body")


@pytest.mark.parametrize("law", list(ContactLaw))
def test_a_stop_that_is_always_in_contact_is_a_spring(law: ContactLaw) -> None:
    distance = Waveform(np.array([5.0, 1.0 + 0.5j]), 2.0)
    part = Stop(BETWEEN, 3.0, 0.1, 0.5, law)
    harmonics = Contact(part, distance).harmonics()
    assert harmonics.coefficients == pytest.approx([13.5, (3.0 + 0.2j) * (1.0 + 0.5j)], abs=1e-12)
    assert harmonics.direct[1, 1] == pytest.approx(3.0 + 0.2j)


def test_a_contact_that_is_never_made_has_no_force() -> None:
    for part in (Stop(BETWEEN, 3.0, 0.1, 9.0), Play(BETWEEN, 3.0, 0.1, 9.0), Play(BETWEEN, 3.0, 0.0, 9.0)):
        harmonics = Contact(part, Waveform(np.array([0.5, 1.0 + 0.5j]), 2.0)).harmonics()
        for each in vars(harmonics).values():
            assert not each.any()


def test_offsets_and_forces_of_either_side() -> None:
    distance = Waveform(np.array([0.25, 1.0 + 0.5j]), 2.0)
    play = Contact(Play(BETWEEN, 3.0, 0.4, 0.5, ContactLaw.TRUNCATED), distance)
    assert play.offsets == {1: 0.25, -1: -0.25}
    assert Contact(Stop(BETWEEN, 3.0, 0.4, 0.5), distance).offsets == {1: 0.5}
    assert play.law is ContactLaw.TRUNCATED
    assert Contact(Play(BETWEEN, 3.0, 0.0, 0.5, ContactLaw.TRUNCATED), distance).law is ContactLaw.PULLING
    times = np.array([0.0, 0.7])
    for side in (1, -1):
        expected = 3.0 * (distance.at(times) - 0.25 * side) + 0.4 * distance.slope(times)
        assert play.force(side).at(times) == pytest.approx(expected)
    # How far the spring is stretched beyond the slot: 1.25 - 0.25, and nothing within it.
    assert play._stretch_at(0.0) == pytest.approx(1.0)
    assert play._stretch_at(0.5 * distance.period) == pytest.approx(-0.75 + 0.25)
    inside = Waveform(np.array([0.1, 0.1 + 0j]), 2.0)
    assert Contact(play.part, inside)._stretch_at(0.0) == 0.0
    assert Contact(Stop(BETWEEN, 3.0, 0.4, 0.5), inside)._stretch_at(0.0) == 0.0


def test_contact_is_made_and_released_at_known_times() -> None:
    # s = sin 2t beyond ±0.5 from asin(0.5)/2 on; force 3 (s - 0.5) + 0.4 s' vanishes later.
    distance = Waveform(np.array([0.0, -1j]), 2.0)
    contact = Contact(Play(BETWEEN, 3.0, 0.4, 1.0), distance)
    nothing = Decay(0.0, 7.5, 0.0)
    assert contact._made(0.0, nothing, 0) == (pytest.approx(math.pi / 12.0), 1)
    assert contact._made(0.3, nothing, 0) == (pytest.approx(math.pi / 12.0 + math.pi / 2.0), -1)
    at = math.pi / 12.0
    assert contact._made(at, nothing, 1) == (pytest.approx(at + math.pi / 2.0), -1)
    # 3 sin + 0.8 cos = √9.64 sin(x + 0.2606) = 1.5
    size, lead = math.hypot(3.0, 0.8), math.atan2(0.8, 3.0)
    end = 0.5 * (math.pi - math.asin(1.5 / size) - lead)
    assert contact._released(0.3, 1) == pytest.approx(end)
    assert contact._released(0.3, -1) == pytest.approx(end + math.pi / 2.0)
    small = Contact(Play(BETWEEN, 3.0, 0.4, 3.0), distance)
    assert small._made(0.2, nothing, 0) == (0.2, 0)
    always = Contact(Stop(BETWEEN, 3.0, 0.4, -9.0), distance)
    assert always._released(0.0, 1) is None


def test_with_the_truncated_law_contact_ends_where_the_force_would_pull() -> None:
    """s = sin 2t beyond 0.5 from pi/12 to 5 pi/12; 3 (s - 0.5) + 0.8 cos 2t vanishes before."""
    distance = Waveform(np.array([0.0, -1j]), 2.0)
    end = 0.5 * (math.pi - math.asin(1.5 / math.hypot(3.0, 0.8)) - math.atan2(0.8, 3.0))
    for law, expected in ((ContactLaw.TRUNCATED, end), (ContactLaw.PULLING, 5.0 * math.pi / 12.0)):
        spans = list(Contact(Play(BETWEEN, 3.0, 0.4, 1.0, law), distance)._without_memory())
        assert [side for *_, side in spans] == [1, -1]
        begins, ends = ([span[place] for span in spans] for place in (0, 1))
        assert begins == pytest.approx([math.pi / 12.0, math.pi / 12.0 + math.pi / 2.0])
        assert ends == pytest.approx([expected, expected + math.pi / 2.0])


def stepped(part: Play | Stop, distance: Waveform, steps: int = 12_000) -> list[tuple[float, float, int]]:
    """Step a spring and a damper beside it through two periods: contacts that begin in the second."""
    rate, h = part.stiffness / part.damping, distance.period / steps
    half = 0.5 * part.gap
    offsets = {1: half, -1: -half} if isinstance(part, Play) else {1: part.gap}
    times = h * np.arange(3 * steps)
    s, slope = distance.at(times).tolist(), distance.slope(times).tolist()
    z = max(s[0] - offsets[1], 0.0) + (min(s[0] - offsets[-1], 0.0) if -1 in offsets else 0.0)
    side, begun, found = int(np.sign(z)), 0.0, []
    for place, time in enumerate(times.tolist()):
        if side:
            z = s[place] - offsets[side]
            if (part.stiffness * z + part.damping * slope[place]) * side < 0.0:
                found.append((begun, time, side))
                side = 0
        else:
            z *= math.exp(-rate * h)
            for each, offset in offsets.items():
                if (s[place] - offset - z) * each > 0.0:
                    side, begun = each, time
    return [span for span in found if distance.period <= span[0] < 2.0 * distance.period]


@pytest.mark.parametrize(
    "coefficients", [[0.0, -1j], [0.2, 1.0], [-0.3, -0.9], [0.1, 0.6 - 0.2j, 0.5j], [0.9, 0.4 + 0.5j]]
)
@pytest.mark.parametrize(
    "part",
    [
        Play(BETWEEN, 3.0, 0.004, 1.0, ContactLaw.RELAXING),
        Stop(BETWEEN, 3.0, 0.004, 0.4, ContactLaw.RELAXING),
        Play(BETWEEN, 3.0, 0.03, 0.6, ContactLaw.RELAXING),
    ],
)
def test_with_the_relaxing_law_contact_is_made_with_what_is_left_of_the_stretch(
    part: Play | Stop, coefficients: list[complex]
) -> None:
    distance = Waveform(np.array(coefficients, complex), 691.0)
    found = list(Contact(part, distance)._relaxing())
    expected = stepped(part, distance)
    assert [side for *_, side in found] == [side for *_, side in expected]
    for one, other in zip(found, expected, strict=True):
        assert one[:2] == pytest.approx(other[:2], abs=5e-4 * distance.period)


def test_a_side_that_was_just_released_is_sought_again_at_once() -> None:
    distance = Waveform(np.array([0.0, -1j]), 691.0)
    contact = Contact(Play(BETWEEN, 3.0, 0.004, 1.0), distance)
    at = math.asin(0.5) / 691.0
    nothing = Decay(0.0, 7.5, 0.0)
    assert contact._made(at - 5e-4, nothing, 1) == (pytest.approx(at), 1)
    # What was stretched by 2 lets contact be made in the next period only.
    slow = Decay(2.0, 150.0, 0.0)
    time, side = Contact(Stop(BETWEEN, 3.0, 0.004, 0.5), distance)._made(0.0, slow, 0)
    assert side == 1
    assert distance.period < time < 2.0 * distance.period
    assert math.sin(691.0 * time) - 2.0 * math.exp(-150.0 * time) == pytest.approx(0.5)


def moved(contact: Contact, begin: float, end: float) -> Harmonics:
    nothing = Harmonics(np.zeros(2, complex), *np.zeros((2, 2, 2), complex))
    return contact._with_onsets(nothing, 1, Pieces(np.array([begin]), np.array([end]), np.ones(1)))


def test_ends_at_which_the_distance_turns_do_not_move() -> None:
    """s = cos 2t turns at 0; at 0.06 its slope is -0.24, and the force jumps by -(0.5 s + 0.4 s')."""
    distance = Waveform(np.array([0.0, 1.0 + 0j]), 2.0)
    contact = Contact(Stop(BETWEEN, 0.5, 0.4, 0.3, ContactLaw.PULLING), distance)
    slope = -2.0 * math.sin(0.12)
    jump = -(0.5 * (math.cos(0.12) - 0.3) + 0.4 * slope)
    nothing = Harmonics(np.zeros(2, complex), *np.zeros((2, 2, 2), complex))
    expected = with_moving_ends(nothing, distance, np.array([0.06]), np.array([jump / slope]), np.ones(2))
    found = moved(contact, 0.0, 0.06)
    assert found.direct == pytest.approx(expected.direct)
    assert found.conjugate == pytest.approx(expected.conjugate)
    assert np.abs(found.direct).max() > 0.1


def test_a_jump_that_is_rounding_moves_no_end() -> None:
    """Of cos 2t, with an offset of 1, the force at 4.4e-10 is 0.4 s' = -7e-10, of 1.154 in all."""
    contact = Contact(
        Stop(BETWEEN, 0.3, 0.4, 1.0, ContactLaw.PULLING), Waveform(np.array([0.0, 1.0 + 0j]), 2.0)
    )
    assert not moved(contact, 4.4e-10, 4.4e-10).direct.any()
    assert moved(contact, 8e-10, 4.4e-10).direct.any()
