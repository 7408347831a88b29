# SPDX-License-Identifier: Apache-2.0
"""The designer of interaction models in a real browser.

check_designer.py BUILD_DIR [--picture FILE]
"""
import argparse
import difflib
import json
import math
import pathlib
import shutil
import subprocess
import sys
import tempfile
import urllib.error
import urllib.request

from browser import Browser, chromium

SKIPPED = 77
MODELS = pathlib.Path(__file__).resolve().parents[2] / "scenarios/models/interaction"


class Designer:
    """`skein model edit` of a copy of the models, ended with the test."""

    def __init__(self, build):
        self.build = build
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="skein-designer-"))
        shutil.copytree(MODELS, self.folder / "models")
        self.model = self.folder / "models/monitoring-with-relay.yaml"
        self.process = subprocess.Popen([f"{build}/bin/skein", "model", "edit", str(self.model)], stdout=subprocess.PIPE, text=True)
        self.url = self.process.stdout.readline().split()[-1]

    def check(self):
        """What the command says of the files as they are now."""
        done = subprocess.run([f"{self.build}/bin/skein", "model", "check", "--json", str(self.model)], capture_output=True, text=True)
        return json.loads(done.stdout)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.terminate()
        code = self.process.wait(20)
        shutil.rmtree(self.folder, ignore_errors=True)
        assert code == 0, code


class Sheet:
    """The page, as somebody at it sees and uses it."""

    def __init__(self, browser, designer):
        self.page = browser.page(designer.url)
        self.page.until("document.querySelectorAll('#roles .role').length === 2")

    def settled(self):
        """What was asked for has been answered."""
        self.page.says("(async () => { const s = await import('/designer-state.js'); await s.edit([]); })()")

    def choose(self, key):
        self.page.until(f"document.querySelector('#roles [data-key=\"{key}\"]')")
        self.page.says(f"document.querySelector('#roles [data-key=\"{key}\"]').click()")

    def set(self, find, value):
        """A field or a choice of the inspector."""
        self.page.says(f"(() => {{ const f = {find}; f.value = {json.dumps(value)}; f.dispatchEvent(new Event('change', {{bubbles: true}})); }})()")
        self.settled()

    def press(self, find):
        self.page.says(f"({find}).click()")
        self.settled()

    def check(self):
        self.settled()
        return self.page.says("(async () => (await import('/designer-state.js')).state.check)()")

    def text(self, name):
        self.settled()
        return self.page.says(f"(async () => (await import('/designer-state.js')).state.files.find((f) => f.name.endsWith('/{name}')).text)()")

    def state(self):
        return self.page.says("document.getElementById('state').textContent")

    def save(self):
        self.press("document.getElementById('save')")


def field(label):
    return f"[...document.querySelectorAll('#inspector .field')].find((one) => one.firstChild.textContent === '{label}').querySelector('input, select')"


def changed_lines(before, after):
    return [line for line in difflib.ndiff(before.splitlines(), after.splitlines()) if line[0] in "+-"]


def check_shows_the_model(sheet):
    page = sheet.page
    assert page.says("document.querySelectorAll('#roles .block').length") >= 12
    assert page.says("document.querySelectorAll('#arrows path[data-correspondence]').length") == 2
    assert page.says("document.querySelector('[data-key=\"perceive/b12\"] > .condition.exit').textContent") == "t13 ended"
    assert "mcs2" in page.says("document.querySelector('[data-key=\"perceive/b12\"] > .condition.scm').textContent")
    assert sheet.check()["right"]


def check_edits_by_mouse(sheet, designer):
    """Each change is in the text where it belongs, and the other lines are as they were."""
    role = (designer.folder / "models/roles/perceive.yaml").read_text()
    sheet.choose("perceive/b11")
    sheet.set(field("its end"), "immediate")
    assert changed_lines(role, sheet.text("perceive.yaml")) == ["+           end: immediate"], changed_lines(role, sheet.text("perceive.yaml"))
    assert "not saved" in sheet.state()
    sheet.press("document.getElementById('undo')")
    assert sheet.text("perceive.yaml") == role and sheet.state() == "saved"
    sheet.choose("perceive/t11")
    sheet.set(field("id"), "first")
    text = sheet.text("perceive.yaml")
    assert "t11" not in text and "{componel: first, state: ended}" in text
    assert sheet.check()["right"], sheet.check()
    sheet.choose("perceive/b13")
    sheet.press("document.querySelector('#inspector [data-insert=task]')")
    assert len(sheet.text("perceive.yaml").splitlines()) > len(role.splitlines())
    sheet.choose("relay/b21")
    sheet.press("document.querySelector('#inspector [data-formula=exit] .and')")
    assert "exit: [[{message: interruption}]]" in sheet.text("relay.yaml")
    sheet.choose("relay/ac21")
    sheet.set("document.querySelector('#inspector [aria-label=who]')", "everyone")
    assert "{role: relay, action: ac21, with: perceive, target: ac11, who: everyone}" in sheet.text("monitoring-with-relay.yaml")


