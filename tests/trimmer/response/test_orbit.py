"""Exact periodic motions against digits and formulas that others computed."""

from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace

import numpy as np
import pytest

from tests.trimmer.response.mechanisms import body, example, twin
from trimmer import MechanismError, OrbitNotFoundError, UnsupportedMotionError, forced_orbit, simulate
from trimmer.mechanism import ContactLaw, Force, Link, Mechanism, Pin, Play, linear_matrices

LAWS = {ContactLaw.RELAXING: 2.933334121400e-3, ContactLaw.TRUNCATED: 2.933334121515e-3}
"""Peak to peak of the stroke, m: definition of the mechanism, computed twice by different means."""


def with_law(mechanism: Mechanism, law: ContactLaw) -> Mechanism:
    return replace(mechanism, plays={name: replace(play, law=law) for name, play in mechanism.plays.items()})


@pytest.mark.parametrize("law", LAWS)
def test_the_trimmer_with_play_to_all_digits(law: ContactLaw) -> None:
    orbit = forced_orbit(with_law(twin(1.0), law))
    stroke = orbit.measures.outputs["stroke"]
    assert orbit.success, orbit.message
    assert (orbit.stable, orbit.period_count, orbit.events_per_period) == (True, 1, 14)
    assert stroke.peak_to_peak == pytest.approx(LAWS[law], rel=4e-13)
    assert stroke.harmonics[[0, 2, 4]] == pytest.approx(
        [1.50471470358e-3, 1.14721349311e-4, 3.3929164589e-5], rel=1e-10
    )
    assert stroke.harmonics[1:8:2].max() < 1e-15
    assert orbit.measures.rms_acceleration["motor"] == pytest.approx(118.754895, abs=6e-7)


def test_the_trimmer_whose_contact_pulls() -> None:
    stroke = forced_orbit(with_law(twin(1.0), ContactLaw.PULLING)).measures.outputs["stroke"]
    assert stroke.peak_to_peak == pytest.approx(2.93306e-3, abs=5e-9)


@pytest.mark.parametrize(
    ("ratio", "friction", "amplitude"),
    [(0.7, 0.2, 1.927774517940), (1.2, 0.5, 1.657467471056), (2.0, 0.3, 0.297676184992)],
)
def test_den_hartog(ratio: float, friction: float, amplitude: float) -> None:
    mechanism = example("den-hartog", frequency=ratio / (2 * np.pi), frictions__floor__force=friction)
    orbit = forced_orbit(mechanism)
    assert orbit.measures.outputs["block"].peak_to_peak / 2 == pytest.approx(amplitude, abs=6e-13)
    assert orbit.measures.frictions["floor"].work == pytest.approx(4 * friction * amplitude, rel=1e-12)


def test_a_block_on_a_belt_has_its_own_period() -> None:
    orbit = forced_orbit(example("block-on-belt"))
    stick = orbit.measures.frictions["rubbing"].stick
    assert orbit.stable
    assert orbit.period == pytest.approx(8.902605407815, abs=6e-13)
    assert stick * orbit.period == pytest.approx(5, abs=1e-12)
    assert (1 - stick) * orbit.period == pytest.approx(3.902605407815, abs=6e-13)
    assert orbit.measures.outputs["block"].peak_to_peak / 2 == pytest.approx(0.538516480713, abs=6e-13)
    assert abs(orbit.multipliers) == pytest.approx([1, 0], abs=1e-12)


def test_a_linear_mechanism_has_the_complex_response() -> None:
    mechanism = example("thesis")
    orbit = forced_orbit(mechanism)
    matrices, omega = linear_matrices(mechanism), 2j * np.pi * mechanism.frequency
    dynamic = matrices.mass * omega**2 + matrices.damping * omega + matrices.stiffness
    # The pin moves as a sine.
    pin = -1j * np.array([each.amplitude for each in mechanism.pins.values()])
    q = np.linalg.solve(dynamic, (matrices.pin_displacement + omega * matrices.pin_velocity) @ pin)
    names = list(mechanism.bodies)
    (name,) = mechanism.outputs
    weights = mechanism.outputs[name].weights
    expected = sum(weight * q[names.index(body)] for body, weight in weights.items())
    found = orbit.measures.outputs[name]
    assert found.amplitudes[0] == pytest.approx(expected, rel=1e-11)
    assert found.harmonics[1:].max() < 1e-11 * abs(expected)
    assert found.rms == pytest.approx(abs(expected) / np.sqrt(2), rel=1e-11)
    assert found.peak_to_peak == pytest.approx(2 * abs(expected), rel=1e-11)
    accelerations = {body: abs(omega**2 * each) / np.sqrt(2) for body, each in zip(names, q, strict=True)}
    assert orbit.measures.rms_acceleration == pytest.approx(accelerations, rel=1e-11)
    assert orbit.events_per_period == 0


