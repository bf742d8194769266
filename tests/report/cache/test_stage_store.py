"""Results are kept under their keys."""

import contextlib
import hashlib
import io
import json
import os
import pickle
import tempfile
import time
from pathlib import Path
from typing import Any

import control
import numpy as np
import pytest
import sympy
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import array_shapes, arrays

from report.cache.stage_store import Bounds, StageStore
from trimmer import Body, FrictionBacklash, TrimmerParameters, periodic_orbits, pin_model

RESULT = {"answer": [1, 2.5, "text"], "array": np.arange(4.0), "body": Body(1.0)}


def test_a_result_is_made_once_per_key(tmp_path: Path) -> None:
    store, calls = StageStore(tmp_path / "kept"), []

    def make() -> dict[str, int]:
        calls.append(1)
        return {"answer": len(calls)}

    assert store.made("stage", "a", make) == {"answer": 1}
    assert store.made("stage", "a", make) == {"answer": 1}
    assert store.made("stage", "b", make) == {"answer": 2}
    assert store.load("stage", "a") is None
    assert store.load("other", "b") is None


@settings(max_examples=25, deadline=None)
@given(st.data())
def test_a_damaged_file_is_made_again_and_that_is_told(data: st.DataObject) -> None:
    with tempfile.TemporaryDirectory() as name, contextlib.redirect_stderr(io.StringIO()) as told:
        store, path = StageStore(Path(name)), Path(name) / "stage.data"
        store.keep("stage", "a", RESULT)
        whole = path.read_bytes()
        at = data.draw(st.integers(len("a\n"), len(whole) - 1))
        damage = {
            "cut": whole[:at],
            "altered": whole[:at] + bytes([whole[at] ^ data.draw(st.integers(1, 255))]) + whole[at + 1 :],
            "longer": whole[:at] + b"\0" + whole[at:],
        }
        path.write_bytes(damage[data.draw(st.sampled_from(sorted(damage)))])
        assert store.made("stage", "a", lambda: "again") == "again"
        assert told.getvalue() == f"trimmer: {path} is damaged; what it held is computed again\n"
        assert store.load("stage", "a") == "again"


class Runs:
    """What pickle would run when it reads it."""

    def __reduce__(self) -> tuple[Any, ...]:
        return os.mkdir, (str(Runs.folder),)

    folder = Path()


def signed(entries: list[Any], raw: bytes = b"") -> bytes:
    """Return the content of a file as somebody would write it who knows the format."""
    content = json.dumps([entries, [len(entries) - 1]]).encode() + b"\n" + raw
    return b"a\n" + hashlib.sha256(content).hexdigest().encode() + b"\n" + content


CODE = "__import__('os').mkdir('ran')"
HOSTILE = {
    "a function": [["object", "os:system", []]],
    "a function of the project": [["object", "report.command:main", []]],
    "the program itself": [["object", "trimmer.__main__:x", []]],
    "a class of the library": [["object", "subprocess:Popen", []]],
    "an array of objects": [["array", "|O", [1], 0, 8]],
    "text as an expression": [["Tuple", CODE]],
    "text in a matrix": [["tuple", [CODE]], ["matrix", 1, 1, [0]]],
    "text as a number": [["rational", CODE, 1]],
    "an argument of a function": [["dict", []], ["tuple", [CODE]], ["function of", "f", [0], [1]]],
    "a base of a function": [["tuple", []], ["dict", [["bases", [0]]]], ["function of", "f", [1], [0]]],
    "itself": [["tuple", [[0]]]],
    "a row before the first": [["tuple", [1]], ["tuple", [[-1]]]],
    "other fields": [["object", "trimmer.mechanism.parts:Body", [["weight", 1.0]]]],
    "an unknown tag": [["pickle", "x"]],
}


@pytest.mark.parametrize("entries", HOSTILE.values(), ids=HOSTILE)
def test_what_somebody_wrote_there_is_not_run(entries: list[Any], tmp_path, monkeypatch, capsys) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "stage.data").write_bytes(signed(entries))
    assert StageStore(tmp_path).made("stage", "a", lambda: "own") == "own"
    assert "is damaged" in capsys.readouterr().err
    assert [path.name for path in tmp_path.iterdir()] == ["stage.data"]


def test_a_pickle_is_not_read(tmp_path: Path) -> None:
    Runs.folder = tmp_path / "ran"
    content = pickle.dumps(("a", Runs()))
    for name, each in (("stage.pickle", content), ("stage.data", content), ("x.data", b"a\n" + content)):
        (tmp_path / name).write_bytes(each)
    store = StageStore(tmp_path)
    assert store.load("stage", "a") is None
    assert store.load("other", "a") is None
    assert not Runs.folder.exists()


DATA = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.text() | st.binary() | st.complex_numbers(),
    lambda inner: (
        st.lists(inner)
        | st.tuples(inner, inner)
        | st.dictionaries(st.text() | st.integers(), inner)
        | st.frozensets(st.integers() | st.text())
    ),
    max_leaves=20,
)


def as_told(value: Any) -> Any:
    """Return a value as text that tells types, signs of zero and NaN apart, and no order of a set."""
    if isinstance(value, frozenset):
        return "frozenset", sorted(map(repr, value))
    if isinstance(value, dict):
        return [(key, as_told(each)) for key, each in value.items()]
    if isinstance(value, list | tuple):
        return type(value).__name__, [as_told(each) for each in value]
    return repr(value)


