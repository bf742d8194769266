"""What loops settle to, their branches, maps and samples: beside the same machine, by laws, on paper."""

import json
import math
from pathlib import Path

import control
import numpy as np
import pytest
import scipy.linalg
import scipy.optimize
from matplotlib.figure import Figure

import trimmer
from trimmer import SerialRunner
from trimmer.command_line.mechanisms import follow_text, respond_text, sample_text
from trimmer.design import Measure
from trimmer.loops import BodyFriction
from trimmer.uncertainty import SampleSettings, SampleStudy, uncertainty_from

EXAMPLES = Path(__file__).parents[3] / "examples"
THESIS = trimmer.TrimmerParameters.thesis()
FORCE, BLADE, CUTTER = "frictions.q2-q4.force", "frictions.blade.force", "bodies.cutter.mass"
QUIET = trimmer.FollowSettings(quiet=True, largest_step=0.1)


def driven(force: float, gap: float | None = None, static: float | None = None) -> trimmer.TrimmerLoop:
    """The thesis's trimmer at 110 Hz, with dry friction between cutter and guard."""
    play = None if gap is None else trimmer.FrictionBacklash(gap)
    between = (BodyFriction("q2-q4", trimmer.CoulombFriction(force, static)),)
    return trimmer.TrimmerLoop(THESIS, play, trimmer.Drive(1.5e-3, frequency=110.0), frictions=between)


@pytest.fixture(scope="module")
def machine(tmp_path_factory: pytest.TempPathFactory) -> trimmer.Mechanism:
    """The same machine from its bodies and springs, without play."""
    rubs = '\n[frictions]\nblade = { between = ["cutter", "guard"], force = "1 N" }\n'
    file = tmp_path_factory.mktemp("machine") / "rubbing.toml"
    file.write_text((EXAMPLES / "thesis.toml").read_text("utf-8") + rubs, "utf-8")
    return trimmer.Mechanism.from_toml(file)


def relay(level: float) -> trimmer.ClosedLoop:
    """A relay around 1/(s (s + 1) (s + 2)), all of it plain numbers."""
    return trimmer.ClosedLoop(control.tf([1.0], [1.0, 3.0, 2.0, 0.0]), trimmer.Relay(level))


def period_of_relay() -> float:
    """The period of its limit cycle: the output is zero where a square wave of that period switches.

    A state x' = u - p x with x(T/2) = -x(0) switches at -tanh(p T/4)/p, at -T/4 for p = 0; the output is half
    the first of three such states less the second and half the third, p = 0, 1, 2.
    """

    def output(quarter: float) -> float:
        return 0.5 * quarter - math.tanh(quarter) + 0.25 * math.tanh(2.0 * quarter)

    return 4.0 * float(scipy.optimize.brentq(output, 0.5, 3.0, xtol=1e-14))


@pytest.mark.parametrize(("force", "static"), [(0.3, 0.3), (2.0, 2.0), (2.0, 3.5), (8.0, 8.0)])
def test_without_play_a_loop_settles_as_the_machine_does(machine, force, static) -> None:
    loop = trimmer.respond(driven(force, static=static)).motion
    sticky = machine.with_value("frictions.blade.force", force).with_value("frictions.blade.static", static)
    mechanism = trimmer.respond(sticky).motion
    np.testing.assert_allclose(loop.orbit.multipliers, mechanism.orbit.multipliers, atol=1e-9)
    ours, theirs = loop.orbit.measures, mechanism.orbit.measures
    output, stroke = ours.outputs["output"], theirs.outputs["stroke"]
    assert output.peak_to_peak == pytest.approx(stroke.peak_to_peak, rel=1e-10)
    np.testing.assert_allclose(output.amplitudes, stroke.amplitudes, atol=1e-11 * stroke.peak_to_peak)
    friction, blade = ours.frictions["friction q2-q4"], theirs.frictions["blade"]
    assert (friction.work, friction.power) == pytest.approx((blade.work, blade.power), rel=1e-9)
    assert friction.stick == pytest.approx(blade.stick, abs=1e-9)


