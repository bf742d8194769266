"""Backlash of three kinds: the load behind it stops at once, is braked, or keeps its velocity."""
