"""Who computes samples and how they are looked at, with trials that cost nothing."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from tests.trimmer.design.made import oscillator
from trimmer import MotionKind
from trimmer.design.trial import Trial
from trimmer.errors import UncertaintyError
from trimmer.uncertainty import balance, loop_samples, samples, study
from trimmer.uncertainty.balance import balanced_samples
from trimmer.uncertainty.distributions import Normal, Scatter, Uncertainty, Uniform
from trimmer.uncertainty.kept import Keeping
from trimmer.uncertainty.loop_samples import LoopFile, LoopNumbers, LoopSamples, _possible
from trimmer.uncertainty.points import Plan
from trimmer.uncertainty.sample_file import SampleFile
from trimmer.uncertainty.samples import SampleInputs, SampleSettings, inputs_at, sample_inputs, trials_of
from trimmer.uncertainty.study import study_samples

PLACES = ("bodies.block.mass", "links.spring.stiffness")
UNCERTAINTY = Uncertainty(
    (Scatter(PLACES[0], "kg", Uniform(0.4, 0.6)), Scatter(PLACES[1], "N/m", Normal(9e3, 100.0)))
)


def inputs(values: list[list[float]]) -> SampleInputs:
    return inputs_at(oscillator(), UNCERTAINTY, SampleSettings(most_periods=33), np.array(values))


class Counting:
    """Gives back the values of each sample, the last first, and counts them."""

    def __init__(self) -> None:
        self.done: list[int] = []

    def results(self, work: Any, made: Iterable[Any]) -> Iterator[Any]:
        assert (work.trial.places, work.trial.most_periods) == (PLACES, 33)
        for number, values in reversed(list(made)):
            self.done.append(number)
            measures = tuple((each, values[0]) for each in work.trial.asked)
            yield number, Trial(values, MotionKind.PERIODIC, 1, measures)


def many(count: int, wrong: tuple[int, ...] = ()) -> list[list[float]]:
    return [[-1.0 if at in wrong else 0.4 + 1e-4 * at, 9e3] for at in range(count)]


def test_trials_stand_in_the_order_of_their_samples(tmp_path) -> None:
    made, runner = inputs(many(200, (1, 150))), Counting()
    assert (~made.possible).nonzero()[0].tolist() == [1, 150]
    path = tmp_path / "samples.jsonl"
    trials = trials_of(made, runner, Keeping(path), quiet=True)  # type: ignore[arg-type]
    assert [each.values for each in trials] == [tuple(row) for row in made.values[made.possible].tolist()]
    lines = path.read_bytes().splitlines(keepends=True)
    path.write_bytes(b"".join(lines[:190]))
    again = Counting()
    resumed = trials_of(made, again, Keeping(path, resume=True), quiet=True)  # type: ignore[arg-type]
    assert resumed == trials
    assert again.done == [9, 8, 7, 6, 5, 4, 3, 2, 0]
    idle = Counting()
    assert trials_of(made, idle, Keeping(path, resume=True), quiet=True) == trials  # type: ignore[arg-type]
    assert idle.done == []
    replaced = Counting()
    trials_of(made, replaced, Keeping(path, overwrite=True), quiet=True)  # type: ignore[arg-type]
    assert len(replaced.done) == 198


def test_samples_that_are_done_are_counted(monkeypatch: pytest.MonkeyPatch, tmp_path) -> None:
    bars: list[tuple[dict[str, Any], list[int]]] = []

    @contextmanager
    def bar(**options: Any) -> Iterator[Any]:
        updates: list[int] = []
        bars.append((options, updates))
        yield SimpleNamespace(update=lambda: updates.append(1))

    monkeypatch.setattr(samples, "progress_bar", bar)
    made, path = inputs(many(5)), tmp_path / "samples.jsonl"
    trials_of(made, Counting(), Keeping(path), quiet=True)  # type: ignore[arg-type]
    path.write_bytes(b"".join(path.read_bytes().splitlines(keepends=True)[:3]))
    trials_of(made, Counting(), Keeping(path, resume=True))  # type: ignore[arg-type]
    (first, done), (second, left) = bars
    assert (first["total"], first["initial"], first["quiet"], len(done)) == (5, 0, True, 5)
    assert (second["total"], second["initial"], second["quiet"], len(left)) == (5, 2, False, 3)


@pytest.mark.parametrize(("count", "several"), [(12, False), (13, True)])
def test_a_few_samples_are_done_here(monkeypatch: pytest.MonkeyPatch, count: int, several: bool) -> None:
    here, there = Counting(), Counting()
    monkeypatch.setattr(samples, "SerialRunner", lambda: here)
    monkeypatch.setattr(samples, "ProcessRunner", lambda: there)
    trials_of(inputs(many(count)), quiet=True)
    assert (len(here.done), len(there.done)) == ((0, count) if several else (count, 0))


def test_one_per_cent_may_be_impossible() -> None:
    assert inputs(many(100, (7,))).possible.sum() == 99
    with pytest.raises(UncertaintyError, match=r"2\.0%.* the first one because .*mass = -1"):
        inputs(many(100, (7, 9)))


def test_points_are_turned_into_values() -> None:
    settings = SampleSettings(count=5, plan=Plan.SOBOL, seed=6)
    found = sample_inputs(oscillator(), UNCERTAINTY, settings)
    np.testing.assert_array_equal(found.values, UNCERTAINTY.values(Plan.SOBOL.points(8, 2, 6)))
    assert (found.settings, found.possible.all()) == (settings, True)


def test_balance_goes_through_the_first_that_repeat(monkeypatch: pytest.MonkeyPatch) -> None:
    made = inputs([[0.4, 9e3], [0.45, 9e3], [0.5, 9e3], [0.55, 9e3], [0.6, 9e3]])
    counts = [None, 1, 2, 1, 1]
    trials = tuple(
        Trial(tuple(row), MotionKind.PERIODIC, count, ())
        for row, count in zip(made.values.tolist(), counts, strict=True)
    )
    asked: list[Any] = []

    def settle(flow: Any, begin: object, most_periods: int) -> Any:
        mass = flow.mechanism.value(PLACES[0])
        asked.append((mass, most_periods))
        orbit = None if mass == 0.5 else SimpleNamespace(course=mass, periods=7)
        return SimpleNamespace(orbit=orbit)

    def balanced(course: float, mechanism: object, periods: int, harmonics: int) -> Any:
        assert (periods, harmonics) == (7, 9)
        return SimpleNamespace(distance=1e-3 * course, converged=course < 0.5)

    monkeypatch.setattr(balance, "settle", settle)
    monkeypatch.setattr(balance, "balanced_beside", balanced)
    of: Any = SimpleNamespace(trials=trials, inputs=made)
    found = balanced_samples(of, 3, 9)
    assert asked == [(0.45, 33), (0.5, 33), (0.55, 33)]
    assert (found.numbers, found.harmonics) == ((1, 3), 9)
    assert found.distances == pytest.approx([4.5e-4, 5.5e-4])
    assert found.converged.tolist() == [True, False]


def test_the_rate_is_that_of_this_run(monkeypatch: pytest.MonkeyPatch, tmp_path) -> None:
    clock = iter([10.0, 14.0] * 3)
    monkeypatch.setattr(study.time, "perf_counter", lambda: next(clock))
    file = SampleFile(oscillator(), (), UNCERTAINTY)
    settings = SampleSettings(count=8, most_periods=33)
    path = tmp_path / "samples.jsonl"
    found = study_samples(file, settings, runner=Counting(), keeping=Keeping(path), quiet=True)  # type: ignore[arg-type]
    assert (found.per_second, found.indices, found.balanced) == (2.0, {}, None)
    assert len(found.samples.trials) == 8
    resumed = study_samples(file, settings, runner=Counting(), keeping=Keeping(path, resume=True), quiet=True)  # type: ignore[arg-type]
    assert math.isnan(resumed.per_second)


def test_impossible_samples_have_no_quantities() -> None:
    pytest.importorskip("SALib")
    # Of 64 blocks of 4 samples one has two springs that pull.
    wide = Uncertainty((UNCERTAINTY.scatters[0], Scatter(PLACES[1], "N/m", Normal(9e3, 3.6e3))))
    file = SampleFile(oscillator(), (), wide)
    settings = SampleSettings(count=60, most_periods=33, seed=2)
    found = study_samples(file, settings, indices=True, runner=Counting(), quiet=True)  # type: ignore[arg-type]
    assert found.samples.inputs.settings.plan is Plan.SOBOL
    assert len(found.samples.inputs.values) == 64 * 4
    by_name = {quantity.name: each for quantity, each in found.indices.items()}
    stroke = by_name["peak to peak of block"]  # which Counting makes the mass
    assert stroke.indices[0].place == PLACES[0]
    assert (found.samples.impossible, len(found.samples.trials)) == (2, 254)
    assert (stroke.used, stroke.blocks) == (63, 64)


def loop(*scatters: Scatter) -> LoopFile:
    from trimmer import TrimmerParameters

    return LoopFile(LoopNumbers(TrimmerParameters.thesis(), 4e-5), Uncertainty(scatters))


def test_masses_and_gaps_are_positive_and_dampings_may_be_zero() -> None:
    file = loop(*(Scatter(name, "1", Normal(1.0, 1.0)) for name in ("m2", "c2", "gap")))
    values = np.ones((400, 3))
    values[0, 1] = 0.0
    values[1, 0] = 0.0
    values[2, 2] = 0.0
    values[3, 1] = -1e-9
    assert (~_possible(file, values)).nonzero()[0].tolist() == [1, 2, 3]
    values[4, 2] = -1.0
    assert (~_possible(file, values)).sum() == 4  # of 400: just 1 %
    values[5, 2] = -1.0
    with pytest.raises(UncertaintyError, match=r"1\.2%.*most of them as gap would"):
        _possible(file, values)


def test_numbers_of_a_loop_are_its_parameters_and_the_gap() -> None:
    numbers = loop().numbers
    assert (numbers.value("gap"), numbers.places["gap"]) == (4e-5, "m")
    assert numbers.value("m2") == numbers.parameters.m2
    assert numbers.places["m2"] == "kg"


def test_cycles_belong_to_their_samples(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[Any] = []
    monkeypatch.setattr(
        loop_samples, "sampled_limit_cycles", lambda samples, **options: asked.append((samples, options))
    )
    values = np.array([[1.0, 3e-5], [2.0, 5e-5]])
    both = loop(Scatter("m2", "kg", Normal(1.0, 1.0)), Scatter("gap", "m", Normal(1.0, 1.0)))
    loop_samples._limit_cycles(both, values, "out", "in")
    loop_samples._limit_cycles(loop(Scatter("m2", "kg", Normal(1.0, 1.0))), values[:, :1], "out", "in")
    (first, options), (second, more) = asked
    assert {name: each.tolist() for name, each in first.items()} == {"m2": [1.0, 2.0]}
    assert options["gap"].tolist() == [3e-5, 5e-5]
    assert (options["output"], options["channels"]) == ("out", "in")
    assert second["m2"].tolist() == [1.0, 2.0]
    assert more["gap"].tolist() == [4e-5, 4e-5]


def test_indices_of_a_loop_leave_out_what_is_impossible(monkeypatch: pytest.MonkeyPatch) -> None:
    found: Any = SimpleNamespace(exists=np.array([True, False, True]))
    monkeypatch.setattr(
        loop_samples,
        "_largest",
        lambda each: (np.array([1e-3, np.nan, 2e-3]), np.array([80.0, np.nan, 90.0])),
    )
    monkeypatch.setattr(
        loop_samples, "indices_of", lambda column, places, seed: (column.tolist(), places, seed)
    )
    file = loop(Scatter("m2", "kg", Normal(1.0, 1.0)))
    possible = np.array([True, False, True, True])
    told: Any = loop_samples._indices(file, possible, found, 8)
    columns = {name: each[0] for name, each in told.items()}
    np.testing.assert_array_equal(columns["whether there is a stable limit cycle"], [1, np.nan, 0, 1])
    np.testing.assert_array_equal(columns["its amplitude"], [1e-3, np.nan, np.nan, 2e-3])
    np.testing.assert_array_equal(columns["its frequency"], [80.0, np.nan, np.nan, 90.0])
    assert {each[1:] for each in told.values()} == {(("m2",), 8)}


def test_what_was_left_out_of_a_loop_is_told() -> None:
    cycles: Any = SimpleNamespace(message="Searched.")
    values, possible = np.zeros((4, 1)), np.array([True, False, True, True])
    made = LoopSamples(loop(), SampleSettings(seed=5), values, possible, cycles, {}, 1.0)
    assert made.message == (
        "4 samples (latin-hypercube, seed 5). 1 samples that no trimmer can have were left out. Searched."
    )
    whole = LoopSamples(loop(), SampleSettings(), values, np.ones(4, bool), cycles, {}, 1.0)
    assert "left out" not in whole.message


def test_a_loop_without_any_cycle_has_no_largest() -> None:
    nothing: Any = SimpleNamespace(amplitude=np.zeros((3, 0)), count=np.zeros(3))
    sizes, frequencies = loop_samples._largest(nothing)
    np.testing.assert_array_equal(sizes, [np.nan] * 3)
    np.testing.assert_array_equal(frequencies, [np.nan] * 3)
