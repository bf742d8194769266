"""Each line of advice is a box that anybody can test with ``trimmer respond``, from rest."""

import json
from dataclasses import replace

import numpy as np
import pytest

from report.document.advice import advice_json
from report.numbers.twin.advice import (
    BOUNDED,
    LINES,
    Searched,
    Tried,
    attempt,
    climbed,
    holds,
    read_advice,
    tried_again,
)
from report.numbers.twin.kept_files import KeptDataError
from report.numbers.twin.mechanism import FORCE, SPEED
from report.twin.observation import UnsupportedObservationError
from report.twin.sections.design import SECTION
from tests.json_document import documented, keys
from trimmer.command_line.main import main

ADVICE = json.loads(advice_json(LINES))
NAMED = [line.id for line in LINES]
TOLD = [f"{line.id}, {bound.says}" for line in LINES for bound in line.bounds]


def test_the_file_has_the_keys_that_are_documented():
    found = {key.replace(".at_least", ".at_most") for key in keys(ADVICE, ("[].set", "[].over"))}
    assert {"[]" + key.removeprefix("[]") for key in found} == {
        key.replace(".PLACE", "") for key in documented("advice.json of trimmer report")
    } - {"[].at_least"}
    assert all(("at_most" in line) != ("at_least" in line) for line in ADVICE)


@pytest.mark.parametrize("line", LINES, ids=NAMED)
def test_a_box_reaches_five_per_cent_of_speed_and_half_of_the_friction_to_either_side(line):
    for place, share in ((SPEED, 0.05), (FORCE, 0.5)):
        low, high = line.over[place]
        middle = (low + high) / 2
        assert (high - low) / 2 >= share * middle * (1 - 1e-9)


@pytest.mark.parametrize("number", range(len(ADVICE)), ids=TOLD)
def test_it_holds_at_a_point_of_its_box_that_the_search_did_not_try(number, capsys, project_folder):
    line = ADVICE[number]
    shares = np.random.default_rng(1000 + number).random(len(line["over"])).tolist()
    point = {
        place: low + s * (high - low)
        for s, (place, (low, high)) in zip(shares, line["over"].items(), strict=True)
    }
    options = [f"--set={place}={value!r}" for place, value in (line["set"] | point).items()]
    assert main(["respond", str(project_folder / "examples" / "thesis-play.toml"), "--json", *options]) == 0
    found = json.loads(capsys.readouterr().out)
    assert found["kind"] in line["kinds"]
    value = found
    for key in line["measure"].split("."):
        value = value[key]
    assert line.get("at_least", -np.inf) <= value <= line.get("at_most", np.inf)


@pytest.mark.slow
@pytest.mark.parametrize("searched", read_advice(LINES), ids=NAMED)
def test_what_the_search_found_is_found_again(searched):
    """Of motions that repeat; those that do not differ with rounding."""
    for kept in searched.worst:
        (found,) = attempt(searched.line, kept.point)
        assert holds(searched.line, found)
        if found.kind == kept.kind == "periodic":
            assert found.values == pytest.approx(kept.values, rel=1e-4)


@pytest.mark.slow
def test_a_climb_ends_at_the_worst_that_is_kept():
    (found,) = (each for each in read_advice(LINES) if each.line.id == "soft")
    worst = max(each.values[2] for each in found.worst)
    line = replace(found.line, bounds=found.line.bounds[2:3])
    (beside,) = attempt(line, (104.78, 0.749, 212.4e-6, 5500.0))
    reached = climbed(Searched(line, {}, (beside,), ()))
    assert beside.values[0] < 0.99 * worst
    assert max(each.values[0] for each in reached.worst) == pytest.approx(worst, rel=1e-3)
    assert sum(reached.kinds.values()) > 50


def lowered(line, at, value):
    """A line whose bound lies just below a value that was found."""
    bounds = [*line.bounds]
    bounds[at] = replace(bounds[at], at_most=0.999 * value)
    return replace(line, bounds=tuple(bounds))


@pytest.mark.parametrize("at", range(3))
def test_a_bound_that_the_search_broke_stops_the_build(evidence, at):
    found = next(each for each in evidence.twin.advice if each.line.id == "calm")
    worst = max(each.values[at] for each in found.worst)
    broken = replace(found, line=lowered(found.line, at, worst))
    assert found.holds
    assert not broken.holds
    known = replace(evidence, twin=replace(evidence.twin, advice=(broken, *evidence.twin.advice[1:])))
    with pytest.raises(UnsupportedObservationError, match=r"twin-do-calm: .* does not hold"):
        SECTION.items[0].finished(known)


def test_a_bound_that_breaks_now_is_noticed_though_the_search_kept_it():
    (found,) = (each for each in read_advice(LINES) if each.line.id == "soft")
    again = tried_again(found)
    assert len(again.again) >= 4
    assert again.holds
    lower = lowered(found.line, 0, again.again[0].values[0])
    assert not replace(again, line=lower, worst=()).holds


def test_another_kind_of_motion_than_those_allowed_breaks_a_line():
    line = LINES[0]
    assert holds(line, Tried((), "periodic", (1.0, 1.0, 0.1)))
    assert not holds(line, Tried((), "chaotic", (1.0, 1.0, 0.1)))
    assert not holds(line, Tried((), "periodic", (1.0, None, 0.1)))
    assert "chaotic" in BOUNDED
    (found,) = (each for each in read_advice(LINES) if each.line.id == "calm")
    assert found.holds
    assert not replace(found, kinds={**found.kinds, "chaotic": 1}).holds


def test_a_search_of_another_box_is_refused():
    wider = replace(LINES[0], over=LINES[0].over | {SPEED: (140.0, 160.0)})
    with pytest.raises(KeptDataError, match=r"advice\.json .* was made from another .*make maps"):
        read_advice([wider, *LINES[1:]])
