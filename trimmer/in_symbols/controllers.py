"""The laws of controllers in formulas, with their numbers in SI units."""

from collections.abc import Callable, Iterator

import sympy

from derivations.latex import escaped, latex
from derivations.parts import Control
from trimmer.mechanism.controls.controllers import DIFFERENCE, Cascade, Controller, Pid, TransferController
from trimmer.mechanism.controls.references import (
    ProfileReference,
    RampReference,
    SineReference,
    StepReference,
)
from trimmer.mechanism.mechanism import Mechanism
from trimmer.mechanism.parts import OutputKind

Named = Callable[[str, str, str], sympy.Expr]
"""Returns the function of time of a part by section, name, and what it is."""


def controls_of(mechanism: Mechanism, named: Named) -> Iterator[Control]:
    """Yield what each controller gives, with its law."""
    for name, controller in mechanism.controllers.items():
        value = named("controllers", name, "value")
        lines = (
            *_errors(mechanism, controller, named),
            *(_sampled(controller) if controller.sample is not None else _continuous(controller)),
            *_acting(controller, latex(value)),
        )
        yield Control(name, value, _told(controller, latex(value)), lines)


def _told(controller: Controller, value: str) -> str:
    start, end = map(escaped, controller.acts)
    followed = f"the reference {escaped(controller.reference)}" if controller.reference else "zero"
    told = (
        f"It compares the output {escaped(controller.measure)}, $y$, with {followed}, $r$, and acts with "
        f"${value}$ on {end} and with its opposite on {start}. Numbers are in SI units, and its states are 0 "
        "at first."
    )
    if controller.sample is not None:
        told += " It samples at $t_k = k h$, where $y$ is as just before, and what it finds is held."
    return told


def _errors(mechanism: Mechanism, controller: Controller, named: Named) -> Iterator[str]:
    measured = latex(named("outputs", controller.measure, "value"))
    reference = mechanism.references.get(controller.reference or "")
    match reference:
        case StepReference(step, at):
            followed = f"r = {_number(step)} \\quad \\text{{from }} t = {_number(at)} \\text{{ on}}"
        case RampReference(ramp, at):
            from_then = f"\\quad \\text{{from }} t = {_number(at)} \\text{{ on}}"
            followed = f"r = {_number(ramp)}\\,(t - {_number(at)}) {from_then}"
        case SineReference(sine, frequency, phase):
            angle = f"2 \\pi \\cdot {_number(frequency)}\\,t + {_number(phase)}"
            followed = f"r = {_number(sine)} \\sin({angle})"
        case ProfileReference(points):
            pairs = ",\\; ".join(f"({_number(time)}, {_number(value)})" for time, value in points)
            followed = f"r \\text{{ straight between }} (t, r) = {pairs}"
        case _:
            followed = "r = 0"
    yield followed
    yield f"y = {measured}, \\qquad e = r - y"
    if isinstance(controller, Cascade):
        yield f"v = {_speed(mechanism, controller, measured, named)}"


def _speed(mechanism: Mechanism, cascade: Cascade, measured: str, named: Named) -> str:
    if cascade.speed == DIFFERENCE:
        return "\\frac{y_k - y_{k-1}}{h}, \\qquad y_{-1} = y_0"
    if cascade.speed is not None:
        return latex(named("outputs", cascade.speed, "value"))
    output = mechanism.outputs[cascade.measure]
    return f"\\frac{{d}}{{dt}} {measured}" if output.kind is OutputKind.DISPLACEMENT else "0"


def _follows(controller: Controller, factor: str = "") -> str:
    """Return by how much the integral follows the limit, as a share of its rate."""
    time = controller.tracking_time
    if time is None or time == float("inf"):
        return ""
    return f" + \\frac{{{factor or '1'}}}{{{_number(time)}}}\\,(\\operatorname{{sat}}(w) - w)"


