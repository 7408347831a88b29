# SPDX-License-Identifier: Apache-2.0
"""Recordings, read by others: npm's reader of MCAP files (@mcap/core) reads what `skein run --mcap`, `skein export` and
`skein spy record` write, by index and as a stream, whole and cut short; the published schemas of Foxglove
(@foxglove/schemas) hold for every message on a topic of theirs. Skipped, and said so, where npm or its registry cannot
be reached.

    check_recordings.py SOURCE PROGRAMS [RECORDING…]
"""
import pathlib
import shutil
import subprocess
import sys
import tempfile

SKIPPED = 77
PACKAGES = ["@mcap/core@2.2.2", "@foxglove/schemas@2.1.0", "ajv@8.17.1"]


def run(command, folder, **more):
    return subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False, timeout=120, **more)


def skip(why):
    print(f"skipped: {why}")
    sys.exit(SKIPPED)


def install(folder):
    """npm's packages in a folder of the test's own; nothing of them stays."""
    for tool in ("node", "npm", "zstd", "lz4"):
        if not shutil.which(tool):
            skip(f"there is no {tool} here")
    (folder / "package.json").write_text('{"private": true}')
    try:
        done = run(["npm", "install", "--no-audit", "--no-fund", "--prefer-offline", "--fetch-retries=1", *PACKAGES], folder)
    except subprocess.TimeoutExpired:
        skip("npm's registry does not answer")
    if done.returncode != 0:
        skip(f"npm cannot install {' '.join(PACKAGES)}: {done.stderr.strip().splitlines()[-1:]}")


def main():
    source, programs = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]).resolve()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        install(folder)
        shutil.copy(source / "tests/recordings/read_recording.mjs", folder)
        scenario = source / "scenarios/comets/confirmed.yaml"
        done = run([programs / "skein", "run", scenario, "--virtual", "--quiet", "--out", folder / "run",
                    "--mcap", folder / "zstd.mcap"], folder)
        if done.returncode != 0:
            sys.exit(f"the run failed:\n{done.stdout}{done.stderr}")
        for compression in ("none", "lz4"):
            done = run([programs / "skein", "export", folder / "run", "--compression", compression,
                        "--mcap", folder / f"{compression}.mcap"], folder)
            if done.returncode != 0:
                sys.exit(f"the export failed:\n{done.stdout}{done.stderr}")
        files = [folder / f"{one}.mcap" for one in ("zstd", "none", "lz4")] + [pathlib.Path(one) for one in sys.argv[3:]]
        bad = 0
        for file in files:
            done = run(["node", "read_recording.mjs", file, folder / "run/events.jsonl"], folder)
            print(f"{file.name}: {done.stdout.strip()}{done.stderr.strip()}")
            bad += done.returncode != 0
    sys.exit(1 if bad else 0)


if __name__ == "__main__":
    main()
