from __future__ import annotations

import io
import os
import subprocess
import sys
from argparse import ArgumentParser
from dataclasses import replace
from importlib.metadata import EntryPoint
from pathlib import Path

import pytest

import trimmer.command_line.main as command_line
from trimmer.command_line.command import Command
from trimmer.command_line.main import ENTRY_POINT_GROUP, main
from trimmer.errors import TrimmerError


def no_options(parser: ArgumentParser) -> None:
    pass


def fail(error: BaseException) -> Command:
    def run(arguments: object) -> int:
        raise error

    return Command("other", "a command of another package", no_options, run)


OTHER = Command("other", "a command of another package", no_options, lambda arguments: 7)
NO_COMMAND = "not a command"


@pytest.fixture
def entry(monkeypatch: pytest.MonkeyPatch):
    """Make another package's entry point the only one there is."""

    def install(target: str) -> None:
        point = EntryPoint("other", target, ENTRY_POINT_GROUP)
        monkeypatch.setattr(command_line, "entry_points", lambda group: [point])

    install(f"{__name__}:OTHER")
    monkeypatch.setitem(sys.modules, __name__, sys.modules.get(__name__, sys.modules["__main__"]))
    monkeypatch.setattr(sys.modules[__name__], "OTHER", OTHER, raising=False)
    monkeypatch.setattr(sys.modules[__name__], "NO_COMMAND", NO_COMMAND, raising=False)
    return install


def test_help_lists_the_commands_with_those_of_other_packages(entry, capsys) -> None:
    with pytest.raises(SystemExit) as stopped:
        main(["--help"])
    assert stopped.value.code == 0
    listed = capsys.readouterr().out
    for name in ("linear", "parameters", "derive", "other"):
        assert f"    {name}" in listed
    assert "a command of another package" in listed


def test_a_command_of_another_package_runs_and_gives_the_exit_code(entry) -> None:
    assert main(["other"]) == 7


@pytest.mark.parametrize(
    ("target", "message"),
    [
        ("no.such.module:COMMAND", "does not load: No module named 'no'"),
        (f"{__name__}:NO_COMMAND", "is not a Command"),
    ],
)
def test_a_broken_command_does_not_take_the_others_with_it(entry, capsys, target, message) -> None:
    entry(target)
    assert main(["parameters"]) == 0
    printed = capsys.readouterr()
    assert f"command 'other' ({target}) {message}" in printed.err
    assert "m1 = 0.035" in printed.out


MISSPELLED = [
    (["lineal"], "there is no command 'lineal'; did you mean linear? See trimmer --help"),
    (["--vesion"], "there is no option --vesion; did you mean --version? See trimmer --help"),
    (
        ["linear", "--outptu", "q2"],
        "there is no option --outptu; did you mean --output? See trimmer linear --help",
    ),
    (
        ["linear", "-output=q2"],
        "there is no option -output; did you mean --output? See trimmer linear --help",
    ),
    (["identify", "--gpa", "1"], "there is no option --gpa; did you mean --gap? See trimmer identify --help"),
    (["linear", "--channels", "Both"], "--channels: there is no 'Both'; did you mean both? See"),
    (["linear", "--channels", "x"], "--channels: there is no 'x'; choose displacement or both; see"),
    (["limit-cycles", "--element", "frction"], "there is no 'frction'; did you mean friction? See"),
    (["linear", "--output", "q24"], "'q24' is not a displacement: did you mean q2-q4?"),
    (["linear", "x", "y"], "'x' and 'y' have no use here; leave them out; see trimmer linear --help"),
    (["linear", "--xyz"], "there is no option --xyz; see trimmer linear --help"),
    (["spectrum", "a.csv", "--bits", "17"], "--bits: there is no 17; choose 16 or 24; see"),
    (["identify", "--gap", "q"], "--gap: 'q' is no number; see"),
    (["map", "a.toml", "--starts", "1.5"], "--starts: '1.5' is no whole number; see"),
    (["report", "--only", "ch55"], "--only ch55: there is no such chapter; did you mean ch5?"),
]


@pytest.mark.parametrize(("words", "told"), MISSPELLED, ids=lambda each: str(each)[:40])
def test_what_was_meant_is_asked_for(capsys, words: list[str], told: str) -> None:
    try:
        code = main(words)
    except SystemExit as stopped:
        code = stopped.code
    shown = capsys.readouterr()
    assert (code, shown.out) == (2, "")
    assert told in shown.err
    assert shown.err.count("\n") == 1


@pytest.mark.parametrize("value", ["-1e-3", "-inf", "-5", "-.5"])
def test_a_negative_number_is_no_option(capsys, value: str) -> None:
    assert main(["identify", "--gap", value, "--frequency", "740"]) == 2
    assert "gap must be positive and finite" in capsys.readouterr().err


