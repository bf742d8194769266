"""The research questions of the thesis (section 1.3), answered once more from the twin."""

import numpy as np

from report.judging.parts import close, so
from report.judging.record import text
from report.numbers.evidence import Evidence
from report.numbers.thesis import EXPERIMENT_GAP
from report.numbers.twin.mechanism import SMALL_FORCE, SMALL_GAP
from report.numbers.twin_numbers import SCALE
from report.twin.observation import Observed, SectionRecord, observation

MOST = 0.9  # Share that is meant by most
NUMBERS = "report/numbers/twin_numbers.py"
MAPS = "report/numbers/twin/map_numbers.py"


@observation("twin-question-1", source=MAPS)
def size(known: Evidence) -> Observed:
    friction = known.twin.friction
    row, reach = friction.row(SMALL_FORCE), friction.reach(SMALL_FORCE)
    motor, chaotic = friction.kept.measure("motor")[row], friction.chaotic[row]
    regular = friction.first <= reach
    at_most = 1e6 * friction.first[regular][motor[regular].argmax()]
    yield text(f"""
        Not in proportion. With 0.5 N at 110 Hz the motion repeats with the drive up to {1e6 * reach:.0f} µm,
        with impacts but without frequencies of its own. The motor's acceleration is {motor[0]:.0f} m/s²
        without play, only {motor.min():.0f} m/s² at {1e6 * friction.first[motor.argmin()]:.0f} µm, and
        {motor[regular].max():.0f} m/s² at {at_most:.0f} µm. Beyond comes chaos, not a limit cycle that grows
        with the gap: it is irregular, but with {motor[chaotic].min():.0f} to {motor[chaotic].max():.0f} m/s²
        not stronger.
    """)
    yield so("nine tenths of the cells of that row beyond it are chaotic", chaotic[~regular].mean() >= MOST)
    yield so("the motor is shaken most before the chaos", motor[chaotic].max() < motor[regular].max())
    yield so("and least with a small gap", 0 < friction.first[motor.argmin()] < SMALL_GAP)


@observation("twin-question-2", source=MAPS)
def damping(known: Evidence) -> Observed:
    numbers = known.twin.damping
    single, chaotic = numbers.single.mean(axis=1), numbers.chaotic.mean(axis=1)
    stated = numbers.row(0.4)
    yield text(f"""
        Without play the trimmer is stable with the dampings of Listing A.1. With play the damping of the
        bridge matters, and not in one direction: with 0.5 N and gaps up to 0.5 mm, {single[stated]:.0%} of
        the cells repeat with the drive at the thesis's 0.4 N s/m, {single.min():.0%} at
        {numbers.second[single.argmin()]:.1f} N s/m and {single.max():.0%} at
        {numbers.second[single.argmax()]:.1f} N s/m; chaos fills {chaotic[stated]:.0%} at 0.4 and
        {chaotic[-1]:.0%} at {numbers.second[-1]:.1f} N s/m.
    """)
    yield so(
        "shares of the rows of the map over gap and damping",
        (single.min() < single[stated] < single.max(), chaotic[-1] < chaotic[stated]),
    )
    yield so(
        "all natural modes of the linear trimmer decay",
        tuple(np.real(known.numbers.displacement_only.poles()) < 0),
    )


@observation("twin-question-3", source=MAPS)
def stability(known: Evidence) -> Observed:
    friction, starts = known.twin.friction, known.twin.starts
    chaotic = friction.shares["chaotic"]
    yield text(f"""
        A driven trimmer never rests, so the question is which motion it keeps. Play makes the drive's period
        unstable: it is left in {float(1 - friction.single[:, 1:].mean()):.0%} of the cells with play, mostly
        for chaos. Several motions may be stable at one gap and friction: in {starts.several:.0%} of
        {starts.cells} cells eight starts led to more than one. The thesis answers that play does not alter
        the stability; of its linear part that is so.
    """)
    yield so("most of the cells that leave it are chaotic", chaotic > 0.5 * (1 - friction.shares["one"]))
    yield so("eight starts in each cell of the coarser map", starts.kept.grid.starts == 8)


