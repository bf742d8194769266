"""The research questions of the thesis (section 1.3), its answers (chapter 7), and the answers now."""

from __future__ import annotations

from report.document.extras import Answer
from report.judging.text import one_line
from report.numbers.evidence import Evidence
from report.numbers.thesis import EXPERIMENT_GAP


def answers(known: Evidence) -> tuple[Answer, ...]:
    """Return the main question and the six that belong to it, with the numbers as solved."""
    cycles, error = known.cycles, known.orbits.friction.stable.amplitude_error
    unstable, stable = cycles.friction.unstable, cycles.friction.stable
    thesis, both = (
        branch.merger.force_per_gap
        for branch in (cycles.equivalent.in_place, cycles.equivalent.in_place_both_channels)
    )
    return (
        _answer(
            "How does the size of the play influence the limit cycles, and so the vibration?",
            r"""
            The amplitude grows in proportion to the play; below a play of about $2\times10^{-8}$ m there is
            no limit cycle.
            """,
            f"""
            The proportion is exact, and holds for every play: by harmonic balance the amplitude is
            {stable.amplitude:.2f} times the gap in the thesis's loop,
            {cycles.friction_both_channels.stable.amplitude:.2f} times with the pin's velocity, at a frequency
            that does not depend on the gap. There is no smallest play. The limit cycle belongs to a loop that
            feeds the output back to the pin. In a trimmer the motor moves the pin, and where play only passes
            the pin's displacement on, as in the thesis, the vibration repeats with the drive.
            """,
            ("txt-7-proportional", "txt-6-threshold", "txt-5.2.1-proportional", "lst-A.1"),
        ),
        _answer(
            "How does damping influence the linear stability?",
            """
            By chapter 7 damping raises the peaks at the resonances and leaves their frequencies, far below
            the operating one. By section 5.1.3 it lowers the peaks, and the frequencies lie far above.
            """,
            """
            Damping lowers the peaks; the frequencies hardly change. The trimmer is stable with any positive
            damping that reaches all modes. The resonances lie above the drive, where its harmonics meet them.
            """,
            ("txt-7-damping", "txt-7-operating-frequency"),
        ),
        _answer(
            "How does play influence stability and performance?",
            """
            Stability is not altered; unstable limit cycles, predicted for certain sizes of play, shift to the
            stable ones. Performance is altered: play adds oscillations, in proportion to its size.
            """,
            f"""
            Rest stays stable, but only against small disturbances: the unstable limit cycle is the boundary.
            In the closed loop a disturbance well below {unstable.amplitude:.2f} gaps dies out, a larger one
            grows to the oscillation of {stable.amplitude:.2f} gaps. Both exist for every gap, in proportion
            to it.
            """,
            ("txt-5.2.1-second-limit-cycle", "txt-5.2.3-unstable-inner", "txt-5.2.1-stable"),
        ),
        _answer(
            "How does friction influence stability and performance?",
            """
            Coulomb friction between cutter and guard suppresses the limit cycles of backlash; it is desired.
            """,
            f"""
            It does, although the thesis's equation 3.2 and its equivalent nonlinearity have friction with the
            wrong sign. By harmonic balance the limit cycle is gone when the force over the gap exceeds
            {thesis:.0f} N/m ({both:.0f} N/m with the pin's velocity): for 0.2 mm of play
            {thesis * EXPERIMENT_GAP:.1f} N ({both * EXPERIMENT_GAP:.1f} N). Friction also damps the modes
            that impacts excite.
            """,
            ("txt-7-coulomb", "eq-3.2", "txt-5.2.5-coulomb-term", "txt-3.3-friction-suppresses"),
        ),
        _answer(
            "How do input amplitude and play influence stability and performance?",
            "The input amplitude does not change the limit cycle.",
            """
            In the thesis's open loop there is no limit cycle to change. What is seen are harmonics of the
            drive: they depend on the ratio of the input amplitude to the gap, and tend to a multiple of the
            gap when the input is much larger. For wide strokes the thesis's answer therefore nearly holds.
            """,
            ("txt-7-input-amplitude", "txt-5.2.1-drive-amplitude"),
        ),
        _answer(
            "How does the input frequency influence stability and performance?",
            "Hardly, since stable limit cycles can only lie in the band from 733 to 815 Hz.",
            f"""
            It influences the limit cycle hardly or not at all, as the thesis says; but the band is
            {stable.frequency:.1f} to {cycles.inertia.stable.frequency:.1f} Hz. In open loop it decides which
            harmonics of the drive meet a resonance: near 110 Hz the fifth meets the mode of Listing A.1 at
            549.6 Hz.
            """,
            ("txt-7-input-frequency", "txt-5.2.3-band", "txt-5.1.3-first-resonance"),
        ),
        _answer(
            "How does the predicted limit cycle show in the output?",
            "As an oscillation on top of the driven one in open loop, and alone in the closed loop.",
            f"""
            In the closed loop it appears alone, as the thesis says; harmonic balance predicts its amplitude
            to {error:.1%}. In open loop it does not appear: a stable linear system behind play that only
            passes the pin's displacement on settles to the period of the drive. The peaks read as limit
            cycles are harmonics of the drive, natural modes that have not yet decayed, or, to judge by their
            numbers, peaks of a closed loop.
            """,
            ("txt-5.2.1-open-loop-peak", "txt-7-subharmonics", "txt-3.3-peak-550", "txt-3.3-peak-366"),
        ),
    )


def _answer(question: str, thesis: str, now: str, claims: tuple[str, ...]) -> Answer:
    return Answer(question, one_line(thesis), one_line(now), claims)
