"""Time stamps in files: rates, gaps, rounding and scatter, told to the digit; at each limit."""

from collections.abc import Callable, Sequence
from pathlib import Path

import numpy as np
import pytest

from tests.trimmer.signals.reading import message_for
from trimmer.signals import Sampling, read_recording, read_signal

SPLIT = Sampling(gaps="split")
RESAMPLE = Sampling("resample", "split")
ROUNDED = np.floor(np.arange(200) * 1.25)
HOLES = np.delete(np.arange(100), [25, 50, 75])
"""Three samples of a hundred are missing, evenly: a lower rate with rounded stamps would explain them."""


@pytest.fixture
def stamped(file: Callable[[str], Path]) -> Callable[..., Path]:
    """Write stamps, s, with the values 0, 1, 4, ..., which never repeat."""

    def write(times: Sequence[float], values: Sequence[float] | None = None) -> Path:
        values = np.arange(len(times)) ** 2 if values is None else values
        rows = zip(map(float, times), map(float, values), strict=True)
        return file("t,y\n" + "".join(f"{time!r},{value!r}\n" for time, value in rows))

    return write


@pytest.mark.parametrize(
    ("times", "begins", "rate", "rel"),
    [
        (3.0 + np.arange(50) / 691.0, (), 691.0, 0.0),
        (0.25 + np.arange(200) / 123.456789012345, (), 123.456789012345, 0.0),
        (np.arange(7) * 0.3, (), 10 / 3, 1e-14),
        (np.delete(np.arange(60) * 0.25, [10, 11, 40]), (10, 38), 4.0, 0.0),
        (np.concatenate([np.arange(30), np.arange(40, 70)]) * 0.3, (30,), 3.3333333333333, 0.0),
        (np.concatenate([HOLES, 500 + HOLES]) / 1e3, (25, 49, 73, 97, 122, 146, 170), 1000.0, 0.0),
        # Every fifth one is missing of 800 Hz in milliseconds: these are rounded, and only 3 ms are a gap.
        (np.concatenate([ROUNDED, ROUNDED[-1] + 3 + ROUNDED]) / 1e3, (200,), 800.0, 2e-3),
        (np.concatenate([ROUNDED, ROUNDED[-1] + 2 + ROUNDED]) / 1e3, (), 800.0, 4e-3),
        (np.round(np.delete(np.arange(400) / 40.0, range(100, 120)), 2), (100,), 40.0, 1e-4),
        (np.round(np.delete(np.arange(400) * 0.0205, range(100, 120)), 2), (100,), 1 / 0.0205, 1e-3),
        (np.floor(np.arange(90) / 3.0), (), 3.0, 0.02),
        (np.array([0.0, 1.0, 2.0, 10.0, 11.0, 12.0]), (3,), 1.0, 0.0),
    ],
)
def test_rate_and_gaps_follow_from_stamps(stamped, times, begins, rate: float, rel: float) -> None:
    recording = read_recording(stamped(times), sampling=SPLIT)
    found = recording.stretches[0].sample_rate
    assert found == pytest.approx(rate, rel=rel, abs=0.0)
    assert {part.sample_rate for part in recording.stretches} == {found}
    assert [part.start for part in recording.stretches] == [times[place] for place in (0, *begins)]
    assert [part.values[0] for part in recording.stretches] == [place**2 for place in (0, *begins)]
    told = [(gap.begin, gap.end, gap.line) for gap in recording.gaps]
    assert told == [(times[place - 1], times[place], place + 2) for place in begins]
    missing = [max(1, round((gap.end - gap.begin) * found) - 1) for gap in recording.gaps]
    assert [gap.missing for gap in recording.gaps] == missing


