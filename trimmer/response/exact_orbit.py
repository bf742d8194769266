"""The exact periodic motion of a mechanism or a loop; ``trimmer.orbits.forced_orbit`` is the entry."""

from __future__ import annotations

from typing import TYPE_CHECKING

from trimmer.arguments import whole_number
from trimmer.errors import UnsupportedMotionError
from trimmer.mechanism.mechanism import Mechanism
from trimmer.response.flows import known_flow_of

if TYPE_CHECKING:
    from trimmer.motion.flow import Flow
    from trimmer.motion.subject import Subject
    from trimmer.response.periodic.orbit import Orbit
    from trimmer.response.starts import Start

SETTLING = (8, 64, 512)  # Drive periods from rest after which Newton's method is tried, one after the other


def exact_orbit(
    subject: Subject, periods: int = 1, guess: Start = None, settling: int | None = None
) -> Orbit:
    """Find an exact periodic motion of a mechanism or a loop; see ``trimmer.orbits.forced_orbit``."""
    from trimmer.response.by_itself.orbit_by_itself import orbit_by_itself, self_excited_orbit
    from trimmer.response.starts import instant_of

    whole_number("periods", periods, 1)
    if settling is not None:
        whole_number("settling", settling, 0)
    flow = known_flow_of(subject)
    require_repeating(flow)
    if not flow.period:
        if periods > 1:
            raise ValueError(
                f"periods is {periods}, but the mechanism has no drive whose periods could count"
            )
        found = orbit_by_itself(flow) if guess is None else self_excited_orbit(flow, instant_of(flow, guess))
        return found
    return _driven(flow, periods, guess, settling)


def _driven(flow: Flow, periods: int, guess: Start, settling: int | None) -> Orbit:
    from trimmer.errors import OrbitNotFoundError
    from trimmer.hybrid.stretch import Ending
    from trimmer.mechanism.drives import RETURNS, told_of_drives
    from trimmer.response.periodic.orbit import orbit_of
    from trimmer.response.periodic.pace import periods_of
    from trimmer.response.periodic.shooting import Return, solve
    from trimmer.response.starts import instant_of

    together = flow.modes.system.layout.recurrence
    if not together:
        raise OrbitNotFoundError(f"nothing repeats: {told_of_drives(RETURNS)}")
    if periods % together:
        raise OrbitNotFoundError(
            f"nothing repeats after {periods_of(flow.subject, periods)}: its drives return together "
            f"after {together}, so give a multiple of that"
        )
    instant, followed, orbit = instant_of(flow, guess), 0, None
    waits = (settling,) if settling is not None else SETTLING if guess is None else (0,)
    for wait in waits:
        if wait > followed:
            strobe = flow.strobe(instant, wait - followed)
            if strobe.ending is not Ending.REACHED_END:
                raise OrbitNotFoundError(f"the motion cannot be followed: {strobe.ending.value}")
            instant, followed = strobe.end, wait
        shot = solve(Return(flow, periods), flow.at(instant.state, instant.phase, like=instant))
        orbit = None if shot is None else orbit_of(flow, shot, periods)
        if orbit is not None and orbit.success:
            return orbit
    if orbit is None:
        raise OrbitNotFoundError(f"the motion cannot be followed over {periods_of(flow.subject, periods)}")
    return orbit


def require_repeating(flow: Flow) -> None:
    """Check that a mechanism can repeat.

    Raises:
        UnsupportedMotionError: if pins go on for ever and pull at springs that something else holds.
    """
    if flow.modes.system.layout.ramp:
        raise UnsupportedMotionError(
            "nothing repeats, because a pin goes on for ever, and what leans on it is held elsewhere too; "
            "simulate() follows it"
        )


def diverges_by_pull(subject: Subject) -> bool:
    """Say whether pins that go on for ever stretch springs without end, whatever else happens."""
    if not isinstance(subject, Mechanism):
        return False
    from trimmer.contact.state.frame import frame_of

    goes_on = any(pin.velocity for pin in subject.pins.values()) or subject.references
    return bool(goes_on) and frame_of(subject, without_stops=True).pulled
