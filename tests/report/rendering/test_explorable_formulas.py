"""The explorable: its formulas in a browser are those of Python, its solutions those of the library."""

import math

import numpy as np
import pytest
import sympy

from derivations.linear_trimmer import derive_linear_trimmer
from report.explorable.formulas import functions
from report.explorable.script import script
from report.folders import templates
from report.numbers.friction_in_place import force_response, largest_force
from report.numbers.linear_numbers import exact_values
from tests.quick import quick
from tests.report.rendering.page_checks import opened
from trimmer import FrictionBacklash, ViscousBacklash, limit_cycles, pin_model, response_at, transfer_function
from trimmer.elements.backlashes.contact_equation import steady_motion
from trimmer.thesis import InputChannels, TrimmerParameters

CLOSE = 1e-12
PARAMETERS = TrimmerParameters.thesis()
PIN = InputChannels.DISPLACEMENT_ONLY
POINTS = [(flight, gamma) for flight in (0.3, 0.9, 1.7, 2.6, 3.1) for gamma in (0.02, 0.3, 1.25, 4.7, 60.0)]
FREQUENCIES = (60.0, 206.0, 227.0, 354.0, 480.0, 549.0, 612.0, 733.63, 1139.0, 1500.0)


@pytest.fixture(scope="module")
def printed():
    return functions(derive_linear_trimmer(), exact_values(PARAMETERS))


@pytest.fixture(scope="module")
def page(printed, browser):
    code = script(printed) + (templates() / "explorable.js").read_text(encoding="utf-8")
    with opened(browser) as visit:
        visit.page.add_script_tag(content=code)
        yield visit.page
        assert visit.complaints == []


def in_page(page, name: str, *arguments: float) -> dict[str, float]:
    return page.evaluate(f"(given) => explorableFormulas.{name}(...given)", list(arguments))


def solved(page, **settings: float) -> list[dict]:
    whole = {"gap": 2e-4, "load": 1e-3, "damping": PARAMETERS.c2, "force": 0.0, "share": 0.0} | settings
    return page.evaluate("(settings) => explorableModel(explorableFormulas).solve(settings)", whole)


@pytest.mark.browser
@pytest.mark.parametrize(("damping", "share"), [(0.4, 0.0), (0.4, 1.0), (1.3, 0.0), (1.3, 1.0), (0.05, 1.0)])
def test_responses_are_those_of_the_library(page, damping, share):
    """The inverse of that to the pin, and that to friction of cutter on guard, relative to the pin's."""
    parameters = TrimmerParameters(**{**vars(PARAMETERS), "c2": damping})
    channels = InputChannels.DISPLACEMENT_AND_VELOCITY if share else PIN
    pin, pair = transfer_function(parameters, channels=channels), force_response(parameters)
    for omega in (2 * math.pi * frequency for frequency in FREQUENCIES):
        to_pin = complex(response_at(pin, omega))
        rubbing = parameters.k2 * complex(response_at(pair, omega)) / to_pin
        for name, expected, close in (("inverseResponse", 1 / to_pin, CLOSE), ("rubbing", rubbing, 1e-9)):
            found = in_page(page, name, omega, damping, share)
            assert abs(complex(found["real"], found["imaginary"]) / expected - 1) < close


@pytest.mark.browser
def test_backlash_is_that_of_the_library(page):
    for flight, gamma in POINTS:
        found = in_page(page, "element", flight, gamma)
        element = ViscousBacklash(found["ratio"], gamma)
        gain = complex(element.describing_function(1.0, 1.0))
        assert abs(complex(found["real"], found["imaginary"]) - gain) < CLOSE
        motion = steady_motion(found["ratio"], np.array([1.0]), np.array([gamma]))
        assert float(motion.flight[0]) == pytest.approx(flight, rel=CLOSE)


@pytest.mark.browser
def test_the_waveform_is_that_of_the_library(page):
    for flight, gamma in POINTS:
        at = in_page(page, "element", flight, gamma)
        element = ViscousBacklash(at["ratio"], gamma)
        middle = at["separation"] + flight / 2
        later = at["separation"] + (flight + math.pi) / 2
        for name, phase in (("flight", middle), ("contact", later)):
            position = in_page(page, name, phase, gamma, at["ratio"])["position"]
            expected = float(element.waveform(np.array([phase]), 1.0, 1.0)[0])
            assert position == pytest.approx(expected, rel=CLOSE, abs=CLOSE)


@pytest.mark.browser
def test_every_function_is_that_of_forty_digits(page, printed):
    values = {"omega": 4609.5, "c_2": 0.4, "share": 0.7, "lambda": 0.61, "gamma": 4.6}
    values |= {"F_c": 0.3, "A": 1.4e-3, "theta": 1.1, "g": 0.7}
    for function in printed:
        given = [sympy.Float(values[argument.name], 40) for argument in function.arguments]
        found = in_page(page, function.name, *(values[argument.name] for argument in function.arguments))
        for name, expected in exactly(function, given).items():
            assert found[name] == pytest.approx(float(expected), rel=CLOSE, abs=1e-14), (function.name, name)


def exactly(function, given):
    """Evaluate a function in Python, to forty digits."""
    known = dict(zip(function.arguments, given, strict=True))
    expm1 = sympy.Function("expm1")
    for symbol, value in function.given:
        plain = value.replace(expm1, lambda exponent: sympy.exp(exponent) - 1)
        known[symbol] = plain.subs(known).evalf(40)
    return {name: value.subs(known).evalf(40) for name, value in function.results.items()}


@pytest.mark.browser
@pytest.mark.parametrize("load", quick([1e-6, 3e-5, 1e-4, 1e-3, 1e-2, 0.1], 1, 3))
@pytest.mark.parametrize("share", [0.0, 1.0])
def test_the_limit_cycles_are_those_of_the_library(page, load, share):
    channels = InputChannels.DISPLACEMENT_AND_VELOCITY if share else InputChannels.DISPLACEMENT_ONLY
    system = transfer_function(PARAMETERS, channels=channels)
    expected = limit_cycles(system, ViscousBacklash(2e-4, load))
    found = solved(page, load=load, share=share)
    assert [each["stable"] for each in found] == [cycle.stable for cycle in expected]
    for each, cycle in zip(found, expected, strict=True):
        assert each["omega"] == pytest.approx(cycle.omega, rel=CLOSE)
        assert each["amplitude"] == pytest.approx(cycle.amplitude, rel=CLOSE)


@pytest.mark.browser
def test_friction_ends_the_limit_cycle_and_the_gap_only_scales_it(page):
    small, large = solved(page, gap=4e-6), solved(page, gap=4e-4)
    assert [each["omega"] for each in small] == pytest.approx([each["omega"] for each in large], rel=1e-12)
    assert large[0]["amplitude"] == pytest.approx(100 * small[0]["amplitude"], rel=1e-10)
    unstable, stable = limit_cycles(pin_model(PARAMETERS, channels=PIN), FrictionBacklash(1.0))
    most = 2e-4 * largest_force(PARAMETERS, PIN, unstable, stable).force_per_gap
    # The load of the page is not quite without mass: its flight shifts the force by less than a hundredth.
    assert len(solved(page, load=1e-6, force=0.98 * most)) == 2
    assert solved(page, load=1e-6, force=1.02 * most) == []


def test_the_formulas_are_small_and_hold_no_foreign_code(printed):
    text = script(printed)
    assert len(text) < 20_000
    assert "Not supported" not in text
    assert all(f"  {function.name}(" in text for function in printed)
