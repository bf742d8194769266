"""What options make of a record: how it is read, scaled and converted, and what is refused of it."""

from __future__ import annotations

import math
from argparse import Namespace
from pathlib import Path
from types import SimpleNamespace as Made
from typing import Any

import numpy as np
import pytest

from trimmer.command_line.parser import OptionError
from trimmer.command_line.signals import signal_options
from trimmer.command_line.signals.signal_options import chosen_recording
from trimmer.errors import TrimmerError
from trimmer.signals.csv_layout import CsvLayout
from trimmer.signals.fault import Certainty, Clipping
from trimmer.signals.recording import Recording
from trimmer.signals.sampling import Gaps, Sampling, TimeStamps
from trimmer.signals.signal import Signal, SignalError

SIGNAL = Signal(np.sin(0.1 * np.arange(400.0)), 500.0, "x", "")
USUAL = {
    "column": None,
    "time": None,
    "rate": None,
    "delimiter": None,
    "decimal": None,
    "missing": "refuse",
    "channel": None,
    "ignore_time": False,
    "resample": False,
    "gaps": "refuse",
    "begin": None,
    "until": None,
    "scale": None,
    "unit": None,
    "clipped": "mark",
    "quantity": None,
    "lowest": None,
    "highest": None,
    "sensor_corner": None,
}


def asked(file: Path | str = "a.csv", **changes: Any) -> Namespace:
    return Namespace(**USUAL | {"file": Path(file), "given": frozenset(changes)} | changes)


@pytest.fixture
def read(monkeypatch: pytest.MonkeyPatch) -> dict[str, Any]:
    """What the library's readers are asked for; names of WAV files end in ``.wav``."""
    found: dict[str, Any] = {"between": None}

    class Record(Recording):
        def between(self, begin: float, end: float) -> Recording:
            found["between"] = begin, end
            return self

    def of_text(*given: Any, **keywords: Any) -> Recording:
        found["text"] = given, keywords
        return Record((SIGNAL,))

    def of_wav(*given: Any, **keywords: Any) -> Signal:
        found["wav"] = given, keywords
        return SIGNAL

    monkeypatch.setattr("trimmer.signals.read.read_recording", of_text)
    monkeypatch.setattr("trimmer.signals.read_wav.read_wav", of_wav)
    monkeypatch.setattr("trimmer.signals.read_wav.is_wav", lambda file: file.suffix == ".wav")
    return found


def test_a_table_is_read_as_its_options_say(read: dict[str, Any]) -> None:
    chosen = chosen_recording(asked())
    usual = {"column": None, "time_column": None, "sample_rate": None, "missing": "refuse"}
    equal = Sampling(TimeStamps.EQUAL, Gaps.REFUSE)
    expected = usual | {"layout": CsvLayout(None, None), "sampling": equal}
    assert read["text"] == ((Path("a.csv"),), expected)
    assert (read["between"], chosen.signal, chosen.full_scale_is_one) == (None, SIGNAL, False)
    given = {"column": "x", "time": "t", "rate": 5.0, "missing": "gap"}
    chosen_recording(asked(**given, delimiter="semicolon", decimal="comma", gaps="split", ignore_time=True))
    expected = {"column": "x", "time_column": "t", "sample_rate": 5.0, "missing": "gap"}
    ignored = Sampling(TimeStamps.IGNORE, Gaps.SPLIT)
    assert read["text"][1] == expected | {"layout": CsvLayout("semicolon", "comma"), "sampling": ignored}
    chosen_recording(asked(resample=True))
    assert read["text"][1]["sampling"] == Sampling(TimeStamps.RESAMPLE, Gaps.REFUSE)
    for begin, until, ends in (
        (0.5, None, (0.5, math.inf)),
        (None, 0.7, (-math.inf, 0.7)),
        (0.5, 0.7, (0.5, 0.7)),
    ):
        chosen_recording(asked(begin=begin, until=until))
        assert read["between"] == ends