@pytest.mark.parametrize(
    "arguments", [[], ["nonsense"], ["linear", "--nonsense"], ["linear", "--channels", "x"]]
)
def test_wrong_use_is_exit_code_2_with_a_sentence(capsys, arguments: list[str]) -> None:
    with pytest.raises(SystemExit) as stopped:
        main(arguments)
    assert stopped.value.code == 2
    told = capsys.readouterr()
    assert told.out == ""
    assert told.err.startswith("trimmer: ")
    assert told.err.endswith(
        f"; see {' '.join(['trimmer', *arguments[:1]]) if arguments[1:] else 'trimmer'} --help\n"
    )
    assert told.err.count("\n") == 1


def test_what_the_user_can_correct_is_reported_without_a_traceback(entry, capsys, monkeypatch) -> None:
    monkeypatch.setattr(sys.modules[__name__], "OTHER", fail(TrimmerError("do this instead")))
    assert main(["other"]) == 2
    assert capsys.readouterr().err == "trimmer: do this instead\n"


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="needs /dev/full")
def test_a_full_disk_behind_standard_output_is_reported(project_folder: Path) -> None:
    code = "import sys; from trimmer.command_line.main import main; sys.exit(main(['parameters']))"
    with open("/dev/full", "wb") as full:
        done = subprocess.run(
            [sys.executable, "-c", code],
            stdout=full,
            stderr=subprocess.PIPE,
            text=True,
            cwd=project_folder,
            check=False,
        )
    expected = "trimmer: standard output: No space left on device; send the output elsewhere\n"
    assert (done.returncode, done.stderr) == (2, expected)


def test_an_error_of_the_program_is_not_hidden(entry, monkeypatch) -> None:
    monkeypatch.setattr(sys.modules[__name__], "OTHER", fail(ZeroDivisionError("a bug")))
    with pytest.raises(ZeroDivisionError):
        main(["other"])


def test_an_interrupt_is_exit_code_130(entry, monkeypatch) -> None:
    monkeypatch.setattr(sys.modules[__name__], "OTHER", fail(KeyboardInterrupt()))
    assert main(["other"]) == 130


@pytest.mark.parametrize(
    ("words", "name"),
    [
        (["spectrum", "a.csv", "--rate", "{}"], "rate"),
        (["spectrum", "a.csv", "--sample-rate", "{}"], "rate"),
        (["simulate", "--sample-rate", "{}"], "sample_rate"),
        (["simulate", "--rate", "{}"], "sample_rate"),
        (["respond", "a.toml", "--wait", "{}"], "periods"),
        (["map", "a.toml", "--wait", "{}"], "periods"),
        (["follow", "a.toml", "--vary", "frequency", "--from", "1", "--to", "2", "--wait", "{}"], "wait"),
        (["simulate", "--drive-frequency", "{}"], "drive"),
        (["spectrum", "a.csv", "--drive-frequency", "{}"], "drive"),
    ],
)
def test_one_thing_has_one_name_in_all_commands(monkeypatch, words: list[str], name: str) -> None:
    seen: list[object] = []
    commands = [
        replace(command, run=lambda arguments: seen.append(getattr(arguments, name)) or 0)
        for command in command_line.installed_commands()
    ]
    monkeypatch.setattr(command_line, "installed_commands", lambda: commands)
    assert main([word.format(7) for word in words]) == 0
    assert seen == [7]


def test_version(capsys) -> None:
    with pytest.raises(SystemExit) as stopped:
        main(["--version"])
    assert stopped.value.code == 0
    assert capsys.readouterr().out.startswith("trimmer ")


def test_a_reader_that_stops_early_is_no_error(project_folder: Path) -> None:
    code = "import sys; from trimmer.command_line.main import main; sys.exit(main(['parameters']))"
    read_end, write_end = os.pipe()
    os.close(read_end)
    with os.fdopen(write_end, "wb") as closed_pipe:
        done = subprocess.run(
            [sys.executable, "-c", code],
            stdout=closed_pipe,
            stderr=subprocess.PIPE,
            text=True,
            cwd=project_folder,
            env={**os.environ, "PYTHONUNBUFFERED": ""},
            check=False,
        )
    assert (done.returncode, done.stderr) == (0, "")


def test_a_command_cannot_be_changed() -> None:
    assert replace(OTHER, name="third").name == "third"
    with pytest.raises(AttributeError):
        OTHER.name = "third"  # type: ignore[misc]


COMMAND = "import sys; from trimmer.command_line.main import main; sys.exit(main(sys.argv[1:]))"
C_LOCALE = {"LC_ALL": "C", "PYTHONIOENCODING": "ascii", "PYTHONUTF8": "0", "PYTHONCOERCECLOCALE": "0"}


def run(
    folder: Path, *words: str, shell: str = "", code: Path = Path(os.devnull), **settings: str
) -> subprocess.CompletedProcess[bytes]:
    """Run a command by a shell, which redirects its streams, and writes its exit code into a file."""
    program = [sys.executable, "-c", COMMAND, *words]
    return subprocess.run(
        ["sh", "-c", f'{{ "$@"; code=$?; echo $code >"$CODE"; exit $code; }} {shell}', "sh", *program],
        capture_output=True,
        cwd=folder,
        env={**os.environ, "PYTHONUNBUFFERED": "", "CODE": str(code), **settings},
        check=False,
    )


