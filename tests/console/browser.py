# SPDX-License-Identifier: Apache-2.0
"""A headless Chromium by its debugging pipe: no packages but Python's own."""
import base64
import json
import os
import select
import shutil
import subprocess
import tempfile
import time


def chromium():
    """The program, or None."""
    return shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")


class Browser:
    def __init__(self, width=1440, height=900):
        to_read, self._to = os.pipe()
        self._from, from_write = os.pipe()
        self._folder = tempfile.mkdtemp(prefix="skein-browser-")

        def give_pipe():  # as descriptors 3 and 4
            os.dup2(to_read, 10), os.dup2(from_write, 11)
            os.dup2(10, 3), os.dup2(11, 4)

        self._process = subprocess.Popen(
            [chromium(), "--headless=new", "--no-sandbox", "--remote-debugging-pipe", "--no-first-run",
             "--disable-background-networking", f"--window-size={width},{height}", f"--user-data-dir={self._folder}",
             "about:blank"],
            preexec_fn=give_pipe, pass_fds=(3, 4, to_read, from_write), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(to_read), os.close(from_write)
        self._number, self._buffer, self.errors = 0, b"", []

    def call(self, method, session=None, seconds=60, **parameters):
        self._number += 1
        seconds += 30  # beyond what the page itself waits
        message = {"id": self._number, "method": method, "params": parameters}
        if session:
            message["sessionId"] = session
        os.write(self._to, json.dumps(message).encode() + b"\0")
        until = time.monotonic() + seconds
        while True:
            answer = self._next(until)
            if answer.get("id") == message["id"]:
                if "error" in answer:
                    raise RuntimeError(f"{method}: {answer['error']}")
                return answer["result"]
            if answer.get("method") == "Runtime.exceptionThrown":
                self.errors.append(answer["params"]["exceptionDetails"].get("exception", {}).get("description", "?"))

    def _next(self, until):
        while b"\0" not in self._buffer:
            if not select.select([self._from], [], [], max(0, until - time.monotonic()))[0]:
                raise TimeoutError("the browser does not answer")
            piece = os.read(self._from, 1 << 16)
            if not piece:
                raise RuntimeError("the browser is gone")
            self._buffer += piece
        one, self._buffer = self._buffer.split(b"\0", 1)
        return json.loads(one)

    def page(self, url, width=1440, height=900):
        return Page(self, url, width, height)

    def close(self):
        self._process.terminate()
        self._process.wait(20)
        shutil.rmtree(self._folder, ignore_errors=True)


class Page:
    def __init__(self, browser, url, width, height):
        self._browser = browser
        self._target = browser.call("Target.createTarget", url="about:blank", newWindow=True)["targetId"]
        self._session = browser.call("Target.attachToTarget", targetId=self._target, flatten=True)["sessionId"]
        for domain in ("Page", "Runtime"):
            self.call(domain + ".enable")
        self.call("Emulation.setFocusEmulationEnabled", enabled=True)  # a page behind others is seen too
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=False)
        self.open(url)

    def call(self, method, **parameters):
        return self._browser.call(method, self._session, **parameters)

    def open(self, url):
        self.call("Page.navigate", url=url)

    def says(self, script):
        """The value of an expression; a promise is waited for."""
        result = self.call("Runtime.evaluate", expression=script, returnByValue=True, awaitPromise=True)
        if "exceptionDetails" in result:
            raise RuntimeError(result["exceptionDetails"].get("exception", {}).get("description", script))
        return result["result"].get("value")

    def until(self, script, seconds=60):
        """Waits in the page until the expression is true, over loads of it too; its value, or an error with what it was last."""
        end = time.monotonic() + seconds
        while True:
            left = max(0.0, end - time.monotonic())
            try:
                value = self.says(_WAITING % {"script": script, "ms": int(1000 * left)})
            except RuntimeError as error:
                if left > 0 and "navigat" in str(error) or "context" in str(error):
                    continue  # the page was loaded anew
                raise
            if isinstance(value, dict) and "never" in value:
                raise AssertionError(f"never came: {script}; last: {value['never']}; log: {self._browser.errors}")
            return value

    def press(self, key, times=1):
        """Keys as a user has them: what has the focus gets them, and does what the browser itself does with them."""
        code, number, text = _KEYS.get(key, (key, ord(key[0].upper()), key if len(key) == 1 else ""))
        event = {"key": key, "code": code, "windowsVirtualKeyCode": number}
        for _ in range(times):
            self.call("Input.dispatchKeyEvent", type="keyDown" if text else "rawKeyDown", text=text, **event)
            self.call("Input.dispatchKeyEvent", type="keyUp", **event)

    def picture(self, path):
        data = self.call("Page.captureScreenshot", format="png")["data"]
        with open(path, "wb") as file:
            file.write(base64.b64decode(data))

    def close(self):
        self._browser.call("Target.closeTarget", targetId=self._target)


# Code of the key, its number on a keyboard of Windows (by which Chromium knows what to do itself: Escape closes a dialog), what it writes.
_KEYS = {"Enter": ("Enter", 13, "\r"), "Escape": ("Escape", 27, ""), "Tab": ("Tab", 9, ""), " ": ("Space", 32, " "),
         "ArrowLeft": ("ArrowLeft", 37, ""), "ArrowUp": ("ArrowUp", 38, ""), "ArrowRight": ("ArrowRight", 39, ""), "ArrowDown": ("ArrowDown", 40, ""),
         "0": ("Digit0", 48, "0"), "+": ("NumpadAdd", 107, "+"), "-": ("Minus", 189, "-")}

# A promise of the expression's value, looked at ten times a second in the page itself.
_WAITING = """new Promise((resolve) => {
  const end = performance.now() + %(ms)d;
  const look = () => {
    let value = null, why = "";
    try { value = (%(script)s); } catch (error) { why = String(error); }
    if (value) resolve(value);
    else if (performance.now() > end) resolve({never: why || String(value)});
    else setTimeout(look, 100);
  };
  look();
})"""
