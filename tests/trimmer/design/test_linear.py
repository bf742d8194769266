"""Modes and transfer functions against the modes of the thesis's trimmer, SciPy, and exact orbits."""

from __future__ import annotations

import numpy as np
import pytest
import scipy.linalg

from trimmer import TrimmerParameters, modes
from trimmer.design import DesignFile, FoundMotion
from trimmer.design.linear import linear_states
from trimmer.mechanism import Contacts, linear_matrices


def test_the_linear_trimmer_has_the_modes_of_its_other_model(linear_file: DesignFile) -> None:
    (state,) = linear_states(linear_file.mechanism)
    expected = modes(TrimmerParameters.thesis())
    assert [mode.frequency for mode in state.modes] == pytest.approx([mode.frequency for mode in expected])
    assert [mode.damping_ratio for mode in state.modes] == pytest.approx(
        [each.damping_ratio for each in expected]
    )


def test_closed_contacts_are_links_and_open_ones_are_nothing(
    trimmer_file: DesignFile, linear_file: DesignFile
) -> None:
    closed, opened = linear_states(trimmer_file.mechanism)
    assert (closed.contacts, opened.contacts) == (Contacts.CLOSED, Contacts.OPEN)
    (linked,) = linear_states(linear_file.mechanism)
    for mode, expected in zip(closed.modes, linked.modes, strict=True):
        assert mode.frequency == pytest.approx(expected.frequency)
        assert mode.shape == pytest.approx(expected.shape)
    matrices = linear_matrices(trimmer_file.mechanism)
    squares = scipy.linalg.eigvalsh(matrices.stiffness, matrices.mass)
    undamped = [mode.frequency / np.sqrt(1 - mode.damping_ratio**2) for mode in opened.modes]
    assert undamped == pytest.approx((np.sqrt(squares) / (2 * np.pi)).tolist(), rel=1e-3)


def test_the_transfer_function_is_what_the_exact_motion_does(
    linear_file: DesignFile, linear_motion: FoundMotion
) -> None:
    (state,) = linear_states(linear_file.mechanism)
    (transfer,) = state.transfer
    stroke = linear_motion.outputs["stroke"].harmonics[0]
    assert transfer.at_drive is not None
    assert 1.5e-3 * abs(transfer.at_drive) == pytest.approx(stroke, rel=1e-9)
