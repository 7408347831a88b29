# SPDX-License-Identifier: Apache-2.0
"""Each library builds with nothing configured but what it declares, and each public header compiles alone.

    check_build_alone.py ARCHITECTURE.json SCRATCH [LIBRARY…]
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


def run(command, cwd=None):
    done = subprocess.run(command, cwd=cwd, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    return done.returncode, done.stdout


def first_errors(output):
    lines = [line for line in output.splitlines() if re.search(r"error|Error|undefined", line)]
    return "\n    ".join((lines or output.splitlines()[-5:])[:5])


class Alone:
    """One library in a build tree of its own."""

    def __init__(self, architecture, scratch, name):
        self.architecture, self.name = architecture, name
        self.tree = pathlib.Path(scratch) / name
        self.library = architecture.libraries[name]

    def problems(self):
        configure = ["cmake", "-S", str(self.architecture.source), "-B", str(self.tree), "-G", "Ninja",
                     f"-DCMAKE_BUILD_TYPE={self.architecture.build_type}",
                     f"-DCMAKE_CXX_COMPILER={self.architecture.compiler}",
                     f"-DSKEIN_WERROR={self.architecture.werror}", "-DSKEIN_BUILD_TESTS=OFF", "-DSKEIN_BUILD_BENCH=OFF",
                     # a static library needs no other one to be built
                     "-DCMAKE_OPTIMIZE_DEPENDENCIES=ON", "-DSKEIN_ONLY=" + ";".join(self.wanted())]
        code, output = run(configure)
        if code != 0:
            return [f"{self.name}: does not configure alone:\n    {first_errors(output)}"]
        code, output = run(["cmake", "--build", str(self.tree), "-j", "1", "--target", f"skein_{self.name}"])
        if code != 0:
            return [f"{self.name}: does not build alone:\n    {first_errors(output)}"]
        return self.header_problems()

    def wanted(self):
        """How the top CMakeLists.txt knows the library and what it depends on: by directory."""
        return [self.architecture.libraries[name].directory for name in self.architecture.closure(self.name)]

    def header_problems(self):
        include = self.architecture.source / self.library.directory / "include"
        headers = sorted(include.rglob("*.hpp"))
        command = self.compile_command() if headers else None
        if headers and command is None:
            return [f"{self.name}: no compile command"]
        problems = []
        for header in headers:
            relative = header.relative_to(include).as_posix()
            unit = self.tree / "headers" / (relative.replace("/", "__") + ".cpp")
            unit.parent.mkdir(exist_ok=True)
            text = f'#include "{relative}"\n#include "{relative}"\n'
            if not unit.exists() or unit.read_text() != text:
                unit.write_text(text)
            code, output = run([*command, "-o", f"{unit}.o", "-c", str(unit)], cwd=self.tree)
            if code != 0:
                problems.append(f"{self.name}: {relative} does not compile alone:\n    {first_errors(output)}")
        return problems

    def compile_command(self):
        """That of the library, without its private directories, output and optimisation."""
        for entry in json.loads((self.tree / "compile_commands.json").read_text()):
            if f"skein_{self.name}.dir" not in entry["command"]:
                continue
            words = shlex.split(entry["command"])
            words = words[:words.index("-o")]
            private = f"-I{self.architecture.source / self.library.directory}/src"
            return [word for word in words if word != private and not word.startswith("-O")] + ["-O0"]
        return None


def main():
    architecture = Architecture(sys.argv[1])
    names = sys.argv[3:] or list(architecture.libraries)
    with concurrent.futures.ThreadPoolExecutor(max_workers=max(1, len(os.sched_getaffinity(0)))) as pool:
        results = pool.map(lambda name: Alone(architecture, sys.argv[2], name).problems(), names)
        problems = [problem for result in results for problem in result]
    finish(problems, f"{len(names)} libraries build alone, and so does each of their public headers")


if __name__ == "__main__":
    main()
