"""Gap and friction, gap and speed: which motion where."""

from __future__ import annotations

from report.judging.parts import close, equal, so
from report.judging.record import text
from report.numbers.evidence import Evidence
from report.numbers.thesis import EXPERIMENT_GAP
from report.numbers.twin.grids import WAITED
from report.numbers.twin.map_numbers import MapNumbers
from report.numbers.twin.mechanism import SMALL_FORCE
from report.twin.figures.maps import friction_map, speed_map
from report.twin.observation import Observed, SectionRecord, observation

NUMBERS = "report/numbers/twin/map_numbers.py"
NARROW = 100e-6
"""Gap up to which the drive's period prevails, m."""
LARGEST_FORCE = 4.0
CALM = (146.0, 164.0)
"""Band of speeds in which the motion stays regular up to larger gaps, Hz."""
CALM_GAP = 180e-6


@observation("twin-shares", source=NUMBERS, title="Gap and friction.")
def shares(known: Evidence) -> Observed:
    friction = known.twin.friction
    found = friction.shares
    yield text(f"""
        From rest at 110 Hz, over gaps up to 0.5 mm and frictions up to 4 N, {found["one"]:.0%} of
        {friction.cells} cells repeat with the drive and {found["three"]:.0%} after three drive periods;
        {found["other"]:.0%} repeat after other numbers, {found["torus"]:.0%} are tori,
        {found["chaotic"]:.0%} are chaotic, and {found["open"]:.0%} had not settled within {WAITED} drive
        periods.
    """)
    yield close("the shares add up to the whole", sum(found.values()), 1.0)
    yield so(
        "most cells are chaotic, and those with the drive's period come next",
        found["chaotic"] > found["one"] > max(found["three"], found["other"], found["torus"], found["open"]),
    )


@observation("twin-reach", source=NUMBERS, title="How large a gap may be, at 110 Hz.")
def reach(known: Evidence) -> Observed:
    friction = known.twin.friction
    narrow = friction.within((0.0, NARROW), (SMALL_FORCE, LARGEST_FORCE))
    others = int((narrow & ~friction.single).sum())
    yield text(f"""
        At 110 Hz, up to 0.1 mm and with 0.5 N or more, the motion repeats with the drive in all but {others}
        of {int(narrow.sum())} cells: at {1e6 * _doubled(friction)[0]:.0f} and
        {1e6 * _doubled(friction)[-1]:.0f} µm with 0.6 N it takes two drive periods, and at 20 µm with 1.6 and
        1.7 N it is a torus. Without friction the second smallest gap of the map,
        {1e6 * float(friction.first[1]):.0f} µm, is chaotic already. For 40 µm it takes
        {known.twin.friction_for_small_gap:.1f} N or more, for 0.2 mm
        {known.twin.friction_for_experiment:.1f} N: friction below 1 N does not bring 0.2 mm to the drive's
        period. What holds over a range of speeds stands [with the advice](#twin-design).
    """)
    yield so("these are few, and they are those named", others == len(_doubled(friction)) + _tori(friction))
    yield so("the cell without friction is chaotic", bool(friction.chaotic[0, 1]))
    below = friction.within((EXPERIMENT_GAP, EXPERIMENT_GAP), (0.0, 1.0))
    yield so("no cell at 0.2 mm up to 1 N repeats with the drive", not friction.single[below].any())


def _doubled(friction: MapNumbers) -> tuple[float, ...]:
    """Return the gaps up to ``NARROW`` at which 0.6 N gives two drive periods, m."""
    row = friction.row(0.6)
    cells = friction.within((0.0, NARROW), (0.6, 0.6))[row] & (friction.kept.period_count[row] == 2)
    return tuple(friction.first[cells].tolist())


def _tori(friction: MapNumbers) -> int:
    """Return the number of tori at 20 µm with 1.6 and 1.7 N."""
    cells = friction.within((20e-6, 20e-6), (1.6, 1.7))
    return int((friction.kept.kind[cells] == "t").sum())


@observation("twin-speed", source=NUMBERS, title="Gap and speed.")
def speed(known: Evidence) -> Observed:
    numbers = known.twin.speed
    calm = numbers.within((0.0, CALM_GAP), CALM)
    at_drive, slower, faster = (1e6 * numbers.reach(each) for each in (110.0, 100.0, 120.0))
    yield text(f"""
        With 0.5 N, over drives from 60 to 200 Hz, {numbers.shares["one"]:.0%} of {numbers.cells} cells repeat
        with the drive and {numbers.shares["chaotic"]:.0%} are chaotic. The gap up to which the drive's period
        lasts is {slower:.0f} µm at 100 Hz, {at_drive:.0f} µm at 110 Hz and {faster:.0f} µm at 120 Hz: the
        edge is ragged, and 10 Hz make a difference. One band is calm: from 146 to 164 Hz all
        {int(calm.sum())} cells up to 0.18 mm repeat with the drive. At 74 Hz all gaps up to 0.5 mm do, but
        not at 72 or 76 Hz, so nobody should aim at it. Gaps up to {1e6 * numbers.common_reach:.0f} µm repeat
        with the drive at all speeds.
    """)
    yield so("every cell of the band repeats with the drive", tuple(numbers.single[calm]))
    yield so(
        "at 74 Hz every cell does, at 72 and 76 Hz not",
        numbers.reach(74.0) == numbers.first[-1] > max(numbers.reach(72.0), numbers.reach(76.0)),
    )
    yield so("the cells beside 110 Hz reach less far or as far", at_drive > slower)


@observation("twin-impacts", source=NUMBERS, title="Impacts.")
def impacts(known: Evidence) -> Observed:
    friction, speeds = known.twin.friction, known.twin.speed
    free = friction.within((0.0, friction.first[-1]), (0.0, 0.0))
    yield text(f"""
        At 110 Hz pin and bridge meet at up to {friction.largest("impact_speed", free):.2f} m/s where there is
        no friction, and at up to {friction.largest("impact_speed"):.2f} m/s over all gaps and frictions of
        the map. Over all speeds, with 0.5 N, it is up to {speeds.largest("impact_speed"):.2f} m/s.
    """)
    yield so(
        "largest speed of an impact in each cell of both maps",
        friction.largest("impact_speed") > 1.5 * friction.largest("impact_speed", free),
    )
    yield equal(
        "the map over speed has 0.5 N", speeds.kept.grid.mechanism.frictions["blade"].force, SMALL_FORCE
    )


SECTION = SectionRecord(
    "twin-maps", "Which motion where", (shares, reach, friction_map, speed, speed_map, impacts)
)
