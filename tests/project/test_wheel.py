"""The wheel holds all that the packages need, and works from another folder."""

import os
import subprocess
import sys
import tarfile
import zipfile
from pathlib import Path

import pytest

PACKAGES = ("derivations", "trimmer", "report")
PIP = [sys.executable, "-I", "-m", "pip", "--disable-pip-version-check"]


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory, project_folder: Path) -> Path:
    """The project's wheel, built with the locked backend and without network."""
    folder = tmp_path_factory.mktemp("wheel")
    options = ["--quiet", "--no-deps", "--no-build-isolation", "--no-index", "--wheel-dir", str(folder)]
    subprocess.run([*PIP, "wheel", *options, str(project_folder)], check=True)
    (built,) = folder.glob("*.whl")
    return built


@pytest.fixture(scope="module")
def installed(wheel: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Folder into which the wheel is installed without its dependencies."""
    folder = tmp_path_factory.mktemp("installed")
    options = ["--quiet", "--no-deps", "--no-index", "--no-compile", "--target", str(folder)]
    subprocess.run([*PIP, "install", *options, str(wheel)], check=True)
    return folder


def test_wheel_holds_every_file_of_the_packages(wheel: Path, project_folder: Path) -> None:
    sources = {
        path.relative_to(project_folder).as_posix()
        for package in PACKAGES
        for path in (project_folder / package).rglob("*")
        if path.is_file() and "__pycache__" not in path.parts
    }
    sources |= {
        f"{package}/{path.relative_to(project_folder).as_posix()}"
        for package, folder in (("report", "templates"), ("trimmer", "examples"))
        for path in (project_folder / folder).rglob("*")
        if path.is_file() and "__pycache__" not in path.parts
    }
    shipped = {name for name in zipfile.ZipFile(wheel).namelist() if name.startswith(PACKAGES)}
    assert sources == {name for name in shipped if ".dist-info/" not in name}
    assert not any(name.startswith(("templates/", "examples/")) for name in zipfile.ZipFile(wheel).namelist())
    for folder in ("report/templates/", "report/fonts/", "trimmer/generated/", "trimmer/examples/"):
        assert any(name.startswith(folder) for name in shipped), folder


def test_wheel_holds_the_licences(wheel: Path) -> None:
    names = zipfile.ZipFile(wheel).namelist()
    assert any(name.endswith(".dist-info/licenses/LICENSE") for name in names)
    assert any("/licenses/report/fonts/" in name for name in names)


@pytest.mark.slow
def test_installed_command_works_from_another_folder(installed: Path, tmp_path, project_folder) -> None:
    variables = os.environ | {"PYTHONPATH": str(installed)}
    where = (
        "import trimmer, report, derivations; print(trimmer.__file__, report.__file__, derivations.__file__)"
    )
    ended = subprocess.run(
        [sys.executable, "-c", where], cwd=tmp_path, env=variables, capture_output=True, text=True, check=True
    )
    assert str(project_folder) not in ended.stdout
    command = [sys.executable, str(installed / "bin" / "trimmer"), "--help"]
    ended = subprocess.run(command, cwd=tmp_path, env=variables, capture_output=True, text=True, check=True)
    assert "report" in ended.stdout


@pytest.mark.slow
def test_source_distribution_holds_what_the_site_is_made_from(tmp_path: Path, project_folder: Path) -> None:
    """Built by the backend itself, since pip builds none; nothing that a build has written is in it."""
    made = (
        f"import os, hatchling.build; os.chdir({str(project_folder)!r}); "
        f"print(hatchling.build.build_sdist({str(tmp_path)!r}))"
    )
    subprocess.run([sys.executable, "-c", made], check=True, capture_output=True)
    (built,) = tmp_path.glob("*.tar.gz")
    with tarfile.open(built) as archive:
        names = {name.partition("/")[2] for name in archive.getnames()}
    pages = {path.relative_to(project_folder).as_posix() for path in (project_folder / "docs").rglob("*.*")}
    scripts = {path.relative_to(project_folder).as_posix() for path in project_folder.glob("scripts/*/*.py")}
    assert pages | scripts | {"mkdocs.yml", "CITATION.cff", "Makefile"} <= names
    assert any(name.startswith("examples/scripts/") for name in names)
    assert not any(name.startswith(("build/", ".venv/")) for name in names)
