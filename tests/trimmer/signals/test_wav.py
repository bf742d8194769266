from __future__ import annotations

import itertools
import wave
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays
from scipy.io import wavfile

from trimmer.files import FileWriteError
from trimmer.signals import wav
from trimmer.signals.signal import SignalError
from trimmer.signals.wav import SUITED_RATES, BitDepth, write_wav
from trimmer.spectra.peaks import peaks
from trimmer.spectra.spectrum import amplitude_spectrum


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


def test_a_rounded_ratio_of_rates_changes_the_pitch_as_returned(tmp_path: Path, monkeypatch) -> None:
    monkeypatch.setattr(wav, "_LARGEST_FACTOR", 10)  # 10/9 for 22050/20000
    times = np.arange(20_000) / 20_000
    written = write_wav(tmp_path / "a.wav", np.sin(2 * np.pi * 733.6 * times), 20_000)
    assert written.pitch_error == pytest.approx(1.1025 * 0.9 - 1, rel=1e-12)
    rate, samples, _ = samples_of(tmp_path / "a.wav")
    (found,) = peaks(amplitude_spectrum(samples, rate), limit=1)
    assert found.frequency == pytest.approx(733.6 * (1 + written.pitch_error), rel=1e-6)


def test_what_lies_above_half_the_new_rate_is_not_heard(tmp_path: Path) -> None:
    times = np.arange(20_000) / 200_000
    low, high = np.sin(2 * np.pi * 1000 * times), np.sin(2 * np.pi * 40_000 * times)
    write_wav(tmp_path / "a.wav", low + high, 200_000)
    rate, samples, _ = samples_of(tmp_path / "a.wav")
    spectrum = amplitude_spectrum(samples, rate)
    mirrored = np.abs(spectrum.frequency - 8000) < 100  # 48 - 40 kHz, where it would show
    assert rate == 48_000
    assert spectrum.amplitude[mirrored].max() < 1e-3 * spectrum.amplitude.max()


@pytest.mark.parametrize("rate", SUITED_RATES)
def test_a_suited_rate_is_kept(tmp_path: Path, rate: int) -> None:
    written = write_wav(tmp_path / "a.wav", np.arange(2000.0), rate)
    assert (written.sample_rate, written.samples, written.pitch_error) == (rate, 2000, 0.0)


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


@pytest.mark.parametrize(
    ("samples", "rate", "bits", "fits"),
    [
        (1000, 8000, 16, True),
        (1001, 8000, 16, False),
        (667, 8000, 24, False),
        (666, 8000, 24, True),
        (907, 20_000, 16, True),
        (908, 20_000, 16, False),
    ],
)
def test_a_file_has_room_for_so_many_bytes(
    tmp_path: Path, monkeypatch, samples, rate, bits, fits: bool
) -> None:
    assert wav._LARGEST_DATA == 2**32 - 64
    monkeypatch.setattr(wav, "_LARGEST_DATA", 2000)
    if fits:
        assert write_wav(tmp_path / "a.wav", np.arange(float(samples)), rate, bits).samples <= 1000
    else:
        with pytest.raises(SignalError, match="more than 4 GiB"):
            write_wav(tmp_path / "a.wav", np.arange(float(samples)), rate, bits)


def test_rates_that_sound_devices_play() -> None:
    usual = (8000, 11025, 12000, 16000, 22050, 24000, 32000, 44100, 48000)
    for low, high in itertools.pairwise(usual):
        assert (wav._suited(low), wav._suited(low + 0.5), wav._suited(high - 0.5)) == (low, high, high)
    for rate in (88200, 96000, 176400, 192000):
        assert (wav._suited(rate), wav._suited(rate + 1), wav._suited(rate - 1)) == (rate, 48000, 48000)
    assert wav._suited(1.0) == 8000


def test_ratios_of_rates_have_denominators_that_are_not_large() -> None:
    assert wav._simple(Fraction(441, 480)) == Fraction(147, 160)
    assert wav._simple(Fraction(480, 441)) == Fraction(160, 147)
    assert wav._simple(Fraction(1, 2) + Fraction(1, 10**9)) == Fraction(1, 2)
    assert wav._simple(Fraction(7, 100_003)) == Fraction(1, 14286)
    # Where a whole number is needed that is larger than that, it is the next one.
    assert wav._simple(Fraction(2, 120_001)) == Fraction(1, 60_001)
    assert wav._simple(Fraction(120_001, 2)) == 60_001
    vibration = np.array([1.0, -1.0, 0.5])
    assert wav._resampled(vibration, Fraction(1)) is vibration
    assert wav._resampled(vibration, Fraction(2)).size == 6
    assert wav._resampled(np.ones(6), Fraction(1, 3)).size == 2


def test_a_folder_is_refused(tmp_path: Path) -> None:
    with pytest.raises(FileWriteError, match="is a folder"):
        write_wav(tmp_path, np.zeros(500), 20_000)


def test_a_sound_is_long_and_fast_enough_at_the_very_limit() -> None:
    wav._check_audible(10, 1000.0)
    wav._check_audible(100, 40.0)
    for samples, rate in ((9, 1000.0), (100, 39.9)):
        with pytest.raises(SignalError):
            wav._check_audible(samples, rate)


def test_a_mean_is_taken_off_before_samples_could_be_too_large() -> None:
    scale, mean, vibration = wav._without_mean(np.array([1.0, -4.0, 2.0, 3.0]))
    assert (scale, mean) == (4.0, 0.5)
    np.testing.assert_allclose(vibration, [0.125, -1.125, 0.375, 0.625])
    scale, mean, vibration = wav._without_mean(np.zeros(3))
    assert (scale, mean, vibration.tolist()) == (1.0, 0.0, [0.0, 0.0, 0.0])
