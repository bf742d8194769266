"""The research questions of the thesis (section 1.3), answered once more from the twin."""

from __future__ import annotations

import numpy as np

from report.judging.parts import close, so
from report.judging.record import text
from report.numbers.evidence import Evidence
from report.numbers.thesis import EXPERIMENT_GAP
from report.numbers.twin.mechanism import SMALL_FORCE, SMALL_GAP
from report.numbers.twin_numbers import SCALE
from report.twin.observation import Observed, SectionRecord, observation

MOST = 0.9
"""Share that is meant by most."""
NUMBERS = "report/numbers/twin_numbers.py"
MAPS = "report/numbers/twin/map_numbers.py"


@observation(
    "twin-question-1", source=MAPS, title="1. How does the size of the play influence the vibration?"
)
def size(known: Evidence) -> Observed:
    friction = known.twin.friction
    row, reach = friction.row(SMALL_FORCE), friction.reach(SMALL_FORCE)
    motor, chaotic = friction.kept.measure("motor")[row], friction.chaotic[row]
    regular = friction.first <= reach
    yield text("""
        Not in proportion. With 0.5 N at 110 Hz the motion repeats with the drive up to [[ reach | f0 ]] µm,
        with impacts but without frequencies of its own. The motor's acceleration is [[ without | f0 ]] m/s²
        without play, only [[ least | f0 ]] m/s² at [[ at_least | f0 ]] µm, and [[ most | f0 ]] m/s² at
        [[ at_most | f0 ]] µm. Beyond comes chaos, not a limit cycle that grows with the gap: it is
        irregular, but with [[ calm | f0 ]] to [[ rough | f0 ]] m/s² not stronger.
    """).given(
        reach=1e6 * reach,
        without=motor[0],
        least=motor.min(),
        at_least=1e6 * friction.first[motor.argmin()],
        most=motor[regular].max(),
        at_most=1e6 * friction.first[regular][motor[regular].argmax()],
        calm=motor[chaotic].min(),
        rough=motor[chaotic].max(),
    )
    yield so("nine tenths of the cells of that row beyond it are chaotic", chaotic[~regular].mean() >= MOST)
    yield so("the motor is shaken most before the chaos", motor[chaotic].max() < motor[regular].max())
    yield so("and least with a small gap", 0 < friction.first[motor.argmin()] < SMALL_GAP)


@observation(
    "twin-question-2", source=MAPS, title="2. What is the effect of damping on the stability of the system?"
)
def damping(known: Evidence) -> Observed:
    numbers = known.twin.damping
    single, chaotic = numbers.single.mean(axis=1), numbers.chaotic.mean(axis=1)
    stated = numbers.row(0.4)
    yield text("""
        Without play the trimmer is stable with the dampings of Listing A.1. With play the damping of the
        bridge matters, and not in one direction: with 0.5 N and gaps up to 0.5 mm, [[ stated | percent0 ]]
        of the cells repeat with the drive at the thesis's 0.4 N s/m, [[ least | percent0 ]] at
        [[ at_least | f1 ]] N s/m and [[ most | percent0 ]] at [[ at_most | f1 ]] N s/m; chaos fills
        [[ chaos | percent0 ]] at 0.4 and [[ less_chaos | percent0 ]] at [[ end | f1 ]] N s/m.
    """).given(
        stated=single[stated],
        least=single.min(),
        at_least=numbers.second[single.argmin()],
        most=single.max(),
        at_most=numbers.second[single.argmax()],
        chaos=chaotic[stated],
        less_chaos=chaotic[-1],
        end=numbers.second[-1],
    )
    yield so(
        "shares of the rows of the map over gap and damping",
        single.min() < single[stated] < single.max() and chaotic[-1] < chaotic[stated],
    )
    yield so(
        "all natural modes of the linear trimmer decay",
        bool((np.real(known.numbers.displacement_only.poles()) < 0).all()),
    )


@observation("twin-question-3", source=MAPS, title="3. How does play influence stability and performance?")
def stability(known: Evidence) -> Observed:
    friction, starts = known.twin.friction, known.twin.starts
    chaotic = friction.shares["chaotic"]
    yield text("""
        A driven trimmer never rests, so the question is which motion it keeps. Play makes the drive's
        period unstable: it is left in [[ lost | percent0 ]] of the cells with play, mostly for chaos.
        Several motions may be stable at one gap and friction: in [[ several | percent0 ]] of [[ cells ]]
        cells eight starts led to more than one. The thesis answers that play does not alter the stability;
        of its linear part that is so.
    """).given(lost=float(1 - friction.single[:, 1:].mean()), several=starts.several, cells=starts.cells)
    yield so("most of the cells that leave it are chaotic", chaotic > 0.5 * (1 - friction.shares["one"]))
    yield so("eight starts in each cell of the coarser map", starts.kept.grid.starts == 8)


