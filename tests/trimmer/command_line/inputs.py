"""Files that calls of the command line read: signals with known contents, and files as users leave them."""

import math
import wave
from pathlib import Path

import numpy as np

import trimmer
from trimmer import TrimmerParameters

EXAMPLES = Path(__file__).parents[3] / "examples"
THESIS = TrimmerParameters.thesis().to_toml()
GRAVITY = 9.80665
RATE, DRIVE = 5000.0, 110.3
TIMES = np.arange(20_000) / RATE
AMPLITUDES = {1: 1.2e-3, 2: 2e-5, 3: 1.5e-4}
"""Displacement that ``logger.csv``, ``recorder.wav`` and ``volts.csv`` hold, by harmonic of the drive, m."""
MACHINE = """
title = "Oscillator at a stop"
frequency = 20.0
[bodies]
mass = { mass = 1.0 }
[pins]
[links]
spring = { between = ["ground", "mass"], stiffness = 1e4, damping = 10.0 }
[stops]
wall = { between = ["mass", "ground"], stiffness = 1e5, damping = 20.0, gap = 1e-3 }
[forces]
shaker = { on = "mass", amplitude = 40.0 }
[outputs]
mass = { mass = 1 }
"""
FREE = """
[bodies]
mass = { mass = 1.0 }
other = { mass = 2.0 }
[pins]
[links]
spring = { between = ["mass", "other"], stiffness = 1e4 }
"""
SCATTER = """
[uncertainty]
"plays.bridge.gap" = { normal = "5 um" }
"frictions.blade.force" = { uniform = ["0.9 N", "1.3 N"] }
'links."motor mount".stiffness' = { uniform = "10 %" }
"""


def write_inputs(folder: Path) -> None:
    """Write all of them into a folder, with a link to the examples."""
    (folder / "examples").symlink_to(EXAMPLES)
    (folder / "folder").mkdir()
    (folder / "binary").write_bytes(bytes(range(256)))
    noise = np.random.default_rng(3).normal(size=TIMES.size)
    for name, text in {**_texts(), **_signals(noise), **_simulated()}.items():
        (folder / name).write_text(text, "latin-1" if name == "latin.csv" else "utf-8")
    clipped = np.clip(np.rint(32768 * _acceleration(noise) / 60), -32768, 32767)
    with wave.open(str(folder / "recorder.wav"), "wb") as sound:
        sound.setnchannels(2)
        sound.setsampwidth(2)
        sound.setframerate(int(RATE))
        sound.writeframes(np.stack([np.zeros(TIMES.size), clipped], axis=1).astype("<i2").tobytes())


def _texts() -> dict[str, str]:
    undamped, twin = THESIS, (EXAMPLES / "thesis-play.toml").read_text("utf-8")
    for symbol, value in (("c1", 3.5), ("c2", 0.4), ("c3", 1.0), ("c4", 4.0)):
        undamped = undamped.replace(f"{symbol} = {value}", f"{symbol} = 0")
    return {
        "empty.toml": " \n",
        "empty.csv": "",
        "notes.svg": "notes",
        "mine.toml": THESIS,
        "thesis.svg": THESIS,
        "heavy.toml": THESIS.replace("m1 = 0.035", "m1 = 0.07"),
        "undamped.toml": undamped,
        "wrong.toml": THESIS.replace("m1 = 0.035", "m1 = nan").replace("k5", "k6"),
        "open.toml": THESIS.replace("k2 = 30000.0", "k2 = 0").replace("c2 = 0.4", "c2 = 0"),
        "series.toml": f'{THESIS}\n[uncertainty]\nm1 = {{ normal = "2 %" }}\nk2 = {{ normal = "5 %" }}\n',
        "stop.toml": MACHINE,
        "free.toml": FREE,
        "scatter.toml": f"{twin}{SCATTER}",
        "untargeted.toml": f"{MACHINE}[uncertainty]\nfrequency = {{ normal = '1 %' }}\n",
        "two.toml": MACHINE + "turned = { mass = -1 }\n",
        "fast.toml": twin.replace("frequency = 110.0", "frequency = 1e308"),
        "slow.toml": twin.replace("frequency = 110.0", "frequency = 5e-324"),
        "many.toml": "".join(f"strange{number} = {number}\n" for number in range(500)) + FREE,
    }


