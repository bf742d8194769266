"""Every number of every command, set to what nobody means, is soon answered: by a result or a sentence."""

import math
import re
import resource
import signal
from contextlib import suppress
from pathlib import Path

import numpy as np
import pytest

from trimmer import TrimmerParameters
from trimmer.command_line.loops.loop_options import ELEMENT_OPTIONS
from trimmer.command_line.main import installed_commands, main
from trimmer.command_line.parser import WRONG_USE, as_option

EXAMPLES = Path(__file__).parents[3] / "examples"
TWIN, SCATTER = str(EXAMPLES / "thesis-play.toml"), str(EXAMPLES / "scatter.toml")
SERVO, PROOF = str(EXAMPLES / "two-mass-servo.toml"), str(EXAMPLES / "proofs" / "delayed-relay.json")
VALUES = ("0", "-1", "nan", "inf", "1e308", "1e-308", "5e-324")
SLOWEST = 20.0  # Processor time, s, of the slowest answer; kernels may have to be compiled

PLAY = "--element friction --gap 4e-5"
DRIVEN = "simulate --drive 110 --amplitude 1e-3"
BRANCH = f"follow {TWIN} --points 5 --wait 30 --vary frictions.blade.force"
RECORD = "record.csv"
WORDS = [
    *(f"{command} {words}" for command in ("limit-cycles", "orbits", f"spectrum {RECORD}") for words in (
        "--element friction --gap X", "--element viscous --gap 4e-5 --time-constant X",
        "--element relay --force X", "--element relay --force 1 --hysteresis X",
        "--element relay --force 1 --dead-zone X", "--element saturation --threshold X",
        "--element saturation --threshold 1e-5 --slope X",
    )),
    f"limit-cycles {PLAY} --omega-range X 1e4", f"limit-cycles {PLAY} --omega-range 1 X",
    "identify --frequency 740 --gap X", "identify --gap 4e-5 --frequency X",
    "identify --gap 4e-5 --frequency 740 --uncertainty X",
    *(f"{command} {words}" for command in (
        "simulate", "respond --periods 20",
        "follow --points 3 --wait 30 --vary frequency --from 110 --to 111",
        "map --jobs 1 --periods 5 --vary frequency=110:111:2",
        "sample --parameters p.toml --count 2 --periods 5 --jobs 1",
        "sweep --steps 2 --periods 5 --vary frequency --from 110 --to 111", f"overlay {RECORD}",
    ) for words in (
        f"{PLAY} --amplitude 1e-3 --drive X", f"{PLAY} --drive 110 --amplitude X",
        *(f"--drive 110 --amplitude 1e-3 --element {element} X" for element in (
            "friction --gap", "viscous --gap 1e-5 --time-constant", "relay --force",
            "relay --force 1 --hysteresis", "relay --force 1 --dead-zone", "saturation --threshold",
            "saturation --threshold 1e-5 --slope",
        )),
    )),
    *(f"{command} {PLAY} {words}" for command in ("simulate", "respond") for words in (
        "--impulse X", "--state q2=X",
    )),
    f"{DRIVEN} --duration X", f"{DRIVEN} --friction q2-q4=X", f"{DRIVEN} --csv OUT.csv --sample-rate X",
    f"{DRIVEN} --csv OUT.csv --duration X", f"{DRIVEN} --wav OUT.wav --sample-rate X",
    f"simulate {TWIN} --duration X",
    f"simulate {TWIN} --state cutter=X,0", f"simulate {TWIN} --state cutter=0,X",
    f"simulate {TWIN} --set frequency=X", f"simulate {TWIN} --set plays.bridge.gap=X",
    f"respond {TWIN} --starts X", f"respond {TWIN} --starts 2 --seed X", f"respond {TWIN} --periods X",
    f"respond {TWIN} --periods 20 --set plays.bridge.stiffness=X",
    f"follow {TWIN} --points 5 --wait 30 --vary frequency --from X --to 1",
    f"{BRANCH} --from 1 --to X", f"{BRANCH} --from 1 --to 0.99 --points X",
    f"{BRANCH} --from 1 --to 0.99 --periods X", f"{BRANCH} --from 1 --to 0.99 --harmonics X",
    f"follow {TWIN} --vary frictions.blade.force --from 1 --to 0.99 --wait X",
    f"{BRANCH} --from 1 --to 0.99 --switches X",
    f"map {TWIN} --jobs 1 --periods 5 --vary frequency=X:1:2", f"map {TWIN} --jobs 1 --vary frequency=1:2:X",
    *(f"map {TWIN} --vary frequency=100:110:2 --periods 5 {words} X" for words in (
        "--jobs", "--starts", "--starts 2 --seed",
    )),
    f"map {TWIN} --jobs 1 --vary frequency=100:110:2 --periods X",
    f"map {TWIN} --jobs 1 --periods 5 --vary frequency=9:10:2 --vary plays.bridge.gap=0:1e-5:2 --special X",
    *(f"sample {SCATTER} --jobs 1 {words} X" for words in (
        "--periods 5 --count", "--count 2 --periods", "--count 2 --periods 5 --seed", "--count 2 --balance",
    )),
    f"sample {SCATTER} --count 2 --periods 5 --jobs X", "sample p.toml --count 4 --gap X",
    *(f"spectrum {RECORD} {words} X" for words in (
        "--rate", "--resample --rate", "--ignore-time --rate", "--from", "--until", "--scale", "--drive",
        "--limit", "--average", "--as velocity --lowest", "--as velocity --highest",
        "--as velocity --lowest 5 --sensor-corner",
        "--gap", "--column", "--time", "--wav OUT.wav --bits", "--channel",
    )),
    *(f"overlay {RECORD} --against {TWIN} {words} X" for words in (
        "--rate", "--from", "--until", "--scale", "--drive", "--as velocity --lowest",
        "--as velocity --highest", "--as velocity --sensor-corner", "--channel", "--column", "--time",
    )),
    *(f"fit {TWIN} {RECORD} --free plays.bridge.gap {words} X" for words in (
        "--rate", "--from", "--until", "--drive", "--starts 2 --seed", "--channel", "--time", "--column",
    )),
    *(f"sweep {PLAY} --amplitude 1e-3 --vary frequency --from 110 --to 111 {words} X" for words in (
        "--drive 110 --periods 5 --steps", "--drive 110 --steps 2 --periods",
        "--drive 110 --steps 2 --periods 5 --impulse",
    )),
    f"spectrum {RECORD} --mains X", f"step {SERVO} --duration X", f"check {PROOF} --limit X",
    f"compare {TWIN} {SCATTER} --jobs X", f"design {TWIN} --jobs X",
]  # fmt: skip
"""Commands, with X in the place of a number."""
UNTRIED = {"fit --scale", "fit --amplitude", *(f"fit {as_option(name)}" for name in ELEMENT_OPTIONS)}
"""They are read as by other commands, and what is no number that nobody means takes a whole fit."""


