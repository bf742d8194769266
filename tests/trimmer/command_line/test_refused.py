"""Words that cannot be meant together are refused for their own reason, before any work is done."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from collections.abc import Sequence
from pathlib import Path

import pytest

from trimmer.command_line.loops import limit_cycles
from trimmer.command_line.main import _parser, installed_commands
from trimmer.command_line.mechanisms import map_options
from trimmer.errors import TrimmerError
from trimmer.mechanism.mechanism import Mechanism
from trimmer.parameters import TrimmerParameters

EXAMPLES = Path(__file__).parents[3] / "examples"
TWIN = str(EXAMPLES / "thesis-play.toml")
SCATTER = str(EXAMPLES / "scatter.toml")
PLAY = ["--element", "friction", "--gap", "4e-5"]
DRIVEN = ["simulate", "--drive", "110", "--amplitude", "1e-3"]
LINE = ["--vary", "frequency=60:120:3"]


@pytest.fixture(scope="module")
def parser() -> ArgumentParser:
    return _parser(installed_commands())


@pytest.fixture(scope="module")
def file(tmp_path_factory: pytest.TempPathFactory) -> str:
    """A parameter file whose name is that of a picture."""
    path = tmp_path_factory.mktemp("read") / "a.svg"
    path.write_text(TrimmerParameters.thesis().to_toml())
    return str(path)


def refuse(parser: ArgumentParser, words: Sequence[str], told: str) -> None:
    arguments = parser.parse_args(words)
    arguments.quiet = True
    with pytest.raises(TrimmerError) as error:
        arguments.run(arguments)
    assert str(error.value).startswith(told)


@pytest.mark.parametrize(
    ("words", "option", "meaning"),
    [
        (["orbits", *PLAY, "--parameters", "F"], "--plot", "parameters"),
        (["limit-cycles", *PLAY, "--parameters", "F"], "--plot", "parameters"),
        (["identify", "--gap", "4e-5", "--frequency", "740", "--parameters", "F"], "--plot", "parameters"),
        (["linear", "--parameters", "F"], "--plot", "parameters"),
        ([*DRIVEN, "--parameters", "F"], "--plot", "parameters"),
        (["spectrum", "F"], "--plot", "signal"),
        (["spectrum", "a.csv", "--parameters", "F"], "--plot", "parameters"),
        (["overlay", "F", "--against", TWIN], "--plot", "signal"),
        (["overlay", "a.csv", "--against", "F"], "--plot", "mechanism"),
        (["fit", "F", "a.csv"], "--output", "mechanism"),
        (["fit", TWIN, "F"], "--plot", "measurement"),
        (["respond", "F"], "--plot", "mechanism"),
        (["follow", "F", "--vary", "a", "--from", "1", "--to", "2"], "--plot", "mechanism"),
        (["map", "F", *LINE], "--output", "mechanism"),
        (["sample", "F"], "--output", "mechanism"),
        (["simulate", "F"], "--csv", "mechanism"),
        (["derive", "F"], "--latex", "mechanism"),
        (["derive", "F"], "--module", "mechanism"),
    ],
    ids=lambda each: each if isinstance(each, str) else each[0],
)
def test_what_is_read_is_not_written(
    parser: ArgumentParser, file: str, words: list[str], option: str, meaning: str
) -> None:
    given = [file if word == "F" else word for word in words]
    refuse(parser, [*given, option, file], f"{option} {file}: is the file of the {meaning}")


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (["spectrum", "-", "--parameters", "-"], "signal and --parameters cannot both be read"),
        (["overlay", "-", "--against", "-"], "signal and --against cannot both be read"),
        (["fit", "-", "-"], "mechanism and measurement cannot both be read"),
        (["fit", TWIN, "a.csv", "--starts", "1", "--seed", "1"], "--seed has no effect without --starts"),
        (["fit", TWIN, "a.csv", "--seed", "-1"], "--seed -1: must not be negative"),
        (["spectrum", "a.csv", "--output", "q2"], "--output has no effect without --gap"),
        (["spectrum", "a.csv", "--channels", "both"], "--channels has no effect without --gap"),
        (["spectrum", "a.csv", "--bits", "24"], "--bits has no effect without --wav"),
        (["spectrum", "a.csv", "--ignore-time"], "--ignore-time needs the sample rate"),
        (["spectrum", "a.csv", "--sensor-corner", "2"], "--sensor-corner has no effect without --as"),
        (["respond", TWIN, "--seed", "1"], "--seed has no effect without --starts"),
        (["respond", TWIN, "--starts", "2", "--seed", "-1"], "--seed -1: must not be negative"),
        (["follow", TWIN, "--vary", "a", "--from", "1", "--to", "2", "--points", "1"], "--points 1: give"),
        (
            ["follow", TWIN, "--vary", "frequency=3", "--from", "1", "--to", "2"],
            "'frequency=3' is no place: write names with dots",
        ),
        (["map", TWIN, *LINE, "--special", "1"], "--special follows points over two numbers"),
        (
            ["map", TWIN, *LINE, "--vary", "pins.pin.order=1:2:2", "--special", "2"],
            "pins.pin.order: orders are whole numbers",
        ),
        (
            ["map", TWIN, *LINE, "--vary", "plays.bridge.gap=0:1:2", "--special", "1001"],
            "--special 1001: give",
        ),
        (["sample", SCATTER, "--count", "1000001"], "1000001 samples do not fit into memory"),
        (
            ["follow", TWIN, "--vary", "frequency", "--from", "1", "--to", "2", "--harmonics", "1001"],
            "--harmonics 1001: give at most 1000",
        ),
        (
            ["simulate", TWIN, "--duration", "1e9"],
            "--duration 1e+09 s is 1.1e+11 drive periods; give at most",
        ),
        (["map", TWIN, *LINE, "--seed", "1"], "--seed has no effect without --starts"),
        (["map", TWIN, *LINE, "--periods", "1"], "--periods 1: give a whole number from 2 on"),
        (["map", TWIN, *LINE, "--starts", "0"], "--starts 0: give a whole number from 1 on"),
        (["map", TWIN, *LINE, "--starts", "2", "--seed", "-1"], "--seed -1: give a whole number from 0 on"),
        (["map", TWIN, *LINE, "--resume"], "--resume goes on with the file of --output"),
        (
            ["map", TWIN, *LINE, "--resume", "--output", "a", "--overwrite"],
            "--resume and --overwrite contradict",
        ),
        (["map", TWIN, *LINE, "--jobs", "0"], "--jobs 0: give a whole number from 1 on"),
        (["map", TWIN, *LINE, "--jobs", "99999"], "--jobs 99999: this computer has"),
        (["sample", SCATTER, "--jobs", "99999"], "--jobs 99999: this computer has"),
        (["map", TWIN, *LINE, "--jobs", "1", "--scheduler", "x"], "--jobs is of this computer"),
        (["map", TWIN, *LINE, "--scheduler", " "], "--scheduler: give the address"),
        (["map", TWIN], "--vary is missing: give it once"),
        (["map", TWIN, *LINE, *LINE, *LINE], "--vary was given 3 times: give it once"),
        (["map", TWIN, *LINE, *LINE], "--vary frequency was given twice"),
        (["map", TWIN, "--vary", "frequency=1:2"], "--vary frequency=1:2: write PLACE=A:B:N"),
        (["map", TWIN, "--vary", "frequency=2:2.0:3"], "--vary frequency=2:2.0:3: goes from 2 to the same"),
        (["map", TWIN, "--vary", "frequency=1:2:1"], "--vary frequency=1:2:1: 1 is no number of values"),
        (["map", TWIN, "--vary", "frequency=1:2 kg:3"], "--vary frequency: '2 kg'"),
        (["sample", SCATTER, "--seed", "-1"], "--seed -1: give a whole number from 0 on"),
        (["sample", SCATTER, "--indices", "--plan", "sobol"], "--indices chooses the samples itself"),
        (["sample", SCATTER, "--channels", "both"], "--channels has no effect without --gap"),
        (["sample", SCATTER, "--resume"], "--resume goes on with the file of --output"),
        (["sample", SCATTER, "--jobs", "-1"], "--jobs -1: give a whole number"),
        *(
            (["sample", SCATTER, "--gap", "4e-5", *words], f"{words[0]} has no effect without a mechanism")
            for words in (["--balance", "1"], ["--output", "a"], ["--plot", "a.svg"], ["--jobs", "2"])
        ),
        (["simulate", "--set", "a=1"], "--set has no effect without the file of a mechanism"),
        (["simulate", "--state", "a=1,2"], "--state has no effect without the file of a mechanism"),
        (["simulate", TWIN, "--friction", "q2-q4=1"], "--friction is for the loops of the thesis"),
        (["simulate", TWIN, "--friction", "q2-q4=1", "--drive", "1"], "--drive is for the loops"),
        (["simulate", TWIN, "--duration", "0"], "--duration 0: duration must be positive"),
        (["simulate", TWIN, "--sample-rate", "5"], "--sample-rate has no effect without --csv or --wav"),
        (["simulate", TWIN, "--sample-rate", "3", "--csv", "a"], "--duration 0.5 s at --sample-rate 3 Hz"),
        (["simulate"], "without --element and --drive nothing happens"),
        (["simulate", "--slope", "1"], "--slope has no effect without --element"),
        (["simulate", *PLAY], "the closed loop stays at rest"),
        (["simulate", *PLAY, "--impulse", "inf"], "--impulse inf: must be finite"),
        (["simulate", "--drive", "1"], "a drive has a frequency and an amplitude: --amplitude (m)"),
        (["simulate", "--amplitude", "1"], "a drive has a frequency and an amplitude: --drive (Hz)"),
        (["simulate", "--drive", "0", "--amplitude", "1"], "--drive 0: drive must be positive"),
        (["simulate", "--drive", "1", "--amplitude", "-1"], "--amplitude -1: must be finite and not"),
        (["simulate", "--drive", "1", "--amplitude", "inf"], "--amplitude inf: must be finite and not"),
        ([*DRIVEN, "--friction", "q2-q4"], "--friction q2-q4: write the displacement and the force"),
        ([*DRIVEN, "--friction", "q2-q4=a"], "--friction q2-q4=a: 'a' is not a number"),
        (["identify", "--gap", "0", "--frequency", "740"], "--gap 0: gap must be positive"),
        (["identify", "--gap", "1", "--frequency", "-2"], "--frequency -2: frequency must be positive"),
        (["identify", "--gap", "1", "--frequency", "2", "--uncertainty", "2"], "--uncertainty 2: must be"),
        (["limit-cycles", "--element", "friction"], "--element friction needs --gap"),
        (["limit-cycles", *PLAY, "--force", "1"], "--element friction does not use --force"),
        (["limit-cycles", *PLAY, "--omega-range", "2", "1"], "--omega-range 2 1: needs 0 < lowest"),
        (
            ["limit-cycles", "--element", "relay", "--force", "1", "--hysteresis", "-1"],
            "--hysteresis -1: must be zero or positive (m)",
        ),
    ],
    ids=lambda each: each if isinstance(each, str) else None,
)
def test_words_that_cannot_be_meant_together(parser: ArgumentParser, words: list[str], told: str) -> None:
    refuse(parser, words, told)


def test_limits_of_what_is_searched_and_varied() -> None:
    asked = Namespace(omega_range=[0.5, 0.75])
    assert limit_cycles._omega_range(asked) == (0.5, 0.75)
    for wrong in ([0.0, 1.0], [1.0, 1.0], [1.0, float("inf")]):
        asked.omega_range = wrong
        with pytest.raises(TrimmerError):
            limit_cycles._omega_range(asked)
    twin = Mechanism.from_toml(TWIN)
    texts = ["plays.bridge.gap = 0 : 40 um : 3", "frequency=120:60:2"]
    assert map_options.varied_values(twin, texts) == {
        "plays.bridge.gap": [0.0, 2e-5, 4e-5],
        "frequency": [120.0, 60.0],
    }
    assert list(map_options.varied_values(twin, texts[1:])) == ["frequency"]
    with pytest.raises(TrimmerError, match=r"did you mean plays\.bridge\.gap"):
        map_options.varied_values(twin, ["plays.bridge.gpa=0:1:3"])
