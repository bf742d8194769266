import dataclasses

import pytest

from trimmer import TrimmerParameters, modes, pin_model, resonance_peaks, summarise
from trimmer.linear import (
    UnsupportedSystemError,
    antiresonances,
    asymptotic_roll_off,
    bandwidth,
    bandwidth_crossings,
    encirclements,
    gain_crossings,
    real_axis_crossings,
)
from trimmer.thesis import Displacement, InputChannels, TrimmerBody

THESIS = TrimmerParameters.thesis()


@pytest.mark.parametrize("channels", InputChannels)
def test_the_summary_says_what_the_state_space_says(channels: InputChannels) -> None:
    summary = summarise(THESIS, channels=channels)
    system = pin_model(THESIS, channels=channels)
    assert summary.modes == modes(THESIS)
    assert summary.factored.static_gain == pytest.approx(system.dcgain(), rel=1e-12)
    assert summary.gain_crossings == pytest.approx(gain_crossings(system), rel=1e-9)
    assert summary.low_pass.bandwidth == pytest.approx(bandwidth(system), rel=1e-9)
    assert summary.low_pass.crossings == pytest.approx(bandwidth_crossings(system), rel=1e-9)
    assert summary.roll_off == pytest.approx(asymptotic_roll_off(system))
    assert summary.encirclements == encirclements(system)
    for found, expected in (
        (summary.real_axis_crossings, real_axis_crossings(system)),
        (summary.peaks, resonance_peaks(system)),
        (summary.antiresonances, antiresonances(system)),
    ):
        assert [item.omega for item in found] == pytest.approx([item.omega for item in expected], rel=1e-9)


def test_the_summary_follows_the_cutter_from_the_guard_by_both_channels_unless_told() -> None:
    summary = summarise(THESIS)
    assert (summary.output.label, summary.channels) == ("q2-q4", InputChannels.DISPLACEMENT_AND_VELOCITY)
    assert summarise(THESIS, "q3", "displacement").output == Displacement(TrimmerBody(3))


def test_a_pin_that_touches_nothing_is_an_error_and_what_there_is_not_is_none() -> None:
    with pytest.raises(UnsupportedSystemError, match="does not reach its output"):
        summarise(dataclasses.replace(THESIS, k2=0.0, c2=0.0))
    assert summarise(dataclasses.replace(THESIS, k2=0.0)).low_pass is None  # no gain at zero frequency
    undamped = dataclasses.replace(THESIS, c1=0.0, c2=0.0, c3=0.0, c4=0.0)
    assert summarise(undamped).encirclements is None  # its locus is the real axis


def test_a_free_trimmer_has_a_gain_at_zero_frequency() -> None:
    """Its rigid-body motion is a double pole at 0 that the pin, an inner force, does not excite."""
    free = dataclasses.replace(THESIS, k1=0.0, c1=0.0, k3=0.0, c3=0.0, k5=0.0)
    summary = summarise(free, Displacement(TrimmerBody.CUTTER, TrimmerBody.MOTOR))
    assert summary.factored.static_gain == pytest.approx(1.0, rel=1e-9)


def test_the_summary_shows_its_modes() -> None:
    summary = summarise(THESIS)
    frame = summary.to_dataframe()
    assert frame["eigenvalue"].tolist() == [mode.eigenvalue for mode in summary.modes]
    assert frame["frequency"].tolist() == [mode.frequency for mode in summary.modes]
    counts = f"{len(summary.modes)} modes, {len(summary.peaks)} peaks"
    assert f"output q2-q4, {counts}, roll-off {summary.roll_off:.4g} dB" in repr(summary)
