"""Time of an event and memory for chains of more and more bodies with stops and frictions.

Run it with `python -m benchmarks.large`. Each chain moves for a second in a process of its own, whose largest
memory counts, with all of Python and what is imported. Twice the bodies are to cost at most three times as
much an event, and the targets stand beside the memory.
"""

import resource
import subprocess
import sys
import time
from argparse import ArgumentParser

import numpy as np

from benchmarks.calibration import calibration, sentence
from trimmer.contact.flow import MechanismFlow
from trimmer.mechanism import GROUND, Body, Force, Friction, Link, Mechanism, Stop

CHAINS = (
    (6, 6, 6, 0),
    (12, 12, 12, 0),
    (25, 20, 20, 0),
    (50, 20, 20, 0),
    (20, 20, 20, 300),
    (200, 5, 5, 400),
)
"""Bodies, stops, frictions, and the target of memory, MB, 0 for none."""
DURATION, FREQUENCY = 1.0, 50.0


def chain(bodies: int, stops: int, frictions: int) -> Mechanism:
    """Return bodies in a row from the ground on, with stops and frictions evenly among them."""
    random = np.random.default_rng(0)
    names = [f"body {number}" for number in range(bodies)]

    def spread(count: int) -> list[str]:
        return [names[place] for place in np.linspace(0, bodies - 1, count).round().astype(int)]

    return Mechanism(
        bodies={name: Body(random.uniform(0.5, 1.5)) for name in names},
        links={
            name: Link((before, name), random.uniform(2e4, 4e4), random.uniform(2, 6))
            for before, name in zip([GROUND, *names], names, strict=False)
        },
        stops={
            f"stop {name}": Stop((GROUND, name), 2e5, 20.0, random.uniform(2e-4, 8e-4))
            for name in spread(stops)
        },
        frictions={
            f"pad {name}": Friction((GROUND, name), random.uniform(0.2, 0.8)) for name in spread(frictions)
        },
        forces={
            name: Force(name, amplitude=random.uniform(2, 8), phase=random.uniform(0, 6))
            for name in spread(min(5, bodies))
        },
        frequency=FREQUENCY,
    )


def measure(bodies: int, stops: int, frictions: int) -> None:
    """Print the number of events, the time of one when all modes are met, s, and the largest memory, MB."""
    flow = MechanismFlow(chain(bodies, stops, frictions))
    start = flow.rest()
    events = len(flow.timed(start, DURATION).events)
    memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    begun = time.process_time()
    flow.timed(start, DURATION)
    print(events, (time.process_time() - begun) / events / calibration(), memory)


def main() -> None:
    """Print a table."""
    print(sentence())
    for *counts, target in CHAINS:
        call = f"from benchmarks.large import measure; measure(*{counts})"
        ended = subprocess.run([sys.executable, "-c", call], capture_output=True, text=True, check=True)
        events, each, memory = map(float, ended.stdout.split())
        bound = f"   (target {target} MB)" if target else ""
        bodies, stops, frictions = counts
        print(
            f"{bodies:4} bodies, {stops:2} stops, {frictions:2} frictions  {events:6.0f} events, "
            f"each {1e3 * each:8.3f} thousandths of the calibration loop  {memory:6.0f} MB{bound}"
        )


if __name__ == "__main__":
    ArgumentParser(description=__doc__).parse_args()
    main()
