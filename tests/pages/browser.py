# SPDX-License-Identifier: GPL-3.0-or-later
"""Headless Chromium, controlled by the DevTools protocol (Debian: chromium, python3-websocket)."""

import base64
import collections
import itertools
import json
import os
import shutil
import subprocess
import sys
import tempfile
import threading
import unittest
from pathlib import Path

import websocket

LIMIT = 1800  # seconds for an answer, against hanging


class Browser:
    """A Chromium process with a fresh profile and no network."""

    def __init__(self):
        program = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
        if program is None:
            raise FileNotFoundError("chromium is not installed")
        self.profile = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        options = ["--headless=new", "--remote-debugging-port=0", "--remote-allow-origins=*", "--no-first-run",
                   "--disable-gpu", "--disable-dev-shm-usage", "--hide-scrollbars", "--force-device-scale-factor=1",
                   "--disable-background-networking", "--disable-component-update", "--disable-sync",
                   "--host-resolver-rules=MAP * ~NOTFOUND", f"--user-data-dir={self.profile.name}"]
        if os.geteuid() == 0:
            options.append("--no-sandbox")  # which Chromium refuses to root
        self.process = subprocess.Popen([program, *options, "about:blank"], stdin=subprocess.DEVNULL,
                                        stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        said = []
        for line in self.process.stderr:
            said.append(line)
            if line.startswith("DevTools listening on "):
                break
        else:
            raise RuntimeError("chromium does not start:\n" + "".join(said))
        # The rest of its output is discarded: a full pipe would block it.
        threading.Thread(target=collections.deque, args=(self.process.stderr, 0), daemon=True).start()
        self.socket = websocket.create_connection(line.split()[-1], timeout=LIMIT)
        self.numbers, self.events = itertools.count(1), []

    def call(self, method, session=None, **parameters):
        number = next(self.numbers)
        message = {"id": number, "method": method, "params": parameters}
        if session:
            message["sessionId"] = session
        self.socket.send(json.dumps(message))
        while True:
            answer = json.loads(self.socket.recv())
            if answer.get("id") == number:
                if "error" in answer:
                    raise RuntimeError(f"{method}: {answer['error']['message']}")
                return answer["result"]
            self.events.append(answer)

    def wait_for(self, method, session):
        while True:
            for event in self.events:
                if event["method"] == method and event.get("sessionId") == session:
                    return event["params"]
            self.events.append(json.loads(self.socket.recv()))

    def close(self):
        try:
            self.call("Browser.close")
        except (OSError, websocket.WebSocketException):
            self.process.kill()
        self.process.wait()
        self.process.stderr.close()
        self.socket.close()
        self.profile.cleanup()


class Page:
    """A file, opened in its own tab: its console output, its requests and its contents."""

    def __init__(self, browser, path, width=1280, height=900, dark=False, scripts=True):
        self.browser = browser
        self.target = browser.call("Target.createTarget", url="about:blank")["targetId"]
        self.session = browser.call("Target.attachToTarget", targetId=self.target, flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.call(f"{domain}.enable")
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=False)
        self.call("Emulation.setEmulatedMedia",
                  features=[{"name": "prefers-color-scheme", "value": "dark" if dark else "light"}])
        self.call("Emulation.setScriptExecutionDisabled", value=not scripts)
        self.address = Path(path).resolve().as_uri()
        self.call("Page.navigate", url=self.address)
        browser.wait_for("Page.loadEventFired", self.session)

    def call(self, method, **parameters):
        return self.browser.call(method, self.session, **parameters)

    def ours(self, method):
        return [e["params"] for e in self.browser.events if e["method"] == method
                and e.get("sessionId") == self.session]

    def evaluate(self, expression):
        """The value of an expression in the page; a promise is waited for."""
        answer = self.call("Runtime.evaluate", expression=expression, returnByValue=True, awaitPromise=True)
        if "exceptionDetails" in answer:
            raise RuntimeError(f"{expression}: {answer['exceptionDetails']}")
        return answer["result"].get("value")

    def click(self, selector):
        """Clicks where the middle of an element is, as a mouse would."""
        x, y = self.evaluate(f"""(() => {{ const e = document.querySelector({json.dumps(selector)});
            e.scrollIntoView({{block: 'center'}}); const r = e.getBoundingClientRect();
            return [r.x + r.width / 2, r.y + r.height / 2]; }})()""")
        for kind in ("mousePressed", "mouseReleased"):
            self.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left", clickCount=1)

    def press(self, key):
        for kind in ("keyDown", "keyUp"):
            self.call("Input.dispatchKeyEvent", type=kind, key=key, code=key,
                      windowsVirtualKeyCode={"ArrowRight": 39, "ArrowLeft": 37, "Home": 36, "End": 35,
                                             "Enter": 13}[key],
                      **({"text": "\r"} if key == "Enter" and kind == "keyDown" else {}))

    def complaints(self):
        """Warnings, errors and exceptions on the console."""
        # Pending work of the page is done.
        self.evaluate("document.fonts.ready.then(() => new Promise(done => setTimeout(done, 0)))")
        found = [str(p["args"]) for p in self.ours("Runtime.consoleAPICalled")
                 if p["type"] in ("error", "warning", "assert")]
        found += [p["entry"]["text"] for p in self.ours("Log.entryAdded")
                  if p["entry"]["level"] in ("error", "warning")]
        return found + [str(p["exceptionDetails"]) for p in self.ours("Runtime.exceptionThrown")]

    def fetched(self):
        """All requests except that of the page itself."""
        return [p["request"]["url"] for p in self.ours("Network.requestWillBeSent")
                if p["request"]["url"] != self.address]

    def screenshot(self, path, whole=True):
        shot = {}
        if whole:
            size = self.call("Page.getLayoutMetrics")["cssContentSize"]
            shot = {"captureBeyondViewport": True,
                    "clip": {"x": 0, "y": 0, "width": size["width"], "height": size["height"], "scale": 1}}
        Path(path).write_bytes(base64.b64decode(self.call("Page.captureScreenshot", format="png", **shot)["data"]))

    def close(self):
        self.browser.call("Target.closeTarget", targetId=self.target)
        self.browser.events = [e for e in self.browser.events if e.get("sessionId") != self.session]


class BrowserTest(unittest.TestCase):
    """Tests that share one browser, `self.browser`. The program ends with 77, skipped, where there is no Chromium."""

    @classmethod
    def setUpClass(cls):
        try:
            cls.browser = Browser()
        except FileNotFoundError as missing:
            print(f"tests/pages: {missing} (tools/setup --deep)")
            sys.exit(77)

    @classmethod
    def tearDownClass(cls):
        cls.browser.close()
