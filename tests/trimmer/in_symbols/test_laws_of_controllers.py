"""What is told of each kind of controller in formulas, as kept in ``laws_of_controllers.txt``.

``python -m tests.trimmer.in_symbols.test_laws_of_controllers`` writes it anew. That machines move by these
laws is asked in ``tests/trimmer/contact``.
"""

from pathlib import Path

from trimmer import Mechanism
from trimmer.code_generation import derive_mechanism_sources

KEPT = Path(__file__).with_name("laws_of_controllers.txt")
PID = 'kind = "pid", kp = 6.0, ki = 120.0, kd = 0.05, filter_time = 1e-3, limit = 2.0'
CASCADE = 'kind = "cascade", kp = 50.0, kv = 0.6'
TRANSFER = 'kind = "transfer", denominator = [1e-3, 1.0]'
CONTROLLERS = (
    f'{PID}, reference = "step"',
    f'{PID}, reference = "ramp", sample = 1e-3, delay = 5e-4',
    f'{CASCADE}, ti = 0.02, speed = "speed", feedforward = 1.0, reference = "sine"',
    f'{CASCADE}, ti = 0.02, speed = "difference", reference = "profile", sample = 2e-3',
    f'{CASCADE}, speed = "speed", reference = "step", sample = 1e-3',
    f"{TRANSFER}, numerator = [1.0, 20.0], delay = 1e-3, pade = 2",
    f"{TRANSFER}, numerator = [-1.0, 20.0], sample = 1e-3",
)
MACHINE = """\
[bodies]
motor = { inertia = 0.0002 }
[outputs]
angle = { motor = 1 }
speed = { velocity = { motor = 1 } }
[references]
step = { step = 0.5, at = 0.01 }
ramp = { ramp = 2.0, at = 0.02 }
sine = { sine = 0.1, frequency = 3.0, phase = 0.5 }
profile = { profile = [[0, 0], [1, 3], [2, 0.5]] }
[controllers]
""" + "".join(
    f'c{number} = {{ measure = "angle", acts = ["ground", "motor"], {each} }}\n'
    for number, each in enumerate(CONTROLLERS, start=1)
)


def told() -> str:
    """Return the sections of the controllers, a line for each formula."""
    latex = derive_mechanism_sources(Mechanism.from_toml_text(MACHINE)).latex
    sections = latex[latex.index("\\section{Controller") : latex.index("\\section{Checks}")]
    lines = (line for line in sections.splitlines() if line and not line.endswith("{dmath*}"))
    return "".join(f"{line}\n" for line in lines)


def test_the_law_of_each_kind_is_told_as_it_was() -> None:
    assert told().splitlines() == KEPT.read_text("utf-8").splitlines()


if __name__ == "__main__":
    KEPT.write_text(told(), "utf-8")
