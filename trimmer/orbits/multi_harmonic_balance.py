"""Harmonic balance with several harmonics, which leads from the describing function to the exact orbit."""

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import control
import numpy as np
import scipy.optimize

from trimmer.arguments import require_instance, require_instances, whole_number
from trimmer.arrays import Complexes, Reals
from trimmer.balance.limit_cycle import IN_UNIT_OF_INPUT, LimitCycle
from trimmer.balance.loop_first import takes_a_loop
from trimmer.balance.many_harmonics.steady_response import steady_response
from trimmer.balance.many_harmonics.trigonometric import OddPolynomial
from trimmer.elements.element import Element
from trimmer.errors import OrbitNotFoundError
from trimmer.loops.loops import ClosedLoop
from trimmer.showing.shown import Tabular
from trimmer.showing.table import Table, of_harmonics

BALANCED = 1e-9  # Largest imbalance of any harmonic, relative to the first one, that counts as a solution
NO_OUTPUT = 1e3  # Imbalance where the element has no steady output


@dataclass(frozen=True, eq=False, repr=False)
class BalancedHarmonics(Tabular):
    """A solution of harmonic balance for the odd harmonics up to an order.

    Attributes:
        order: Highest harmonic.
        amplitude: Half of peak to peak of the element's input, in its unit.
        omega: Angular frequency, rad/s.
        harmonics: Complex amplitudes c_1, c_3 ... of the element's input Im Σ c_n exp(j n omega t), in its
            unit, shape ((order + 1) / 2,); c_1 > 0.
        residual: Largest imbalance of a harmonic relative to the first one.
    """

    order: int
    amplitude: float
    omega: float
    harmonics: Complexes
    residual: float

    @property
    def frequency(self) -> float:
        """Frequency of the first harmonic, Hz."""
        return self.omega / (2.0 * math.pi)

    def _told(self) -> str:
        return f"order {self.order}, amplitude {self.amplitude:.6g}, {self.frequency:.6g} Hz"

    def _table(self) -> Table:
        orders = np.arange(1, self.order + 1, 2)
        title = "Harmonics of the element's input"
        return of_harmonics(title, self.frequency, IN_UNIT_OF_INPUT, orders, self.harmonics)


@takes_a_loop
def multi_harmonic_balance(
    loop: ClosedLoop, cycle: LimitCycle, orders: Sequence[int] = (1, 3, 5, 7, 9)
) -> tuple[BalancedHarmonics, ...]:
    """Solve c_n + G(jn omega) U_n(c) = 0 for odd n up to each order, each from the solution before.

    U_n is the n-th harmonic of the element's steady output for the whole input, not for its first harmonic
    alone. Order 1 is the describing function's prediction; with growing order the solutions converge to the
    exact periodic orbit (Mees 1972).

    Args:
        loop: The closed loop; or ``system, element`` in its place.
        cycle: The limit cycle that the describing function predicts.
        orders: Odd numbers that rise.

    Returns:
        One solution per order.

    Raises:
        WrongTypeError: if neither a closed loop nor a system and an element are given.
        ValueError: if the orders are not odd, positive and rising.
        OrbitNotFoundError: if there is no solution near the one before.
    """
    require_instance("cycle", cycle, LimitCycle, "a trimmer.LimitCycle")
    orders = [
        whole_number(f"orders[{place}]", order)
        for place, order in enumerate(require_instances("orders", orders, object, "a whole number"))
    ]
    if not orders or any(order < 1 or order % 2 == 0 for order in orders) or sorted(set(orders)) != [*orders]:
        raise ValueError(f"orders must be odd, positive and rising, not {tuple(orders)!r}")
    return tuple(solutions(loop.system, loop.element, (cycle.amplitude, cycle.omega), orders))


def solutions(
    system: control.LTI, element: Element, guess: tuple[float, float], orders: Sequence[int]
) -> Iterator[BalancedHarmonics]:
    """Solve for one order after the other, each from the solution before.

    Args:
        system: G, one input and one output.
        element: The nonlinear element.
        guess: Amplitude of the element's input, in its unit, and omega, rad/s.
        orders: Odd numbers that rise.

    Yields:
        One solution per order.

    Raises:
        OrbitNotFoundError: if there is no solution near the one before.
    """
    harmonics, omega = np.array([guess[0]], dtype=np.complex128), guess[1]
    for order in orders:
        harmonics = np.append(harmonics, np.zeros((order + 1) // 2 - len(harmonics)))
        solution = _solve(system, element, order, harmonics, omega)
        harmonics, omega = solution.harmonics, solution.omega
        yield solution


def _solve(
    system: control.LTI, element: Element, order: int, harmonics: Complexes, omega: float
) -> BalancedHarmonics:
    amplitude = float(harmonics[0].real)

    def unpacked(unknowns: Reals) -> tuple[OddPolynomial, float]:
        first, ratio = unknowns[:2]
        coefficients = np.array([first, *unknowns[2:].view(np.complex128)], dtype=np.complex128)
        return OddPolynomial(amplitude * coefficients), ratio * omega

    def imbalance(unknowns: Reals) -> Reals:
        given, trial = unpacked(unknowns)
        output = steady_response(element, given, trial) if trial > 0 else None
        if output is None:
            return np.full(len(unknowns), NO_OUTPUT)
        gains = np.atleast_1d(system(1j * trial * given.numbers))
        residuals = (given.coefficients + gains * output) / amplitude
        return np.asarray(residuals.view(np.float64))

    start = np.append([1.0, 1.0], harmonics[1:].view(np.float64) / amplitude)
    found = scipy.optimize.root(imbalance, start, method="hybr", options={"xtol": 1e-14})
    residual = float(abs(imbalance(found.x)).max())
    if not residual <= BALANCED:  # At a pole of the system it is NaN.
        raise OrbitNotFoundError(f"no solution with harmonics up to {order} lies near that of lower order")
    given, solved = unpacked(found.x)
    return BalancedHarmonics(order, given.largest(), solved, given.coefficients, residual)
