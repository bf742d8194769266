"""Prose as it is read."""

from report.judging.text import one_line


def test_a_text_block_is_one_line():
    block = r"""
        With $\frac{b}{A}$ and $\{1\}$ the gain
        is 2.0 at most.
        """
    assert one_line(block) == r"With $\frac{b}{A}$ and $\{1\}$ the gain is 2.0 at most."


def test_a_no_break_space_is_no_space_to_break_at():
    assert one_line("0.1\u00a0 m") == "0.1\u00a0 m"
