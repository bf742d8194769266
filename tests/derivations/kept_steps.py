"""The derivations as they are told, in the files of ``kept``: prose, equations, their numbers, and functions.

``python -m tests.derivations.kept_steps`` writes the files anew, after a change that is wanted.
"""

from collections.abc import Callable, Iterator, Mapping
from functools import cache
from pathlib import Path

from derivations.any_mechanism.derivation import derive_mechanism
from derivations.any_mechanism.narrative import mechanism_narrative
from derivations.elements.narrative import element_narrative, textbook_narrative
from derivations.linear_trimmer import derive_linear_trimmer
from derivations.loop.narrative import loop_narrative
from derivations.mechanism import Mechanism
from derivations.narrative import narrative
from derivations.parts import ContactLaw, Damper, Spring
from derivations.step import NarrativeStep
from tests.derivations.symbolic_parts import GROUND, body, force, friction, pin, play, positive, stop
from trimmer import Mechanism as MechanismOfNumbers
from trimmer.code_generation import derive_mechanism_sources


def every_part() -> Mechanism:
    """Return a mechanism with each kind of part, and each law of contact."""
    first, second, third = body(1), body(2), body(3)
    driven = pin("u", first)
    return Mechanism(
        (first, second, third),
        (Spring(positive("k"), GROUND, first), Spring(positive("k_2"), second, third)),
        (Damper(positive("c"), first, second), Damper(positive("c_2"), GROUND, third)),
        (driven,),
        (
            play("a", second, driven),
            play("b", second, third, ContactLaw.TRUNCATED),
            play("c", GROUND, third, ContactLaw.PULLING, gap=False),
            stop("d", first, second, ContactLaw.TRUNCATED, damping=False),
            stop("e", third, GROUND),
        ),
        (friction("a", first, second), friction("b", GROUND, third, viscous=False)),
        (force("P", second), force("Q", third)),
    )


FOLDER = Path(__file__).with_name("kept")
EXAMPLE = Path(__file__).parents[2] / "examples" / "foil-shaver.toml"
NARRATIVES: Mapping[str, Callable[[], tuple[NarrativeStep, ...]]] = {
    "linear": lambda: narrative(derive_linear_trimmer()),
    "loop": lambda: loop_narrative(derive_linear_trimmer()),
    "elements": element_narrative,
    "textbook": textbook_narrative,
    "mechanism": lambda: mechanism_narrative(derive_mechanism(every_part())),
}
SOURCES = ("document", "module")  # What `trimmer derive` writes of an example
sources = cache(lambda: derive_mechanism_sources(MechanismOfNumbers.from_toml(EXAMPLE)))


def told(step: NarrativeStep) -> Iterator[str]:
    """Yield the lines of a step."""
    yield f"## {step.title} ({step.id}{', long' if step.long else ''})"
    yield from step.text.splitlines()
    for formula in step.formulas:
        yield from filter(None, [formula.words])
        yield f"    {formula.latex}" + (f"    ({formula.thesis})" if formula.thesis else "")
    yield from (f"Code: {each.__module__}.{each.__qualname__}" for each in step.code)


def written(name: str) -> str:
    """Return the content of a file."""
    if name in SOURCES:
        return sources().latex if name == "document" else sources().module
    return "".join(f"{line}\n" for step in NARRATIVES[name]() for line in (*told(step), ""))


if __name__ == "__main__":
    for each in (*NARRATIVES, *SOURCES):
        FOLDER.joinpath(f"{each}.txt").write_text(written(each), encoding="utf-8")
