"""The layout of drawn mechanisms: nothing crosses, nothing is left out."""

from collections.abc import Collection
from itertools import chain, combinations, pairwise, product
from pathlib import Path
from random import Random

import pytest

from report.design.diagram.diagram import mechanism_diagram
from report.design.diagram.layout import DiagramLayout, joints_of, layout_of
from report.pages.drawing.style import style
from tests.quick import quick
from trimmer.design.specification.design_file import design_file_of_text
from trimmer.examples import example_text, examples
from trimmer.mechanism import GROUND, Mechanism

FOLDER = Path(__file__).parents[3] / "examples"


@pytest.fixture(scope="module", params=examples())
def mechanism(request: pytest.FixtureRequest) -> Mechanism:
    return design_file_of_text(example_text(request.param), request.param, FOLDER).mechanism


@pytest.fixture(scope="module")
def layout(mechanism: Mechanism) -> DiagramLayout:
    return layout_of(mechanism)


def test_no_part_runs_through_a_body_or_another_part(layout: DiagramLayout) -> None:
    columns = {body: place for place, body in enumerate(layout.bodies, start=1)}
    assert not layout.crossings
    for run in layout.runs:
        for body, (low, high) in layout.spans.items():
            assert not (run.left < columns[body] < run.right and low <= run.lane <= high)
        others = [each for each in layout.runs if each is not run and each.lane == run.lane]
        assert all(each.right <= run.left or run.right <= each.left for each in others)


def linked(pairs: Collection[tuple[str, str]]) -> DiagramLayout:
    """Return the layout of bodies that springs join."""
    links = (f's{n} = {{ between = ["{a}", "{b}"], stiffness = 1.0 }}' for n, (a, b) in enumerate(pairs))
    bodies = (f"{each} = {{ mass = 1.0 }}" for each in sorted({*chain(*pairs)} - {GROUND}))
    return layout_of(Mechanism.from_toml_text("\n".join(["[bodies]", *bodies, "[links]", *links])))


@pytest.mark.parametrize("seed", quick([24, 34, 38, *range(76, 84)], 0, 1, 2, 3))
def test_each_part_of_random_machines_that_runs_through_a_body_is_told(seed: int) -> None:
    chance = Random(seed)
    names = [GROUND, *(f"b{number}" for number in range(chance.randint(3, 6)))]
    pairs = [*pairwise(names), *(chance.sample(names, 2) for _ in range(chance.randint(3, 12)))]
    layout = linked([(a, b) for a, b in pairs])
    columns = {body: place for place, body in enumerate(layout.bodies, start=1)}
    assert {(run.joint.name, body) for run, body in layout.crossings} == {
        (run.joint.name, body)
        for run in layout.runs
        for body, (low, high) in layout.spans.items()
        if run.left < columns[body] < run.right and low <= run.lane <= high
    }


@pytest.mark.parametrize(
    ("pairs", "planar"),
    [
        ([*combinations("abcd", 2)], True),
        ([*combinations("abcde", 2)], False),
        ([*product("abc", "def")], False),
        ([*product("abc", "def")][:-1], True),
    ],
    ids=["four, each with each", "five", "three with three", "one spring fewer"],
)
def test_a_part_runs_through_a_body_where_no_drawing_can_do_without(pairs, planar) -> None:
    """Kuratowski: five bodies each joined with each, or three with three, cannot be drawn in a plane."""
    assert (not linked(pairs).crossings) == planar


def test_every_part_joins_its_two_ends(mechanism: Mechanism, layout: DiagramLayout) -> None:
    names = {0: GROUND, len(layout.bodies) + 1: GROUND} | dict(enumerate(layout.bodies, start=1))
    assert {(run.joint.section, run.joint.name) for run in layout.runs} == {
        (joint.section, joint.name) for joint in joints_of(mechanism)
    }
    for run in layout.runs:
        ends = (names[run.left], names[run.right])
        assert (ends[::-1] if run.turned else ends) == run.joint.carriers
        for end in ends:
            if end != GROUND:
                low, high = layout.spans[end]
                assert low <= run.lane <= high


def test_names_of_parts_stand_in_the_drawing(mechanism: Mechanism) -> None:
    with style():
        (axes,) = mechanism_diagram(mechanism).axes
    words = " ".join(" ".join(text.get_text().split()) for text in axes.texts)
    for joint in joints_of(mechanism):
        assert joint.name in words
    for name in (*mechanism.bodies, *mechanism.structures):
        assert name.split()[0] in words


def test_names_of_points_stand_above_them_within_the_drawing() -> None:
    text = "bodies = { a = { inertia = 1.0 }, b = { inertia = 1.0 } }\n[points]\n"
    text += "".join(f'{each}_of_a_flank = {{ {each} = "1 mm" }}\n' for each in "ab")
    text += '[plays]\nmesh = { between = ["a_of_a_flank", "b_of_a_flank"], stiffness = 1.0, gap = 1.0 }\n'
    with style():
        figure = mechanism_diagram(Mechanism.from_toml_text(text))
        figure.draw_without_rendering()
    texts = {each.get_text(): each.get_window_extent() for each in figure.axes[0].texts}
    assert {"a_of_a_flank", "b_of_a_flank"} <= {each.replace("\\", "") for each in texts}
    assert max(each.y1 for each in texts.values()) <= figure.bbox.y1


def test_many_bodies_are_placed_without_trying_every_order() -> None:
    names = [f"b{n}" for n in range(12)]
    layout = linked([*pairwise([GROUND, *names])])
    assert layout.bodies == tuple(names)
    assert not layout.crossings
