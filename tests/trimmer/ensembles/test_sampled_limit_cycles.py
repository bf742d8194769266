"""Limit cycles of many trimmers against ``limit_cycles`` of each, and what must hold without it."""

import warnings
from dataclasses import asdict

import numpy as np
import pytest

from tests.quick import examples, quick
from trimmer import FrictionBacklash, TrimmerParameters, limit_cycles, pin_model
from trimmer.ensembles import sampled_limit_cycles
from trimmer.ensembles.limit_cycles import BLOCK
from trimmer.thesis import ParameterError

THESIS = asdict(TrimmerParameters.thesis())


def random_samples(seed: int, count: int, spread: float) -> tuple[dict[str, np.ndarray], np.ndarray]:
    random = np.random.default_rng(seed)
    samples = {name: value * np.exp(random.uniform(-spread, spread, count)) for name, value in THESIS.items()}
    return samples, 10 ** random.uniform(-6, -3, count)


def one_by_one(samples, gaps, output: str, channels: str) -> list[list[tuple[float, float, bool]]]:
    found = []
    for row, gap in enumerate(gaps):
        parameters = TrimmerParameters(**{name: float(values[row]) for name, values in samples.items()})
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            cycles = limit_cycles(pin_model(parameters, output, channels), FrictionBacklash(float(gap)))
        found.append(sorted((c.omega, c.amplitude, c.stable) for c in cycles))
    return found


def assert_same(found, expected) -> None:
    assert found.count.tolist() == [len(cycles) for cycles in expected]
    for row, cycles in enumerate(expected):
        for column, (omega, amplitude, stable) in enumerate(cycles):
            assert found.omega[row, column] == pytest.approx(omega, rel=1e-9)
            assert found.amplitude[row, column] == pytest.approx(amplitude, rel=1e-8)
            assert found.stable[row, column] == stable
        assert np.isnan(found.omega[row, len(cycles) :]).all()
        assert not found.stable[row, len(cycles) :].any()


@pytest.mark.parametrize("channels", ["both", "displacement"])
@pytest.mark.parametrize("spread", [0.1, 1.0])
@pytest.mark.parametrize("output", quick(["q2-q4", "q2-q3", "q4"], 0))
def test_they_are_those_of_each_trimmer(channels: str, spread: float, output: str) -> None:
    samples, gaps = random_samples(1, examples(24, 300), spread)
    found = sampled_limit_cycles(samples, gap=gaps, output=output, channels=channels)
    assert_same(found, one_by_one(samples, gaps, output, channels))


def test_the_thesis_has_its_two() -> None:
    found = sampled_limit_cycles({}, gap=4e-5)
    # README: 21.1 µm at 554.29 Hz, unstable; 175.2 µm at 728.40 Hz, stable.
    np.testing.assert_allclose(found.frequency, [[554.29, 728.40]], atol=5e-3)
    np.testing.assert_allclose(found.amplitude, [[21.1e-6, 175.2e-6]], atol=5e-8)
    assert found.stable.tolist() == [[False, True]]
    assert found.exists.tolist() == [True]


def test_poles_that_are_a_thousand_times_faster_are_found_too() -> None:
    light = {"m1": np.array([1e-7 * THESIS["m1"]])}
    found = sampled_limit_cycles(light, gap=4e-5)
    assert (found.searched_again.tolist(), found.undecided.tolist()) == ([False], [False])
    samples = {name: np.array([value]) for name, value in THESIS.items()} | light
    assert_same(found, one_by_one(samples, [4e-5], "q2-q4", "both"))


def test_numbers_and_rows_mix_and_keep_their_places() -> None:
    m2, k1 = THESIS["m2"], THESIS["k1"]
    varied = sampled_limit_cycles({"m2": [m2, 1.1 * m2], "k1": k1}, gap=[4e-5, 8e-5])
    plain = sampled_limit_cycles({}, gap=4e-5)
    assert varied.omega[0] == pytest.approx(plain.omega[0], rel=1e-9)
    assert varied.omega[1] != pytest.approx(plain.omega[0], rel=1e-4)


def test_what_the_base_is_does_not_matter_where_every_parameter_is_sampled() -> None:
    samples, gaps = random_samples(6, 5, 0.2)
    undamped = TrimmerParameters(**{**THESIS, "c1": 0.0, "c2": 0.0, "c3": 0.0, "c4": 0.0})
    found, others = (sampled_limit_cycles(samples, gap=gaps, base=base) for base in (None, undamped))
    assert found.count.tolist() == others.count.tolist()
    np.testing.assert_allclose(others.omega, found.omega, rtol=1e-9)
    np.testing.assert_allclose(others.amplitude, found.amplitude, rtol=1e-8)


