"""SciPy's solve_ivp with events, hand-written laws: the programs of ``benchmarks/problems/second_ways``."""

import scipy

from benchmarks.peers.telling import tell
from benchmarks.problems.second_ways import contacts, frictions, pieces

SETTINGS = {
    "RK45, rtol 1e-3, atol 1e-6 (defaults)": ("RK45", 1e-3, 1e-6),
    "DOP853, rtol 1e-10": ("DOP853", 1e-10, 1e-14),
}
ASKED = {
    ("preloaded-stop", "last release"): contacts.preloaded_stop,
    ("hardening-spring", "peak to peak of x"): contacts.hardening_spring,
    ("falling-friction", "period"): frictions.falling_friction,
    ("conveyor", "advance"): frictions.conveyor,
}

if __name__ == "__main__":
    for setting, (method, rtol, atol) in SETTINGS.items():
        pieces.METHOD, pieces.RTOL, pieces.ATOL = method, rtol, atol
        for (problem, digit), ask in ASKED.items():
            tell(
                f"SciPy {scipy.__version__}",
                setting,
                problem,
                digit,
                lambda ask=ask, digit=digit: ask()[digit],
            )
