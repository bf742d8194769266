"""Figures of section 5.2 that rest on harmonic balance, each with its caption and alternative text."""

from __future__ import annotations

from report.chapters.chapter_5.figures import contours, equivalent_nonlinearity, section_5_2_simulated
from report.drawing.drawing import Drawing

SECOND_IMPLEMENTATION = Drawing(
    "fig-5.5",
    "Friction-controlled backlash by two programs",
    "$G$ and $-1/N$ of Listing A.3, with python-control's values as squares (thesis, figure 5.5). Right: "
    "size of what both return. They agree from half of the gap on; below it the library returns zero, the "
    "listing numbers without meaning.",
    "Squares lie on a dashed curve that runs from minus one down and to the left through the large loop of "
    "G. Beside it the size of N over the amplitude: zero at half of the gap, rising towards one; left of "
    "that the dashed line rises again while the squares stay at zero.",
    contours.second_implementation,
)

LARGER_GAP = Drawing(
    "fig-5.10",
    "Intersections and oscillation for a gap of 40 µm",
    "a: $G$ and $-1/N$ of friction-controlled backlash with $b$ = $4\\times10^{-5}$ m (thesis, figure 5.10). "
    "Full point: stable limit cycle; open point: unstable. The curve is that of every other gap; only the "
    "amplitudes along it belong to this one. b: how far the exact loop swings after an impulse, and the "
    "settled motion.",
    "The dashed curve leaves the large loop of G at its lower side, at 21.1 micrometres and 553.6 hertz, "
    "unstable, and crosses it again close to minus one, at 332.6 micrometres and 733.6 hertz, stable. Below, "
    "a band that widens to 0.33 millimetres, and four periods of a sine of that size.",
    contours.larger_gap,
)

LATER = (
    Drawing(
        "fig-5.15",
        "What a band of limit cycles would need",
        "$G$ with $-1/N$ of inertia-controlled backlash near $-1$ (thesis, figure 5.15). For intersections "
        "from 4600 to 5380 rad/s the curve would have to be as thick as the shaded area. With all harmonics "
        "that come back it is 0.002 thick, less than the line drawn.",
        "A broad shaded band around the dashed curve holds both ends of the thesis's range on G, which lie "
        "far on both sides of the one intersection at 4716 radians per second.",
        contours.higher_harmonics,
    ),
    Drawing(
        "fig-5.16",
        "Viscous-controlled backlash with G",
        "$G$ with $-1/N$ for a constant $\\gamma = M\\omega/D$, between the curves for friction and for "
        "inertia (thesis, figure 5.16). Above: right contours; each meets the outer circle near $-1$, where "
        "it is stable. Below: Listing A.5, whose contact angles are complex; its contours stay away from "
        "$-1$.",
        "Above, three curves start at minus one between two others and cross G near minus one and once more "
        "on the small loop. Below, three curves start away from minus one and bend to the right across the "
        "small loop; near minus one there is none of them.",
        contours.viscous_contours,
    ),
    *section_5_2_simulated.RELAY,
    Drawing(
        "fig-5.21",
        "Backlash and friction together",
        "$G$ with $-1/N$ by Listing A.6 for 0.15 N, 200π rad/s and a gap of 2 mm, and with one of them "
        "changed (thesis, figure 5.21; the values beside those are ours). Last panel: the right friction "
        "term, over $k_2$. The wrong sign bends the curves to the right, the right one bends them up.",
        "Three panels in which curves from minus one bend from the curve without friction to the lower "
        "right; a fourth in which they bend to the left and upwards, until they no longer meet G.",
        equivalent_nonlinearity.three_panels,
    ),
    Drawing(
        "fig-5.22",
        "Equivalent nonlinearity without friction",
        "$G$ with $-1/N$ for $b$ = $4\\times10^{-6}$ m and $F_c$ = 0 (thesis, figure 5.22). Listing A.6 "
        "gives backlash without friction and its two limit cycles. Equation 5.14, whose real part lacks a "
        "factor, gives a curve along the negative real axis.",
        "A dashed curve with two marked intersections, at 2.11 and 33.26 micrometres; a dash-dotted straight "
        "line along the negative real axis meets G nowhere.",
        equivalent_nonlinearity.without_force,
    ),
    Drawing(
        "fig-5.23",
        "Equivalent nonlinearity with 0.6 N",
        "a: $G$ with $-1/N$ for $b$ = $4\\times10^{-6}$ m and $F_c$ = 0.6 N (thesis, figure 5.23). By "
        "Listing A.6 there is one intersection, with an amplitude of 16.9 mm. With the right sign the curve "
        "leaves $-1$ upwards and meets $G$ nowhere. b: spectrum of the exact loop with that gap and force, "
        "all bodies displaced alike at the start; dotted: natural modes of the loop without play and "
        "friction.",
        "Two half circles from minus one to zero, one below the real axis, which crosses G close to minus "
        "one, and one above it, which does not. Below, a spectrum with three rounded peaks at 222, 370 and "
        "737 hertz, the same for three starts.",
        equivalent_nonlinearity.one_force,
    ),
    Drawing(
        "fig-5.24",
        "Contours for several forces, and what friction does",
        "Left: Listing A.6 for $b$ = $4\\times10^{-6}$ m and several $F_c$ (thesis, figure 5.24); the "
        "intersection moves to the right and stops. Right: amplitude over force for friction between cutter "
        "and guard; the stable and the unstable limit cycle meet, and beyond that force there is none.",
        "Left, five curves from minus one cross G at points that crowd together. Right, for each of two "
        "loops a falling solid curve and a rising dotted one that end in one point, at 8.1 and 6.3 "
        "kilonewton per metre of gap.",
        equivalent_nonlinearity.several_forces,
    ),
)
