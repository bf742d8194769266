"""What signals, recordings, bands and files of them say, where numbers are large, negative or at a limit."""

from __future__ import annotations

import math
import wave
from pathlib import Path

import matplotlib
import numpy as np
import pytest
from matplotlib.figure import Figure

from trimmer.errors import WrongTypeError
from trimmer.files import STANDARD_INPUT
from trimmer.signals.band import EVERYWHERE, Band
from trimmer.signals.columns import _decimal_hint
from trimmer.signals.csv_layout import CsvLayout, DecimalSign, Delimiter
from trimmer.signals.csv_table import read_table
from trimmer.signals.missing import MissingValues, fill
from trimmer.signals.omega_kernel import OmegaKernel
from trimmer.signals.quantity import Quantity, in_si, quantity_of
from trimmer.signals.read import read_recording
from trimmer.signals.read_wav import is_wav, read_wav
from trimmer.signals.recording import Gap, Recording, told_gaps
from trimmer.signals.resample import resampled, trusted_band
from trimmer.signals.sampling import Sampling
from trimmer.signals.signal import Signal, SignalError
from trimmer.signals.text_file import SignalFileError, read_lines, unreadable
from trimmer.signals.units import SECONDS, in_brackets, is_unit
from trimmer.signals.write import write_signal


def test_sizes_of_a_signal_are_those_of_its_largest_values() -> None:
    assert Signal([0.0, -3e300 / 4, 3e300 / 4], 1.0).rms == pytest.approx(math.sqrt(2 / 3) * 0.75e300)
    assert Signal([-5.0, -5.0], 1.0).rms == 0.0
    assert Signal([0.0, 0.0], 1.0).rms == 0.0
    with pytest.raises(SignalError, match="samples above"):
        Signal([0.0, -1e301, 1.0], 1.0)
    assert Signal([1e300], 1.0).values.tolist() == [1e300]
    scaled = Signal([1.0, -2.0], 1.0, unit="V", full_scale=5.0).scaled(-3.0, "mm")
    assert (scaled.values.tolist(), scaled.unit, scaled.full_scale) == ([-3.0, 6.0], "mm", 15.0)
    assert Signal([1.0], 1.0, unit="V").scaled(2.0).unit == "V"
    for factor in (0.0, math.inf, -math.inf, math.nan):
        with pytest.raises(SignalError, match="the factor must be finite and not 0"):
            scaled.scaled(factor)


@pytest.mark.parametrize(
    ("options", "error"),
    [
        ({"converted": 0.5}, ValueError),
        ({"interpolated": -1}, ValueError),
        ({"trusted": (0.0, 1.0)}, WrongTypeError),
        ({"full_scale": 0.0}, SignalError),
        ({"full_scale": math.nan}, SignalError),
        ({"start": math.inf}, SignalError),
        ({"notes": (1,)}, WrongTypeError),
        ({"name": 1}, WrongTypeError),
        ({"unit": None}, WrongTypeError),
    ],
)
def test_fields_of_a_signal_are_checked(options: dict[str, object], error: type[Exception]) -> None:
    with pytest.raises(error):
        Signal([1.0], 1.0, **options)  # type: ignore[arg-type]
    assert Signal([1.0], 1.0, converted=-2, interpolated=0).converted == -2


def test_a_signal_as_a_table_a_picture_and_a_line() -> None:
    matplotlib.use("agg")
    signal = Signal([1.0, -2.0, 5.0], 50.0, "stroke", "mm", start=0.5)
    table = signal._table()
    assert (table.title, [column.name for column in table.columns]) == (
        "Samples of stroke",
        ["time", "stroke"],
    )
    assert [column.unit for column in table.columns] == ["s", "mm"]
    assert [list(row) for row in table.rows()] == [[0.5, 1.0], [0.52, -2.0], [0.54, 5.0]]
    assert [column.name for column in Signal([1.0], 1.0, "time")._table().columns] == ["time", "value"]
    assert signal._told() == "stroke [mm], 3 samples at 50 Hz, 0.06 s"
    ax = Figure().add_subplot()
    assert signal.plot(ax) is ax
    assert ax.lines[0].get_ydata().tolist() == [1.0, -2.0, 5.0]


