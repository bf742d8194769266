"""Kinds of motion, with the words of the JSON and of legends."""

from __future__ import annotations

from trimmer.choices import Choice


class MotionKind(Choice):
    """What a motion is after the waiting time, as far as the numbers carry it.

    The value says it in plain words. A motion that is none of the first three is undecided, which is no
    error.
    """

    PERIODIC = "periodic"
    TORUS = "torus"
    CHAOTIC = "chaotic"
    UNDECIDED = "not settled"
    FAILED = "failed"
