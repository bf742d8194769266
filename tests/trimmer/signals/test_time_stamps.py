from __future__ import annotations

import pytest

from tests.trimmer.signals.reading import message_for
from trimmer.signals.read import read_signal
from trimmer.signals.signal import SignalError


@pytest.mark.parametrize(
    ("stamps", "message"),
    [
        ([0.0], ": one time stamp gives no sample rate"),
        ([0.0, 0.1, 0.1, 0.3], ", line 4: time stamp 0.1 s does not come after 0.1 s of line 3"),
        ([0.0, 0.1, 0.0, 0.1], ", line 4: time stamp 0 s does not come after 0.1 s of line 3"),
        (
            [0.0, 0.1, 0.2, 0.4, 0.5],
            ", line 5: time stamps are not at equal distances: this one comes 0.2 s after",
        ),
        ([0.0, 0.1, 0.206, 0.3], ", line 4: time stamps are not at equal distances"),
        ([0.0, "", 0.2], ", line 3: the time stamp is missing"),
        (["10:00:01", "10:00:02"], ", line 2: '10:00:01' is not a number"),
    ],
)
def test_time_stamps_that_are_not_uniform_are_reported_with_their_line(file, stamps, message: str) -> None:
    content = "t,y\n" + "".join(f"{stamp},1.0\n" for stamp in stamps)
    assert message_for(file(content)).startswith(message)


def test_time_stamps_may_be_rounded_by_a_twentieth_of_the_interval(file) -> None:
    content = "t,y\n" + "".join(f"{round(k / 30_000, 6)},1.0\n" for k in range(1000))
    assert read_signal(file(content)).sample_rate == pytest.approx(30_000, rel=1e-4)


def test_an_unknown_unit_of_time_is_reported(file) -> None:
    assert "time stamps in 'min' are not known; known units: s" in message_for(file("t [min],y\n0,1\n1,2\n"))


def test_a_rate_must_agree_with_the_time_stamps(file) -> None:
    path = file("t,y\n0,1\n0.1,2\n0.2,3\n")
    assert read_signal(path, sample_rate=10.009).sample_rate == 10.009
    assert message_for(path, sample_rate=10.011).startswith(
        ": the time stamps are those of 10 Hz, not of 10.011"
    )
    with pytest.raises(SignalError, match="must be a positive number of hertz"):
        read_signal(path, sample_rate=0)


def test_without_rate_and_time_stamps_it_says_what_to_give(file) -> None:
    error = message_for(file("y\n1\n2\n"))
    assert error == ": no sample rate; give it (--rate), or name the column of time stamps (--time)"


def test_a_file_without_heading_can_have_its_time_stamps_numbered(file) -> None:
    signal = read_signal(file("0.0;1\n0.5;2\n"), time_column=1)
    assert (signal.sample_rate, signal.name, signal.values.tolist()) == (2.0, "column 2", [1.0, 2.0])
