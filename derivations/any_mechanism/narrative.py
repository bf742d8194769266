"""The derivation of any mechanism step by step, told as that of the thesis's trimmer is."""

from collections.abc import Iterator

import sympy

from derivations.algebra.unevaluated import total
from derivations.any_mechanism.contact_law import ContactStatement
from derivations.any_mechanism.curve_law import CurveStatement
from derivations.any_mechanism.derivation import MechanismDerivation
from derivations.any_mechanism.friction_law import FrictionStatement
from derivations.any_mechanism.wall_law import WallStatement
from derivations.equations_of_motion import MotionMatrices, inertial_forces, inputs
from derivations.latex import escaped, latex, latex_equation
from derivations.linear_motion import SymbolicMotion
from derivations.mechanism import elongation, position
from derivations.narrative import elongations, energies, euler_lagrange_equation, symmetric_matrices
from derivations.parts import ContactLaw, Control, End, Output, Play
from derivations.step import Formula, NarrativeStep
from derivations.symbols import t

ENDING = {
    ContactLaw.RELAXING: "It ends where $T$ would have to pull; the spring then relaxes by itself "
    "until a side of the slot is met again.",
    ContactLaw.TRUNCATED: "It carries nothing where $T$ would have to pull, and has no memory of it.",
    ContactLaw.PULLING: "It lasts until the gap is reached again, and may pull until then.",
}


POINTS = (
    "A point moves by a weighted sum of these: as the end of a lever by its arm times the angle, or behind a "
    "gear by its ratio. What it is pushed with acts on each body with the same weight. "
)

STRUCTURES = (
    "The coordinates of a structure are among them. Its matrices of mass, damping and stiffness are part of "
    "$M$, $C$ and $K$ below; half of their quadratic forms are part of the energies and of $R$. "
    "$W$ is the inverse of its mass matrix. "
)


def mechanism_narrative(derivation: MechanismDerivation) -> tuple[NarrativeStep, ...]:
    """Return the steps of a derivation, from the parts to the laws of contact and friction."""
    mechanism = derivation.mechanism
    return (
        _parts(derivation),
        _energies(derivation.motion),
        *([] if mechanism.is_linear and not mechanism.forces else [_virtual_work(derivation.motion)]),
        _motion(derivation.motion),
        _matrices(derivation.motion),
        *([_closed_contact(derivation.closed)] if derivation.closed is not derivation.motion else []),
        _state_space(derivation),
        *([_outputs(derivation)] if mechanism.outputs else []),
        *map(_contact_law, derivation.contacts),
        *map(_curve_law, derivation.curves),
        *(_wall_law(derivation, each) for each in derivation.walls),
        *map(_friction_law, derivation.frictions),
        *map(_control_law, mechanism.controls),
        _checks(derivation),
    )


def _parts(derivation: MechanismDerivation) -> NarrativeStep:
    mechanism = derivation.mechanism
    bodies = (
        f"{escaped(body.name)} (${latex(body.coordinate)}${', an angle' if body.turns else ''})"
        for body in mechanism.bodies
    )
    points = (Formula(latex_equation(point.displacement, position(point))) for point in mechanism.points)
    pins = (
        Formula(latex_equation(pin.displacement, pin.law)) for pin in mechanism.pins if pin.law is not None
    )
    forces = (
        Formula(latex_equation(force.value, force.law)) for force in mechanism.forces if force.law is not None
    )
    between_springs = {(spring.start, spring.end) for spring in mechanism.springs}
    rates = (
        Formula(f"e_{{{latex(damper.damping)}}} = {latex(elongation(damper))}")
        for damper in mechanism.resistances
        if (damper.start, damper.end) not in between_springs
    )
    distances = (
        Formula(latex_equation(named, each))
        for named, each in (
            *((each.contact.distance, each.distance) for each in derivation.contacts),
            *((each.spring.distance, each.distance) for each in derivation.curves),
            *((each.wall.distance, each.distance) for each in derivation.walls),
        )
    )
    intermediate = (POINTS if mechanism.points else "") + (STRUCTURES if mechanism.structures else "")
    return NarrativeStep(
        "parts",
        "Bodies and what joins them",
        f"Bodies that move along one line, with their displacements in the fixed frame: {', '.join(bodies)}. "
        f"{intermediate}A pin moves as prescribed, relative to what carries it. Below stand these motions "
        "and the given forces, the elongation $e$ of each spring, of each damper that is not beside one, and "
        "the distance $s$ of the two ends of each contact: the position of one end less that of the other.",
        (*points, *pins, *forces, *elongations(mechanism), *rates, *distances),
    )


