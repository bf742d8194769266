"""Claims of section 5.1.3 on eigenvalues and resonances (equation 5.2)."""

from collections.abc import Sequence

from report.chapters.second_ways import EXACTLY
from report.judging.claim import ClaimPart, Confirmation
from report.judging.parts import assertion, close, digits, so
from report.judging.record import Record, claim, text
from report.judging.verdict import Certainty
from report.numbers.evidence import Evidence
from report.numbers.independent.exact_response import eigenvalues, gain, gain_ratio, peak
from report.numbers.thesis import DRIVE_FREQUENCY, DRIVE_OMEGA, MEASURED_DRIVE_FREQUENCY, TURN
from trimmer import resonance_peaks
from trimmer.linear import filtering_ratio
from trimmer.linear.extrema import Extremum

PRINTED_EIGENVALUES = (
    ("1,2", "-541.6448", "7159.6999"),
    ("3,4", "-80.5896", "3453.172"),
    ("5,6", "-41.8148", "2229.5063"),
    ("7,8", "-24.9984", "1397.0567"),
)
DECADE, READ_TO = 50.0, 0.5
"""Width of a decade in a plot over three of them on a page, and what can be told apart on it, mm."""
READING_ACCURACY = 10 ** (READ_TO / DECADE) - 1  # Share to which a frequency can be read in a Bode plot
PLOT_READ = f"a plot with {DECADE:.0f} mm a decade is read to {READ_TO} mm, {100 * READING_ACCURACY:.1f} %"
EXACT_ROOTS, EXACT_SLOPE = "the roots of the exact polynomial", "the slope of the exact gain"


@claim("eq-5.2")
def printed_eigenvalues(known: Evidence) -> Record:
    exact = sorted(
        (root for root in eigenvalues(known.numbers) if root.imag > 0), key=lambda root: -root.imag
    )
    solved = sorted((mode.eigenvalue for mode in known.numbers.modes), key=lambda root: -root.imag)
    for (index, real, imaginary), value, other in zip(PRINTED_EIGENVALUES, solved, exact, strict=True):
        second = close(EXACT_ROOTS, other, value)
        yield digits(rf"$\mathrm{{Re}}\,\lambda_{{{index}}}$", real, value.real, "1/s", second=second)
        yield digits(rf"$\mathrm{{Im}}\,\lambda_{{{index}}}$", imaginary, value.imag, "rad/s", second=second)
    yield text("""
        All eight eigenvalues agree to every printed digit. They come in four conjugate pairs, one for each
        mode. The text leaves open whether they are poles or zeros of the transfer function; they are poles.
    """)


def peak_part(
    index: str, printed: str, omega: float, second: Confirmation, certainty: Certainty | None = None
) -> ClaimPart:
    """Hold the frequency of a peak against an eigenvalue's imaginary part, as well as a plot can be read."""
    distance = omega / float(printed) - 1
    return assertion(
        rf"peak near $\mathrm{{Im}}\,\lambda_{{{index}}}$",
        f"a peak stands at {printed} rad/s, as far as a plot can be read",
        abs(distance) <= READING_ACCURACY,
        f"it stands at {omega:.2f} rad/s, {100 * distance:+.3f} %",
        method=f"local maxima of the gain; {PLOT_READ}",
        second=second,
        certainty=certainty,
    )


def nearest(peaks: Sequence[Extremum], omega: float) -> Extremum:
    return min(peaks, key=lambda each: abs(each.omega - omega))


@claim("txt-5.1.3-hidden-peak")
def hidden_peak(known: Evidence) -> Record:
    numbers, system = known.numbers, known.numbers.displacement_only
    peaks = resonance_peaks(system)
    (hidden, _, place), *visible = PRINTED_EIGENVALUES
    found = {printed: nearest(peaks, float(printed)).omega for _, _, printed in visible}
    for index, _, printed in visible:
        omega = found[printed]
        second = close(EXACT_SLOPE, peak(numbers, omega), omega, 1e-7)
        yield peak_part(index, printed, omega, second, Certainty.READING)
    pole = next(mode.eigenvalue for mode in numbers.modes if mode.omega_damped > 7000)
    apart = min(abs(zero - pole) for zero in system.zeros())
    falls = gain(numbers, float(place) * 1.01) < gain(numbers, float(place) * 0.99)
    yield assertion(
        rf"peak near $\mathrm{{Im}}\,\lambda_{{{hidden}}}$",
        "the output $x_2 - x_4$ shows no peak near 7159.7 rad/s",
        tuple(abs(each.omega / float(place) - 1) >= 0.2 for each in peaks),
        f"""
        a pair of zeros lies {apart:.2f} rad/s from the pair of poles, {100 * apart / abs(pole):.3f} % of
        their size, and takes the peak away
        """,
        method="all local maxima of the gain",
        second=so("the gain falls from 0.99 to 1.01 times that frequency", falls),
    )
    *others, last = (100 * (omega / float(printed) - 1) for printed, omega in found.items())
    (stray,) = (each.omega for each in peaks if each.omega not in found.values())
    yield text(f"""
        One resonance is hidden, as the text says, because zeros all but cancel its poles. The other peaks
        stand at the imaginary parts, two of them within {max(map(abs, others)):.1f} %. The faint one next to
        a valley stands {last:.1f} % above its {numbers.modes[0].omega_damped:.0f} rad/s, less than half a
        millimetre in a plot. A further faint maximum, at {stray:.1f} rad/s, belongs to no eigenvalue.
    """)


@claim("txt-5.1.3-first-resonance")
def first_resonance(known: Evidence) -> Record:
    numbers, system = known.numbers, known.numbers.displacement_only
    frequency, measured = numbers.modes[0].frequency, MEASURED_DRIVE_FREQUENCY
    exact = min(abs(root.imag) for root in eigenvalues(numbers)) / TURN
    fifth = float(filtering_ratio(system, DRIVE_OMEGA, 5))
    second = close(EXACT_ROOTS, exact, frequency)
    yield digits("first eigenfrequency", "222.35", frequency, "Hz", second=second)
    yield assertion(
        "what follows for the drive",
        "the resonances do not matter, as the first one is far above the drive",
        fifth < 1,
        f"the drive's harmonics meet them: the fifth of 100 Hz passes {fifth:.1f} times better than 100 Hz",
        method="frequency response at multiples of the drive",
        second=close(EXACTLY, gain_ratio(numbers, DRIVE_OMEGA, 5), fifth),
        item="the resonances do not matter, as the drive lies below them",
        certainty=Certainty.READING,
    )
    highest = max(resonance_peaks(system), key=lambda each: each.magnitude).omega / TURN
    yield text(f"""
        The number is right: the first eigenfrequency is {frequency / DRIVE_FREQUENCY:.1f} times the drive.
        The conclusion holds for a sinusoidal motion. It does not hold for the trimmer, where play and
        friction make harmonics of the drive.

        A peak near {highest:.0f} Hz in a driven spectrum of this model needs no limit cycle: a harmonic of
        the drive is amplified there more than anywhere else. Section 3.3 takes its peak at 549.999 Hz for a
        fifth harmonic too, which fits the measured drive of {measured} Hz ({5 * measured:.1f} Hz), though the
        parameters of the measured trimmer (table C.1) are not given.
    """)
