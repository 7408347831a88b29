# SPDX-License-Identifier: Apache-2.0
"""Each public header compiles alone, with nothing but what its library declares.

    check_headers_alone.py ARCHITECTURE.json COMPILE_COMMANDS.json [LIBRARY…]

The build compiles over a precompiled header, which would hide what a header forgets to include: here each
is compiled without it, with the options of its library.
"""
import concurrent.futures
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys

from sources import Architecture, finish

ONCE = re.compile(r"^\s*#\s*pragma\s+once\b", re.M)


def first_errors(output):
    lines = [line for line in output.splitlines() if re.search(r"error|Error|undefined", line)]
    return "\n    ".join((lines or output.splitlines()[-5:])[:5])


class Headers:
    """The public headers of one library and how they are compiled."""

    def __init__(self, architecture, commands, name, work):
        self.name = name
        self.work = work
        self.directory = architecture.source / architecture.libraries[name].directory
        self.entries = [entry for entry in commands if f"/skein_{name}.dir/" in entry["command"]]
        include = self.directory / "include"
        self.paths = {path.relative_to(include).as_posix(): path for path in sorted(include.rglob("*.hpp"))}

    def problems(self):
        if self.paths and not self.entries:
            yield f"{self.name}: no compile command"
            return
        for relative, path in self.paths.items():
            if not ONCE.search(path.read_text()):
                yield f"{self.name}: {relative} has no #pragma once"
            yield from self.compile_problems(relative)

    def compile_problems(self, relative):
        source = self.work / self.name / f"{relative.replace('/', '_')}.cpp"
        source.parent.mkdir(parents=True, exist_ok=True)
        source.write_text(f'#include "{relative}"\n')
        done = subprocess.run([*self.compile_command(), "-c", source, "-o", source.with_suffix(".o")], text=True,
                              check=False, cwd=self.entries[0]["directory"],
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        if done.returncode != 0:
            yield f"{self.name}: {relative} does not compile alone:\n    {first_errors(done.stdout)}"

    def compile_command(self):
        """That of the library's sources, without its private directory, precompiled header and optimisation."""
        words = shlex.split(self.entries[0]["command"])
        words = words[:words.index("-o")]
        if "-include" in words:
            at = words.index("-include")
            del words[at:at + 2]
        private = f"-I{self.directory}/src"
        return [word for word in words if word != private and not word.startswith(("-O", "-fpch", "-Winvalid-pch"))]


def main():
    architecture = Architecture(sys.argv[1])
    commands = json.loads(pathlib.Path(sys.argv[2]).read_text())
    work = pathlib.Path(sys.argv[2]).parent / "headers_alone"
    libraries = [Headers(architecture, commands, name, work) for name in sys.argv[3:] or architecture.libraries]
    with concurrent.futures.ThreadPoolExecutor(max_workers=max(1, len(os.sched_getaffinity(0)))) as pool:
        results = pool.map(lambda one: list(one.problems()), libraries)
        problems = [problem for result in results for problem in result]
    finish(problems, f"{sum(len(one.paths) for one in libraries)} public headers compile alone")


if __name__ == "__main__":
    main()