def _energies(motion: SymbolicMotion) -> NarrativeStep:
    return NarrativeStep(
        "energies",
        "Energies and dissipation",
        "Kinetic energy belongs to the bodies, potential energy to the springs, and Rayleigh's function, "
        "half of the power that is lost, to the dampers and to viscous friction.",
        energies(motion),
    )


def _virtual_work(motion: SymbolicMotion) -> NarrativeStep:
    forces = zip(motion.mechanism.bodies, motion.generalised_forces, strict=True)
    return NarrativeStep(
        "virtual-work",
        "Generalised forces",
        "Contacts, dry frictions and given forces enter by their virtual work. A contact with the tension "
        "$T_j$ does the work $-T_j\\,\\delta s_j$ as its ends move apart, a dry friction $f_j$ likewise, "
        "and a given force that of its body's displacement.",
        tuple(Formula(f"Q_{{{latex(body.coordinate)}}} = {latex(force)}") for body, force in forces),
    )


def _motion(motion: SymbolicMotion) -> NarrativeStep:
    return NarrativeStep(
        "motion",
        "Equations of motion",
        "The Euler-Lagrange equation of each body. The sum of forces by Newton's law gives the same lines.",
        (euler_lagrange_equation("Q_i"), *_balances(motion)),
    )


def _balances(motion: SymbolicMotion) -> Iterator[Formula]:
    coupled = {body for structure in motion.mechanism.structures for body in structure.bodies}
    listed = zip(
        motion.mechanism.bodies, inertial_forces(motion.mechanism), motion.resultant_forces, strict=True
    )
    for body, inertial, force in listed:
        mass = "" if body.mass == 1 else f"{latex(body.mass)} "
        alone = f"{mass}{latex(body.coordinate.diff(t, 2))}"
        yield Formula(f"{latex(inertial) if body in coupled else alone} = {latex(force)}")


def _matrices(motion: SymbolicMotion) -> NarrativeStep:
    kinds = zip(_columns(motion.matrices), inputs(motion.mechanism), strict=True)
    driving = [
        (name, matrix, f"{name} {latex(sympy.Matrix(names))}")
        for (name, matrix), names in kinds
        if any(matrix)
    ]
    sum_of_inputs = " + ".join(term for _, _, term in driving) or "0"
    return NarrativeStep(
        "matrices",
        "Matrices",
        "The equations of motion are linear in displacements and inputs, with symmetric matrices.",
        (
            Formula(f"M\\ddot q + C\\dot q + K q = {sum_of_inputs}"),
            *symmetric_matrices(motion.matrices),
            *(Formula(f"{name} = {latex(matrix)}") for name, matrix, _ in driving),
        ),
    )


def _columns(matrices: MotionMatrices) -> tuple[tuple[str, sympy.ImmutableMatrix], ...]:
    return (
        ("F_u", matrices.displacement_force),
        ("F_v", matrices.velocity_force),
        ("F_p", matrices.given_force),
        ("F_T", matrices.contact_force),
        ("F_f", matrices.friction_force),
    )


