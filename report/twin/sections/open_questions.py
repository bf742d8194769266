"""What stays open."""

from __future__ import annotations

from report.judging.parts import so
from report.judging.record import text
from report.numbers.evidence import Evidence
from report.twin.observation import Observed, SectionRecord, observation

MAPS = "report/numbers/twin/map_numbers.py"
FEW = 0.1


@observation("twin-open-cells", source=MAPS, title="Cells without an answer.")
def cells(known: Evidence) -> Observed:
    friction, speed = known.twin.friction, known.twin.speed
    yield text(f"""
        {friction.shares["open"]:.1%} of the cells over gap and friction and {speed.shares["open"]:.1%} of
        those over gap and speed had not settled within 300 drive periods, and no kind could be told. In
        {friction.by_rounding:.1%} and {speed.by_rounding:.1%} of all cells a start one nanometre beside rest
        led to another motion: there the map shows one of several, and another computer may show another.
        Torus and chaos are told apart by one neighbour over 100 drive periods, which may err near an edge.
    """)
    yield so(
        "each of these is less than a tenth of the cells",
        max(friction.shares["open"], speed.shares["open"], friction.by_rounding, speed.by_rounding) < FEW,
    )


@observation("twin-open-starts", source=MAPS, title="Other starts.")
def starts(known: Evidence) -> Observed:
    numbers = known.twin.starts
    single = numbers.single
    beside = float((numbers.kept.motion_count[single] > 1).mean())
    yield text(f"""
        The maps begin at rest. On a coarser grid of {numbers.cells} cells, eight starts led to more than one
        motion in {numbers.several:.0%} of all cells and in {beside:.0%} of those that keep the drive's period
        from rest (mirror images count as two). A jolt may therefore leave a trimmer in another motion than
        the maps show. Eight starts do not find all there are.
    """)
    yield so("motions told apart by their exact orbits, of others by kind", min(beside, numbers.several) > 0)


@observation("twin-open-parameters", source="report/numbers/twin/mechanism.py", title="The machine itself.")
def parameters(known: Evidence) -> Observed:
    friction = known.twin.small.frozen.force
    yield text(f"""
        All numbers are of the parameters of Listing A.1, one contact damping (the 0.4 N s/m of the bridge)
        and dry friction between blade and guard alone, {friction} N where one value had to be chosen. The
        parameters of the measured trimmer are not published, nor is its friction. Static friction above the
        kinetic one, hair between the blades, play in the motor's bearing and motion across the line are not
        modelled.
    """)
    yield so(
        "static and kinetic friction of the twin are the same",
        known.twin.friction.kept.grid.mechanism.frictions["blade"].static_force == friction,
    )


SECTION = SectionRecord("twin-open", "What stays open", (cells, starts, parameters))
