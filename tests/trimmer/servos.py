"""Files of servos that follow a step."""

from tests.trimmer.problem_machines import machine_text

SERVO = machine_text("servo-to-rest")  # It comes to rest: backlash, frictions, a limit
STICTION = machine_text("stiction-pid")  # It hunts: an integral tears out again and again what sticks
SAMPLED = machine_text("sampled-axis")  # It comes to rest, 0.5 ms behind its samples
