"""Claims of section 6.3, on whether friction holds the driving bridge, and of 6.4, on the gap it quotes."""

from report.judging.comparisons.printed import power
from report.judging.parts import assertion, close
from report.judging.record import Record, claim, text
from report.numbers.evidence import Evidence
from report.numbers.independent.load_in_play import LetGoLoad
from report.numbers.thesis import DRIVE_AMPLITUDE, DRIVE_FREQUENCY, DRIVE_OMEGA, EXPERIMENT_GAP, LARGE_GAP

LARGEST_FORCE = 1.0  # Bound of the Coulomb force in sections 3.3, 5.2.4 and 5.2.5, N
GAPS_QUOTED = {
    "section 3.2": "200e-6",
    "the simulation of it in section 3.3": "200e-6",
    "chapter 6": "200e-6",
    "section 6.4": "100e-6",
}
"""Gap of the experiment, or of the model that is held against it, m."""
DOMINANT = "friction dominates: backlash in the trimmer is friction-controlled"


@claim("txt-6.3-friction-dominates")
def dominant_friction(known: Evidence) -> Record:
    mass = known.numbers.parameters.m2
    load = LetGoLoad(DRIVE_AMPLITUDE, DRIVE_OMEGA, LARGEST_FORCE / mass)
    needed, ahead = mass * DRIVE_AMPLITUDE * DRIVE_OMEGA**2, load.ahead()
    sampled = mass * load.largest_acceleration()
    yield assertion(
        "force that holds the load when the pin turns back",
        "friction exceeds the load's inertia, so that the load stops with the pin",
        needed < LARGEST_FORCE,
        rf"""
        $m_2A\omega^2$ is {needed:.2f} N under the drive, {1e3 * mass:.0f} g at {1e3 * DRIVE_AMPLITUDE:.1f} mm
        and {DRIVE_FREQUENCY:.0f} Hz; friction is assumed below {LARGEST_FORCE:.1f} N
        """,
        method="the thesis's mass, drive and bound of the force",
        second=close("second differences of the pin's sampled motion", sampled, needed, 1e-5),
        item=DOMINANT,
    )
    yield assertion(
        "the load with as much friction, let go by the pin",
        "it stays within the gap until the pin comes back for it",
        ahead < EXPERIMENT_GAP,
        f"""
        it would run {1e3 * ahead:.2f} mm ahead of the pin before it stops, so it crosses the gap of
        {1e6 * LARGE_GAP:.0f} µm, and one of {1e6 * EXPERIMENT_GAP:.0f} µm too
        """,
        method="deceleration by a constant force, beside the pin's sine",
        second=close("SciPy's integration of the flight", load.ahead_by_integration(), ahead, 1e-6),
        item=DOMINANT,
    )
    cycle, heavy = known.cycles.friction.stable, known.cycles.inertia.stable
    inertia = mass * LARGE_GAP * cycle.amplitude * cycle.omega**2
    smaller = 100 * (1 - heavy.amplitude / cycle.amplitude)
    yield text(f"""
        Sections 2.3.4, 5.2.1 and 6.3 take friction for dominant because the spring presses hard; none gives a
        number, and 6.3 says that there is no evidence. With the mass of Listing A.1, the drive and the bound
        on friction that the thesis itself states, the load's inertia is the larger force; at the predicted
        limit cycle for {1e6 * LARGE_GAP:.0f} µm it is {inertia:.0f} N. So neither limit holds; the general
        backlash is the one to use.

        The recommendation of chapter 7 may have been made for convenience, not for a physical reason. The
        predicted frequency lies at {cycle.frequency:.1f} Hz with friction alone and at {heavy.frequency:.1f}
        Hz with inertia alone, where the amplitude is {smaller:.0f} % smaller.
    """)


@claim("txt-6-gap-quoted")
def gap_of_the_experiment(_: Evidence) -> Record:
    yield assertion(
        "",
        "the gap of the experiment, and of the model held against it, is quoted alike everywhere",
        len(set(GAPS_QUOTED.values())) == 1,
        ", ".join(f"{power(gap)} m in {place}" for place, gap in GAPS_QUOTED.items()),
        method="read in the four places",
    )
    yield text("""
        For the model that was held against the experiment section 6.4 gives half of the gap that section 3.3
        gives. Read as a slip, or as a further run that is not shown, it changes nothing. One may also be the
        total gap and the other half of it, which neither place says.

        By the last reading an amplitude predicted for the experiment is uncertain by a factor of two.
    """)
