import math

import control
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.quick import quick
from tests.trimmer.balance.loops import GAP, THESIS_LOOP
from trimmer import FrictionBacklash, ViscousBacklash, WrongTypeError, identify_time_constant, limit_cycles
from trimmer.linear import UnsupportedSystemError, pin_model
from trimmer.thesis import TrimmerParameters


@pytest.mark.parametrize("time_constant", quick([0.0, 3e-5, 1e-3, 0.1, math.inf], 2, 4))
def test_the_time_constant_of_a_predicted_limit_cycle_is_found_again(time_constant: float) -> None:
    for cycle in limit_cycles(THESIS_LOOP, ViscousBacklash(GAP, time_constant)):
        found = identify_time_constant(THESIS_LOOP, GAP, cycle.frequency).time_constants
        nearest = min(found, key=lambda each: abs(each.amplitude / cycle.amplitude - 1))
        assert nearest.time_constant == pytest.approx(time_constant, rel=1e-8)
        assert nearest.amplitude == pytest.approx(cycle.amplitude, rel=1e-8)
        assert nearest.stable == cycle.stable


LOOPS = {
    "thesis": THESIS_LOOP,
    "thesis, both channels": pin_model(TrimmerParameters.thesis()),
    "as a fraction": control.tf([1000], [1, 2, 3, 1]),
    "with an integrator": control.tf([1], [1, 1, 0]),
    "that never oscillates": control.tf([0.1], [1, 1]),
}


@pytest.mark.parametrize("G", quick(LOOPS.values(), 2), ids=LOOPS)
def test_no_limit_cycle_of_any_load_lies_outside_the_bands(G: control.lti.LTI) -> None:
    bands = identify_time_constant(G, GAP, 1.0).bands
    cycles = [c for tau in np.geomspace(1e-8, 1e4, 13) for c in limit_cycles(G, ViscousBacklash(GAP, tau))]
    for cycle in cycles:
        assert any(band.holds(cycle.frequency) for band in bands)
    met = [band for band in bands if any(band.holds(cycle.frequency) for cycle in cycles)]
    assert met == list(bands)


@pytest.mark.parametrize("G", quick(LOOPS.values(), 3), ids=LOOPS)
def test_right_outside_a_band_there_is_no_time_constant_and_right_inside_there_is(G: control.lti.LTI) -> None:
    bands = identify_time_constant(G, GAP, 1.0).bands
    for band in bands:
        for end, inwards in ((band.lower, 1e-5), (band.upper, -1e-5)):
            if math.isnan(end.time_constant):
                continue
            (inside,) = identify_time_constant(G, GAP, end.frequency * (1 + inwards)).time_constants
            omega = 2 * math.pi * end.frequency
            loads = [math.atan(omega * tau) for tau in (inside.time_constant, end.time_constant)]
            assert loads[0] == pytest.approx(loads[1], abs=0.02)
            assert identify_time_constant(G, GAP, end.frequency * (1 - inwards)).time_constants == ()


def test_the_describing_functions_of_all_loads_cover_a_region_once() -> None:
    """The Jacobian determinant of N over u and ln gamma has one sign: then bands end at the border only."""
    for gamma in np.geomspace(1e-6, 1e6, 200):
        element = ViscousBacklash(1.0, gamma)
        u = float(element.domain(1.0)) * np.linspace(1e-3, 1 - 1e-3, 200)
        slopes = element.derivatives(1.0 / u, 1.0)
        assert ((slopes.by_u.conj() * slopes.by_log_omega).imag > 0).all()


