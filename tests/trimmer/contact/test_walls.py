"""Rigid walls: impacts, completed chatter, rest and letting go, several walls at once; closed forms."""

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from scipy.linalg import expm
from scipy.optimize import brentq

from tests.mechanisms.random_mechanisms import curved, random_mechanism, with_every_part
from tests.quick import quick
from tests.trimmer.contact.test_against_brute_force import compare
from tests.trimmer.problem_machines import machine_text
from trimmer import Mechanism, MechanismError, follow, respond, simulate
from trimmer.mechanism import Body, Force, Friction, Link, Pin, Stop, Wall

G = 9.81
TABLE = machine_text("bouncing-ball")


def ball(restitution: float, start=(1.0, 0.0), **parts) -> Mechanism:
    """A ball of 0.1 kg above the floor, which is at 0."""
    given = {"walls": {"floor": Wall(("ball", "ground"), restitution)}, **parts}
    weight = Force("ball", -0.1 * G)
    return Mechanism({"ball": Body(0.1)}, forces={"weight": weight}, start={"ball": start}, **given)


def bodies_in_line(velocities, restitution=1.0, masses=None) -> Mechanism:
    """Balls that touch each other, with a wall between neighbours; nothing else holds them."""
    names = "abcde"[: len(velocities)]
    pairs = list(pairwise(names))
    return Mechanism(
        {name: Body(mass) for name, mass in zip(names, masses or [1.0] * len(names), strict=True)},
        walls={a + b: Wall((b, a), restitution) for a, b in pairs},
        start={name: (0.0, v) for name, v in zip(names, velocities, strict=True)},
    )


def kinds(motion) -> list[str]:
    return [event.kind.value for event in motion.events]


def last(motion) -> np.ndarray:
    return motion.states(np.array([motion.duration]))[:, 0]


@pytest.mark.parametrize(
    ("restitution", "kind"),
    quick([(0.6, "fold"), (0.8, "fold"), (0.6, "period-doubling"), (0.8, "period-doubling")], 0, 3),
)
def test_fold_and_period_doubling_of_the_ball_on_the_table(restitution, kind):
    """Closed forms for one impact per period (Holmes, J. Sound Vib. 84, 1982)."""
    omega, period = 40 * np.pi, 0.05
    unit = G / omega**2
    share = np.pi * (1 - restitution) / (1 + restitution)
    doubling = np.hypot(share, 2 * (1 + restitution**2) / (1 + restitution) ** 2)
    value = unit * (share if kind == "fold" else doubling)
    amplitude = unit * (0.9 * share + 0.1 * doubling)
    phase = np.arccos(share * unit / amplitude)  # of the impact, which the ball leaves with g T / 2
    flown = period - phase / omega
    height = amplitude * np.sin(phase) + G * flown * (period - flown) / 2
    table = Mechanism.from_toml_text(TABLE).with_value("walls.plate.restitution", restitution)
    begun = replace(table, start={"ball": (height, G * (period / 2 - flown))})
    branch = follow(begun, "pins.table.amplitude", amplitude, value * (0.98 if kind == "fold" else 1.02))
    special = branch.special[0]
    assert (special.kind.word, special.value) == (kind, pytest.approx(value, rel=1e-8))


@pytest.mark.parametrize(
    ("restitution", "frictions"), [(0.3, 0), (0.8, 0), (0.95, 0), (0.5, 1), (0.7, 1), (0.5, 2), (0.7, 2)]
)
def test_a_bouncing_ball_comes_to_rest_when_the_geometric_series_ends(restitution, frictions):
    """Rising it is slowed by weight and friction, falling pulled by their difference; the floor is at -1."""
    rubs = 0.05 * G if frictions else 0.0
    guides = {f"guide {n}": Friction(("ground", "ball"), rubs / frictions) for n in range(frictions)}
    walls = {"floor": Wall(("ball", "ground"), restitution, gap=1.0)}
    motion = simulate(ball(restitution, (0.0, -1.0), walls=walls, frictions=guides), 60.0)
    falls, rises = G - rubs / 0.1, G + rubs / 0.1
    speed, kept = np.sqrt(1.0 + 2 * falls), restitution * np.sqrt(falls / rises)
    once = restitution * speed * (1 / rises + 1 / np.sqrt(rises * falls))
    assert motion.success and motion.chatter_completed
    assert kinds(motion)[-2:] == ["chatter completed", "rest begun"] or frictions
    untold = 2.0**-44 * 2.0  # of the height, m, whose bounce is the last one at most
    left = 2 * np.sqrt(2 * untold / falls) * kept / (1 - kept) + 1.1e-9
    assert motion.events[-1].time == pytest.approx((speed - 1.0) / falls + once / (1 - kept), abs=left)
    assert last(motion) == pytest.approx([-1.0, 0.0], abs=1e-15)
    impacts = [each for each in motion.events if each.kind.value == "impact"]
    speeds = pytest.approx(
        speed * kept ** np.arange(len(impacts)), rel=1e-6, abs=1e-7 if frictions else 1e-11
    )
    assert [each.speed for each in impacts] == speeds
    assert [each.impulse / (0.1 * (1 + restitution)) for each in impacts] == speeds
    lost = motion.energy.walls["floor"] + sum(motion.energy.frictions.values())
    assert lost == pytest.approx(0.05 + 0.1 * G, rel=1e-12)
    assert motion.energy.walls["floor"] == pytest.approx(
        0.05 * (1 - restitution**2) * speed**2 / (1 - kept**2), rel=1e-9
    )


