"""The linear trimmer as python-control systems: state space and transfer function, for any displacement."""

from collections.abc import Sequence

import control
import numpy as np

from trimmer.arguments import require_instances
from trimmer.arrays import Reals
from trimmer.choices import Choice
from trimmer.displacement import CUTTER_RELATIVE_TO_GUARD, Displacement, TrimmerBody
from trimmer.generated import linear_trimmer
from trimmer.parameters import ParameterError, TrimmerParameters, require_parameters

STATES = tuple(body.coordinate for body in TrimmerBody) + tuple(
    f"{body.coordinate}_dot" for body in TrimmerBody
)
"""Names of the states: four displacements (m), then their velocities (m/s)."""

INPUTS = ("pin_displacement", "pin_velocity")
"""Names of the inputs: displacement of the pin relative to the motor (m) and its velocity (m/s)."""


class InputChannels(Choice):
    """Which of the two inputs the pin acts through.

    The thesis keeps the displacement only (Appendix A.2); the pin of the real mechanism acts through both,
    because its velocity is the derivative of its displacement.
    """

    DISPLACEMENT_ONLY = "displacement"
    DISPLACEMENT_AND_VELOCITY = "both"

    @property
    def word(self) -> str:
        """``displacement`` or ``both``."""
        return str(self.value)


def linear_model(
    parameters: TrimmerParameters,
    output: Displacement | str | Sequence[Displacement | str] = CUTTER_RELATIVE_TO_GUARD,
) -> control.StateSpace:
    """Build the state-space model with both inputs (equations 2.10 to 2.14 of the thesis).

    Args:
        parameters: The trimmer.
        output: One displacement, or several, which become the outputs in that order; labels such as ``q2-q4``
            will do.

    Returns:
        A continuous-time system with 8 states, 2 inputs and one output per displacement, all named
        (``STATES``, ``INPUTS``, the displacements' labels); SI units.

    Raises:
        DisplacementError: if an output is no displacement.
        ValueError: if no output is given.
    """
    one = isinstance(output, Displacement | str)
    listed = (output,) if one else require_instances("output", output, object, "a displacement")
    outputs = tuple(map(Displacement.parse, listed))
    if not outputs:
        raise ValueError("a linear model needs at least one output displacement")
    require_parameters(parameters)
    values = parameters.values()
    return control.ss(
        np.array(linear_trimmer.state_matrix(*values)),
        np.array(linear_trimmer.input_matrix(*values)),
        np.array([displacement.row + (0.0,) * len(TrimmerBody) for displacement in outputs]),
        np.zeros((len(outputs), len(INPUTS))),
        name="linear_trimmer",
        states=list(STATES),
        inputs=list(INPUTS),
        outputs=[displacement.label for displacement in outputs],
    )


def pin_model(
    parameters: TrimmerParameters,
    output: Displacement | str = CUTTER_RELATIVE_TO_GUARD,
    channels: InputChannels | str = InputChannels.DISPLACEMENT_AND_VELOCITY,
) -> control.StateSpace:
    """Build the model with one input, the displacement of the pin.

    With both channels G = G1 + s G2. No differentiator is needed: with z = x - B2 u the state equation
    x' = A x + B1 u + B2 u' becomes z' = A z + (B1 + A B2) u, y = C z + C B2 u. A displacement has C B2 = 0,
    because a force changes velocities first. The first four states stay q1 to q4; the others are then named
    z1 to z4, since they are the velocities less their rows of B2 u.

    Args:
        parameters: The trimmer.
        output: The displacement to follow, also by its label, such as ``q2-q4``.
        channels: Whether the pin acts by its displacement alone, as in the thesis, or by its velocity too: a
            member, or its word (``displacement``, ``both``).

    Returns:
        A continuous-time system with 8 states, one input and one output, named; SI units.

    Raises:
        ChoiceError: if there are no such channels.
        DisplacementError: if the output is no displacement.
        ParameterError: if the parameters are so far apart that the equations overflow.
    """
    output, channels = Displacement.parse(output), InputChannels.chosen(channels, "channels")
    model = linear_model(parameters, output)
    A, B, C = model.A, model.B, model.C
    from_displacement, from_velocity = B[:, :1], B[:, 1:]
    with np.errstate(all="ignore"):
        # What is computed from the model next needs products of its entries.
        _require_finite(parameters, A @ np.hstack([A, B]))
    if channels is InputChannels.DISPLACEMENT_ONLY:
        pin_input, feedthrough, states = from_displacement, np.zeros((1, 1)), STATES
    else:
        pin_input, feedthrough = from_displacement + A @ from_velocity, C @ from_velocity
        states = STATES[: len(TrimmerBody)] + tuple(f"z{body.value}" for body in TrimmerBody)
    return control.ss(
        *(A, pin_input, C, feedthrough),
        name="linear_trimmer",
        states=list(states),
        inputs=[INPUTS[0]],
        outputs=[output.label],
    )


def transfer_function(
    parameters: TrimmerParameters,
    output: Displacement | str = CUTTER_RELATIVE_TO_GUARD,
    channels: InputChannels | str = InputChannels.DISPLACEMENT_AND_VELOCITY,
) -> control.TransferFunction:
    """Build the transfer function from the displacement of the pin, from the derived coefficients.

    Its coefficients are those of the derivation (equation 2.21 of the thesis with symbols), so they carry the
    rounding of a few units in the last place; a conversion from state space loses far more.

    Args:
        parameters: The trimmer.
        output: The displacement to follow, also by its label, such as ``q2-q4``.
        channels: Whether the pin acts by its displacement alone, as in the thesis, or by its velocity too: a
            member, or its word (``displacement``, ``both``).

    Returns:
        A continuous-time system with a monic denominator of degree 8; dimensionless (m/m).

    Raises:
        ChoiceError: if there are no such channels.
        DisplacementError: if the output is no displacement.
        ParameterError: if the parameters are so far apart that the coefficients overflow.
    """
    require_parameters(parameters)
    output, channels = Displacement.parse(output), InputChannels.chosen(channels, "channels")
    values = parameters.values()
    weights = np.array(output.row)
    denominator = np.array(linear_trimmer.characteristic_polynomial(*values))
    with np.errstate(all="ignore"):
        numerator = weights @ np.array(linear_trimmer.displacement_numerators(*values))
        if channels is InputChannels.DISPLACEMENT_AND_VELOCITY:
            velocity_numerator = weights @ np.array(linear_trimmer.velocity_numerators(*values))
            numerator = np.polyadd(numerator, np.append(velocity_numerator, 0.0))
    _require_finite(parameters, numerator, denominator)
    return control.tf(
        _without_leading_zeros(numerator),
        denominator,
        name="linear_trimmer",
        inputs=[INPUTS[0]],
        outputs=[output.label],
    )


def _without_leading_zeros(coefficients: Reals) -> Reals:
    return np.trim_zeros(coefficients, "f") if coefficients.any() else np.zeros(1)


def _require_finite(parameters: TrimmerParameters, *results: Reals) -> None:
    """Check that no product or ratio of the parameters overflowed, and name the lightest body if one did."""
    if not all(np.isfinite(result).all() for result in results):
        lightest = min(("m1", "m2", "m3", "m4"), key=lambda name: getattr(parameters, name))
        raise ParameterError(
            "the parameters are too many powers of ten apart, so that the equations overflow: "
            f"the lightest body has {lightest} = {getattr(parameters, lightest)!r} kg; is the unit kg?"
        )
