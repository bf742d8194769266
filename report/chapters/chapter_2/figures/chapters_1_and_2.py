"""The figures of chapters 1 and 2, each with its caption and alternative text."""

from __future__ import annotations

from report.chapters.chapter_2.figures.block_diagrams import (
    describing_function_block,
    feedback_system,
    linear_system,
    loop_without_reference,
    parallel_nonlinearities,
)
from report.chapters.chapter_2.figures.characteristics import backlash_characteristic, coulomb_friction
from report.chapters.chapter_2.figures.mechanisms import (
    components,
    eccentric_pin,
    free_body_diagram,
    motor_and_load,
)
from report.chapters.chapter_2.figures.textbook_loops import one_limit_cycle, two_limit_cycles
from report.chapters.chapter_2.figures.waveforms import (
    friction_controlled,
    inertia_controlled,
    viscous_controlled,
)
from report.drawing.drawing import Drawing

DRAWINGS = (
    Drawing(
        "fig-1.1",
        "Parts of the trimmer",
        "The parts that the text names and what they are fastened to (thesis, figure 1.1); shapes and sizes "
        "are free. The pin moves the driving bridge through play; the cutter rubs on the guard.",
        "A motor with a shell and an eccentric pin stands on the plastic housing. The pin stands between "
        "two raised edges of the driving bridge, with play on both sides. The bridge is fixed to the "
        "cutter, which touches the guard. The guard is fixed to the guard housing, and a coil spring ties "
        "the cutter to it.",
        lambda _: components(),
    ),
    Drawing(
        "fig-2.1",
        "Four masses with springs and dampers",
        "The masses and what ties them, as the energies have it (thesis, figure 2.1b). The pin is displaced "
        "by $u(t)$ relative to the motor that carries it. Friction between cutter and guard is not in the "
        "linear model.",
        "From left to right: a wall, spring k1 and damper c1, motor m1; at the distance u the pin, spring "
        "k2 and damper c2, cutter m2; spring k5, guard housing m3; spring k3 and damper c3, a wall. The "
        "guard m4 hangs on the guard housing by spring k4 and damper c4.",
        lambda _: free_body_diagram(),
    ),
    Drawing(
        "fig-2.2",
        "Eccentric pin",
        "The shaft from above, and the pin's displacement over a turn (thesis, figure 2.2). The amplitude "
        "is the eccentricity $A$; the bridge's edges are flat, so the size of the pin does not matter.",
        "A circle with a small pin at the distance A from its centre, at the angle 2 pi f t from the "
        "upright, between two upright lines. Beside it a sine of height A over one turn.",
        lambda _: eccentric_pin(),
    ),
    Drawing(
        "fig-2.3",
        "Linear system as a block",
        "Block diagram of the linear trimmer (thesis, figure 2.3): the output's transform is $G(s)$ times "
        "the input's.",
        "An arrow u of t enters a block G of s, an arrow y of t leaves it.",
        lambda _: linear_system(),
    ),
    Drawing(
        "fig-2.4",
        "General feedback system",
        "Loop with $G$ ahead and $N$ in the feedback path (thesis, figure 2.4), so that $M = G/(1 + GN)$.",
        "A reference U enters a summing junction, then a block G whose output Y is fed back through a block "
        "N and subtracted.",
        lambda _: feedback_system(),
    ),
    Drawing(
        "fig-2.5",
        "Loop of element and linear system",
        "The loop in which limit cycles are sought (thesis, figure 2.5). Without reference $e = -y$, and "
        "what goes round comes back unchanged only if $1 + NG = 0$.",
        "A reference of zero enters a summing junction; its output e goes through a block N of A and omega, "
        "then through a block G of j omega, and is subtracted at the junction.",
        lambda _: loop_without_reference(),
    ),
    Drawing(
        "fig-2.6",
        "Describing function as a block",
        "A sine goes in, a periodic signal comes out (thesis, figure 2.6). $N = (M/A)\\,e^{j\\varphi}$ "
        "keeps its first harmonic and drops the others.",
        "An arrow A sine omega t enters a block N; an arrow M sine of omega t plus phi, plus higher "
        "harmonics, leaves it.",
        lambda _: describing_function_block(),
    ),
    Drawing(
        "fig-2.7",
        "Motor and load with play",
        "A motor moves a load with mass $M$ and damping $D$ through play (thesis, figure 2.7). Here $b$ is "
        "the clearance on either side and $2b$ all of it; from figure 2.10 on the thesis writes $b$ for all "
        "of it.",
        "A motor carries a pin between two edges of a load M, with a gap b on either side; a damper D ties "
        "the load to a wall.",
        lambda _: motor_and_load(),
    ),
    Drawing(
        "fig-2.8",
        "Characteristic of backlash",
        "Output over input of friction-controlled backlash (thesis, figure 2.8). From rest the path is "
        "$OAB$, then $BCDE$ for ever. A smaller amplitude gives a lower path of the same width $2b$.",
        "Two closed parallelograms with upright slope one and horizontal sides of length 2b, run round "
        "counter-clockwise; the larger is marked B, C, D, E and a dotted line leads to it from O over A.",
        lambda _: backlash_characteristic(),
    ),
    Drawing(
        "fig-2.9",
        "Friction-controlled backlash",
        "Characteristic, input and output (thesis, figure 2.9), for $2b = 0.6\\,A$; thin lines join what "
        "belongs together. After the peak $B$ the load stays at $+(A - b)$ until the pin has crossed the "
        "gap, at $C$.",
        "Three panels that share their axes: a parallelogram B, C, D, E, below it the sine of the input "
        "with time downwards, to its right the output, which is flat from B to C and from D to E.",
        lambda _: friction_controlled(),
    ),
    Drawing(
        "fig-2.10",
        "Inertia-controlled backlash",
        "A load without friction (thesis, figure 2.10), for $b = 0.6\\,A$. It is let go where the pin is "
        "fastest, at $0$ and $\\pi$, keeps that velocity, and is caught at $\\phi$ and $\\pi + \\phi$. It "
        "goes farther than the pin.",
        "Positions and velocities of pin and load over a period, and the load's position over the pin's. "
        "The load flies along straight lines from zero to phi and from pi to pi plus phi, with velocity "
        "plus one and minus one, and jumps to the pin's velocity when it is caught.",
        lambda _: inertia_controlled(),
    ),
    Drawing(
        "fig-2.11",
        "Viscous-controlled backlash",
        "Loads with inertia and friction (thesis, figure 2.11), for $b = 0.6\\,A$ and three $\\gamma = "
        "M\\omega/D$. The heavier the load, the earlier it is let go at $\\phi_s = \\arctan(1/\\gamma)$ and "
        "the farther it flies before it is caught at $\\phi_c$.",
        "Positions and velocities of pin and load for gamma 0.3, 1 and 4. With 0.3 the let-go load soon "
        "stands still, with 4 it keeps most of its velocity.",
        lambda _: viscous_controlled(),
    ),
    Drawing(
        "fig-2.12",
        "Coulomb friction",
        "Friction is a relay in the velocity (thesis, figure 2.12). Over the displacement the same force is "
        "a rectangle, run round clockwise; its area $4F_cA$ is the work lost in a period.",
        "Three panels: a step from minus one to plus one at zero velocity; a rectangle over the "
        "displacement; over a period the force is plus one while the velocity is positive and minus one "
        "while it is negative.",
        lambda _: coulomb_friction(),
    ),
    Drawing(
        "fig-2.13",
        "Graphical harmonic balance",
        "A relay with $1/(s(s+1)(s+2))$, an example in the place of the thesis's figure 2.13, which names "
        "no loop. Left: $G$ and $-1/N$ meet at $K$; arrows: rising $\\omega$ and $A$. Right: real and "
        "imaginary part of $1 + NG$ are zero at the same $K$, $\\omega = \\sqrt 2$, $A = 2/(3\\pi)$.",
        "Left, the locus of G crosses the negative real axis, along which minus one over N runs, at K. "
        "Right, a falling curve and an upright line cross at omega 1.4142 and amplitude 0.2122.",
        lambda _: one_limit_cycle(),
    ),
    Drawing(
        "fig-2.14",
        "Stable and unstable limit cycle",
        "$7/(s + 1)^3$ with friction-controlled backlash, an example in the place of the thesis's figure "
        "2.14. Triangles: operating points at a larger ($L'$) and a smaller ($L''$) amplitude; arrows: "
        "rising $\\omega$ and $A$. Below: the loop simulated. It leaves $A_1$ either way and settles at "
        "$A_2$ from both sides.",
        "The curve of minus one over N enters the shaded region that G encircles at L1, unstable, and "
        "leaves it at L2, stable, before it ends at minus one. Amplitudes over time fall to zero from just "
        "below A1, and tend to A2 from just above A1 and from above A2.",
        lambda _: two_limit_cycles(),
    ),
    Drawing(
        "fig-2.15",
        "Two nonlinearities in parallel",
        "Friction $N_f$ and backlash $N_r$ fed back from two places (a), and the same loop with both fed "
        "from one (b) (thesis, figure 2.15). Friction sees $v = x/G_g$, so its amplitude is that of $v$.",
        "Part a: a block Gm with friction around it, then a block Gg, whose output is fed back through "
        "backlash. Part b: a block Gm Gg, whose output is fed back through backlash and, in parallel, "
        "through one over Gg and friction.",
        lambda _: parallel_nonlinearities(),
    ),
)
