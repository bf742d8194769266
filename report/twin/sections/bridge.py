"""Where the bridge that stays where it was left fails, and by how much."""

from __future__ import annotations

from report.judging.parts import close, small, so
from report.judging.record import text
from report.numbers.evidence import Evidence
from report.numbers.twin.mechanism import FREQUENCY
from report.twin.figures.bridge import bridge_in_slot
from report.twin.observation import Observed, SectionRecord, observation

FROZEN = "report/numbers/twin/frozen_bridge.py"
SETTLED = 1e-6
"""Largest change from one period to the next that counts as none."""

CHAOTIC_SHARE = (0.35, 0.40)
"""Share of the time on the other side at 0.2 mm and 0.5 N; means of 220 drive periods differ by 0.003."""
CHAOTIC_ACCELERATION = (67.0, 78.0)
"""Root mean square of the motor's acceleration there, m/s²; such means differ by 1.3."""
TIMES = 3
"""How many times as much the thesis's bridge shakes the motor there, at least."""


def _between(value: float, limits: tuple[float, float]) -> bool:
    return limits[0] < value < limits[1]


@observation("twin-models", source="report/numbers/twin/mechanism.py", title="The two models.")
def models(known: Evidence) -> Observed:
    twin = known.twin
    yield text(f"""
        The thesis puts the play before a linear trimmer. Its bridge follows the pin or stays where it was
        left, whatever force that takes. In the twin the bridge is a spring and a damper behind a slot: it can
        push on either side and never pull, and what it pushes with acts on the motor as well. Both models
        have the parameters of Listing A.1 (not those of the measured trimmer), 1.5 mm at the pin, and dry
        friction between cutter and guard. Without play and friction they are one linear trimmer: the stroke
        is {1e3 * twin.no_gap[0].peak_to_peak:.4f} mm peak to peak at {FREQUENCY:.0f} Hz in both.
    """)
    yield close(
        "the stroke of the twin without play and friction is that of the linear trimmer's frequency response",
        twin.no_gap[0].peak_to_peak,
        twin.linear_stroke,
    )


@observation("twin-pull", source=FROZEN, title="What the thesis's bridge would need.")
def pull(known: Evidence) -> Observed:
    small_gap, large = known.twin.small.frozen, known.twin.experiment.frozen
    yield text(f"""
        At 40 µm and 0.5 N, driven at 110 Hz, the pin of the thesis's model would have to pull the bridge in
        {small_gap.share_pulled:.0%} of the period, with up to {small_gap.largest_pull:.1f} N. While the
        bridge stands still in its slot, {small_gap.share_standing:.0%} of the period, something would have to
        hold it against up to {small_gap.holding:.1f} N. At 0.2 mm and 0.5 N these forces are
        {large.largest_pull:.1f} N and {large.holding:.1f} N. The only dry friction of the trimmer is 0.5 N
        and rubs elsewhere, between blade and guard.
    """)
    yield so(
        "the force of the bridge's spring and damper, split by whether the bridge moves: it exceeds the "
        "friction in both cases",
        min(small_gap.holding, large.holding) > small_gap.force,
    )
    yield small("the motion has settled", max(small_gap.repeat, large.repeat), SETTLED)
    yield close(
        "the share of standing is that of the pin's way back through the gap",
        small_gap.share_standing,
        small_gap.share_on_the_way,
        1e-2,
    )


@observation("twin-side", source="report/numbers/twin_numbers.py", title="Where the bridge is.")
def side(known: Evidence) -> Observed:
    numbers = known.twin
    shares = [each.other_side for each in (numbers.small, numbers.experiment, numbers.main)]
    yield text(f"""
        The two bridges lie on different sides of the pin for {shares[0]:.0%} of the time at 40 µm and 0.5 N,
        for {CHAOTIC_SHARE[0]:.0%} to {CHAOTIC_SHARE[1]:.0%} at 0.2 mm and 0.5 N, and for {shares[2]:.0%} at
        0.2 mm and 2 N: they are then apart by up to the whole gap. In the thesis's model the
        bridge changes sides when the pin turns round, in the twin when the force changes its sign.
    """)
    yield so(
        "bridge relative to motor in both models, at one phase of the pin, until the motion repeats or over "
        "220 drive periods: further apart than half of the gap",
        tuple(0 < share < 1 for share in shares),
    )
    yield so("the chaotic motion's share, over 220 drive periods", _between(shares[1], CHAOTIC_SHARE))


@observation("twin-reaction", source="report/numbers/twin/cases.py", title="What the motor feels.")
def reaction(known: Evidence) -> Observed:
    numbers = known.twin
    small_gap, large, rubbing = (
        (each.frozen.motor_acceleration, each.twin.motor)
        for each in (numbers.small, numbers.experiment, numbers.main)
    )
    yield text(f"""
        The motor's acceleration (root mean square) is {small_gap[0]:.0f} m/s² in the thesis's model and
        {small_gap[1]:.0f} m/s² in the twin at 40 µm and 0.5 N; {large[0]:.0f} and
        {CHAOTIC_ACCELERATION[0]:.0f} to {CHAOTIC_ACCELERATION[1]:.0f} m/s² at 0.2 mm and 0.5 N;
        {rubbing[0]:.0f} and {rubbing[1]:.0f} m/s² at 0.2 mm and 2 N. In the second case the thesis's bridge,
        which can pull and stays put, shakes the motor more than {TIMES:.0f} times as much as one that can
        only push.
    """)
    yield so(
        "accelerations from the forces on the motor in one model and over the exact motion in the other",
        (large[0] > TIMES * large[1], small_gap[0] > small_gap[1]),
    )
    yield so("the chaotic motion's mean over 220 drive periods", _between(large[1], CHAOTIC_ACCELERATION))


SECTION = SectionRecord(
    "twin-bridge", "Where the thesis's bridge fails", (models, pull, side, bridge_in_slot, reaction)
)