@observation("twin-question-4", source=NUMBERS)
def friction_(known: Evidence) -> Observed:
    numbers = known.twin
    first, last = numbers.no_gap[0], numbers.no_gap[-1]
    yield text(f"""
        It calms the play, at a price. 40 µm need {numbers.friction_for_small_gap:.1f} N to repeat with
        the drive, 0.2 mm need {numbers.friction_for_experiment:.1f} N. Without any play, friction from 0 to 4
        N raises the motor's acceleration from {first.motor:.1f} to {last.motor:.0f} m/s², lowers the stroke
        from {1e3 * first.peak_to_peak:.2f} to {1e3 * last.peak_to_peak:.2f} mm, and the blade loses
        {last.wear:.1f} W to it. It exchanges chaos for a stronger, regular vibration.
    """)
    yield so(
        "motor's acceleration rises with each step", tuple(np.diff([c.motor for c in numbers.no_gap]) > 0)
    )
    yield so("stroke falls with each step", tuple(np.diff([c.peak_to_peak for c in numbers.no_gap]) < 0))


@observation("twin-question-5", source=NUMBERS)
def amplitude(known: Evidence) -> Observed:
    numbers = known.twin
    yield text(f"""
        Only their ratio counts, and that of friction to amplitude: with amplitude, gap and friction all times
        {SCALE} the motion is the same at that scale. A larger pin amplitude therefore acts like a smaller gap
        and less friction together. On the map over gap and friction it moves a design straight towards the
        origin, across the edges, and so can end a subharmonic or begin one.
    """)
    yield close(
        "stroke of 0.2 mm and 2 N, and of half of all three times two",
        numbers.scaled / SCALE,
        numbers.main.twin.peak_to_peak,
    )


@observation("twin-question-6", source=MAPS)
def frequency(known: Evidence) -> Observed:
    speed = known.twin.speed
    column = speed.column(EXPERIMENT_GAP)
    calm = speed.second[speed.single[:, column]]
    yield text(f"""
        More than anything but the gap. With 0.5 N the gap up to which the drive's period lasts varies between
        {1e6 * float(speed.reaches.min()):.0f} and {1e6 * float(speed.reaches.max()):.0f} µm over 60 to 200
        Hz. At 0.2 mm {len(calm)} of {len(speed.second)} speeds repeat with the drive, from
        {float(calm.min()):.0f} to {float(calm.max()):.0f} Hz. The thesis's answer, hardly any influence,
        speaks of its closed loop, which has no drive.
    """)
    yield so(
        "reach of each row of the map over gap and speed",
        float(speed.reaches.max()) >= 10 * float(speed.reaches.min()) > 0,
    )


@observation("twin-question-7", source=NUMBERS)
def shown(known: Evidence) -> Observed:
    twin, cycle = known.twin.small.twin, known.cycles.friction.stable
    low, high = cycle.frequency, known.cycles.inertia.stable.frequency
    places = twin.lines[:, 0] * twin.frequency
    inside = (places >= low) & (places <= high)
    nearest, seventh = 7 * twin.frequency, twin.line(7)
    yield text(f"""
        Not at all. The thesis's loop predicts {1e6 * cycle.amplitude * twin.gap:.0f} µm at {low:.1f} Hz for
        40 µm, and for other backlash up to {high:.1f} Hz. The twin at 40 µm and 0.5 N, driven at 110 Hz, has
        nothing but harmonics. None lies in that band; the nearest, the seventh at {nearest:.0f} Hz, has
        {1e6 * seventh:.1f} µm. What two-way contact adds to the output are subharmonics and chaos, tied to
        the drive, not an oscillation at {low:.0f} Hz.
    """)
    yield so("no line of the exact motion lies in the band", (low < high, not inside.any()))
    yield so("the nearest is far smaller than predicted", seventh < 0.05 * cycle.amplitude * twin.gap)


SECTION = SectionRecord(
    "twin-questions",
    "The research questions, from the twin",
    (size, damping, stability, friction_, amplitude, frequency, shown),
)
