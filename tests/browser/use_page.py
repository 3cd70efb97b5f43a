# SPDX-License-Identifier: GPL-3.0-or-later
"""use_page.py FOLDER: uses the page as a person would, as a folder from a server and as a single file, and checks the results.
The browser sees the window as one picture, so positions are in pixels of a window of 1400 × 900."""

import csv
import gzip
import json
import math
import pathlib
import re
import subprocess
import sys
import time

from chromium import Chromium, serve

ROOT = pathlib.Path(__file__).parent.parent.parent
SAMPLE = ROOT / "data/inventor_sample.csv"
PROGRAM = ROOT / "build/release/app/slidercrank"
LINK = "#a=40&b=120&c=20&omega2=60rpm"

CTRL = 2

measured = {}
failures = []


def check(what, is_true, detail=""):
    print(("ok      " if is_true else "FAILED  ") + what + (f": {detail}" if detail != "" else ""), flush=True)
    if not is_true:
        failures.append(what)


def note_time(what, value, limit):
    """Notes a measured time (s). No test fails by the limit, which holds for a machine without other load."""
    print(("ok      " if value <= limit else "SLOW    ") + f"{what}: {value:.3f} s, limit {limit} s", flush=True)
    measured[what] = round(value, 4)


def native(*arguments):
    return subprocess.run([PROGRAM, *arguments], check=True, capture_output=True, text=True).stdout


def table(text):
    """Returns the columns of a CSV text by their names, with the values as texts."""
    rows = list(csv.reader(text.splitlines()))
    return {name: [row[i] for row in rows[1:]] for i, name in enumerate(rows[0])}


def check_table(what, page, scene):
    """Compares an exported table with that of the native program for the same scene."""
    program = table(native("solve", "--scene", scene, "--channels", "all"))
    shared = [name for name in program if name in page]
    check(f"{what}: 36 channels at 201 times", len(shared) >= 36 and all(len(page[name]) == 201 for name in shared),
          f"{len(shared)} columns")
    differing = {}
    for name in shared:
        for here, there in zip(page[name], program[name]):
            if here != there:
                count, largest = differing.get(name, (0, 0.0))
                differing[name] = count + 1, max(largest, abs(float(here) - float(there)) / max(abs(float(there)), 1e-300))
    measured[f"{what}: values that are written differently, by channel (number, largest relative difference)"] = differing
    check(f"{what}: equal to the native program's, but for the rounding of sine and cosine",
          all(largest < 1e-13 or float(count) <= 2 for count, largest in differing.values()), differing or "every digit")


class Window:
    """The program's window in a page."""

    FILE, VIEW = (20, 10), (97, 10)
    SLIDER_OF_B = (206, 750)  # the handle of the slider of b, at 65 mm
    BACKGROUND = (200, 300)  # of the mechanism's drawing
    PIN, PIN_TURNED = (231, 339), (213, 292)  # A at two crank angles, θ₂ = 0 and about 30° later
    COUPLER_LINK = (280, 319)  # between A and G₃
    STUDY_TAB, RUN_STUDY = (1180, 599), (1366, 672)

    def __init__(self, browser, shots, name):
        self.browser, self.shots, self.name = browser, shots, name

    def shot(self, what):
        self.browser.screenshot(self.shots / f"{self.name}-{what}.png")

    def menu(self, place, *letters):
        """Opens a menu, and presses the underlined letters of its entries."""
        self.browser.click(*place)
        for letter in letters:
            self.browser.key(letter)
        self.browser.wait(0.5)

    def save(self, format_number=0):
        """Accepts the proposed name in the form that saves a file. `format_number`: position in its list of formats."""
        self.browser.key("Tab")
        for _ in range(format_number):
            self.browser.key("ArrowDown")
        self.browser.key("Enter")

    def export(self, letter, name, format_number=0):
        path = self.browser.downloads / name
        path.unlink(missing_ok=True)
        self.menu(self.FILE, "x", letter)
        self.save(format_number)
        return self.browser.downloaded(name)

    def link(self):
        """Copies the link of the mechanism, and returns it."""
        self.menu(self.FILE, "k")
        return self.browser.script("navigator.clipboard.readText()")

    def value(self, name):
        """Returns the value of a parameter in the link of the mechanism, or NaN."""
        found = re.search(rf"[#&]{name}=([-0-9.e]+)", self.link())
        return float(found[1]) if found else math.nan


def check_frames(window):
    browser = window.browser
    browser.click(*Window.PIN)
    browser.key(" ")
    browser.wait(1.0)
    before, time_before, start = browser.script("measured.frames"), browser.main_thread_time(), time.time()
    browser.wait(4.0)
    frames = browser.script("measured.frames") - before
    measured[f"{window.name}: frames a second while playing"] = round(frames / (time.time() - start), 1)
    note_time(f"{window.name}: processor time of a frame", (browser.main_thread_time() - time_before) / frames, 0.022)  # 45 frames a second
    browser.key(" ")
    browser.wait(1.0)
    before = browser.script("measured.frames")
    browser.wait(2.0)
    check("nothing is painted while nothing moves", browser.script("measured.frames") - before <= 4)


