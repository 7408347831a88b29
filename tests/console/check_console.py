# SPDX-License-Identifier: Apache-2.0
"""The operators' page in a real browser, with real daemons: check_console.py BUILD_DIR [--pictures DIR]."""
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import time
import urllib.error
import urllib.request

from browser import Browser, chromium

SKIPPED = 77
SOURCE = pathlib.Path(__file__).resolve().parents[2]


class Mission:
    """A scenario's run with its console, ended with the test."""

    def __init__(self, build, scenario, rate, console="0"):
        self.folder = tempfile.mkdtemp(prefix="skein-console-")
        self.process = subprocess.Popen(
            [f"{build}/bin/skein", "run", str(SOURCE / scenario), "--rate", str(rate), "--console", console, "--quiet",
             "--out", self.folder], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.url = self._wait_for_url()

    def _wait_for_url(self):
        log = pathlib.Path(self.folder) / "logs" / "ground.log"
        for _ in range(600):
            found = re.search(r"console at (http\S+)", log.read_text()) if log.exists() else None
            if found:
                return found.group(1)
            if self.process.poll() is not None:
                break
            time.sleep(0.1)
        raise AssertionError("the ground station serves no console: " + (log.read_text() if log.exists() else "no log"))

    def end(self):
        self.process.terminate()
        self.process.wait(60)


def card(uav):
    return f"document.querySelector('[data-uav=\"{uav}\"]')"


def press(uav, words):
    return f"[...{card(uav)}.querySelectorAll('button')].find((one) => one.textContent === '{words}').click()"


def check_takes_in_hand_late_and_by_several(browser, mission):
    page = browser.page(mission.url)
    page.until("document.querySelectorAll('.card').length === 3")
    page.until("document.getElementById('news').textContent === 'live'")
    page.says("document.getElementById('who').value = 'ada'")
    page.until(f"{card('marvin')}.textContent.includes('take in hand')")
    page.says(press("marvin", "take in hand"))
    page.until(f"{card('marvin')}.textContent.includes('in your hand')")
    page.until("document.getElementById('requests').textContent.includes('marvin: DEGREE 1: acknowledged')")
    late = browser.page(mission.url)
    late.until(f"{card('marvin')}?.textContent.includes('in hand of ada')")
    late.says("document.getElementById('who').value = 'bo'")
    late.until(f"{card('marvin')}.textContent.includes('ask for it')")
    late.says(press("marvin", "ask for it"))
    page.until(f"{card('marvin')}.textContent.includes('keep it: bo asks')")
    page.says(press("marvin", "keep it: bo asks"))
    late.until(f"{card('marvin')}.textContent.includes('ask for it')")
    page.close()  # a lost page changes nothing
    late.open(mission.url)
    late.until(f"{card('marvin')}?.textContent.includes('in hand of ada')")
    late.says("document.getElementById('who').value = 'ada'")
    late.until(f"{card('marvin')}.textContent.includes('give back')")
    late.says(press("marvin", "give back"))
    late.until(f"!{card('marvin')}.textContent.includes('in your hand') && {card('marvin')}.querySelector('.degree').textContent === '3'")
    late.close()


def check_shows_the_mission(browser, mission):
    page = browser.page(mission.url)
    page.until("document.getElementById('clock').textContent > '00:05'")
    drawn = page.until("""(() => { const c = document.getElementById('map'); if (!c.width) return 0;
        const d = c.getContext('2d').getImageData(0, 0, c.width, c.height).data; const seen = new Set();
        for (let i = 0; i < d.length; i += 4 * 97) seen.add((d[i] << 16) | (d[i + 1] << 8) | d[i + 2]); return seen.size > 200 && seen.size; })()""")
    page.until("document.getElementById('phase').textContent.length > 3")
    assert not browser.errors, browser.errors
    page.close()
    return drawn


def check_refuses_others(mission):
    def status(path, headers, data=None):
        request = urllib.request.Request(mission.url + path, data=data, headers=headers)
        try:
            return urllib.request.urlopen(request, timeout=10).status
        except urllib.error.HTTPError as error:
            return error.code
    asked = json.dumps({"who": "eve", "number": 1, "actions": [{"finish": True}]}).encode()
    assert status("api/request", {"Content-Type": "application/json", "Origin": "http://evil.example"}, asked) == 403
    assert status("api/request", {"Content-Type": "application/json"}, asked) == 403
    assert status("api/request", {"Content-Type": "text/plain", "Authorization": "Bearer x"}, asked) == 415
    assert status("", {"Host": "evil.example"}) == 421


def main():
    build = sys.argv[1]
    if chromium() is None:
        print("SKIPPED: there is no chromium on this machine")
        return SKIPPED
    mission = Mission(build, "scenarios/comets/confirmed.yaml", 3)
    browser = Browser()
    try:
        check_shows_the_mission(browser, mission)
        check_refuses_others(mission)
        check_takes_in_hand_late_and_by_several(browser, mission)
        print("the console does what it should")
        return 0
    finally:
        browser.close()
        mission.end()


if __name__ == "__main__":
    sys.exit(main())
