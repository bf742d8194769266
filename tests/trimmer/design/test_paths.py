"""How far a branch stays stable, and branches whose orbits are known in closed form."""

import numpy as np
import pytest

from tests.trimmer.design.made import motion, oscillator, oscillator_amplitude
from trimmer.branches import BranchEnd, SpecialKind
from trimmer.design import DesignSettings, NumberRole, PathSide, SpecialOnPath, Study, VariedNumber
from trimmer.design.parameter_studies.paths import path_through
from trimmer.design.specification.design_file import design_file_of_text
from trimmer.examples import example_text


def special(kind: SpecialKind, value: float) -> SpecialOnPath:
    return SpecialOnPath(kind, value, {}, ())


def side(
    values: list[float], unstable: str, *points: SpecialOnPath, reason: BranchEnd = BranchEnd.LEFT_AT_STOP
) -> PathSide:
    """Return a side whose orbits are stable but for those marked with ``u``."""
    stable = np.array([each != "u" for each in unstable])
    return PathSide(values[-1], np.array(values), stable, {}, points, reason, "")


def test_a_side_that_is_stable_throughout_reaches_its_end() -> None:
    points = (special(SpecialKind.GRAZING, 1.1), special(SpecialKind.FOLD, 1.2))
    whole = side([1.0, 1.2, 1.4], "sss", *points)
    assert (whole.reaches, whole.losing, whole.first_special) == (None, None, points)
    broken = side([1.0, 1.2, 1.4], "sss", points[0], reason=BranchEnd.STEP_TOO_SMALL)
    assert (broken.reaches, broken.losing, broken.first_special) == (1.4, None, points[:1])


def test_stability_is_lost_at_the_special_point_between_two_orbits() -> None:
    points = [
        special(SpecialKind.PERIOD_DOUBLING, 1.1),
        special(SpecialKind.GRAZING, 1.25),
        special(SpecialKind.FOLD, 1.3),
        special(SpecialKind.GRAZING, 1.29),
    ]
    lost = side([1.0, 1.2, 1.4, 1.6], "ssus", *points)
    assert lost.reaches == 1.3
    assert lost.losing is SpecialKind.FOLD
    assert lost.first_special == tuple(points[:3])


@pytest.mark.parametrize("value", [0.8, 0.6])
def test_a_special_point_at_either_orbit_counts_downwards_too(value: float) -> None:
    points = [special(SpecialKind.TORUS, 0.5), special(SpecialKind.TORUS, value)]
    lost = side([1.0, 0.8, 0.6, 0.5], "ssuu", *points)
    assert lost.reaches == value
    assert lost.losing is SpecialKind.TORUS


def test_without_a_special_point_the_last_stable_orbit_is_reached() -> None:
    points = [special(SpecialKind.GRAZING, each) for each in (0.9, 0.8, 0.75, 0.85)]
    lost = side([1.0, 0.8, 0.6], "ssu", *points)
    assert (lost.reaches, lost.losing) == (0.8, None)
    assert lost.first_special == tuple(points[:2])
    beyond = [points[0], points[2], points[3]]
    assert side([1.0, 0.8, 0.6], "ssu", *beyond).first_special == tuple(points[:1])


def over_frequency(lowest: float, highest: float) -> VariedNumber:
    return VariedNumber(NumberRole.SPEED, "frequency", "", "Hz", 20.0, lowest, highest)


@pytest.mark.slow
def test_the_orbits_of_an_oscillator_are_those_of_its_formula() -> None:
    begun = motion(state=np.zeros(2))
    path = path_through(oscillator(), over_frequency(19.0, 20.5), begun, 300)
    assert path.periods == 1
    assert path.varied.place == "frequency"
    for found, end in ((path.down, 19.0), (path.up, 20.5)):
        assert found is not None
        assert (found.end, found.reason, found.special) == (end, BranchEnd.LEFT_AT_STOP, ())
        assert found.reaches is None
        assert found.message
        assert found.stable.all()
        assert found.values[[0, -1]] == pytest.approx([20.0, end], rel=1e-12)
        # Steps of at most 2 % of a side.
        assert abs(np.diff(found.values)).max() <= 0.0201 * abs(end - 20.0)
        expected = [2 * oscillator_amplitude(float(each)) for each in found.values]
        assert found.stroke["block"] == pytest.approx(expected, rel=1e-9)
        assert found.stroke["double"] == pytest.approx(2 * np.array(expected), rel=1e-9)


def test_the_strokes_of_a_block_on_a_belt_are_those_of_its_formula() -> None:
    """It starts as fast as the belt where k q is the static force, and swings about where it is kinetic."""
    block = design_file_of_text(example_text("block-on-belt"), "block-on-belt")
    study = Study(block, DesignSettings(starts=1, most_points=120))
    belt, rubbing = study.paths(found := study.motions(), study.varied(found))
    for path, differ in ((belt, lambda v: (v, 0.5)), (rubbing, lambda kinetic: (0.2, 1.0 - kinetic))):
        for side in (path.down, path.up):
            assert side is not None and side.stable[:-1].all() and len(side.values) > 20
            stroke = [2 * float(np.hypot(*differ(each))) for each in side.values.tolist()]
            assert side.stroke["block"] == pytest.approx(stroke, rel=1e-9)


@pytest.mark.parametrize(("lowest", "highest", "there"), [(20.0, 20.5, "up"), (19.5, 20.0, "down")])
def test_a_range_that_ends_at_the_working_point_has_one_side(
    lowest: float, highest: float, there: str
) -> None:
    path = path_through(oscillator(), over_frequency(lowest, highest), motion(state=np.zeros(2)), 4)
    assert (path.down is None, path.up is None) == (there == "up", there == "down")
    found = getattr(path, there)
    assert found.end == (highest if there == "up" else lowest)
    assert (len(found.values), found.reason) == (4, BranchEnd.MOST_POINTS)
