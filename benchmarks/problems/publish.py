"""Publish the problems: a page in Markdown, and JSON and CSV for others to use.

``python -m benchmarks.problems.publish FOLDER`` writes problems.md, problems.json and digits.csv.
"""

import csv
import io
import json
import sys
from argparse import ArgumentParser
from collections.abc import Iterator
from pathlib import Path

from benchmarks.problems.proven import proven_digits
from benchmarks.problems.read import FOLDER, Problem, problems

TABLE = Path(__file__).parents[1] / "peers" / "table.md"  # What the last run of the peers gave
FIRST = """# Problems with digits

{number} problems of play, stops, friction, impact and control, with {digits} numbers, each found in two
independent ways at least. Take them to test a program of your own: [problems.json](problems.json) has
statements and digits, [digits.csv](digits.csv) the digits alone. The second ways are short programs in
`benchmarks/problems/second_ways` that use SciPy and mpmath alone. `python -m benchmarks.problems.ask` runs
both ways again. `CITATION.cff` says how to cite them.

Of these numbers {proven} are proven too, by ball arithmetic, to the digits that the last column says: the
motion, or the special point, is there, with these events and no other, and what is read of it is enclosed.
The proofs stand in `benchmarks/problems/proofs`; `trimmer check FILE` verifies each again without a solver,
of the equations in its file. A grazing of motions that have events besides,
and the end of infinitely many impacts, are not covered.

"""


def conventions() -> str:
    """Return what holds for all statements, Markdown."""
    return (FOLDER / "conventions.md").read_text(encoding="utf-8")


def as_json() -> str:
    """Return conventions and problems as JSON."""
    return json.dumps(
        {"conventions": conventions(), "problems": [_told(each) for each in problems()]},
        indent=1,
        ensure_ascii=False,
    )


def _told(problem: Problem) -> dict[str, object]:
    digits = [
        {
            "name": each.name,
            "value": each.value,
            "unit": each.unit,
            "agreement": each.agreement,
            "ways": list(each.ways),
            "proven_digits": proven_digits(problem, each),
        }
        for each in problem.digits
    ]
    whole = {"name": problem.name, "title": problem.title, "kinds": list(problem.kinds)}
    return {**whole, "source": problem.source, "statement": problem.statement, "digits": digits}


def as_csv() -> str:
    """Return a line for each digit."""
    written = io.StringIO()
    table = csv.writer(written, lineterminator="\n")
    table.writerow(["problem", "digit", "value", "unit", "agreement", "ways", "proven_digits"])
    for problem in problems():
        for each in problem.digits:
            told = [problem.name, each.name, repr(each.value), each.unit, each.agreement]
            table.writerow([*told, "; ".join(each.ways), proven_digits(problem, each)])
    return written.getvalue()


def page() -> str:
    """Return the page of all problems, Markdown."""
    all_of_them = problems()
    proven = [proven_digits(problem, each) for problem in all_of_them for each in problem.digits]
    count = sum(each > 0 for each in proven)
    parts = [FIRST.format(number=len(all_of_them), digits=len(proven), proven=count)]
    parts += ["## Conventions\n\n", conventions(), "\n"]
    for problem in all_of_them:
        parts += _section(problem)
    if TABLE.exists():
        parts.append(TABLE.read_text(encoding="utf-8"))
    return "".join(parts)


def _section(problem: Problem) -> Iterator[str]:
    yield f"## {problem.title}\n\n`{problem.name}`: {', '.join(problem.kinds)}. Source: {problem.source}.\n\n"
    yield f"{problem.statement}\n\n| asked | digits | unit | agreement | proven |\n"
    yield "| --- | --- | --- | --- | --- |\n"
    for each in problem.digits:
        proven = proven_digits(problem, each) or "no"
        yield f"| {each.name} | {each.printed} | {each.unit} | {each.agreement:.0e} | {proven} |\n"
    ways = dict.fromkeys(each.ways for each in problem.digits)
    for found in ways:
        names = "" if len(ways) == 1 else f"{', '.join(e.name for e in problem.digits if e.ways == found)}: "
        yield f"\nFound by: {names}{'; '.join(found)}.\n"
    yield '\n<details markdown="1"><summary>With this package</summary>\n\n'
    if problem.python:
        yield f"```python\n{problem.python.strip()}\n```\n"
    else:
        yield f"```toml\n{problem.machine.strip()}\n```\n\n```sh\n"
        yield from (f"trimmer {line.replace('FILE', 'machine.toml')}\n" for line in problem.asks.values())
        yield "```\n"
    yield "\n</details>\n\n"


def main() -> None:
    """Write the three files."""
    parser = ArgumentParser(prog="python -m benchmarks.problems.publish", description=__doc__)
    parser.add_argument("folder", type=Path, help="where the files go")
    folder: Path = parser.parse_args().folder
    folder.mkdir(parents=True, exist_ok=True)
    for name, content in {"problems.md": page(), "problems.json": as_json(), "digits.csv": as_csv()}.items():
        (folder / name).write_text(content, encoding="utf-8")


if __name__ == "__main__":
    main()
    sys.exit(0)
