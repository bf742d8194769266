"""Which changes ``make mutate`` makes of a source, and which it does not."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest

from scripts.mutation.mutants import drawn, mutants_of, places_of
from scripts.mutation.operators import Kind


def changes(folder: Path, source: str) -> dict[str, Kind]:
    """Return the changes of a source by what stands in it afterwards; none of two that give the same."""
    path = folder / "trimmer" / "module.py"
    path.parent.mkdir(exist_ok=True)
    path.write_text(source, encoding="utf-8")
    found = [mutant for place in places_of(folder, path) for mutant in mutants_of(place)]
    texts = {mutant.text(source.encode()).decode(): mutant.kind for mutant in found}
    assert all(ast.dump(ast.parse(text)) != ast.dump(ast.parse(source)) for text in texts)
    return {ast.unparse(ast.parse(text)): kind for text, kind in texts.items()}


@pytest.mark.parametrize(
    ("source", "kind", "expected"),
    [
        ("y = a + b", Kind.ARITHMETIC, {"y = a - b"}),
        ("y = a * b", Kind.ARITHMETIC, {"y = a / b"}),
        ("y = a < b", Kind.COMPARISON, {"y = a <= b", "y = a >= b"}),
        ("y = a is None", Kind.COMPARISON, {"y = a is not None"}),
        ("y = f(2.5)", Kind.CONSTANT, {"y = f(3.5)", "y = f(-2.5)", "y = f(0.0)"}),
        ("y = f(0)", Kind.CONSTANT, {"y = f(1)"}),
        ("y = f(True)", Kind.CONSTANT, {"y = f(False)"}),
        ("y = a[1]", Kind.INDEX, {"y = a[2]", "y = a[0]"}),
        ("y = a[:, 1:]", Kind.INDEX, {"y = a[:, 2:]", "y = a[:, 0:]"}),
        ("y = a[-1]", Kind.INDEX, {"y = a[-2]", "y = a[-0]"}),
        ("y = -x", Kind.SIGN, {"y = x"}),
        ("y = not x", Kind.SIGN, {"y = x"}),
        ("y = a and b", Kind.LOGIC, {"y = a or b"}),
        ("y = a if c else b", Kind.LOGIC, {"y = b if c else a"}),
        ("f(x)", Kind.REMOVAL, {"pass"}),
        ("a[i] = x", Kind.REMOVAL, {"pass"}),
        ("y += x", Kind.REMOVAL, {"pass"}),
        ("if x:\n    raise E('a')", Kind.REMOVAL, {"if x:\n    pass", "pass"}),
        ("y = abs(x)", Kind.CALL, {"y = x"}),
        ("y = f(a, b)", Kind.ARGUMENTS, {"y = f(b, a)"}),
        ("y = close(a, b, c, d)", Kind.ARGUMENTS, {"y = close(b, a, c, d)", "y = close(a, b, d, c)"}),
        ("y = np.sin(x)", Kind.FUNCTION, {"y = np.cos(x)"}),
        ("y = z.real", Kind.FUNCTION, {"y = z.imag"}),
        ("def f(a, b):\n    return a", Kind.RETURN, {"def f(a, b):\n    return b"}),
        ("y = f(a, b=c)", Kind.KEYWORD, {"y = f(a)"}),
        ("y = f(b=c, d=e)", Kind.KEYWORD, {"y = f(d=e)", "y = f(b=c)"}),
        ("y = f(b=c, d=e)", Kind.ARGUMENTS, {"y = f(b=e, d=c)"}),
        ("def f(*, a=True):\n    pass", Kind.DEFAULT, {"def f(*, a=False):\n    pass"}),
        ("def f(n=12):\n    pass", Kind.DEFAULT, {"def f(n=24):\n    pass", "def f(n=6):\n    pass"}),
        ("TOLERANCE = 1e-9", Kind.SETTING, {"TOLERANCE = 1e-06", "TOLERANCE = 1e-12"}),
        (
            "class A:\n    most: int = 8",
            Kind.SETTING,
            {"class A:\n    most: int = 16", "class A:\n    most: int = 4"},
        ),
        ("brentq(f, xtol=4.0)", Kind.SETTING, {"brentq(f, xtol=8.0)", "brentq(f, xtol=2.0)"}),
        ("def f(a):\n    a = g(a)\n    return a", Kind.REMOVAL, {"def f(a):\n    pass\n    return a"}),
        ("if x:\n    y = 1", Kind.REMOVAL, {"pass"}),
        ("def f():\n    yield x", Kind.REMOVAL, {"def f():\n    pass"}),
        ("y = digits('a', expression(2), b + c)", Kind.CONSTANT, set()),
    ],
)
def test_changes_of_a_kind(tmp_path: Path, source: str, kind: Kind, expected: set[str]) -> None:
    found = changes(tmp_path, source)
    assert {text for text, each in found.items() if each is kind} == expected


@pytest.mark.parametrize(
    "source",
    [
        '"""A docstring with 1 + 1."""',
        "@overload\ndef f(x: int = 1) -> int: ...",
        "x: tuple[int, 3]",
        "def f(x: 'a' = None) -> g(1, 2):\n    pass",
        "@decorator(1, 2)\ndef f():\n    pass",
        "def f(width=12):\n    pass",
        "line(x, color=(0.1, 0.2))",
        "yield text('a').given(x=1 + 2)",
        "axes.set_title('a', 1 + 2)",
        "y = f(1e-9)",
        "raise ValueError(f'{1 + 2}', 3)",
        "def __repr__(self):\n    return f(1 + 2)",
        "if TYPE_CHECKING:\n    x = 1 + 2",
        "assert 1 + x < 2",
        "y = 'a' + b",
        "y = f'{a + 1}'",
        "def f() -> int | None:\n    pass",
    ],
)
def test_what_is_no_logic_is_left_alone(tmp_path: Path, source: str) -> None:
    kinds = set(changes(tmp_path, source).values())
    assert kinds <= {Kind.REMOVAL}


def test_a_setting_is_compared_but_not_whether_it_is_included(tmp_path: Path) -> None:
    assert set(changes(tmp_path, "y = error < TOLERANCE")) == {"y = error >= TOLERANCE"}
    assert set(changes(tmp_path, "y = error < 1e-9")) == {"y = error >= 1e-09"}


@pytest.fixture
def project(tmp_path: Path) -> Path:
    for package in ("derivations", "trimmer", "trimmer/generated", "report", "report/pages/drawing"):
        (tmp_path / package).mkdir(parents=True)
        lines = "".join(f"y{k} = a{k} + b{k} * {k}.5\n" for k in range(8))
        (tmp_path / package / "module.py").write_text(lines, encoding="utf-8")
    return tmp_path


def test_a_seed_draws_the_same_and_more_go_on(project: Path) -> None:
    few, many = (drawn(project, 5, count) for count in (6, 20))
    assert many[:6] == few
    assert few == drawn(project, 5, 6)
    assert few != drawn(project, 6, 6)
    assert len({(mutant.path, mutant.span) for mutant in many}) == 20
    assert {mutant.path for mutant in drawn(project, 5, 100, "trimmer")} == {"trimmer/module.py"}
    assert {each.path for each in many} == {"derivations/module.py", "trimmer/module.py", "report/module.py"}