@observation(
    "twin-question-4", source=NUMBERS, title="4. How does friction influence stability and performance?"
)
def friction_(known: Evidence) -> Observed:
    numbers = known.twin
    first, last = numbers.no_gap[0], numbers.no_gap[-1]
    yield text("""
        It calms the play and is paid for. 40 µm need [[ small | f1 ]] N to repeat with the drive, 0.2 mm
        need [[ large | f1 ]] N. Without any play, friction from 0 to 4 N raises the motor's acceleration
        from [[ free | f1 ]] to [[ rubbing | f0 ]] m/s², lowers the stroke from [[ stroke | f2 ]] to
        [[ less | f2 ]] mm, and the blade loses [[ wear | f1 ]] W to it. It exchanges chaos for a stronger,
        regular vibration.
    """).given(
        small=numbers.friction_for_small_gap,
        large=numbers.friction_for_experiment,
        free=first.motor,
        rubbing=last.motor,
        stroke=1e3 * first.peak_to_peak,
        less=1e3 * last.peak_to_peak,
        wear=last.wear,
    )
    yield so(
        "motor's acceleration rises with each step",
        bool(np.all(np.diff([c.motor for c in numbers.no_gap]) > 0)),
    )
    yield so(
        "stroke falls with each step", bool(np.all(np.diff([c.peak_to_peak for c in numbers.no_gap]) < 0))
    )


@observation(
    "twin-question-5",
    source=NUMBERS,
    title="5. How do the input amplitude and the play influence stability and performance?",
)
def amplitude(known: Evidence) -> Observed:
    numbers = known.twin
    yield text("""
        Only their ratio counts, and that of friction to amplitude: with amplitude, gap and friction all
        times [[ scale ]] the motion is the same at that scale. A larger pin amplitude therefore acts like a
        smaller gap and less friction together. On the map over gap and friction it moves a design straight
        towards the origin, across the edges, and so can end a subharmonic or begin one.
    """).given(scale=SCALE)
    yield close(
        "stroke of 0.2 mm and 2 N, and of half of all three times two",
        numbers.scaled / SCALE,
        numbers.main.twin.peak_to_peak,
    )


@observation(
    "twin-question-6",
    source=MAPS,
    title="6. How does the input frequency influence stability and performance?",
)
def frequency(known: Evidence) -> Observed:
    speed = known.twin.speed
    column = speed.column(EXPERIMENT_GAP)
    calm = speed.second[speed.single[:, column]]
    yield text("""
        More than anything but the gap. With 0.5 N the gap up to which the drive's period lasts varies
        between [[ least | f0 ]] and [[ most | f0 ]] µm over 60 to 200 Hz. At 0.2 mm [[ count ]] of
        [[ all ]] speeds repeat with the drive, from [[ low | f0 ]] to [[ high | f0 ]] Hz. The thesis's
        answer, hardly any influence, speaks of its closed loop, which has no drive.
    """).given(
        least=1e6 * float(speed.reaches.min()),
        most=1e6 * float(speed.reaches.max()),
        count=len(calm),
        all=len(speed.second),
        low=float(calm.min()),
        high=float(calm.max()),
    )
    yield so(
        "reach of each row of the map over gap and speed",
        float(speed.reaches.max()) >= 10 * float(speed.reaches.min()) > 0,
    )


@observation(
    "twin-question-7", source=NUMBERS, title="7. How does the predicted limit cycle show in the output?"
)
def shown(known: Evidence) -> Observed:
    twin, cycle = known.twin.small.twin, known.cycles.friction.stable
    low, high = cycle.frequency, known.cycles.inertia.stable.frequency
    places = twin.lines[:, 0] * twin.frequency
    inside = (places >= low) & (places <= high)
    nearest, seventh = 7 * twin.frequency, twin.line(7)
    yield text("""
        Not at all. The thesis's loop predicts [[ predicted | f0 ]] µm at [[ low | f1 ]] Hz for 40 µm, and
        for other backlash up to [[ high | f1 ]] Hz. The twin at 40 µm and 0.5 N, driven at 110 Hz, has
        nothing but harmonics. None lies in that band; the nearest, the seventh at [[ nearest | f0 ]] Hz,
        has [[ seventh | f1 ]] µm. What two-way contact adds to the output are subharmonics and chaos, tied
        to the drive, not an oscillation at [[ low | f0 ]] Hz.
    """).given(
        predicted=1e6 * cycle.amplitude * twin.gap,
        low=low,
        high=high,
        nearest=nearest,
        seventh=1e6 * seventh,
    )
    yield so("no line of the exact motion lies in the band", low < high and not inside.any())
    yield so("the nearest is far smaller than predicted", seventh < 0.05 * cycle.amplitude * twin.gap)


SECTION = SectionRecord(
    "twin-questions",
    "The research questions, from the twin",
    (size, damping, stability, friction_, amplitude, frequency, shown),
)
