"""What is not certain is reported: tangency, a continuum, poles on the axis, the ends of the axis."""

import math
import warnings

import control
import mpmath
import numpy as np
import pytest

from tests.trimmer.balance.loops import GAP, THESIS_LOOP, s
from tests.trimmer.elements.oracle import ExactBacklash
from trimmer import UndecidedWarning, harmonic_balance, limit_cycles
from trimmer.elements import CoulombFriction, FrictionBacklash, InertiaBacklash, Relay, ViscousBacklash


def test_a_continuum_is_reported_and_not_enumerated() -> None:
    # G = 1/(s^2+1) is real at all frequencies and negative above 1.
    balance = harmonic_balance(1 / (s**2 + 1), Relay(1.0), omega_range=(0.1, 10.0))
    assert balance.limit_cycles == ()
    assert balance.certificate.winding_number is None
    lowest = min(region.omegas[0] for region in balance.certificate.undecided)
    highest = max(region.omegas[1] for region in balance.certificate.undecided)
    assert lowest == pytest.approx(1.0, rel=0.05)
    assert highest == pytest.approx(10.0, rel=1e-6)


@pytest.mark.parametrize(
    ("zeros", "poles"), [([-1] * 3, [-1.1] * 3 + [-1e5] * 3), ([-1e5] * 2, [-1.1e5] * 2)]
)
def test_one_in_state_space_is_as_certain_as_its_fraction(zeros: list[float], poles: list[float]) -> None:
    G = control.zpk(zeros, [*poles, -1, -1, -1], 1.0)
    fraction, states = (
        harmonic_balance(each, Relay(1.0)).certificate for each in (control.tf(G), control.ss(G))
    )
    assert fraction.complete and states.complete
    assert states.omegas == pytest.approx(fraction.omegas, rel=1e-3)  # Threefold roots are known to 1e-5.


TWICE = FrictionBacklash(1.0) + FrictionBacklash(1.0)
NEARLY_AT_THE_EDGE = control.tf([-1e18], [1, 3, 3, 1, 0, 0])


@pytest.mark.parametrize(
    ("G", "element", "omegas", "told"),
    [
        (1 / (s**2 + 1), Relay(1.0), (0.1, 10.0), "touch or coincide"),
        (1 / s**2, Relay(1.0), None, "touch or coincide|are not excluded; give omega_range"),
        (NEARLY_AT_THE_EDGE, FrictionBacklash(1.0), None, "not excluded, next to a pole of G on the imagin"),
        (10 / (s * (s + 1)), TWICE, None, "are not excluded"),
        # -1/G = -j omega/K is imaginary, and so is the N of a load that is touched for no time at all.
        (s / (s**2 + 1), ViscousBacklash(1.0, 0.5), None, "where N ends"),
        (control.tf([1], np.poly(-np.arange(1.0, 51.0))), Relay(1.0), None, "does not tell its poles and z"),
    ],
)
def test_what_is_undecided_is_warned_of(G, element, omegas, told: str) -> None:
    with pytest.warns(UndecidedWarning, match=told):
        limit_cycles(G, element, omega_range=omegas)
    certificate = harmonic_balance(G, element, omegas).certificate
    assert not certificate.complete and certificate.doubts


def test_each_continuum_is_a_region_of_its_own() -> None:
    """1/((s² + 1)(s² + 9)(s² + 25)) is negative from 1 to 3 rad/s and from 5 rad/s on."""
    system = 1 / ((s**2 + 1) * (s**2 + 9) * (s**2 + 25))
    regions = harmonic_balance(system, Relay(1.0), omega_range=(0.1, 10.0)).certificate.undecided
    ends = [each.omegas for each in sorted(regions, key=lambda each: each.omegas)]
    assert ends == [pytest.approx((1.0, 3.0), rel=0.01), pytest.approx((5.0, 10.0), rel=0.01)]


def tangency() -> tuple[float, float, float]:
    """K, omega and gap/A where the curves of K/(s(s+1)) and backlash touch, to 15 of 30 digits."""
    with mpmath.workdps(30):

        def gain(u):
            c = 1 - u
            real = (mpmath.pi / 2 + mpmath.asin(c) + c * mpmath.sqrt(1 - c**2)) / mpmath.pi
            return mpmath.mpc(real, -u * (2 - u) / mpmath.pi)

        def conditions(K, omega, u):
            inverse, slope = mpmath.mpc(-(omega**2), omega) / K, mpmath.mpc(-2 * omega, 1) / K
            excess, by_u = gain(u) + inverse, mpmath.diff(gain, u)
            return excess.real, excess.imag, (by_u * mpmath.conj(slope)).imag

        return tuple(map(float, mpmath.findroot(conditions, (3.417, 0.757, 1.55), tol=1e-20)))


