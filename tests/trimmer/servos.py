"""Files of servos that follow a step, of which servo.json tells what they do."""

SERVO = """\
[bodies]
motor = { inertia = 0.0002 }
load = { inertia = 0.0005 }
[plays]
shaft = { between = ["motor", "load"], stiffness = 80.0, damping = 0.02, gap = 0.01 }
[frictions]
bearing = { between = ["ground", "motor"], force = 0.05, static = 0.08 }
guide = { between = ["ground", "load"], force = 0.08, static = 0.12, viscous = 0.001 }
[outputs]
angle = { motor = 1 }
torque = { control = "axis" }
[controllers.axis]
measure = "angle"
reference = "path"
acts = ["ground", "motor"]
kind = "pid"
kp = 6.0
kd = 0.09
filter_time = 1e-3
limit = 2.0
[references]
path = { step = 0.5, at = 0.01 }
"""
"""It comes to rest: backlash, frictions, a limit."""
STICTION = """
[bodies]
motor = { inertia = 0.0002 }
[frictions]
bearing = { between = ["ground", "motor"], force = 0.05, static = 0.08 }
[outputs]
angle = { motor = 1 }
[controllers.axis]
measure = "angle"
reference = "path"
acts = ["ground", "motor"]
kind = "pid"
kp = 6.0
ki = 120.0
kd = 0.05
filter_time = 1e-3
limit = 2.0
[references]
path = { step = 0.5, at = 0.01 }
"""
"""It hunts: an integral tears out again and again what sticks."""
SAMPLED = """
[bodies]
motor = { inertia = 0.0002 }
load = { inertia = 0.0005 }
[links]
shaft = { between = ["motor", "load"], stiffness = 80.0, damping = 0.02 }
bearing = { between = ["ground", "motor"], damping = 0.001 }
guide = { between = ["ground", "load"], damping = 0.001 }
[outputs]
angle = { motor = 1 }
torque = { control = "axis" }
[controllers.axis]
measure = "angle"
reference = "path"
acts = ["ground", "motor"]
kind = "pid"
kp = 1.5
ki = 10.0
kd = 0.04
filter_time = 0.002
sample = 0.001
delay = 0.0005
[references]
path = { step = 0.5, at = 0.0102 }
"""
"""It comes to rest, 0.5 ms behind its samples."""
