"""Designs that several tests look at, each read and solved once."""

from __future__ import annotations

import pytest

from trimmer import respond
from trimmer.design import DesignFile, FoundMotion
from trimmer.design.design_file import design_file_of_text
from trimmer.design.found_motion import of_settled
from trimmer.examples import example_text


@pytest.fixture(scope="session")
def trimmer_file() -> DesignFile:
    """The trimmer with play."""
    return design_file_of_text(example_text("thesis-play"), "thesis-play.toml")


@pytest.fixture(scope="session")
def trimmer_motion(trimmer_file: DesignFile) -> FoundMotion:
    """What it settles to."""
    motion = of_settled(respond(trimmer_file.mechanism).motion)
    assert motion is not None
    return motion


@pytest.fixture(scope="session")
def linear_file() -> DesignFile:
    """The linear trimmer."""
    return design_file_of_text(example_text("thesis"), "thesis.toml")


@pytest.fixture(scope="session")
def linear_motion(linear_file: DesignFile) -> FoundMotion:
    """What it settles to."""
    motion = of_settled(respond(linear_file.mechanism).motion)
    assert motion is not None
    return motion
