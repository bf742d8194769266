"""The arrays of a mechanism, its extended state and what it holds, against values written out by hand."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from trimmer.contact.layout import Rows, layout_of, moves
from trimmer.contact.machine import independent, machine_of
from trimmer.contact.statuses import PULLS, RELAXES, TRUNCATES
from trimmer.mechanism.mechanism import Mechanism
from trimmer.mechanism.parts import Body, ContactLaw, Force, Friction, Link, Pin, Play, Stop

FREQUENCY = 110.0
OMEGA = 2 * math.pi * FREQUENCY


def rich() -> Mechanism:
    """Two bodies with each kind of part; the state is q1 q2 v1 v2 z, sine cosine sine3 cosine3, t, 1."""
    return Mechanism(
        bodies={"motor": Body(0.035), "cutter": Body(0.003)},
        frequency=FREQUENCY,
        pins={
            "pin": Pin("motor", 1.5e-3, 0.3, offset=2e-4, order=3),
            "belt": Pin("ground", velocity=0.25, offset=-3e-4),
            "idle": Pin("cutter", velocity=0.5),
        },
        links={
            "mount": Link(("motor", "ground"), 200e3, 3.5),
            "leaning": Link(("belt", "cutter"), 40.0, 3.0),
        },
        plays={
            "bridge": Play(("cutter", "pin"), 30e3, 0.4, 4e-5),
            "nothing": Play(("cutter", "motor"), 0.0, 0.0, 1e-3),
            "tight": Play(("motor", "cutter"), 0.0, 0.7, 0.0, ContactLaw.TRUNCATED),
        },
        stops={
            "wall": Stop(("ground", "motor"), 5e4, 0.0, 6e-4),
            "soft": Stop(("cutter", "ground"), 2e4, 0.3, 7e-4, ContactLaw.PULLING),
        },
        frictions={
            "blade": Friction(("motor", "cutter"), 0.8, 1.1, viscous=0.2),
            "air": Friction(("ground", "cutter"), 0.0, viscous=0.1),
            "table": Friction(("belt", "motor"), 0.5),
        },
        forces={
            "weight": Force("cutter", 0.03),
            "drum": Force("motor", 0.0, 2.0, 0.4, 1, 1e-6),
        },
    )


def test_orders_of_the_drive_ascend() -> None:
    forces = {"eighth": Force("one", amplitude=1.0, order=8), "first": Force("one", amplitude=1.0)}
    mechanism = Mechanism({"one": Body(1.0)}, frequency=2.0, forces=forces)
    assert machine_of(mechanism)[1].orders == (1, 8)
    still = machine_of(replace(mechanism, frequency=None, forces={"weight": Force("one", 1.0)}))[1]
    assert (still.orders, still.omega, still.period, still.pin_rows.shape) == ((), 0.0, 0.0, (0, 3))


def test_the_layout_of_a_rich_mechanism() -> None:
    machine, layout = machine_of(rich())
    assert layout.bodies == ("motor", "cutter")
    assert layout.contacts == ("bridge", "tight", "wall", "soft")
    assert layout.frictions == ("blade", "table")
    assert layout.relaxing == ("bridge",)
    assert (layout.orders, layout.ramp, layout.pins) == ((1, 3), True, ("pin", "belt", "idle"))
    assert (layout.state_count, layout.size, layout.forcing) == (5, 11, 6)
    assert (layout.sine(1), layout.sine(3)) == (5, 7)
    assert layout.omega == pytest.approx(OMEGA, rel=1e-15)
    assert layout.period == pytest.approx(1 / FREQUENCY, rel=1e-15)
    rows = np.zeros((3, 11))
    rows[0, 0], rows[0, 7:9], rows[0, -1] = 1.0, (1.5e-3 * math.cos(0.3), 1.5e-3 * math.sin(0.3)), 2e-4
    rows[1, -2:] = 0.25, -3e-4
    rows[2, 1], rows[2, -2] = 1.0, 0.5
    np.testing.assert_allclose(layout.pin_rows, rows, rtol=1e-14, atol=1e-20)
    assert machine.base.shape == (11, 11)


def test_what_forces_at_a_time() -> None:
    layout = machine_of(rich())[1]
    angle = OMEGA * 1.3e-3
    waves = [math.sin(angle), math.cos(angle), math.sin(3 * angle), math.cos(3 * angle)]
    np.testing.assert_allclose(layout.forcing_at(1.3e-3, 0.5), [*waves, 0.5013, 1.0], rtol=1e-13)
    np.testing.assert_allclose(layout.forcing_at(1.3e-3), [*waves, 0.0013, 1.0], rtol=1e-13)
    still = machine_of(Mechanism({"body": Body(1.0)}, links={"one": Link(("ground", "body"), 1.0)}))[1]
    assert still.period == 0.0
    assert still.forcing_at(3.0, 2.0).tolist() == [1.0]
    assert (still.state_count, still.size) == (2, 3)


def test_the_numbers_of_contacts_and_frictions() -> None:
    machine, _ = machine_of(rich())
    assert machine.stiffness.tolist() == [30e3, 0.0, 5e4, 2e4]
    assert machine.damping.tolist() == [0.4, 0.7, 0.0, 0.3]
    assert machine.offsets.tolist() == [[2e-5, -2e-5], [0, 0], [6e-4, -np.inf], [7e-4, -np.inf]]
    assert machine.law.tolist() == [RELAXES, TRUNCATES, PULLS, PULLS]
    assert machine.relaxing_state.tolist() == [4, -1, -1, -1]
    assert machine.always.tolist() == [0, 0, 0, 0]
    assert (machine.kinetic.tolist(), machine.static.tolist()) == ([0.8, 0.5], [1.1, 0.5])
    assert machine.vertices.tolist() == [[0, 1], [2, 0]]
    to_motor, to_cutter = 1 / 0.035, 1 / 0.003
    np.testing.assert_allclose(
        machine.contact_push,
        [[-to_motor, to_cutter], [to_motor, -to_cutter], [-to_motor, 0], [0, to_cutter]],
        rtol=1e-14,
    )
    np.testing.assert_allclose(machine.friction_push, [[-to_motor, to_cutter], [to_motor, 0]], rtol=1e-14)


def test_distances_and_rates_of_contacts_and_frictions() -> None:
    machine, layout = machine_of(rich())
    pin = layout.pin_rows[0]
    distances = np.zeros((4, 11))
    distances[0] = pin
    distances[0, 1] = -1.0
    distances[1, :2], distances[2, 0], distances[3, 1] = (-1.0, 1.0), 1.0, -1.0
    np.testing.assert_allclose(machine.contact_distance, distances, rtol=1e-14, atol=1e-20)
    # A rate is the distance's derivative along the flow, whichever contact holds.
    np.testing.assert_allclose(machine.contact_rate, distances @ machine.base, rtol=1e-12, atol=1e-12)
    rates = np.zeros((2, 11))
    rates[0, 2:4], rates[1, 2], rates[1, -1] = (-1.0, 1.0), 1.0, -0.25
    np.testing.assert_allclose(machine.friction_rate, rates, rtol=1e-14, atol=1e-20)


def test_the_flow_without_contact_and_dry_friction() -> None:
    base = machine_of(rich())[0].base
    expected = np.zeros((11, 11))
    expected[0, 2] = expected[1, 3] = 1.0
    expected[2, 0], expected[2, 2:4] = -200e3 / 0.035, (-(3.5 + 0.2) / 0.035, 0.2 / 0.035)
    expected[3, 1], expected[3, 2] = -40 / 0.003, 0.2 / 0.003
    expected[3, 3] = -(3.0 + 0.2 + 0.1) / 0.003
    expected[3, -2], expected[3, -1] = 40 * 0.25 / 0.003, (40 * -3e-4 + 3.0 * 0.25 + 0.03) / 0.003
    push = (2.0 + 1e-6 * OMEGA**2) / 0.035
    expected[2, 5:7] = push * math.cos(0.4), push * math.sin(0.4)
    expected[5, 6], expected[6, 5], expected[7, 8], expected[8, 7] = OMEGA, -OMEGA, 3 * OMEGA, -3 * OMEGA
    expected[-2, -1] = 1.0
    np.testing.assert_allclose(base, expected, rtol=1e-13, atol=1e-9)


def test_a_play_without_gap_is_a_link_unless_its_law_cuts_its_pull_off() -> None:
    def always(part) -> int:
        kind = "plays" if isinstance(part, Play) else "stops"
        mechanism = Mechanism({"body": Body(1.0)}, **{kind: {"part": part}})
        return int(machine_of(mechanism)[0].always[0])

    between = ("ground", "body")
    assert always(Play(between, 1.0, 0.5, 0.0)) == 1
    assert always(Play(between, 1.0, 0.5, 0.0, ContactLaw.PULLING)) == 1
    assert always(Play(between, 1.0, 0.0, 0.0, ContactLaw.TRUNCATED)) == 1
    assert always(Play(between, 1.0, 0.5, 0.0, ContactLaw.TRUNCATED)) == 0
    assert always(Play(between, 1.0, 0.5, 1e-9)) == 0
    assert always(Stop(between, 1.0, 0.5, 0.0)) == 0


def test_only_what_something_leans_on_needs_the_time() -> None:
    def ramp(velocity: float, stiffness: float) -> bool:
        mechanism = Mechanism(
            {"body": Body(1.0)},
            pins={"belt": Pin("ground", velocity=velocity)},
            links={"spring": Link(("belt", "body"), stiffness, 1.0)},
        )
        return layout_of(mechanism, {}, ()).ramp

    assert ramp(0.25, 1.0)
    assert not ramp(0.0, 1.0)
    assert not ramp(0.25, 0.0)
    wall = Stop(("ground", "belt"), 1.0, 0.0, 1.0)
    belt = {"belt": Pin("body", velocity=-0.25)}
    mechanism = Mechanism({"body": Body(1.0)}, pins=belt, stops={"wall": wall})
    assert layout_of(mechanism, {"wall": wall}, ()).ramp
    assert not layout_of(mechanism, {"wall": replace(wall, between=("ground", "body"))}, ()).ramp


def test_a_spring_relaxes_if_there_is_a_damper_to_hold_it_back() -> None:
    def relaxing(law: ContactLaw, stiffness: float, damping: float) -> tuple[str, ...]:
        part = Stop(("ground", "body"), stiffness, damping, 0.0, law)
        mechanism = Mechanism({"body": Body(1.0)}, stops={"wall": part})
        return layout_of(mechanism, {"wall": part}, ()).relaxing

    assert relaxing(ContactLaw.RELAXING, 1.0, 1.0) == ("wall",)
    assert relaxing(ContactLaw.RELAXING, 1.0, 0.0) == ()
    assert relaxing(ContactLaw.TRUNCATED, 1.0, 1.0) == ()


def test_what_moves() -> None:
    assert moves(Pin("ground", 1e-3))
    assert not moves(Pin("ground", velocity=1.0, offset=1.0))
    assert moves(Force("body", amplitude=-1.0))
    assert moves(Force("body", unbalance=1e-6))
    assert not moves(Force("body", constant=1.0))


def test_velocities_of_ends_are_the_rates_of_their_displacements() -> None:
    mechanism = rich()
    machine, layout = machine_of(mechanism)
    rows = Rows(mechanism, layout)
    for end in ("ground", "motor", "cutter", "pin", "belt", "idle"):
        expected = rows.displacement(end) @ machine.base
        np.testing.assert_allclose(rows.velocity(end), expected, rtol=1e-13, atol=1e-13)
    assert [rows.carrier(end) for end in ("ground", "motor", "cutter", "pin", "belt", "idle")] == [
        *(2, 0, 1, 0, 2, 1)
    ]
    assert rows.push("ground", "idle").tolist() == [0.0, 1 / 0.003]
    np.testing.assert_allclose(
        rows.wave(3, 2.0, 0.5)[7:9], [2 * math.cos(0.5), 2 * math.sin(0.5)], rtol=1e-14
    )


@pytest.mark.parametrize(
    ("vertices", "tree"),
    [
        ([[0, 1], [1, 0], [1, 2]], [0, 2]),
        ([[0, 1], [2, 3], [1, 2], [0, 3]], [0, 1, 2]),
        ([[3, 2], [1, 2], [1, 0], [0, 3]], [0, 1, 2]),
        ([[4, 0], [4, 1], [0, 1], [1, 1]], [0, 1]),
    ],
)
def test_a_spanning_tree_leaves_rings_open(vertices: list[list[int]], tree: list[int]) -> None:
    edges = np.array(vertices)
    assert independent(edges, np.arange(len(edges))).tolist() == tree
    assert independent(edges, np.array([1])).tolist() == [1]
    assert independent(np.zeros((0, 2), dtype=np.int64), np.array([], dtype=np.intp)).tolist() == []
