"""Observations: each has one text, and checks that hold."""

import re

import pytest

from report.judging.parts import small, so
from report.judging.record import text
from report.judging.text import RecordError
from report.twin.chapter import SECTIONS
from report.twin.observation import ObservationRecord, UnsupportedObservationError, observation

RECORDS = [item for section in SECTIONS for item in section.items if isinstance(item, ObservationRecord)]


def record(*items):
    return observation("twin-x", source="report/twin/chapter.py")(lambda known: iter(items))


def test_an_observation_shows_what_it_rests_on():
    found = record(text("It is 2.0 m."), so("seen", True), small("tiny", 0.0)).finished(None)
    assert (found.text, found.evidence) == ("It is 2.0 m.", ("seen", "tiny"))


def test_a_check_that_does_not_hold_stops_with_id_and_words():
    with pytest.raises(UnsupportedObservationError, match=r"twin-x.*the moon is near"):
        record(text("So."), so("the moon is near", False)).finished(None)


@pytest.mark.parametrize(
    "items", [(text("So."),), (so("seen", True),), (text("A."), text("B."), so("seen", True))]
)
def test_it_needs_one_text_and_a_check(items):
    with pytest.raises(RecordError, match="twin-x"):
        record(*items).finished(None)


def test_ids_are_unique():
    ids = [item.id for section in SECTIONS for item in section.items] + [section.id for section in SECTIONS]
    assert len(set(ids)) == len(ids)


@pytest.mark.parametrize("each", RECORDS, ids=lambda each: each.id)
def test_every_observation_holds(each, evidence):
    found = each.finished(evidence)
    assert found.evidence
    assert not re.search(r"\b(nan|inf)\b", found.text)


@pytest.mark.parametrize("each", RECORDS, ids=lambda each: each.id)
def test_its_source_is_a_file(each, project_folder):
    assert (project_folder / each.source).is_file()
