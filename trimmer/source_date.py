"""The time at which things are made, if the environment sets it (https://reproducible-builds.org)."""

import os
from datetime import UTC, datetime

from trimmer.errors import TrimmerError

EPOCH = "SOURCE_DATE_EPOCH"
"""Environment variable with the time at which things are made, s since 1970, so that they are made alike."""


class DateError(TrimmerError):
    """The environment names no date."""


def source_date() -> datetime | None:
    """Return the time that ``SOURCE_DATE_EPOCH`` sets, UTC; None where it is not set, or empty."""
    given = os.environ.get(EPOCH)
    if not given:
        return None
    try:
        if not given.isascii() or not given.isdecimal():
            raise ValueError
        return datetime.fromtimestamp(int(given), UTC)
    except (ValueError, OverflowError, OSError):
        raise DateError(
            f"{EPOCH}={given[:40]!r} in the environment is no date: give seconds since 1970, or unset it"
        ) from None


def check_source_date() -> None:
    """Check the date of the environment for libraries, some of which end at a wrong or an empty one."""
    if source_date() is None:
        os.environ.pop(EPOCH, None)
