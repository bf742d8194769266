from __future__ import annotations

from pathlib import Path

from trimmer.command_line.main import main
from trimmer.parameters import TrimmerParameters


def test_the_template_is_printed(capsys) -> None:
    assert main(["parameters"]) == 0
    assert capsys.readouterr().out == TrimmerParameters.thesis().to_toml()


def test_the_template_is_written_and_can_be_used(tmp_path: Path, capsys) -> None:
    path = tmp_path / "new folder" / "mine.toml"
    assert main(["parameters", "--output", str(path)]) == 0
    assert capsys.readouterr().out == f"wrote {path}\n"
    assert TrimmerParameters.from_toml(path) == TrimmerParameters.thesis()
    assert main(["linear", "--parameters", str(path)]) == 0


def test_a_file_that_is_there_is_kept(tmp_path: Path, capsys) -> None:
    path = tmp_path / "mine.toml"
    path.write_text("precious")
    assert main(["parameters", "--output", str(path)]) == 2
    assert path.read_text() == "precious"
    assert (
        capsys.readouterr().err
        == f"trimmer: {path} is there already: name another file, or remove it first\n"
    )


def test_a_folder_is_refused(tmp_path: Path, capsys) -> None:
    assert main(["parameters", "--output", str(tmp_path)]) == 2
    assert "is a folder" in capsys.readouterr().err