def test_three_periods_are_found_and_six_are_said_to_be_three() -> None:
    mechanism = twin(2.0, 2e-4)
    three, six = (forced_orbit(mechanism, periods=count, settling=300) for count in (3, 6))
    assert (three.period_count, six.period_count) == (3, 3)
    assert six.message == "a stable motion that repeats after 3 drive periods already, not 6"
    assert abs(six.multipliers[:2]) == pytest.approx(abs(three.multipliers[:2]) ** 2, rel=1e-9)
    stroke, longer = three.measures.outputs["stroke"], six.measures.outputs["stroke"]
    assert [line[:2] for line in stroke.lines[:4]] == [(1, 3), (2, 3), (3, 3), (4, 3)]
    assert stroke.subharmonics.min() > 1e-6
    assert np.allclose(longer.amplitudes, stroke.amplitudes, rtol=0, atol=1e-13)


def test_an_unstable_motion_is_found_and_said_to_be_so() -> None:
    orbit = forced_orbit(twin(2.0, 2e-4), settling=200)
    assert orbit.success
    assert not orbit.stable
    assert orbit.message.startswith("an unstable motion")
    again = forced_orbit(twin(2.0, 2e-4), guess=1.0000001 * orbit.instant.state)
    assert again.instant.state == pytest.approx(orbit.instant.state, rel=1e-9)


@pytest.mark.parametrize("name", ["thesis-play", "held", "foil-shaver", "servo"])
def test_work_and_losses_of_a_period_are_equal(name: str) -> None:
    orbit = forced_orbit(example(name))
    energy = simulate(orbit.mechanism, orbit.period, state=orbit.instant.state).energy
    assert orbit.success
    assert energy.residual < 1e-10
    assert energy.work == pytest.approx(energy.loss, rel=1e-9)
    for friction, measured in orbit.measures.frictions.items():
        part = orbit.mechanism.frictions[friction]
        if part.viscous == 0:
            assert measured.work == pytest.approx(energy.frictions[friction], rel=1e-10)


def test_an_orbit_asked_for_again_is_that_of_a_machine_that_nothing_is_known_of() -> None:
    again, other = twin(1.0), twin(0.5)
    guess = 1.01 * forced_orbit(again).instant.state
    forced_orbit(other, guess=guess)  # Meets the modes in another order.
    with ThreadPoolExecutor() as pool:
        beside = pool.submit(forced_orbit, again, guess=guess).result()
    known, fresh = forced_orbit(again, guess=guess), forced_orbit(twin(1.0), guess=guess)
    for orbit in (beside, known, forced_orbit(again, guess=guess)):
        assert orbit.instant.state.tobytes() == fresh.instant.state.tobytes()
        assert orbit.multipliers.tobytes() == fresh.multipliers.tobytes()
        assert orbit.measures.peak_to_peak == fresh.measures.peak_to_peak
    assert again == twin(1.0)


def test_what_cannot_repeat_is_named() -> None:
    links = {"rope": Link(("winch", "body"), 1.0), "post": Link(("ground", "body"), 1.0)}
    pulled = body(pins={"winch": Pin("ground", velocity=1.0)}, links=links)
    with pytest.raises(UnsupportedMotionError, match="goes on for ever"):
        forced_orbit(pulled)
    damped = body(links={"spring": Link(("ground", "body"), 1.0, 0.1)}, start={"body": (1.0, 0.0)})
    with pytest.raises(OrbitNotFoundError, match="comes to rest"):
        forced_orbit(damped)


def test_a_guess_that_does_not_fit_is_named() -> None:
    with pytest.raises(MechanismError, match="9 states"):
        forced_orbit(twin(), guess=np.zeros(4))


def test_harmonics_of_a_slow_wave_are_exact_at_any_order() -> None:
    push = {"push": Force("body", amplitude=1.0, order=20)}
    mechanism = body(frequency=1e-3, links={"spring": Link(("ground", "body"), 1.0, 0.5)}, forces=push)
    amplitudes = forced_orbit(mechanism).measures.outputs["body"].harmonics
    omega = 20 * 2 * np.pi * 1e-3
    assert amplitudes[19] == pytest.approx(1 / abs(1 - omega**2 + 0.5j * omega), rel=1e-10)
    assert amplitudes[:19].max() < 1e-11


def test_a_relaxing_spring_a_hair_beyond_its_slot_does_not_chatter() -> None:
    slot = {"slot": Play(("ground", "body"), 1e4, 100.0, 0.2)}
    mechanism = body(frequency=1.0, plays=slot, forces={"push": Force("body", constant=500.0)})
    # The spring is stretched, and the body moves back faster than it relaxes, but is pushed towards contact.
    motion = simulate(mechanism, 1.0, state=[0.12 + 1e-10, -5.0, 0.02])
    assert motion.success
    assert len(motion.events) < 20