def _closed_contact(motion: SymbolicMotion) -> NarrativeStep:
    constant = motion.matrices.constant_force
    return NarrativeStep(
        "closed-contact",
        "Closed contact",
        "While contacts are closed, their springs and dampers act as any others do, with the distance less "
        "what the slot leaves free. A side $\\sigma$ of a play is 1 where the end is ahead, and $-1$ behind. "
        "With every contact closed the energies and the equations of motion are these; of an open one "
        "stiffness and damping are zero. At the right side a constant $f_0$ is added, if there is a gap.",
        (
            Formula(latex_equation(sympy.Symbol("U"), motion.potential_energy)),
            Formula(latex_equation(sympy.Symbol("R"), motion.rayleigh_function)),
            *_balances(motion),
            Formula(latex_equation(sympy.Symbol("C"), motion.matrices.damping)),
            Formula(latex_equation(sympy.Symbol("K"), motion.matrices.stiffness)),
            *([] if constant.is_zero_matrix else [Formula(f"f_0 = {latex(constant)}")]),
        ),
    )


def _state_space(derivation: MechanismDerivation) -> NarrativeStep:
    motion, closed = derivation.motion, derivation.closed
    text = "With the state $x = (q, \\dot q)$ and all inputs $w$."
    formulas = [Formula(r"\dot{x} = A x + B w"), *_space(motion)]
    if closed is not motion:
        text += " First with the tensions of contacts as inputs, then with every contact closed."
        formulas += _space(closed)
    return NarrativeStep("state-space", "State space", text, tuple(formulas))


def _space(motion: SymbolicMotion) -> list[Formula]:
    driving = [each for kind in inputs(motion.mechanism) for each in kind]
    if not motion.matrices.constant_force.is_zero_matrix:
        driving.append(sympy.S.One)
    formulas = [Formula(latex_equation(sympy.Symbol("A"), motion.space.a))]
    if driving:
        formulas.append(Formula(latex_equation(sympy.Symbol("B"), motion.space.b)))
        formulas.append(Formula(f"w = {latex(sympy.Matrix(driving))}"))
    return formulas


def _outputs(derivation: MechanismDerivation) -> NarrativeStep:
    outputs = derivation.mechanism.outputs
    displacements = all(each.order == 0 and each.force is None for each in outputs)
    told = "The displacements that are asked for, in those of bodies and pins."
    return NarrativeStep(
        "outputs",
        "Outputs",
        told if displacements else "What is asked for: motions in those of bodies and pins, and forces.",
        tuple(Formula(latex_equation(each.value, _asked(each))) for each in outputs),
    )


def _asked(output: Output) -> sympy.Expr:
    if output.force is not None:
        return output.force
    return total(
        *(weight * term.diff(t, output.order) for end, weight in output.weights for term in _terms(end))
    )


def _terms(end: End) -> tuple[sympy.Expr, ...]:
    return sympy.Add.make_args(position(end))


def _contact_law(statement: ContactStatement) -> NarrativeStep:
    contact = statement.contact
    kind = "play" if isinstance(contact, Play) else "stop"
    without = "" if contact.damping != 0 else " Without damping all laws of contact are this one."
    formulas = [Formula(latex_equation(contact.distance, statement.distance))]
    if statement.stretch is not None:
        formulas.append(Formula(latex_equation(contact.stretch, statement.stretch)))
    if statement.stretch_rate is not None:
        formulas.append(Formula(latex_equation(contact.stretch.diff(t), statement.stretch_rate)))
    formulas.append(Formula(latex_equation(contact.tension, statement.tension)))
    return NarrativeStep(
        f"contact-{contact.tension.func.__name__}",
        f"Contact: {contact.name}",
        f"The {kind} pulls its ends together with $T = {latex(contact.tension)}$. "
        f"{ENDING[contact.law] if contact.damping != 0 else ''}{without}".strip(),
        tuple(formulas),
    )


def _curve_law(statement: CurveStatement) -> NarrativeStep:
    spring = statement.spring
    return NarrativeStep(
        f"curve-{spring.tension.func.__name__}",
        f"Curve: {spring.name}",
        "The spring pulls its ends together with a force that is straight between the points of its curve, "
        "and beyond the outer ones. Numbers are in SI units.",
        (
            Formula(latex_equation(spring.distance, statement.distance)),
            Formula(latex_equation(spring.tension, statement.tension)),
        ),
    )


