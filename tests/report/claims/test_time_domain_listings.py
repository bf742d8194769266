"""Listings A.7 and A.8 repeated, against python-control's backlash and the library's waveforms."""

import math

import control
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from report.numbers.listed_blocks import PERIOD, contact_time, friction_block, inertia_block
from report.numbers.thesis import DRIVE_AMPLITUDE, DRIVE_OMEGA, TIMED_GAP
from trimmer import InertiaBacklash

POSITIONS = st.lists(st.floats(-5, 5), min_size=1, max_size=40)


def run(positions, gap, load=0.0):
    outputs = []
    for pin in positions:
        load = friction_block(pin, gap, load)
        outputs.append(load)
    return outputs


@given(positions=POSITIONS, gap=st.floats(0.01, 4))
def test_for_any_input_the_block_does_what_python_control_does(positions, gap):
    library = control.friction_backlash_nonlinearity(gap)
    assert run(positions, gap) == [library(pin) for pin in positions]


def test_for_its_own_input_the_inertia_block_has_the_derived_waveform_but_for_the_rounded_constant():
    time = np.linspace(0, PERIOD, 2000, endpoint=False) + PERIOD / 7777
    pin = DRIVE_AMPLITUDE * np.sin(DRIVE_OMEGA * time)
    difference = inertia_block(pin, time) - InertiaBacklash(TIMED_GAP).waveform(
        DRIVE_OMEGA * time, DRIVE_AMPLITUDE
    )
    rounded = (time > PERIOD / 2) & (time < PERIOD / 2 + contact_time())
    offset = 0.0049 - (math.pi * DRIVE_AMPLITUDE + TIMED_GAP / 2)
    np.testing.assert_allclose(difference[rounded], offset, atol=1e-12)
    np.testing.assert_allclose(difference[~rounded], 0, atol=1e-12)


def test_the_contact_time_is_that_of_keplers_equation():
    angle = DRIVE_OMEGA * contact_time()
    assert angle - math.sin(angle) == pytest.approx(TIMED_GAP / DRIVE_AMPLITUDE, rel=1e-12)


def test_the_inertia_block_repeats_with_the_period():
    time = np.linspace(0, PERIOD, 50, endpoint=False) + PERIOD / 333
    pin = DRIVE_AMPLITUDE * np.sin(DRIVE_OMEGA * time)
    np.testing.assert_allclose(inertia_block(pin, time), inertia_block(pin, time + 3 * PERIOD), atol=1e-12)
