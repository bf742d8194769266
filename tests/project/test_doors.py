"""The rule that tests ask through public names."""

from pathlib import Path

import pytest

from scripts.doors import insides, wrong


@pytest.mark.parametrize(
    ("source", "found"),
    [
        ("from trimmer.response.periodic.shooting import _settled", ["imports the private _settled"]),
        ("import report._hidden.thing", ["imports the private _hidden"]),
        ("import trimmer\ntrimmer.simulate.__wrapped__", []),
        ("import trimmer\ntrimmer._table", ["takes the private _table"]),
        (
            "from trimmer import design\nmonkeypatch.setattr(design, 'slow', None)",
            ["replaces design inside the packages"],
        ),
        ("mock.patch('report.command.main')", ["replaces 'report.command.main' inside the packages"]),
        ("from trimmer import Problem\ndict(Problem.table)", []),
        ("from trimmer import A\nmock.patch.dict(A.table)", ["replaces A.table inside the packages"]),
        ("import os, time\nmonkeypatch.setattr(time, 'sleep', None)\nos._exit(1)", []),
        ("monkeypatch.setenv('HOME', '/')\nself._kept = row._replace(a=1)", []),
        ("from trimmer.response.respond import respond", ["imports respond from below trimmer"]),
        ("from trimmer.design.study import Study, pairs", ["imports Study from below trimmer.design"]),
        ("from trimmer.linear.models.modes import Mode as M", ["imports Mode from below trimmer.linear"]),
        ("from trimmer.design import Study, study\nfrom trimmer.hybrid.system import Mode", []),
    ],
)
def test_what_goes_inside_is_found(source: str, found: list[str]) -> None:
    assert [what for _, what in insides(source)] == found


def test_the_list_has_reasons_and_no_file_that_needs_none(tmp_path: Path) -> None:
    tests = tmp_path / "tests"
    tests.mkdir()
    tests.joinpath("insides.csv").write_text("file,reason\ntests/a.py,\ntests/b.py,why\ntests/gone.py,why\n")
    tests.joinpath("a.py").write_text("from trimmer import _a")
    tests.joinpath("b.py").write_text("from trimmer import b")
    tests.joinpath("c.py").write_text("from trimmer import _c")
    assert list(wrong(tmp_path)) == [
        "tests/insides.csv: tests/a.py has no reason",
        "tests/insides.csv: tests/b.py touches no insides any more; take it off the list",
        "tests/c.py:1: imports the private _c; ask through a public name",
        "tests/insides.csv: tests/gone.py is not there",
    ]