@pytest.mark.parametrize("scale", [0.013, 7.0])
def test_a_motion_grows_with_its_gap_drive_and_friction(scale: float) -> None:
    small = driven(2.0, 2e-4)
    large = small
    for place in ("element.gap", "drive.amplitude", FORCE):
        large = large.with_value(place, scale * small.value(place))
    first, second = (trimmer.respond(each).motion for each in (small, large))
    np.testing.assert_allclose(first.orbit.multipliers, second.orbit.multipliers, atol=1e-9)
    for name, size in first.peak_to_peak.items():
        assert second.peak_to_peak[name] == pytest.approx(scale * size, rel=1e-9)
    play, larger = (each.orbit.measures.contacts["backlash"] for each in (first, second))
    assert larger.impact_speeds == pytest.approx([scale * each for each in play.impact_speeds], rel=1e-8)
    assert (larger.share, larger.impacts) == pytest.approx((play.share, play.impacts), rel=1e-9)


def test_a_map_of_a_loop_has_what_each_of_its_cells_settles_to() -> None:
    loop, gaps, forces = driven(1.0, 4e-5), [4e-5, 2e-4], [1.0, 5.0]
    places = {"element.gap": gaps, FORCE: forces}
    found = trimmer.motion_map(loop, places, runner=SerialRunner(), quiet=True)
    assert found.units == ("m", "N")
    for row, force in enumerate(forces):
        for column, gap in enumerate(gaps):
            motion = trimmer.respond(driven(force, gap)).motion
            assert found.kind[row, column] is motion.kind
            assert found.stroke[row, column] == pytest.approx(motion.peak_to_peak["output"], rel=1e-9)
            power = motion.measures.frictions["friction q2-q4"].power
            assert found.wear_power["friction q2-q4"][row, column] == pytest.approx(power, rel=1e-8)


def test_a_basin_of_a_loop_is_that_of_the_same_machine(machine: trimmer.Mechanism) -> None:
    """Where the blade sticks for good, the motion depends on where it began."""
    held, reached = machine.with_value(BLADE, 60.0), []
    for subject, place in ((driven(60.0), "q2"), (held, "cutter.displacement")):
        values = {place: [-2e-4, 0.0, 3e-4]}
        found = trimmer.basin(subject, values, runner=SerialRunner(), quiet=True).result
        assert found.searched.startswith("3 cells, each from a start of its own, for at most")
        reached.append([cell.motions[0].states for cell in found.cells])
    assert np.ptp(reached[0], axis=0).max() > 1e-5
    np.testing.assert_allclose(reached[0], reached[1], atol=1e-9 * np.abs(reached[1]).max())


def test_a_start_of_a_loop_is_that_of_its_motions_unless_another_is_given() -> None:
    loop = trimmer.ClosedLoop(relay(1.0).model, trimmer.Relay(1.0))
    begun, states = loop.with_value("start.x[1]", 0.2), [0.0, 0.2, 0.0]
    own, given = trimmer.simulate(begun, 1.0), trimmer.simulate(loop, 1.0, initial_state=states)
    np.testing.assert_array_equal(own.output([0.5, 1.0]), given.output([0.5, 1.0]))
    assert (begun.value("start.x[1]"), begun.start) == (0.2, {"x[1]": 0.2})
    np.testing.assert_array_equal(trimmer.simulate(begun, 1.0, initial_state=[0.0] * 3).output([1.0]), [0.0])
    with pytest.raises(trimmer.TrimmerError, match="no state of the loop; there are"):
        trimmer.ClosedLoop(begun.system, begun.element, start={"q7": 1.0})


