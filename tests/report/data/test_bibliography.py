"""The works that are cited, and the words by which a text cites them."""

import re

import pytest

from report.data.bibliography import cited, works


def test_works_are_in_order_and_have_their_own_names() -> None:
    names = [work.name for work in works()]
    assert len(set(names)) == len(names)
    assert [work.short for work in works()] == sorted(work.short for work in works())
    assert all(re.search(r"\d{4}", work.published) for work in works())


@pytest.mark.parametrize(
    ("text", "names"),
    [
        ("Loeb's criterion", ["loeb"]),
        ("Tsypkin's condition in closed form", ["tsypkin"]),
        ("confirmed by SciPy's matrix exponential", ["moler", "virtanen"]),
        ("the Floquet multipliers of the exact orbits", ["floquet", "leine"]),
        ("integrated by DOP853; proven by ball arithmetic", ["hairer", "johansson"]),
        ("quotient of the two frequencies", []),
    ],
)
def test_a_method_is_cited_where_it_is_named(text: str, names: list[str]) -> None:
    assert [work.name for work in cited(text)] == names
