"""The benchmark problems: their form, that both ways find their digits, and what is refused of a file."""

import ast
import csv
import io
import json
import math
import sys
from dataclasses import replace
from pathlib import Path

import mpmath
import pytest

from benchmarks.problems import ask, proven, publish
from benchmarks.problems.read import KINDS, Digit, Problem, ProblemError, problems, read
from tests.quick import quick
from trimmer.proof import check_proof

PROBLEMS = {each.name: each for each in problems()}
OURS = (
    *("ball-to-rest", "conveyor", "falling-friction", "gear-rattle", "hardening-spring", "lever-play"),
    *("preloaded-stop", "sampled-axis", "servo-to-rest", "soft-wall", "structure-stop"),
)
SECOND = ("ball-to-rest", "den-hartog", "preloaded-stop", "sampled-axis")  # Asked in each quick run
GIVEN = """
title = "A"
kinds = ["play"]
statement = "x"
second_way = "closed.soft_wall"
ways = ["one", "two"]
python = "found = {}"
digits = [{ name = "a", value = 1.0, unit = "m", agreement = 1e-9 }]
"""


def test_the_collection_is_wide_and_whole() -> None:
    assert {kind for each in PROBLEMS.values() for kind in each.kinds} == KINDS
    folder = Path(publish.__file__).parent / "second_ways"
    for each in PROBLEMS.values():
        module, function = each.second_way.split(".")
        assert f"def {function}()" in (folder / f"{module}.py").read_text("utf-8")
        assert each.statement.isprintable() or "\n" in each.statement
        assert all(digit.ours or each.python for digit in each.digits)


@pytest.mark.parametrize("name", quick(PROBLEMS, *[list(PROBLEMS).index(each) for each in OURS]))
def test_the_package_finds_the_digits(name: str) -> None:
    problem = PROBLEMS[name]
    errors = ask.compared(problem, ask.ours(problem))
    assert all(errors[each.name] <= each.agreement for each in problem.digits), errors


@pytest.mark.parametrize("name", quick(PROBLEMS, *[list(PROBLEMS).index(each) for each in SECOND]))
def test_the_second_way_finds_the_digits(name: str) -> None:
    problem = PROBLEMS[name]
    errors = ask.compared(problem, ask.second(problem))
    assert all(errors[each.name] <= each.agreement for each in problem.digits), errors


@pytest.mark.parametrize(("found", "off"), [(1.23456789e-3, False), (1.2346e-3, True), (float("nan"), True)])
def test_what_is_further_off_than_the_file_says_is_shown(tmp_path: Path, found: float, off: bool) -> None:
    path = tmp_path / "a.toml"
    path.write_text(GIVEN.replace("value = 1.0", "value = 1.23456789e-3").replace("1e-9", "2e-6"), "utf-8")
    ((late, line),) = ask.held(read(path), {"ours": {"a": found}})
    assert late is off is line.endswith("  OFF")
    assert line.startswith("  a: 0.0012346 m, to 2e-06; ours ")


@pytest.mark.parametrize(
    ("keys", "value"),
    [
        (["x", 1, "half"], 2.0),
        (["x", 1, "minus"], -4.0),
        (["x", "count"], 3.0),
        (["z", "modulus"], 5.0),
        (["points", "fold", "turns"], 4.0 * math.pi),
        (["points", "torus"], 9.0),
    ],
)
def test_keys_lead_to_a_number(keys: list[str | int], value: float) -> None:
    points = [("fold", 1.0), ("torus", 9.0), ("fold", 2.0), ("fold", 4.0)]
    told = {"x": [1.0, 4.0, 2.0], "z": [3.0, -4.0], "points": [{"kind": k, "value": v} for k, v in points]}
    digit = Digit("a", value, "", 1e-9, ("one", "two"), tuple(keys))
    assert ask.followed(told, digit) == pytest.approx(value, rel=1e-15)


def test_a_second_way_with_many_digits_leaves_those_of_others_alone() -> None:
    before = mpmath.mp.dps
    ask.second(PROBLEMS["ball-to-rest"])
    assert mpmath.mp.dps == before


