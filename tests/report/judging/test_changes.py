"""Two versions of claims.json are compared claim by claim."""

import json

import pytest

from report.judging.changes import ClaimsFileError, differences, parsed_claims, read_claims
from report.rendering.json import to_json
from report.rendering.selection import select
from tests.report.rendering.sample import sample

CLAIM = {
    "id": "eq-2.8",
    "section": "2.2.1",
    "verdict": "erratum",
    "severity": "slip",
    "printed": "x",
    "derived": "y",
    "explanation": "why",
}


def written(*claims, schema=2):
    return json.dumps({"schema": schema, "claims": claims})


def compared(before, after, schema=2, omitted=()):
    old, new = written(*before, schema=schema), written(*after)
    return differences(parsed_claims(old, "old.json"), parsed_claims(new, "new"), omitted).splitlines()


def test_the_same_claims_differ_in_nothing():
    (line,) = compared([CLAIM], [CLAIM])
    assert line.startswith("compared with old.json (schema 2, 1 claims): 0 changed, ")
    assert line.endswith("of which 0 in verdict or severity, 0 new, 0 gone")


@pytest.mark.parametrize(
    ("field", "value", "says"),
    [
        ("verdict", "copy", "verdict: erratum → copy"),
        ("severity", "none", "severity: slip → none"),
        ("printed", "z", "printed: x → z"),
        ("derived", "", "derived: y → (nothing)"),
        ("explanation", "because", "explanation: why → because"),
        ("printed", "a\nb\x1b[2J", "printed: x → a b [2J"),
    ],
)
def test_each_field_is_compared(field, value, says):
    assert compared([CLAIM], [CLAIM | {field: value}])[1:] == ["  eq-2.8", f"    {says}"]


def test_new_verdicts_come_first():
    other = CLAIM | {"id": "eq-5.1"}
    head, *lines = compared([CLAIM, other], [CLAIM | {"printed": "z"}, other | {"verdict": "copy"}])
    assert head.endswith("2 changed, of which 1 in verdict or severity, 0 new, 0 gone")
    assert [line for line in lines if not line.startswith("    ")] == ["  eq-5.1", "  eq-2.8"]


def test_other_fields_are_not():
    assert len(compared([CLAIM], [CLAIM | {"method": "another", "section": "2.2"}])) == 1


def test_long_texts_are_shown_from_their_first_difference():
    before, after = "a" * 100 + "b" + "c" * 100, "a" * 100 + "d" + "c" * 100
    _, line = compared([CLAIM | {"printed": before}], [CLAIM | {"printed": after}])[1:]
    assert line == f"    printed: …{'a' * 15}b{'c' * 44}… → …{'a' * 15}d{'c' * 44}…"


def test_new_and_gone_claims_are_listed():
    other = CLAIM | {"id": "eq-5.1", "section": "5.1.2"}
    assert compared([CLAIM], [other])[1:] == ["  new: eq-5.1", "  gone: eq-2.8"]
    assert compared([CLAIM, other], [other], omitted={"2"})[1:] == []


def test_a_file_without_severities_says_so():
    first = {name: value for name, value in CLAIM.items() if name != "severity"}
    assert compared([first], [CLAIM], schema=1)[1:] == ["  severity is not compared: schema 1 has none"]


def test_what_a_build_writes_can_be_read(tmp_path):
    path = tmp_path / "claims.json"
    path.write_text(to_json(sample()), encoding="utf-8")
    whole = read_claims(path)
    part = parsed_claims(to_json(select(sample(), ["ch5"])), "part")
    assert len(whole.claims) > len(part.claims)
    assert "severity, 0 new, 0 gone" in differences(whole, part, {"2", "A"})
    assert "severity, 0 new, 7 gone" in differences(whole, part)


@pytest.mark.parametrize(
    ("content", "reason"),
    [
        (b"", "no JSON"),
        (b"\xff", "no JSON in UTF-8"),
        (b"[" * 100_000, "it is nested too deeply"),
        (b"9" * 5000, "a number of thousands of digits"),
        (b"[]", "no list of claims"),
        (b'{"schema": 2, "claims": {}}', "no list of claims"),
        (written(schema=3).encode(), "its schema is 3, and this version reads 1 and 2"),
        (written(schema=True).encode(), "its schema is True"),
        (written(schema=[2]).encode(), r"its schema is \[2\]"),
        (b'{"claims": []}', "its schema is None"),
        (written(CLAIM, 7).encode(), "its claim 2 has no text as id"),
        (written(CLAIM | {"verdict": 1}).encode(), "its claim 1 has no text as verdict"),
        (written({"id": "a"}).encode(), "its claim 1 has no text as section"),
        (written(CLAIM, CLAIM).encode(), "it has the claim 'eq-2.8' twice"),
    ],
)
def test_what_is_no_file_of_claims_is_refused_in_a_sentence(tmp_path, content, reason):
    path = tmp_path / "old.json"
    path.write_bytes(content)
    with pytest.raises(ClaimsFileError, match=rf"^--compare .*old\.json: .*{reason}.*; give a claims\.json"):
        read_claims(path)


def test_a_file_that_cannot_be_read_is_named(tmp_path):
    with pytest.raises(ClaimsFileError, match=r"none\.json: cannot be read"):
        read_claims(tmp_path / "none.json")
