"""What claims are judged with: the symbolic derivation and the numbers that were solved from it."""

from collections.abc import Callable
from dataclasses import dataclass

from derivations.algebra.laplace import GeneralSystem, TransformedSystem, general_system, transform
from derivations.linear_trimmer import LinearTrimmer, derive_linear_trimmer
from report.numbers.exact_orbits import ExactOrbits
from report.numbers.limit_cycle_numbers import LimitCycleNumbers, solve_limit_cycles
from report.numbers.linear_numbers import LinearNumbers, solve_linear
from report.numbers.motion_numbers import MotionNumbers, solve_motion
from report.numbers.twin_numbers import TwinNumbers, solve_twin
from trimmer import TrimmerParameters


@dataclass(frozen=True)
class Derived:
    """What SymPy derived: the linear trimmer, and a general system solved in the Laplace domain."""

    trimmer: LinearTrimmer
    general: GeneralSystem
    transformed: TransformedSystem


@dataclass(frozen=True)
class Evidence:
    """Everything that was derived and solved before a claim is judged."""

    derivation: LinearTrimmer
    general: GeneralSystem
    transformed: TransformedSystem
    numbers: LinearNumbers
    cycles: LimitCycleNumbers
    motion: MotionNumbers
    twin: TwinNumbers

    @property
    def orbits(self) -> ExactOrbits:
        """The exact orbits of the closed loops of section 5.2."""
        return self.motion.closed.orbits


def derive() -> Derived:
    """Derive the linear trimmer, and solve a general system in the Laplace domain."""
    general = general_system()
    return Derived(derive_linear_trimmer(), general, transform(general))


def solve(derived: Derived, twin: Callable[[], TwinNumbers] = solve_twin) -> Evidence:
    """Solve the thesis's trimmer with the derived equations, and last the twin, which needs none of them.

    Raises:
        KeptDataError: if a map or a branch that is kept cannot be used.
    """
    numbers = solve_linear(derived.trimmer, TrimmerParameters.thesis())
    cycles = solve_limit_cycles(numbers)
    motion = solve_motion(numbers, cycles)
    return Evidence(derived.trimmer, derived.general, derived.transformed, numbers, cycles, motion, twin())


def gather() -> Evidence:
    """Derive and solve everything that the claims need."""
    return solve(derive())
