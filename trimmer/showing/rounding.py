"""Numbers that may be nothing but rounding, which another processor does otherwise."""

SMALLEST = 1e-12
"""Share of one below which a multiplier, or what a balance is off by, is a bound and not a number."""


def or_rounding(share: float, form: str) -> str:
    """Return a share in a form, or ``less than 1e-12``."""
    return format(share, form) if abs(share) >= SMALLEST else f"less than {SMALLEST:g}"
