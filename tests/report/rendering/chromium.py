"""A small client of Chromium's DevTools protocol, over the pipe on its descriptors 3 and 4."""

from __future__ import annotations

import contextlib
import fcntl
import json
import os
import select
import signal
import tempfile
import time
from collections.abc import Iterator
from typing import Any

TIMEOUT = 60.0
FLAGS = (
    "--headless",
    "--no-sandbox",
    "--disable-gpu",
    "--no-first-run",
    "--disable-quic",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--hide-scrollbars",
    "--remote-debugging-pipe",
)


class Page:
    """A tab of the browser; ``events`` holds what the protocol reported about it."""

    def __init__(self, connection: Connection, session: str, target: str) -> None:
        self._connection = connection
        self._session = session
        self._target = target
        for domain in ("Page", "Runtime", "Network", "Log"):
            self.send(f"{domain}.enable")

    def send(self, method: str, **parameters: Any) -> dict[str, Any]:
        return self._connection.send(method, parameters, self._session)

    def close(self) -> None:
        self._connection.send("Target.closeTarget", {"targetId": self._target})

    def view(self, width: int, height: int, scheme: str = "light") -> None:
        """Set the size of the window in CSS pixels and the preferred colour scheme."""
        size = {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": False}
        self.send("Emulation.setDeviceMetricsOverride", **size)
        feature = {"name": "prefers-color-scheme", "value": scheme}
        self.send("Emulation.setEmulatedMedia", features=[feature])

    def open(self, address: str) -> None:
        """Load an address anew and wait until it is there."""
        self.send("Page.navigate", url="about:blank")
        self.send("Page.navigate", url=address)
        self.wait_for("document.readyState === 'complete' && location.href !== 'about:blank'")

    def wait_for(self, condition: str) -> None:
        deadline = time.monotonic() + TIMEOUT
        while not self.evaluate(condition):
            assert time.monotonic() < deadline, f"not so within {TIMEOUT} s: {condition}"
            time.sleep(0.02)

    def evaluate(self, expression: str) -> Any:
        answer = self.send("Runtime.evaluate", expression=expression, returnByValue=True, awaitPromise=True)
        assert "exceptionDetails" not in answer, answer["exceptionDetails"]
        return answer["result"].get("value")

    def press(self, key: str, code: int) -> None:
        """Press and release a key."""
        text = {"text": key} if len(key) == 1 else {}
        self.send("Input.dispatchKeyEvent", type="keyDown", key=key, windowsVirtualKeyCode=code, **text)
        self.send("Input.dispatchKeyEvent", type="keyUp", key=key, windowsVirtualKeyCode=code)

    @property
    def events(self) -> list[dict[str, Any]]:
        return [event for event in self._connection.events if event.get("sessionId") == self._session]


class Connection:
    """Commands and answers as JSON, each ended by a zero byte."""

    def __init__(self, reading: int, writing: int) -> None:
        self._reading, self._writing = reading, writing
        self._buffer = b""
        self._last = 0
        self.events: list[dict[str, Any]] = []

    def send(self, method: str, parameters: dict[str, Any], session: str | None = None) -> dict[str, Any]:
        """Send a command and return its result; events that arrive meanwhile are kept."""
        self._last += 1
        command = {"id": self._last, "method": method, "params": parameters}
        if session is not None:
            command["sessionId"] = session
        self._write(json.dumps(command).encode() + b"\0")
        while True:
            message = self._read()
            if message.get("id") == self._last:
                assert "error" not in message, f"{method}: {message['error']}"
                return dict(message["result"])
            self.events.append(message)

    def page(self) -> Page:
        target = self.send("Target.createTarget", {"url": "about:blank"})["targetId"]
        session = self.send("Target.attachToTarget", {"targetId": target, "flatten": True})["sessionId"]
        return Page(self, session, target)

    def _write(self, data: bytes) -> None:
        while data:
            data = data[os.write(self._writing, data) :]

    def _read(self) -> dict[str, Any]:
        while b"\0" not in self._buffer:
            ready, _, _ = select.select([self._reading], [], [], TIMEOUT)
            assert ready, f"Chromium said nothing for {TIMEOUT} s"
            piece = os.read(self._reading, 1 << 20)
            assert piece, "Chromium closed its pipe"
            self._buffer += piece
        message, _, self._buffer = self._buffer.partition(b"\0")
        return dict(json.loads(message))


@contextlib.contextmanager
def running(chromium: str) -> Iterator[Connection]:
    """Start Chromium with an empty profile and end it, and only it, afterwards."""
    with contextlib.ExitStack() as stack:
        profile = stack.enter_context(tempfile.TemporaryDirectory(ignore_cleanup_errors=True))
        commands, answers = _pipe(stack), _pipe(stack)
        silence = stack.enter_context(open(os.devnull, "w"))
        process = os.posix_spawn(
            chromium,
            [chromium, *FLAGS, f"--user-data-dir={profile}", "about:blank"],
            dict(os.environ),
            file_actions=[
                (os.POSIX_SPAWN_DUP2, commands[0], 3),
                (os.POSIX_SPAWN_DUP2, answers[1], 4),
                (os.POSIX_SPAWN_DUP2, silence.fileno(), 1),
                (os.POSIX_SPAWN_DUP2, silence.fileno(), 2),
            ],
        )
        connection = Connection(answers[0], commands[1])
        try:
            yield connection
        finally:
            _end(process, connection)


def _pipe(stack: contextlib.ExitStack) -> tuple[int, int]:
    """Return a pipe whose descriptors are above those that Chromium is given."""
    ends = []
    for low in os.pipe():
        high = fcntl.fcntl(low, fcntl.F_DUPFD_CLOEXEC, 10)
        os.close(low)
        stack.callback(os.close, high)
        ends.append(high)
    return ends[0], ends[1]


def _end(process: int, connection: Connection) -> None:
    with contextlib.suppress(AssertionError, OSError):
        connection.send("Browser.close", {})
    deadline = time.monotonic() + 10.0
    while time.monotonic() < deadline:
        if os.waitpid(process, os.WNOHANG)[0]:
            return
        time.sleep(0.05)
    os.kill(process, signal.SIGKILL)
    os.waitpid(process, 0)
