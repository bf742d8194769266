"""Mechanisms of the examples, with numbers set."""

from pathlib import Path

from trimmer import Body, Mechanism, Output

FOLDER = Path(__file__).parents[3] / "examples"


def example(name: str, **values: float) -> Mechanism:
    """Return an example with numbers set; a place is written with two underscores for each dot."""
    mechanism = Mechanism.from_toml(FOLDER / f"{name}.toml")
    for place, value in values.items():
        mechanism = mechanism.with_value(place.replace("__", "."), value)
    return mechanism


def twin(force: float = 0.5, gap: float = 40e-6, frequency: float = 110.0) -> Mechanism:
    """Return the trimmer of the thesis with play, by friction, N, gap, m, and frequency, Hz."""
    values = {"frictions__blade__force": force, "plays__bridge__gap": gap}
    return example("thesis-play", frequency=frequency, **values)


def body(mass: float = 1.0, **parts: object) -> Mechanism:
    """Return a machine of one body, whose displacement is its output, with its other parts."""
    return Mechanism(**{"bodies": {"body": Body(mass)}, "outputs": {"body": Output({"body": 1.0})}} | parts)
