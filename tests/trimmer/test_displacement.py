from itertools import permutations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from trimmer.thesis import CUTTER_RELATIVE_TO_GUARD, Displacement, DisplacementError, TrimmerBody

EVERY = [*map(Displacement, TrimmerBody), *(Displacement(*pair) for pair in permutations(TrimmerBody, 2))]


def test_the_thesis_output_is_cutter_relative_to_guard() -> None:
    assert CUTTER_RELATIVE_TO_GUARD.label == "q2-q4"
    assert CUTTER_RELATIVE_TO_GUARD.row == (0.0, 1.0, 0.0, -1.0)  # equation 2.14


@pytest.mark.parametrize("displacement", EVERY, ids=lambda displacement: displacement.label)
def test_labels_read_back(displacement: Displacement) -> None:
    assert Displacement.parse(displacement.label) == displacement


@pytest.mark.parametrize("text", ["", "q", "q0", "q5", "q2-q4-q1", "q²", "output", 60 * "q2"])
def test_what_is_no_displacement_is_refused_with_what_to_write(text: str) -> None:
    with pytest.raises(DisplacementError, match=r"q2-q4.*q1 motor, q2 cutter, q3 housing, q4 guard"):
        Displacement.parse(text)


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        *(("q2-", "q2"), ("-q2", "q2"), ("2", "q2"), ("Cutter", "q2"), ("x3", "q3"), ("q33", "q3")),
        *(("q2+q4", "q2-q4"), ("q2−q4", "q2-q4"), ("q24", "q2-q4"), ("2-4", "q2-q4"), ("x2_x4", "q2-q4")),
        *(("cutter-guard", "q2-q4"), ("guard relative to housing", "q4-q3")),
    ],
)
def test_a_displacement_that_was_meant_is_named(text: str, meant: str) -> None:
    with pytest.raises(DisplacementError, match=rf"is not a displacement: did you mean {meant}\?$"):
        Displacement.parse(text)


def test_a_body_relative_to_itself_is_refused() -> None:
    with pytest.raises(DisplacementError, match="q3-q3 is zero"):
        Displacement(TrimmerBody.HOUSING, TrimmerBody.HOUSING)


@given(st.text(max_size=12))
def test_any_text_is_read_or_refused(text: str) -> None:
    try:
        displacement = Displacement.parse(text)
    except DisplacementError:
        return
    assert displacement in EVERY
