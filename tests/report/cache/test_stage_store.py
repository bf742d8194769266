"""Results are kept under their keys."""

from __future__ import annotations

from pathlib import Path

import control
import numpy as np
import sympy

from report.cache.stage_store import StageStore


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
