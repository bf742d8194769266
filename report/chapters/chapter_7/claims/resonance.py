"""Claims of chapter 7 on damping, on where the resonances lie, and on a limit cycle at one of them."""

from report.chapters.second_ways import EXACTLY
from report.judging.parts import assertion, close, so
from report.judging.record import Record, claim, text
from report.judging.verdict import Certainty
from report.numbers.evidence import Evidence
from report.numbers.independent.exact_response import gain, gain_ratio
from report.numbers.linear_numbers import lightly_damped_response
from report.numbers.thesis import DRIVE_FREQUENCY, TURN
from trimmer import resonance_peaks, response_at

PRECISELY = 0.5  # Distance within which a frequency lies precisely at another, Hz
THIRD = 3  # Order of the lowest harmonic that an odd element adds


@claim("txt-7-damping")
def damping(known: Evidence) -> Record:
    numbers, damped = known.numbers, resonance_peaks(known.numbers.displacement_only)
    light = lightly_damped_response(numbers.parameters)
    highest, without = (max(peak.magnitude for peak in peaks) for peaks in (damped, resonance_peaks(light)))
    exact = max(float(gain(numbers, peak.omega)) for peak in damped)
    pairs = zip(
        sorted(mode.eigenvalue.imag for mode in numbers.modes),
        sorted(mode.omega for mode in numbers.undamped),
        strict=True,
    )
    moved = max(abs(with_it / without_it - 1) for with_it, without_it in pairs)
    yield assertion(
        "",
        "damping increases the magnitude of the resonances",
        highest > without,
        f"the highest peak is {highest:.1f} with damping and {without:.0f} with a thousandth of it",
        method="all local maxima of the gain for both dampings",
        second=close(EXACTLY, exact, highest),
    )
    yield text(f"""
        Damping lowers every resonance, as section 5.1.3 and the first paragraph of chapter 7 have it. The
        answer to the first sub-question states the opposite, perhaps by a slip of one word.

        The answer has to read: damping lowers the resonances, and moves the natural frequencies by
        {100 * moved:.1f} % at most.
    """)


@claim("txt-7-operating-frequency")
def operating_frequency(known: Evidence) -> Record:
    lowest = min(mode.frequency for mode in known.numbers.modes)
    undamped = min(mode.omega for mode in known.numbers.undamped) / TURN
    yield assertion(
        "",
        "the resonances lie below the operating frequency",
        lowest < DRIVE_FREQUENCY,
        f"the lowest is at {lowest:.2f} Hz, the drive at {DRIVE_FREQUENCY:.0f} Hz",
        method="eigenvalues",
        second=close("the undamped eigenvalue problem", undamped, lowest, 1e-3),
    )
    yield text("""
        It is the other way round: all resonances lie above the operating frequency, as section 5.1.3 says.
        That does not make them irrelevant, because the harmonics of the drive reach them.

        None on numbers; the answer to the first sub-question contradicts chapter 5.
    """)


@claim("txt-7-resonance")
def resonance(known: Evidence) -> Record:
    numbers, pair = known.numbers, known.cycles.friction
    peaks = resonance_peaks(numbers.displacement_only)
    highest = max(peaks, key=lambda peak: peak.magnitude).omega
    stable, unstable = (
        min(abs(cycle.omega - peak.omega) for peak in peaks) / TURN for cycle in (pair.stable, pair.unstable)
    )
    height = float(gain(numbers, pair.unstable.omega) / gain(numbers, highest))
    yield assertion(
        "where the limit cycles lie",
        "that one lies precisely at a resonance is very unlikely",
        min(stable, unstable) > PRECISELY,
        f"""
        the stable one is {stable:.0f} Hz from the nearest peak of the gain, the unstable one {unstable:.1f}
        Hz from the highest
        """,
        method="all solutions of harmonic balance; peaks of the gain",
        second=so(f"the exact gain at the unstable one, {100 * height:.0f} % of the peak's", height < 1),
        item="no limit cycle at a resonance, very unlikely",
    )
    shares = {peak.omega: share_of_third(known, peak.omega) for peak in peaks}
    at_peaks = ", ".join(f"{share:.2g} at {omega / TURN:.1f} Hz" for omega, share in shares.items())
    exact = gain_ratio(numbers, highest, THIRD)
    yield assertion(
        "what a resonance would do",
        "at a resonance the harmonics are not attenuated",
        min(shares.values()) > 1,
        f"""
        against the first harmonic $G$ passes the third by {at_peaks}; at the stable limit cycle by
        {share_of_third(known, pair.stable.omega):.2g}
        """,
        method="gain at three times each peak's frequency over the peak",
        second=close(EXACTLY, exact, shares[highest]),
        certainty=Certainty.READING,
    )
    mode = min(numbers.modes, key=lambda mode: abs(mode.eigenvalue.imag - highest))
    yield text(f"""
        Precisely at a resonance there is no limit cycle, though the unstable one lies within the
        {-2 * mode.eigenvalue.real / TURN:.0f} Hz that the highest peak is wide. The fear behind it has two
        readings. If a resonance at the limit cycle is meant, it magnifies the first harmonic and so weakens
        the others beside it, but for the two lowest, flat peaks; of all peaks the highest filters best. If a
        resonance at a higher harmonic is meant, that harmonic does come back.

        None on the predictions: no resonance lies near three or five times either frequency.
    """)


def share_of_third(known: Evidence, omega: float) -> float:
    """Return |G| at three times an angular frequency (rad/s) over |G| at it."""
    system = known.numbers.displacement_only
    third, first = (abs(complex(response_at(system, order * omega))) for order in (THIRD, 1))
    return float(third / first)
