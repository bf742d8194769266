"""Disks that hold N on boxes, and the table of them, with elements whose bounds are known by hand."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
import pytest

from trimmer.balance.cells import Cells
from trimmer.balance.element_curve import ElementCurve, GainTable
from trimmer.elements.backlashes.friction_backlash import FrictionBacklash
from trimmer.elements.relay import Relay
from trimmer.elements.saturation import Saturation


@dataclass(frozen=True)
class Sloping:
    """N = 2 u + 3j ln omega up to u = edge omega**power, with 4 and 5 as bounds of its slopes."""

    power: float = 0.0
    edge: float = 1.0
    constant_from: float = math.inf
    depends_on_frequency: bool = True
    own_reach: float | None = None
    amplitude_scale: float = 7.0

    def describing_function(self, amplitude: Any, omega: Any = None) -> Any:
        return 2.0 * self.amplitude_scale / amplitude + 3j * (0.0 if omega is None else np.log(omega))

    def domain(self, omega: Any = None) -> Any:
        return np.asarray(self.edge * (1.0 if omega is None else omega**self.power))

    def sensitivity(self, u_range: Any, omega_range: Any) -> Any:
        assert (omega_range is not None) == self.depends_on_frequency
        return np.full(u_range[0].shape, 4.0), np.full(u_range[0].shape, 5.0)

    def reach(self, u_range: Any, omega_range: Any) -> Any:
        return None if self.own_reach is None else np.asarray(self.own_reach)

    def variation(self, u_range: Any, omega_range: Any) -> Any:
        return u_range[1] - u_range[0], omega_range[1] / omega_range[0]


def cells(*limits: tuple[float, float, float, float]) -> Cells:
    return Cells(*np.array(limits, float).T)


def test_inside_the_domain_the_middle_counts() -> None:
    disks = ElementCurve(Sloping()).disks(cells((0.2, 0.6, 1.0, 4.0), (0.1, 0.2, -1.0, 1.0)))
    assert disks.centre == pytest.approx([0.8 + 7.5j, 0.3])
    assert disks.u_share == pytest.approx([0.8, 0.2])
    assert disks.radius == pytest.approx([0.8 + 7.5, 0.2 + 5.0])
    assert disks.exists.all()


@pytest.mark.parametrize(("power", "corner"), [(-1.0, -2.0), (1.0, 2.0)])
def test_at_the_edge_the_corner_counts_that_is_farthest_inside(power: float, corner: float) -> None:
    # The edge is at u = e**2 at that corner and e**-2 at the other.
    curve = ElementCurve(Sloping(power))
    disks = curve.disks(
        cells((0.5, 0.9, -2.0, 2.0), (7.0, 9.0, -2.0, 2.0), (7.5, 9.0, -2.0, 2.0), (0.0, 0.1, -2.0, 2.0))
    )
    assert disks.centre[:2] == pytest.approx([1.0 + 3j * corner, 14.0 + 3j * corner])
    assert disks.u_share == pytest.approx([1.6, 8.0, 6.0, 0.2])
    assert disks.radius == pytest.approx([1.6 + 20.0, 8.0 + 20.0, 6.0 + 20.0, 0.2 + 10.0])
    assert disks.exists.tolist() == [True, True, False, True]
    assert disks.centre[3] == pytest.approx(0.1)
    assert curve.inside(cells((0.1, math.exp(-2.0), -2.0, 2.0), (0.1, 0.136, -2.0, 2.0))).tolist() == [
        True,
        False,
    ]


def test_at_an_edge_that_is_the_same_everywhere_the_upper_corner_counts_and_beyond_it_nothing_is() -> None:
    disks = ElementCurve(Sloping()).disks(cells((0.5, 1.5, -2.0, 3.0), (1.0, 1.5, -2.0, 3.0)))
    assert disks.centre[0] == pytest.approx(1.0 + 9j)
    assert disks.exists.tolist() == [True, False]


def test_a_bound_of_its_own_takes_the_place_of_that_from_the_slope() -> None:
    curve = ElementCurve(Sloping(depends_on_frequency=False, own_reach=0.25))
    disks = curve.disks(cells((0.2, 0.6, 1.0, 4.0), (0.1, 0.2, -1.0, 1.0)))
    assert disks.radius.tolist() == disks.u_share.tolist() == [0.25, 0.25]
    assert disks.centre.tolist() == pytest.approx([0.8, 0.3])
    assert disks.exists.tolist() == [True, True]
    with_frequency = ElementCurve(Sloping(own_reach=0.25)).disks(cells((0.2, 0.6, 1.0, 4.0)))
    assert with_frequency.radius == pytest.approx([0.25 + 7.5])


def test_u_and_x_are_turned_into_amplitude_and_omega() -> None:
    curve = ElementCurve(Sloping())
    assert curve.value(np.array([0.5]), np.array([2.0])) == pytest.approx([1.0 + 6j])
    assert curve.amplitude(np.array([0.5, 2.0])) == pytest.approx([14.0, 3.5])
    assert np.isnan(curve.amplitude(np.array([-0.5])))[0]
    with np.errstate(divide="ignore"):
        assert np.isinf(curve.amplitude(np.array([0.0])))[0]
    by_u, by_x = curve.variation(cells((0.2, 0.6, 1.0, 4.0)))
    assert by_u == pytest.approx([0.4])
    assert by_x == pytest.approx([math.exp(3.0)])


def test_the_edge_is_where_n_ends_or_stays_the_same() -> None:
    x = np.array([-1.0, 2.0])
    assert ElementCurve(Sloping(1.0)).edge(x) == pytest.approx(np.exp(x))
    assert ElementCurve(Sloping(1.0, constant_from=2.0)).edge(x) == pytest.approx([math.exp(-1.0), 2.0])
    assert float(ElementCurve(FrictionBacklash(4e-5)).edge(x)) == 2.0
    saturation = Saturation(3.0, 0.5)
    assert float(ElementCurve(saturation).edge(x)) == saturation.constant_from < float(saturation.domain())
    assert np.isinf(ElementCurve(Relay(2.0)).edge(x))


def test_a_table_has_a_row_for_each_u_and_a_column_for_each_block() -> None:
    table = GainTable.of(ElementCurve(Sloping(1.0)), np.array([-1.0, 0.0, 2.0]))
    assert table.u_breaks == pytest.approx(np.linspace(0.0, math.exp(2.0), 33))
    assert table.disks.centre.shape == (32, 2)
    step = math.exp(2.0) / 32
    assert table.disks.centre[0] == pytest.approx([step - 1.5j, step + 3j])
    assert table.disks.radius[0] == pytest.approx([2.0 * step + 2.5, 2.0 * step + 5.0])
    # Through the second row of the first block runs the edge.
    assert table.disks.u_share[1] == pytest.approx([4.0 * step, 2.0 * step])
    assert table.disks.exists[:, 0].sum() == math.ceil(1.0 / step)
    assert table.disks.exists[:, 1].all()
    rows = table.rows_at(np.array([1, 0, 1]))
    assert rows.radius[0] == pytest.approx([2.0 * step + 5.0, 2.0 * step + 2.5, 2.0 * step + 5.0])
    pairs = table.disks_at(np.array([0, 1]), np.array([1, 0]))
    # The edge falls with x to the left: there the right corner counts, at x = 0.
    assert pairs.centre == pytest.approx([step + 3j, 2.0 * step])
    box = table.box
    assert (box.u_lower[0], box.u_upper[0]) == (0.0, pytest.approx(math.exp(2.0)))
    assert (box.x_lower[0], box.x_upper[0]) == (-1.0, 2.0)


def test_a_table_goes_up_to_the_larger_end_of_an_edge_that_falls() -> None:
    table = GainTable.of(ElementCurve(Sloping(-1.0)), np.array([-1.0, 0.0, 2.0]))
    assert table.u_breaks == pytest.approx(np.linspace(0.0, math.e, 33))


def test_a_table_of_an_element_without_frequency_has_one_column() -> None:
    table = GainTable.of(
        ElementCurve(Sloping(edge=3.2, depends_on_frequency=False)), np.array([1.0, 2.0, 5.0])
    )
    assert table.u_breaks == pytest.approx(np.linspace(0.0, 3.2, 65))
    assert table.disks.centre.shape == (64, 1)
    assert table.disks.centre[:3, 0] == pytest.approx([0.05, 0.15, 0.25])
    assert table.disks.radius[:, 0] == pytest.approx(0.1)
    assert table.rows_at(np.array([0, 1, 1])) is table.disks
    assert table.disks_at(np.array([2, 0]), np.array([1, 0])).centre == pytest.approx([0.25, 0.05])
    some = table.cells(np.array([2]), np.array([1.5]), np.array([1.75]))
    assert (some.u_lower[0], some.u_upper[0]) == pytest.approx((0.1, 0.15))
    assert (some.x_lower[0], some.x_upper[0]) == (1.5, 1.75)
    # |N| is between 0 and 6.35, with a radius of 0.1.
    assert table.largest_gain == pytest.approx(6.35 + 0.1)
    assert table.smallest_gain == 0.0


def test_the_smallest_and_the_largest_gain_are_those_of_the_disks_that_exist() -> None:
    # |N| is 6 and more, for u is small; the last rows of the first block do not exist.
    table = GainTable.of(ElementCurve(Sloping(1.0, edge=0.1)), np.array([2.0, 2.1, 2.2]))
    exists = [
        (abs(centre), radius)
        for centre, radius, there in zip(
            *(each.ravel().tolist() for each in (table.disks.centre, table.disks.radius, table.disks.exists)),
            strict=True,
        )
        if there
    ]
    assert len(exists) < table.disks.exists.size
    assert table.smallest_gain == pytest.approx(min(size - radius for size, radius in exists))
    assert 5.0 < table.smallest_gain < 6.0
    assert table.largest_gain == pytest.approx(max(size + radius for size, radius in exists))
    assert 6.6 < table.largest_gain < 8.0
