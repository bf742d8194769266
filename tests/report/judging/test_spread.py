"""How a slip spreads: edges from data, their order, and the picture."""

from dataclasses import replace

import pytest

from report.data.statements import read_follows, read_inventory
from report.judging.spread import Follows, SpreadError, in_order, read_edges
from report.judging.verdict import Verdict
from report.rendering.pictures.spread_picture import description, spread, spread_picture
from tests.report.rendering.sample import sample

EDGES = (
    Follows("eq-2.9", "eq-2.8", "put in"),
    Follows("fig-5.1", "eq-2.9", "computed by it"),
    Follows("tab-5.1", "fig-5.1", "read off"),
    Follows("lst-A.1", "eq-2.9", "solves it"),
)


@pytest.fixture(scope="module")
def document():
    return replace(sample(), spread=EDGES)


def test_the_slip_of_equation_2_46_reaches_section_5_2_3():
    edges = read_follows(read_inventory())
    order = in_order(edges)
    chain = ["eq-2.46", "lst-A.5", "fig-5.16", "txt-5.2.3-unstable-inner"]
    assert [claim for claim in order if claim in chain] == chain


def test_an_edge_to_nowhere_is_an_error(tmp_path):
    path = tmp_path / "edges.csv"
    path.write_text("id,follows_from,how\neq-2.46,eq-99,read\n", encoding="utf-8")
    with pytest.raises(SpreadError, match="eq-99"):
        read_edges(read_inventory(), path)


def test_a_circle_is_an_error():
    with pytest.raises(SpreadError, match="follow from each other"):
        in_order((*EDGES, Follows("eq-2.8", "tab-5.1", "back")))


def test_each_statement_stands_once_and_below_what_it_follows_from(document):
    places = {place.finding.id: place for place in spread(document)}
    assert list(places) == ["eq-2.8", "eq-2.9", "fig-5.1", "tab-5.1", "lst-A.1"]
    assert [place.depth for place in places.values()] == [0, 1, 2, 3, 2]
    for edge in EDGES:
        assert places[edge.source].row in places[edge.claim].above
        assert places[edge.source].row < places[edge.claim].row


def test_a_statement_of_two_waits_for_both(document):
    both = replace(document, spread=(*EDGES, Follows("lst-A.1", "tab-5.1", "too")))
    places = spread(both)
    assert places[-1].finding.id == "lst-A.1"
    assert len(places[-1].above) == 2


def test_the_slip_stops_where_a_statement_holds(document):
    for place in spread(document):
        assert place.holds == (place.finding.verdict is Verdict.REPRODUCED)
        if place.above and place.holds:
            assert "the slip stops" in spread_picture(document)


def test_the_picture_says_in_words_what_it_shows(document):
    picture = spread_picture(document)
    assert picture.count("<rect") == len(spread(document))
    assert picture.count('class="edge"') == len(EDGES)
    assert description(document).count("follows from") == len(EDGES)