def check_exports(window):
    for method in ("closed-form", "newton"):
        window.browser.open(window.address + LINK + "&method=" + method)
        window.browser.wait(1.0)
        page = table(window.export("d", "motion.csv", 1).read_text())
        check_table(f"{window.name}, {method}", page, "slidercrank.html" + LINK + "&method=" + method)
    report = window.export("r", "report.pdf")
    text = subprocess.run(["pdftotext", "-layout", report, "-"], check=True, capture_output=True, text=True).stdout
    check("the report names the mechanism", "120" in text and "40" in text)
    window.browser.key("e", CTRL)
    window.browser.wait(1.0)
    window.shot("figure")
    window.browser.key("Enter")
    window.browser.wait(0.5)
    window.save()
    picture = window.browser.downloaded("figure.png").read_bytes()
    check("the figure is a picture of the stated size", picture[:8] == b"\x89PNG\r\n\x1a\n" and len(picture) > 20_000, len(picture))


def check_reference(window):
    browser = window.browser
    browser.open(window.address)
    browser.drop(700, 300, [SAMPLE])
    browser.wait(3.0)
    window.shot("dropped")
    report = window.export("r", "report.pdf")
    text = subprocess.run(["pdftotext", "-layout", report, "-"], check=True, capture_output=True, text=True).stdout
    check("the dropped file is compared, and its mechanism found", re.search(r"b\s*=?\s*60(\.0+)?\b", text) is not None)
    browser.open(window.address)
    window.menu(Window.FILE, "o")
    browser.choose([SAMPLE])
    browser.wait(3.0)
    window.shot("chosen")
    browser.drop(700, 300, [ROOT / "LICENSE"])
    browser.wait(1.0)
    window.shot("refused")


def check_context_menus(window):
    """Checks that no context menu blocks the page, as a menu with an event loop of its own would."""
    browser = window.browser
    browser.open(window.address)
    for what, place in (("mechanism", Window.BACKGROUND), ("plot", (800, 200)), ("number box", (450, 720)),
                        ("slider", Window.SLIDER_OF_B), ("table", (900, 800)), ("tab bar", (700, 600))):
        for kind in ("mousePressed", "mouseReleased"):
            browser.mouse(kind, *place, "right")
        browser.wait(0.5)
        window.shot("menu-" + what.replace(" ", "-"))
        browser.key("Escape")
        before = browser.script("measured.frames")
        window.menu(Window.FILE)
        check(f"a right click on the {what} does not stop the page", browser.script("measured.frames") > before)
        browser.key("Escape")


def check_editing(window):
    browser = window.browser
    browser.open(window.address)
    b = window.value("b")
    browser.swipe(Window.COUPLER_LINK, (Window.COUPLER_LINK[0] + 48, Window.COUPLER_LINK[1] - 20))
    check("a length is dragged with a finger", window.value("b") > b + 5, window.link())
    browser.open(window.address)
    browser.swipe(Window.PIN, Window.PIN_TURNED)
    check("the crank is turned with a finger", window.value("time") > 0.05, window.link())
    browser.drag(Window.SLIDER_OF_B, (Window.SLIDER_OF_B[0] + 40, Window.SLIDER_OF_B[1]))
    b = window.value("b")
    check("a slider is dragged", b > 66, b)
    browser.swipe((Window.SLIDER_OF_B[0] + 40, Window.SLIDER_OF_B[1]), (Window.SLIDER_OF_B[0] + 80, Window.SLIDER_OF_B[1]))
    check("a slider is dragged with a finger", window.value("b") > b + 1)
    window.shot("edited")
    browser.wait(4.0)  # until the unsaved changes are kept
    link = window.link()
    browser.reload()
    browser.wait(3.0)
    window.shot("reloaded")
    kept = browser.script("Object.keys(localStorage).filter(name => name.startsWith('slidercrank/recovery/')).length")
    check("unsaved changes are kept in the browser's storage", kept == 1, kept)
    name, _, mechanism = link.partition("#")  # the link of a page from disk begins with the name of its file
    check("the page opens a link that it has copied",
          name.endswith("slidercrank.html") and browser.open(window.address + "#" + mechanism) < 60)


def check_language(window):
    browser = window.browser
    window.menu(Window.VIEW, "g", "p")
    browser.reload()
    browser.wait(1.0)
    window.shot("spanish")
    name = window.browser.downloads / "movimiento.csv"
    window.menu(Window.FILE, "x", "d")
    window.save()
    check("speaks Spanish after it is loaded again", browser.downloaded(name.name).exists())
    window.menu(Window.VIEW, "m", "e")


def check_study(window):
    browser = window.browser
    browser.open(window.address)
    browser.click(*Window.STUDY_TAB)
    browser.click(*Window.RUN_STUDY)
    measured[f"{window.name}: seconds of the study"] = round(wait_until_idle(browser), 1)
    window.shot("study")


def wait_until_idle(browser):
    """Waits until the page's main thread hardly runs for a second. Returns the seconds that this took."""
    start = time.time()
    before = -1.0
    while (now := browser.main_thread_time()) > before + 0.1 and time.time() < start + 120:
        before = now
        browser.wait(1.0)
    return time.time() - start


