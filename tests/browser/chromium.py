# SPDX-License-Identifier: GPL-3.0-or-later
"""Drives a headless Chromium by its debugging protocol: mouse, fingers, keys, dropped and downloaded files, screenshots, and the
longest time for which the page is blocked. This is processor time, which other load on the machine does not change."""

import base64
import http.server
import json
import os
import pathlib
import shutil
import subprocess
import tempfile
import threading
import time
import urllib.request

import websocket

# Counts the frames in which the page is painted, and notes when the first one has been painted (s since 1970).
MEASURE = """
window.measured = {frames: 0, painted: null};
{
  let isPainted = false;
  for (const name of ["putImageData", "drawImage"]) {
    const paint = CanvasRenderingContext2D.prototype[name];
    CanvasRenderingContext2D.prototype[name] = function (...all) { isPainted = true; return paint.apply(this, all); };
  }
  const next = () => {
    if (isPainted) {
      measured.frames += 1;
      measured.painted ??= (performance.timeOrigin + performance.now()) / 1000;
    }
    isPainted = false;
    requestAnimationFrame(next);
  };
  requestAnimationFrame(next);
}
"""


def serve(folder):
    """Serves a folder to this machine only. Returns the address."""

    class QuietHandler(http.server.SimpleHTTPRequestHandler):
        extensions_map = {**http.server.SimpleHTTPRequestHandler.extensions_map, ".wasm": "application/wasm"}

        def __init__(self, *arguments):
            super().__init__(*arguments, directory=str(folder))

        def log_message(self, *_):
            pass

    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), QuietHandler)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    return f"http://127.0.0.1:{server.server_address[1]}/"


