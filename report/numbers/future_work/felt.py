"""How the housing of the twin shakes a hand: acceleration weighted by ISO 5349-1, over gap and friction."""

from typing import Any, Final

from report.numbers.future_work.kept import KeptAnswer
from report.numbers.twin.mechanism import twin
from trimmer import respond
from trimmer.design.analysis.found_motion import of_settled
from trimmer.response.results.response_json import response_json

HOUSING: Final = "housing"
GAPS: Final = (0.0, 20e-6, 40e-6, 60e-6, 100e-6, 150e-6, 200e-6, 300e-6)
FORCES: Final = (0.0, 0.5, 1.0, 2.0, 3.0, 4.0)
SPEED, CALM = 110.0, 150.0  # Drive of the map, Hz, and one in the calm band
CALM_FORCE: Final = 0.5  # Friction with which the calm speed is tried, N


def felt_row(gap: float, force: float, speed: float) -> list[Any]:
    """Return speed, gap, friction, kind of motion, and weighted and plain rms of the housing (m/s²)."""
    response = respond(twin(gap, force, speed))
    found = of_settled(response.motion)
    felt = found.hand_arm[HOUSING] if found else None
    kind = response_json(response)["kind"]
    return [speed, gap, force, kind, *((felt.weighted, felt.rms) if felt else (None, None))]


FELT: Final = KeptAnswer(
    "felt",
    [GAPS, FORCES, SPEED, CALM, CALM_FORCE, twin().to_toml()],
    lambda: {
        "map": [felt_row(gap, force, SPEED) for force in FORCES for gap in GAPS],
        "calm": [felt_row(gap, CALM_FORCE, CALM) for gap in GAPS],
    },
)