def test_a_tangency_is_undecided_and_its_neighbours_are_none_or_two_that_are_flagged() -> None:
    K, omega, u = tangency()
    element = FrictionBacklash(1.0)
    below = harmonic_balance((1 - 1e-3) * K / (s * (s + 1)), element)
    assert below.limit_cycles == ()
    assert below.certificate.complete
    above = harmonic_balance((1 + 1e-3) * K / (s * (s + 1)), element)
    assert above.certificate.complete
    assert len(above.limit_cycles) == 2
    assert all(cycle.near_tangency for cycle in above.limit_cycles)
    assert sorted(cycle.index for cycle in above.limit_cycles) == [-1, 1]
    (region,) = harmonic_balance(K / (s * (s + 1)), element).certificate.undecided
    assert region.omegas[0] <= omega <= region.omegas[1]
    assert region.amplitudes[0] <= 1 / u <= region.amplitudes[1]
    assert region.omegas[1] / region.omegas[0] < 1.01
    with pytest.warns(UndecidedWarning, match="touch or coincide"):
        limit_cycles(K / (s * (s + 1)), element)


def test_a_solution_at_the_corner_of_four_boxes_is_found_once() -> None:
    """gap/A = 1 and 1 rad/s lie in the middle of what is searched, where it is cut into halves of halves."""
    inverse = -complex(FrictionBacklash(1.0).describing_function(1.0))
    # 1/G = (s² + a s + b) k with a b that gives this at s = j.
    system = control.tf([1.0], [1.0, inverse.imag, 1.0 + inverse.real])
    balance = harmonic_balance(system, FrictionBacklash(1.0), (math.exp(-1.0), math.e))
    nearest = [each for each in balance.limit_cycles if abs(each.omega - 1.0) < 1e-3]
    assert [(each.amplitude, each.omega) for each in nearest] == [pytest.approx((1.0, 1.0), rel=1e-9)]
    assert balance.certificate.complete


def test_a_hidden_undamped_mode_is_passed_over_or_undecided() -> None:
    third_order = 20 / (s + 1) ** 3
    hidden = third_order * (s**2 + 0.25) / (s**2 + 0.25)
    expected = limit_cycles(third_order, FrictionBacklash(1.0))
    balance = harmonic_balance(hidden, FrictionBacklash(1.0))
    assert [cycle.omega for cycle in balance.limit_cycles] == pytest.approx(
        [c.omega for c in expected], rel=1e-6
    )
    assert all(region.omegas[0] <= 0.5 <= region.omegas[1] for region in balance.certificate.undecided)


@pytest.mark.parametrize(
    "element", [FrictionBacklash(1.0), ViscousBacklash(1.0, 0.5), -2.0 * FrictionBacklash(1.0)]
)
@pytest.mark.parametrize(
    "G",
    [
        10 / (s + 1) ** 3,
        10 / (s * (s + 1)),
        -1 / s**3 / (s + 1),
        (s + 2) / (s**2 + 1) / (s + 1),
        5 / s**2 / (s + 3),
    ],
)
def test_all_amplitudes_are_covered(element, G) -> None:
    """Also where G is infinite on the imaginary axis and N vanishes at the edge of the dead band."""
    balance = harmonic_balance(G, element)
    assert balance.certificate.smallest_gain == 0
    assert balance.certificate.complete
    assert balance.confirmed


@pytest.mark.parametrize("gain", [1e3, 1e5, 1e6, 1e8])
def test_a_limit_cycle_next_to_the_edge_is_found_beside_a_double_integrator(gain: float) -> None:
    """Against 40 digits: N in closed form from the angle of contact, so that no digits cancel."""
    G = control.tf([-gain], [1, 3, 3, 1, 0, 0])
    with mpmath.workdps(40):

        def balance(log_l, omega):
            angle = mpmath.exp(log_l)
            sine = mpmath.sin(angle)
            N = mpmath.mpc(angle - sine * mpmath.cos(angle), -(sine**2)) / mpmath.pi
            jw = mpmath.mpc(0, omega)
            excess = N * gain / (jw**2 * (1 + jw) ** 3) - 1
            return excess.real, excess.imag

        start = mpmath.log(mpmath.sqrt(mpmath.pi * 0.5 / gain))
        log_l, omega = mpmath.findroot(balance, (start, 0.58), tol=1e-25)
        margin = mpmath.sin(mpmath.exp(log_l) / 2) ** 2  # u = 1 + cos l
        amplitude = 1 / (2 * (1 - margin))
    result = harmonic_balance(G, FrictionBacklash(1.0))
    (cycle,) = result.limit_cycles
    assert cycle.omega == pytest.approx(float(omega), rel=1e-4)  # the triple pole has five digits
    assert cycle.amplitude - 0.5 == pytest.approx(float(amplitude - 0.5), rel=1e-3)
    assert result.certificate.complete


