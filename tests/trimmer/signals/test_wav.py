import itertools
import wave
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays
from scipy.io import wavfile

from trimmer import peaks
from trimmer.files import FileWriteError
from trimmer.signals import BitDepth, SignalError, write_wav
from trimmer.spectra import amplitude_spectrum


def samples_of(path: Path) -> tuple[int, np.ndarray, BitDepth]:
    """Read a WAV file with SciPy; it gives 24-bit samples in the upper bytes of 32."""
    rate, samples = wavfile.read(path)
    if samples.dtype == np.int16:
        return rate, samples.astype(int), BitDepth.SIXTEEN
    assert samples.dtype == np.int32
    return rate, samples.astype(int) >> 8, BitDepth.TWENTY_FOUR


@pytest.mark.parametrize("bit_depth", BitDepth)
def test_the_returned_scale_gives_the_signal_back(tmp_path: Path, bit_depth: BitDepth) -> None:
    signal = 2e-5 + 1e-4 * np.sin(np.arange(1000) / 7.0)
    written = write_wav(tmp_path / "a.wav", signal, 44100, bit_depth)
    rate, samples, depth = samples_of(tmp_path / "a.wav")
    assert (rate, depth, samples.size) == (44100, bit_depth, 1000)
    assert (written.sample_rate, written.samples, written.bit_depth) == (44100, 1000, bit_depth)
    back = written.mean + written.full_scale * samples / bit_depth.full_scale
    assert np.abs(back - signal).max() <= 0.51 * written.full_scale / bit_depth.full_scale
    assert written.mean == pytest.approx(signal.mean(), rel=1e-12)


@pytest.mark.parametrize("bit_depth", BitDepth)
@pytest.mark.parametrize("peak", [0.9, 1.0, 1e-3])
@settings(max_examples=12)
@given(values=arrays(np.float64, st.integers(80, 100), elements=st.floats(-1e300, 1e300)))
def test_nothing_is_clipped(tmp_path_factory, values, peak: float, bit_depth: BitDepth) -> None:
    path = tmp_path_factory.getbasetemp() / "clipped.wav"
    write_wav(path, values, 8000, bit_depth, peak)
    _, samples, _ = samples_of(path)
    loudest = np.abs(samples).max()
    assert bit_depth.full_scale == {16: 32_767, 24: 8_388_607}[bit_depth.value]
    assert loudest <= bit_depth.full_scale
    constant = np.all(values == values[0])
    assert loudest == (0 if constant else round(peak * bit_depth.full_scale))


@pytest.mark.parametrize(
    ("rate", "wav_rate"),
    [(20_000, 22_050), (10_002_300, 48_000), (5000, 8000), (50_000, 48_000), (20_000.123, 22_050)],
)
def test_resampling_keeps_pitch_and_amplitude(tmp_path: Path, rate: float, wav_rate: int) -> None:
    duration, frequency, amplitude = 0.5 if rate < 1e6 else 0.05, 733.6, 3e-5
    times = np.arange(int(duration * rate)) / rate
    written = write_wav(tmp_path / "a.wav", amplitude * np.sin(2 * np.pi * frequency * times), rate)
    assert written.sample_rate == wav_rate
    assert abs(written.pitch_error) < 1e-6
    heard_rate, samples, _ = samples_of(tmp_path / "a.wav")
    heard = samples * (written.full_scale / BitDepth.SIXTEEN.full_scale)
    (found,) = peaks(amplitude_spectrum(heard, heard_rate), limit=1)
    assert found.frequency == pytest.approx(frequency, rel=1e-4)
    assert found.amplitude == pytest.approx(amplitude, rel=2e-3)


def test_what_lies_above_half_the_new_rate_is_not_heard(tmp_path: Path) -> None:
    times = np.arange(20_000) / 200_000
    low, high = np.sin(2 * np.pi * 1000 * times), np.sin(2 * np.pi * 40_000 * times)
    write_wav(tmp_path / "a.wav", low + high, 200_000)
    rate, samples, _ = samples_of(tmp_path / "a.wav")
    spectrum = amplitude_spectrum(samples, rate)
    mirrored = np.abs(spectrum.frequency - 8000) < 100  # 48 - 40 kHz, where it would show
    assert rate == 48_000
    assert spectrum.amplitude[mirrored].max() < 1e-3 * spectrum.amplitude.max()