@pytest.mark.parametrize("restitutions", [(0.3, 0.3), (0.6, 0.5), (0.9, 0.75)])
def test_two_balls_that_bounce_on_each_other_come_to_rest(restitutions):
    """Both chatters end at one instant, where each impact of the one lifts the other a little."""
    on_floor, on_ball = restitutions
    balls = Mechanism(
        {"a": Body(3.7), "b": Body(3.6)},
        forces={"on a": Force("a", -3.7 * G), "on b": Force("b", -3.6 * G)},
        walls={"floor": Wall(("a", "ground"), on_floor), "between": Wall(("b", "a"), on_ball)},
        start={"a": (1.0, 0.0), "b": (1.5, 1.0)},
    )
    motion = simulate(balls, 5.0)
    assert motion.success
    assert last(motion) == pytest.approx(np.zeros(4), abs=1e-30)
    assert {event.part for event in motion.events if event.kind.value == "rest begun"} == {"floor", "between"}
    fallen = 3.7 * G + 3.6 * (1.5 * G + 0.5)
    assert sum(motion.energy.walls.values()) == pytest.approx(fallen, rel=1e-12)


def test_energy_is_kept_over_many_impacts_without_loss():
    motion = simulate(ball(1.0), 2 * np.sqrt(2 / G) * 1e4)
    assert len(motion.events) == 10_000
    assert not motion.chatter_completed
    (kinetic, _), (_, _) = motion.energy.kinetic, motion.energy.stored
    height, speed = last(motion)
    assert kinetic + 0.1 * G == pytest.approx(0.1 * G * height + 0.05 * speed**2, rel=1e-10)


def test_a_plastic_impact_ends_in_rest_at_once():
    motion = simulate(ball(0.0), 2.0)
    assert kinds(motion) == ["impact", "rest begun"]
    assert not motion.chatter_completed


@pytest.mark.parametrize("frequency", [15.7, 15.8])
def test_a_ball_leaves_the_table_where_its_acceleration_exceeds_that_of_gravity(frequency):
    omega, amplitude = 2 * np.pi * frequency, 1e-3
    table = {"table": Pin("ground", amplitude)}
    walls = {"floor": Wall(("ball", "table"), 0.5)}
    mechanism = ball(0.5, (0.0, amplitude * omega), frequency=frequency, pins=table, walls=walls)
    motion = simulate(mechanism, 3 / frequency)
    if amplitude * omega**2 < G:
        assert not motion.events
        forces = motion.flow.forces(motion.course, np.array([0.25, 0.75]) / frequency)["floor"]
        assert forces == pytest.approx(0.1 * (G + amplitude * omega**2 * np.array([-1, 1])), rel=1e-9)
    else:
        first = motion.events[0]
        assert first.kind.value == "rest ended"
        assert omega * first.time == pytest.approx(np.arcsin(G / (amplitude * omega**2)), rel=1e-9)
        assert motion.chatter_completed
    assert motion.energy.residual < 1e-11


def test_rest_on_a_wall_takes_two_multipliers():
    table = {"table": Pin("ground", 1e-3)}
    walls = {"floor": Wall(("ball", "table"), 0.5)}
    orbit = respond(ball(0.5, (0.0, 0.0), frequency=17.0, pins=table, walls=walls)).motions[0].orbit
    assert orbit.multipliers == pytest.approx([0.0, 0.0], abs=1e-12)


