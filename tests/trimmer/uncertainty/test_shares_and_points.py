"""Points, distributions, quantiles and indices with small numbers, written out."""

from __future__ import annotations

import json
import math
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from scipy import stats

from trimmer import MotionKind
from trimmer.design.targets import Measure, Target
from trimmer.design.trial import Asked, Trial
from trimmer.errors import UncertaintyError
from trimmer.json_data import parsed_json, typed
from trimmer.uncertainty import indices as index_module
from trimmer.uncertainty.distributions import Joint, Normal, Scatter, Uncertainty, Uniform
from trimmer.uncertainty.indices import Index, indices_of, saltelli_points
from trimmer.uncertainty.kept import _as_data, _Kept, _trial, header
from trimmer.uncertainty.points import EDGE, Plan, within_cube
from trimmer.uncertainty.samples import SampleInputs, Samples, SampleSettings
from trimmer.uncertainty.statistics import Share, distribution_of, share_of
from trimmer.uncertainty.study import Quantity, _quantities, name_of

STROKE, PERIOD, SPEED = (
    Asked(Measure.STROKE, "x"),
    Asked(Measure.PERIOD, ""),
    Asked(Measure.IMPACT_SPEED, "stop"),
)


def test_sobol_takes_the_next_power_of_two() -> None:
    assert [Plan.SOBOL.count(wanted) for wanted in (1, 2, 3, 64, 65)] == [1, 2, 4, 64, 128]
    assert Plan.LATIN_HYPERCUBE.count(65) == 65
    assert Plan.SOBOL.points(4, 3, 1).shape == Plan.LATIN_HYPERCUBE.points(4, 3, 1).shape == (4, 3)
    np.testing.assert_array_equal(Plan.SOBOL.points(4, 3, 1), stats.qmc.Sobol(3, rng=1).random(4))
    np.testing.assert_array_equal(
        Plan.LATIN_HYPERCUBE.points(4, 3, 1), stats.qmc.LatinHypercube(3, rng=1).random(4)
    )


def test_points_on_a_face_are_moved_off_it() -> None:
    assert within_cube(np.array([0.0, 0.3, 1.0])).tolist() == [EDGE, 0.3, 1.0 - EDGE]


def test_a_uniform_distribution_ends() -> None:
    assert [Uniform(2e-5, 6e-5).share_below(each) for each in (1e-5, 3e-5, 7e-5)] == pytest.approx(
        [0, 0.25, 1]
    )


def test_values_are_placed_by_column() -> None:
    scatters = (Scatter("a", "m", Uniform(1.0, 3.0)), Scatter("b", "m", Normal(5.0, 2.0)))
    shares = np.array([[0.25, 0.5], [0.75, 0.5]])
    np.testing.assert_allclose(Uncertainty(scatters).values(shares), [[1.5, 5.0], [2.5, 5.0]])
    nothing = Uncertainty(()).values(np.zeros((3, 0)))
    assert nothing.shape == (3, 0)


def test_numbers_that_scatter_together_have_their_own_means() -> None:
    covariance = ((4.0, 1.2, 0.0), (1.2, 1.0, 0.3), (0.0, 0.3, 0.25))
    scatters = tuple(
        Scatter(name, "m", each)
        for name, each in zip(
            "pabc", (Uniform(0.0, 1.0), Normal(1.0, 2.0), Uniform(2.0, 5.0), Normal(-3.0, 0.5)), strict=True
        )
    )
    joint = Joint(("c", "a", "b"), tuple(tuple(covariance[i][j] for j in (2, 0, 1)) for i in (2, 0, 1)))
    uncertainty = Uncertainty(scatters, (joint,))
    np.testing.assert_allclose(joint.root @ joint.root.T, joint.covariance, atol=1e-12)
    shares = np.array([[0.3, 0.2, 0.6, 0.9]])
    found = uncertainty.values(shares)[0]
    scores = stats.norm.ppf([0.9, 0.2, 0.6])
    expected = np.array([-3.0, 1.0, 3.5]) + joint.root @ scores
    assert found == pytest.approx([0.3, expected[1], expected[2], expected[0]])
    singular = Joint(("a", "b"), ((1.0, 2.0), (2.0, 4.0)))
    np.testing.assert_allclose(singular.root @ singular.root.T, singular.covariance, atol=1e-12)
    assert np.isfinite(singular.root).all()


