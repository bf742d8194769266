import subprocess
import sys
from importlib import import_module, metadata
from pathlib import Path

import pytest

import trimmer
from tests.public_names import public_names


def test_every_public_name_comes_from_its_module() -> None:
    for name, value in public_names().items():
        if hasattr(value, "__module__") and callable(value):
            assert getattr(import_module(value.__module__), name) is value, name


def test_no_module_hides_a_public_name() -> None:
    """Importing trimmer.x sets the attribute x of the package; a function x would then be out of reach."""
    modules = {path.stem for path in Path(trimmer.__file__).parent.glob("*.py")}
    assert modules.isdisjoint(trimmer.__all__)


def test_the_package_says_that_it_is_typed() -> None:
    """PEP 561: without this file a type checker takes everything in the package for Any."""
    assert (Path(trimmer.__file__).parent / "py.typed").read_text() == ""


def test_the_package_can_be_run_as_the_command(project_folder: Path) -> None:
    for words, code in ((["--version"], 0), (["linear", "--no-such-option"], 2)):
        command = [sys.executable, "-m", "trimmer", *words]
        ended = subprocess.run(command, capture_output=True, text=True, check=False, cwd=project_folder)
        assert ended.returncode == code
        assert (ended.stdout or ended.stderr).split()[0].rstrip(":") == "trimmer"


def test_few_names_stand_at_the_top_and_star_import_gives_them() -> None:
    assert set(trimmer.__all__) - {"__version__"} <= set(dir(trimmer))
    assert len(trimmer.__all__) <= 80
    names: dict[str, object] = {}
    exec("from trimmer import *", names)
    assert set(trimmer.__all__) <= set(names)
    with pytest.raises(AttributeError, match="linaer_model"):
        trimmer.linaer_model  # noqa: B018


def test_a_name_that_stands_in_a_room_is_answered_with_its_place() -> None:
    for name in set(public_names()) - set(trimmer.__all__):
        with pytest.warns(DeprecationWarning, match=rf"from trimmer\.\w+ import {name}$"):
            assert getattr(trimmer, name) is public_names()[name]


def test_a_former_name_is_answered_with_the_one_that_took_its_place() -> None:
    for place in (trimmer, trimmer.uncertainty):
        with pytest.warns(DeprecationWarning, match="from trimmer.uncertainty import sample_limit_cycles$"):
            assert place.sample_loop is trimmer.uncertainty.sample_limit_cycles


def test_the_version_is_that_of_the_installed_distribution(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(metadata, "version", {"trimmer": "1.2.3"}.__getitem__)
    assert trimmer.__version__ == "1.2.3"

    def not_found(name: str) -> str:
        raise metadata.PackageNotFoundError(name)

    monkeypatch.setattr(metadata, "version", not_found)
    assert trimmer.__version__ == "unknown (not installed)"