def _continuous(controller: Controller) -> Iterator[str]:
    match controller:
        case Pid():
            terms = [f"{_number(controller.kp)}\\,e"] if controller.kp else []
            if controller.ki:
                yield f"\\dot I = {_number(controller.ki)}\\,e{_follows(controller)}"
                terms.append("I")
            if controller.kd:
                filtered = f"\\frac{{e - z}}{{{_number(controller.filter_time)}}}"
                yield f"\\dot z = {filtered}"
                terms.append(f"{_number(controller.kd)}\\,{filtered}")
            yield f"w = {' + '.join(terms) or '0'}"
        case Cascade():
            yield _slip(controller, "\\dot r")
            if controller.ti is not None:
                gain = f"\\frac{{{_number(controller.kv)}}}{{{_number(controller.ti)}}}"
                yield f"\\dot I = {gain}\\,f{_follows(controller)}"
            yield f"w = {_number(controller.kv)}\\,f{' + I' if controller.ti is not None else ''}"
        case TransferController():
            yield f"W(s) = {_ratio(controller)}\\,E(s)"


def _sampled(controller: Controller) -> Iterator[str]:
    yield f"h = {_number(controller.sample or 0.0)}"
    match controller:
        case Pid():
            terms = [f"{_number(controller.kp)}\\,e_k"] if controller.kp else []
            if controller.kd:
                time = _number(controller.filter_time)
                yield f"z_k = z_{{k-1}} + \\frac{{h}}{{{time} + h}}\\,(e_k - z_{{k-1}})"
                terms.append(f"{_number(controller.kd)}\\,\\frac{{e_k - z_k}}{{{time}}}")
            if controller.ki:
                terms.append(f"I_{{k-1}} + {_number(controller.ki)}\\,h\\,e_k")
            yield f"w_k = {' + '.join(terms) or '0'}"
            if controller.ki:
                yield f"I_k = I_{{k-1}} + {_number(controller.ki)}\\,h\\,e_k{_follows(controller, 'h')}"
        case Cascade():
            yield _slip(controller, "\\dot r")
            gain = _number(controller.kv)
            if controller.ti is None:
                yield f"w_k = {gain}\\,f_k"
                return
            rate = f"\\frac{{{gain}}}{{{_number(controller.ti)}}}\\,h\\,f_k"
            yield f"w_k = {gain}\\,f_k + I_{{k-1}} + {rate}"
            yield f"I_k = I_{{k-1}} + {rate}{_follows(controller, 'h')}"
        case TransferController():
            yield f"W = {_ratio(controller)}\\,E, \\qquad s = \\frac{{2}}{{h}}\\,\\frac{{q - 1}}{{q + 1}}"


def _slip(cascade: Cascade, rate: str) -> str:
    ahead = f" + {_number(cascade.feedforward)}\\,{rate}" if cascade.feedforward else ""
    return f"f = {_number(cascade.kp)}\\,e{ahead} - v"


def _ratio(controller: TransferController) -> str:
    above, below = (_polynomial(each) for each in (controller.numerator, controller.denominator))
    return f"\\frac{{{above}}}{{{below}}}"


def _polynomial(coefficients: tuple[float, ...]) -> str:
    powers = range(len(coefficients) - 1, -1, -1)
    letters = ["" if power == 0 else "\\,s" if power == 1 else f"\\,s^{{{power}}}" for power in powers]
    terms = [f"{_number(each)}{letter}" for each, letter in zip(coefficients, letters, strict=True) if each]
    return " + ".join(terms) or "0"


def _acting(controller: Controller, value: str) -> Iterator[str]:
    sat = "\\operatorname{sat}(w)"
    if controller.limit is None:
        yield f"{sat} = w"
    else:
        limit = _number(controller.limit)
        yield f"{sat} = \\max(-{limit}, \\min({limit}, w))"
    if controller.sample is not None:
        delay = f" + {_number(controller.delay)}" if controller.delay else ""
        while_held = f"\\text{{for }} t_k{delay} \\le t < t_{{k+1}}{delay}"
        yield f"{value} = \\operatorname{{sat}}(w_k) \\quad {while_held}"
    elif controller.delay and controller.pade is not None:
        order = f"({controller.pade}, {controller.pade})"
        yield (
            f"{value} = P(s)\\,{sat}, \\qquad P(s) \\approx e^{{-{_number(controller.delay)}\\,s}} "
            f"\\text{{, the }} {order} \\text{{ Padé approximant}}"
        )
    else:
        yield f"{value} = {sat}"


def _number(value: float) -> str:
    """Return a number as it is written, with a power of ten for its exponent; one below 0 in parentheses."""
    digits, _, power = repr(float(value)).removesuffix(".0").partition("e")
    found = f"{digits} \\cdot 10^{{{int(power)}}}" if power else digits
    return f"({found})" if value < 0 else found
