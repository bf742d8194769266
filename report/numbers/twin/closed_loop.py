"""The thesis's closed loop with friction between cutter and guard, and the branches of it that are kept."""

from typing import Final

import numpy as np

from report.numbers.equivalent_nonlinearity import FORCE as LARGE_FORCE
from report.numbers.equivalent_nonlinearity import OTHER_FORCE as SMALL_FORCE
from report.numbers.thesis import EXPERIMENT_GAP, LARGE_GAP
from report.numbers.twin.grids import KeptCourse
from report.numbers.twin.kept_files import FOLDER
from trimmer import (
    CoulombFriction,
    FrictionBacklash,
    TrimmerLoop,
    TrimmerParameters,
    limit_cycles,
    periodic_orbits,
)
from trimmer.arrays import Reals
from trimmer.displacement import CUTTER_RELATIVE_TO_GUARD
from trimmer.linear import InputChannels
from trimmer.loops import BodyFriction

FILE: Final = FOLDER / "loop.json"
GAP, FORCE = "element.gap", f"frictions.{CUTTER_RELATIVE_TO_GUARD.label}.force"
"""Places of the numbers that are varied."""
OUTPUT: Final = "output"
FORCES: Final = (SMALL_FORCE, 0.3, LARGE_FORCE)
"""Frictions of the branches over the gap, N: those of figures 5.21 and 5.23, and one between them."""
LEAST_FORCE, MOST_FORCE = 1e-3, 0.4
"""Ends of the branch over the friction, N; a friction without force is none."""
LEAST_GAP: Final = 10e-6  # The branches over the gap reach from here to the gap of the experiment, m
COARSE: Final = 0.05  # Largest change of the number between two orbits, as a share of its interval


def thesis_loop(gap: float, force: float) -> TrimmerLoop:
    """Return the loop of section 5.2 with a total clearance, m, and friction in newtons."""
    return TrimmerLoop(
        TrimmerParameters.thesis(),
        FrictionBacklash(gap),
        channels=InputChannels.DISPLACEMENT_ONLY,
        frictions=(BodyFriction(CUTTER_RELATIVE_TO_GUARD, CoulombFriction(force)),),
    )


def _over_gap(force: float) -> KeptCourse:
    loop, ends = thesis_loop(EXPERIMENT_GAP, force), (LEAST_GAP, EXPERIMENT_GAP)
    return KeptCourse(f"gap, {force:g} N", loop, GAP, ends[1], ends[0], ends, OUTPUT, COARSE)


OVER_FORCE: Final = KeptCourse(
    "force",
    thesis_loop(LARGE_GAP, LEAST_FORCE),
    FORCE,
    LEAST_FORCE,
    MOST_FORCE,
    (LEAST_FORCE, MOST_FORCE),
    OUTPUT,
    COARSE,
)
LOOP_COURSES: Final = (OVER_FORCE, *map(_over_gap, FORCES))


def without_friction(course: KeptCourse) -> Reals:
    """Return states and period of the stable orbit of the loop of a branch as if it had no friction, (n,).

    From there the orbit with friction at the start of the branch is found.
    """
    loop = course.subject
    assert isinstance(loop, TrimmerLoop)
    assert loop.element is not None
    (stable,) = (each for each in limit_cycles(loop.model, loop.element) if each.stable)
    (orbit,) = periodic_orbits(loop.model, loop.element, (stable,))
    return np.array([*orbit.motion.state(0.0), float(orbit.motion.element_output(0.0)), orbit.period])
