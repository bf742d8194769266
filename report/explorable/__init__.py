"""The explorable: gap, load, damping, friction and the pin's velocity move the limit cycle."""