def test_parts_of_a_signal_include_both_ends_and_a_millionth_of_a_sample() -> None:
    signal = Signal(np.arange(10.0), 10.0, start=1.0)
    for begin, end, values in (
        (1.2, 1.5, [2, 3, 4, 5]),
        (1.2 + 9e-8, 1.5 - 9e-8, [2, 3, 4, 5]),
        (1.81, 9, [9]),
    ):
        part = signal.between(begin, end)
        assert (part.values.tolist(), part.start) == (values, pytest.approx(1.0 + 0.1 * values[0]))
    assert signal.between(1.2 + 2e-7, 1.5 - 2e-7).values.tolist() == [3, 4]
    with pytest.raises(
        SignalError, match=r"no sample lies from 1\.21 s to 1\.29 s: the record goes from 1 s to 1\.9 s"
    ):
        signal.between(1.21, 1.29)


def test_bands_have_the_narrower_ends_with_their_reasons() -> None:
    wide, narrow = Band(2.0, 90.0, "a", "b"), Band(5.0, 80.0, "c", "d")
    assert wide.within(narrow) == narrow.within(wide) == narrow
    assert wide.within(Band(1.0, 80.0, "c", "d")) == Band(2.0, 80.0, "a", "d")
    assert wide.within(Band(2.0, 90.0, "c", "d")) == wide
    assert [2.0 in wide, 90.0 in wide, 1.9 in wide, 90.1 in wide] == [True, True, False, False]
    assert (EVERYWHERE.lowest, EVERYWHERE.highest) == (0.0, math.inf)
    assert EVERYWHERE.sentence == "trusted at all frequencies up to half of the sample rate"
    assert wide.sentence == "trusted from 2 Hz (a) up to 90 Hz (b)"
    assert Band(2.0, lowest_reason="a").sentence == "trusted from 2 Hz (a)"
    assert Band(highest=90.0, highest_reason="b").sentence == "trusted up to 90 Hz (b)"


def test_gaps_and_stretches_in_words() -> None:
    gaps = tuple(Gap(float(k), k + 0.5, 10 * k, k) for k in range(1, 5))
    assert gaps[0].sentence == "gap of 0.5 s after 1 s (line 10), about 1 sample"
    assert gaps[1].sentence == "gap of 0.5 s after 2 s (line 20), about 2 samples"
    told = [told_gaps(gaps[:count]) for count in (1, 3, 4)]
    assert told[0] == f"1 gap in the time stamps: {gaps[0].sentence}"
    assert told[1] == "3 gaps in the time stamps: " + "; ".join(gap.sentence for gap in gaps[:3])
    assert told[2] == told[1].replace("3 gaps", "4 gaps") + "; ..."
    parts = tuple(
        Signal(np.arange(float(size)), 10.0, start=start) for size, start in ((2, 0.0), (5, 1.0), (5, 2.0))
    )
    recording = Recording(parts, gaps[:2])
    assert recording._told() == "signal, 3 stretches, 2 gaps, 12 samples"
    assert (recording.samples, recording.longest.start) == (12, 1.0)
    assert "the longest of 3 stretches" in recording.longest.notes[0]
    assert "from 1 s on for 0.5 s; 7 samples of the others are left out" in recording.longest.notes[0]
    assert Recording(parts[:1]).longest is parts[0]
    part = recording.between(0.1, 1.2)
    assert ([each.values.size for each in part.stretches], part.gaps) == ([1, 3], recording.gaps)
    with pytest.raises(SignalError, match="no sample lies"):
        recording.between(0.5, 0.6)


def test_a_comma_is_suspected_only_where_every_cell_is_a_whole_number(file) -> None:
    for text, hinted in (("1,-2\n+3,4\n", True), ("1,2\n3,4.5\n", False), ("1.5,2\n3,4\n", False)):
        assert bool(_decimal_hint(read_table(file(text), CsvLayout()))) is hinted
    for count, hinted in ((99, False), (100, True)):
        assert bool(_decimal_hint(read_table(file(count * "1,2\n" + "1.5,2\n"), CsvLayout()))) is hinted
    layout = CsvLayout("semicolon", "comma")  # type: ignore[arg-type]
    assert (layout.delimiter, layout.decimal) == (Delimiter.SEMICOLON, DecimalSign.COMMA)


