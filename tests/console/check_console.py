# SPDX-License-Identifier: Apache-2.0
"""The operators' page in a real browser, with real daemons.

check_console.py BUILD_DIR               what the page does
check_console.py BUILD_DIR --figures     what it costs and how fast it draws (docs/performance.md)
check_console.py BUILD_DIR --pictures D  what it looks like
"""
import argparse
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import urllib.error
import urllib.request

from browser import Browser, chromium
from fleet import fleet

SKIPPED = 77
SOURCE = pathlib.Path(__file__).resolve().parents[2]
MARKUP = '<img src=x onerror="window.hurt = 1">'


class Mission:
    """A run with its console, ended with the test."""

    def __init__(self, build, scenario, rate, changes=()):
        self.folder = tempfile.mkdtemp(prefix="skein-console-")
        if isinstance(scenario, str):
            file = pathlib.Path(self.folder) / "scenario.yaml"
            file.write_text(scenario)
        else:
            file = scenario
        self.process = subprocess.Popen(
            [f"{build}/bin/skein", "run", str(file), "--rate", str(rate), "--console", "0", "--out", self.folder + "/out", *changes],
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        self.said = []
        self.url = self._url()

    def _url(self):
        for line in self.process.stdout:
            self.said.append(line)
            found = re.search(r"console at (http\S+)", line)
            if found:
                return found.group(1)
        raise AssertionError("the run tells no console: " + "".join(self.said))

    def pid_of(self, program):
        for entry in pathlib.Path("/proc").iterdir():
            try:
                words = (entry / "cmdline").read_bytes().split(b"\0")
            except OSError:
                continue
            if words and words[0].endswith(program.encode()) and any(self.folder.encode() in word for word in words):
                return int(entry.name)
        raise AssertionError(program + " does not run")

    def end(self):
        self.process.terminate()
        self.process.communicate(timeout=60)
        shutil.rmtree(self.folder, ignore_errors=True)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.end()


class Replay:
    """A run in virtual time, then its replay."""

    def __init__(self, build, scenario, speed):
        self.folder = tempfile.mkdtemp(prefix="skein-replay-")
        file = scenario
        if isinstance(scenario, str):
            file = pathlib.Path(self.folder) / "scenario.yaml"
            file.write_text(scenario)
        subprocess.run([f"{build}/bin/skein", "run", str(file), "--virtual", "--quiet", "--out", self.folder + "/out"],
                       stdout=subprocess.DEVNULL)
        self.process = subprocess.Popen([f"{build}/bin/skein", "replay", self.folder + "/out", "--speed", str(speed)],
                                        stdout=subprocess.PIPE, text=True)
        self.url = self.process.stdout.readline().split()[-1]

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.terminate()
        code = self.process.wait(20)
        shutil.rmtree(self.folder, ignore_errors=True)
        assert code == 0, code


MARKS = "(async () => (await import('/feed.js')).model.uavs.get('marvin').marks.size)()"


def card(uav):
    return f"document.querySelector('[data-uav=\"{uav}\"]')"


def press(uav, words):
    return f"[...{card(uav)}.querySelectorAll('button')].find((one) => one.textContent === '{words}').click()"


def requests_tell(words):
    return f"document.getElementById('requests').textContent.includes({json.dumps(words)})"


def opened(browser, mission):
    page = browser.page(mission.url)
    page.until("document.getElementById('news').textContent === 'live'")
    page.until("document.querySelectorAll('.card button').length > 0")
    return page


def check_shows_the_mission(browser, mission):
    page = opened(browser, mission)
    page.until("document.getElementById('clock').textContent > '00:05'")
    page.until("""(() => { const c = document.getElementById('map'); if (!c.width) return 0;
        const d = c.getContext('2d').getImageData(0, 0, c.width, c.height).data; const seen = new Set();
        for (let i = 0; i < d.length; i += 4 * 97) seen.add((d[i] << 16) | (d[i + 1] << 8) | d[i + 2]); return seen.size > 200; })()""")
    page.until("document.getElementById('phase').textContent.length > 3")
    page.close()


def check_takes_in_hand_late_and_by_several(browser, mission):
    page = opened(browser, mission)
    page.says("document.getElementById('who').value = 'ada'")
    page.until(f"{card('marvin')}.textContent.includes('take in hand')")
    page.says(press("marvin", "take in hand"))
    page.until(f"{card('marvin')}.textContent.includes('in your hand')")
    page.until(requests_tell("marvin: DEGREE 1: acknowledged"))
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


def check_names_are_text(browser, mission):
    """What an operator calls himself is shown to all, and is no markup to any of them."""
    page = opened(browser, mission)
    page.says(f"document.getElementById('who').value = {json.dumps(MARKUP)}")
    page.until(f"{card('karma')}.textContent.includes('take in hand')")
    page.says(press("karma", "take in hand"))
    page.until(requests_tell("karma: DEGREE 1: acknowledged"))
    other = opened(browser, mission)
    other.until(f"{card('karma')}.textContent.includes({json.dumps('in hand of ' + MARKUP)})")
    for one in (page, other):
        assert one.says("window.hurt === undefined && document.querySelectorAll('img').length === 0")
    page.until(f"{card('karma')}.textContent.includes('give back')")
    page.says(press("karma", "give back"))
    other.until(f"!{card('karma')}.textContent.includes('in hand of')")
    page.close()
    other.close()


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


def check_is_used_by_keys(browser, mission):
    """A UAV is chosen, the chronology moved, air closed by its corners and opened again without a mouse."""
    page = opened(browser, mission)
    page.until("document.getElementById('map').clientWidth > 0 && document.querySelector('[data-uav=heliv] header')")
    page.says("document.querySelector('[data-uav=heliv] header').focus()")
    page.press("Enter")
    page.until(f"{card('heliv')}.classList.contains('chosen')")
    page.says("document.getElementById('mission-button').focus()")
    page.press("Enter")
    page.until("document.getElementById('mission').open")
    page.press("Escape")
    page.until("!document.getElementById('mission').open")
    check_closes_air_by_keys(page)
    page.says("document.getElementById('chronology').focus()")
    page.press("ArrowLeft", 3)
    end = "(async () => (await import('/timeline.js')).window_.end)()"
    assert page.says(end) is not None
    page.press("0")
    assert page.says(end) is None
    page.close()


def check_closes_air_by_keys(page):
    corners = (("ArrowLeft", 2), (" ", 1), ("ArrowUp", 3), (" ", 1), ("ArrowRight", 3), (" ", 1))
    for leave in (True, False):
        page.says("document.querySelector('#tools .acts').focus()")
        page.press("Enter")
        page.until("document.activeElement === document.getElementById('map')")
        for keys in (*corners, ("Enter", 1)):
            page.press(*keys)
        page.until("document.getElementById('air').open")
        if leave:
            page.press("Escape")
            page.until("!document.getElementById('air').open")
    page.until("document.activeElement?.closest('#air') !== null")
    page.press("Tab")
    page.press("ArrowRight", 9)
    page.until("!document.getElementById('air').open")
    opener = "[...document.querySelectorAll('#answers button')].find((one) => one.textContent === 'open closed-1')"
    page.until(opener)
    page.says(opener + ".focus()")
    page.press("Enter")
    page.until("!" + opener)


def check_ends_the_mission_by_keys(browser, mission):
    page = opened(browser, mission)
    page.says("document.querySelector('#finish input').focus()")
    page.press("ArrowRight", 7)
    assert page.says("Number(document.querySelector('#finish input').value) < 97"), "seven steps are not enough"
    page.press("ArrowRight", 2)
    page.until("document.getElementById('news').textContent === 'mission over'")
    page.close()


def check_gives_a_mission_from_the_form(browser, mission):
    page = opened(browser, mission)
    page.says("document.getElementById('mission-button').click()")
    page.until("document.getElementById('mission').open")
    page.says("""(() => {
        const kind = document.querySelector('#mission fieldset select');
        kind.value = 'general-takeoff'; kind.dispatchEvent(new Event('change'));
        document.querySelector('#mission-send').click(); })()""")
    page.until("!document.getElementById('mission').open")
    page.until(requests_tell("acknowledged"))
    page.until(f"{card('marvin')}.textContent.includes('general-takeoff')")
    page.until(f"{card('marvin')}.querySelector('.goals')?.textContent.includes('achieved')")
    check_picks_zones_and_places_on_the_map(page)
    page.close()


def check_picks_zones_and_places_on_the_map(page):
    """The form steps aside, a point is picked, and it comes back with what is there; also when nothing is picked."""
    page.says("document.getElementById('mission-button').click()")
    page.says("""(() => { const kind = document.querySelector('#mission fieldset select');
        kind.value = 'perform-detection'; kind.dispatchEvent(new Event('change')); })()""")
    given = "[...document.querySelectorAll('#mission fieldset label select')].map((one) => one.value === 'point' ? one.selectedOptions[0].textContent : one.value).join()"
    before = page.says(given)
    assert before.startswith("A,"), before
    for what, keys, after in (("zone", "Escape", before), ("zone", " ", "Z," + before.split(",")[1]), ("place", " ", "Z,360, 130")):
        page.says("(async () => Object.assign((await import('/map.js')).view, {x: 360, y: 130}))()")
        page.says(f"document.querySelector('#mission button[title=\"a {what} on the map\"]').click()")
        page.until("document.activeElement === document.getElementById('map') && !document.getElementById('mission').open")
        page.press(keys)
        page.until("document.getElementById('mission').open")
        assert page.says(given) == after, (what, page.says(given), after)
    page.says("document.getElementById('mission').close()")


def check_replays_what_was_recorded(browser, build):
    """A mission in virtual time, then seen on the page: at an instant, and at an earlier one."""
    with Replay(build, SOURCE / "scenarios/comets/confirmed.yaml", 60) as replay:
        page = browser.page(replay.url)
        page.until("document.getElementById('news').textContent === 'replay'")
        page.until("document.getElementById('clock').textContent > '00:20'")
        assert page.says("getComputedStyle(document.getElementById('mission-button')).display === 'none'")
        page.says("(() => { const at = document.getElementById('at'); at.value = at.max; at.dispatchEvent(new Event('change')); })()")
        page.until("document.getElementById('play').textContent === 'play'")
        page.until("document.getElementById('phase').textContent.length > 3")
        done = page.says(MARKS)
        assert done > 3, done
        page.says("(() => { const at = document.getElementById('at'); at.value = 10; at.dispatchEvent(new Event('change')); })()")
        page.until("document.getElementById('clock').textContent === '00:10'")
        fewer = page.says(MARKS)
        assert fewer < done, (fewer, done)
        page.close()


def check_shows_joint_tasks(browser, build):
    """Roles, whom with and where they are, of a joint task; what it costs to fly home."""
    with Replay(build, SOURCE / "scenarios/mref/nominal.yaml", 60) as replay:
        page = browser.page(replay.url)
        page.until("document.querySelectorAll('.joint li').length >= 2")
        page.until("document.getElementById('play')")
        page.says("document.getElementById('play').click()")
        page.until("document.getElementById('play').textContent === 'play'")
        told = page.says("[...document.querySelectorAll('.joint li')].map((one) => one.textContent)")
        assert any(re.search(r"^[\w-]+: \S+ (loaded|running).* with \w+ \(", one) for one in told), told
        assert page.says("[...document.querySelectorAll('.card dd')].some((one) => /% to home/.test(one.textContent))")
        page.close()


def check_draws_spatial_constraints(browser, build):
    """What a role must hold is drawn where it holds: while no constraint is told to be violated, each UAV is where its constraints let it be."""
    with Replay(build, SOURCE / "scenarios/mref/nominal.yaml", 60) as replay:
        page = browser.page(replay.url)
        page.until("document.querySelectorAll('.joint li').length >= 2")
        page.until("document.getElementById('play')")
        page.says("document.getElementById('play').textContent === 'halt' && document.getElementById('play').click()")
        page.until("document.getElementById('play').textContent === 'play'")
        seen = {}
        for at in range(200, 900, 50):
            page.says(f"(() => {{ const at = document.getElementById('at'); at.value = {at}; at.dispatchEvent(new Event('change')); }})()")
            page.until(f"document.getElementById('clock').textContent === '{at // 60:02d}:{at % 60:02d}'")
            told = page.says("""(async () => {
                const {model, placeOf} = await import('/feed.js'), {constraintsOf, isIn, regionOf} = await import('/constraints.js');
                return [...model.uavs.values()].flatMap((uav) => { const at = placeOf(uav);
                  return constraintsOf(uav).map(({scm, violated, figures}) => ({uav: uav.name, scm, violated, known: figures !== null,
                    holds: figures?.every((figure) => isIn(regionOf(figure, at.z), [at.x, at.y]))})); }); })()""")
            for one in told:
                assert one["known"], one
                if not one["violated"]:
                    assert one["holds"], (at, one)
                seen.setdefault(one["scm"], set()).add(one["uav"])
        assert set(seen) == {"mcs1", "mcs2", "mcs3"}, seen
        assert len(seen["mcs1"]) == 2 and len(seen["mcs2"]) == 1 and len(seen["mcs3"]) == 1, seen
        page.close()


def check_twenty_are_readable(browser, build):
    """Twenty UAVs have a head each at the right and a row each in the chronology; the chosen one is shown whole."""
    with Replay(build, fleet(20, SOURCE, until=40), 20) as replay:
        page = browser.page(replay.url)
        page.until("document.querySelectorAll('.card').length === 20")
        page.until("document.getElementById('cards').scrollHeight <= document.getElementById('cards').clientHeight")
        page.until("document.getElementById('chronology').clientHeight >= 20 * 20")
        assert page.says(f"getComputedStyle({card('heli7')}.querySelector('dl')).display") == "none"
        page.says(f"{card('heli7')}.querySelector('header').focus()")
        page.press("Enter")
        page.until(f"getComputedStyle({card('heli7')}.querySelector('dl')).display !== 'none'")
        page.close()


def line_of_sight(ground, a, b):
    """By many points of the segment: of the bilinear ground between the points of the grid."""
    def level(x, y):
        u = min(max((x - ground["west"]) / ground["step"], 0), ground["columns"] - 1)
        v = min(max((y - ground["south"]) / ground["step"], 0), ground["rows"] - 1)
        i, j = min(int(u), ground["columns"] - 2), min(int(v), ground["rows"] - 2)
        z = lambda c, r: ground["heights"][r * ground["columns"] + c]
        u, v = u - i, v - j
        return (z(i, j) * (1 - u) + z(i + 1, j) * u) * (1 - v) + (z(i, j + 1) * (1 - u) + z(i + 1, j + 1) * u) * v
    steps = 400
    return all(a[2] + (b[2] - a[2]) * k / steps >= level(a[0] + (b[0] - a[0]) * k / steps, a[1] + (b[1] - a[1]) * k / steps) for k in range(1, steps))


def check_draws_a_view_shed(browser, build):
    """Behind the spurs of real ground nothing is seen; as a line of sight that is walked along says."""
    with Replay(build, SOURCE / "scenarios/jacksboro/fire.yaml", 60) as replay:
        page = browser.page(replay.url)
        page.until("document.getElementById('viewshed')")
        page.says("(() => { const one = document.getElementById('viewshed'); one.value = 'ground'; one.dispatchEvent(new Event('change')); })()")
        page.until("document.getElementById('legend').textContent.includes('not heard by the ground')")
        ground, place = page.says("(async () => { const {model} = await import('/feed.js'); return [model.world.terrain, model.world.ground]; })()")
        height = 40
        seen = page.says(f"(async () => [...(await import('/viewshed.js')).viewshed((await import('/feed.js')).model.world.terrain, {json.dumps(place)}, {height})])()")
        assert 0.05 < sum(seen) / len(seen) < 0.95, "nothing is hidden, or all of it"
        same = asked = 0
        for k in range(0, len(seen), 23):
            x, y = ground["west"] + k % ground["columns"] * ground["step"], ground["south"] + k // ground["columns"] * ground["step"]
            same += line_of_sight(ground, place, (x, y, ground["heights"][k] + height)) == bool(seen[k])
            asked += 1
        assert same / asked > 0.95, (same, asked)
        page.close()


def check_shows_what_was_searched(browser, mission):
    page = opened(browser, mission)
    page.until("document.getElementById('legend').textContent.includes('belief of fire')")
    page.until("""(async () => { const {model} = await import('/feed.js'), t = model.world.terrain;
        return [...model.looks.values()].some((look) => { const cells = model.belief.get(Math.round((look.viewpoint.y - t.south) / t.step));
          return cells && /[0-9]/.test(cells[Math.round((look.viewpoint.x - t.west) / t.step)]); }); })()""")
    page.close()


def check_shows_a_cut_link(browser, mission):
    """Seconds from the word of the simulator that the link is cut to the card that says so."""
    page = opened(browser, mission)
    page.until(f"{card('marvin')}.querySelector('header .chip.good')")
    page.says("""(async () => {
        const {model} = await import('/feed.js');
        window.cut = null;
        const look = () => {
          const t = performance.now();
          if (window.cut === null && [...model.links.values()].some((link) => link.up === false)) window.cut = {at: t};
          if (window.cut && !window.cut.shown && document.querySelector('[data-uav="marvin"]').classList.contains('lost')) window.cut.shown = t;
          if (!window.cut?.shown) setTimeout(look, 20);
        };
        look(); })()""")
    seconds = page.until("window.cut?.shown && (window.cut.shown - window.cut.at) / 1000", 120)
    page.close()
    return seconds


def processor_seconds(pid):
    fields = pathlib.Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def frames(page, seconds):
    return page.says(f"""new Promise((done) => {{ let n = 0; const begin = performance.now();
        const step = (t) => {{ n += 1; t - begin < {1000 * seconds} ? requestAnimationFrame(step) : done(n / ((performance.now() - begin) / 1000)); }};
        requestAnimationFrame(step); }})""")


def tell_cost(build, uavs):
    with Mission(build, fleet(uavs, SOURCE), 1) as mission:
        ground = mission.pid_of("skein-ground")
        browser = Browser()
        try:  # not of the beginning, when all plan at once
            opened(browser, mission).until("document.getElementById('clock').textContent >= '01:00'", 120)
        finally:
            browser.close()
        for pages in (0, 1, 5):
            browser = Browser()
            try:
                shown = [opened(browser, mission) for _ in range(pages)]
                before = processor_seconds(ground)
                browser.page("about:blank").says("new Promise((done) => setTimeout(done, 20000))")
                print(f"{uavs} UAVs, {pages} pages: ground station {(processor_seconds(ground) - before) / 20 * 100:.1f} % of a processor", flush=True)
                if pages == 1:
                    first = shown[0].says("performance.getEntriesByType('paint')[0]?.startTime")
                    print(f"{uavs} UAVs: first paint {first:.0f} ms, {frames(shown[0], 10):.1f} frames/s", flush=True)
            finally:
                browser.close()


def tell_action(build, times=10):
    """From pressing a button to `acknowledged` on the page: the ground station, the radio of the scenario, the UAV's node, and back."""
    browser = Browser()
    try:
        with Mission(build, SOURCE / "scenarios/comets/confirmed.yaml", 1) as mission:
            page = opened(browser, mission)
            page.until(f"{card('heliv')}.textContent.includes('take in hand')")
            taken = []
            for number in range(times):
                words = "take in hand" if number % 2 == 0 else "give back"
                page.until(f"[...{card('heliv')}.querySelectorAll('button')].some((one) => one.textContent === '{words}')")
                taken.append(page.says(f"""new Promise((done) => {{
                    const begin = performance.now();
                    {press('heliv', words)};
                    const look = () => {{ const first = document.querySelector('#requests li');
                      first && first.textContent.includes('{words.split()[0]} heliv') && first.textContent.includes(': acknowledged')
                        ? done(performance.now() - begin) : setTimeout(look, 5); }};
                    look(); }})"""))
            taken.sort()
            print(f"action to acknowledgement shown: median {taken[len(taken) // 2]:.0f} ms, at most {taken[-1]:.0f} ms of {times}", flush=True)
    finally:
        browser.close()


def tell_frames(build, uavs):
    """Of a replay at ten times mission speed: the log has each UAV's place once a mission second."""
    browser = Browser()
    try:
        with Replay(build, fleet(uavs, SOURCE, until=600), 10) as replay:
            page = browser.page(replay.url)
            page.until("document.getElementById('clock').textContent > '01:00'")
            print(f"{uavs} UAVs at 10 Hz: {frames(page, 10):.1f} frames/s", flush=True)
    finally:
        browser.close()


def check(build, pictures):
    browser = Browser()
    try:
        with Mission(build, SOURCE / "scenarios/comets/confirmed.yaml", 3) as mission:
            check_shows_the_mission(browser, mission)
            check_refuses_others(mission)
            check_takes_in_hand_late_and_by_several(browser, mission)
            check_names_are_text(browser, mission)
            check_is_used_by_keys(browser, mission)
            check_shows_what_was_searched(browser, mission)
            if pictures:
                page = opened(browser, mission)
                page.picture(f"{pictures}/console.png")
            check_ends_the_mission_by_keys(browser, mission)
        with Mission(build, fleet(1, SOURCE, cut=True), 2) as mission:
            check_gives_a_mission_from_the_form(browser, mission)
            seconds = check_shows_a_cut_link(browser, mission)
            assert seconds < 3, f"a cut link was shown after {seconds:.1f} s"
            print(f"a cut link is shown after {seconds:.1f} s")
        check_replays_what_was_recorded(browser, build)
        check_shows_joint_tasks(browser, build)
        check_draws_spatial_constraints(browser, build)
        check_draws_a_view_shed(browser, build)
        check_twenty_are_readable(browser, build)
        assert not browser.errors, browser.errors
    finally:
        browser.close()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build")
    parser.add_argument("--figures", action="store_true")
    parser.add_argument("--pictures")
    options = parser.parse_args()
    if chromium() is None:
        print("SKIPPED: there is no chromium on this machine")
        return SKIPPED
    if options.figures:
        tell_action(options.build)
        tell_frames(options.build, 20)
        tell_cost(options.build, 3)
        tell_cost(options.build, 8)
        tell_cost(options.build, 20)
    else:
        check(options.build, options.pictures)
        print("the console does what it should")
    return 0


if __name__ == "__main__":
    sys.exit(main())
