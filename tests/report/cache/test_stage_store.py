"""Results are kept under their keys."""

from __future__ import annotations

import os
import time
from pathlib import Path

import control
import numpy as np
import sympy

from report.cache.stage_store import Bounds, StageStore


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


def test_a_damaged_file_counts_as_none(tmp_path: Path) -> None:
    store = StageStore(tmp_path)
    store.keep("stage", "a", [1, 2])
    (tmp_path / "stage.pickle").write_bytes((tmp_path / "stage.pickle").read_bytes()[:-4])
    assert store.load("stage", "a") is None
    (tmp_path / "stage.pickle").write_bytes(b"")
    assert store.load("stage", "a") is None


def aged(path: Path, days: float) -> None:
    """Make a file look as if it was last used some days ago."""
    then = time.time() - days * 86400
    os.utime(path, (then, then))


def test_what_was_not_used_for_long_goes(tmp_path: Path) -> None:
    store = StageStore(tmp_path)
    for name, days in (("old", 31), ("read", 31), ("new", 29)):
        store.keep(name, "a", [name])
        aged(tmp_path / f"{name}.pickle", days)
    (tmp_path / ".0123.part").write_bytes(b"half")
    (tmp_path / ".4567.part").write_bytes(b"being written")
    aged(tmp_path / ".0123.part", 2)
    (tmp_path / "notes.txt").write_text("mine")
    aged(tmp_path / "notes.txt", 100)
    assert store.load("read", "a") == ["read"]
    assert store.load("old", "other key") is None
    store.clear_old()
    assert {path.name for path in tmp_path.iterdir()} == {
        "read.pickle", "new.pickle", ".4567.part", "notes.txt"
    }  # fmt: skip


def test_beyond_a_size_what_was_not_used_for_longest_goes_but_nothing_of_today(tmp_path: Path) -> None:
    store = StageStore(tmp_path)
    for name, days in (("oldest", 9.0), ("older", 8.0), ("today", 0.5), ("now", 0.0)):
        store.keep(name, "a", bytes(1000))
        aged(tmp_path / f"{name}.pickle", days)
    store.clear_old(Bounds(size=3500))
    assert {path.stem for path in tmp_path.iterdir()} == {"older", "today", "now"}
    store.clear_old(Bounds(size=10))
    assert {path.stem for path in tmp_path.iterdir()} == {"today", "now"}


def test_nothing_is_cleared_where_there_is_nothing(tmp_path: Path) -> None:
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