def use_page(name, address, shots):
    browser = Chromium(1400, 900)
    try:
        window = Window(browser, shots, name)
        window.address = address
        browser.call("Browser.grantPermissions", permissions=["clipboardReadWrite", "clipboardSanitizedWrite"])
        browser.wait_until_started()
        seconds = browser.open(address)
        note_time(f"{name}: the window is painted", seconds, 2.5)
        measured[f"{name}: of them, processor time of the page, s"] = round(browser.main_thread_time(), 2)
        browser.wait(1.0)
        window.shot("start")
        browser.requests.clear()
        check_frames(window)
        requests = [request for request in browser.requests if not request.startswith(("data:", "blob:"))]
        check("makes no request after it has loaded", not requests, requests)
        for check_part in (check_context_menus, check_exports, check_editing, check_reference, check_study, check_language):
            try:
                check_part(window)
            except (AssertionError, RuntimeError, OSError) as error:
                window.shot("failed-" + check_part.__name__)
                check(check_part.__name__, False, error)
        browser.stop_recording()
        note_time(f"{name}: longest block, processor time", browser.longest_block, 0.3)
        measured[f"{name}: memory of the program, MB"] = memory_of(browser)
        # Chromium reports as an error that it does not ask "Leave the page?" before the user has done something in it.
        errors = [line for line in browser.console
                  if ("error" in line.lower() or "exec()" in line) and "beforeunload" not in line]
        check("no error is reported", not errors, errors[:5])
    finally:
        browser.close()


def memory_of(browser):
    """Returns the MB of all processes of the browser. Memory that processes share counts once."""
    maps = [process / "smaps_rollup" for process in browser.processes()]
    return round(sum(int(re.search(r"^Pss: +(\d+)", each.read_text(), re.M)[1]) for each in maps if each.exists()) / 1000)


def check_window_sizes(address, shots):
    for width, height, is_phone in ((1400, 900, False), (1024, 700, False), (390, 844, True), (844, 390, True)):
        for is_dark in (False, True):
            browser = Chromium(width, height, is_dark, is_phone)
            try:
                browser.open(address + LINK)
                browser.wait(1.0)
                browser.screenshot(shots / f"{width}x{height}-{'dark' if is_dark else 'light'}.png")
                view = "document.getElementById('view')"
                check(f"the window fits into {width} × {height}", browser.script(
                    f"{view}.clientWidth === {view}.scrollWidth && {view}.clientHeight === {view}.scrollHeight"))
                scale = browser.script("visualViewport.scale")
                browser.swipe((470, 440), (470, 440))  # into a number box, which opens the screen keyboard of a phone
                check("the page keeps its size while one types", browser.script("visualViewport.scale") == scale, scale)
            finally:
                browser.close()


def check_old_browser(address, lack):
    """`lack`: a script that removes what an old browser does not have."""
    browser = Chromium(800, 500)
    try:
        browser.call("Page.addScriptToEvaluateOnNewDocument", source=lack)
        browser.call("Page.navigate", url=address)
        state_text = lambda: browser.script("document.getElementById('state')?.textContent") or ""
        browser.wait_for("the sentence for an old browser", lambda: "lacks WebAssembly" in state_text())
        check("says what an old browser lacks", True, state_text())
    except AssertionError as error:
        check("says what an old browser lacks", False, error)
    finally:
        browser.close()


def check_file_sizes(folder):
    files = ("slidercrank.html", "slidercrank.js", "slidercrank.wasm", "qtloader.js")
    packed = sum(len(gzip.compress((folder / "page" / file).read_bytes(), 9, mtime=0)) for file in files) / 1e6
    single = len(gzip.compress((folder / "slidercrank.html").read_bytes(), 9, mtime=0)) / 1e6
    measured["folder with gzip, MB"] = round(packed, 2)
    measured["file with gzip, MB"] = round(single, 2)
    measured["file, MB"] = round((folder / "slidercrank.html").stat().st_size / 1e6, 2)
    check("the folder takes at most 6 MB with gzip", packed <= 6, f"{packed:.2f}")
    check("the file takes at most 8 MB with gzip", single <= 8, f"{single:.2f}")


def main():
    folder = pathlib.Path(sys.argv[1])
    shots = folder / "test"
    shots.mkdir(exist_ok=True)
    check_file_sizes(folder)
    address = serve(folder / "page")
    use_page("folder", address + "slidercrank.html", shots)
    use_page("file", (folder / "slidercrank.html").as_uri(), shots)
    check_old_browser(address + "slidercrank.html", "delete window.WebAssembly")
    check_old_browser(address + "slidercrank.html",
                      "WebAssembly.compileStreaming = () => Promise.reject(new WebAssembly.CompileError('unknown opcode'))")
    check_window_sizes(address + "slidercrank.html", shots)
    (shots / "measured.json").write_text(json.dumps(measured, indent=2, ensure_ascii=False))
    print(json.dumps(measured, indent=2, ensure_ascii=False))
    print(f"{len(failures)} failed" if failures else "All passed")
    sys.exit(1 if failures else 0)


if __name__ == "__main__":
    main()
