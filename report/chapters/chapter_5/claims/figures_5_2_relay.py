"""Claims on the figures of section 5.2.4 that show simulations of a relay and of friction: 5.19 and 5.20."""

from __future__ import annotations

import math

import numpy as np

from report.chapters.chapter_5.claims.driven_open_loop import REPEATS
from report.chapters.chapter_5.claims.section_5_2_4_simulated import (
    FIGURE_FORCE,
    candidates_part,
    friction_part,
    relay_part,
)
from report.claim import Claim, Impact, Part
from report.comparisons.assertion import Assertion
from report.comparisons.second_ways import by_harmonics, second_way
from report.evidence import Evidence
from report.numbers.linear_numbers import DRIVE_AMPLITUDE, DRIVE_FREQUENCY
from report.numbers.relay_loop import VISCOUS
from trimmer import InputChannels, pin_model
from trimmer.elements.relay import Relay
from trimmer.motion.drive import Drive
from trimmer.motion.loops import OpenLoop
from trimmer.motion.simulation import simulate

PERIODS = 60
"""Periods of the drive after which the open loop with a relay is settled."""


def claims(evidence: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    return (_relay(evidence), _relay_and_viscous(evidence))


def _relay(evidence: Evidence) -> Claim:
    numbers = evidence.motion.closed.relay
    return Claim(
        id="fig-5.19",
        parts=(relay_part(numbers, "relay of 0.015 in the loop"), _relay_in_open_loop(evidence)),
        explanation=(
            "The caption says open loop, the text feedback; neither has a limit cycle. Behind a relay in "
            "open loop stand odd multiples of the drive. In the loop the relay oscillates ever faster with "
            "ever smaller swings, so a simulation ends with what its step or tolerance leaves."
        ),
        consequence="See the high frequency in section 5.2.4.",
        impact=Impact.DOWNSTREAM,
        source="report/numbers/relay_loop.py",
    )


def _relay_repeats(evidence: Evidence) -> bool:
    """Tell whether the driven open loop with the relay of figure 5.19 ends with the period of its drive."""
    system = pin_model(evidence.numbers.parameters, channels=InputChannels.DISPLACEMENT_ONLY)
    drive = Drive(DRIVE_AMPLITUDE, 2 * math.pi * DRIVE_FREQUENCY)
    motion = simulate(OpenLoop(system, Relay(FIGURE_FORCE), drive), PERIODS / DRIVE_FREQUENCY)
    times = np.linspace(0, 1 / DRIVE_FREQUENCY, 401)
    last, before = (motion.output(motion.duration - turns / DRIVE_FREQUENCY + times) for turns in (1, 2))
    return bool(abs(last - before).max() < REPEATS * abs(last).max())


def _relay_in_open_loop(evidence: Evidence) -> Part:
    decay = max(mode.eigenvalue.real for mode in evidence.numbers.modes)
    return Part(
        "in open loop, as the caption has it",
        Assertion(
            statement="an oscillation besides the drive's harmonics goes on",
            derived=decay >= 0,
            evidence=(
                "a relay turns a sine into a square wave of the same period, and behind it free motions "
                f"decay as $e^{{{decay:.0f}\\,t}}$ or faster"
            ),
            method="periodic input of a stable linear system",
        ),
        second_way(
            f"exact simulation, whose last two of {PERIODS} periods are alike", _relay_repeats(evidence)
        ),
    )


def _relay_and_viscous(evidence: Evidence) -> Claim:
    numbers = evidence.motion.closed.relay
    return Claim(
        id="fig-5.20",
        parts=(
            candidates_part(
                numbers.with_viscous,
                "the block on the output, as a relay with a gain of 0.1",
                "a periodic oscillation goes on",
                by_harmonics(evidence.numbers.displacement_only, numbers.with_viscous.frequencies, VISCOUS),
            ),
            friction_part(numbers, "the block on the output's velocity, as friction"),
        ),
        explanation=(
            "Which signal enters the block is not said. On the output it is a relay with a small gain, and "
            "there is no periodic motion; on its velocity it is friction, and the loop sticks or creeps to "
            "rest without oscillation. A lasting high frequency is again the simulation's own."
        ),
        consequence="The second simulation does not confirm the first.",
        impact=Impact.DOWNSTREAM,
        source="report/numbers/relay_loop.py",
    )