@pytest.mark.parametrize("restitution", [0.0, 0.4, 1.0])
def test_two_balls_collide_as_their_restitution_says(restitution):
    mechanism = bodies_in_line([2.0, -1.0], restitution, masses=[3.0, 1.0])
    motion = simulate(mechanism, 1.0)
    first, second = last(motion)[2:]
    assert 3 * first + second == pytest.approx(5.0, rel=1e-14)
    assert second - first == pytest.approx(3 * restitution, abs=1e-14)
    assert motion.events[0].impulse == pytest.approx((1 + restitution) * 3.0 * 0.75)


def test_the_last_ball_of_a_cradle_flies_off():
    motion = simulate(bodies_in_line([1.0, 0.0, 0.0, 0.0]), 1.0)
    assert last(motion)[4:] == pytest.approx([0.0, 0.0, 0.0, 1.0], abs=1e-14)
    assert [event.part for event in motion.events if event.kind.value == "impact"] == ["ab", "bc", "cd"]


def test_walls_in_turn_pass_after_pass():
    """Newton's law on touching pairs, in the order of the file, until none closes: done by hand."""
    motion = simulate(bodies_in_line([1.0, 0.0, 0.0], 0.5), 1.0)
    velocities, done = [1.0, 0.0, 0.0], []
    while any(a > b for a, b in pairwise(velocities)):
        for place, name in enumerate(("ab", "bc")):
            a, b = velocities[place : place + 2]
            if a > b:
                mean, rate = (a + b) / 2, a - b
                velocities[place : place + 2] = mean - 0.25 * rate, mean + 0.25 * rate
                done.append(name)
    assert last(motion)[3:] == pytest.approx(velocities, rel=1e-14)
    assert [event.part for event in motion.events if event.kind.value == "impact"] == done
    assert not motion.walls_together


def test_walls_whose_impacts_would_not_end_act_together():
    """A ball between two that close on it for ever, with a restitution just below one."""
    motion = simulate(bodies_in_line([1.0, 0.0, -1.0], 0.5, masses=[1e3, 1.0, 1e3]), 1.0)
    velocities = last(motion)[3:]
    assert motion.walls_together
    assert 1e3 * velocities[0] + velocities[1] + 1e3 * velocities[2] == pytest.approx(0.0, abs=1e-9)
    assert np.diff(velocities).min() >= -1e-12


def test_a_slide_is_held_by_friction_and_wall_together_until_both_let_go():
    """Pressed on the wall with 2.5 N at most, it leaves where the pull exceeds the friction of 1 N."""
    slide = Mechanism(
        {"slide": Body(1.0)}, frequency=1.0, frictions={"guide": Friction(("ground", "slide"), 1.0)},
        forces={"pull": Force("slide", 0.5, 2.0)}, walls={"end": Wall(("ground", "slide"), 0.0, gap=0.01)},
        start={"slide": (0.01, 0.0)},
    )  # fmt: skip
    motion = simulate(slide, 1.0)
    angle = np.pi + np.arcsin(1.5 / 2.0)
    assert kinds(motion)[:2] == ["stick ended", "rest ended"]
    assert motion.events[0].time == motion.events[1].time == pytest.approx(angle / (2 * np.pi), rel=1e-12)
    forces = motion.flow.forces(motion.course, np.array([0.25, 0.5]))
    assert forces["end"] + forces["guide"] == pytest.approx([2.5, 0.5], rel=1e-12)
    assert (forces["end"] >= 0).all()
    assert motion.energy.residual < 1e-12


@pytest.mark.parametrize(("push", "rubs"), [(3.0, 0.0), (2e4, 0.0), (2e4, 0.3)])
def test_a_body_between_two_walls_without_room_stays_and_neither_pulls(push, rubs):
    walls = {"right": Wall(("ground", "body"), 0.5), "left": Wall(("body", "ground"), 0.5)}
    rubbing, pushing = {"rail": Friction(("ground", "body"), rubs)}, {"push": Force("body", 0.0, push)}
    held = Mechanism({"body": Body(1.0)}, frequency=1.0, forces=pushing, walls=walls, frictions=rubbing)
    motion = simulate(held, 2.0)
    assert last(motion) == pytest.approx([0.0, 0.0], abs=0.0) and not motion.events
    forces = motion.flow.forces(motion.course, np.array([0.25, 0.75]))
    pushes = np.append(forces["right"], forces["left"])
    assert pushes == pytest.approx([push, 0.0, 0.0, push], abs=1.01 * rubs + 1e-9)
    assert respond(held).motions[0].contacts["right"].largest_force == pytest.approx(max(pushes), rel=1e-12)