def test_samples_of_a_loop_are_those_of_the_same_machine(machine: trimmer.Mechanism) -> None:
    strokes, powers = [], []
    for subject, force, mass in ((driven(1.0), FORCE, "parameters.m2"), (machine, BLADE, CUTTER)):
        scattering = uncertainty_from(subject, {force: {"uniform": [0.5, 1.5]}, mass: {"normal": "3 %"}})
        found = trimmer.sample(subject, scattering, SampleSettings(4, seed=2), runner=SerialRunner())
        assert (found.kinds, found.impossible, found.failed) == ({"period 1": 4}, 0, 0)
        asked = {each.measure: each for each in reversed(found.asked)}  # Of strokes the first one.
        strokes.append(found.measured(asked[Measure.STROKE]))
        powers.append(found.measured(asked[Measure.WEAR_POWER]))
    np.testing.assert_allclose(strokes[0], strokes[1], rtol=1e-10)
    np.testing.assert_allclose(powers[0], powers[1], rtol=1e-9)


def test_energies_are_asked_of_a_loop_as_of_a_machine(machine: trimmer.Mechanism) -> None:
    ours, theirs = (trimmer.simulate(each, 0.03) for each in (driven(1.0), machine))
    assert trimmer.energy_balance(ours) == ours.energy
    assert trimmer.energy_balance(theirs) is theirs.energy
    assert ours.energy.kinetic == pytest.approx(theirs.energy.kinetic, rel=1e-9)
    assert ours.energy.friction_loss == pytest.approx(theirs.energy.frictions["blade"], rel=1e-9)
    for each in (ours.energy, theirs.energy):
        stored, kinetic = each.stored[1] - each.stored[0], each.kinetic[1] - each.kinetic[0]
        assert each.work == pytest.approx(kinetic + stored + each.loss, rel=1e-12)


def test_plain_numbers_have_no_units() -> None:
    scattering = uncertainty_from(relay(1.0), {"element.level": {"normal": "5 %"}})
    drive = trimmer.Drive(1.0, omega=1.5)
    driven_relay = trimmer.OpenLoop(control.tf([1.0], [1.0, 0.3, 1.0]), trimmer.Relay(1.0), drive)
    samples = trimmer.sample(driven_relay, scattering, SampleSettings(3), runner=SerialRunner())
    data = json.loads(sample_text.as_json(SampleStudy(samples, {}, None, math.nan)))
    assert {each["unit"] for each in data["measures"]} == {""}
    assert set(samples.to_dataframe().attrs["units"].values()) == {""}
    for drawn in (samples, trimmer.simulate(driven_relay, 9.0)):
        axes = drawn.plot(Figure().add_subplot())
        assert {axes.get_xlabel(), axes.get_ylabel()} <= {
            "peak to peak of output",
            "samples",
            "signals",
            "time, s",
        }


def test_what_no_samples_are_of_is_told() -> None:
    scattering = uncertainty_from(relay(1.0), {"element.level": {"normal": "5 %"}})
    with pytest.raises(trimmer.TrimmerError, match=r"there is no number at element\.level"):
        trimmer.sample(driven(1.0), scattering)


def test_a_relay_oscillates_at_one_period_and_in_proportion_to_its_level() -> None:
    branch = trimmer.follow(relay(1.0), "element.level", 1.0, 2.0, settings=QUIET)
    assert branch.success
    assert branch.periods == 1
    assert not branch.special
    expected = period_of_relay()
    sizes = {point.outputs["output"].peak_to_peak / point.value for point in branch.points}
    assert max(sizes) / min(sizes) == pytest.approx(1.0, abs=1e-9)
    for point in branch.points:
        assert point.period == pytest.approx(expected, rel=1e-10)
        assert point.outputs["element_output"].peak_to_peak == pytest.approx(2.0 * point.value, rel=1e-9)
    settled = trimmer.respond(relay(2.0), state=[0.1, 0.0, 0.0]).motion
    assert settled.orbit.period == pytest.approx(expected, rel=1e-10)
    assert settled.peak_to_peak["output"] == pytest.approx(2.0 * max(sizes), rel=1e-9)