@settings(max_examples=60, deadline=None)
@given(DATA)
def test_data_read_back_as_they_were(value: Any) -> None:
    with tempfile.TemporaryDirectory() as name:
        StageStore(Path(name)).keep("stage", "a", (value,))
        (read,) = StageStore(Path(name)).load("stage", "a")
    assert as_told(read) == as_told(value)


@given(
    array_shapes(max_dims=3).flatmap(
        lambda shape: arrays(st.sampled_from(["<f8", ">f4", "<c16", "?", "<i8", "u1", "<U3"]), shape)
    ),
    st.booleans(),
)
def test_arrays_read_back_in_their_type_and_order(array: Any, turned: bool) -> None:
    given_array = array.T if turned else array
    with tempfile.TemporaryDirectory() as name:
        StageStore(Path(name)).keep("stage", "a", {"array": given_array, "one": given_array.flat[0]})
        read = StageStore(Path(name)).load("stage", "a")
    np.testing.assert_array_equal(read["array"], given_array)
    assert (read["array"].dtype, type(read["one"])) == (array.dtype, type(given_array.flat[0]))
    assert read["array"].flags.f_contiguous == given_array.flags.f_contiguous
    assert read["array"].flags.writeable


def test_what_is_shared_is_shared_again() -> None:
    shared = Body(0.5)
    with tempfile.TemporaryDirectory() as name:
        StageStore(Path(name)).keep("stage", "a", [shared, (shared, {"x": shared})])
        read = StageStore(Path(name)).load("stage", "a")
    assert read[0] == shared
    assert read[0] is read[1][0] is read[1][1]["x"]


def test_what_is_no_data_is_refused_when_it_is_kept(tmp_path: Path) -> None:
    for value in (len, object(), Path(), np.array([object()]), Runs()):
        with pytest.raises(TypeError, match="cannot be kept"):
            StageStore(tmp_path).keep("stage", "a", [value])
    assert not list(tmp_path.iterdir())


def aged(path: Path, days: float) -> None:
    """Make a file look as if it was last used some days ago."""
    then = time.time() - days * 86400
    os.utime(path, (then, then))


def test_what_was_not_used_for_long_goes(tmp_path: Path) -> None:
    store = StageStore(tmp_path)
    for name, days in (("old", 31), ("read", 31), ("new", 29)):
        store.keep(name, "a", [name])
        aged(tmp_path / f"{name}.data", days)
    (tmp_path / ".0123.part").write_bytes(b"half")
    (tmp_path / ".4567.part").write_bytes(b"being written")
    aged(tmp_path / ".0123.part", 2)
    (tmp_path / "notes.txt").write_text("mine")
    aged(tmp_path / "notes.txt", 100)
    assert store.load("read", "a") == ["read"]
    assert store.load("old", "other key") is None
    store.clear_old()
    assert {path.name for path in tmp_path.iterdir()} == {
        "read.data", "new.data", ".4567.part", "notes.txt"
    }  # fmt: skip


def test_beyond_a_size_what_was_not_used_for_longest_goes_but_nothing_of_today(tmp_path: Path) -> None:
    store = StageStore(tmp_path)
    for name, days in (("oldest", 9.0), ("older", 8.0), ("today", 0.5), ("now", 0.0)):
        store.keep(name, "a", bytes(1000))
        aged(tmp_path / f"{name}.data", days)
    store.clear_old(Bounds(size=3500))
    assert {path.stem for path in tmp_path.iterdir()} == {"older", "today", "now"}
    store.clear_old(Bounds(size=10))
    assert {path.stem for path in tmp_path.iterdir()} == {"today", "now"}
    StageStore(tmp_path / "none").clear_old()
    assert not (tmp_path / "none").exists()


def test_a_state_space_model_reads_back_equal(tmp_path: Path) -> None:
    model = control.ss(
        [[0, 1], [-2, -3]], [[0], [1]], [[1, 0]], [[0]], name="m", states=["q", "v"], outputs="y"
    )
    StageStore(tmp_path).keep("stage", "a", {"model": model})
    read = StageStore(tmp_path).load("stage", "a")["model"]
    assert np.array_equal(read.A, model.A)
    assert np.array_equal(read.C, model.C)
    assert (read.name, read.state_labels, read.output_labels) == ("m", ["q", "v"], ["y"])
    assert complex(read(2j)) == complex(model(2j))


def test_terms_read_back_in_their_order(tmp_path: Path) -> None:
    a, b = sympy.symbols("a b")
    expression = sympy.Add(sympy.Mul(b, a, evaluate=False), -a, evaluate=False)
    StageStore(tmp_path).keep("stage", "a", [expression])
    (read,) = StageStore(tmp_path).load("stage", "a")
    assert sympy.latex(read, order="none") == sympy.latex(expression, order="none")
    assert [term.args for term in read.args] == [term.args for term in expression.args]


def test_an_orbit_of_a_loop_is_kept_with_the_modes_it_goes_through(tmp_path: Path) -> None:
    system, play = pin_model(TrimmerParameters.thesis()), FrictionBacklash(4e-5)
    unstable, stable = periodic_orbits(system, play)
    assert len({event.mode for event in stable.motion.events}) == 3
    store = StageStore(tmp_path)
    store.keep("orbits", "a", (unstable, stable))
    again = store.load("orbits", "a")
    for before, after in zip((unstable, stable), again, strict=True):
        np.testing.assert_array_equal(after.switching_times, before.switching_times)
        times = np.linspace(0.0, before.period, 57)
        np.testing.assert_array_equal(after.motion.output(times), before.motion.output(times))
