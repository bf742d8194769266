"""Each prediction of the thesis beside harmonic balance done right, and the exact orbit."""

from __future__ import annotations

from collections.abc import Iterator

from report.document import CorrectedResult
from report.evidence import Evidence
from report.numbers.exact_orbits import ExactOrbits, OrbitPair, solve_orbits
from report.numbers.limit_cycle_numbers import Pair

GAP, LARGER_GAP = 4e-6, 4e-5
"""Gaps of section 5.2.1, m."""


def corrected_results(evidence: Evidence) -> tuple[CorrectedResult, ...]:
    """Return one row for each prediction, in the order of the thesis."""
    orbits = solve_orbits(evidence.numbers, evidence.cycles)
    return (
        *_friction(evidence, orbits),
        *_velocity(evidence, orbits),
        *_inertia(evidence, orbits),
        *_errors(evidence, orbits),
        *_with_friction(evidence),
    )


def _friction(evidence: Evidence, orbits: ExactOrbits) -> Iterator[CorrectedResult]:
    cycles, exact = evidence.cycles.friction, orbits.friction
    yield CorrectedResult(
        "txt-5.2.1-threshold",
        "smallest gap with a limit cycle",
        *("2e-8", "none", "none"),
        unit="m",
        remark="amplitude over gap is the same for every gap",
    )
    predicted = "txt-5.2.1-prediction"
    yield _amplitude(predicted, "stable, $b$ = $4\\times10^{-6}$ m", "3.3138e-5", GAP, cycles, exact)
    yield _frequency(predicted, "stable, any gap", "733.3", cycles, exact)
    second = "txt-5.2.1-second-limit-cycle"
    yield CorrectedResult(
        second,
        "amplitude, unstable, $b$ = $4\\times10^{-5}$ m",
        "2.1089e-5",
        f"{cycles.unstable.amplitude * LARGER_GAP:.5g}",
        f"{exact.unstable.amplitude * LARGER_GAP:.5g}",
        "m",
        "there for every gap, not only for larger ones",
    )
    yield CorrectedResult(
        second,
        "frequency, unstable, any gap",
        "533.22",
        f"{cycles.unstable.frequency:.2f}",
        f"{exact.unstable.frequency:.2f}",
        "Hz",
    )


def _velocity(evidence: Evidence, orbits: ExactOrbits) -> Iterator[CorrectedResult]:
    cycles, exact = evidence.cycles.friction_both_channels, orbits.friction_both_channels
    remark = "the thesis's loop leaves the pin's velocity out"
    yield _amplitude("lst-A.1", "stable, with the pin's velocity, per gap", "", 1.0, cycles, exact, remark)
    yield _frequency("lst-A.1", "stable, with the pin's velocity", "", cycles, exact, remark)


def _inertia(evidence: Evidence, orbits: ExactOrbits) -> Iterator[CorrectedResult]:
    cycles, exact = evidence.cycles.inertia, orbits.inertia
    low, exact_low = evidence.cycles.friction.stable, orbits.friction.stable
    prediction, figure = "txt-5.2.2-prediction", "fig-5.13"
    yield _frequency(prediction, "stable, inertia-controlled", "814.9", cycles, exact)
    yield _amplitude(prediction, "stable, inertia-controlled, per gap", "", 1.0, cycles, exact)
    yield CorrectedResult(
        figure,
        "frequency, unstable, inertia-controlled",
        "",
        f"{cycles.unstable.frequency:.1f}",
        f"{exact.unstable.frequency:.1f}",
        "Hz",
        f"missed by the thesis; {cycles.unstable.amplitude:.3f} and exactly "
        f"{exact.unstable.amplitude:.3f} gaps",
    )
    yield CorrectedResult(
        "txt-5.2.3-band",
        "band of stable limit cycles",
        "733 to 815",
        f"{low.frequency:.1f} to {cycles.stable.frequency:.1f}",
        f"{exact_low.frequency:.1f} to {exact.stable.frequency:.1f}",
        "Hz",
        "760 Hz, the example of equation 5.11, lies outside",
    )


def _errors(evidence: Evidence, orbits: ExactOrbits) -> Iterator[CorrectedResult]:
    friction, inertia = orbits.friction.stable, orbits.inertia.stable
    against = "error of harmonic balance against the exact orbit"
    for claim, quantity, printed, error in (
        ("txt-5.2.1-amplitude-error", "amplitude, friction-controlled", "0.4334", friction.amplitude_error),
        ("txt-5.2.1-frequency-error", "frequency, friction-controlled", "0.046", friction.frequency_error),
        ("txt-5.2.2-error", "frequency, inertia-controlled", "23.47", inertia.frequency_error),
    ):
        yield CorrectedResult(
            claim, f"error of the predicted {quantity}", printed, f"{100 * abs(error):.2g}", "0", "%", against
        )


def _with_friction(evidence: Evidence) -> Iterator[CorrectedResult]:
    merger = evidence.cycles.equivalent.in_place.merger
    yield CorrectedResult(
        "txt-5.2.5-prediction",
        "frequency with friction, $b$ = $4\\times10^{-6}$ m, $F_c$ = 0.6 N",
        "737.514",
        "none",
        "",
        "Hz",
        f"no limit cycle above $F_c/b$ = {merger.force_per_gap:.0f} N/m: "
        f"{merger.force_per_gap * GAP:.2g} N for this gap",
    )


def _amplitude(
    claim: str, quantity: str, printed: str, gap: float, cycles: Pair, exact: OrbitPair, remark: str = ""
) -> CorrectedResult:
    return CorrectedResult(
        claim,
        f"amplitude, {quantity}",
        printed,
        f"{cycles.stable.amplitude * gap:.5g}",
        f"{exact.stable.amplitude * gap:.5g}",
        "" if gap == 1.0 else "m",
        remark,
    )


def _frequency(
    claim: str, quantity: str, printed: str, cycles: Pair, exact: OrbitPair, remark: str = ""
) -> CorrectedResult:
    return CorrectedResult(
        claim,
        f"frequency, {quantity}",
        printed,
        f"{cycles.stable.frequency:.2f}",
        f"{exact.stable.frequency:.2f}",
        "Hz",
        remark,
    )