def test_of_a_loop_without_units_nothing_has_one() -> None:
    branch = trimmer.follow(relay(1.0), "element.level", 1.0, 1.01, settings=QUIET)
    response = trimmer.respond(relay(1.0), state=[0.1, 0.0, 0.0], starts=2)
    told = f"{follow_text.as_text(branch, None)}\n{respond_text.as_text(response)}"
    told += respond_text.as_text(trimmer.respond(relay(1.0)))
    heads = told.replace("(", " ").replace(")", " ").replace(",", " ").split()
    assert not {"m", "N", "m/s", "J", "W", "m/s²", "body", "mechanism", "force"} & set(heads)
    for result in (branch, response):
        assert set(result.to_dataframe().attrs["units"].values()) <= {"", "s"}


def test_where_stick_begins_a_simulation_sticks_on_one_side_and_not_on_the_other() -> None:
    branch = trimmer.follow(driven(0.3), FORCE, 0.3, 0.5, settings=QUIET)
    (special,) = branch.special
    assert special.kind is trimmer.branches.SpecialKind.STICK
    assert special.parts == ("friction q2-q4",)

    def sticks(force: float) -> int:
        motion = trimmer.simulate(driven(force), 0.6)
        late = (event for event in motion.events if event.time > 0.5)
        return sum(event.kind is trimmer.loops.EventKind.STICK for event in late)

    assert sticks(0.999 * special.value) == 0
    # Twice in each of the eleven periods of the last tenth of a second.
    assert sticks(1.001 * special.value) == 22


def test_a_closed_trimmer_follows_its_limit_cycle_in_proportion_to_its_gap() -> None:
    loop = trimmer.TrimmerLoop(THESIS, trimmer.FrictionBacklash(4e-5))
    branch = trimmer.follow(loop, "element.gap", "40 um", "44 um", settings=QUIET)
    orbit = next(each for each in trimmer.periodic_orbits(loop) if each.stable)
    first, last = branch.points[0], branch.points[-1]
    assert (first.period, last.period) == pytest.approx((orbit.period, orbit.period), rel=1e-10)
    assert first.outputs["element_input"].peak_to_peak == pytest.approx(2.0 * orbit.amplitude, rel=1e-9)
    assert last.outputs["element_input"].peak_to_peak == pytest.approx(2.2 * orbit.amplitude, rel=1e-9)


def test_an_open_loop_that_reverses_at_quarters_of_its_period_is_followed() -> None:
    """The start of the period is amid a segment then. The friction alone drives what is linear behind it."""
    rubs = trimmer.CoulombFriction(0.5)
    loop = trimmer.TrimmerLoop(THESIS, rubs, trimmer.Drive(5e-4, frequency=269.0), channels="displacement")
    branch = trimmer.follow(loop, "element.force", 0.5, 0.75, settings=QUIET)
    first, last = (branch.points[at].outputs["output"].peak_to_peak for at in (0, -1))
    assert last == pytest.approx(1.5 * first, rel=1e-12)


def test_a_closed_trimmer_whose_friction_stops_it_has_no_branch() -> None:
    rubs = (BodyFriction("q2-q4", trimmer.CoulombFriction(2.0)),)
    loop = trimmer.TrimmerLoop(THESIS, trimmer.FrictionBacklash(4e-5), frictions=rubs)
    branch = trimmer.follow(loop, "element.gap", "40 um", "44 um", settings=QUIET)
    assert not branch.points
    assert "comes to rest" in branch.message


CLOSED = trimmer.TrimmerLoop(THESIS, trimmer.FrictionBacklash(4e-5))