@pytest.mark.slow
@pytest.mark.parametrize("command", [command.name for command in installed_commands()])
def test_every_number_is_among_them(command: str, capsys) -> None:
    tried = {part for words in WORDS if words.split()[0] == command for part in words.split()}
    with pytest.raises(SystemExit):
        main([command, "--help"])
    for names in re.findall(r"^  (--\w.*?)(?:  |$)", capsys.readouterr().out, re.MULTILINE):
        options = re.findall(r"--[\w-]+", names)
        if f"{command} {options[0]}" not in UNTRIED and _takes_number(command, options[0], capsys):
            assert tried & set(options), options


def _takes_number(command: str, option: str, capsys) -> bool:
    """Ask the command by a word that is no number; another mistake behind it keeps it from running."""
    with suppress(SystemExit):
        main([command, option, "q", "--quiet=0"])
    return re.search(r"'q' is (no|not a\b).*\bnumber", capsys.readouterr().err) is not None


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("numbers")
    scatter = '\n[uncertainty]\nm1 = { normal = "2 %" }\n'
    (folder / "p.toml").write_text(TrimmerParameters.thesis().to_toml() + scatter, "utf-8")
    times = np.arange(1000) / 2000.0
    moved = 1.4e-3 * np.sin(math.tau * 110 * times) + 1e-5 * np.sin(math.tau * 330 * times)
    lines = (f"{time:.6f},{each:.9f}\n" for time, each in zip(times, moved, strict=True))
    (folder / RECORD).write_text(f"time [s],x [m]\n{''.join(lines)}", "utf-8")
    return folder


def answered(capsys: pytest.CaptureFixture[str], words: list[str]) -> int:
    try:
        code = main(words)
    except SystemExit as stopped:
        code = int(stopped.code or 0)
    told = capsys.readouterr()
    assert code in (0, WRONG_USE, 3), told.err
    lines = told.err.splitlines()
    assert all(line.startswith("trimmer: ") for line in lines), told.err
    assert "encountered" not in told.err
    if code == WRONG_USE:
        assert len(lines) == 1
        assert told.out == ""
    return code


@pytest.mark.slow
@pytest.mark.parametrize("words", WORDS)
def test_numbers_that_nobody_means(folder: Path, monkeypatch, capsys, words: str) -> None:
    monkeypatch.chdir(folder)
    for value in VALUES:
        before = resource.getrusage(resource.RUSAGE_SELF).ru_utime
        answered(capsys, words.replace("X", value).split())
        assert resource.getrusage(resource.RUSAGE_SELF).ru_utime - before < SLOWEST, value


WITHOUT_END = (
    f"{DRIVEN} --duration 1e308",
    f"{DRIVEN} --duration 1e40",
    f"simulate {TWIN} --duration 1e20",
    f"simulate {PLAY} --impulse 1e-6 --duration 1e20",
    "identify --gap 4e-5 --frequency 1e308",
    f"map {TWIN} --vary frequency=1:2:100000 --vary plays.bridge.gap=0:1:100000",
    f"{DRIVEN} --csv a.csv --sample-rate 1e30",
)


def test_what_would_never_end_is_told_at_once(monkeypatch, tmp_path: Path, capsys) -> None:
    monkeypatch.chdir(tmp_path)
    before = resource.getrusage(resource.RUSAGE_SELF).ru_utime
    for words in WITHOUT_END:
        signal.alarm(60)  # ends the process, whatever it does
        assert answered(capsys, words.split()) == WRONG_USE
        signal.alarm(0)
    assert resource.getrusage(resource.RUSAGE_SELF).ru_utime - before < SLOWEST