def _signals(noise: np.ndarray) -> dict[str, str]:
    times = np.arange(20_000) / 20_000
    parts = {109.845: 1e-3, 3 * 109.845: 5e-5, 553.59: 3e-5, 900.0: 1e-5}
    motion = 2e-6 + 2e-8 * noise + sum(size * np.cos(math.tau * f * times) for f, size in parts.items())
    measured, short = _acceleration(noise), 1e-3 * np.cos(math.tau * 110 * times[::10])
    kept = np.r_[0:9000, 9400:20_000]
    logged = (f"{TIMES[k]:.3f};{measured[k]:.4f}".replace(".", ",") for k in kept)
    latin = [f"{k / 2:.1f};{1e3 * each:.9f};0".replace(".", ",") for k, each in enumerate(short)]
    latin[500] = latin[500].split(";")[0] + ";;0"
    stamps = TIMES[:8000] + np.random.default_rng(4).uniform(-3e-5, 3e-5, 8000)
    jitter = np.cos(math.tau * DRIVE * stamps) + 0.05 * np.cos(math.tau * 1500.0 * stamps)
    omega = np.geomspace(0.2, 5.0, 24)
    plant = 4.0 / (1j * omega * (1.0 + 1j * omega) ** 2)
    cycle = 1.7e-4 * np.sin(math.tau * 729.0 * times[:6000]) + 1e-8 * noise[:6000]
    return {
        "plant.csv": _table("omega,real,imaginary", omega, plant.real, plant.imag),
        "cycle.csv": _table("time [s],output [m]", times[:6000], cycle),
        "motion.csv": _table("time [s],q2-q4 [m]", times, motion),
        "logger.csv": "\n".join(["Logger 3000", "serial;1234", "Time;Accel X", "s;g", *logged]),
        "jitter.csv": _table("t [ms],v [mm/s]", 1e3 * stamps, jitter),
        "volts.csv": _table("U [V]", 0.1 * measured),
        "latin.csv": "\r\n".join(["Time;Weg;Kanal µ", "ms;µm;V", *latin, ""]),
        "bare.csv": "\n".join(f"{1e3 * each:.9f}".replace(".", ",") for each in short),
        "tab.csv": "\n".join(f"{each:.9f}\t{k}" for k, each in enumerate(1e3 * short)),
        "short.csv": _table("time [s],x [m]", np.arange(3.0), np.zeros(3)),
        "slow.csv": _table("time [s],x [m]", np.arange(30) / 2, np.zeros(30)),
        "zero.csv": _table("time [s],x", np.arange(400) / 2000, np.zeros(400)),
    }


def _acceleration(noise: np.ndarray) -> np.ndarray:
    """Return what an accelerometer on the blade gives, g: noise, offset and drift with it."""
    moved = sum(
        -((math.tau * n * DRIVE) ** 2) * a * np.cos(math.tau * n * DRIVE * TIMES + n)
        for n, a in AMPLITUDES.items()
    )
    acceleration: np.ndarray = moved / GRAVITY + 0.3 * noise + 0.8 + 0.05 * TIMES
    return acceleration


def _simulated() -> dict[str, str]:
    """Return records of mechanisms, with a little noise: a velocity, and the stroke of the trimmer."""
    rng = np.random.default_rng(0)
    motion = trimmer.simulate(trimmer.Mechanism.from_toml_text(MACHINE), 4.0)
    times = np.arange(2.013, 4.0, 5e-4)
    velocity = motion.velocity("mass", times)
    small, large = 1e-3 * rng.normal(size=times.size), 0.02 * rng.normal(size=times.size)
    speed = _table("t,v [m/s],turned [m/s],rough [m/s]", times, velocity + small, -velocity, velocity + large)
    twin = trimmer.Mechanism.from_toml(EXAMPLES / "thesis-play.toml").with_value("frictions.blade.force", 1.0)
    late = 0.4 + np.arange(3000) / 10_000
    stroke = trimmer.simulate(twin, 0.8).output("stroke", late) + 2e-6 * rng.normal(size=late.size)
    hum = np.clip(stroke + 1e-4 * np.cos(100 * math.pi * late), -1.2e-3, 1.2e-3)
    return {
        "speed.csv": speed,
        "stroke.csv": _table("time [s],stroke [m]", late, stroke),
        "clipped.csv": _table("time [s],stroke [m]", late, hum),
        "pair.csv": _table("time [s],a [m],b [m]", late, stroke, stroke),
    }


def _table(head: str, *columns: np.ndarray) -> str:
    rows = (",".join(f"{each:.9g}" for each in row) for row in zip(*columns, strict=True))
    return "\n".join([head, *rows, ""])
