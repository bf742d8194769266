"""``trimmer respond``, and ``trimmer simulate`` of a mechanism."""

from __future__ import annotations

import json
import time
from pathlib import Path

import pytest

from tests.json_document import documented, keys
from trimmer.command_line.main import main
from trimmer.command_line.patience import patience

EXAMPLES = Path(__file__).parents[3] / "examples"
TWIN = str(EXAMPLES / "thesis-play.toml")
BY_NAME = {"outputs", "bodies", "contacts", "frictions", "densities", "box"}
BY_NAME |= {"positions", "forces"}


def with_one_name(value: object) -> object:
    """Return JSON in which objects whose keys are names have one entry, NAME."""
    if isinstance(value, list):
        return [with_one_name(each) for each in value]
    if not isinstance(value, dict):
        return value
    return {
        key: {"NAME": with_one_name(next(iter(inner.values())))}
        if key in BY_NAME and inner
        else with_one_name(inner)
        for key, inner in value.items()
    }


def printed(capsys: pytest.CaptureFixture[str], *words: str) -> dict:
    assert main([*words, "--json"]) == 0
    return json.loads(capsys.readouterr().out)


def test_keys_are_those_of_the_document(capsys: pytest.CaptureFixture[str]) -> None:
    stable = printed(capsys, "respond", TWIN)
    chaotic = printed(
        capsys, "respond", TWIN, "--set", "frictions.blade.force=0", "--set", "plays.bridge.gap=0.2mm",
        "--periods", "64",
    )  # fmt: skip
    still = printed(capsys, "respond", TWIN, "--set", "pins.pin.amplitude=0")
    found = {key for content in (stable, chaotic, still) for key in keys(with_one_name(content))}
    # An empty object stands for what a motion that does not repeat has no figures of.
    found -= {f"{prefix}{name}" for prefix in ("", "motions[].") for name in ("contacts", "frictions")}
    found |= {f"{prefix}lyapunov" for prefix in ("", "motions[].")}
    assert found == documented("trimmer respond")
    assert (stable["kind"], stable["period_count"]) == ("periodic", 1)
    assert (still["kind"], still["success"], still["period_count"]) == ("rest", True, None)
    assert still["rest"]["positions"] == dict.fromkeys(["motor", "cutter", "housing", "guard"], 0.0)
    assert (chaotic["kind"], chaotic["period_count"], chaotic["multipliers"]) == ("chaotic", None, [])


def test_the_first_sentence_says_what_it_settles_to(capsys: pytest.CaptureFixture[str]) -> None:
    words = ["--set", "plays.bridge.gap=0.2 mm", "--set", "frictions.blade.force=2"]
    assert main(["respond", TWIN, *words]) == 0
    first, *rest = capsys.readouterr().out.splitlines()
    assert first.startswith("It settles within")
    assert first.endswith("to a stable motion that repeats after 3 drive periods.")
    assert any("1/3: 8.231" in line for line in rest)
    assert any("bridge" in line and "4.33333" in line for line in rest)


def test_several_starts_are_told_apart(capsys: pytest.CaptureFixture[str]) -> None:
    words = ["--set", "plays.bridge.gap=0.2 mm", "--set", "frictions.blade.force=2", "--set", "frequency=100"]
    assert main(["respond", TWIN, *words, "--starts", "4"]) == 0
    shown = capsys.readouterr().out
    assert "4 starts settle to 2 motions; 50% of them to this one." in shown
    assert "Motion 2, 50% of the starts, the mirror image of one before" in shown
    assert "Random starts lie within motor" in shown


