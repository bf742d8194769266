"""WAV files that SciPy and the standard library wrote come back."""

import io
import wave
from pathlib import Path

import numpy as np
import pytest
from scipy.io import wavfile

from trimmer.signals import read_wav, write_wav
from trimmer.signals.reading_wav import is_wav
from trimmer.signals.text_file import SignalFileError

X = 0.5 * np.sin(np.arange(1000) / 10)
KINDS = {
    np.uint8: (8, lambda x: np.rint(128 * x + 128)),
    np.int16: (16, lambda x: np.rint(2.0**15 * x)),
    np.int32: (32, lambda x: np.rint(2.0**31 * x)),
    np.float32: (24, lambda x: x),
    np.float64: (53, lambda x: x),
}


@pytest.mark.parametrize("kind", KINDS)
def test_samples_come_back_as_shares_of_full_scale(tmp_path: Path, kind) -> None:
    bits, stored = KINDS[kind]
    wavfile.write(tmp_path / "a.wav", 8000, np.stack([stored(X), stored(0.3 * X)], axis=1).astype(kind))
    assert is_wav(tmp_path / "a.wav")
    signal = read_wav(tmp_path / "a.wav", channel=2)
    np.testing.assert_allclose(signal.values, 0.3 * X, atol=2.0**-bits)
    assert (signal.sample_rate, signal.unit, signal.name) == (8000.0, "", "channel 2")
    assert signal.full_scale == (np.inf if np.dtype(kind).kind == "f" else 1.0)
    assert "channel 2 of 2" in signal.notes[0]


@pytest.mark.parametrize("width", [1, 2, 3, 4])
def test_extreme_samples_are_full_scale(tmp_path: Path, width: int) -> None:
    low = b"\0" if width == 1 else b"\0" * (width - 1) + b"\x80"
    high = b"\xff" if width == 1 else b"\xff" * (width - 1) + b"\x7f"
    with wave.open(str(tmp_path / "a.wav"), "wb") as sound:
        sound.setnchannels(1)
        sound.setsampwidth(width)
        sound.setframerate(1000)
        sound.writeframes(low + high)
    assert read_wav(tmp_path / "a.wav").values.tolist() == [-1.0, 1.0 - 2.0 ** (1 - 8 * width)]


@pytest.mark.parametrize("bits", [16, 24])
def test_what_trimmer_writes_comes_back_without_its_mean(tmp_path: Path, bits: int) -> None:
    written = write_wav(tmp_path / "a.wav", 3.0 + X, 8000.0, bits)
    back = read_wav(tmp_path / "a.wav").scaled(written.full_scale, "m")
    np.testing.assert_allclose(back.values + written.mean, 3.0 + X, atol=2.0 ** (2 - bits))


def test_a_part_of_a_file_is_read(tmp_path: Path) -> None:
    wavfile.write(tmp_path / "a.wav", 1000, np.arange(1000, dtype=np.int16))
    part = read_wav(tmp_path / "a.wav", begin=0.25, end=0.5)
    assert (part.start, part.values.size, part.values[0] * 2**15) == (0.25, 251, 250.0)
    with pytest.raises(SignalFileError, match="lasts 1 s, and holds no sample from 2 s"):
        read_wav(tmp_path / "a.wav", begin=2.0)


def test_what_cannot_be_read_is_told(tmp_path: Path) -> None:
    path = tmp_path / "a.wav"
    wavfile.write(path, 1000, np.zeros((100, 2), np.int16))
    whole = path.read_bytes()
    for channel, message in ((None, r"has 2 channels; choose one \(--channel 1 to 2\)"), (3, "no channel 3")):
        with pytest.raises(SignalFileError, match=message):
            read_wav(path, channel=channel)
    for content in (b"", b"RIFF", b"a,b\n1,2\n", whole[:30], whole[:20] + b"\x02" + whole[21:]):
        path.write_bytes(content)
        with pytest.raises(SignalFileError, match="cannot be read as a WAV file"):
            read_wav(path, channel=1)
    with pytest.raises(SignalFileError, match="no such file"):
        read_wav(tmp_path / "none.wav")
    with pytest.raises(SignalFileError, match="is a folder"):
        read_wav(tmp_path)
    wavfile.write(path, 1000, np.array([0.0, np.nan, 1.0]))
    with pytest.raises(SignalFileError, match="sample 2 is not finite"):
        read_wav(path)
    assert not is_wav(tmp_path / "none.wav")


def test_a_file_that_ends_early_is_read_and_told(tmp_path: Path) -> None:
    content = io.BytesIO()
    with wave.open(content, "wb") as sound:
        sound.setnchannels(1)
        sound.setsampwidth(3)
        sound.setframerate(1000)
        sound.writeframes(bytes(3000))
    (tmp_path / "a.wav").write_bytes(content.getvalue()[:2045])  # a whole number of samples
    signal = read_wav(tmp_path / "a.wav")
    assert signal.values.size == 667
    assert "Reached EOF prematurely" in signal.notes[1]


@pytest.mark.parametrize(
    ("begin", "end", "first", "last"),
    [
        (-1.0, 0.0, 0, 0),
        (0.0, np.inf, 0, 9),
        (0.001, 0.002, 1, 2),
        (0.0011, 0.0029, 2, 2),
        (0.0, 7.0, 0, 9),
        (0.009, np.inf, 9, 9),
        (0.003 + 1e-12, 0.004 - 1e-12, 3, 4),
    ],
)
def test_both_ends_of_a_part_are_included(tmp_path: Path, begin, end, first: int, last: int) -> None:
    wavfile.write(tmp_path / "a.wav", 1000, np.arange(10, dtype=np.int16))
    part = read_wav(tmp_path / "a.wav", begin=begin, end=end)
    np.testing.assert_array_equal(part.values * 2**15, np.arange(first, last + 1))
    assert part.start == first / 1000


@pytest.mark.parametrize(("begin", "end"), [(0.0, -0.001), (0.0091, np.inf), (0.0011, 0.0019), (-2.0, -1.0)])
def test_a_part_without_samples_is_refused(tmp_path: Path, begin: float, end: float) -> None:
    wavfile.write(tmp_path / "a.wav", 1000, np.arange(10, dtype=np.int16))
    with pytest.raises(SignalFileError, match="holds no sample"):
        read_wav(tmp_path / "a.wav", begin=begin, end=end)
