"""The measurement of random changes: read, refused if it does not add up, printed."""

import json
from dataclasses import replace
from pathlib import Path

import pytest

from report.data.mutation import MutationDataError, MutationMeasurement, read_mutation
from report.rendering.markdown import to_markdown
from tests.report.rendering.sample import sample

CONTENT = {
    "date": "2026-11-22",
    "command": "make mutate ARGS='--seed 7 --count 150'",
    **{"drawn": 150, "equivalent": 10, "claims": 31, "tests": 102, "nothing": 7, "texts": 1},
    "interval": [0.9, 0.9757],
}


def written(folder: Path, **changes: object) -> Path:
    path = folder / "mutation.json"
    path.write_text(json.dumps({**CONTENT, **changes}), encoding="utf-8")
    return path


def test_without_a_measurement_there_is_none(tmp_path: Path) -> None:
    assert read_mutation(tmp_path / "mutation.json") is None


def test_what_was_measured_is_read(tmp_path: Path) -> None:
    found = read_mutation(written(tmp_path))
    assert found == MutationMeasurement(
        "2026-11-22", "make mutate ARGS='--seed 7 --count 150'", 150, 10, 31, 102, 7, (0.9, 0.9757)
    )
    assert found.noticed == 133


@pytest.mark.parametrize(
    "changes",
    [
        {"drawn": 151},
        {"nothing": -7, "equivalent": 24},
        {"interval": [0.96, 0.99]},
        {"interval": 3},
        {"tests": "many"},
    ],
)
def test_what_does_not_add_up_is_refused(tmp_path: Path, changes: dict[str, object]) -> None:
    with pytest.raises(MutationDataError, match=r"mutation\.json: .*measure again"):
        read_mutation(written(tmp_path, **changes))


def test_the_method_tells_date_command_counts_and_interval(tmp_path: Path) -> None:
    document = sample()
    assert "slip of this program" not in to_markdown(document)["method"]
    measured = replace(document, mutation=read_mutation(written(tmp_path)))
    text = " ".join(to_markdown(measured)["method"].replace("\\", "").split())
    assert "On 2026-11-22 the derivations and solvers of that day's state" in text
    assert "`make mutate ARGS='--seed 7 --count 150'`" in text
    assert "10 of these changes have no effect" in text
    assert "Of the other 140, 31 gave another verdict or stopped this report, 102 failed a test" in text
    assert "95.0 % were noticed, and with 95 % confidence the share lies between 90.0 and 97.6 %." in text
