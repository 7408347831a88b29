# SPDX-License-Identifier: Apache-2.0
"""Runs the examples of all `--help` as they are written, in a folder like a fresh clone, one command after the other.

    check_help.py SOURCE PROGRAMS          those that end by themselves
    check_help.py SOURCE PROGRAMS --live   those that need daemons, a browser or a mission that is being flown

What only long series make slow is made short. Files that are a user's own (`survey.plan`) stand ready, from the data of
our tests. Examples end with 0, or with a negative answer (1) where NEGATIVE says that they are there to show one.
"""
import json
import os
import pathlib
import re
import shutil
import signal
import struct
import subprocess
import sys
import tempfile

OWN = {
    "copter.waypoints": "libs/mission_files/fuzz/corpus/copter.waypoints",
    "models/marvin.yaml": "scenarios/comets/models/marvin.yaml",
}
FELL = """origin: {latitude: -35.36, longitude: 149.16, altitude: 584}
terrain: {west: -3000, south: -3000, east: 3000, north: 3000, cell: 50, base: 0}
"""
PLAN = {"fileType": "Plan", "version": 1, "mission": {"version": 2, "vehicleType": 2, "plannedHomePosition": [47.5, 8.25, 430], "items": [
    {"type": "SimpleItem", "command": 22, "frame": 3, "params": [0, 0, 0, None, 47.5, 8.25, 40], "autoContinue": True},
    {"type": "SimpleItem", "command": 16, "frame": 3, "params": [0, 0, 0, None, 47.501, 8.251, 40], "autoContinue": True},
    {"type": "SimpleItem", "command": 20, "frame": 2, "params": [0, 0, 0, 0, 0, 0, 0], "autoContinue": True}]}}
KML = """<kml xmlns="http://www.opengis.net/kml/2.2"><Document>
<Placemark><name>way</name><LineString><coordinates>8.251,47.501 8.252,47.502</coordinates></LineString></Placemark>
<Placemark><name>Danger area</name><Polygon><outerBoundaryIs><LinearRing>
<coordinates>8.254,47.504 8.255,47.504 8.255,47.505 8.254,47.504</coordinates></LinearRing></outerBoundaryIs></Polygon></Placemark>
</Document></kml>
"""
SHORT = ((r"--seeds 1\.\.\d+", "--seeds 1..2"), (r"^skein mastn bench$", "skein mastn bench --quick"))
NEGATIVE = (r"--why-not", r"^skein compare ")
LIVE = r"skein (operate|status|spy|replay|state) |skein model edit|functional: |skein-sim |skein functional .*--domain|--over-dds|^skein run (?!.*--virtual)"
DOMAIN = "97"
ENDLESS = r"--watch|skein spy|skein replay|model edit"


def help_of(programs, *words):
    return subprocess.run([programs / "skein", *words, "--help"], capture_output=True, text=True, check=True).stdout


def commands_of(programs, *above):
    """(words, help) of every command."""
    text = help_of(programs, *above)
    yield above, text
    listed = re.search(r"^Subcommands:\n(.*?)(?:\n\n|\Z)", text, re.M | re.S)
    for name in re.findall(r"^  (\S+)", listed[1] if listed else "", re.M):
        yield from commands_of(programs, *above, name)


def examples_of(text):
    """Command lines, without what is said of them three columns or more behind them."""
    shown = re.search(r"^Examples:\n((?:  .*\n?)+)", text, re.M)
    if not shown:
        return []
    lines = re.sub(r"\\\n\s*", "", shown[1]).splitlines()
    return [re.sub(r" {3,}[^ '\"].*$", "", line).strip() for line in lines]


def all_examples(programs):
    examples = {}
    for words, text in commands_of(programs):
        for example in examples_of(text):
            examples.setdefault(example, " ".join(words))
    return examples


