# SPDX-License-Identifier: Apache-2.0
"""Does what a page of docs/ says, in a folder of its own: writes the files it shows, gives its commands, and looks
for the lines that it shows after them.

    check_tutorial.py SOURCE PROGRAMS PAGE
"""
import pathlib
import re
import subprocess
import sys
import tempfile

BLOCK = re.compile(r"^```(\w+)(?: (\S+))?\n(.*?)^```$", re.M | re.S)


def blocks_of(page):
    return [match.groups() for match in BLOCK.finditer(page)]


def said(folder, commands):
    done = subprocess.run(["bash", "-eu", "-c", commands], cwd=folder, capture_output=True, text=True, check=False, timeout=300)
    return done.returncode, done.stdout + done.stderr


def follow(folder, blocks):
    """The faults found, in order. A command is worth nothing after one that failed."""
    output = ""
    for kind, name, text in blocks:
        if kind == "yaml":
            file = folder / name
            file.parent.mkdir(exist_ok=True)
            file.write_text(text)
        elif kind == "sh":
            code, output = said(folder, text)
            if code != 0:
                yield f"exit code {code} of:\n{text}{output}"
                return
        elif kind == "text":
            for line in text.splitlines():
                if line.strip() not in output:
                    yield f"'{line}' is not in:\n{output}"


def main():
    source, programs, page = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]), sys.argv[3]
    blocks = blocks_of((source / "docs" / page).read_text())
    if len([kind for kind, _, _ in blocks if kind == "sh"]) < 5:
        sys.exit(f"docs/{page}: its commands are not found")
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "build").mkdir()
        (folder / "build/bin").symlink_to(programs)
        (folder / "scenarios").symlink_to(source / "scenarios")
        faults = list(follow(folder, blocks))
    for fault in faults:
        print(fault)
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
