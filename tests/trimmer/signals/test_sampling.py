"""Time stamps as loggers write them: rounded, with gaps, with jitter, repeated, wrapped around."""

from collections.abc import Sequence

import numpy as np
import pytest

from tests.trimmer.signals.reading import message_for
from trimmer.signals import Gaps, Sampling, TimeStamps, read_recording, read_signal
from trimmer.signals.sampling import SPLINE_ERROR, resampled, trusted_band
from trimmer.signals.time_stamps import spacing_of

RESAMPLE = Sampling(TimeStamps.RESAMPLE, Gaps.SPLIT)
SPLIT = Sampling(gaps=Gaps.SPLIT)


def text(times: Sequence[float], digits: str = ".9g", values: Sequence[float] | None = None) -> str:
    values = np.sin(np.asarray(times)) if values is None else values
    return "t,y\n" + "".join(f"{t:{digits}},{v!r}\n" for t, v in zip(times, map(float, values), strict=True))


@pytest.mark.parametrize("rate", [350.0, 400.0, 950.0, 999.0, 3000.0, 44_100.0])
@pytest.mark.parametrize("rounding", [np.rint, np.floor])
def test_stamps_rounded_to_milliseconds_give_the_rate_within_what_is_told(rate: float, rounding) -> None:
    times = rounding(np.arange(4000) / rate * 1e3) / 1e3
    spacing = spacing_of(times, range(2, 4002), "file")
    assert (spacing.equal, spacing.begins, spacing.rounding) == (True, (0,), 1e-3)
    assert abs(spacing.rate / rate - 1) < spacing.rate_uncertainty < 0.02


def test_rounded_stamps_are_told_with_what_they_cannot_show(file) -> None:
    signal = read_signal(file(text(np.arange(10_000) / 44_100, ".3f")))
    (note,) = signal.notes
    assert "rounded to 0.001 s" in note
    assert "a gap of up to 44 samples would not be seen" in note
    exact = read_signal(file(text(np.arange(10_000) / 44_100, ".3f")), sample_rate=44_100.0)
    assert exact.sample_rate == 44_100.0


def test_missing_values_can_be_gaps(file) -> None:
    rows = [f"{k},{'' if 100 <= k < 150 else k % 7}" for k in range(400)]
    path = file("t [ms],y\n" + "\n".join(rows))
    assert "--missing gap" in message_for(path)
    recording = read_recording(path, missing="gap", sampling=SPLIT)
    assert [(s.start, s.values.size) for s in recording.stretches] == [(0.0, 100), (0.15, 250)]
    assert "1 gap" in message_for(path, missing="gap")
    without_stamps = file("y\n" + "\n".join(row.split(",")[1] or "nan" for row in rows))
    recording = read_recording(without_stamps, missing="gap", sample_rate=1000.0, sampling=SPLIT)
    assert [(s.start, s.values.size) for s in recording.stretches] == [(0.0, 100), (0.15, 250)]


def test_jitter_is_refused_with_its_size_or_resampled(file) -> None:
    rng = np.random.default_rng(1)
    times = np.arange(2000) / 1000 + rng.uniform(-2e-4, 2e-4, 2000)
    values = np.cos(2 * np.pi * 50 * times)
    path = file(text(times, ".9g", values))
    told = message_for(path)
    assert "stamps are 0.00012 s off" in told
    assert "--resample" in told and "--ignore-time" in told
    signal = read_signal(path, sampling=RESAMPLE)
    assert np.abs(signal.values - np.cos(2 * np.pi * 50 * signal.times))[20:-20].max() < 0.01
    assert 100 < signal.trusted.highest < 120
    assert "cubic spline" in signal.notes[-1]
    assert "--rate" not in message_for(path, sample_rate=500.0, sampling=RESAMPLE)
    faster = read_signal(path, sample_rate=4000.0, sampling=RESAMPLE)
    assert np.abs(faster.values - np.cos(2 * np.pi * 50 * faster.times))[80:-80].max() < 0.01


def test_no_gap_is_bridged_by_resampling(file) -> None:
    rng = np.random.default_rng(2)
    times = (np.arange(3000) / 1000 + rng.uniform(-2e-4, 2e-4, 3000))[np.r_[0:1000, 1100:3000]]
    path = file(text(times))
    with pytest.raises(ValueError, match="1 gap in the time stamps"):
        read_signal(path, sampling=Sampling(TimeStamps.RESAMPLE))
    recording = read_recording(path, sampling=RESAMPLE)
    assert len(recording.stretches) == 2
    assert recording.stretches[0].times[-1] <= times[999]
    assert recording.stretches[1].start == pytest.approx(times[1000])


@pytest.mark.parametrize(
    ("times", "message"),
    [
        (np.r_[0:50, 0:50] / 1000, ", line 52: time stamp 0 s does not come after 0.049 s of line 51"),
        (np.arange(100) * 1000 % 65_536 * 1e-6, ", line 68: .* a counter that wraps around"),
        (np.r_[0:50, 48:90] / 1000, ", line 52: time stamp 0.048 s .*; write stamps with more digits"),
        (np.r_[0:50, 49:90] / 1000, ", line 52: time stamp 0.049 s does not come after 0.049 s of line 51"),
    ],
)
def test_stamps_that_do_not_rise_are_refused_in_a_sentence(file, times, message: str) -> None:
    path = file(text(times))
    with pytest.raises(ValueError, match=message):
        read_signal(path)
    ignored = read_signal(path, sample_rate=1000.0, sampling=Sampling(TimeStamps.IGNORE))
    assert ignored.values.size == times.size
    assert "time stamps are left aside" in ignored.notes[0]
    assert message_for(path, sampling=Sampling("ignore")) == ": no sample rate; give it (--rate)"


@pytest.mark.parametrize("seed", range(5))
def test_lines_in_the_trusted_band_are_as_exact_as_it_says(seed: int) -> None:
    rng = np.random.default_rng(seed)
    times = np.cumsum(rng.uniform(0.4e-3, 1.6e-3, 2000))
    band = trusted_band(times)
    for share in (0.3, 1.0):
        frequency, phase = share * band.highest, rng.uniform(0, 6)
        made = resampled(times, np.cos(2 * np.pi * frequency * times + phase), 1000.0)
        at = times[0] + np.arange(made.size) / 1000.0
        inside = slice(20, -20)
        error = np.abs(made - np.cos(2 * np.pi * frequency * at + phase))[inside].max()
        assert error < SPLINE_ERROR * share**4
    beyond = 3 * band.highest
    made = resampled(times, np.cos(2 * np.pi * beyond * times), 1000.0)
    at = times[0] + np.arange(made.size) / 1000.0
    assert np.abs(made - np.cos(2 * np.pi * beyond * at))[20:-20].max() > SPLINE_ERROR