@pytest.mark.parametrize(("late", "equal"), [(0.049, True), (0.051, False), (-0.049, True), (-0.051, False)])
def test_a_stamp_may_be_off_by_a_twentieth_of_the_distance(stamped, late: float, equal: bool) -> None:
    times = np.arange(21) * 4e-5
    times[7] += late * 4e-5
    path = stamped(times)
    if equal:
        assert read_signal(path).sample_rate == pytest.approx(25_000, rel=1e-12)
        return
    jitter = abs(late) * 4e-5 * np.sqrt(20) / 21
    told = message_for(path)
    assert told.startswith(", line 9: time stamps are not at equal distances: this one comes")
    assert f"where 4e-05 s is usual; stamps are {jitter:.2g} s off (standard deviation)" in told


@pytest.mark.parametrize(
    ("pattern", "longest"), [((0.9, 1.0, 1.1), 1.0 + 6.0 * 1.4826 * 0.1), ((1.0, 1.0, 1.0, 0.8, 1.2), 1.5)]
)
def test_a_gap_among_unequal_distances_is_longer_than_their_scatter(stamped, pattern, longest: float) -> None:
    for length, begins in ((longest - 0.02, [0]), (longest + 0.02, [0, 61])):
        steps = np.concatenate([np.resize(pattern, 60), [length], np.resize(pattern, 60)])
        times = np.concatenate([[0.0], np.cumsum(steps)]) * 0.0123456789
        recording = read_recording(stamped(times), sampling=RESAMPLE)
        assert [part.start for part in recording.stretches] == times[begins].tolist()
        assert recording.stretches[0].sample_rate == pytest.approx(81.0, rel=2e-2)