@pytest.mark.slow
def test_two_millihertz_beside_the_limit_the_nearest_load_is_told() -> None:
    system = LOOPS["thesis, both channels"]
    limit = max(cycle.frequency for cycle in limit_cycles(system, FrictionBacklash(GAP)))
    beside = identify_time_constant(system, GAP, limit - 0.002)
    assert beside.time_constants == ()
    assert beside.intervals == ()
    assert not beside.success
    assert beside.message.startswith("no M/D gives a limit cycle within the uncertainty; the nearest")
    assert beside.nearest is not None
    assert beside.nearest.time_constant == 0.0
    assert beside.nearest.limit_cycle.frequency == pytest.approx(limit, rel=1e-12)
    within = identify_time_constant(system, GAP, limit - 0.002, frequency_uncertainty=0.33 / 2)
    (interval,) = within.intervals
    (at_the_end,) = identify_time_constant(system, GAP, limit - 0.002 + 0.33 / 2).time_constants
    assert interval.lowest == 0.0
    assert interval.frequencies[0] == pytest.approx(limit, rel=1e-12)
    assert interval.highest == pytest.approx(at_the_end.time_constant, rel=1e-9)
    assert within.success
    assert within.message == f"M/D within the uncertainty: 0 to {interval.highest:.6g} s"


@pytest.mark.slow
@settings(max_examples=10, deadline=None)
@given(st.floats(-8, 2), st.floats(340, 780), st.floats(0, 30))
def test_a_load_lies_in_an_interval_when_its_limit_cycle_has_such_a_frequency(
    exponent: float, frequency: float, uncertainty: float
) -> None:
    """Compared with the limit cycles of one load after the other."""
    tau = 10**exponent
    told = identify_time_constant(THESIS_LOOP, GAP, frequency, frequency_uncertainty=uncertainty)
    for cycle in limit_cycles(THESIS_LOOP, ViscousBacklash(GAP, tau)):
        within = [
            each
            for each in told.intervals
            if each.frequencies[0] <= cycle.frequency <= each.frequencies[1]
            and each.lowest * (1 - 1e-6) <= tau <= each.highest * (1 + 1e-6)
        ]
        assert bool(within) == (abs(cycle.frequency - frequency) <= uncertainty)


@pytest.mark.slow
def test_a_measured_range_over_a_whole_band_takes_every_load() -> None:
    told = identify_time_constant(THESIS_LOOP, GAP, 740.0, frequency_uncertainty=20.0)
    (interval,) = told.intervals
    assert (interval.lowest, interval.highest) == (0.0, math.inf)
    assert interval.frequencies == told.bands[-1].frequencies
    assert told.nearest is None


def test_a_loop_that_never_oscillates_has_no_nearest_load() -> None:
    told = identify_time_constant(LOOPS["that never oscillates"], GAP, 1.0, frequency_uncertainty=0.5)
    assert (told.success, told.bands, told.nearest) == (False, (), None)
    assert told.message == "no M/D gives a limit cycle at any frequency"


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        *(
            ((THESIS_LOOP, GAP, each), "frequency must be positive")
            for each in (0.0, -1.0, math.nan, math.inf)
        ),
        ((THESIS_LOOP, 0.0, 700.0), "gap must be positive"),
        ((control.tf([1, 0], [1]), GAP, 700.0), "more zeros than poles"),
        ((FrictionBacklash, GAP, 700.0), "FrictionBacklash"),
        ((THESIS_LOOP, "4e-5", 700.0), "gap must be a real number .*, not '4e-5'"),
        ((THESIS_LOOP, GAP, "700"), "frequency must be a real number .*, not '700'"),
        ((THESIS_LOOP, GAP, None), "frequency must be a real number .*, not None"),
        *(
            ((THESIS_LOOP, GAP, 700.0, each), "_uncertainty must be zero or positive and less than")
            for each in (-1.0, math.nan, 700.0, math.inf)
        ),
    ],
)
def test_what_cannot_be_identified_is_named(arguments, message: str) -> None:
    with pytest.raises((ValueError, WrongTypeError, UnsupportedSystemError), match=message):
        identify_time_constant(*arguments[:3], frequency_uncertainty=sum(arguments[3:]))