def test_second_ways_know_nothing_of_the_package() -> None:
    """Nor does what a function of theirs imports when it is called."""
    files = sorted((Path(publish.__file__).parent / "second_ways").glob("*.py"))
    nodes = [node for path in files for node in ast.walk(ast.parse(path.read_text("utf-8")))]
    used = {alias.name for node in nodes if isinstance(node, ast.Import) for alias in node.names}
    used |= {str(node.module) for node in nodes if isinstance(node, ast.ImportFrom)}
    outside = {name.split(".")[0] for name in used if not name.startswith("benchmarks.problems.second_ways.")}
    assert outside <= {*sys.stdlib_module_names, "mpmath", "numpy", "scipy"} - {"importlib"}


def test_what_is_published_has_every_digit() -> None:
    told = json.loads(publish.as_json())
    rows = list(csv.DictReader(io.StringIO(publish.as_csv())))
    page = publish.page()
    expected = [(each.name, digit.name, digit.value) for each in PROBLEMS.values() for digit in each.digits]
    assert [(p["name"], d["name"], d["value"]) for p in told["problems"] for d in p["digits"]] == expected
    assert [(row["problem"], row["digit"], float(row["value"])) for row in rows] == expected
    for each in PROBLEMS.values():
        assert f"## {each.title}\n" in page and each.statement in page
        assert all(f"| {digit.name} | {digit.printed} |" in page for digit in each.digits)


PROVEN = [
    (problem, digit)
    for problem in PROBLEMS.values()
    for digit in problem.digits
    if proven.proven_digits(problem, digit)
]


@pytest.mark.parametrize(("problem", "digit"), quick(PROVEN, 0, 1, 2, 3, 16))
def test_a_proven_digit_is_that_of_a_proof_that_holds(problem: Problem, digit: Digit) -> None:
    pytest.importorskip("flint")
    proof = check_proof(proven.file_of(problem, digit))
    assert proof.verdict == "proven"
    assert proven.digits_of(problem, digit, proof.theorem) == proven.proven_digits(problem, digit) >= 8
    for other in (
        replace(digit, value=digit.value * (1 + 1e-7)),
        replace(digit, name="impact speed", ours=("a", "b")),
    ):
        assert proven.digits_of(problem, other, proof.theorem) == 0


def test_kept_proofs_are_those_of_digits_and_are_counted() -> None:
    files = {proven.file_of(*each) for each in PROVEN}
    assert files == set(proven.PROOFS.glob("*.json"))
    told = json.loads(publish.as_json())
    counts = [digit["proven_digits"] for each in told["problems"] for digit in each["digits"]]
    assert sum(count > 0 for count in counts) == len(PROVEN) >= 105
    assert f"Of these numbers {len(PROVEN)} are proven too" in publish.page()


@pytest.mark.slow
@pytest.mark.parametrize(("problem", "digit"), PROVEN[::3])
def test_a_proof_is_made_again_of_the_problem(problem: Problem, digit: Digit) -> None:
    """What its file calls its equations is unchecked; here they are set up anew."""
    made = proven.prove(problem, digit)
    assert made is not None
    assert proven.digits_of(problem, digit, made.theorem) == proven.proven_digits(problem, digit)


def test_of_what_is_not_covered_nothing_is_proven() -> None:
    problem = PROBLEMS["damped-block"]
    end = next(each for each in problem.digits if each.name == "end of stick-slip")
    assert proven.prove(problem, end) is None


@pytest.mark.parametrize(
    ("before", "after", "sentence"),
    [
        ('title = "A"', "", "'title' is missing; add it"),
        ('title = "A"', 'title = "A"\nname = "b"', "unknown key 'name'; known are"),
        ('["play"]', '["plays"]', "kinds has 'plays'; known are control, friction, impact, play, stop"),
        ('["one", "two"]', '["one"]', "digit 'a' has 1 ways; two independent ones are needed"),
        ("value = 1.0", "value = nan", "give a number that is not 0, confirmed to 1e-05"),
        ("1e-9", "1e-3", "digit 'a' is 1.0 to 0.001; give a number"),
        (', unit = "m"', "", "digit 'a' lacks or has 'unit'"),
        ("1e-9 }", '1e-9 }, { name = "a", value = 1.0, unit = "", agreement = 1e-9 }', "'a' is there twice"),
        ('python = "found = {}"', "", "give machine and asks, or python"),
    ],
)
def test_what_is_wrong_with_a_file_is_said(tmp_path: Path, before: str, after: str, sentence: str) -> None:
    assert before in GIVEN
    path = tmp_path / "a.toml"
    path.write_text(GIVEN.replace(before, after), encoding="utf-8")
    with pytest.raises(ProblemError, match=r"^a\.toml: ") as told:
        read(path)
    assert sentence in str(told.value)
