"""How fast things happen beside the period that is counted: slowly, where that is only a sample."""

from __future__ import annotations

from trimmer.motion.flow import Flow

SAMPLES = 16
"""Samples in which a sampled machine does as much as another one in a period of its drive."""


def pace_of(flow: Flow) -> int:
    """Return in how many drive periods as much happens as in one: many, if they are samples alone."""
    system = flow.modes.system
    return SAMPLES if system.clockwork is not None and not len(system.layout.orders) else 1
