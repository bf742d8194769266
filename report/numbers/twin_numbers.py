"""Every number of the physical twin that the report needs, solved or read once."""

from dataclasses import dataclass
from typing import Final

import numpy as np

from report.numbers.thesis import DRIVE_AMPLITUDE, DRIVE_FREQUENCY, EXPERIMENT_GAP, TURN
from report.numbers.twin.advice import LINES, Searched, read_advice, tried_again
from report.numbers.twin.cases import PHASES, SHOWN, Independent, TwinCase, followed, independent, twin_case
from report.numbers.twin.frozen_bridge import FrozenBridge, frozen_bridge
from report.numbers.twin.grids import COURSES, DAMPING_MAP, FRICTION_MAP, SPEED_MAP, STARTS_MAP, STIFFNESS_MAP
from report.numbers.twin.kept_branch import FILE, KeptBranch, read_branches
from report.numbers.twin.kept_map import read_map
from report.numbers.twin.loop_numbers import FrictionLoopNumbers, solve_loop
from report.numbers.twin.map_numbers import MapNumbers
from report.numbers.twin.mechanism import AMPLITUDE, FREQUENCY, SMALL_FORCE, SMALL_GAP, STROKE, twin
from trimmer import TrimmerParameters, forced_orbit, pin_model, response_at
from trimmer.arrays import Reals
from trimmer.linear import InputChannels

THESIS_FORCE: Final = 0.5  # The middle one of the thesis's three frictions, N
MAIN_FORCE: Final = 2.0  # Friction of the motion of three drive periods, N
FORCES: Final = (0.0, 1.0, 2.0, 3.0, 4.0)  # Frictions without play, N
SOLVED_AGAIN: Final = 100  # Every so many orbits of a branch one is solved again
SCALE: Final = 0.5  # Factor by which amplitude, gap and friction are changed together


