"""Chromium without a window, driven over the DevTools protocol through a pair of pipes.

With `--remote-debugging-pipe` Chromium reads commands from descriptor 3 and writes answers and
events to descriptor 4, JSON texts that end with a zero byte; no network and no further package take
part.
"""

import contextlib
import json
import os
import shutil
import subprocess
import sys
import time

CHROMIUM = shutil.which("chromium") or shutil.which("google-chrome")
OPTIONS = ["--headless", "--no-sandbox", "--no-first-run", "--remote-debugging-pipe"]
OPTIONS += ["--disable-gpu", "--disable-dev-shm-usage"]
# Descriptors of this process become 3 and 4 of Chromium.
START = "import os, sys; r, w, *c = sys.argv[1:]; os.dup2(int(r), 53); os.dup2(int(w), 54); "
START += "os.dup2(53, 3); os.dup2(54, 4); os.execv(c[0], c)"
SECONDS = 60.0


class Page:
    """A page in a browser, and everything that Chromium reported of it."""

    def __init__(self, commands, answers):
        self._commands, self._answers = commands, answers
        self._last, self._session, self._rest = 0, None, b""
        self.events = []

    def open(self, url, width, height):
        """Show a page in a new window of a size, and forget what happened before."""
        self._session, self.events = None, []
        target = self.call("Target.createTarget", url="about:blank")["targetId"]
        attached = self.call("Target.attachToTarget", targetId=target, flatten=True)
        self._session = attached["sessionId"]
        for domain in ("Page", "Runtime", "Network", "Log"):
            self.call(f"{domain}.enable")
        self.resize(width, height)
        self.call("Page.navigate", url=url)

    def resize(self, width, height):
        """Give the window a size in pixels."""
        metrics = {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": False}
        self.call("Emulation.setDeviceMetricsOverride", **metrics)

    def evaluate(self, expression):
        """The value of an expression of JavaScript."""
        answer = self.call("Runtime.evaluate", expression=expression, returnByValue=True)
        assert "exceptionDetails" not in answer, answer["exceptionDetails"]
        return answer["result"].get("value")

    def wait_for(self, expression):
        """Wait until an expression holds."""
        deadline = time.monotonic() + SECONDS
        while not self.evaluate(expression):
            assert time.monotonic() < deadline, f"{expression} does not come to hold"
            time.sleep(0.05)

    def call(self, method, **params):
        """Give a command and wait for its answer."""
        self._last += 1
        command = {"id": self._last, "method": method, "params": params}
        if self._session:
            command["sessionId"] = self._session
        self._commands.write(json.dumps(command).encode() + b"\0")
        while True:
            message = self._read()
            if message.get("id") == self._last:
                assert "error" not in message, f"{method}: {message['error']}"
                return message["result"]
            self.events.append(message)

    def _read(self):
        while b"\0" not in self._rest:
            more = os.read(self._answers, 2**16)
            assert more, "Chromium has ended"
            self._rest += more
        message, _, self._rest = self._rest.partition(b"\0")
        return json.loads(message)

    def reports(self, method):
        """What Chromium reported under the name of an event."""
        return [event["params"] for event in self.events if event.get("method") == method]

    def complaints(self):
        """Errors and warnings on the console, and exceptions that nothing caught."""
        printed = [(one["type"], one) for one in self.reports("Runtime.consoleAPICalled")]
        logged = [(one["entry"]["level"], one) for one in self.reports("Log.entryAdded")]
        found = [one for level, one in printed + logged if level in ("error", "warning")]
        return self.reports("Runtime.exceptionThrown") + found

    def requests(self):
        """Addresses that were asked for, but for those that the page holds itself."""
        sent = self.reports("Network.requestWillBeSent")
        urls = [params["request"]["url"] for params in sent]
        return [url for url in urls if not url.startswith(("data:", "blob:"))]


@contextlib.contextmanager
def browser(profile):
    """A browser with a profile in a folder of its own."""
    here_out, here_in = os.pipe(), os.pipe()
    command = [CHROMIUM, *OPTIONS, f"--user-data-dir={profile}", "about:blank"]
    process = subprocess.Popen(
        [sys.executable, "-c", START, str(here_out[0]), str(here_in[1]), *command],
        pass_fds=(here_out[0], here_in[1]),
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )
    os.close(here_out[0])
    os.close(here_in[1])
    try:
        with open(here_out[1], "wb", buffering=0) as commands:
            page = Page(commands, here_in[0])
            yield page
            page._session = None
            page.call("Browser.close")
    finally:
        os.close(here_in[0])
        try:
            process.wait(10)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()