def run_here(
    monkeypatch: pytest.MonkeyPatch, folder: Path, *words: str, encoding: str
) -> subprocess.CompletedProcess[bytes]:
    """Run a command in this process, as imports take longer than work, with streams of an encoding."""
    streams = {name: io.TextIOWrapper(io.BytesIO(), encoding=encoding) for name in ("stdout", "stderr")}
    with monkeypatch.context() as patched:
        patched.chdir(folder)
        for name, stream in streams.items():
            patched.setattr(sys, name, stream)
        try:
            code = main(words)
        except SystemExit as ended:
            code = int(ended.code or 0)
    written = {}
    for name, stream in streams.items():
        stream.flush()
        written[name] = stream.buffer.getvalue()  # type: ignore[attr-defined]
    return subprocess.CompletedProcess(words, code, **written)


def test_what_an_encoding_lacks_is_written_in_ascii(
    project_folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    plain = run(project_folder, "linear", **C_LOCALE)
    full = run_here(monkeypatch, project_folder, "linear", encoding="utf-8")
    assert (plain.returncode, plain.stderr) == (0, b"")
    assert " ± " in full.stdout.decode("utf-8")
    assert plain.stdout.decode("ascii") == full.stdout.decode("utf-8").replace("±", "+-")


NAMES = [
    ["linear", "--parameters", "ω\udcff.toml"],
    ["linear", "--channels", "日本"],
    ["limit-cycles", "--element", "friction", "--gap", "1", "--plot", "\udcff.jpg"],
]


def assert_told_in_a_line(done: subprocess.CompletedProcess[bytes]) -> None:
    assert (done.returncode, done.stdout) == (2, b"")
    assert done.stderr.startswith(b"trimmer: ")
    assert done.stderr.count(b"\n") == 1


@pytest.mark.parametrize("words", NAMES)
@pytest.mark.parametrize("encoding", ["ascii", "utf-8"])
def test_names_in_any_letters_give_no_traceback(
    project_folder: Path, monkeypatch: pytest.MonkeyPatch, words: list[str], encoding: str
) -> None:
    assert_told_in_a_line(run_here(monkeypatch, project_folder, *words, encoding=encoding))


@pytest.mark.parametrize("words", NAMES[:2])
def test_names_in_any_letters_give_no_traceback_in_the_c_locale(
    project_folder: Path, words: list[str]
) -> None:
    """The locale also says how the words are read, and how a file is looked for."""
    assert_told_in_a_line(run(project_folder, *words, **C_LOCALE))


def test_a_column_is_found_by_a_name_in_any_letters(project_folder: Path, tmp_path: Path) -> None:
    file = tmp_path / "a.csv"
    file.write_text("\n".join(["µ,x", *(f"{k % 5},0" for k in range(99))]), encoding="utf-8")
    done = run(project_folder, "spectrum", str(file), "--column", "µ", "--rate", "100", **C_LOCALE)
    assert (done.returncode, done.stderr) == (0, b"")
    assert done.stdout.startswith(b"u of ")


@pytest.mark.parametrize("words", [["parameters"], ["linear", "--help"]])
def test_a_closed_output_is_told(project_folder: Path, words: list[str]) -> None:
    done = run(project_folder, *words, shell=">&-")
    told = b"trimmer: standard output is closed; send it to a file, or to /dev/null\n"
    assert (done.returncode, done.stderr) == (2, told)


@pytest.mark.parametrize("words", [["parameters"], ["linear", "--help"]])
def test_a_reader_that_stops_at_once_is_no_error(
    project_folder: Path, tmp_path: Path, words: list[str]
) -> None:
    done = run(project_folder, *words, shell="| true", code=tmp_path / "code")
    assert done.stderr == b""
    assert (tmp_path / "code").read_text() == "0\n"


@pytest.mark.parametrize(("words", "code"), [(["linear", "--nonsense"], 2), (["parameters"], 0)])
@pytest.mark.parametrize("shell", ["2>&-", "2>&- <&-", "2>&1 | true"])
def test_nobody_needs_to_read_the_errors(
    project_folder: Path, tmp_path: Path, words: list[str], code: int, shell: str
) -> None:
    done = run(project_folder, *words, shell=shell, code=tmp_path / "code")
    assert done.stderr == b""
    assert b"trimmer:" not in done.stdout
    assert (tmp_path / "code").read_text() == f"{code}\n"


@pytest.mark.parametrize("words", [["--help"], ["simulate", "--help"]])
def test_help_lists_the_exit_codes(capsys, words: list[str]) -> None:
    with pytest.raises(SystemExit) as stopped:
        main(words)
    assert stopped.value.code == 0
    shown = " ".join(capsys.readouterr().out.split())
    for code in ("0 done", "1 an error", "2 wrong use", "3 a simulation", "130 interrupted"):
        assert code in shown