def test_a_constant_signal_is_silence(tmp_path: Path) -> None:
    written = write_wav(tmp_path / "a.wav", np.full(500, 0.1), 20_000)
    assert not samples_of(tmp_path / "a.wav")[1].any()
    assert (written.mean, written.full_scale) == (pytest.approx(0.1), 0.0)


def test_the_same_signal_is_the_same_bytes(tmp_path: Path) -> None:
    for name in ("a.wav", "b.wav"):
        write_wav(tmp_path / name, np.sin(np.arange(999.0)), 20_000)
    assert (tmp_path / "a.wav").read_bytes() == (tmp_path / "b.wav").read_bytes()
    with wave.open(str(tmp_path / "a.wav")) as file:
        assert (file.getnchannels(), file.getsampwidth()) == (1, 2)


@pytest.mark.parametrize(
    ("signal", "rate", "peak", "message"),
    [
        (np.zeros(500), 20_000, 0.0, "peak is 0.0: it must be above 0 and at most 1"),
        (np.zeros(500), 20_000, 1.1, "peak is 1.1"),
        (np.zeros(500), 20_000, np.nan, "peak is nan"),
        (np.zeros(500), 0, 0.9, "sample rate must be a positive number"),
        ([np.nan], 20_000, 0.9, "not finite"),
        (np.zeros(10), 20_000, 0.9, "10 samples at 20000 Hz last 0.0005 s; a sound needs 0.01 s"),
        (np.zeros(500), 30, 0.9, "hold no frequency above 15 Hz; below 20 Hz nothing can be heard"),
    ],
)
def test_what_cannot_be_heard_or_written_is_refused(tmp_path: Path, signal, rate, peak, message: str) -> None:
    with pytest.raises(SignalError, match=message):
        write_wav(tmp_path / "a.wav", signal, rate, peak=peak)
    assert list(tmp_path.iterdir()) == []


def test_a_folder_is_refused(tmp_path: Path) -> None:
    with pytest.raises(FileWriteError, match="is a folder"):
        write_wav(tmp_path, np.zeros(500), 20_000)


def test_the_next_rate_that_sound_devices_play_is_taken(tmp_path: Path) -> None:
    usual = (8000, 11025, 12000, 16000, 22050, 24000, 32000, 44100, 48000)
    kept = (*usual, 88200, 96000, 176400, 192000)
    cases = {rate: rate for rate in kept} | {40.0: 8000, 1e5: 48000, 88201.0: 48000, 191999.0: 48000}
    cases |= {low + 1.0: high for low, high in itertools.pairwise(usual)}
    for rate, wav_rate in cases.items():
        written = write_wav(tmp_path / "a.wav", np.arange(2000.0), rate)
        assert written.sample_rate == wav_rate
        assert abs(written.pitch_error) < (1e-300 if wav_rate == rate else 1.1e-5)
    # A sound of just 10 ms is one, also with a rate that is no ratio of whole numbers.
    assert write_wav(tmp_path / "a.wav", np.arange(10.0), 1000.0).samples == 80
    odd = write_wav(tmp_path / "a.wav", np.arange(2000.0), 1e4 * np.pi)
    assert (odd.sample_rate, odd.samples) == (32000, 2038)
    assert 0 < abs(odd.pitch_error) < 1e-9


@pytest.mark.parametrize("bits", BitDepth)
def test_more_than_4_gib_are_refused_before_the_work(tmp_path: Path, bits: BitDepth) -> None:
    samples = (2**32 - 64) // (200 * bits.value // 8) + 1  # 40 Hz become 8000 Hz
    with pytest.raises(SignalError, match=f"{samples} samples at 40 Hz make a WAV file of more than 4 GiB"):
        write_wav(tmp_path / "a.wav", np.zeros(samples), 40.0, bits)


def test_a_rounded_ratio_of_rates_changes_the_pitch_as_returned(tmp_path: Path) -> None:
    """47999.6 to 48000 Hz is a ratio of no whole numbers below 50000: the samples are played as they are."""
    rate = 47999.6
    sine = np.sin(2 * np.pi * 733.6 * np.arange(48_000) / rate)
    written = write_wav(tmp_path / "a.wav", sine, rate, 24)
    assert written.pitch_error == pytest.approx(48000 / rate - 1, rel=1e-9)
    played, samples, _ = samples_of(tmp_path / "a.wav")
    (found,) = peaks(amplitude_spectrum(samples, played), limit=1)
    assert found.frequency / 733.6 - 1 == pytest.approx(written.pitch_error, rel=1e-3)
