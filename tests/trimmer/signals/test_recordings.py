"""Stretches, gaps, missing values and layouts of files, piece by piece."""

from __future__ import annotations

import math
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
from scipy.io import wavfile

from trimmer.signals import wav
from trimmer.signals.csv_layout import (
    CsvLayout,
    DecimalSign,
    Delimiter,
    delimiter_of,
    ends_with_delimiter,
    is_comment,
)
from trimmer.signals.fault import Dropout
from trimmer.signals.faults import faults
from trimmer.signals.missing import Filled, MissingValues, fill
from trimmer.signals.read_wav import is_wav, read_wav
from trimmer.signals.recording import Gap, Recording, told_gaps
from trimmer.signals.sampling import Stamped, _without_repetition
from trimmer.signals.signal import Signal, SignalError
from trimmer.signals.text_file import SignalFileError
from trimmer.signals.wav import SUITED_RATES

NAN = math.nan
LINES = range(2, 30)


def filled(values: list[float], missing: MissingValues) -> tuple[list[float], list[int], int, bool]:
    found = fill(np.array(values), LINES, missing, "file")
    return found.values.tolist(), found.places.tolist(), found.interpolated, found.has_gaps


def test_missing_values_are_interpolated_between_others_and_cut_at_the_ends() -> None:
    values = [NAN, *range(10), 10.0, NAN, 14.0, NAN]
    expected = [*map(float, range(11)), 12.0, 14.0]
    assert filled(values, MissingValues.INTERPOLATE) == (expected, list(range(1, 14)), 1, False)
    assert filled(values, MissingValues.GAP) == (
        [*map(float, range(11)), 14.0],
        [*range(1, 12), 13],
        0,
        True,
    )
    whole = [3.0, 1.0, 2.0]
    for missing in MissingValues:
        assert filled(whole, missing) == (whole, [0, 1, 2], 0, False)
    assert not Filled(np.ones(2), np.array([4, 5])).has_gaps
    assert Filled(np.ones(2), np.array([4, 6])).has_gaps


@pytest.mark.parametrize(
    ("values", "missing", "message"),
    [
        ([NAN, NAN], MissingValues.GAP, "every value"),
        ([1.0, NAN, 2.0], MissingValues.REFUSE, "line 3: a value is missing"),
        ([1.0, NAN, NAN], MissingValues.REFUSE, "line 3: the first of 2 missing"),
        ([1.0, *[2.0] * 7, NAN, 2.0], MissingValues.INTERPOLATE, ""),
        ([1.0, *[2.0] * 6, NAN, 2.0], MissingValues.INTERPOLATE, "10 %"),
    ],
)
def test_missing_values_that_are_refused(values: list[float], missing: MissingValues, message: str) -> None:
    if not message:
        assert filled(values, missing)[2] == 1  # A tenth is just allowed.
        return
    with pytest.raises(SignalFileError, match=message):
        filled(values, missing)


@pytest.mark.parametrize(
    ("lines", "decimal", "expected"),
    [
        (["a;b", "1,5;2"], None, Delimiter.SEMICOLON),
        (["1\t2;3"], None, Delimiter.TAB),
        (["1,2"], None, Delimiter.COMMA),
        (["1,2"], DecimalSign.COMMA, None),
        (["1;2"], DecimalSign.COMMA, Delimiter.SEMICOLON),
        (["1.5"], None, None),
        (["a,b", "x"], None, Delimiter.COMMA),
        (["a;b", "1,2"], None, Delimiter.COMMA),
    ],
)
def test_the_sign_between_columns(
    lines: list[str], decimal: DecimalSign | None, expected: Delimiter | None
) -> None:
    assert delimiter_of(lines, CsvLayout(decimal=decimal)) is expected
    assert delimiter_of(lines, CsvLayout(Delimiter.TAB, decimal)) is Delimiter.TAB


@pytest.mark.parametrize(
    ("lines", "ends"),
    [
        (["a;b;", "1;2;", "3;4;"], True),
        (["a;b;c", "1;2;", "3;4;"], False),
        (["1;2;", "3;4"], False),
        (["1;2; "], True),
        (["a;b", "1;2;"], True),
    ],
)
def test_a_sign_that_ends_each_line(lines: list[str], ends: bool) -> None:
    assert ends_with_delimiter(lines, Delimiter.SEMICOLON) == ends
    assert not ends_with_delimiter(lines, None)


def test_comments() -> None:
    assert [is_comment(line) for line in ("# a", "  # a", "1 # a", "")] == [True, True, False, False]