def test_what_is_too_near_to_the_edge_is_not_called_complete() -> None:
    assert harmonic_balance(NEARLY_AT_THE_EDGE, FrictionBacklash(1.0)).certificate.smallest_gain > 0


def test_an_n_of_which_nothing_is_known_next_to_a_pole_is_not_called_complete() -> None:
    assert 0 < harmonic_balance(10 / (s * (s + 1)), TWICE).certificate.smallest_gain < 1e-9
    away = harmonic_balance(10 / (s * (s + 1)), TWICE, omega_range=(0.01, 100.0))
    assert away.certificate.smallest_gain == 0
    assert away.certificate.complete


NEAR_THE_EDGE = control.tf(
    [43179.78679190458, 8221.052566433806, 243.32724108576767, -454.93549455118676, -157.51904373957302,
     16.522659263032217],
    [1, 0.14943382073696956, 49.464694834870016, 4.99841593936363, 485.0736371619471, 1.7073680591122502,
     7.710184382233277],
)  # fmt: skip


def test_a_transversal_solution_near_the_edge_of_the_domain_is_found() -> None:
    """Against quadrature in 40 digits; the curves cross at right angles, 1e-10 before N ends."""
    gap, time_constant = 1.03, 37.7
    balance = harmonic_balance(NEAR_THE_EDGE, ViscousBacklash(gap, time_constant))
    assert balance.certificate.complete
    (cycle,) = balance.limit_cycles
    assert cycle.crossing_angle > 1.5
    numerator, denominator = (
        [mpmath.mpf(float(c)) for c in side[0][0]] for side in (NEAR_THE_EDGE.num, NEAR_THE_EDGE.den)
    )

    def excess(ratio, omega):
        with mpmath.workdps(30):
            jw = mpmath.mpc(0, omega)
            N = ExactBacklash(ratio, time_constant * omega).describing_function(1)
            return N + mpmath.polyval(denominator, jw) / mpmath.polyval(numerator, jw)

    with mpmath.workdps(30):
        ratio, omega = gap / mpmath.mpf(cycle.amplitude), mpmath.mpf(cycle.omega)
        step = mpmath.mpf("1e-7")
        here = excess(ratio, omega)
        by_u = (here - excess(ratio - step, omega)) / step
        by_omega = (excess(ratio, omega * (1 + step)) - here) / step
        sine = (by_u * mpmath.conj(by_omega)).imag / abs(by_u) / abs(by_omega)
    # At right angles either is off by no more than all of the rest would make it.
    assert abs(abs(sine) - 1) < 1e-3
    assert abs(here) < 1e-12 * min(abs(by_u), abs(by_omega))


@pytest.mark.parametrize("element", [InertiaBacklash(1.0), FrictionBacklash(1.0) + CoulombFriction(0.5)])
def test_an_n_that_does_not_vanish_leaves_nothing_out(element) -> None:
    assert harmonic_balance(10 / (s * (s + 1)), element).certificate.smallest_gain == 0


def test_a_limit_cycle_next_to_the_edge_of_the_dead_band_is_found() -> None:
    # At its resonance at 1 rad/s G is about -j 1e8, so -1/G is -j 1e-8 and gap/A is 2 - pi/2 * 1e-8.
    (cycle,) = limit_cycles(1e4 / (s**2 + 1e-4 * s + 1), FrictionBacklash(1.0), (0.99, 1.01))
    assert cycle.amplitude - 0.5 == pytest.approx(math.pi / 8 * 1e-8, rel=1e-3)
    assert cycle.omega == pytest.approx(1.0, rel=1e-6)


def test_zero_frequency_and_infinite_amplitude_are_undecided_if_the_static_gain_is_minus_one() -> None:
    (region,) = harmonic_balance(-1 / (s + 1) ** 2, FrictionBacklash(1.0)).certificate.undecided
    assert region.omegas[1] < 1e-5
    assert region.amplitudes[0] > 1e5
    for static_gain in (-0.999, -1.001):
        assert harmonic_balance(static_gain / (s + 1) ** 2, FrictionBacklash(1.0)).certificate.complete