@pytest.mark.parametrize("words", [["block-on-belt"], ["thesis-play"], ["thesis-play", "--starts", "2"]])
def test_the_picture_is_drawn(words: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    pictures = [tmp_path / "first.svg", tmp_path / "second.svg"]
    name, *options = words
    for picture in pictures:
        assert main(["respond", str(EXAMPLES / f"{name}.toml"), *options, "--plot", str(picture)]) == 0
    assert pictures[0].read_bytes() == pictures[1].read_bytes()
    assert capsys.readouterr().out.startswith("It settles")


def test_what_does_not_repeat_is_drawn_too(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    words = ["--set", "frictions.blade.force=0", "--set", "plays.bridge.gap=0.2mm", "--periods", "64"]
    assert main(["respond", TWIN, *words, "--plot", str(tmp_path / "chaos.png")]) == 0
    assert "It is chaotic" in capsys.readouterr().out
    assert (tmp_path / "chaos.png").stat().st_size > 10_000


@pytest.mark.parametrize(
    ("words", "named"),
    [
        (["respond", TWIN, "--state", "motor"], "write BODY=DISPLACEMENT,VELOCITY"),
        (["respond", TWIN, "--state", "motr=1,2"], "'motr' is no body; did you mean motor?"),
        (["respond", TWIN, "--state", "saw=1,2"], "'saw' is no body; there are motor, cutter"),
        (["respond", TWIN, "--state", "motor=1kg,0"], "motor=1kg,0"),
        (["respond", TWIN, "--seed", "3"], "--seed has no effect without --starts"),
        (["respond", TWIN, "--set", "plays.bridge.gp=1"], "plays.bridge.gap"),
        (["respond", "nothing.toml"], "nothing.toml"),
        (["respond", TWIN, "--plot", "a.txt"], "must end in .svg, .png, .pdf"),
        (["respond", TWIN, "--plot", TWIN], "must end in"),
        (["simulate", TWIN, "--gap", "1e-5"], "--gap is for the loops of the thesis"),
        (["simulate", TWIN, "--friction", "q1=1"], "--friction is for the loops"),
        (["simulate", "--set", "frequency=1"], "--set has no effect without the file of a mechanism"),
    ],
)
def test_wrong_use_is_named(words: list[str], named: str, capsys: pytest.CaptureFixture[str]) -> None:
    try:
        code = main(words)
    except SystemExit as ended:
        code = ended.code
    assert code == 2
    assert named in capsys.readouterr().err


def test_a_mechanism_is_simulated(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    content = printed(capsys, "simulate", TWIN, "--duration", "0.1", "--state", "motor=1um,0")
    by_name = {"last_amplitudes", "energy.pins", "energy.forces", "energy.dampers", "energy.contacts"}
    still = printed(capsys, "simulate", TWIN, "--duration", "0.1", "--set", "pins.pin.amplitude=0")
    still["rest"] = with_one_name(still["rest"])
    found = set(keys(content, by_name | {"energy.frictions"})) | {
        f"rest.{key}" for key in keys(still["rest"])
    }
    assert found == documented("trimmer simulate, of a mechanism")
    assert content["rest"] is None
    assert content["energy"]["residual"] < 1e-12
    table = tmp_path / "motion.csv"
    assert main(["simulate", TWIN, "--duration", "0.1", "--csv", str(table)]) == 0
    shown = capsys.readouterr().out
    assert "bridge:" in shown
    assert "lost in friction blade" in shown
    assert table.read_text().startswith("time [s],stroke [m]\n")


def test_who_waits_is_told(capsys: pytest.CaptureFixture[str]) -> None:
    with patience(0.01):
        time.sleep(0.2)
    assert "compiles its kernels" in capsys.readouterr().err
    with patience(0.2):
        pass
    time.sleep(0.3)
    assert capsys.readouterr().err == ""


def test_a_simulated_motion_is_drawn(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    picture = tmp_path / "motion.svg"
    assert main(["simulate", TWIN, "--duration", "0.05", "--plot", str(picture)]) == 0
    assert capsys.readouterr().out.endswith(f"wrote {picture}\n")
    assert picture.read_text().startswith("<?xml")


def test_the_motion_of_a_loop_is_drawn_too(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    picture = tmp_path / "loop.pdf"
    loop = ["--element", "friction", "--gap", "1e-4", "--impulse", "1", "--duration", "0.01"]
    assert main(["simulate", *loop, "--plot", str(picture)]) == 0
    assert capsys.readouterr().out.endswith(f"wrote {picture}\n")
    assert picture.read_bytes().startswith(b"%PDF-")
