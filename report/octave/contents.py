"""What each corrected listing is about, and what was wrong in the thesis's."""

from __future__ import annotations

from dataclasses import dataclass

BACKLASH = "derivations/elements/backlash.py"


@dataclass(frozen=True)
class Content:
    """A program: the thesis's listing and section that it corrects, its title, and the faults it corrects.

    ``source`` names the file of this project that derives its formulas; it is empty for a program that calls
    others for them. Texts are ASCII, for any editor.
    """

    number: str
    section: str
    title: str
    faults: tuple[str, ...]
    source: str

    @property
    def function(self) -> str:
        """Name of the program's function; its file is called so too."""
        return f"listing_{self.number.lower().replace('.', '_')}"

    @property
    def claim(self) -> str:
        """Id of the claim on the thesis's listing."""
        return f"lst-{self.number}"


CONTENTS = (
    Content(
        "A.1",
        "A.2",
        "Linear trimmer: matrices and transfer function.",
        (
            "Line 58 keeps the response G1 to the displacement of the pin alone. The pin's velocity is the "
            "derivative of its displacement and acts through the damper c2: the response is G1 + s G2.",
        ),
        "derivations/state_space.py and derivations/transfer_function.py",
    ),
    Content(
        "A.2",
        "A.3",
        "Describing function of friction-controlled backlash.",
        (
            "Line 6 tests A < b, and line 12 overwrites the zeros that it sets: below b/2 the function "
            "returns numbers without meaning.",
            "The formula is right for b as the total gap, while equations 2.36 to 2.41 use b for half of it.",
            "Lines 9 and 10 assign N.re and N.im, line 12 uses N_re and N_im, in the copy at hand.",
        ),
        BACKLASH,
    ),
    Content(
        "A.3",
        "A.4",
        "Describing function of friction-controlled backlash, the same as listing_a_2.",
        (
            "The faults of Listing A.2, whose formulas it repeats, but for the names in lines 9 and 10.",
            "The text before it, with an input wave and a previous output, describes Listing A.7.",
        ),
        "",
    ),
    Content(
        "A.4",
        "A.5",
        "Describing function of inertia-controlled backlash.",
        (
            "Line 3 scales the unknown by w, and line 9 takes the root, which is the contact angle over w, "
            "for the angle itself: right for w = 1 only. The function does not depend on frequency.",
        ),
        BACKLASH,
    ),
    Content(
        "A.5",
        "A.6",
        "Describing function of viscous-controlled backlash, the general case.",
        (
            "Line 6 has sqrt(1 - phi^2) where the contact condition has sqrt(1 + phi^2); for phi > 1 the "
            "angle becomes complex.",
            "Line 8 gives the solver no interval, though for wide gaps the condition has several roots; "
            "contact is the one less than half a turn after separation.",
            "Line 21 has li for the imaginary unit 1i, in the copy at hand.",
        ),
        BACKLASH,
    ),
    Content(
        "A.6",
        "A.7",
        "Friction-controlled backlash with Coulomb friction added to it.",
        (
            "Line 18 divides the friction term by j w, where 1/G_g = j w multiplies it, and line 15 uses the "
            "amplitude of the displacement for that of the velocity: the term is j 4 Fc/(pi A).",
            "Line 18 adds that term, a stiffness, to a number; here it is divided by a stiffness first.",
            "The faults of Listing A.2, in lines 8 and 12.",
        ),
        f"{BACKLASH} and derivations/elements/friction.py",
    ),
    Content(
        "A.7",
        "A.8",
        "Friction-controlled backlash in time, for any input.",
        ("Line 12 has one end too many: the function cannot be read.",),
        BACKLASH,
    ),
    Content(
        "A.8",
        "A.9",
        "Inertia-controlled backlash in time, steady motion under a sinusoid.",
        (
            "Amplitude, gap, frequency and instant of contact are constants (lines 2 to 8): for any other "
            "input the result is wrong. The text gives 109.845 Hz, the constants belong to 100 Hz.",
            "Line 12 rounds pi A + b/2 = 0.004912 m to 0.0049 m: the output jumps by 0.012 mm.",
            "At the instants of contact no condition of lines 10 to 13 holds, and the output is zero.",
        ),
        BACKLASH,
    ),
    Content(
        "A.9",
        "A.10",
        "Limit cycles: all intersections of G and -1/N.",
        (
            "Line 23 uses x0, which line 31 defines.",
            "Lines 18 to 20 have coefficients rounded to four digits, which moves the intersections.",
            "Line 9 starts the curve at b/2 + 1e-6 m: for narrow gaps most of it is missing.",
            "Each start gives one solution, and nothing tells whether there are more.",
            "The loop has the pin's displacement alone (see listing_a_1).",
        ),
        "",
    ),
    Content(
        "A.10",
        "A.11",
        "Describing function of inertia-controlled backlash, the same as listing_a_4.",
        ("The faults of Listing A.4, which it repeats.",),
        "",
    ),
)
"""The corrected listings, in thesis order."""