def test_recordings_of_stretches() -> None:
    first, second = Signal(np.ones(3), 4.0, "a"), Signal(np.arange(5.0), 4.0, "a", start=2.0)
    third = Signal(np.arange(5.0), 4.0, "a", start=9.0)
    gap = Gap(0.5, 2.0, 5, 5)
    recording = Recording((first, second, third), (gap, gap))
    assert recording.samples == 13
    longest = recording.longest
    assert (longest.start, len(longest.notes)) == (2.0, 1)
    assert "longest of 3 stretches" in longest.notes[0]
    assert "8 samples of the others" in longest.notes[0]
    assert Recording((first,)).longest.notes == ()
    part = recording.between(2.25, 9.5)
    assert [(each.start, each.values.size) for each in part.stretches] == [(2.25, 4), (9.0, 3)]
    assert part.gaps == (gap, gap)
    with pytest.raises(SignalError, match="no sample lies"):
        recording.between(5.0, 6.0)
    assert "3 stretches, 2 gaps, 13 samples" in repr(recording)


def test_gaps_are_told() -> None:
    one, many = Gap(0.5, 2.0, 5, 1), Gap(3.0, 4.0, 9, 7)
    assert one.sentence == "gap of 1.5 s after 0.5 s (line 5), about 1 sample"
    assert many.sentence.endswith("about 7 samples")
    assert told_gaps((one,)).startswith("1 gap in the time stamps: gap of 1.5 s")
    assert told_gaps((one,) * 3).startswith("3 gaps")
    assert not told_gaps((one,) * 3).endswith("...")
    assert told_gaps((one,) * 4).endswith("; ...")
    assert told_gaps((one,) * 4).count("gap of") == 3


@pytest.mark.parametrize(("same", "left"), [(1, 1), (2, 2), (3, 0)])
def test_rows_that_repeat_are_left_out_up_to_half_of_the_steps(same: int, left: int) -> None:
    times = np.cumsum([0.0, *[0.0] * same, *[1.0] * (4 - same)])
    stamped, count = _without_repetition(Stamped(times, np.ones(5), range(2, 7), "file"))
    assert count == left
    assert list(stamped.lines) == ([2, *range(3 + same, 7)] if left else [2, 3, 4, 5, 6])
    assert len(stamped.times) == len(stamped.values) == 5 - left


def test_a_part_of_a_channel_of_a_wav_file(tmp_path: Path) -> None:
    path = tmp_path / "two.wav"
    frames = np.stack([np.arange(10), -100 * np.arange(10)], axis=1).astype(np.int16)
    wavfile.write(path, 5, frames)
    assert is_wav(path)
    found = read_wav(path, channel=2, begin=0.4, end=1.0)
    assert found.values.tolist() == [-each / 2**15 for each in (200, 300, 400, 500)]
    assert (found.start, found.sample_rate, found.name, found.full_scale) == (0.4, 5.0, "channel 2", 1.0)
    assert read_wav(path, channel=1, begin=0.41).start == 0.6
    assert read_wav(path, channel=1, end=1.19).values.size == 6
    assert read_wav(path, channel=1, begin=-3.0).values.size == 10
    assert "channel 2 of 2" in found.notes[0]
    for options in ({}, {"channel": 3}, {"channel": 1, "end": -0.3}, {"channel": 1, "begin": 2.0}):
        with pytest.raises(SignalFileError):
            read_wav(path, **options)
    alone = tmp_path / "one.wav"
    wavfile.write(alone, 5, np.array([0, 128, 255], dtype=np.uint8))
    assert read_wav(alone).values.tolist() == [-1.0, 0.0, 127 / 128]
    assert "channel" not in read_wav(alone).notes[0]
    wavfile.write(alone, 5, np.array([0.5, np.inf], dtype=np.float32))
    with pytest.raises(SignalFileError, match="sample 2 is not finite"):
        read_wav(alone)
    assert read_wav(alone, end=0.0).full_scale == math.inf
    assert not is_wav(tmp_path / "none.wav")


@pytest.mark.parametrize(
    ("rate", "suited"),
    [(8000.0, 8000), (192000.0, 192000), (7999.0, 8000), (8001.0, 11025), (47999.0, 48000), (60000.0, 48000)],
)
def test_the_rate_that_a_sound_is_written_at(rate: float, suited: int) -> None:
    assert wav._suited(rate) == suited
    assert suited in SUITED_RATES


def test_ratios_of_rates_are_rounded_to_whole_numbers_that_are_not_large() -> None:
    assert wav._simple(Fraction(441, 480)) == Fraction(441, 480)
    assert wav._simple(Fraction(480, 441)) == Fraction(480, 441)
    third = Fraction(1, 3) + Fraction(1, 10**12)
    assert wav._simple(third) == Fraction(1, 3)
    assert wav._simple(1 / third) == 3
    assert wav._simple(Fraction(1, 70_000)) == Fraction(1, 70_000)


def test_a_dropout_is_told_with_its_place_and_others() -> None:
    values = np.sin(0.37 * np.arange(2000)) + 0.3
    values[500:540], values[900:960] = 0.123, 0.456
    (found,) = (each for each in faults(Signal(values, 100.0, start=7.0)) if isinstance(each, Dropout))
    assert (found.begin, found.end) == (16.0, pytest.approx(16.59))
    assert (found.value, found.samples, found.others, found.kind) == (0.456, 60, 1, "dropout")
    assert "as 1 more" in found.sentence
