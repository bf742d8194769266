import tomllib
from pathlib import Path

import pytest
from hypothesis import given, settings

from tests.trimmer.mechanism.mechanisms import mechanisms
from trimmer import Body, Link, Mechanism, Pin, Stop, TrimmerParameters
from trimmer.files import FileWriteError, write_atomically

THESIS = TrimmerParameters.thesis().to_mechanism(1.5e-3, 110.0)


@settings(max_examples=10)
@given(mechanisms())
def test_what_is_written_reads_back_equal(mechanism: Mechanism) -> None:
    again = Mechanism.from_toml_text(mechanism.to_toml())
    assert again == mechanism
    assert again.to_toml() == mechanism.to_toml()


def test_defaults_are_left_out() -> None:
    mechanism = Mechanism(
        {"a": Body(2)},
        pins={"p": Pin("ground")},
        links={"spring": Link(("ground", "a"), 3)},
        stops={"wall": Stop(("p", "a"), gap=-1)},
    )
    assert tomllib.loads(mechanism.to_toml()) == {
        "bodies": {"a": {"mass": 2.0}},
        "pins": {"p": {"on": "ground"}},
        "links": {"spring": {"between": ["ground", "a"], "stiffness": 3.0}},
        "stops": {"wall": {"between": ["p", "a"], "gap": -1.0}},
    }


def test_a_written_mechanism_takes_the_place_of_a_mechanism_only(tmp_path: Path) -> None:
    path = tmp_path / "mine.toml"
    write_atomically(path, THESIS.to_toml())
    write_atomically(path, THESIS.with_value("frequency", 50.0).to_toml())
    assert Mechanism.from_toml(path).frequency == 50.0
    path.write_text(TrimmerParameters.thesis().to_toml())
    with pytest.raises(FileWriteError, match="is no mechanism file"):
        write_atomically(path, THESIS.to_toml())