def test_sound_is_read_as_its_options_say(read: dict[str, Any]) -> None:
    chosen = chosen_recording(asked("a.wav"))
    assert read["wav"] == ((Path("a.wav"),), {"channel": None, "begin": 0.0, "end": math.inf})
    assert chosen.full_scale_is_one
    assert not chosen_recording(asked("a.wav", scale=2.0)).full_scale_is_one
    chosen_recording(asked("a.wav", channel=2, begin=0.25, until=0.75))
    assert read["wav"][1] == {"channel": 2, "begin": 0.25, "end": 0.75}
    for name in ("column", "time", "delimiter", "decimal", "missing", "gaps", "rate"):
        with pytest.raises(OptionError, match=f"--{name} has no effect without a CSV file"):
            chosen_recording(asked("a.wav", **{name: "refuse"}))
    for name in ("ignore_time", "resample"):
        with pytest.raises(OptionError, match=f"--{name.replace('_', '-')} has no effect on a WAV file"):
            chosen_recording(asked("a.wav", **{name: True}))


def test_a_channel_is_of_sound_unless_there_is_no_file(read: dict[str, Any], tmp_path: Path) -> None:
    there = tmp_path / "a.csv"
    there.write_text("x")
    for file in (there, Path("-")):
        with pytest.raises(OptionError, match="--channel has no effect without a WAV file"):
            chosen_recording(asked(file, channel=1))
    chosen_recording(asked(tmp_path / "none.csv", channel=1))  # the reader tells that it is not there


def test_samples_are_scaled_and_get_a_unit(read: dict[str, Any]) -> None:
    scaled = chosen_recording(asked(scale=-2.0)).signal
    np.testing.assert_array_equal(scaled.values, -2.0 * SIGNAL.values)
    assert scaled.unit == ""
    named = chosen_recording(asked(unit="mm/s")).signal
    assert (named.values[5], named.unit) == (SIGNAL.values[5], "mm/s")
    metres = Signal(SIGNAL.values, 500.0, "x", "m")
    with pytest.raises(OptionError, match=r"a.csv: the heading says that x is in m, not in m/s;"):
        signal_options._with_unit(asked(unit="m/s"), metres)
    assert signal_options._with_unit(asked(unit="m"), metres).unit == "m"
    again = signal_options._with_unit(asked(scale=3.0), metres)
    assert (again.unit, again.values[7]) == ("m", pytest.approx(3.0 * metres.values[7]))


def test_what_is_surely_clipped_is_refused_if_asked() -> None:
    def faults(certainty: Certainty) -> tuple[Any, ...]:
        return (Made(sentence="other"), Clipping(certainty, 3, 0, 2, 100, 0.5, 2.0))

    for certainty in (Certainty.CERTAIN, Certainty.LIKELY):
        with pytest.raises(OptionError, match=r"a.csv: 3 of 100 samples"):
            signal_options._refuse_clipped(asked(clipped="refuse"), faults(certainty))
        signal_options._refuse_clipped(asked(), faults(certainty))
    signal_options._refuse_clipped(asked(clipped="refuse"), faults(Certainty.POSSIBLE))
    signal_options._refuse_clipped(asked(clipped="refuse"), faults(Certainty.POSSIBLE)[:1])


@pytest.mark.parametrize("told", ["too short", "a.csv: too short"])
def test_errors_of_a_record_name_its_file_once(monkeypatch: pytest.MonkeyPatch, told: str) -> None:
    def fail(*_: Any, **__: Any) -> None:
        raise SignalError(told)

    monkeypatch.setattr("trimmer.signals.read_wav.is_wav", lambda file: False)
    monkeypatch.setattr("trimmer.signals.read.read_recording", fail)
    with pytest.raises(TrimmerError) as error:
        chosen_recording(asked())
    assert str(error.value) == "a.csv: too short"
