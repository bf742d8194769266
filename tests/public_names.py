"""All public names, those at the top of ``trimmer`` and those in its rooms."""

from typing import Any

import trimmer


def public_names() -> dict[str, Any]:
    """Return what stands under each name."""
    at_the_top = {name: getattr(trimmer, name) for name in trimmer.__all__ if name != "__version__"}
    rooms = [getattr(trimmer, room) for room in trimmer.ROOMS]
    return {name: getattr(room, name) for room in rooms for name in room.__all__} | at_the_top
