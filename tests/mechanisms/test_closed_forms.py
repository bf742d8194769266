"""The forms on paper give the digits of the definition's table, and the event-driven one holds its digits."""

from __future__ import annotations

import mpmath
import pytest
from mpmath import mp, mpf

from tests.mechanisms import closed_forms
from tests.mechanisms.oscillator_events import Oscillator, with_friction, with_stop
from trimmer.mechanism.parts import ContactLaw


def digits(value: mpf, printed: str) -> bool:
    """Whether a number rounds to the printed one."""
    return mpmath.nstr(value, len(printed.lstrip("0.").replace(".", ""))) == printed


@pytest.mark.parametrize(
    ("ratio", "force", "printed"),
    [(0.7, 0.2, "1.92777451794"), (1.2, 0.5, "1.657467471056"), (2, 0.3, "0.297676184992")],
)
def test_den_hartog(ratio, force, printed):
    assert abs(closed_forms.den_hartog_amplitude(ratio, force) - mpf(printed)) < 6e-13


def test_block_on_a_belt():
    motion = closed_forms.block_on_belt(1, 1, 1, 0.5, 0.2)
    assert digits(motion.amplitude, "0.538516480713")
    assert digits(motion.slip, "3.902605407815")
    assert abs(motion.stick - 5) < 1e-14
    assert digits(motion.period, "8.902605407815")


@pytest.mark.parametrize(
    ("zeta", "printed"), [(0.1, "0.744079397722"), (0.3, "0.450975452893"), (0.6, "0.248840580378")]
)
def test_rebound(zeta, printed):
    assert digits(closed_forms.rebound_ratio(zeta), printed)


def test_the_oscillator_rebounds_as_the_closed_form_says():
    with mp.workdps(40):
        zeta = mpf(3) / 10
        thrown = Oscillator(1, 0, mpf(10) ** -60, 0, mpf(1))
        motion = with_stop(thrown, (1, 2 * zeta, 0), ContactLaw.TRUNCATED, (mpf(-1) / 8, 1), mpf(4))
        assert abs(motion.velocity + closed_forms.rebound_ratio(zeta)) < 1e-28


@pytest.mark.slow
@pytest.mark.parametrize("law", ContactLaw)
def test_twenty_digits_of_event_times_do_not_depend_on_the_working_precision(law):
    shorter, longer = (times(law, digits) for digits in (30, 45))
    assert len(shorter) > 8
    assert max(abs(a - b) for a, b in zip(shorter, longer, strict=True)) < 1e-20


def times(law: ContactLaw, working_digits: int) -> list[mpf]:
    with mp.workdps(working_digits):
        driven = Oscillator(1.0, 0.25, 4.0, 3.0, mpf(3))
        stopped = with_stop(driven, (50.0, 2.0, 0.25), law, (0, 0), mpf(7))
        rubbed = with_friction(replace_amplitude(driven), 1.0, 1.25, (0, 0.5), mpf(7))
        return [*stopped.made, *stopped.broken, *rubbed.begun, *rubbed.ended]


def replace_amplitude(oscillator: Oscillator) -> Oscillator:
    return Oscillator(
        oscillator.mass, oscillator.damping, oscillator.stiffness, 2.0, mpf(3) / 4, oscillator.phase
    )


@pytest.mark.parametrize("printed", ["0.6534401404", "0.581899639"])
def test_two_bodies_graze_their_stop(printed):
    k, c = [[1, -1], [-1, 2]], [[0.03, -0.03], [-0.03, 0.06]]
    omega = closed_forms.grazing_omega([1, 1], c, k, lambda _: [0, 0.1], (0, 1), mpf(printed))
    assert digits(omega, printed)


@pytest.mark.parametrize("printed", ["5.534678554", "6.997666276"])
def test_one_body_grazes_its_stop(printed):
    damping = mpf("0.1") * mpmath.sqrt(40)
    omega = closed_forms.grazing_omega([1], [[damping]], [[40]], lambda _: [100], (0, 10), mpf(printed))
    assert digits(omega, printed)


@pytest.mark.parametrize("printed", ["0.8206310877", "1.407088466"])
def test_contact_with_a_dead_zone_is_lost(printed):
    """It rests at 1.1, 0.1 beyond the zone."""

    def forces(omega):
        return [mpf("0.05") * omega**2]

    omega = closed_forms.grazing_omega([1], [[mpf("0.1")]], [[1]], forces, (0, mpf("0.1")), mpf(printed))
    assert digits(omega, printed)