def test_a_share_of_nothing_is_anything() -> None:
    assert share_of(0, 0) == Share(0, 0, 0.0, 1.0)
    some = share_of(3, 12)
    assert (some.count, some.total, some.value) == (3, 12, 0.25)


def test_quantiles_lie_between_samples_in_order() -> None:
    values = np.random.default_rng(2).permutation(np.arange(1.0, 201.0))
    found = distribution_of(np.array([*values, np.nan, np.inf]))
    assert found is not None
    assert found.count == 200
    assert found.mean == pytest.approx(100.5, rel=200 * np.finfo(float).eps)
    assert found.deviation == pytest.approx(math.sqrt((200**2 - 1) / 12 * 200 / 199))
    for each, share in zip(found.quantiles, (0.05, 0.5, 0.95), strict=True):
        low, high = (int(stats.binom.ppf(part, 200, share)) for part in (0.025, 0.975))
        assert each.share == share
        assert (each.lowest, each.highest) == (low, high + 1)
        assert each.value == pytest.approx(1 + 199 * share)
    assert [each.lowest for each in found.quantiles] == [4.0, 86.0, 184.0]


def test_one_sample_has_no_deviation() -> None:
    found = distribution_of(np.array([3.0]))
    assert found is not None
    assert (found.count, found.mean, found.deviation) == (1, 3.0, 0.0)
    assert [(each.value, each.lowest, each.highest) for each in found.quantiles[1:2]] == [
        (3.0, -np.inf, np.inf)
    ]
    two = distribution_of(np.array([3.0, 5.0]))
    assert two is not None
    assert two.deviation == pytest.approx(math.sqrt(2))


