"""Claims of the opening of chapter 6, before section 6.1."""

from __future__ import annotations

from report.chapters.second_ways import by_grid
from report.claim import Impact
from report.evidence import Evidence
from report.parts import digits, made_here
from report.record import Record, claim, text
from trimmer import real_axis_crossings


@claim("txt-6-every-case", source="trimmer/balance/solve.py", impact=Impact.LOCAL)
def every_case(known: Evidence) -> Record:
    system = known.numbers.displacement_only
    relay = sum(crossing.value < 0 for crossing in real_axis_crossings(system))
    with_play = min(2, *(len(found) for found in known.cycles.viscous))
    yield digits(
        "least number of limit cycles over the elements",
        "1",
        min(with_play, relay),
        second=by_grid(system, relay),
        slip=made_here("Coulomb friction is left out", with_play),
    )
    yield text("""
        Friction- and inertia-controlled backlash have two limit cycles each, viscous-controlled one or two,
        by its $M/D$. Coulomb friction alone, the fourth case of chapter 5, has none, as section 5.2.4 says
        itself. That two occur under strict conditions only is not so either: they do for every gap.

        Chapter 7 repeats it: all models showed a stable limit cycle.
    """)
