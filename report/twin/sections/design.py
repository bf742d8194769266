"""What a designer should do, with numbers."""

from __future__ import annotations

from report.judging.parts import so
from report.judging.record import text
from report.numbers.evidence import Evidence
from report.numbers.thesis import EXPERIMENT_GAP
from report.numbers.twin.mechanism import SMALL_FORCE
from report.twin.figures.design import design_limits
from report.twin.observation import Observed, SectionRecord, observation

MAPS = "report/numbers/twin/map_numbers.py"
SOFT, STIFF = 10e3, 37.5e3
"""Stiffnesses of the bridge, N/m: the largest that bears every gap of the map, and where the limit falls."""
NOMINAL = 30e3
TIGHT, WIDE = 10e-6, 100e-6
"""Gaps between which a designer chooses, m."""


@observation("twin-do-gap", source=MAPS, title="Gap: well below 0.1 mm.")
def gap(known: Evidence) -> Observed:
    friction = known.twin.friction
    row = friction.row(SMALL_FORCE)
    motor, speed = friction.kept.measure("motor")[row], friction.kept.measure("impact_speed")[row]
    tight, wide, worn = (friction.column(each) for each in (TIGHT, WIDE, EXPERIMENT_GAP))
    yield text(f"""
        With 0.5 N at 110 Hz every gap up to {1e6 * friction.reach(SMALL_FORCE):.0f} µm repeats with the
        drive. The motor is calmest with {1e6 * TIGHT:.0f} µm, {motor[tight]:.0f} m/s² against {motor[0]:.0f}
        m/s² without play. At 0.1 mm it has {motor[wide]:.0f} m/s², and impacts reach
        {float(speed[: wide + 1].max()):.2f} m/s. Wear that opens the gap to 0.2 mm leads into chaos.
    """)
    yield so("row of the map at 0.5 N", friction.reach(SMALL_FORCE) >= WIDE)
    yield so("the smallest acceleration of that row is at this gap", int(motor.argmin()) == tight)
    yield so("the cell at 0.2 mm is chaotic", bool(friction.chaotic[row, worn]))


@observation("twin-do-friction", source=MAPS, title="Friction: some, not much.")
def friction_(known: Evidence) -> Observed:
    numbers = known.twin
    friction = numbers.friction
    at = friction.column(40e-6)
    low, high = friction.row(SMALL_FORCE), friction.row(4.0)
    motor, wear = friction.kept.measure("motor"), friction.kept.measure("wear")
    yield text(f"""
        About half a newton is enough for a gap of some 40 µm: {numbers.friction_for_small_gap:.1f} N suffice.
        More buys little gap and costs much. At 40 µm, 4 N instead of 0.5 N raise the motor's acceleration
        from {motor[low, at]:.0f} to {motor[high, at]:.0f} m/s² and the wear from {wear[low, at]:.2f} to
        {wear[high, at]:.1f} W, while the gap that is borne goes from {1e6 * friction.reach(SMALL_FORCE):.0f}
        to {1e6 * friction.reach(4.0):.0f} µm. Do not use friction against play of 0.2 mm: it takes
        {numbers.friction_for_experiment:.1f} N.
    """)
    yield so("acceleration doubles at least", motor[high, at] > 2 * motor[low, at])
    yield so(
        "the gap that is borne does not grow in proportion",
        friction.reach(4.0) < 3 * friction.reach(SMALL_FORCE),
    )


@observation("twin-do-stiffness", source=MAPS, title="Stiffness of the bridge: softer.")
def stiffness(known: Evidence) -> Observed:
    numbers = known.twin.stiffness
    soft, nominal = numbers.row(SOFT), numbers.row(NOMINAL)
    at = numbers.column(EXPERIMENT_GAP)
    motor, stroke = numbers.kept.measure("motor")[:, at], numbers.kept.measure("stroke")[:, at]
    stiffer = numbers.second >= STIFF
    least = 1e6 * float(numbers.reaches[stiffer].max())
    yield text(f"""
        With a bridge of {1e-3 * SOFT:.0f} kN/m or less, instead of 30 kN/m, every gap of the map up to 0.5 mm
        repeats with the drive at 110 Hz and 0.5 N. At 0.2 mm the motor then has {motor[soft]:.0f} instead of
        {motor[nominal]:.0f} m/s², and the stroke is {1e3 * stroke[soft]:.2f} mm,
        {1e3 * (stroke[soft] - 3e-3):.2f} mm more than the pin's own. From {1e-3 * STIFF:.1f} kN/m on, only
        gaps up to {least:.0f} µm are borne throughout. How a soft bridge cuts hair was not asked.
    """)
    yield so(
        "all cells up to 10 kN/m repeat with the drive",
        bool(numbers.single[numbers.second <= SOFT * (1 + 1e-9)].all()),
    )
    yield so("at the next stiffness of the map not all do", not numbers.single[soft + 1].all())
    yield so("at 30 kN/m and 0.2 mm the motion is chaotic", bool(numbers.chaotic[nominal, at]))


@observation(
    "twin-do-speed", source=MAPS, title="Speed: choose it with the gap, and do not trust a single value."
)
def speed(known: Evidence) -> Observed:
    numbers = known.twin.speed
    inside = (numbers.second >= 146.0) & (numbers.second <= 164.0)
    around = (numbers.second >= 96.0) & (numbers.second <= 108.0)
    slower, nominal = numbers.reach(108.0), numbers.reach(110.0)
    calm = 1e6 * float(numbers.reaches[inside].min())
    rough = 1e6 * float(numbers.reaches[around].max())
    yield text(f"""
        With 0.5 N, drives of 146 to 164 Hz bear gaps up to {calm:.0f} µm at the least, those of 96 to 108 Hz
        no more than {rough:.0f} µm at the best. 110 Hz lies beside that rough band: a motor that runs 2 Hz
        slower bears {1e6 * slower:.0f} µm instead of {1e6 * nominal:.0f} µm.
    """)
    yield so(
        "the worst of the one band bears more than the best of the other",
        float(numbers.reaches[inside].min()) > float(numbers.reaches[around].max()),
    )
    yield so("108 Hz bears less than 110 Hz", slower < nominal)


SECTION = SectionRecord("twin-design", "For the designer", (design_limits, gap, friction_, stiffness, speed))