@pytest.mark.parametrize(
    ("ends", "gap", "start", "force", "damping", "then"),
    [
        (("body", "ground"), -0.03, (0.1, -8.0), 0.0, 60.0, "contact broken"),  # Thrown in again: it pushes
        (("ground", "body"), 0.1, (0.05, 5.0), 2000.0, 20.0, "contact made"),  # Thrown out: it would pull
    ],
)
def test_a_force_that_an_impact_made_jump_is_zero_as_late_as_it_comes_to(
    ends, gap, start, force, damping, then
):
    """A body in a stop of 1 kN/m hits a wall: from there on a vibration, or a flight, by SciPy."""
    motion = simulate(
        Mechanism(
            {"body": Body(1.0)},
            stops={"stop": Stop(("ground", "body"), 1e3, damping, 0.0, law="truncated")},
            walls={"wall": Wall(ends, 0.8, gap)},
            forces={"force": Force("body", force)},
            start={"body": start},
        ),
        0.4,
    )
    hit = next(i for i, event in enumerate(motion.events) if event.kind.value == "impact")
    impact, changed, after = motion.events[hit : hit + 3]
    pushes = then == "contact broken"
    flow = np.array([[0, 1, 0], [-1e3 * pushes, -damping * pushes, force], [0, 0, 0]])
    begin = np.array([abs(gap), (0.8 if pushes else -0.8) * impact.speed, 1.0])
    stretch = brentq(lambda t: np.array([1e3, damping, 0]) @ expm(flow * t) @ begin, 1e-9, 0.3)
    assert changed.time == impact.time and after.kind.value == then
    assert after.time - impact.time == pytest.approx(stretch, rel=1e-9)


def test_stick_is_decided_anew_after_an_impact():
    """A ball strikes a block that sticks; the block slides until friction has used up what it was given."""
    mechanism = Mechanism(
        {"ball": Body(1.0), "block": Body(2.0)},
        frictions={"floor": Friction(("ground", "block"), 3.0, 4.0)},
        walls={"face": Wall(("block", "ball"), 0.5)},
        start={"ball": (-1.0, 2.0)},
    )
    motion = simulate(mechanism, 3.0)
    assert kinds(motion) == ["impact", "stick ended", "stick begun"]
    given = 1.5 * 2.0 / (1 + 1 / 2) / 2.0
    assert motion.events[2].time - 0.5 == pytest.approx(given / (3.0 / 2.0), rel=1e-12)
    assert last(motion)[1] == pytest.approx(given**2 / 2 / 1.5, rel=1e-12)


def test_a_start_beyond_the_gap_is_refused():
    with pytest.raises(
        MechanismError, match=r"start.ball: at the start 'ground' is 0.1 m too far from 'ball' for .*'floor'"
    ):
        simulate(ball(0.5, (-0.1, 0.0)), 1.0)


def test_a_gap_that_no_start_is_within_is_named_in_the_unit_of_its_ends():
    turning = Mechanism({"arm": Body(inertia=1.0)}, walls={"end": Wall(("ground", "arm"), 0.5, gap=-1.0)})
    with pytest.raises(MechanismError, match=r"walls.end.gap: .* is 1 rad too far .* give another gap"):
        simulate(turning, 1.0)


def test_a_start_on_the_wall_with_a_closing_rate_begins_with_an_impact():
    first = simulate(ball(0.5, (0.0, -2.0)), 0.1).events[0]
    assert (first.time, first.kind.value, first.speed) == (0.0, "impact", 2.0)


def test_derivatives_over_impacts_and_rest_are_those_of_the_motion():
    """Differences of motions against the saltation matrices, with friction between impacts."""
    mechanism = Mechanism(
        {"a": Body(1.0), "b": Body(0.5)},
        frequency=1.0,
        links={"held": Link(("ground", "a"), 30.0, 0.4), "coupled": Link(("a", "b"), 15.0, 0.2)},
        frictions={"rub": Friction(("ground", "b"), 0.3)},
        forces={"push": Force("a", 0.0, 8.0)},
        walls={"right": Wall(("ground", "b"), 0.7, gap=0.1), "between": Wall(("b", "a"), 0.4, gap=0.05)},
    )
    start = np.array([0.02, 0.03, 0.1, 0.4])
    motion = simulate(mechanism, 2.6, state=start)
    assert sum(kind == "impact" for kind in kinds(motion)) > 4
    step = 1e-7
    columns = [
        (last(simulate(mechanism, 2.6, state=start + h)) - last(simulate(mechanism, 2.6, state=start - h)))
        / (2 * step)
        for h in step * np.eye(4)
    ]
    exact = motion.course.monodromy
    assert np.column_stack(columns) == pytest.approx(exact, abs=1e-4 * abs(exact).max())