def test_next_to_a_double_integrator_a_relay_with_hysteresis_has_its_limit_cycle() -> None:
    """-1/G = w²/(0.01 (1 + j w)) is behind the axis by atan w, N of the relay by half of asin(1/A).

    Both go to zero with the same phase, and N is behind as well: so the phase alone excludes nothing.
    The solution below is that of SciPy's fsolve.
    """
    element = Relay(math.pi / 2.0, hysteresis=0.5, dead_zone=0.5)
    balance = harmonic_balance(0.01 * (s + 1) / s**2, element)
    (cycle,) = balance.limit_cycles
    assert (cycle.amplitude, cycle.omega) == pytest.approx((12.5399045, 0.0399363), rel=1e-6)
    assert balance.certificate.complete
    assert balance.confirmed


@pytest.mark.parametrize("size", [1.0, 1e-9, 1e7])
def test_a_range_is_proven_by_the_phase_of_few_roots(size: float) -> None:
    """With t = omega/size the phase of (1 + jt)**n is n t but for n t**3/(3 - 3 t**2); 1/2 is tried first.

    Where f starts out real and positive, as for 1/(s+1)**3 with a relay, it is enough that this is below pi;
    at high frequency f is imaginary, and 1.5 + 0.17 is not below pi/2, so that t = 1/4 is the first. Where it
    starts out real and negative, as for -1/(s+1)**2, the phase leaves pi at once, and is not there again. For
    -(s+1.1)/(s(s+1)) with friction it does so too, but with 0.09 t, which the remainder is below at t = 1/4.
    """
    for system, element, ends in (
        (control.tf([size**3], np.poly([-size] * 3)), Relay(1.0), (0.5, 4.0)),
        (control.tf([-(size**2)], np.poly([-size] * 2)), Relay(1.0), (0.5, 2.0)),
        (control.tf([-1.0, -1.1 * size], [1.0, size, 0.0]), CoulombFriction(1.0), (0.25, 4.4)),
    ):
        certificate = harmonic_balance(system, element).certificate
        assert certificate.omegas == pytest.approx(size * np.array(ends), rel=1e-4)
        assert certificate.outside_excluded


@pytest.mark.parametrize(("sign", "end", "omega"), [(-1.0, 0, 2e-6), (1.0, 1, 2e6)])
def test_where_nothing_is_proven_it_is_looked_a_million_times_beyond_the_roots(
    sign: float, end: int, omega: float
) -> None:
    """-1/(s**2 + 4) is real and positive at low frequencies, 1/(s**2 + 4) real and negative at high ones."""
    certificate = harmonic_balance(sign / (s**2 + 4), Relay(1.0)).certificate
    assert certificate.omegas[end] == pytest.approx(omega, rel=1e-9)
    assert not certificate.outside_excluded


def test_only_beyond_a_range_that_was_not_given_limit_cycles_may_be_missing() -> None:
    """The phase of (s + 3)/(s + 1)**3 nears -180 degrees with the third power of 1/w: no bound shows it."""
    system = (s + 3) / (s + 1) ** 3
    with pytest.warns(UndecidedWarning) as told:
        assert limit_cycles(system, Relay(1.0)) == ()
    assert "are not excluded; give omega_range" in str(told[-1].message)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert limit_cycles(system, Relay(1.0), omega_range=(0.1, 10.0)) == ()
        assert len(limit_cycles(1 / (s + 1) ** 3, Relay(1.0))) == 1


def test_an_omega_that_is_frozen_is_positive_and_finite() -> None:
    element = ViscousBacklash(GAP, 1.0)  # gamma is 0.5 at 0.5 rad/s, and 4600 at the frequency of the loop
    cycles = limit_cycles(THESIS_LOOP, element, frozen_omega=0.5)
    assert cycles
    for cycle in cycles:
        gain = complex(element.describing_function(cycle.amplitude, 0.5))
        assert 1.0 + gain * complex(THESIS_LOOP(1j * cycle.omega)) == pytest.approx(0.0, abs=1e-9)
    for wrong in (0.0, -1.0, math.inf, math.nan):
        with pytest.raises(ValueError, match="frozen_omega must be positive and finite"):
            limit_cycles(THESIS_LOOP, element, frozen_omega=wrong)