def test_a_map_of_a_loop_that_moves_by_itself_has_its_stable_orbits() -> None:
    """Lengths scale with the gap, and with them the forces that stop it."""
    (stable,) = (each for each in trimmer.periodic_orbits(CLOSED) if each.stable)
    alone = trimmer.motion_map(CLOSED, {"element.gap": [4e-5, 8e-5]}, runner=SerialRunner())
    assert alone.peak_to_peak["element_input"][0] == pytest.approx(
        [2 * stable.amplitude, 4 * stable.amplitude]
    )
    rubbed = trimmer.TrimmerLoop(
        THESIS,
        trimmer.FrictionBacklash(4e-5),
        frictions=(BodyFriction("q2-q4", trimmer.CoulombFriction(1.0)),),
    )
    places = {"element.gap": [2e-5, 4e-5], FORCE: [0.1, 0.2, 2.0]}
    found = trimmer.motion_map(rubbed, places, runner=SerialRunner())
    assert found.stroke[1, 1] == pytest.approx(2 * found.stroke[0, 0], rel=1e-9) != 0.0
    assert found.kind[2].tolist() == [trimmer.MotionKind.REST] * 2
    assert "what they lead to with friction" in found.searched


@pytest.mark.parametrize(
    ("damping", "element", "kind"),
    [
        (1, trimmer.Saturation(1.0), trimmer.MotionKind.REST),
        (-1, trimmer.DeadZone(1.0, slope=0.1), trimmer.MotionKind.DIVERGING),
    ],
)
def test_a_map_of_a_loop_without_an_orbit_tells_how_all_motions_end(damping, element, kind) -> None:
    loop = trimmer.ClosedLoop(control.tf([1.0], [1, damping, 1]), element)
    found = trimmer.motion_map(loop, {"element.threshold": [1.0]}, runner=SerialRunner())
    assert found.cells[0].motions[0].kind is kind


@pytest.mark.parametrize(
    ("ask", "told"),
    [
        (lambda: trimmer.follow(CLOSED, "frequency", 100.0, 110.0), "no number at frequency"),
        (lambda: trimmer.follow(CLOSED, "element.gp", 1e-5, 2e-5), "did you mean element.gap"),
        (lambda: trimmer.follow(CLOSED, "element.gap", "40 s", "50 s"), "'s' does not measure what m does"),
        (lambda: trimmer.follow(CLOSED, "element.gap", -1e-5, 1e-5), "gap must be positive"),
        (
            lambda: trimmer.motion_map(CLOSED, {"element.gap": [1e-5]}, starts=2),
            "starts: the orbits of a loop",
        ),
        (lambda: trimmer.respond(CLOSED, state={"q5": 1.0}), "no state of the loop; there are q1"),
        (lambda: trimmer.respond(CLOSED, state=[1.0]), r"has the shape \(1,\), but the loop has"),
    ],
)
def test_what_a_loop_is_not_asked_for(ask, told: str) -> None:
    with pytest.raises(trimmer.errors.TrimmerError, match=told):
        ask()


@pytest.mark.parametrize("seed", range(3))
def test_of_an_undamped_loop_rounding_damps_nothing(seed: int) -> None:
    """Vibrations of 1 and sqrt(3) rad/s within a dead zone, in states that mix them: real parts are 1e-16."""
    mixed = np.random.default_rng(seed).normal(size=(4, 4))
    turning = scipy.linalg.block_diag([[0, 1], [-1, 0]], np.sqrt(3) * np.array([[0, 1], [-1, 0]]))
    flow = mixed @ turning @ np.linalg.inv(mixed)
    outputs = np.array([[1.0, 0.0, 1.0, 0.0]]) @ np.linalg.inv(mixed)
    plant = control.ss(flow, mixed @ np.ones((4, 1)), outputs, 0.0)
    loop = trimmer.ClosedLoop(plant, trimmer.DeadZone(1.0))
    response = trimmer.respond(loop, state=mixed @ [0.2, 0.0, 0.3, 0.0])
    assert response.kind is trimmer.MotionKind.TORUS
    assert "nothing damps the free vibrations of 0.159155 and 0.275664 Hz" in response.message