@pytest.mark.parametrize(
    ("times", "digit"),
    [
        (np.arange(60) // 3 * 1.0, "1"),
        (1.7e9 + np.round(np.arange(300) / 300.0, 2), "0.01"),
        (np.round(np.arange(300) / 300.0, 2), "0.01"),
        (np.floor(np.arange(300) * 3.5) * 1e-9, "1e-09"),
        ((100.0 + np.arange(300) / 44_100).astype(np.float32).astype(float), "7.63e-06"),
    ],
)
def test_the_last_digit_of_stamps_is_told_where_it_is_coarse(stamped, times, digit: str) -> None:
    (note,) = read_signal(stamped(times)).notes
    rate = 1 / np.polyfit(np.arange(times.size), times - times[0], 1)[0]
    uncertainty = 100 * float(digit) / np.ptp(times)
    assert note.startswith(f"time stamps are rounded to {digit} s, where samples are {1 / rate:.4g} s apart")
    assert f"to {uncertainty:.2g} %" in note or digit == "7.63e-06"


def test_few_coarse_stamps_and_nanoseconds_are_not_rounded_ones(stamped) -> None:
    assert "line 3: time stamp 0 s does not come after 0 s" in message_for(stamped(np.arange(57) // 3))
    steps = np.resize([1.0, 1.0, 1.0, 3.0, 0.5], 100)
    times = np.concatenate([[0.0], np.cumsum(steps)]) * 1e-9
    assert "time stamps are not at equal distances" in message_for(stamped(times))
    assert "line 3: time stamp 5 s does not come after 5 s" in message_for(stamped([5.0, 5.0, 5.0]))
    assert "a counter that wraps" in message_for(stamped([5.0, 15.0, 9.0, 16.0]))
    assert "; write stamps with more digits" in message_for(stamped([5.0, 15.0, 9.9, 16.0]))


def test_a_rate_that_is_given_agrees_as_far_as_stamps_tell(stamped) -> None:
    path = stamped(np.arange(1000) / 1000.0)
    for given in (999.0, 1001.0):
        assert read_signal(path, sample_rate=given).sample_rate == given
    for given in (998.9, 1001.1):
        assert f"those of 1000 Hz, not of {given} Hz" in message_for(path, sample_rate=given)
    rounded = stamped(np.round(np.arange(300) / 300.0, 2))
    assert read_signal(rounded, sample_rate=302.0).sample_rate == 302.0


def test_resampling_keeps_the_rate_of_the_samples_or_takes_a_higher_one(stamped) -> None:
    times = np.cumsum(np.resize([0.9e-3, 1.1e-3, 0.95e-3, 1.05e-3], 400))
    path = stamped(times)
    assert read_signal(path, sampling=RESAMPLE).sample_rate == pytest.approx(1000, rel=1e-3)
    for given in (999.5, 4000.0):
        assert read_signal(path, sample_rate=given, sampling=RESAMPLE).sample_rate == given
    for steps in (401, 403, 409):  # the last sample is kept, wherever rounding puts its time
        fitting = steps / (times[-1] - times[0])
        assert read_signal(path, sample_rate=fitting, sampling=RESAMPLE).values.size == steps + 1
    assert "900 Hz is less than the 999.749 samples" in message_for(
        path, sample_rate=900.0, sampling=RESAMPLE
    )


def test_a_cubic_comes_back_from_unequal_steps_and_faults_are_told_before(stamped) -> None:
    times = np.concatenate([np.cumsum(np.resize([0.8, 1.2, 1.1, 0.9], 40)), [80.0, 81.2, 82.0]])
    signal = read_signal(stamped(times, times**3 - 2.0 * times), sample_rate=4.0, sampling=RESAMPLE)
    np.testing.assert_allclose(signal.values, signal.times**3 - 2.0 * signal.times, rtol=1e-9, atol=1e-6)
    told = " ".join(signal.notes)
    assert "1 stretches of fewer than 4 samples are left out" in told
    assert "40 samples at unequal distances (0.8 to 1.2 s) are resampled at 4 Hz" in told
    assert signal.trusted.highest == pytest.approx((0.01 * 384 / 5) ** 0.25 / (2 * np.pi * 1.2))
    assert "no stretch has the 4 samples" in message_for(stamped([30.0, 31.2, 32.0]), sampling=RESAMPLE)
    clipped = np.clip(np.sin(0.7 * times), -0.5, 0.5)
    assert any("clipped" in note for note in read_signal(stamped(times, clipped), sampling=RESAMPLE).notes)


@pytest.mark.parametrize(("same", "left"), [(1, 1), (2, 2), (3, None)])
def test_rows_that_repeat_are_left_out_up_to_half_of_the_steps(stamped, same: int, left: int | None) -> None:
    times = np.cumsum([0.0, *[0.0] * same, *[1.0] * (4 - same)])
    path = stamped(times, np.ones(5))
    if left is None:
        assert "does not come after" in message_for(path, sampling=RESAMPLE)
    else:
        signal = read_signal(path, sampling=RESAMPLE)
        assert (signal.values.size, signal.sample_rate) == (5 - left, 1.0)
        assert signal.notes[0].endswith(f"and its time stamp: {left}")


def test_many_gaps_are_told_by_the_first_three_and_parts_are_taken_by_time(stamped) -> None:
    path = stamped(np.delete(np.arange(80.0), [7, 17, 27, 28, 40]))
    told = message_for(path)
    assert (
        "4 gaps in the time stamps: gap of 2 s after 6 s (line 9), about 1 sample; gap of 2 s after" in told
    )
    assert "gap of 3 s after 26 s (line 27), about 2 samples; ...: use the stretches" in told
    recording = read_recording(path, sampling=SPLIT)
    assert repr(recording) == "<Recording: y, 5 stretches, 4 gaps, 75 samples>"
    assert recording.longest.start == 41.0
    part = recording.between(5.0, 19.0)
    assert [(each.start, each.values.size) for each in part.stretches] == [(5.0, 2), (8.0, 9), (18.0, 2)]
    assert part.gaps == recording.gaps
    assert [each.start for each in recording.between(end=9.0).stretches] == [0.0, 8.0]
    assert [each.start for each in recording.between(30.0).stretches] == [30.0, 41.0]
    with pytest.raises(ValueError, match="no sample lies"):
        recording.between(27.2, 28.8)