def test_amplitudes_grow_with_the_gap_and_frequencies_do_not() -> None:
    samples, gaps = random_samples(3, 20, 0.2)
    first, second = (sampled_limit_cycles(samples, gap=factor * gaps) for factor in (1.0, 7.0))
    np.testing.assert_allclose(second.amplitude, 7.0 * first.amplitude, rtol=1e-12)
    np.testing.assert_allclose(second.omega, first.omega, rtol=1e-12)


def test_a_trimmer_that_is_as_many_times_heavier_stiffer_and_more_damped_is_the_same() -> None:
    samples, gaps = random_samples(4, 20, 0.2)
    heavier = {name: 3.0 * values for name, values in samples.items()}
    first, second = (sampled_limit_cycles(each, gap=gaps) for each in (samples, heavier))
    np.testing.assert_allclose(second.amplitude, first.amplitude, rtol=1e-9)


def test_no_digit_depends_on_the_other_trimmers() -> None:
    samples, gaps = random_samples(5, BLOCK + 9, 0.3)
    whole = sampled_limit_cycles(samples, gap=gaps)
    for row in (0, 7, BLOCK, BLOCK + 8):
        alone = sampled_limit_cycles({name: values[row] for name, values in samples.items()}, gap=gaps[row])
        count = alone.count[0]
        assert whole.amplitude[row, :count].tolist() == alone.amplitude[0].tolist()
        assert whole.omega[row, :count].tolist() == alone.omega[0].tolist()


def test_no_trimmers_give_no_limit_cycles() -> None:
    found = sampled_limit_cycles({"m2": []}, gap=1e-5)
    assert found.amplitude.shape == (0, 0)
    assert found.count.shape == (0,)


@pytest.mark.parametrize(
    ("samples", "gap", "error", "told"),
    [
        ({"m5": [1.0]}, 1e-5, ParameterError, "there is no parameter 'm5'"),
        ({"m22": 1.0}, 1e-5, ParameterError, r"no parameter 'm22'; did you mean m2\?"),
        ({"weight": 1.0}, 1e-5, ParameterError, "no parameter 'weight'; there are m1, m2"),
        ({"m2": [[0.003]]}, 1e-5, ValueError, "rows of one length"),
        ({"m2": [0.003, -1.0]}, 1e-5, ParameterError, r"m2 = -1.0 \(sample 1\)"),
        ({"c1": [0.003, np.nan]}, 1e-5, ParameterError, r"c1 = nan \(sample 1\)"),
        ({"m2": [0.003, 0.003]}, [1e-5] * 3, ValueError, "rows of one length"),
        ({"m2": [0.003, 0.003]}, [1e-5, 0.0], ValueError, r"gap must be positive and finite, not .* 1\)"),
    ],
)
def test_what_cannot_be_used_is_named(samples, gap, error: type[Exception], told: str) -> None:
    with pytest.raises(error, match=told):
        sampled_limit_cycles(samples, gap=gap)


def test_where_the_curves_nearly_touch_each_trimmer_is_searched_once_more() -> None:
    """The two limit cycles of the thesis meet and vanish at 4.87255193 times its damping."""

    def damped(shares: np.ndarray) -> tuple[dict[str, np.ndarray], np.ndarray]:
        factors = {"c1": shares, "c2": shares, "c3": shares, "c4": shares}
        return {
            name: value * factors.get(name, np.ones(shares.size)) for name, value in THESIS.items()
        }, shares

    samples, shares = damped(
        4.87255193 * (1.0 + np.array([-0.5, -1e-3, -1e-5, -1e-7, 1e-7, 1e-5, 1e-3, 1.0]))
    )
    gaps = np.full(shares.size, 4e-5)
    found = sampled_limit_cycles(samples, gap=gaps, output="q2-q4", channels="displacement")
    assert found.count.tolist() == [2, 2, 2, 2, 0, 0, 0, 0]
    assert found.searched_again.tolist() == [False, *[True] * 6, False]
    assert not found.undecided.any()
    assert_same(found, one_by_one(samples, gaps, "q2-q4", "displacement"))