@dataclass(frozen=True, eq=False)
class BothModels:
    """One gap and one friction in both models, at the same drive."""

    frozen: FrozenBridge  # The thesis's model, settled
    twin: TwinCase  # The twin, settled

    @property
    def other_side(self) -> float:
        """Share of the time in which the two bridges are apart by more than half of the gap.

        Both are taken relative to their motors and at the same phase of the pin.
        """
        bridge = self.twin.bridge
        apart = abs(bridge - self.repeated(self.frozen.bridge, len(bridge) // PHASES))
        return float((apart > self.twin.gap / 2).mean())

    def repeated(self, period: Reals, times: int = SHOWN) -> Reals:
        """Return a period of the thesis's model so many times, sampled like the motion of the twin."""
        return np.resize(period[:: len(period) // PHASES], times * PHASES)


@dataclass(frozen=True, eq=False)
class TwinNumbers:
    """The twin: 1.5 mm at the pin, and 110 Hz where nothing else is said."""

    small: BothModels  # 40 µm and 0.5 N, in both models
    # 0.2 mm and 0.5 N, the gap of the experiment and a friction of the thesis, in both
    experiment: BothModels
    main: BothModels  # 0.2 mm and 2 N, in both
    asymmetric: TwinCase  # 0.2 mm and 2 N at the 100 Hz of chapters 4 and 5
    no_gap: tuple[TwinCase, ...]  # Without play, with ``FORCES``
    # small_again, main_again: ``small`` and ``main`` by another method
    small_again: Independent
    main_again: Independent
    scaled: float  # Stroke of ``main`` with amplitude, gap and friction all times ``SCALE``, m peak to peak
    mirror_miss: float  # How far the mirror image of ``asymmetric`` is from an exact motion, over its size
    mirror_apart: float  # Distance of the mirror image from the motion itself, m
    linear_stroke: float  # Without play and friction, from the linear trimmer's response, m peak to peak
    branches_again: float  # Largest relative change of the stroke where kept orbits are solved again
    # Lines of advice with what their searches found, tried again at a few points
    advice: tuple[Searched, ...]
    friction: MapNumbers  # Kept map over gap and friction
    speed: MapNumbers  # Kept map over gap and frequency of the drive, 0.5 N
    stiffness: MapNumbers  # Kept map over gap and stiffness of the bridge, 0.5 N
    damping: MapNumbers  # Kept map over gap and damping of the bridge, 0.5 N
    starts: MapNumbers  # Kept map over gap and friction from several starts
    # Kept branches over the gap with 2 N, each before those that part from it
    branches: tuple[KeptBranch, ...]
    loop: FrictionLoopNumbers  # The thesis's loop with friction

    @property
    def friction_for_small_gap(self) -> float:
        """Friction from which 40 µm repeat with the drive in every cell of the map, N."""
        return self.friction.from_where_on(SMALL_GAP)

    @property
    def friction_for_experiment(self) -> float:
        """Friction from which 0.2 mm repeat with the drive in every cell of the map, N."""
        return self.friction.from_where_on(EXPERIMENT_GAP)


def solve_twin() -> TwinNumbers:
    """Solve the single motions, and read what is kept.

    Raises:
        KeptDataError: if a kept file is missing, was changed, or was made from something else.
    """
    maps = (FRICTION_MAP, SPEED_MAP, STIFFNESS_MAP, DAMPING_MAP, STARTS_MAP)
    friction, speed, stiffness, damping, starts = (MapNumbers(read_map(grid)) for grid in maps)
    branches = read_branches(COURSES, FILE)
    miss, apart = _mirrored()
    return TwinNumbers(
        small=_compared(SMALL_GAP, SMALL_FORCE),
        experiment=_compared(EXPERIMENT_GAP, THESIS_FORCE),
        main=_compared(EXPERIMENT_GAP, MAIN_FORCE),
        asymmetric=twin_case(EXPERIMENT_GAP, MAIN_FORCE, DRIVE_FREQUENCY),
        no_gap=tuple(twin_case(0.0, force) for force in FORCES),
        small_again=independent(SMALL_GAP, SMALL_FORCE),
        main_again=independent(EXPERIMENT_GAP, MAIN_FORCE),
        scaled=_scaled(),
        mirror_miss=miss,
        mirror_apart=apart,
        linear_stroke=_linear_stroke(),
        branches_again=_branches_again(branches),
        advice=tuple(map(tried_again, read_advice(LINES))),
        friction=friction,
        speed=speed,
        stiffness=stiffness,
        damping=damping,
        starts=starts,
        branches=branches,
        loop=solve_loop(),
    )


def _compared(gap: float, force: float) -> BothModels:
    return BothModels(frozen_bridge(gap, force), twin_case(gap, force))


def _scaled() -> float:
    """Return the stroke of ``main`` with amplitude, gap and friction all smaller, m."""
    smaller = twin(SCALE * EXPERIMENT_GAP, SCALE * MAIN_FORCE).with_value(AMPLITUDE, SCALE * DRIVE_AMPLITUDE)
    return followed(smaller).measures.peak_to_peak[STROKE]


def _mirrored() -> tuple[float, float]:
    """Return ``mirror_miss`` and ``mirror_apart``."""
    mechanism = twin(EXPERIMENT_GAP, MAIN_FORCE, DRIVE_FREQUENCY)
    orbit = followed(mechanism)
    first, later = orbit.course.states(np.array([0.0, orbit.flow.period / 2]))[:, : orbit.flow.size]
    image = forced_orbit(mechanism, guess=-later)
    miss = np.linalg.norm(image.instant.state / later + 1.0, np.inf)
    apart = np.linalg.norm((image.instant.state - first)[: len(mechanism.bodies)], np.inf)
    return float(miss), float(apart)


def _linear_stroke() -> float:
    """Return the stroke without play and friction from the response of the linear trimmer, m."""
    system = pin_model(TrimmerParameters.thesis(), channels=InputChannels.DISPLACEMENT_AND_VELOCITY)
    response = response_at(system, TURN * FREQUENCY)
    return 2 * DRIVE_AMPLITUDE * float(abs(response))


def _branches_again(branches: tuple[KeptBranch, ...]) -> float:
    """Return the largest relative change of the stroke where branches are solved again from their states."""
    changes = []
    for branch in branches:
        for at in range(0, len(branch.values), SOLVED_AGAIN):
            mechanism = branch.course.subject.with_value(branch.course.place, float(branch.values[at]))
            orbit = forced_orbit(mechanism, periods=branch.periods, guess=branch.states[at])
            changes.append(abs(orbit.measures.peak_to_peak[STROKE] / branch.strokes[at] - 1))
    return max(changes)