def test_files_that_are_no_text_are_named_with_the_line(tmp_path: Path) -> None:
    path = tmp_path / "a.csv"
    for content, line in ((b"\x00", 1), (b"1\n2\n\x013", 3), (b"\n\x7f", 2)):
        path.write_bytes(content)
        with pytest.raises(
            SignalFileError, match=f"a.csv, line {line}: byte 0x{content.lstrip(b'123' + bytes([10]))[0]:02x}"
        ):
            read_lines(path)
    path.write_bytes(b"a\r\nb\rc\nd\xff")
    assert read_lines(path) == ["a", "b", "c", "d\xff"]
    told = str(unreadable(path, PermissionError(13, "not allowed")))
    assert told == f"{path}: cannot be read: not allowed; name a file of samples"
    assert "cannot be read: lost;" in str(unreadable(path, OSError("lost")))


def test_which_files_are_wav(tmp_path: Path) -> None:
    path = tmp_path / "a"
    heads = ((b"RIFF....WAVE", True), (b"RIFX....WAVE", True), (b"RF64....WAVE", True))
    for head, expected in (
        *heads,
        (b"RIFF....AVI ", False),
        (b"OggS....WAVE", False),
        (b"RIFF", False),
        (b"", False),
    ):
        path.write_bytes(head + b"....")
        assert is_wav(path) is expected
    assert (is_wav(tmp_path / "none"), is_wav(tmp_path), is_wav(STANDARD_INPUT)) == (False, False, False)


def test_a_wav_file_without_samples_or_rate_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "a.wav"
    for rate, count in ((1000, 0), (1, 3), (1000, 3)):
        with wave.open(str(path), "wb") as sound:
            sound.setnchannels(1)
            sound.setsampwidth(2)
            sound.setframerate(rate)
            sound.writeframes(count * b"\x00\x40")
        if count:
            assert (read_wav(path).sample_rate, read_wav(path).values.tolist()) == (rate, [0.5] * 3)
        else:
            with pytest.raises(SignalFileError, match="holds no samples, or no sample rate"):
                read_wav(path)
    content = path.read_bytes()
    path.write_bytes(content[:24] + bytes(8) + content[32:])
    with pytest.raises(SignalFileError, match="holds no samples, or no sample rate"):
        read_wav(path)
    with pytest.raises(ValueError, match="channel must be"):
        read_wav(path, channel=0)


def test_columns_without_values(file) -> None:
    values = np.array([math.nan, 1.0, math.nan, 4.0, math.nan, *np.arange(5.0, 24.0)])
    filled = fill(values, range(1, 30), MissingValues.INTERPOLATE, "f")
    assert (filled.values.tolist(), filled.interpolated) == ([1.0, 2.5, 4.0, 4.5, *np.arange(5.0, 24.0)], 2)
    assert (filled.places[0], filled.places[-1], filled.has_gaps) == (1, 23, False)
    gaps = fill(values, range(1, 30), MissingValues.GAP, "f")
    assert (gaps.places[:3].tolist(), gaps.has_gaps, gaps.interpolated) == ([1, 3, 5], True, 0)
    assert not fill(values[[0, 1, 3]], range(3), MissingValues.GAP, "f").has_gaps
    with pytest.raises(SignalFileError, match=r"^f, line 4: the first of 3 missing values, more than 10 %"):
        fill(
            np.array([1.0, math.nan, math.nan, math.nan, *np.ones(25)]),
            range(3, 40),
            MissingValues.INTERPOLATE,
            "f",
        )
    ten = fill(np.array([1.0, math.nan, *np.ones(8)]), range(10), MissingValues.INTERPOLATE, "f")
    assert ten.interpolated == 1
    with pytest.raises(WrongTypeError, match="sampling must be"):
        read_recording(file("1\n2\n"), sample_rate=1.0, sampling="split")  # type: ignore[arg-type]
    with pytest.raises(WrongTypeError, match="layout must be"):
        read_recording(file("1\n2\n"), sample_rate=1.0, layout="comma")  # type: ignore[arg-type]
    recording = read_recording(file("y\n1\n2\n"), sample_rate=4.0, sampling=Sampling())
    assert (recording.stretches[0].times.tolist(), recording.gaps) == ([0.0, 0.25], ())