def check_moves_by_keys(sheet):
    order = "[...document.querySelectorAll('[data-role=relay] [data-key]')].map((one) => one.dataset.key)"
    before = sheet.page.says(order)
    sheet.page.says("document.querySelector('[data-key=\"relay/b22\"]').focus()")
    sheet.page.call("Input.dispatchKeyEvent", type="keyDown", key="ArrowDown", code="ArrowDown", modifiers=1)
    sheet.page.until(f"JSON.stringify({order}) !== {json.dumps(json.dumps(before, separators=(',', ':')))}")
    after = sheet.page.says(order)
    assert after.index("relay/b23") < after.index("relay/b22"), after
    assert sheet.page.says("document.activeElement.dataset.key") == "relay/b22", "what was moved keeps the focus"


def check_picks_on_the_map(sheet):
    sheet.press("document.querySelector('[data-tab=scms]')")
    sheet.press("document.querySelector('[data-instance=mcs3]')")
    sheet.page.until("document.querySelector('#scms canvas').clientWidth > 100")
    sheet.press("[...document.querySelectorAll('[data-instance=mcs3] .arms')].find((one) => one.title.includes('reach'))")
    place = sheet.page.says("(() => { const b = document.querySelector('#scms canvas').getBoundingClientRect(); return [b.left + b.width / 2 + b.height / 4, b.top + b.height / 2]; })()")
    for kind in ("mousePressed", "mouseReleased"):
        sheet.page.call("Input.dispatchMouseEvent", type=kind, x=place[0], y=place[1], button="left", clickCount=1)
    sheet.page.until("document.querySelector('[data-instance=mcs3] [aria-label=reach]').value !== '100'")
    reach = float(sheet.page.says("document.querySelector('[data-instance=mcs3] [aria-label=reach]').value"))
    # A quarter of 300 m across to the east of the first place, 40 m high.
    assert abs(reach - (75 ** 2 + 40 ** 2) ** 0.5) < 4, reach
    assert f"reach: {reach:g}" in sheet.text("monitoring-with-relay.yaml")


def check_broken_text(sheet):
    sheet.press("document.querySelector('[data-tab=text]')")
    whole = sheet.text("perceive.yaml")
    sheet.page.says("(() => { const f = document.getElementById('file'); f.value = [...f.options].find((o) => o.value.endsWith('perceive.yaml')).value; f.dispatchEvent(new Event('change')); })()")
    sheet.page.says("(() => { const s = document.getElementById('source'); s.focus(); s.value = s.value.replace('content:', 'content: ['); s.dispatchEvent(new Event('input')); })()")
    sheet.page.until("document.querySelector('#check li.wrong')")
    said = sheet.check()
    assert not said["right"] and said["errors"][0]["line"] > 0, said
    assert sheet.page.says("document.querySelector('#lines b') !== null"), "the line is marked"
    assert sheet.page.says("!document.getElementById('source').readOnly"), "and the text can be mended"
    sheet.press("document.getElementById('undo')")
    assert sheet.text("perceive.yaml") == whole and sheet.check() != said


def check_saves(sheet, designer):
    names = ["monitoring-with-relay.yaml", "roles/perceive.yaml", "roles/relay.yaml", "roles/../common.yaml", "scms.yaml"]
    before = {name: (designer.folder / "models" / name).read_text() for name in names}
    live = sheet.check()
    sheet.save()
    sheet.page.until("document.getElementById('state').textContent === 'saved'")
    assert designer.check() == live, (designer.check(), live)
    for name in names:
        after = (designer.folder / "models" / name).read_text()
        comments = [sorted(line for line in text.splitlines() if line.lstrip().startswith("#")) for text in (before[name], after)]
        assert comments[0] == comments[1], name  # in another order where a block was moved
    assert (designer.folder / "models/scms.yaml").read_text() == before["scms.yaml"]


def check_two_browsers(browser, designer, sheet):
    other = Sheet(browser, designer)
    sheet.choose("perceive/b10")
    sheet.set(field("its end"), "wait")
    theirs = other.text("relay.yaml")
    other.choose("perceive/b10")
    other.set(field("type"), "loop")
    other.save()
    other.page.until("document.getElementById('state').textContent === 'saved'")
    on_disk = (designer.folder / "models/roles/perceive.yaml").read_text()
    assert "type: loop" in on_disk
    sheet.save()
    sheet.page.until("!document.getElementById('conflict').hidden")
    assert (designer.folder / "models/roles/perceive.yaml").read_text() == on_disk, "nothing is overwritten unasked"
    sheet.press("document.getElementById('theirs')")
    sheet.page.until("document.getElementById('conflict').hidden && document.getElementById('state').textContent === 'saved'")
    assert sheet.text("perceive.yaml") == on_disk and other.text("relay.yaml") == theirs
    other.page.close()


