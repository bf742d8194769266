"""Claims as records of parts and prose, and how they are found."""

import pytest

from report.judging.parts import close, digits, equal, made_here, small, so, uncheckable
from report.judging.record import ClaimRecord, claim, text
from report.judging.text import RecordError, one_line


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


@pytest.mark.parametrize(
    ("items", "told"),
    [
        *(
            (lambda printed=each: [digits("size", printed, 8.28)], "txt-2: part 'size': .* no string of")
            for each in ("8,28", "8.28 times", "", 8.28)
        ),
        (lambda: [], "txt-2 has 0 texts"),
        (lambda: [text("Right.")] * 2, "txt-2 has 2 texts"),
        (lambda: [text("One.\n\nTwo.\n\nThree.")], "3 paragraphs"),
        (lambda: [text("At most $$6$$.")], r"single dollar signs: At most \$\$6\$\$\."),
    ],
)
def test_what_is_wrong_with_a_record_is_named_with_the_claim(items, told):
    with pytest.raises(RecordError, match=told):
        claim("txt-2")(lambda _: iter(items())).claim(None)


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
        (so("two signs", (True, True)), True),
        (so("two signs", (True, False)), False),
        (so("two signs", (False, True)), False),
    ],
)
def test_second_ways_can_disagree(second, agrees):
    assert second.comparison.compare().agrees is agrees


def test_every_statement_of_the_inventory_has_a_record(records, inventory):
    assert set(records.by_id) == set(inventory)


def test_figures_stand_in_the_order_of_the_inventory(records, inventory):
    order = list(inventory)
    places = [order.index(figure.id) for figure in records.figures]
    assert places == sorted(places)
    assert len(places) > 50


def test_a_text_block_is_one_line():
    block = r"""
        With $\frac{b}{A}$ and $\{1\}$ the gain
        is 2.0 at most.
        """
    assert one_line(block) == r"With $\frac{b}{A}$ and $\{1\}$ the gain is 2.0 at most."


def test_a_no_break_space_is_no_space_to_break_at():
    assert one_line("0.1\u00a0 m") == "0.1\u00a0 m"