TWO = ["period-doubling"]


@pytest.mark.parametrize(
    ("begin", "end", "beside", "sides"),
    quick([(0.05, 0.14, [], 1), (0.14, 0.06, TWO, 1), (0.14, 0.06, TWO, 2), (0.17, 0.3, ["fold"], 1)], 0, 3),
)
def test_a_branch_ends_at_the_grazing_of_a_wall(begin, end, beside, sides):
    """Where the linear motion just reaches the wall, from below and from impacts on either side."""
    walls = {"stop": Wall(("ground", "body"), 0.7, gap=1.8), "other": Wall(("body", "ground"), 0.7, gap=1.8)}
    oscillator = Mechanism(
        {"body": Body(1.0)}, frequency=begin, links={"spring": Link(("ground", "body"), 1.0, 0.2)},
        forces={"push": Force("body", 0.0, 1.0)}, walls=dict(list(walls.items())[:sides]),
    )  # fmt: skip
    squares = np.roots([1.0, 0.2**2 - 2.0, 1.0 - 1 / 1.8**2])
    expected = np.sqrt(squares) / (2 * np.pi)
    branch = follow(oscillator, "frequency", begin, end)
    *others, last_one = branch.special
    assert [each.kind.word for each in others] == beside
    assert (last_one.kind.word, last_one.parts) == ("grazing", tuple(walls)[:sides])
    assert min(abs(last_one.value / expected - 1)) < 1e-10
    assert "touched there without speed" in branch.message
    # The state there is that of the linear motion, whose amplitude is the gap.
    position, velocity = last_one.state
    assert np.hypot(position, velocity / (2 * np.pi * last_one.value)) == pytest.approx(1.8, rel=1e-8)


def test_a_branch_ends_where_a_wall_that_is_struck_is_just_missed_later() -> None:
    parts = {"air": Link(("crank", "hammer"), 15e3, 20.0), "tip": Link(("ground", "chisel"), 2e5, 300.0)}
    drill = Mechanism(
        {"hammer": Body(0.25), "chisel": Body(0.4)}, frequency=40.0, links=parts,
        pins={"crank": Pin("ground", 8e-3)}, walls={"anvil": Wall(("hammer", "chisel"), 0.5, gap=6e-3)},
    )  # fmt: skip
    branch = follow(drill, "pins.crank.amplitude", 3e-3, 14e-3)
    assert (branch.special[-1].kind.word, branch.special[-1].parts) == ("grazing", ("anvil",))
    assert not (orbit := respond(drill).motions[0].orbit).flow.grazed(orbit.course)
    hammer, chisel = branch.special[-1].state.reshape(2, 2).T.tolist()
    there = replace(drill, start={"hammer": hammer, "chisel": chisel})
    there = there.with_value("pins.crank.amplitude", branch.special[-1].value * (1 - 1e-9))
    _, states = (motion := simulate(there, 0.025)).course.at(np.linspace(0.022, 0.025, 30_001))
    assert len(motion.events) == 1 and (states[:, 1] - states[:, 0]).max() == pytest.approx(6e-3, rel=1e-6)


def with_walls(seed: int) -> Mechanism:
    """A random mechanism from rest with curves, and walls that its bodies meet: to the ground, of two."""
    made, random = curved(random_mechanism(seed), seed), np.random.default_rng(seed)
    length = max(abs(pin.amplitude) for pin in made.pins.values())
    names = list(made.bodies)
    ends = [("ground", names[0]), *([(names[1], names[0])] if len(names) > 1 else [])]
    walls = {
        f"wall {number}": Wall(pair, float(random.uniform(0.5, 1.0)), float(length * random.uniform(0.1, 1)))
        for number, pair in enumerate(ends)
    }
    return replace(made, walls=walls, start={})


def test_an_impact_lets_nothing_go_that_it_does_not_touch() -> None:
    """What sticks together has drifted apart by the rounding of a long way."""
    events = simulate(with_every_part(300013), 1.2).events
    assert [each.part for each in events if each.time > 1.18] == ["wall 1"]


@pytest.mark.parametrize("seed", quick(range(3, 60, 3), 5))
def test_random_mechanisms_with_walls(seed):
    compare(with_walls(seed), 2)
