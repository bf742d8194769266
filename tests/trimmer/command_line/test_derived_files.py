"""Which files ``derive``, ``parameters`` and ``init`` write, what they tell of them, and which they keep."""

from __future__ import annotations

import io
from pathlib import Path

import pytest

from trimmer.code_generation import DerivedSources
from trimmer.command_line.derive import _module_to_write
from trimmer.command_line.main import main
from trimmer.generated import linear_trimmer

EXAMPLES = Path(__file__).parents[3] / "examples"
IN_USE = Path(linear_trimmer.__file__).read_text("utf-8")
FOLDER = Path("build") / "derivation"


@pytest.fixture(autouse=True)
def folder(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Path:
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.mark.parametrize(("module", "state"), [(IN_USE, "the same as"), ("other", "different from")])
def test_what_is_derived_of_the_thesis_is_held_against_what_is_in_use(
    replaced, capsys, module: str, state: str
) -> None:
    replaced("trimmer.code_generation.derive_sources", DerivedSources(module, "latex"))
    assert main(["derive"]) == 0
    first, second = FOLDER / "linear_trimmer.py", FOLDER / "derivation.tex"
    assert (first.read_text("utf-8"), second.read_text("utf-8")) == (module, "latex")
    told = capsys.readouterr()
    assert told.out == f"{first}: numeric module, {state} the one in use\n{second}: derivations\n"
    assert told.err == "trimmer: deriving the linear trimmer and the describing functions ...\n"


def test_what_is_derived_of_a_mechanism_has_its_name(replaced, monkeypatch, capsys) -> None:
    derived = replaced("trimmer.code_generation.derive_mechanism_sources", DerivedSources("code", "latex"))
    belt = EXAMPLES / "block-on-belt.toml"
    assert main(["derive", str(belt), "--latex", "a.tex"]) == 0
    assert derived.arguments[0].title == "Block on a belt"
    told = capsys.readouterr()
    assert told.err == "trimmer: deriving Block on a belt ...\n"
    assert told.out.splitlines()[0] == f"{FOLDER / 'block-on-belt.py'}: numeric module"
    assert told.out.splitlines()[1].startswith("a.tex: derivation, and the laws")
    assert (FOLDER / "block-on-belt.py").read_text("utf-8") == "code"
    assert Path("a.tex").read_text("utf-8") == "latex"
    nameless = belt.read_text("utf-8").replace('title = "Block on a belt"', "")
    monkeypatch.setattr("sys.stdin", io.TextIOWrapper(io.BytesIO(nameless.encode())))
    assert main(["derive", "-", "--module", "a.py"]) == 0
    told = capsys.readouterr()
    assert told.err == "trimmer: deriving the mechanism ...\n"
    assert (Path("a.py").read_text("utf-8"), (FOLDER / "mechanism.tex").exists()) == ("code", True)


def test_what_is_derived_replaces_files_of_others_only_if_asked(replaced, capsys) -> None:
    replaced("trimmer.code_generation.derive_sources", DerivedSources("code", "latex"))
    for name in ("a", "b"):
        Path(name).write_text("mine")
    words = ["derive", "--module", "a", "--latex", "b"]
    assert main(words) == 2
    assert Path("a").read_text() == Path("b").read_text() == "mine"
    assert main([*words, "--overwrite"]) == 0
    assert (Path("a").read_text(), Path("b").read_text()) == ("code", "latex")


def test_a_dash_is_standard_output_of_a_module_alone() -> None:
    assert _module_to_write("-") == Path("/dev/stdout")
    assert _module_to_write("./-") == Path("-")
    assert _module_to_write("a.py") == Path("a.py")


@pytest.mark.parametrize("words", [["parameters", "--output"], ["init"]], ids=" ".join)
def test_a_first_file_is_kept_unless_it_is_empty(words: list[str], capsys) -> None:
    Path("a.toml").write_text("")
    assert main([*words, "a.toml"]) == 0
    written = Path("a.toml").read_text("utf-8")
    assert written
    assert capsys.readouterr().out.startswith("wrote a.toml")
    Path("a.toml").write_text("x")
    assert main([*words, "a.toml"]) == 2
    assert capsys.readouterr().err.startswith("trimmer: a.toml is there already: name another file")
    assert Path("a.toml").read_text() == "x"
    for name, target in (("one", "other"), ("other", "one"), ("gone", "nowhere")):
        Path(name).symlink_to(target)
    for name in ("one", "gone"):
        assert main([*words, name]) == 2
        assert f"{name} is a symbolic link to " in capsys.readouterr().err
        assert Path(name).is_symlink() and not Path("nowhere").exists()
    long = "x" * 300
    assert main([*words, long]) == 2
    told = capsys.readouterr().err
    assert "is there already" not in told and "File name too long" in told


@pytest.mark.parametrize("words", [["parameters", "--output"], ["init"]], ids=" ".join)
def test_a_first_file_may_go_to_standard_output(words: list[str], monkeypatch, capsys) -> None:
    Path("out").write_text("x")
    for module in ("trimmer.files", "trimmer.command_line.file_options"):
        monkeypatch.setattr(f"{module}.is_standard_output", lambda path: path == Path("out"))
    monkeypatch.setattr("trimmer.files.write_atomically", lambda path, text: print(text, end=""))
    assert main([*words, "out"]) == 0
    told = capsys.readouterr()
    assert told.err.startswith("wrote out")
    assert told.out.startswith("#") or "[" in told.out
