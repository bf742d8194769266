"""How far it is certain that no limit cycle is missing, as text for people and as JSON for machines."""

from trimmer.balance.limit_cycle import Certificate
from trimmer.command_line.json_values import picked


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
    """Return a certificate as entries of JSON, in SI units."""
    names = ("smallest_gain", "winding_number", "winding_omegas", "index_sum", "zero_on_axis", "doubts")
    return {
        **picked(certificate, "method", "omegas", "outside_excluded", "complete", "boxes"),
        "undecided": [picked(region, "amplitudes", "omegas") for region in certificate.undecided],
        **picked(certificate, *names),
    }


def _range(ends: tuple[float, float]) -> str:
    return f"{ends[0]:.9g} to {ends[1]:.9g}"