def _wall_law(derivation: MechanismDerivation, statement: WallStatement) -> NarrativeStep:
    wall, bodies = statement.wall, derivation.mechanism.bodies
    s, gap, rate = latex(wall.distance), latex(wall.gap), latex(wall.distance.diff(t))
    jumps = zip(bodies, statement.changes, strict=True)
    return NarrativeStep(
        f"wall-{wall.tension.func.__name__}",
        f"Wall: {wall.name}",
        f"The ends are never farther apart than the gap. Where it is reached with the rate ${rate} > 0$, "
        "an impulse turns that into its opposite times the restitution; the velocities of the bodies change "
        "by what it gives them. At rest there a force holds that only pushes, "
        f"${latex(wall.tension)} \\ge 0$, the last line; the ends let go where it would have to pull. "
        "Where several walls and frictions hold, these lines hold together.",
        (
            Formula(f"{s} = {latex(statement.distance)} \\le {gap}"),
            Formula(f"\\int {latex(wall.tension)}\\,dt = {latex(statement.impulse)}"),
            *(
                Formula(f"\\Delta {latex(body.coordinate.diff(t))} = {latex(change)}")
                for body, change in jumps
                if change != 0
            ),
            Formula(f"{latex(wall.tension)} = {latex(statement.held)}"),
        ),
    )


def _friction_law(statement: FrictionStatement) -> NarrativeStep:
    friction = statement.friction
    v, force = latex(friction.rate), latex(friction.force)
    size = latex(sympy.Abs(friction.force))
    formulas = [
        Formula(f"{v} = {latex(statement.rate)}"),
        Formula(f"{force} = {latex(statement.sliding)} \\quad \\text{{while }} {v} \\neq 0"),
        Formula(f"{size} \\le {latex(friction.static)} \\quad \\text{{while }} {v} = 0"),
    ]
    if statement.held is not None:
        formulas.append(Formula(f"{force} = {latex(statement.held)}"))
    sliding = (
        "In sliding the dry force has the size that its curve gives for the speed, in SI units, and opposes "
        if friction.points
        else "In sliding the dry force has its kinetic size and opposes "
    )
    viscous = " Its viscous share is a damper, which the equations of motion hold already."
    return NarrativeStep(
        f"friction-{friction.force.func.__name__}",
        f"Friction: {friction.name}",
        f"{sliding}the motion. In stick it is what keeps the "
        "velocity at zero, which is the last line, as long as that is not more than the static force. Where "
        "several frictions stick, these lines hold together." + (viscous if friction.viscous != 0 else ""),
        tuple(formulas),
    )


def _control_law(control: Control) -> NarrativeStep:
    return NarrativeStep(
        f"control-{control.value.func.__name__}",
        f"Controller: {control.name}",
        control.told,
        tuple(map(Formula, control.lines)),
    )


def _checks(derivation: MechanismDerivation) -> NarrativeStep:
    power = derivation.motion.power
    both = (sympy.Add.make_args(power.dissipated_power), sympy.Add.make_args(power.contact_power))
    taken = total(*(term for terms in both for term in terms))
    return NarrativeStep(
        "checks",
        "Checks",
        "Along every motion the energy changes by the power $P_g$ of pins and given forces, less the power "
        "$P_t$ that dampers, frictions and contacts take. The difference of both sides is zero identically. "
        "The equations of motion were derived a second time from the forces on each body alone, and agree.",
        (
            Formula(r"\frac{d}{dt}(T + U) = P_g - P_t"),
            Formula(latex_equation(sympy.Symbol("P_g"), sympy.factor_terms(power.input_power))),
            Formula(latex_equation(sympy.Symbol("P_t"), taken)),
        ),
    )
