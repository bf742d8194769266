"""Motion, contact force and spectrum at 110 Hz, beside the thesis's model."""

from report.judging.parts import close, equal, small, so
from report.judging.record import text
from report.numbers.evidence import Evidence
from report.numbers.thesis import EXPERIMENT_GAP
from report.numbers.twin_numbers import BothModels
from report.twin.figures.motion import motions, spectra
from report.twin.observation import Observed, SectionRecord, observation
from trimmer import MotionKind

CASES = "report/numbers/twin/cases.py"
RUNGE_KUTTA = "the same motion integrated by DOP853 from event to event, with equations written anew"
RELATIVE = 1e-6
ERRORS = 3  # Standard errors by which an exponent has to exceed 0
LYAPUNOV = (0.7, 1.1)
"""Between which the exponent lies per drive period; estimates differ by 0.03 with the first state."""
BELOW = 50
"""How many times the chaos's spectrum lies below the first harmonic, at least; 97 to 141 with the stretch."""
MODERATE = (0.2, 0.8)  # Frictions between which the thesis's three lie, N; the grid of the map has both


def _micrometres(case: BothModels, order: int) -> tuple[float, float]:
    """Return the amplitude of a harmonic in the thesis's model and in the twin, µm."""
    return 1e6 * float(case.frozen.harmonics[order]), 1e6 * case.twin.line(order)


@observation("twin-small-gap", source=CASES, title="40 µm and 0.5 N.")
def small_gap(known: Evidence) -> Observed:
    case, again = known.twin.small, known.twin.small_again
    twin = case.twin
    third, fifth = _micrometres(case, 3), _micrometres(case, 5)
    yield text(f"""
        The twin settles within {twin.waited} drive periods to a motion that repeats with the drive. The pin
        hits the bridge {twin.impacts:.0f} times in each period, at up to {twin.impact_speed:.2f} m/s, and is
        in contact for {twin.contact_share:.0%} of the time. The stroke is {1e3 * twin.peak_to_peak:.3f} mm
        peak to peak against {1e3 * case.frozen.peak_to_peak:.3f} mm in the thesis's model; the third harmonic
        is {third[1]:.0f} µm against {third[0]:.0f}, the fifth {fifth[1]:.0f} µm against {fifth[0]:.0f}. The
        force of the bridge reaches {twin.largest_force:.1f} N.
    """)
    yield equal("exact periodic motion of one drive period", twin.period_count, 1)
    yield so("all Floquet multipliers inside the unit circle", twin.largest_multiplier < 1)
    yield small(f"{RUNGE_KUTTA}: it closes", again.miss)
    yield close("and has the same third harmonic", float(again.lines[2]), twin.line(3), RELATIVE)


@observation("twin-main", source=CASES, title="0.2 mm and 2 N.")
def main_case(known: Evidence) -> Observed:
    case, again = known.twin.main, known.twin.main_again
    twin = case.twin
    yield text(f"""
        With the gap of the experiment and 2 N the twin repeats after {twin.period_count} drive periods, not
        after one. Its stroke has lines between the harmonics: {1e6 * twin.line(1 / 3):.0f} µm at a third of
        the drive, {1e6 * twin.line(5 / 3):.0f} µm at five thirds and {1e6 * twin.line(7 / 3):.0f} µm at seven
        thirds, beside {1e6 * twin.line(1):.0f} µm at the drive itself. The second harmonic is
        {1e6 * twin.line(2):.0f} µm. The thesis's model repeats with the drive for every gap and friction, and
        has odd harmonics alone. "No limit cycle in a driven trimmer" therefore holds for play that only
        passes a displacement on, as in the thesis; two-way contact can bring a vibration of its own.
    """)
    yield equal("exact periodic motion of three drive periods and of no fewer", twin.period_count, 3)
    yield so("all Floquet multipliers inside the unit circle", twin.largest_multiplier < 1)
    yield small(f"{RUNGE_KUTTA}: it closes after three drive periods", again.miss)
    yield close("and has the same line at a third", float(again.lines[0]), twin.line(1 / 3), RELATIVE)


@observation("twin-chaos", source=CASES, title="0.2 mm and the thesis's frictions.")
def chaos(known: Evidence) -> Observed:
    case, friction = known.twin.experiment, known.twin.friction
    exponent = case.twin.lyapunov
    cells = friction.within((EXPERIMENT_GAP, EXPERIMENT_GAP), MODERATE)
    floor = case.twin.highest_between
    yield text(f"""
        At 0.2 mm and 0.5 N the twin is chaotic: neighbouring motions part by a factor of e in about one drive
        period (Lyapunov exponent between {LYAPUNOV[0]:.1f} and {LYAPUNOV[1]:.1f} per period). All
        {int(cells.sum())} cells of the map at that gap from 0.2 to 0.8 N are chaotic, and the frictions of
        section 3.3 lie between them. The thesis's model settles to the drive's period there. The chaos is
        carried by a large regular motion: its first harmonic is {1e3 * case.twin.line(1):.2f} mm, the
        spectrum between the harmonics stays at least {BELOW} times below it.
    """)
    yield equal("kind of motion by exponent and neighbour", case.twin.kind, MotionKind.CHAOTIC)
    yield so("the exponent exceeds three standard errors", exponent.value > ERRORS * exponent.uncertainty)
    yield so(
        "it lies between these numbers, also if it is off by its standard error",
        LYAPUNOV[0] + exponent.uncertainty < exponent.value < LYAPUNOV[1] - exponent.uncertainty,
    )
    yield so("spectrum over 220 drive periods", case.twin.line(1) > BELOW * floor)
    yield so("every one of these cells is chaotic", tuple(friction.chaotic[cells]))
    yield small("the thesis's model has settled", case.frozen.repeat, RELATIVE)


SECTION = SectionRecord(
    "twin-motion",
    "Motion, contact force and spectrum at 110 Hz",
    (small_gap, motions, main_case, spectra, chaos),
)
