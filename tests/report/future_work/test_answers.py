"""The answers to section 6.4: each holds, and some of what is kept for it is computed again."""

import re
from dataclasses import replace
from math import cos, pi

import pytest

from report.data.figures import FigureRecord
from report.document.extras import Observation
from report.future_work.chapter import SECTIONS, future_work
from report.numbers.future_work import compensation, felt, harmonics, load, scatter, second_play
from report.numbers.future_work.all import ANSWERS
from report.numbers.future_work.kept import shortened
from report.numbers.twin.kept_files import KeptDataError
from report.rendering.markdown import REPORT, to_markdown
from report.rendering.selection import select
from report.twin.observation import ObservationRecord
from tests.report.rendering.sample import sample

RECORDS = [item for section in SECTIONS for item in section.items if isinstance(item, ObservationRecord)]
ALIKE = 1e-6
"""Frequencies and amplitudes are solved to better than this; what shakes goes through some events more."""


@pytest.mark.parametrize("each", RECORDS, ids=lambda each: each.id)
def test_every_observation_holds(each, evidence, project_folder):
    found = each.finished(evidence)
    assert found.evidence
    assert not re.search(r"\b(nan|inf)\b", found.text)
    assert (project_folder / each.source).is_file()


def test_each_answer_has_a_figure_how_it_was_computed_and_its_limits():
    assert len(SECTIONS) == 6
    for section in SECTIONS:
        answer, figure, how, limits = section.items
        assert isinstance(figure, FigureRecord)
        assert [each.id for each in (answer, how, limits)] == [
            f"{section.id}-{name}" for name in ("answer", "how", "limits")
        ]


def test_the_chapter_stands_in_the_report_and_in_no_part_of_it(evidence):
    # Drawn without its sources: the sample names none of them.
    chapter = future_work(evidence)
    assert {type(each) for each in chapter.observations} == {Observation}
    document = replace(sample(), future_work=chapter)
    text = to_markdown(document)["future_work"]
    assert "future_work" in REPORT
    places = [text.index(f"#{section.id}") for section in SECTIONS]
    assert places == sorted(places)
    assert all(f"figures/{figure.id}.svg" in text for figure in chapter.figures)
    assert to_markdown(select(document, ["ch5"]))["future_work"].strip() == ""


@pytest.mark.parametrize("answer", ANSWERS, ids=lambda each: each.name)
def test_data_of_other_inputs_are_refused(answer):
    assert answer.read()
    with pytest.raises(KeptDataError, match=rf"{answer.path.name} .* made from another .*: run `make maps`"):
        replace(answer, inputs=[answer.inputs, 1]).read()


def kept(answer, table, *begins):
    """Return the rows of a kept table that begin in a way."""
    return [row for row in answer.read()[table] if tuple(row[: len(begins)]) == begins]


def alike(found, then, tolerance=ALIKE):
    for now, before in zip(shortened(found), then, strict=True):
        assert now == (pytest.approx(before, rel=tolerance) if isinstance(before, float) else before)


def test_motions_of_the_twin_come_out_again():
    alike(
        compensation.motion_row(compensation.compensated(0.25), 0.25, "exact"),
        *kept(compensation.COMPENSATION, "twin", 0.25, "exact"),
    )
    alike(
        second_play.motion_row(second_play.seated(40e-6, 110.0), 40e-6, "seat"),
        *kept(second_play.SECOND_PLAY, "seat 110 Hz", 40e-6),
    )
    alike(felt.felt_row(40e-6, 0.5, 110.0), *kept(felt.FELT, "map", 110.0, 40e-6, 0.5))


def test_limit_cycles_come_out_again():
    rows = harmonics.rows_of("friction", (1, 3))
    for row in rows:
        alike(row, *kept(harmonics.HARMONICS, "solutions", *row[:3]))
    _, parameters = scatter.drawn(scatter.FACTORS[2])
    for number in (0, 100, 200):
        alike(scatter.sample_row(parameters[number]), scatter.SCATTER.read()["samples 3"][number])
    alike(load.interval_row(740.0, 1.0), *kept(load.LOAD, "intervals", 740.0, 1.0), tolerance=1e-4)


@pytest.mark.slow
def test_what_is_dear_comes_out_again():
    then = kept(compensation.COMPENSATION, "too much", 1.25)
    for row, before in zip(compensation.orbit_rows(1.25), then, strict=True):
        alike(row, before)
    for row, before in zip(
        second_play.seat_rows(0.2), kept(second_play.SECOND_PLAY, "loop", 0.2), strict=True
    ):
        alike(row, before)
    alike(
        compensation.motion_row(compensation.fed_forward(0.5), 0.5, "pin"),
        *kept(compensation.COMPENSATION, "twin", 0.5, "pin"),
    )
    alike(load.curve_rows()[0], load.LOAD.read()["curves"][0], tolerance=1e-5)


def test_too_much_compensation_pushes_along_and_none_leaves_the_machine_as_it_is():
    assert compensation.fed_forward(0.0) == compensation.compensated(0.0)
    waves = compensation.fed_forward(0.5).forces["to the cutter"].harmonics
    others = compensation.fed_forward(0.5).forces["to the guard"].harmonics
    # The square wave with the sign of a cosine, at an eighth of a turn.
    value = sum(size * cos(order * pi / 4) for order, size, _ in waves)
    assert value == pytest.approx(0.5 * compensation.FRICTION, rel=0.03)
    assert [-size for _, size, _ in others] == [size for _, size, _ in waves]