def lay_out(source, folder):
    """A folder like a clone, with a user's files in it."""
    for name in ("docs", "libs", "tests"):
        (folder / name).symlink_to(source / name)
    shutil.copytree(source / "scenarios", folder / "scenarios")
    for name, data in OWN.items():
        (folder / name).parent.mkdir(exist_ok=True)
        shutil.copy(source / data, folder / name)
    (folder / "fell.yaml").write_text(FELL)
    (folder / "survey.plan").write_text(json.dumps(PLAN))
    (folder / "map.kml").write_text(KML)
    (folder / "dem.tif").write_text("ncols 20\nnrows 20\nxllcorner 8\nyllcorner 47\ncellsize 0.001\n" + "100 110 120 130 " * 100)
    (folder / "dem.prj").write_text('GEOGCS["WGS 84",DATUM["WGS_1984",SPHEROID["WGS 84",6378137,298.257223563]],'
                                    'PRIMEM["Greenwich",0],UNIT["degree",0.0174532925199433]]')
    (folder / "n36w085.hgt").write_bytes(struct.pack(">1201h", *range(1201)) * 1201)
    for name in (".zfunc", ".config/fish/completions"):
        (folder / name).mkdir(parents=True)


def lacks_a_tool(example):
    return any(re.search(rf"(^|[|&] *){tool} ", example) and not shutil.which(tool) for tool in ("dot", "jq", "man"))


class Runner:
    def __init__(self, programs, folder):
        self.folder = folder
        self.environment = dict(os.environ, PATH=f"{programs}:{os.environ['PATH']}", HOME=str(folder), USER="ann", PAGER="cat", BROWSER="true")
        self.faults = []

    def start(self, command):
        return subprocess.Popen(["bash", "-c", command], cwd=self.folder, env=self.environment, text=True, start_new_session=True,
                                stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)

    def run(self, command, seconds=300, right=(0,)):
        """Whatever goes on after so many seconds is interrupted, as by Ctrl-C."""
        running = self.start("set -o pipefail; " + command)
        try:
            output, _ = running.communicate(timeout=seconds)
        except subprocess.TimeoutExpired:
            os.killpg(running.pid, signal.SIGINT)
            output, _ = running.communicate(timeout=60)
        if running.returncode not in right:
            self.faults.append(f"exit code {running.returncode} of: {command}\n{output[-800:]}")
        return output


def run_plain(runner, examples):
    done = 0
    for example in examples:
        if re.search(LIVE, example) or lacks_a_tool(example):
            continue
        command = example
        for long, short in SHORT:
            command = re.sub(long, short, command)
        runner.run(command, right=(0, 1) if any(re.search(one, example) for one in NEGATIVE) else (0,))
        done += 1
    return done


def run_live(runner, examples):
    live = [re.sub(r"--domain \d+", f"--domain {DOMAIN}", one) for one in examples if re.search(LIVE, one)]
    (runner.folder / "survey.yaml").write_text("{uav: marvin, id: 1, tasks: [{id: 1, task: [general-land]}]}\n")
    mission = runner.start(f"skein run scenarios/comets/confirmed.yaml --rate 5 --quiet --domain {DOMAIN}")
    runner.run(f"skein spy --domain {DOMAIN} echo Telemetry --once --timeout 60")
    after = r"skein (state|replay|functional|run|storm)|functional: |skein-sim|model edit|play "
    for example in (one for one in live if not re.search(after, one)):
        endless = re.search(ENDLESS, example)
        refusable = re.search(r"operate|doctor", example)
        root = "--passive" not in example or os.geteuid() == 0
        runner.run(example, 4 if endless else 30, (0, 130) + ((1,) if refusable else ()) + (() if root else (3,)))
    os.killpg(mission.pid, signal.SIGINT)
    mission.communicate(timeout=60)
    for example in (one for one in live if re.search(after, one)):
        if "skein-sim" in example:
            layer = runner.start(example + " wait")
        elif example.startswith("skein functional"):
            runner.run(example, 120)
            os.killpg(layer.pid, signal.SIGINT)
            layer.communicate(timeout=60)
        elif not example.startswith("skein run"):  # what they leave was left by the mission
            cut_off = (141,) if example.endswith("| head") else ()
            runner.run(re.sub(r"--seeds 1\.\.\d+", "--seeds 1..1", example), 4 if re.search(ENDLESS, example) else 300, (0, 130) + cut_off)
    return len(live)


def main():
    source, programs = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
    examples = all_examples(programs)
    if len(examples) < 90:
        sys.exit(f"only {len(examples)} examples are found")
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        lay_out(source, folder)
        runner = Runner(programs, folder)
        done = (run_live if "--live" in sys.argv else run_plain)(runner, examples)
    print(f"{done} examples", *runner.faults, sep="\n")
    sys.exit(1 if runner.faults else 0)


if __name__ == "__main__":
    main()