class Chromium:
    def __init__(self, width, height, is_dark=False, is_phone=False):
        self.size = (width, height)
        self.profile = pathlib.Path(tempfile.mkdtemp(prefix="slidercrank-browser-"))
        self.downloads = self.profile / "downloads"
        self.downloads.mkdir()
        self.process = subprocess.Popen(
            ["chromium", "--headless=new", "--no-sandbox", "--disable-gpu", "--no-first-run", "--remote-debugging-port=0",
             "--remote-allow-origins=*", "--disable-dev-shm-usage", f"--user-data-dir={self.profile}", "--disable-extensions", "--mute-audio",
             "--disable-background-networking", f"--window-size={width},{height}", "about:blank"],
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.socket = websocket.create_connection(self._address(), max_size=None, timeout=60)
        self.last_id = 0
        self.console = []  # lines that the page has written to its console, and its errors
        self.requests = []  # addresses that the page has asked for
        self.chooser = None
        self.trace = None  # events of the recording; None while nothing is recorded
        self.longest_block = 0.0  # s
        for domain in ("Page", "Runtime", "Log", "DOM"):
            self.call(domain + ".enable")
        # Otherwise Chromium would keep a copy of all that a page loads, for which the page would wait.
        self.call("Network.enable", maxTotalBufferSize=0, maxResourceBufferSize=0)
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=is_phone)
        self.call("Emulation.setEmulatedMedia",
                  features=[{"name": "prefers-color-scheme", "value": "dark" if is_dark else "light"}])
        self.call("Performance.enable", timeDomain="threadTicks")
        self.call("Browser.setDownloadBehavior", behavior="allow", downloadPath=str(self.downloads))
        self.call("Page.setInterceptFileChooserDialog", enabled=True)
        self.call("Page.addScriptToEvaluateOnNewDocument", source=MEASURE)

    def _address(self):
        port_file = self.profile / "DevToolsActivePort"
        end = time.time() + 60
        while time.time() < end:
            try:
                port = port_file.read_text().split("\n")[0]
                pages = json.load(urllib.request.urlopen(f"http://127.0.0.1:{port}/json"))
                return next(page["webSocketDebuggerUrl"] for page in pages if page["type"] == "page")
            except (OSError, StopIteration, ValueError):
                time.sleep(0.1)
        raise TimeoutError("Chromium does not start")

    def wait_until_started(self):
        """Waits until the browser uses hardly any processor time. The browser answers calls some seconds earlier."""
        end = time.time() + 30
        before = -1.0
        while (now := self._processor_time()) > before + 0.02 and time.time() < end:
            before = now
            self.wait(0.5)

    def processes(self):
        names = subprocess.run(["pgrep", "--full", str(self.profile)], capture_output=True, text=True).stdout.split()
        return [pathlib.Path("/proc") / name for name in names]

    def _processor_time(self):
        """The seconds for which the processes of the browser have run, in the user's and in the system's mode."""
        seconds = 0.0
        for process in self.processes():
            try:
                fields = (process / "stat").read_text().rpartition(")")[2].split()
            except OSError:  # the process has just ended
                continue
            seconds += (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")
        return seconds

    def _handle_message(self, message):
        method, params = message.get("method"), message.get("params", {})
        if method == "Runtime.consoleAPICalled":
            self.console.append(" ".join(str(part.get("value", part.get("description", ""))) for part in params["args"]))
        elif method == "Runtime.exceptionThrown":
            details = params["exceptionDetails"]
            self.console.append("error: " + details.get("exception", {}).get("description", details["text"]))
        elif method == "Log.entryAdded" and params["entry"]["level"] == "error":
            self.console.append("error: " + params["entry"]["text"])
        elif method == "Network.requestWillBeSent":
            self.requests.append(params["request"]["url"][:200])
        elif method == "Page.fileChooserOpened":
            self.chooser = params
        elif method == "Tracing.dataCollected":
            self.trace += params["value"]
        elif method == "Tracing.tracingComplete":
            self._find_longest_block()
        elif method == "Page.javascriptDialogOpening":  # "Leave the page?"
            self.last_id += 1
            self.socket.send(json.dumps({"id": self.last_id, "method": "Page.handleJavaScriptDialog", "params": {"accept": True}}))

    def call(self, method, **parameters):
        self.last_id += 1
        number = self.last_id
        self.socket.settimeout(120)
        self.socket.send(json.dumps({"id": number, "method": method, "params": parameters}))
        while True:
            message = json.loads(self.socket.recv())
            if message.get("id") == number:
                if "error" in message:
                    raise RuntimeError(f"{method}: {message['error']}")
                return message["result"]
            self._handle_message(message)

    def wait(self, seconds):
        end = time.time() + seconds
        while (left := end - time.time()) > 0:
            self.socket.settimeout(left)
            try:
                self._handle_message(json.loads(self.socket.recv()))
            except websocket.WebSocketTimeoutException:
                return

    def wait_for(self, what, condition, seconds=30):
        end = time.time() + seconds
        while not condition():
            if time.time() > end:
                raise AssertionError(f"{what}: not within {seconds} s. The page says: {self.console[-5:]}")
            self.wait(0.1)

    def script(self, text):
        result = self.call("Runtime.evaluate", expression=text, awaitPromise=True, returnByValue=True)
        if "exceptionDetails" in result:
            raise RuntimeError(result["exceptionDetails"]["exception"].get("description"))
        return result["result"].get("value")

    def main_thread_time(self):
        """The seconds for which the page's main thread has run."""
        metrics = self.call("Performance.getMetrics")["metrics"]
        return next(metric["value"] for metric in metrics if metric["name"] == "TaskDuration")

    def start_recording(self):
        """Records the tasks of the page until stop_recording() or open()."""
        self.trace = []
        self.call("Tracing.start", traceConfig={"includedCategories": ["disabled-by-default-lighthouse"]})

    def stop_recording(self):
        if self.trace is not None:
            self.call("Tracing.end")
            self.wait_for("the recorded tasks", lambda: self.trace is None, 120)

    def _find_longest_block(self):
        threads = {(event["pid"], event["tid"]): event["args"]["name"] for event in self.trace if event["name"] == "thread_name"}
        for event in self.trace:
            # Other events than RunTask comprise several tasks in a row, between which the browser handles the user's input.
            is_task = event["name"].endswith("RunTask") and "tdur" in event
            if is_task and threads.get((event["pid"], event.get("tid"))) == "CrRendererMain":
                self.longest_block = max(self.longest_block, event["tdur"] / 1e6)
        self.trace = None

    def open(self, address):
        """Opens the page. Returns the seconds until its window has been painted for the first time."""
        self.stop_recording()
        self.requests.clear()
        start = time.time()
        self.script("window.isOld = true")
        self.call("Page.navigate", url=address)
        self.wait(0.3)
        if self.script("window.isOld") and self.script("location.href") == address:
            self.call("Page.reload")  # for a different link (#…), the page reloads itself
        self.wait_for("the window", lambda: not self.script("window.isOld") and self.is_started(), 120)
        painted = self.script("measured.painted")
        self.start_recording()
        return painted - start

    def reload(self):
        self.open(self.script("location.href"))

    def is_started(self):
        return self.script("document.getElementById('start')?.style.display === 'none' && measured.frames > 1")

    def screenshot(self, path):
        path.write_bytes(base64.b64decode(self.call("Page.captureScreenshot", format="png")["data"]))

    def mouse(self, kind, x, y, button="left", buttons=0, clicks=1):
        self.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, button=button, buttons=buttons, clickCount=clicks,
                  pointerType="mouse")

    def click(self, x, y, clicks=1):
        self.mouse("mouseMoved", x, y, "none")
        for i in range(clicks):
            self.mouse("mousePressed", x, y, buttons=1, clicks=i + 1)
            self.mouse("mouseReleased", x, y, clicks=i + 1)
        self.wait(0.3)

    def drag(self, start, end, steps=20):
        self.mouse("mouseMoved", *start, "none")
        self.mouse("mousePressed", *start, buttons=1)
        for x, y in points_between(start, end, steps):
            self.mouse("mouseMoved", x, y, buttons=1)
            self.wait(0.02)
        self.mouse("mouseReleased", *end)
        self.wait(0.3)

    def swipe(self, start, end, steps=20):
        """Drags with one finger on a touch screen."""
        self.call("Input.dispatchTouchEvent", type="touchStart", touchPoints=[{"x": start[0], "y": start[1]}])
        for x, y in points_between(start, end, steps):
            self.call("Input.dispatchTouchEvent", type="touchMove", touchPoints=[{"x": x, "y": y}])
            self.wait(0.02)
        self.call("Input.dispatchTouchEvent", type="touchEnd", touchPoints=[])
        self.wait(0.3)

    def key(self, key, modifiers=0):
        """Presses a key, such as "Enter" or "s". Modifiers: 1 Alt, 2 Ctrl, 8 Shift."""
        codes = {"Enter": 13, "Escape": 27, "Tab": 9, " ": 32, "ArrowDown": 40, "ArrowUp": 38, "ArrowLeft": 37,
                 "ArrowRight": 39, "Home": 36, "End": 35, "F1": 112, "F9": 120, "F11": 122, "Delete": 46, "Backspace": 8}
        code = codes.get(key, ord(key[0].upper()))
        name = "Key" + key.upper() if len(key) == 1 and key.isalpha() else "Digit" + key if key.isdigit() else \
            {" ": "Space"}.get(key, key)
        is_shortcut = modifiers & 3  # Alt or Ctrl
        text = {"text": key} if len(key) == 1 and not is_shortcut else {"text": "\r"} if key == "Enter" else {}
        self.call("Input.dispatchKeyEvent", type="keyDown", key=key, code=name, windowsVirtualKeyCode=code,
                  modifiers=modifiers, **text)
        self.call("Input.dispatchKeyEvent", type="keyUp", key=key, code=name, windowsVirtualKeyCode=code, modifiers=modifiers)
        self.wait(0.15)

    def type(self, text):
        for letter in text:
            self.key(letter)

    def drop(self, x, y, paths):
        data = {"items": [], "files": [str(path) for path in paths], "dragOperationsMask": 1}
        for kind in ("dragEnter", "dragOver", "drop"):
            self.call("Input.dispatchDragEvent", type=kind, x=x, y=y, data=data)
        self.wait(0.5)

    def choose(self, paths):
        """Answers the browser's file chooser, once the page has opened it."""
        self.wait_for("the file chooser", lambda: self.chooser)
        self.call("DOM.setFileInputFiles", files=[str(path) for path in paths], backendNodeId=self.chooser["backendNodeId"])
        self.chooser = None
        self.wait(0.5)

    def downloaded(self, name):
        """Waits for a downloaded file, and returns its path."""
        path = self.downloads / name
        self.wait_for(f"the download of {name}", lambda: path.exists() and path.stat().st_size > 0)
        return path

    def close(self):
        try:
            self.call("Browser.close")
        except (OSError, RuntimeError, websocket.WebSocketException):
            pass
        try:
            self.process.wait(10)
        except subprocess.TimeoutExpired:
            self.process.kill()
        shutil.rmtree(self.profile, ignore_errors=True)


def points_between(start, end, steps):
    for i in range(1, steps + 1):
        yield start[0] + (end[0] - start[0]) * i / steps, start[1] + (end[1] - start[1]) * i / steps