def test_an_identification_holds_what_was_given() -> None:
    (*_, given) = limit_cycles(THESIS_LOOP, ViscousBacklash(GAP, 2e-4))
    result = identify_time_constant(THESIS_LOOP, GAP, given.frequency, frequency_uncertainty=0.5)
    assert (result.frequency, result.frequency_uncertainty, result.gap) == (given.frequency, 0.5, GAP)
    for found in result.time_constants:
        cycle = found.limit_cycle
        assert cycle.frequency == pytest.approx(given.frequency)
        gain = complex(
            ViscousBacklash(GAP, found.time_constant).describing_function(cycle.amplitude, cycle.omega)
        )
        assert 1.0 + gain * complex(THESIS_LOOP(1j * cycle.omega)) == pytest.approx(0.0, abs=1e-9)
        again = result.limit_cycles_with(found.time_constant)
        assert any(each.amplitude == pytest.approx(cycle.amplitude) for each in again)
    constants = [found.time_constant for found in result.time_constants]
    assert constants == sorted(constants)
    assert any(each == pytest.approx(2e-4, rel=1e-8) for each in constants)
    (interval,) = result.intervals
    assert interval.lowest < 2e-4 < interval.highest
    assert interval.frequencies == pytest.approx((given.frequency - 0.5, given.frequency + 0.5))
    assert "amplitude" in repr(result.time_constants[0])


def test_the_time_constant_is_that_of_a_loop_made_for_it() -> None:
    """-1/G at 691 rad/s is made to be N of gap 1 and omega M/D = 0.7 at the amplitude 1.5."""
    omega, gamma, amplitude = 691.0, 0.7, 1.5
    wanted = -1.0 / complex(ViscousBacklash(1.0, gamma).describing_function(amplitude, 1.0))
    # (a s + b)/(s + omega)**2 has any value at j omega: its denominator is 2j omega**2.
    value = wanted * 2j * omega**2
    found = identify_time_constant(
        control.tf([value.imag / omega, value.real], [1.0, 2 * omega, omega**2]), 1.0, omega / (2 * math.pi)
    ).time_constants
    nearest = min(found, key=lambda each: abs(each.time_constant * omega - gamma))
    assert nearest.time_constant == pytest.approx(gamma / omega, rel=1e-9)
    assert nearest.amplitude == pytest.approx(amplitude, rel=1e-9)


def test_a_band_holds_its_ends() -> None:
    (*_, band) = identify_time_constant(THESIS_LOOP, GAP, 700.0).bands
    low, high = band.frequencies
    inside = [band.holds(each) for each in (0.999 * low, low, 0.5 * (low + high), high, 1.001 * high)]
    assert inside == [False, True, True, True, False]
    # It ends where friction or inertia alone oscillates.
    ends = [
        limit_cycles(THESIS_LOOP, ViscousBacklash(GAP, time_constant))[-1].frequency
        for time_constant in (0.0, math.inf)
    ]
    assert (low, high) == pytest.approx(ends, rel=1e-12)
    assert (band.lower.time_constant, band.upper.time_constant) == (0.0, math.inf)


@pytest.mark.parametrize(("sign", "count"), [(1.0, 1), (-1.0, 0)])
def test_a_band_may_end_where_the_pin_only_just_touches(sign: float, count: int) -> None:
    """1/G = ± size (s + 0.3 (s² + 1)) is imaginary at 1 rad/s alone, and of the size of N for gamma 0.8."""
    element = ViscousBacklash(1.0, 0.8)
    size = -element.describing_function(1.0 / (float(element.domain(1.0)) * (1 - 1e-12)), 1.0).imag
    G = control.tf([sign / size], [0.3, 1.0, 0.3])
    bands = identify_time_constant(G, GAP, 1.0).bands
    ends = [end for band in bands for end in (band.lower, band.upper)]
    touching = [end for end in ends if end.frequency == pytest.approx(1.0 / (2 * math.pi), rel=1e-6)]
    assert len(touching) == count
    for end in touching:
        assert end.time_constant == pytest.approx(0.8, rel=1e-5)
        assert end.limit_cycle is None
