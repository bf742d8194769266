"""Each prediction of the thesis beside harmonic balance done right, and the exact orbit."""

from collections.abc import Iterator

from report.document.extras import CorrectedResult
from report.numbers.evidence import Evidence
from report.numbers.exact_orbits import OrbitPair
from report.numbers.limit_cycle_numbers import Pair
from report.numbers.thesis import LARGE_GAP, SMALL_GAP


def corrected_results(known: Evidence) -> tuple[CorrectedResult, ...]:
    """Return one row for each prediction, in the order of the thesis."""
    return (
        *_friction(known.cycles.friction, known.orbits.friction),
        *_velocity(known.cycles.friction_both_channels, known.orbits.friction_both_channels),
        *_inertia(known),
        *_errors(known),
        _with_friction(known.cycles.equivalent.in_place.merger.force_per_gap),
    )


def _friction(cycles: Pair, exact: OrbitPair) -> Iterator[CorrectedResult]:
    threshold, remark = "smallest gap with a limit cycle", "amplitude over gap is the same for every gap"
    yield CorrectedResult("txt-5.2.1-threshold", threshold, "2e-8", "none", "none", "m", remark)
    stable = r"stable, $b$ = $4\times10^{-6}$ m"
    yield _amplitude("txt-5.2.1-prediction", stable, "3.3138e-5", SMALL_GAP, cycles, exact)
    yield _frequency("txt-5.2.1-prediction", "stable, any gap", "733.3", cycles, exact)
    yield CorrectedResult(
        "txt-5.2.1-second-limit-cycle",
        r"amplitude, unstable, $b$ = $4\times10^{-5}$ m",
        "2.1089e-5",
        f"{cycles.unstable.amplitude * LARGE_GAP:.5g}",
        f"{exact.unstable.amplitude * LARGE_GAP:.5g}",
        "m",
        "there for every gap, not only for larger ones",
    )
    yield CorrectedResult(
        "txt-5.2.1-second-limit-cycle",
        "frequency, unstable, any gap",
        "533.22",
        f"{cycles.unstable.frequency:.2f}",
        f"{exact.unstable.frequency:.2f}",
        "Hz",
    )


def _velocity(cycles: Pair, exact: OrbitPair) -> Iterator[CorrectedResult]:
    stable, remark = "stable, with the pin's velocity", "the thesis's loop leaves the pin's velocity out"
    yield _amplitude("lst-A.1", f"{stable}, per gap", "", 1.0, cycles, exact, remark)
    yield _frequency("lst-A.1", stable, "", cycles, exact, remark)


def _inertia(known: Evidence) -> Iterator[CorrectedResult]:
    cycles, exact = known.cycles.inertia, known.orbits.inertia
    low, exact_low = known.cycles.friction.stable.frequency, known.orbits.friction.stable.frequency
    missed = f"{cycles.unstable.amplitude:.3f} and exactly {exact.unstable.amplitude:.3f} gaps"
    stable = "stable, inertia-controlled"
    yield _frequency("txt-5.2.2-prediction", stable, "814.9", cycles, exact)
    yield _amplitude("txt-5.2.2-prediction", f"{stable}, per gap", "", 1.0, cycles, exact)
    yield CorrectedResult(
        "fig-5.13",
        "frequency, unstable, inertia-controlled",
        "",
        f"{cycles.unstable.frequency:.1f}",
        f"{exact.unstable.frequency:.1f}",
        "Hz",
        f"missed by the thesis; {missed}",
    )
    yield CorrectedResult(
        "txt-5.2.3-band",
        "band of stable limit cycles",
        "733 to 815",
        f"{low:.1f} to {cycles.stable.frequency:.1f}",
        f"{exact_low:.1f} to {exact.stable.frequency:.1f}",
        "Hz",
        "760 Hz, the example of equation 5.11, lies outside",
    )


def _errors(known: Evidence) -> Iterator[CorrectedResult]:
    friction, inertia = known.orbits.friction.stable, known.orbits.inertia.stable
    for claim, quantity, printed, error, remark in (
        (
            "txt-5.2.1-amplitude-error",
            "amplitude, friction-controlled",
            "0.4334",
            friction.amplitude_error,
            "printed: right, against the simulation of section 5.2.1; here: against the exact orbit",
        ),
        (
            "txt-5.2.1-frequency-error",
            "frequency, friction-controlled",
            "0.046",
            friction.frequency_error,
            "printed: another number than its own quotient gives; here: against the exact orbit",
        ),
        (
            "txt-5.2.2-error",
            "frequency, inertia-controlled",
            "23.47",
            inertia.frequency_error,
            "printed: right, against a peak that is no limit cycle; here: against the exact orbit",
        ),
    ):
        predicted = f"error of the predicted {quantity}"
        yield CorrectedResult(claim, predicted, printed, f"{100 * abs(error):.2g}", "0", "%", remark)


def _with_friction(force_per_gap: float) -> CorrectedResult:
    force = force_per_gap * SMALL_GAP
    remark = f"no limit cycle above $F_c/b$ = {force_per_gap:.0f} N/m: {force:.2g} N for this gap"
    quantity = r"frequency with friction, $b$ = $4\times10^{-6}$ m, $F_c$ = 0.6 N"
    return CorrectedResult("txt-5.2.5-prediction", quantity, "737.514", "none", "", "Hz", remark)


def _amplitude(
    claim: str, quantity: str, printed: str, gap: float, cycles: Pair, exact: OrbitPair, remark: str = ""
) -> CorrectedResult:
    balance, orbit = (f"{each.stable.amplitude * gap:.5g}" for each in (cycles, exact))
    unit = "" if gap == 1.0 else "m"
    return CorrectedResult(claim, f"amplitude, {quantity}", printed, balance, orbit, unit, remark)


def _frequency(
    claim: str, quantity: str, printed: str, cycles: Pair, exact: OrbitPair, remark: str = ""
) -> CorrectedResult:
    balance, orbit = (f"{each.stable.frequency:.2f}" for each in (cycles, exact))
    return CorrectedResult(claim, f"frequency, {quantity}", printed, balance, orbit, "Hz", remark)
