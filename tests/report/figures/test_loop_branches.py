"""The picture of the limit cycles of the thesis's loop."""

import numpy as np
import pytest


def test_both_sides_of_each_curve_end_in_its_fold(drawn_axes, evidence):
    loop = evidence.twin.loop
    for axes, branches, unit in zip(
        drawn_axes("twin-loop-branches"), ((loop.over_force,), loop.over_gap), (1.0, 1e6), strict=True
    ):
        folds = [line for line in axes.lines if line.get_marker() == "D" and len(line.get_xdata())]
        curves = [line for line in axes.lines if len(line.get_xdata()) > 20 and line.get_marker() == "None"]
        assert len(curves) == 2 * len(branches) == 2 * len(folds)
        for number, (branch, fold) in enumerate(zip(branches, folds, strict=True)):
            assert fold.get_xdata()[0] == pytest.approx(unit * branch.special_of("fold")[0])
            for curve in curves[2 * number : 2 * number + 2]:
                ends = curve.get_xydata()[[0, -1]]
                assert np.abs(ends - fold.get_xydata()).max(axis=1).min() < 1e-9