def test_indices_are_passed_on_with_their_errors(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[Any] = []

    def analyze(problem: dict[str, Any], values: np.ndarray, **options: Any) -> dict[str, list[float]]:
        asked.append((problem, values, options))
        return {"S1": [0.1, 0.3], "ST": [0.2, 0.8], "S1_conf": [0.01, 0.02], "ST_conf": [0.03, 0.04]}

    monkeypatch.setattr(index_module, "_salib", lambda part: SimpleNamespace(analyze=analyze))
    values = np.arange(12.0)
    values[5] = np.inf
    found = indices_of(values, ("a", "b"), 7)
    assert found.indices == (Index("b", 0.3, 0.8, 0.02, 0.04), Index("a", 0.1, 0.2, 0.01, 0.03))
    assert (found.used, found.blocks) == (2, 3)
    (problem, used, options) = asked[0]
    assert used.tolist() == [0, 1, 2, 3, 8, 9, 10, 11]
    assert problem == {"num_vars": 2, "names": ["0", "1"], "bounds": [[0.0, 1.0], [0.0, 1.0]]}
    assert options == {"calc_second_order": False, "conf_level": 0.95, "seed": 7}


def test_what_hardly_differs_has_no_indices() -> None:
    found = indices_of(np.array([1.0, 1.0 + 1e-13, 1.0, 1.0] * 2), ("a", "b"), 0)
    assert (found.indices, found.used, found.blocks) == ((), 2, 2)


def test_blocks_are_a_power_of_two() -> None:
    with pytest.raises(UncertaintyError, match="power of two"):
        saltelli_points(2, 12, 0)


def trial(stroke: float, count: int | None = 1, kind: MotionKind | None = MotionKind.PERIODIC) -> Trial:
    period = math.inf if count is None else float(count)
    return Trial((0.1, 0.2), kind, count, ((STROKE, stroke), (PERIOD, period)))


def samples(*trials: Trial, targets: tuple[Target, ...] = (), possible: tuple[bool, ...] = ()) -> Samples:
    uncertainty = Uncertainty(
        (Scatter("a", "m", Normal(0.0, 1.0)), Scatter("b", "m", Uniform(0.0, 1.0), True))
    )
    flags = np.array(possible or (True,) * len(trials))
    inputs = SampleInputs(None, uncertainty, SampleSettings(seed=3), np.zeros((len(flags), 2)), flags)  # type: ignore[arg-type]
    return Samples(inputs, targets, (STROKE, PERIOD), trials)


MIXED = (
    trial(2.0),
    trial(3.0, 2),
    trial(5.0, None, MotionKind.CHAOTIC),
    trial(math.nan, None, None),
    trial(4.0),
    trial(1.0, 3),
)


def test_kinds_are_counted_the_most_frequent_first() -> None:
    found = samples(*MIXED)
    assert list(found.kinds.items()) == [
        ("period 1", 2),
        (MotionKind.CHAOTIC.word, 1),
        ("failed", 1),
        ("period 2", 1),
        ("period 3", 1),
    ]
    assert found.failed == 1
    np.testing.assert_array_equal(found.measured(STROKE), [2.0, 3.0, 5.0, np.nan, 4.0, 1.0])
    target = Target("stroke_at_least", Measure.STROKE, "x", 3.0)
    assert samples(*MIXED, targets=(target,)).met.tolist() == [False, True, True, False, True, False]


def test_what_was_left_out_is_told() -> None:
    found = samples(*MIXED, possible=(True,) * 6 + (False, False))
    assert found.impossible == 2
    assert found.message.startswith("8 samples (latin-hypercube, seed 3), ")
    for told in (" Of b the file only gives", " 2 samples that no mechanism", " 1 motions could not"):
        assert told in found.message
    assert "no mechanism" not in samples(*MIXED[:3]).message
    assert "could not" not in samples(*MIXED[:3]).message


def test_quantities_are_what_is_so_and_what_is_measured() -> None:
    target = Target("stroke_at_least", Measure.STROKE, "x", 3.0)
    first, second, third = _quantities(samples(*MIXED, targets=(target,)))
    assert first[1].tolist() == [1, 0, 0, 0, 1, 0]
    assert second[1].tolist() == [0, 1, 1, 0, 1, 0]
    assert third[0] == Quantity("peak to peak of x", STROKE)
    np.testing.assert_array_equal(third[1], [2.0, 3.0, 5.0, np.nan, 4.0, 1.0])
    assert len(_quantities(samples(*MIXED))) == 2
    assert name_of(SPEED) == "impact speed of stop"


@pytest.mark.parametrize("given", MIXED)
def test_a_trial_comes_back_from_its_line(given: Trial) -> None:
    made = SimpleNamespace(values=np.array([given.values] * 5))
    said = typed(_Kept, parsed_json(json.dumps(_as_data((4, given)))))
    assert said.number == 4
    found = _trial(said, made, (STROKE, PERIOD))
    assert (found.values, found.kind, found.period_count) == (given.values, given.kind, given.period_count)
    assert [each for each, _ in found.measures] == [STROKE, PERIOD]
    np.testing.assert_array_equal([v for _, v in found.measures], [v for _, v in given.measures])


def test_a_header_tells_other_inputs_apart() -> None:
    from tests.trimmer.design.made import oscillator

    def of(values: np.ndarray, **settings: Any) -> dict[str, Any]:
        uncertainty = Uncertainty((Scatter("frequency", "Hz", Uniform(19.0, 21.0)),))
        possible = np.ones(len(values), bool)
        return header(SampleInputs(oscillator(), uncertainty, SampleSettings(**settings), values, possible))

    usual = of(np.array([[19.5], [20.5]]), seed=2, most_periods=44)
    assert usual["trimmer sample"] == 1
    assert usual["places"] == ["frequency"]
    plan = {"count": 2, "plan": "latin-hypercube", "seed": 2, "most_periods": 44}
    assert usual["settings"] == plan
    assert usual["asked"][:2] == [["stroke", "block"], ["stroke", "double"]]
    digests = {usual["inputs"], of(np.array([[19.5], [20.6]]), seed=2, most_periods=44)["inputs"]}
    digests.add(of(np.array([[19.5], [20.5]]), seed=3, most_periods=44)["inputs"])
    assert len(digests) == 3
