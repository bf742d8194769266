"""What a mechanism settles to, as JSON has it: SI units, full precision."""

from dataclasses import asdict
from typing import Any

from trimmer.mechanism.cut_waveforms import waveforms_left_out
from trimmer.mechanism.mechanism import Mechanism
from trimmer.motion.measures import Measures
from trimmer.motion.part_measures import ContactMeasures, FrictionMeasures
from trimmer.response.results.response import MotionKind, Response, SettledMotion
from trimmer.response.statistics.estimate import Estimate
from trimmer.response.without_events.rest import Rest


def response_json(response: Response) -> dict[str, Any]:
    """Return a response as a dictionary that JSON can hold."""
    mechanism = response.subject if isinstance(response.subject, Mechanism) else None
    shares = waveforms_left_out(mechanism) if mechanism else {}
    motions = [motion_json(motion) for motion in response.motions]
    return {
        **motions[0],
        **({"waveforms_left_out": shares} if shares else {}),
        "success": response.success,
        "message": response.message,
        "starts": response.starts,
        "box": {name: list(reach) for name, reach in response.box.items()},
        "seed": response.seed,
        "motions": [
            {"share": motion.share, "mirrored": motion.mirrored, **told}
            for motion, told in zip(response.motions, motions, strict=True)
        ],
    }


def motion_json(motion: SettledMotion) -> dict[str, Any]:
    """Return a motion as a dictionary that JSON can hold."""
    multipliers = [] if motion.orbit is None else motion.orbit.multipliers.tolist()
    return {
        "kind": motion.kind.word,
        "period_count": motion.period_count,
        "lyapunov": None if motion.lyapunov is None else estimate_json(motion.lyapunov),
        "drive_periods": motion.drive_periods,
        "events_per_period": motion.events_per_period,
        "multipliers": [[each.real, each.imag] for each in multipliers],
        "one_sided": motion.orbit is not None and motion.orbit.one_sided,
        "other_multipliers": _other_multipliers(motion),
        "rest": None if motion.rest is None else rest_json(motion.rest),
        "family": _is_one_of_many(motion),
        "outputs": {name: _output(motion, name) for name in motion.peak_to_peak},
        "bodies": {name: _body(each) for name, each in motion.rms_acceleration.items()},
        "contacts": {name: _contact(each, motion.measures) for name, each in motion.contacts.items()},
        "frictions": {name: _friction(each) for name, each in motion.frictions.items()},
        "period": None if motion.orbit is None else motion.orbit.period,
        "residual": None if motion.orbit is None else motion.orbit.residual,
        "neighbour_agrees": motion.neighbour_agrees,
        "window_periods": None if motion.window is None else motion.window.periods,
        "spectrum": _spectrum(motion),
        "message": motion.message,
        **({} if motion.swings is None else {"swings": asdict(motion.swings)}),
        **({} if motion.slowing is None else {"slowing": asdict(motion.slowing)}),
    }


def _is_one_of_many(motion: SettledMotion) -> bool:
    """Say whether a rest, or a motion that repeats, is one of a family side by side."""
    of_rest = motion.rest is not None and motion.rest.family
    return of_rest or (motion.orbit is not None and motion.orbit.neutral)


def _other_multipliers(motion: SettledMotion) -> list[list[float]] | None:
    edge = None if motion.orbit is None else motion.orbit.edge
    if edge is None or edge.other_multipliers is None:
        return None
    return [[each.real, each.imag] for each in edge.other_multipliers.tolist()]


def rest_json(rest: Rest) -> dict[str, Any]:
    """Return where a mechanism rests, and what each part bears there."""
    return {
        "positions": dict(rest.positions),
        "forces": dict(rest.forces),
        "forces_change": rest.forces_change,
        "family": rest.family,
        "asymptotic": rest.asymptotic,
    }


def estimate_json(estimate: Estimate) -> dict[str, float]:
    """Return an estimate with its standard error."""
    return {"value": estimate.value, "uncertainty": estimate.uncertainty}


def _output(motion: SettledMotion, name: str) -> dict[str, Any]:
    rms, harmonics = motion.rms[name], motion.harmonics[name].tolist()
    found = {
        "advance": motion.advance[name],
        "mean": motion.mean[name],
        "peak_to_peak": motion.peak_to_peak[name],
        "rms": rms.value,
        "rms_interval": list(rms.interval),
        "harmonics": harmonics,
        "subharmonics": [],
        "lines": [[place + 1, 1, size] for place, size in enumerate(harmonics)],
    }
    if motion.window is not None:
        found["peaks"] = [list(line) for line in motion.window.peaks[name]]
    if motion.kind is MotionKind.TORUS and motion.window is not None:
        own, names = motion.window.combinations[name]
        found |= {"own_frequency": own, "multiples": [each and list(each) for each in names]}
    if motion.orbit is not None:
        measured = motion.orbit.measures.outputs[name]
        found |= {
            "subharmonics": measured.subharmonics.tolist(),
            "lines": [list(line) for line in measured.lines],
        }
    return found


def _body(acceleration: Estimate) -> dict[str, Any]:
    return {"rms_acceleration": acceleration.value, "rms_acceleration_interval": list(acceleration.interval)}


def _contact(contact: ContactMeasures, repeating: Measures | None) -> dict[str, Any]:
    """Return what a contact does; of what does not repeat without its many speeds."""
    speeds = {} if repeating is None else {"impact_speeds": list(contact.impact_speeds)}
    return {
        "impacts_per_period": contact.impacts,
        **speeds,
        "impact_speed": contact.impact_speed,
        "largest_force": contact.largest_force,
        "share_of_time": contact.share,
        **({"completed_chatters": contact.completed} if contact.completed else {}),
    }


def _friction(friction: FrictionMeasures) -> dict[str, Any]:
    return {"work_per_period": friction.work, "power": friction.power, "share_of_stick": friction.stick}


def _spectrum(motion: SettledMotion) -> dict[str, Any] | None:
    if motion.window is None:
        return None
    frequencies, densities = motion.window.spectrum
    return {
        "frequencies": frequencies.tolist(),
        "densities": {name: density.tolist() for name, density in densities.items()},
    }
