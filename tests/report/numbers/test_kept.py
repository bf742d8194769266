"""All numbers that the report solves are those that were kept: ``kept.py`` sums them up and renews them."""

from tests.report.numbers.kept import KEPT, summed_up
from tests.trimmer.command_line.alike import alike


def test_solved_numbers_are_those_that_were_kept(evidence):
    kept, found = KEPT.read_text("utf-8").splitlines(), summed_up(evidence).splitlines()
    assert [line.partition(":")[0] for line in found] == [line.partition(":")[0] for line in kept]
    assert [pair for pair in zip(kept, found, strict=True) if not alike(*pair)] == []
