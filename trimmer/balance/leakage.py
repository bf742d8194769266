"""Harmonics of an element that come back to its input through G: the filtering hypothesis as numbers."""

from collections.abc import Sequence

import numpy as np

from trimmer.arguments import require_instance, require_instances, whole_number
from trimmer.balance.limit_cycle import LimitCycle
from trimmer.balance.loop_first import takes_a_loop_or_data
from trimmer.linear.measured_response import response_of
from trimmer.loops.loops import ClosedLoop
from trimmer.loops.measured_loop import MeasuredLoop

HARMONICS = (3, 5, 7)  # The first harmonics above the fundamental that an odd element has


@takes_a_loop_or_data
def harmonic_leakage(
    loop: ClosedLoop | MeasuredLoop, cycle: LimitCycle, harmonics: Sequence[int] = HARMONICS
) -> tuple[float, ...]:
    """Compare each harmonic that comes back to the element's input with the fundamental there.

    The ratio |N_n G(j n omega)| / |N_1 G(j omega)| is what harmonic balance drops (equation 2.26 of the
    thesis weighted with the element's own harmonic); it is small where the filtering hypothesis holds.

    Args:
        loop: The closed loop; or ``system, element`` in its place.
        cycle: A limit cycle of that loop.
        harmonics: Numbers n >= 1.

    Returns:
        One ratio per harmonic, without unit; NaN beyond frequency-response data.

    Raises:
        WrongTypeError: if neither a closed loop nor a system and an element are given.
        UnsupportedSystemError: see ``trimmer.linear.frequency_response.require_siso``.
        ValueError: if a harmonic is not an integer >= 1.
    """
    require_instance("cycle", cycle, LimitCycle, "a trimmer.LimitCycle")
    numbers = require_instances("harmonics", harmonics, object, "a whole number")
    for place, number in enumerate(numbers):
        whole_number(f"harmonics[{place}]", number, 1)

    def returned(harmonic: int) -> float:
        gain = loop.element.describing_function(cycle.amplitude, cycle.omega, harmonic)
        return float(np.abs(gain * response_of(loop.system, harmonic * cycle.omega)))

    fundamental = returned(1)
    return tuple(returned(harmonic) / fundamental for harmonic in numbers)