def test_units_by_hand() -> None:
    assert SECONDS == {
        "": 1.0,
        "s": 1.0,
        "sec": 1.0,
        "ms": 1e-3,
        "us": 1e-6,
        "µs": 1e-6,
        "μs": 1e-6,
        "ns": 1e-9,
    }
    sizes = {
        "m": 1.0,
        "cm": 0.01,
        "mm": 1e-3,
        "um": 1e-6,
        "nm/s": 1e-9,
        "g": 9.80665,
        "mg": 9.80665e-3,
        "V": 1.0,
    }
    assert {unit: pytest.approx(in_si(unit), rel=1e-15) for unit in sizes} == sizes
    kinds = {
        "mm": Quantity.DISPLACEMENT,
        "m s^-1": Quantity.VELOCITY,
        "mg": Quantity.ACCELERATION,
        "": Quantity.OTHER,
    }
    assert {unit: quantity_of(unit) for unit in kinds} == kinds
    assert [each.derivatives for each in list(Quantity)[:3]] == [0, 1, 2]
    with pytest.raises(ValueError, match="not known"):
        _ = Quantity.OTHER.derivatives
    cells = {
        "m": True,
        " [x] ": True,
        "(rpm)": True,
        "": True,
        "ms": True,
        "mV": True,
        "x": False,
        "[a] b": False,
    }
    assert {cell: is_unit(cell) for cell in cells} == cells
    assert [in_brackets(cell) for cell in (" m ", "[m]", "(m)", "", " ")] == ["[m]", "[m]", "(m)", "", ""]


def test_splines_over_unequal_steps() -> None:
    times = np.array([1.0, 1.3, 1.5, 2.0, 2.2, 3.0])
    cubic = times**3 - 2.0 * times
    assert resampled(times, cubic, 4.0) == pytest.approx([x**3 - 2 * x for x in np.arange(1.0, 3.1, 0.25)])
    assert resampled(times, cubic, 4.1).size == 9
    assert resampled(0.1 * np.arange(8.0), np.arange(8.0), 10.0).size == 8
    band = trusted_band(times)
    assert band.highest == pytest.approx((0.01 * 384 / 5) ** 0.25 / (2 * math.pi * 0.8))
    assert band.lowest == 0.0
    assert "steps of up to 0.8 s, lines exact to 1 %" in band.highest_reason


def test_an_offset_does_not_matter_to_the_slope_that_is_put_back() -> None:
    values = np.sin(np.arange(500) / 5.0)
    kernel = OmegaKernel(1, Band(0.0, 200.0), 1000.0, 60)
    plain, *bounds = kernel.applied(values)
    moved, *others = kernel.applied(values + 1e6)
    assert moved == pytest.approx(plain, abs=1e-4)
    assert others == pytest.approx(bounds, rel=1e-5)


def test_only_signals_with_times_that_differ_are_written(tmp_path: Path) -> None:
    signal, path = Signal([1.0, 2.0], 1000.0, "a"), tmp_path / "a.csv"
    with pytest.raises(WrongTypeError, match="others"):
        write_signal(path, signal, [1.0, 2.0])  # type: ignore[arg-type]
    for start in (-1e13, 1e13):
        with pytest.raises(SignalError, match="cannot be told apart"):
            write_signal(path, Signal([1.0, 2.0], 1000.0, "a", start=start))
    late = Signal(np.arange(3.0), 1e-10, "a", start=-1e10)  # the middle one is at 0
    write_signal(path, late)
    with pytest.raises(SignalError, match="cannot be told apart"):
        write_signal(path, Signal(np.arange(3.0), 1e8, "a", start=1e6))
    assert not (tmp_path / "b.csv").exists()
