"""The measured spectra of chapter 3, compared by order of the drive and by parity alone."""

from report.judging.parts import equal, small, so
from report.judging.record import text
from report.numbers.evidence import Evidence
from report.numbers.thesis import EXPERIMENT_GAP, FRAMES_OF_TABLES, SAMPLE_RATE, TABLE_2
from report.numbers.twin.map_numbers import SEEN
from report.twin.observation import Observed, SectionRecord, observation

RESOLUTION = SAMPLE_RATE / FRAMES_OF_TABLES  # Width of a bin of the measured spectra, Hz
VANISHES = 1e-12


@observation("twin-odd", source="report/numbers/twin/cases.py", title="Without play.")
def without_play(known: Evidence) -> Observed:
    cases = known.twin.no_gap
    even = max(case.line(order) for case in cases for order in (2, 4, 6))
    third, fifth = (1e6 * cases[1].line(order) for order in (3, 5))
    yield text(f"""
        Compared by order of the drive and by parity alone, since the parameters of the measured trimmer
        (table C.1) are not given: its spectrum without play has the orders 1, 3 and 5 (table 3.1). So has the
        twin with friction and no play, {third:.0f} µm at the third and {fifth:.0f} µm at the fifth harmonic
        with 1 N, and no even ones. So has the thesis's model; this measurement does not tell them apart.
    """)
    yield small("even harmonics of the exact motions with 0 to 4 N", even, VANISHES)
    yield equal("motions of one drive period", {case.period_count for case in cases}, {1})


@observation("twin-even", source="report/numbers/twin/map_numbers.py", title="With play.")
def with_play(known: Evidence) -> Observed:
    numbers, friction = known.twin, known.twin.friction
    frozen = (numbers.small, numbers.experiment, numbers.main)
    even = max(float(each.frozen.harmonics[order]) for each in frozen for order in (2, 4))
    at_gap = friction.asymmetric[:, friction.column(EXPERIMENT_GAP)]
    forces = friction.second[at_gap]
    most, gap, force = friction.largest_second
    orders = [len(cells) for cells in TABLE_2.values()]
    share = float(friction.asymmetric.sum() / friction.single.sum())
    yield text(f"""
        With 0.2 mm of play the measured spectra have the orders 1 to 5 in all three records (table 3.2),
        the even ones too. By parity alone, since the measured trimmer's parameters (table C.1) are not
        given: the thesis's model cannot have even orders, because it settles to one motion, which is
        symmetric. The twin has them wherever its motion lost its symmetry: in {share:.0%} of the cells of the
        map over gap and friction that repeat with the drive, with up to {1e6 * most:.0f} µm of second
        harmonic (at {1e3 * gap:.2f} mm and {force:.1f} N). At 0.2 mm it repeats with the drive and has even
        harmonics from {float(forces.min()):.1f} N on.
    """)
    yield equal("orders that table 3.2 lists for each record", set(orders), {5})
    yield small("even harmonics of the thesis's model in three settled motions", even, 1e-9)
    yield so("cells with a second harmonic of more than a micrometre", (most > SEEN, len(forces) > 0))


@observation("twin-mirror", source="report/numbers/twin/cases.py", title="A pair of mirrored motions.")
def mirrored(known: Evidence) -> Observed:
    case = known.twin.asymmetric
    yield text(f"""
        An example, in the model with the parameters of Listing A.1 and at its 100 Hz: with 0.2 mm and 2 N it
        repeats with the drive, and its second harmonic is {1e6 * case.line(2):.1f} µm, its fourth
        {1e6 * case.line(4):.0f} µm. A mirrored motion exists beside it with the same amplitudes; the start
        decides.
    """)
    yield equal("exact periodic motion of one drive period", case.period_count, 1)
    yield so("stable, by its Floquet multipliers", case.largest_multiplier < 1)
    yield small("the mirror image, half a period later, is an exact motion too", known.twin.mirror_miss)
    yield so("it is another one", known.twin.mirror_apart > SEEN)


@observation("twin-between", source="report/numbers/twin/cases.py", title="Between the harmonics.")
def between(known: Evidence) -> Observed:
    twin = known.twin.main.twin
    spacing = twin.frequency / twin.period_count
    yield text(f"""
        The thesis found no further frequencies in the measured spectra (section 3.2). A line at a third of
        the drive would lie {spacing:.1f} Hz from the next one, {spacing / RESOLUTION:.1f} bins of
        {RESOLUTION:.0f} Hz: such a record would show it. As far as a record of 0.1 s tells, the measured
        trimmer, whose parameters are not given, repeated with its drive of 109.945 Hz. By order and parity
        alone it moved as the twin with Listing A.1 does where its motion keeps the drive's period and has
        lost its symmetry. A gap that is not centred, or a blade that rubs unequally, would give even
        harmonics as well: neither model has that, and the spectra do not tell it apart.
    """)
    yield so("the lines are more than two bins apart", spacing > 2 * RESOLUTION)
    yield equal("lines of the twin at thirds of the drive", twin.period_count, 3)


SECTION = SectionRecord(
    "twin-measured", "The measured spectra, by order and parity", (without_play, with_play, mirrored, between)
)