def check_refuses_others(designer):
    def status(path, headers, data=None):
        request = urllib.request.Request(designer.url.rsplit("/", 1)[0] + path, data=data, headers=headers)
        try:
            return urllib.request.urlopen(request, timeout=10).status
        except urllib.error.HTTPError as error:
            return error.code
        except urllib.error.URLError as error:  # refused and closed before all of it was sent
            if isinstance(error.reason, (BrokenPipeError, ConnectionResetError)):
                return 413
            raise
    asked = json.dumps({"files": []}).encode()
    js = {"Content-Type": "application/json"}
    assert status("/api/designer/save", {**js, "Origin": "http://evil.example"}, asked) == 403
    assert status("/api/designer/save", js, asked) == 403
    assert status("/api/designer/disk", {"Host": "evil.example"}) == 421
    assert status("/api/designer/look", {**js, "Authorization": "Bearer x"}, b"{" + b" " * 2_000_000) == 413
    assert status("/api/designer/nothing", {}) == 404


def check(build, picture):
    browser = Browser()
    try:
        with Designer(build) as designer:
            sheet = Sheet(browser, designer)
            check_shows_the_model(sheet)
            check_draws_what_flight_checks(sheet)
            check_edits_by_mouse(sheet, designer)
            check_moves_by_keys(sheet)
            check_picks_on_the_map(sheet)
            check_broken_text(sheet)
            check_saves(sheet, designer)
            check_two_browsers(browser, designer, sheet)
            check_refuses_others(designer)
        if picture:
            with Designer(build) as designer:
                sheet = Sheet(browser, designer)
                sheet.choose("perceive/ac11")
                sheet.press("document.querySelector('[data-tab=scms]')")
                sheet.press("document.querySelector('[data-instance=mcs3]')")
                sheet.page.until("(async () => 1)()")
                sheet.settled()
                sheet.page.picture(picture)
        assert not browser.errors, browser.errors
    finally:
        browser.close()


# SCM, heights, positions of its places, its numbers, and the same in the words of the map (constraints.js).
SHAPES = [
    ("perception", (10, 25, 40), {"target": [0, 0, 0], "behind": [70, 20, 0]}, {"near": 25, "far": 60, "azimuth": 0, "altitude": 0.5236},
     [("distance", ">", "target", None, 25, 0), ("distance", "<", "target", None, 60, 0),
      ("azimuth", "=", "target", "behind", 0, 0.2), ("altitude", "=", "target", "behind", 0.5236, 0.2)]),
    ("between", (0, 40, 90), {"one": [-30, 10, 20], "other": [40, -20, 0]}, {"reach": 80},
     [("distance", "<", "one", None, 80, 0), ("distance", "<", "other", None, 80, 0)]),
    ("overview", (15, 60), {"place": [10, -15, 5], "aside": [20, 0, 5]}, {"far": 90, "altitude": 0.6},
     [("distance", "<", "place", None, 90, 0), ("altitude", ">", "place", "aside", 0.6, 0)]),
    ("overview", (15, -40), {"place": [10, -15, 5], "aside": [20, 0, 5]}, {"far": 90, "altitude": -0.7},
     [("distance", "<", "place", None, 90, 0), ("altitude", ">", "place", "aside", -0.7, 0)]),
    ("separation", (5, 30), {"from": [0, 0, 0]}, {"least": 40}, [("distance", ">", "from", None, 40, 0)]),
]


def check_draws_what_flight_checks(sheet):
    """The shapes on the operators' map are where the code that watches them in flight finds them satisfied."""
    for scm, heights, places, numbers, figures in SHAPES:
        direction = lambda a, b: math.atan2(places[b][1] - places[a][1], places[b][0] - places[a][0])
        shapes = [{"quantity": q, "relation": r, "origin": places[of], "zero": direction(of, to) if to else 0, "bound": bound, "tolerance": tolerance}
                  for q, r, of, to, bound, tolerance in figures]
        found = 0
        for height in heights:
            asked = {"scm": scm, "west": -150, "south": -150, "step": 5, "columns": 60, "rows": 60, "altitude": height,
                     "places": {name: [at] for name, at in places.items()}, "numbers": numbers}
            same, inside = sheet.page.says(f"""(async () => {{
                const {{post, currentTexts}} = await import('/designer-state.js'), {{isIn, regionOf}} = await import('/constraints.js');
                const rows = (await post('scm', {{...{json.dumps(asked)}, texts: currentTexts()}})).rows;
                const regions = {json.dumps(shapes)}.map((one) => regionOf(one, {height}));
                let same = 0, inside = 0;
                rows.forEach((row, y) => [...row].forEach((cell, x) => {{
                  const here = regions.every((region) => isIn(region, [-150 + 5 * (x + 0.5), -150 + 5 * (y + 0.5)]));
                  same += here === (cell === '1'); inside += cell === '1'; }}));
                return [same, inside]; }})()""")
            assert same == 3600, (scm, height, same)
            found += inside
        assert found > 0, f"{scm} holds nowhere: nothing was compared"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build")
    parser.add_argument("--picture")
    options = parser.parse_args()
    if chromium() is None:
        print("SKIPPED: there is no chromium on this machine")
        return SKIPPED
    check(options.build, options.picture)
    print("the designer does what it should")
    return 0


if __name__ == "__main__":
    sys.exit(main())
