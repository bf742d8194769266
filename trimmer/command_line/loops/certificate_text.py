"""How far it is certain that no limit cycle is missing, as text for people and as JSON for machines."""

from __future__ import annotations

from trimmer.balance.limit_cycle import Certificate, UndecidedRegion
from trimmer.command_line.json_values import finite


def certificate_as_text(certificate: Certificate) -> list[str]:
    """Return lines on the range that was searched, rad/s, and on the regions that are undecided."""
    lowest, highest = certificate.omegas
    others = "none is missing there" if certificate.complete else "there may be others"
    outside = "; none exist outside" if certificate.outside_excluded else ""
    return [
        f"searched from {lowest:.6g} to {highest:.6g} rad/s: {others}{outside}",
        *(
            f"undecided: {_range(region.omegas)} rad/s, amplitude {_range(region.amplitudes)}"
            for region in certificate.undecided
        ),
        *certificate.other_doubts,
    ]


def certificate_as_json(certificate: Certificate) -> dict[str, object]:
    """Return a certificate as entries of JSON, in SI units; what is infinite is null."""
    return {
        "method": certificate.method,
        "omegas": certificate.omegas,
        "outside_excluded": certificate.outside_excluded,
        "complete": certificate.complete,
        "boxes": certificate.boxes,
        "undecided": [_region(region) for region in certificate.undecided],
        "smallest_gain": certificate.smallest_gain,
        "winding_number": certificate.winding_number,
        "winding_omegas": certificate.winding_omegas,
        "index_sum": certificate.index_sum,
        "zero_on_axis": certificate.zero_on_axis,
        "doubts": certificate.doubts,
    }


def _region(region: UndecidedRegion) -> dict[str, list[float | None]]:
    return {
        "amplitudes": [finite(end) for end in region.amplitudes],
        "omegas": [finite(end) for end in region.omegas],
    }


def _range(ends: tuple[float, float]) -> str:
    return f"{ends[0]:.9g} to {ends[1]:.9g}"
