"""Claims as records, and how they are found."""

import pytest

from report.judging.parts import close, digits, equal, made_here, repeated, small, so, uncheckable
from report.judging.record import ClaimRecord, claim, text
from report.judging.text import RecordError


@claim("txt-1")
def complete(known):
    yield digits("amplitude", "1.50", known, "m", slip=made_here("a slip of the pen", 1.5), item="1.50 m")
    yield uncheckable("frequency", "488 Hz", "the parameters", item="488 Hz")
    yield text(f"""
        It is {known:.1f} m.
        It is not 1.50 m.

        Nothing follows.
    """)


def test_a_record_gives_its_claim_in_the_order_of_its_parts():
    made = complete.claim(2.5)
    assert isinstance(complete, ClaimRecord)
    assert [part.label for part in made.parts] == ["amplitude", "frequency"]
    assert [part.item for part in made.parts] == ["1.50 m", "488 Hz"]
    assert (made.explanation, made.consequence) == ("It is 2.5 m. It is not 1.50 m.", "Nothing follows.")


def test_a_text_of_one_paragraph_has_no_consequence():
    @claim("txt-1")
    def right(_):
        yield text("Right.")

    assert right.claim(None).consequence == ""


def test_what_is_wrong_with_a_record_is_named_with_the_claim():
    @claim("txt-2")
    def comma(_):
        yield digits("amplitude", "8,28", 8.28)

    with pytest.raises(RecordError, match=r"claim txt-2: part 'amplitude'"):
        comma.claim(None)


@pytest.mark.parametrize("count", [0, 2])
def test_a_claim_has_one_text(count):
    @claim("txt-3")
    def items(_):
        yield from [text("Right.")] * count

    with pytest.raises(RecordError, match=f"txt-3 has {count} texts"):
        items.claim(None)


def test_a_text_has_no_third_paragraph():
    with pytest.raises(RecordError, match="3 paragraphs"):
        _ = text("One.\n\nTwo.\n\nThree.").paragraphs


@pytest.mark.parametrize(
    ("second", "agrees"),
    [
        (close("a grid", 1.0, 1.0 + 1e-12), True),
        (close("a grid", 1.0, 1.1), False),
        (equal("a count", 3, 3), True),
        (equal("a count", 3, 4), False),
        (small("a residual", -1e-12), True),
        (small("a residual", 1e-3, 1e-6), False),
        (so("a proof", True), True),
        (so("a proof", False), False),
    ],
)
def test_second_ways_can_disagree(second, agrees):
    assert second.comparison.compare().agrees is agrees


def test_a_slip_is_made_here_or_repeated():
    assert made_here("a", 1).verdict.value == "erratum"
    assert repeated("a", 1).verdict.value == "explained"


def test_every_statement_of_the_inventory_has_a_record(records, inventory):
    assert set(records.by_id) == set(inventory)


def test_figures_stand_in_the_order_of_the_inventory(records, inventory):
    order = list(inventory)
    places = [order.index(figure.id) for figure in records.figures]
    assert places == sorted(places)
    assert len(places) > 50


@pytest.mark.parametrize("printed", ["8,28", "8.28 times", "", 8.28])
def test_printed_digits_are_a_string_of_digits(printed):
    with pytest.raises(RecordError, match="no string of digits"):
        digits("amplitude", printed, 8.28)
