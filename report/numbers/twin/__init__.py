"""The thesis's trimmer with two-way contact: its motions, and what the kept maps and branches say."""
